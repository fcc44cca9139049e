/* SPDX-License-Identifier: MIT */
/* Overlaps and segments against exact arithmetic of 128 bits and double. */
#include <math.h>

#include "game/exact.h"
#include "tiny.h"
#include "wide.h"

static fxl_point difference(const fxl_point *a, const fxl_point *b)
{
    const fxl_point point = {a->x - b->x, a->y - b->y, a->z - b->z};
    return point;
}

static int64_t dot(const fxl_point *a, const fxl_point *b)
{
    return (int64_t)a->x * b->x + (int64_t)a->y * b->y + (int64_t)a->z * b->z;
}

/* Near 0, or anywhere: the first touch often. */
static fxl_point any_point(void)
{
    return unit_random() % 2 ? unit_point(12) : unit_point(FXL_COORDINATE_MAX);
}

static fxl_sphere any_sphere(void)
{
    const fxl_sphere sphere = {any_point(), unit_random() % 2 ? unit_between(0, 12)
                                                              : unit_between(0, FXL_RADIUS_MAX)};
    return sphere;
}

void test_spheres_overlap_where_their_centres_are_near_enough(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const fxl_sphere a = any_sphere(), b = any_sphere();
        const fxl_point between = difference(&a.centre, &b.centre);
        const int64_t reach = (int64_t)a.radius + b.radius;
        const wide left = wide_product(dot(&between, &between), 1);
        const int order = wide_compare(left, wide_product(reach, reach));
        TEST_ASSERT_EQUAL(order <= 0, fxl_spheres_overlap(&a, &b));
    }
    const fxl_sphere one = {{0, 0, 0}, Q16(2)}, other = {{Q16(3), Q16(-4), 0}, Q16(3)},
                     less = {{Q16(3), Q16(-4), 0}, Q16(3) - 1};
    TEST_ASSERT_TRUE(fxl_spheres_overlap(&one, &other)); /* they touch */
    TEST_ASSERT_FALSE(fxl_spheres_overlap(&one, &less));
    const fxl_sphere low = {{-FXL_COORDINATE_MAX, 0, 0}, FXL_RADIUS_MAX};
    const fxl_sphere high = {{FXL_COORDINATE_MAX, 0, 0}, FXL_RADIUS_MAX};
    TEST_ASSERT_TRUE(fxl_spheres_overlap(&low, &high));
}

static fxl_box any_box(void)
{
    const fxl_point a = any_point(), b = any_point();
    const fxl_box box = {{a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z},
                         {a.x < b.x ? b.x : a.x, a.y < b.y ? b.y : a.y, a.z < b.z ? b.z : a.z}};
    return box;
}

static bool apart(int32_t least, int32_t most, int32_t other_least, int32_t other_most)
{
    return most < other_least || other_most < least;
}

/* Squared, from the nearest point of a range. */
static int64_t off(int32_t value, int32_t least, int32_t most)
{
    const int64_t by = value < least  ? (int64_t)least - value
                       : value > most ? (int64_t)value - most
                                      : 0;
    return by * by;
}

void test_boxes_overlap_where_no_axis_keeps_them_apart(void)
{
    uint32_t met = 0, sphere_met = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const fxl_box a = any_box(), b = any_box();
        const bool overlap = !apart(a.least.x, a.most.x, b.least.x, b.most.x) &&
                             !apart(a.least.y, a.most.y, b.least.y, b.most.y) &&
                             !apart(a.least.z, a.most.z, b.least.z, b.most.z);
        TEST_ASSERT_EQUAL(overlap, fxl_boxes_overlap(&a, &b));
        met += overlap;
        const fxl_sphere sphere = any_sphere();
        const int64_t square = off(sphere.centre.x, a.least.x, a.most.x) +
                               off(sphere.centre.y, a.least.y, a.most.y) +
                               off(sphere.centre.z, a.least.z, a.most.z);
        const bool meets = square <= (int64_t)sphere.radius * sphere.radius;
        TEST_ASSERT_EQUAL(meets, fxl_sphere_meets_box(&sphere, &a));
        sphere_met += meets;
    }
    TEST_ASSERT_TRUE(met > 100 && met < UNIT_REPEAT - 100);
    TEST_ASSERT_TRUE(sphere_met > 100 && sphere_met < UNIT_REPEAT - 100);
    const fxl_box one = {{0, 0, 0}, {4, 4, 4}}, other = {{4, 4, 4}, {8, 8, 8}},
                  third = {{4, 4, 5}, {8, 8, 8}};
    TEST_ASSERT_TRUE(fxl_boxes_overlap(&one, &other) && fxl_boxes_overlap(&other, &one));
    TEST_ASSERT_FALSE(fxl_boxes_overlap(&one, &third) || fxl_boxes_overlap(&third, &one));
}

