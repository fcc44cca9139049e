/* SPDX-License-Identifier: MIT */
/* A sphere among cubes, as they are and turned and scaled: it slides along them, and is never
 * within one. */
#include <math.h>

#include "tiny.h"

/* A sphere among cubes: it slides along them, and is never within one. */

static tiny_scene *tiny;

void setUp(void)
{
    tiny = tiny_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
}

/* What happened, added up. */
typedef struct {
    uint32_t contacts;
    uint32_t slid; /* moves that were never blocked, of those with contacts */
} slide_counts;

/* Moves the sphere eight times. It is free after every move: not nearer to a cube than its radius,
 * but for so many units. A small move that meets nothing has no cube half-way either, and goes all
 * the way; a large one is cut into such moves. distance: from the nearest cube, 0 within. */
static void slides_stay_free(const fxl_scene *scene, fxl_sphere *sphere,
                             double (*distance)(const fxl_point *point), fxl_q16_16 slack,
                             slide_counts *counts)
{
    for (int i = 0; i < 8; i++) {
        const fxl_point move = unit_point(unit_random() % 4 ? sphere->radius : 16 * sphere->radius);
        const fxl_point before = sphere->centre;
        fxl_slide slide;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(scene, sphere, &move, &slide));
        TEST_ASSERT_TRUE(distance(&sphere->centre) >= sphere->radius - slack);
        counts->contacts += slide.contacts;
        counts->slid += slide.contacts > 0 && slide.blocked == 0;
        if (slide.contacts == 0) {
            const fxl_point middle = {before.x + move.x / 2, before.y + move.y / 2,
                                      before.z + move.z / 2};
            TEST_ASSERT_TRUE(distance(&middle) >= sphere->radius / 2 - slack);
            TEST_ASSERT_EQUAL_INT32(before.x + move.x, sphere->centre.x);
        }
    }
}

/* How far a point is from the nearest cube, in units of 1/65536; 0 within. */
static double distance(const fxl_point *point)
{
    double nearest = 1e30;
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        const fxl_point *centre = &tiny->instances[i].centre;
        const double d[3] = {fabs((double)point->x - centre->x) - 65536,
                             fabs((double)point->y - centre->y) - 65536,
                             fabs((double)point->z - centre->z) - 65536};
        double square = 0;
        for (int k = 0; k < 3; k++) {
            square += d[k] > 0 ? d[k] * d[k] : 0;
        }
        nearest = sqrt(square) < nearest ? sqrt(square) : nearest;
    }
    return nearest;
}

/* collide 3.1a */
void test_a_free_sphere_goes_all_the_way(void)
{
    fxl_sphere sphere = {{Q16(3), 0, Q16(-4)}, Q16(0.5)};
    const fxl_point move = {Q16(1), Q16(-2), Q16(7) + 1};
    fxl_slide slide;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &move, &slide));
    TEST_ASSERT_EQUAL_INT32(Q16(4), sphere.centre.x);
    TEST_ASSERT_EQUAL_INT32(Q16(-2), sphere.centre.y);
    TEST_ASSERT_EQUAL_INT32(Q16(3) + 1, sphere.centre.z);
    TEST_ASSERT_TRUE(slide.contacts == 0 && slide.blocked == 0 && slide.instance == FXL_HIT_NONE);
}

/* Straight into a face it stops before it; at an angle it keeps the part along the face. */
/* collide 3.1b */
void test_a_sphere_stops_at_a_face_and_slides_along_it(void)
{
    fxl_sphere sphere = {{0, 0, Q16(-4)}, Q16(0.5)};
    const fxl_point straight = {0, 0, Q16(6)}, aslant = {Q16(0.4), Q16(0.3), Q16(0.5)};
    fxl_slide slide;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &straight, &slide));
    TEST_ASSERT_INT32_WITHIN(16, Q16(-1.5), sphere.centre.z);
    TEST_ASSERT_TRUE(sphere.centre.x == 0 && sphere.centre.y == 0);
    TEST_ASSERT_TRUE(slide.contacts > 0 && slide.blocked == 0 && slide.instance == 0 &&
                     slide.face == 4);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &aslant, NULL));
    TEST_ASSERT_INT32_WITHIN(16, Q16(-1.5), sphere.centre.z);
    TEST_ASSERT_EQUAL_INT32(Q16(0.4), sphere.centre.x);
    TEST_ASSERT_EQUAL_INT32(Q16(0.3), sphere.centre.y);
}