/* The squared distance times d . d, against the squared radius times d . d, in 128 bits. */
static bool meets(const fxl_sphere *sphere, const fxl_point *from, const fxl_point *to)
{
    const fxl_point q = difference(&sphere->centre, from), d = difference(to, from);
    const fxl_point beyond = difference(&sphere->centre, to);
    const int64_t along = dot(&q, &d), whole = dot(&d, &d);
    const int64_t reach = (int64_t)sphere->radius * sphere->radius;
    if (along <= 0) {
        return dot(&q, &q) <= reach;
    }
    if (along >= whole) {
        return dot(&beyond, &beyond) <= reach;
    }
    const wide left = wide_difference(wide_product(dot(&q, &q), whole), wide_product(along, along));
    return wide_compare(left, wide_product(reach, whole)) <= 0;
}

void test_a_segment_meets_a_sphere_exactly(void)
{
    uint32_t met = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const fxl_sphere sphere = any_sphere();
        const fxl_point from = any_point(), to = any_point();
        const bool wanted = meets(&sphere, &from, &to);
        TEST_ASSERT_EQUAL(wanted, fxl_sphere_meets_segment(&sphere, &from, &to));
        met += wanted;
    }
    TEST_ASSERT_TRUE(met > 100 && met < UNIT_REPEAT - 100);
    /* Touched at (0, 5, 0), and one unit too low. */
    const fxl_sphere sphere = {{0, 0, 0}, 5};
    const fxl_point from = {-3, 5, 0}, to = {3, 5, 0}, high_from = {-3, 6, 0}, high_to = {3, 5, 0};
    TEST_ASSERT_TRUE(fxl_sphere_meets_segment(&sphere, &from, &to));
    TEST_ASSERT_FALSE(fxl_sphere_meets_segment(&sphere, &high_from, &high_to));
    /* The shortest segment there is: its end touches, its start does not. */
    const fxl_point start = {-1, 5, 0}, end = {0, 5, 0};
    TEST_ASSERT_TRUE(fxl_sphere_meets_segment(&sphere, &start, &end));
}

/* Vectors of any size, and such as lie nearly in one plane. */
/* collide 2.1d */
void test_the_sign_of_a_determinant_is_exact(void)
{
    uint32_t zeros = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const fxl_q16_16 limit = unit_random() % 2 ? 1 << 30 : 1 << unit_between(1, 20);
        const fxl_point b = unit_point(limit), c = unit_point(limit);
        fxl_point a = unit_point(limit);
        if (unit_random() % 2) {
            const fxl_point off = unit_point(1);
            a.x = b.x / 2 + c.x / 2 + off.x;
            a.y = b.y / 2 + c.y / 2 + off.y;
            a.z = b.z / 2 + c.z / 2 + off.z;
        }
        const wide x = wide_product((int64_t)b.y * c.z - (int64_t)b.z * c.y, a.x),
                   y = wide_product((int64_t)b.z * c.x - (int64_t)b.x * c.z, a.y),
                   z = wide_product((int64_t)b.x * c.y - (int64_t)b.y * c.x, a.z);
        const int sign = wide_compare(wide_sum(wide_sum(x, y), z), wide_product(0, 0));
        const int found = fxl_determinant_sign(&a, &b, &c);
        TEST_ASSERT_EQUAL((sign > 0) - (sign < 0), found);
        zeros += sign == 0;
    }
    TEST_ASSERT_TRUE(zeros > 0);
}

/* --- segments and scenes ---------------------------------------------------------------- */

/* The first face that a ray meets, in double; -1 where an edge or the plane is too near to tell. */
static double face_in_double(const tiny_scene *tiny, uint32_t instance, uint32_t number,
                             const fxl_point *from, const fxl_point *to, bool *doubtful)
{
    const fxl_instance *placed = &tiny->instances[instance];
    const fxl_model *model = &tiny->models[placed->model];
    const fxl_face *face = &tiny->faces[model->first_face + number];
    const double d[3] = {(double)to->x - from->x, (double)to->y - from->y, (double)to->z - from->z};
    double corners[4][3], start = 0, end = 0;
    for (uint32_t k = 0; k < face->count; k++) {
        const fxl_point *vertex =
            &tiny->vertices[model->first_vertex + fxl_face_indices(tiny->corners, face)[k]];
        corners[k][0] = (double)placed->centre.x + vertex->x - from->x;
        corners[k][1] = (double)placed->centre.y + vertex->y - from->y;
        corners[k][2] = (double)placed->centre.z + vertex->z - from->z;
    }
    const double normal[3] = {face->normal.x, face->normal.y, face->normal.z};
    for (int k = 0; k < 3; k++) {
        start -= normal[k] * corners[0][k] / 1073741824.0;
        end += normal[k] * (d[k] - corners[0][k]) / 1073741824.0;
    }
    *doubtful |= fabs(start) < 1 || fabs(end) < 1;
    if (start <= 0 || end > 0) {
        return 2;
    }
    for (uint32_t k = 0; k < 4; k++) {
        const double *a = corners[k], *b = corners[(k + 1) % 4];
        const double side = d[0] * (a[1] * b[2] - a[2] * b[1]) +
                            d[1] * (a[2] * b[0] - a[0] * b[2]) + d[2] * (a[0] * b[1] - a[1] * b[0]);
        *doubtful |= fabs(side) < 1e-9 * 65536.0 * 65536.0 * 65536.0 * 100;
        if (side > 0) {
            return 2;
        }
    }
    return start / (start - end);
}

static void expect_like_double(const tiny_scene *tiny, const fxl_point *from, const fxl_point *to,
                               const fxl_hit *hit, uint32_t *hits)
{
    double best = 2;
    bool doubtful = false;
    uint32_t instance = FXL_HIT_NONE, number = 0;
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        for (uint32_t k = 0; k < 6; k++) {
            const double at = face_in_double(tiny, i, k, from, to, &doubtful);
            doubtful |= at < 2 && fabs(at - best) < 1e-12;
            if (at < best) {
                best = at;
                instance = i;
                number = k;
            }
        }
    }
    if (doubtful) {
        return;
    }
    TEST_ASSERT_EQUAL_UINT32(instance, hit->instance);
    TEST_ASSERT_EQUAL_UINT32(number, hit->face);
    best = best > 1 ? 1 : best;
    TEST_ASSERT_NEAR(hit->fraction, best * 2147483648.0, 0.51);
    TEST_ASSERT_NEAR(hit->point.x, from->x + best * ((double)to->x - from->x), 0.76);
    TEST_ASSERT_NEAR(hit->point.y, from->y + best * ((double)to->y - from->y), 0.76);
    TEST_ASSERT_NEAR(hit->point.z, from->z + best * ((double)to->z - from->z), 0.76);
    *hits += hit->instance != FXL_HIT_NONE;
}

/* accuracy 1.2o-p, collide 2.1a-b, 2.2a */
void test_a_segment_hits_what_double_says(void)
{
    uint32_t hits = 0;
    tiny_scene *tiny = tiny_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_point from = unit_point(Q16(20)), to = unit_point(Q16(3));
        fxl_hit hit;
        if (unit_random() % 2) {
            to.z += Q16(10);
        }
        if (unit_random() % 8 == 0) {
            from = unit_point(FXL_COORDINATE_MAX);
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &from, &to, &hit));
        expect_like_double(tiny, &from, &to, &hit, &hits);
    }
    TEST_ASSERT_TRUE(hits > UNIT_REPEAT / 1000);
}

/* Through two cubes that stand one behind the other: the nearer one is hit, whichever comes first
 * in the scene. */