/* What a push leaves, at faces, edges and corners of a cube, from every side. */
/* accuracy 1.2q, collide 3.4a */
void test_a_push_leaves_a_gap(void)
{
    uint32_t pushed = 0;
    tiny->scene.instance_count = 1;
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_sphere sphere = {unit_point(Q16(2.5)), unit_between(Q16(0.25), Q16(1))};
        const fxl_point move = unit_point(sphere.radius / 4); /* one step */
        fxl_slide slide;
        if (distance(&sphere.centre) < sphere.radius + 16) {
            continue;
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &move, &slide));
        if (slide.contacts == 1 && slide.blocked == 0) {
            const double gap = distance(&sphere.centre) - sphere.radius;
            TEST_ASSERT_TRUE(gap >= 8 && gap <= 16);
            pushed++;
        }
    }
    TEST_ASSERT_TRUE(pushed > 0);
}

/* Near the seam of two faces: the edge of the neighbour is farther than the face before the sphere.
 */
void test_a_seam_does_not_push_aside(void)
{
    fxl_sphere sphere = {{Q16(0.9), Q16(-0.9), Q16(-4)}, Q16(0.5)};
    const fxl_point straight = {0, 0, Q16(6)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &straight, NULL));
    TEST_ASSERT_EQUAL_INT32(Q16(0.9), sphere.centre.x);
    TEST_ASSERT_EQUAL_INT32(Q16(-0.9), sphere.centre.y);
    TEST_ASSERT_INT32_WITHIN(16, Q16(-1.5), sphere.centre.z);
}

/* Past an edge: the sphere rolls round it. */
/* collide 3.2a */
void test_a_sphere_goes_round_an_edge(void)
{
    fxl_sphere sphere = {{Q16(1.25), 0, Q16(-4)}, Q16(0.5)};
    const fxl_point move = {0, 0, Q16(7)};
    fxl_slide slide;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &move, &slide));
    TEST_ASSERT_INT32_WITHIN(16, Q16(1.5), sphere.centre.x);
    TEST_ASSERT_EQUAL_INT32(0, sphere.centre.y);
    TEST_ASSERT_TRUE(sphere.centre.z > Q16(2.5) && slide.contacts > 0);
}

/* Past edges that lie along the other axes: they push across themselves alone. */
/* collide 3.4a */
void test_an_edge_pushes_across_itself(void)
{
    fxl_sphere sphere = {{Q16(-4), Q16(1.25), Q16(0.25)}, Q16(0.5)};
    const fxl_point along_x = {Q16(7), 0, 0}, along_z = {0, 0, Q16(7)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &along_x, NULL));
    TEST_ASSERT_INT32_WITHIN(16, Q16(1.5), sphere.centre.y);
    TEST_ASSERT_EQUAL_INT32(Q16(0.25), sphere.centre.z);
    TEST_ASSERT_TRUE(sphere.centre.x > Q16(2.5));
    sphere.centre = (fxl_point){Q16(0.25), Q16(1.25), Q16(-4)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &along_z, NULL));
    TEST_ASSERT_INT32_WITHIN(16, Q16(1.5), sphere.centre.y);
    TEST_ASSERT_EQUAL_INT32(Q16(0.25), sphere.centre.x);
    TEST_ASSERT_TRUE(sphere.centre.z > Q16(2.5));
}

/* The promise, at random: free after every call, and no cube between start and end of any step of
 * a walk of small moves; a large move is cut into such steps by itself. */
/* collide 3.2a, 3.3a */
void test_no_sphere_is_ever_within_a_face(void)
{
    slide_counts counts = {0, 0};
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        fxl_sphere sphere = {unit_point(Q16(4)), unit_between(FXL_SLIDE_RADIUS_MIN, Q16(1.5))};
        sphere.centre.z += unit_between(0, Q16(8));
        if (distance(&sphere.centre) < sphere.radius + 32) {
            continue;
        }
        slides_stay_free(&tiny->scene, &sphere, distance, 2, &counts);
    }
    TEST_ASSERT_TRUE(counts.contacts > 10);
}

/* Fast against a thin wall: the cube as a plate of 1/256. */
/* collide 3.3b */
void test_a_fast_sphere_does_not_pass_a_thin_wall(void)
{
    for (uint32_t i = 0; i < 8; i++) {
        tiny->vertices[i].z /= 256;
        tiny->vertices[i].x *= 16;
        tiny->vertices[i].y *= 16;
    }
    tiny->models[0].radius = Q16(23);
    tiny->scene.instance_count = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    for (int i = 0; i < UNIT_REPEAT / 1000 + 2; i++) {
        fxl_sphere sphere = {{0, 0, Q16(-4)}, unit_between(FXL_SLIDE_RADIUS_MIN * 8, Q16(2))};
        const fxl_point move = {unit_between(Q16(-4), Q16(4)), unit_between(Q16(-4), Q16(4)),
                                unit_between(Q16(5), Q16(10))};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &move, NULL));
        TEST_ASSERT_TRUE(sphere.centre.z <= -sphere.radius);
        TEST_ASSERT_INT32_WITHIN(2, move.x, sphere.centre.x); /* it slid */
    }
}