/* accuracy 1.2o, collide 2.2b */
void test_a_segment_hits_the_nearest(void)
{
    uint32_t hits[2] = {0, 0};
    tiny_scene *tiny = tiny_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    for (int i = 0; i < UNIT_REPEAT / 50; i++) {
        const bool back = i % 2 != 0;
        const int32_t ends[2] = {Q16(-6), Q16(16)};
        const fxl_point from = {unit_between(Q16(-0.9), Q16(0.9)),
                                unit_between(Q16(-0.9), Q16(0.9)), ends[back]},
                        to = {unit_between(Q16(-0.9), Q16(0.9)), unit_between(Q16(-0.9), Q16(0.9)),
                              ends[!back]};
        uint32_t compared = 0;
        fxl_hit hit;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &from, &to, &hit));
        TEST_ASSERT_EQUAL_UINT32(back, hit.instance);
        TEST_ASSERT_EQUAL_UINT32(back ? 5 : 4, hit.face);
        expect_like_double(tiny, &from, &to, &hit, &compared);
        hits[back] += compared;
    }
    TEST_ASSERT_TRUE(hits[0] > UNIT_REPEAT / 200 && hits[1] > UNIT_REPEAT / 200);
}

/* Of two cubes in one place the first is hit. */
/* collide 2.2b */
void test_a_segment_hits_the_first_of_equals(void)
{
    tiny_scene *tiny = tiny_make();
    tiny->instances[2].centre = tiny->instances[0].centre;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    const fxl_point from = {Q16(0.25), Q16(0.5), Q16(-6)}, to = {Q16(0.5), Q16(0.25), Q16(16)};
    fxl_hit hit;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &from, &to, &hit));
    TEST_ASSERT_EQUAL_UINT32(0, hit.instance);
    TEST_ASSERT_EQUAL_UINT32(4, hit.face);
}

/* Into a closed cube, through its edges and corners exactly: there is no gap. */
/* SPEC 2.1d, collide 2.1c-d */
void test_no_segment_passes_between_faces(void)
{
    tiny_scene *tiny = tiny_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_hit hit;
        fxl_point through = {unit_between(-1, 1) * Q16(1), unit_between(-1, 1) * Q16(1),
                             unit_between(-1, 1) * Q16(1)};
        const fxl_point from = {8 * through.x, 8 * through.y, 8 * through.z}, to = {0, 0, 0};
        if (through.x == 0 && through.y == 0 && through.z == 0) {
            continue;
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &from, &to, &hit));
        TEST_ASSERT_EQUAL_UINT32(0, hit.instance);
        TEST_ASSERT_EQUAL_HEX32(FXL_Q1_31_ONE / 8 * 7, hit.fraction);
        TEST_ASSERT_EQUAL_MEMORY(&through, &hit.point, sizeof through);
    }
}

/* collide 2.1b */
void test_ends_and_backs_of_faces(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_hit hit;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    const fxl_point before = {0, 0, Q16(-3)}, on = {0, 0, Q16(-1)}, inside = {0, 0, 0},
                    short_of = {0, 0, Q16(-1) - 1};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &before, &on, &hit));
    TEST_ASSERT_TRUE(hit.instance == 0 && hit.face == 4 && hit.fraction == FXL_Q1_31_ONE);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &before, &short_of, &hit));
    TEST_ASSERT_TRUE(hit.instance == FXL_HIT_NONE && hit.face == 0 &&
                     hit.fraction == FXL_Q1_31_ONE && hit.point.z == short_of.z);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &inside, &before, &hit));
    TEST_ASSERT_EQUAL_UINT32(FXL_HIT_NONE, hit.instance);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &on, &inside, &hit));
    TEST_ASSERT_EQUAL_UINT32(FXL_HIT_NONE, hit.instance);
}

void test_segments_that_cannot_be_are_refused(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_point in = {0, 0, 0}, out = {0, FXL_COORDINATE_MAX + 1, 0};
    fxl_hit hit, before;
    memset(&hit, 0x5A, sizeof hit);
    before = hit;
    tiny->scene.draw_list_needed = 0;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_cast_segment(&tiny->scene, &in, &in, &hit));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_cast_segment(NULL, &in, &in, &hit));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_cast_segment(&tiny->scene, NULL, &in, &hit));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_cast_segment(&tiny->scene, &in, NULL, &hit));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_cast_segment(&tiny->scene, &in, &in, NULL));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_cast_segment(&tiny->scene, &in, &out, &hit));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_cast_segment(&tiny->scene, &out, &in, &hit));
    TEST_ASSERT_EQUAL_MEMORY(&before, &hit, sizeof hit);
}

/* A quarter turn about y, of a point from the instance's centre: exact. */
static fxl_point quarter(const fxl_point *point, const fxl_point *centre)
{
    const fxl_point turned = {centre->x + (point->z - centre->z), point->y,
                              centre->z - (point->x - centre->x)};
    return turned;
}

/* A segment hits a turned instance as the segment that is turned with it hits the one that stands
 * still. */
/* collide 2.3a */
void test_a_segment_hits_what_is_turned(void)
{
    static const fxl_placement placement = {
        {{0, 0, FXL_Q2_30_ONE}, {0, FXL_Q2_30_ONE, 0}, {-FXL_Q2_30_ONE, 0, 0}}, FXL_Q16_16_ONE};
    uint32_t hits = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        tiny_scene *tiny = tiny_make();
        tiny->scene.instance_count = 1;
        const fxl_point centre = tiny->instances[0].centre;
        const fxl_point from = {centre.x + unit_between(-Q16(4), Q16(4)), centre.y + Q16(3),
                                centre.z + unit_between(-Q16(4), Q16(4))};
        const fxl_point to = {centre.x + unit_between(-Q16(1), Q16(1)), centre.y - Q16(1),
                              centre.z + unit_between(-Q16(1), Q16(1))};
        const fxl_point turned_from = quarter(&from, &centre), turned_to = quarter(&to, &centre);
        fxl_hit still, hit;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &from, &to, &still));
        tiny->scene.placements = &placement;
        tiny->scene.first_turned = 0;
        tiny->scene.placement_code = &fxl_turned_instances;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &turned_from, &turned_to, &hit));
        TEST_ASSERT_EQUAL(still.instance, hit.instance);
        TEST_ASSERT_EQUAL(still.face, hit.face);
        TEST_ASSERT_EQUAL_UINT32(still.fraction, hit.fraction);
        hits += hit.instance == 0;
    }
    TEST_ASSERT_TRUE(hits > 0);
}

/* Rows that are no rotation, a scale that is out of range, placements without their code: a status,
 * and no hit is written, also where the segment comes nowhere near the instance. */
/* collide 2.3b */
void test_a_segment_against_placements_that_are_refused(void)
{
    const fxl_point from = {Q16(4000), Q16(4000), Q16(4000)},
                    to = {Q16(4000), Q16(4001), Q16(4000)};
    const fxl_hit before = {{1, 2, 3}, 4, 5, 6};
    tiny_scene *tiny = tiny_make();
    tiny->scene.instance_count = 1;
    fxl_placement placement = FXL_PLACEMENT_NONE;
    tiny->scene.placements = &placement;
    tiny->scene.first_turned = 0;
    tiny->scene.placement_code = &fxl_turned_instances;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    fxl_hit hit = before;
    placement.orientation.x.x -= 8;
    TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, fxl_cast_segment(&tiny->scene, &from, &to, &hit));
    placement.orientation.x.x += 8;
    placement.scale = 0;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_cast_segment(&tiny->scene, &from, &to, &hit));
    placement.scale = FXL_Q16_16_ONE;
    tiny->scene.placement_code = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_cast_segment(&tiny->scene, &from, &to, &hit));
    TEST_ASSERT_EQUAL_MEMORY(&before, &hit, sizeof hit);
    tiny->scene.placement_code = &fxl_turned_instances;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&tiny->scene, &from, &to, &hit));
    TEST_ASSERT_EQUAL(FXL_HIT_NONE, hit.instance);
}

/* The box of a turned instance is that of its points in the world. */
void test_the_box_of_what_is_turned(void)
{
    static const fxl_placement placement = {
        {{0, 0, FXL_Q2_30_ONE}, {0, FXL_Q2_30_ONE, 0}, {-FXL_Q2_30_ONE, 0, 0}}, FXL_UNITS(2)};
    tiny_scene *tiny = tiny_make();
    tiny->scene.instance_count = 1;
    const fxl_point centre = tiny->instances[0].centre;
    fxl_box still, box;
    fxl_box_of_instance(&tiny->scene, &tiny->instances[0], &still);
    tiny->scene.placements = &placement;
    tiny->scene.first_turned = 0;
    tiny->scene.placement_code = &fxl_turned_instances;
    fxl_box_of_instance(&tiny->scene, &tiny->instances[0], &box);
    TEST_ASSERT_EQUAL(centre.x + 2 * (still.most.z - centre.z), box.most.x);
    TEST_ASSERT_EQUAL(centre.y + 2 * (still.least.y - centre.y), box.least.y);
    TEST_ASSERT_EQUAL(centre.z - 2 * (still.most.x - centre.x), box.least.z);
}