/* In a corner there is no way on. */
/* collide 3.1d */
void test_a_sphere_within_a_face_may_stay(void)
{
    fxl_sphere sphere = {{0, 0, 0}, Q16(1.25)}; /* in the middle of a cube */
    const fxl_point move = {Q16(0.1), 0, 0};
    fxl_slide slide;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &move, &slide));
    TEST_ASSERT_TRUE(slide.blocked == 1 && sphere.centre.x == 0);
}

/* Between two cubes that are nearer than its diameter each pushes it against the other: after six
 * pushes it still touches one, and stays. */
/* collide 3.1b */
void test_a_sphere_is_pushed_six_times(void)
{
    fxl_sphere sphere = {{Q16(1.375), 0, 0}, Q16(0.5)};
    const fxl_point none = {0, 0, 0};
    fxl_slide slide;
    tiny->instances[2].centre = (fxl_point){Q16(2.75), 0, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &none, &slide));
    TEST_ASSERT_EQUAL_UINT32(6 + 1, slide.contacts);
    TEST_ASSERT_EQUAL_UINT32(1, slide.blocked);
    TEST_ASSERT_EQUAL_INT32(Q16(1.375), sphere.centre.x);
}

/* A push leaves 12 units of 1/65536 between a sphere and a face: 4 that the face may be off its
 * plane, and 8. */
/* collide 3.1c */
void test_a_push_goes_as_far_as_the_radius_and_no_farther(void)
{
    fxl_sphere deep = {{0, 0, Q16(-1) - 12}, Q16(0.5)}, deeper = {{0, 0, Q16(-1) - 11}, Q16(0.5)};
    const fxl_point none = {0, 0, 0};
    fxl_slide slide;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &deep, &none, &slide));
    TEST_ASSERT_TRUE(slide.contacts == 1 && slide.blocked == 0);
    TEST_ASSERT_EQUAL_INT32(Q16(-1.5) - 12, deep.centre.z);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &deeper, &none, &slide));
    TEST_ASSERT_TRUE(slide.contacts == 1 && slide.blocked == 1);
    TEST_ASSERT_EQUAL_INT32(Q16(-1) - 11, deeper.centre.z);
}

void test_the_end_of_the_world_holds_a_sphere(void)
{
    fxl_sphere sphere = {{FXL_COORDINATE_MAX - 5, 0, 0}, Q16(1)};
    const fxl_point move = {Q16(3), 0, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &move, NULL));
    TEST_ASSERT_EQUAL_INT32(FXL_COORDINATE_MAX, sphere.centre.x);
}

static void expect_refused(fxl_status status, const fxl_sphere *sphere, const fxl_point *move)
{
    fxl_sphere moved = *sphere;
    fxl_slide slide, before;
    memset(&slide, 0x5A, sizeof slide);
    before = slide;
    TEST_ASSERT_EQUAL(status, fxl_slide_sphere(&tiny->scene, &moved, move, &slide));
    TEST_ASSERT_EQUAL_MEMORY(sphere, &moved, sizeof moved);
    TEST_ASSERT_EQUAL_MEMORY(&before, &slide, sizeof slide);
}

/* collide 3.1a, 3.4b-c */
void test_slides_that_cannot_be_are_refused(void)
{
    fxl_sphere sphere = {{0, 0, Q16(-4)}, Q16(1)};
    const fxl_point none = {0, 0, 0}, wide = {FXL_COORDINATE_MAX + 1, 0, 0},
                    far_off = {0, Q16(513), 0};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_slide_sphere(NULL, &sphere, &none, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_slide_sphere(&tiny->scene, NULL, &none, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_slide_sphere(&tiny->scene, &sphere, NULL, NULL));
    expect_refused(FXL_E_RANGE, &sphere, &wide);
    expect_refused(FXL_E_RANGE, &sphere, &far_off);
    sphere.radius = FXL_SLIDE_RADIUS_MIN - 1;
    expect_refused(FXL_E_RANGE, &sphere, &none);
    sphere.radius = FXL_SLIDE_RADIUS_MAX + 1;
    expect_refused(FXL_E_RANGE, &sphere, &none);
    sphere.radius = FXL_SLIDE_RADIUS_MAX;
    sphere.centre.y = -FXL_COORDINATE_MAX - 1;
    expect_refused(FXL_E_RANGE, &sphere, &none);
    tiny->scene.draw_list_needed = 0;
    sphere.centre.y = 0;
    expect_refused(FXL_E_ORDER, &sphere, &none);
}

/* A sphere among cubes that are turned and scaled: it slides along them, and is never within one.
 */

static fxl_placement placements[TINY_INSTANCES];

/* No cube is turned yet. */
static void start_turned(void)
{
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        placements[i] = (fxl_placement)FXL_PLACEMENT_NONE;
    }
    tiny->scene.placements = placements;
    tiny->scene.placement_code = &fxl_turned_instances;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
}

/* How far a point is from a cube, in units of 1/65536; 0 within. In the cube's own axes. */
static double distance_from(const fxl_point *point, uint32_t number)
{
    const fxl_placement *placement = &placements[number];
    const fxl_point *c = &tiny->instances[number].centre;
    const double to[3] = {(double)point->x - c->x, (double)point->y - c->y,
                          (double)point->z - c->z};
    double square = 0;
    for (int k = 0; k < 3; k++) {
        const int32_t *column = &placement->orientation.x.x + k;
        const double along =
            (column[0] * to[0] + column[3] * to[1] + column[6] * to[2]) / FXL_Q2_30_ONE;
        const double out = fabs(along) - placement->scale;
        square += out > 0 ? out * out : 0;
    }
    return sqrt(square);
}

static double distance_of_turned(const fxl_point *point)
{
    double nearest = 1e30;
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        const double here = distance_from(point, i);
        nearest = here < nearest ? here : nearest;
    }
    return nearest;
}

/* A sphere that reaches into a cube by 10/65536 is pushed straight away from it. */
/* collide 3.5b */
void test_a_push_off_a_turned_face_is_what_its_scale_asks_for(void)
{
    static const fxl_q16_16 scales[] = {FXL_Q16_16_ONE,         FXL_Q16_16_ONE + 1, Q16(1.25),
                                        Q16(1.25) + 1,          Q16(3.9),           Q16(45),
                                        FXL_SCALE_MIN};
    start_turned();
    tiny->scene.instance_count = 1;
    for (uint32_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
        const fxl_point *c = &tiny->instances[0].centre;
        placements[0].scale = scales[i];
        const fxl_q16_16 reach = fxl_placement_radius(&placements[0], tiny->models[0].radius);
        const fxl_q16_16 more = (4 * scales[i] + 65535) / 65536 + 4 + reach / (64 * 65536);
        fxl_sphere sphere = {{c->x, c->y, c->z + scales[i] + Q16(1) - 10}, Q16(1)};
        const fxl_point none = {0, 0, 0};
        fxl_slide slide;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &none, &slide));
        TEST_ASSERT_EQUAL_UINT16(1, slide.contacts);
        TEST_ASSERT_EQUAL_INT32(c->z + scales[i] + Q16(1) + more + 8, sphere.centre.z);
    }
}

static void place_all(fxl_q16_16 scale_most)
{
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        placements[i].orientation = unit_orientation();
        placements[i].scale = unit_between(FXL_Q16_16_ONE / 4, scale_most);
    }
}

/* As of cubes that stand still: free after every call, however long the way. */
/* collide 3.5a-b */
void test_no_sphere_is_ever_within_a_turned_face(void)
{
    start_turned();
    slide_counts counts = {0, 0};
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        place_all(Q16(3));
        fxl_sphere sphere = {unit_point(Q16(6)), unit_between(FXL_SLIDE_RADIUS_MIN, Q16(1.5))};
        sphere.centre.z += unit_between(0, Q16(8));
        if (distance_of_turned(&sphere.centre) < sphere.radius + 64) {
            continue;
        }
        slides_stay_free(&tiny->scene, &sphere, distance_of_turned, 3, &counts);
    }
    TEST_ASSERT_TRUE(counts.contacts > 10 && counts.slid > 3);
}

/* Straight into a face that is turned by half a right angle it stops there, a gap away. */
/* collide 3.5a */
void test_a_sphere_stops_at_a_turned_face(void)
{
    start_turned();
    const fxl_q2_30 diagonal = 759250125; /* 2^30 / sqrt(2) */
    placements[0] = (fxl_placement){
        {{diagonal, 0, diagonal}, {0, FXL_Q2_30_ONE, 0}, {-diagonal, 0, diagonal}}, Q16(2)};
    tiny->scene.instance_count = 1;
    fxl_sphere sphere = {{Q16(-3), 0, Q16(-3)}, Q16(0.5)};
    const fxl_point straight = {Q16(4), 0, Q16(4)}, along = {Q16(0.5), Q16(0.25), Q16(-0.5)};
    fxl_slide slide;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &straight, &slide));
    const double gap = distance_from(&sphere.centre, 0) - sphere.radius;
    TEST_ASSERT_TRUE(gap > 8 + 8 && gap < 8 + 4 + 12 + 4);
    TEST_ASSERT_TRUE(slide.contacts > 0 && slide.blocked == 0 && slide.instance == 0);
    const fxl_point before = sphere.centre;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &along, &slide));
    TEST_ASSERT_INT32_WITHIN(8, before.x + along.x, sphere.centre.x);
    TEST_ASSERT_INT32_WITHIN(8, before.y + along.y, sphere.centre.y);
    TEST_ASSERT_INT32_WITHIN(8, before.z + along.z, sphere.centre.z);
}

/* A vertex off the plane of its face, much enlarged: a sphere before it keeps away from it. The
 * face has no neighbours, whose edges would keep the sphere away. */
/* collide 3.5b */
void test_a_vertex_off_its_plane_is_kept_away_from(void)
{
    start_turned();
    uint32_t pushed = 0;
    tiny->faces[0] = tiny->faces[5];
    tiny->models[0].face_count = 1;
    tiny->scene.instance_count = tiny->scene.model_count = tiny->scene.face_count = 1;
    tiny->scene.vertex_count = 8;
    tiny->scene.index_count = 24;
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    tiny->vertices[7].z += FXL_PLANARITY_MAX; /* of the face +z, whose first vertex is another */
    for (int round = 0; round < UNIT_REPEAT / 200; round++) {
        const fxl_q16_16 scale = Q16(200);
        placements[0] = (fxl_placement){unit_orientation(), scale};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
        /* In the cube's axes: over the face, beside the vertex. */
        const fxl_q16_16 beside = unit_between(0, 100), radius = unit_between(Q16(4), Q16(20));
        const fxl_q16_16 above = radius / 200 + 400;
        const fxl_point start = {Q16(1) - beside, Q16(1) - beside, Q16(1) + above};
        const fxl_point end = {Q16(1) - beside, Q16(1) - beside, Q16(1)};
        const fxl_point *centre = &tiny->instances[0].centre;
        fxl_point vertex, to;
        fxl_sphere sphere = {{0, 0, 0}, radius};
        fxl_slide slide;
        fxl_placement_point(&placements[0], centre, &start, &sphere.centre);
        fxl_placement_point(&placements[0], centre, &end, &to);
        fxl_placement_point(&placements[0], centre, &tiny->vertices[7], &vertex);
        const fxl_point move = {to.x - sphere.centre.x, to.y - sphere.centre.y,
                                to.z - sphere.centre.z};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(&tiny->scene, &sphere, &move, &slide));
        const double d[3] = {(double)vertex.x - sphere.centre.x, (double)vertex.y - sphere.centre.y,
                             (double)vertex.z - sphere.centre.z};
        TEST_ASSERT_TRUE(sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) >= radius - 2);
        pushed += slide.contacts > 0;
    }
    TEST_ASSERT_TRUE(pushed > 0);
}

/* collide 3.5c */
void test_placements_that_cannot_be_are_refused(void)
{
    start_turned();
    const fxl_sphere sphere = {{Q16(5), 0, 0}, Q16(1)};
    const fxl_point move = {Q16(1), 0, 0};
    fxl_slide slide = {7, 7, 7, 7};
    const fxl_slide untouched = slide;
    fxl_sphere moved = sphere;
    placements[1].orientation.x.x = 0;
    TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, fxl_slide_sphere(&tiny->scene, &moved, &move, &slide));
    placements[1] = (fxl_placement)FXL_PLACEMENT_NONE;
    placements[2].scale = 0;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_slide_sphere(&tiny->scene, &moved, &move, &slide));
    placements[2] = (fxl_placement)FXL_PLACEMENT_NONE;
    tiny->scene.placement_code = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_slide_sphere(&tiny->scene, &moved, &move, &slide));
    TEST_ASSERT_EQUAL_MEMORY(&sphere, &moved, sizeof moved);
    TEST_ASSERT_EQUAL_MEMORY(&untouched, &slide, sizeof slide);
}
