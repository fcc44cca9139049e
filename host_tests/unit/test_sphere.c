/* SPDX-License-Identifier: MIT */
/* Spheres and boxes about a frustum: which planes they reach, and what is outside. */
#include "unit.h"
#include "clip_unit.h"
#include "wide.h"
#include "game/exact.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    LEAST = 4, /* what the reach has beyond the radius, in units of 2^-12 */
    MOST = 12
};

static fxl_camera camera;
static fxl_view_frustum frustum;
static fxl_frustum world;

static wide scaled(int64_t value)
{
    return wide_product(value, 1 << 30);
}

/* The distance of a point from a plane of the view, in units of 2^-76: exact. */
static wide distance(int plane, const fxl_point *point)
{
    fxl_view_point at;
    fxl_transform_point(&camera, point, &at);
    wide x = wide_product(at.x, frustum.x_side), x_along = wide_product(at.z, frustum.x_depth);
    wide y = wide_product(at.y, frustum.y_side), y_along = wide_product(at.z, frustum.y_depth);
    wide inset = scaled(frustum.inset);
    switch (plane) {
    case FXL_PLANE_NEAR:
        return wide_difference(scaled(at.z), scaled(frustum.near_z));
    case FXL_PLANE_FAR:
        return wide_difference(scaled(frustum.far_z), scaled(at.z));
    case FXL_PLANE_LEFT:
        return wide_difference(wide_sum(x_along, x), inset);
    case FXL_PLANE_RIGHT:
        return wide_difference(wide_difference(x_along, x), inset);
    case FXL_PLANE_BOTTOM:
        return wide_difference(wide_sum(y_along, y), inset);
    default:
        return wide_difference(wide_difference(y_along, y), inset);
    }
}

/* A radius and some units of 2^-12, in units of 2^-76. */
static wide reach(fxl_q16_16 radius, int extra)
{
    return scaled(((int64_t)radius + 16 * extra) * (1 << 30));
}

/* What the header says, plane by plane. */
static void expect_planes(uint32_t planes, const fxl_point *centre, fxl_q16_16 radius)
{
    const wide zero = {0, 0};
    bool surely_outside = false, maybe_outside = false;
    for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
        wide inside = distance(plane, centre), outside = wide_difference(zero, inside);
        surely_outside |= wide_compare(outside, reach(radius, MOST)) >= 0;
        maybe_outside |= wide_compare(outside, reach(radius, LEAST)) > 0;
        if (planes != FXL_SPHERE_OUTSIDE && (planes >> plane & 1u) == 0) {
            TEST_ASSERT_TRUE(wide_compare(inside, reach(radius, LEAST)) >= 0);
        } else if (planes != FXL_SPHERE_OUTSIDE) {
            TEST_ASSERT_TRUE(wide_compare(inside, reach(radius, MOST)) < 0);
        }
    }
    TEST_ASSERT_TRUE(planes <= FXL_SPHERE_OUTSIDE);
    TEST_ASSERT_TRUE(planes == FXL_SPHERE_OUTSIDE ? maybe_outside : !surely_outside);
}

/* Straight ahead, 90 degrees wide: side planes at |x| = z and |y| = 2/3 z. */
/* SPEC 4.4d-e */
void test_spheres_about_a_known_frustum(void)
{
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const struct {
        fxl_point centre;
        fxl_q16_16 radius;
        uint32_t planes;
    } cases[] = {
        {{0, 0, Q16(10)}, Q16(1), 0},
        {{0, 0, Q16(1)},
         Q16(0.9),
         1u << FXL_PLANE_LEFT | 1u << FXL_PLANE_RIGHT | 1u << FXL_PLANE_BOTTOM |
             1u << FXL_PLANE_TOP},
        {{0, 0, Q16(-1)}, Q16(0.9), FXL_SPHERE_OUTSIDE},
        {{0, 0, Q16(1002)}, Q16(1.5), FXL_SPHERE_OUTSIDE},
        {{0, 0, Q16(1000)}, Q16(1), 1u << FXL_PLANE_FAR},
        {{Q16(-10), 0, Q16(10)}, Q16(1), 1u << FXL_PLANE_LEFT},
        {{Q16(10), 0, Q16(10)}, Q16(1), 1u << FXL_PLANE_RIGHT},
        {{0, Q16(-20), Q16(30)}, Q16(1), 1u << FXL_PLANE_BOTTOM},
        {{0, Q16(20), Q16(30)}, Q16(1), 1u << FXL_PLANE_TOP},
        {{Q16(-10), 0, Q16(8)}, Q16(1), FXL_SPHERE_OUTSIDE},
        {{Q16(10), 0, Q16(8)}, Q16(1), FXL_SPHERE_OUTSIDE},
        {{0, Q16(-20), Q16(28)}, Q16(1), FXL_SPHERE_OUTSIDE},
        {{0, Q16(20), Q16(28)}, Q16(1), FXL_SPHERE_OUTSIDE},
        {{0, 0, 0}, FXL_RADIUS_MAX, (1u << FXL_PLANE_COUNT) - 1},
        {{0, 0, Q16(10)}, 0, 0},
        {{FXL_COORDINATE_MAX, FXL_COORDINATE_MAX, -FXL_COORDINATE_MAX}, 0, FXL_SPHERE_OUTSIDE},
    };
    clip_look(&pose, &lens, &camera, &frustum, &world);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        TEST_ASSERT_EQUAL_HEX32(
            cases[i].planes,
            fxl_sphere_planes(&camera, &frustum, &cases[i].centre, cases[i].radius));
        expect_planes(cases[i].planes, &cases[i].centre, cases[i].radius);
    }
}

static fxl_q16_16 clamped(int64_t radius)
{
    radius = radius < 0 ? 0 : radius;
    return radius > FXL_RADIUS_MAX ? FXL_RADIUS_MAX : (fxl_q16_16)radius;
}

/* Any sphere, or one that touches a plane to within a few units of the slack. */
static fxl_q16_16 any_radius(const fxl_point *centre)
{
    if (unit_random() % 4 == 0) {
        return clamped(unit_wide(unit_random() % 2 ? 31 : 20));
    }
    fxl_view_point at;
    fxl_transform_point(&camera, centre, &at);
    int64_t gap =
        fxl_view_distance(&frustum, (int)(unit_random() % FXL_PLANE_COUNT), &at) / (1 << 30);
    return clamped((gap < 0 ? -gap : gap) + unit_between(-400, 400));
}

/* A centre that the frustum is likely to be near: most are not seen otherwise. */
static fxl_point any_centre(const fxl_pose *pose)
{
    fxl_point centre = unit_point(FXL_COORDINATE_MAX);
    if (unit_random() % 2) {
        int32_t spread = unit_between(1, Q16(100));
        int64_t x = (int64_t)pose->position.x + unit_between(-spread, spread);
        int64_t y = (int64_t)pose->position.y + unit_between(-spread, spread);
        int64_t z = (int64_t)pose->position.z + unit_between(-spread, spread);
        if (x == (int32_t)x && x < FXL_COORDINATE_MAX && -x < FXL_COORDINATE_MAX &&
            y < FXL_COORDINATE_MAX && -y < FXL_COORDINATE_MAX && z < FXL_COORDINATE_MAX &&
            -z < FXL_COORDINATE_MAX) {
            centre = (fxl_point){(fxl_q16_16)x, (fxl_q16_16)y, (fxl_q16_16)z};
        }
    }
    return centre;
}

/* SPEC 4.4b-e, accuracy 1.1l */
void test_planes_against_exact_distances(void)
{
    uint32_t outside = 0, inside = 0, crossing = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_pose pose = unit_pose();
        fxl_lens lens = unit_any_lens();
        clip_look(&pose, &lens, &camera, &frustum, &world);
        fxl_point centre = any_centre(&pose);
        fxl_q16_16 radius = any_radius(&centre);
        uint32_t planes = fxl_sphere_planes(&camera, &frustum, &centre, radius);
        expect_planes(planes, &centre, radius);
        outside += planes == FXL_SPHERE_OUTSIDE;
        inside += planes == 0;
        crossing += planes != 0 && planes != FXL_SPHERE_OUTSIDE;
    }
    TEST_ASSERT_TRUE(outside > UNIT_REPEAT / 4 && crossing > UNIT_REPEAT / 8 &&
                     inside > UNIT_REPEAT / 500);
}

/* A vertex of a model with that radius: on the sphere, as far along a direction
 * as whole numbers let it. False where the world ends before. */
static bool place_vertex(const fxl_direction *towards, const fxl_point *centre, fxl_q16_16 radius,
                         fxl_point *vertex)
{
    int64_t to[3] = {towards->x, towards->y, towards->z};
    int64_t from[3] = {centre->x, centre->y, centre->z};
    int64_t at[3], square = 0;
    for (int axis = 0; axis < 3; axis++) {
        int64_t step = to[axis] * radius / (1 << 30);
        square += step * step;
        at[axis] = from[axis] + step;
        if (at[axis] > FXL_COORDINATE_MAX || at[axis] < -FXL_COORDINATE_MAX) {
            return false;
        }
    }
    *vertex = (fxl_point){(fxl_q16_16)at[0], (fxl_q16_16)at[1], (fxl_q16_16)at[2]};
    return square <= (int64_t)radius * radius;
}

/* No vertex is inside the plane that its sphere lies outside of, none outside a
 * plane that the sphere lies inside of; in the view as in the world. */
static void expect_vertex(uint32_t planes, const fxl_point *vertex, bool *seen)
{
    fxl_view_point at;
    fxl_transform_point(&camera, vertex, &at);
    for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
        bool in_view = fxl_view_distance(&frustum, plane, &at) >= 0;
        bool in_world = fxl_plane_distance(&world.planes[plane], vertex) >= 0;
        seen[plane] |= in_view || in_world;
        if (planes != FXL_SPHERE_OUTSIDE && (planes >> plane & 1u) == 0) {
            TEST_ASSERT_TRUE(in_view && in_world);
        }
    }
}

/* SPEC 4.4e, 4.4g */
void test_vertices_of_what_is_left_out(void)
{
    uint32_t outside = 0, inside = 0;
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        fxl_pose pose = unit_pose();
        fxl_lens lens = unit_any_lens();
        clip_look(&pose, &lens, &camera, &frustum, &world);
        fxl_point centre = any_centre(&pose), vertex;
        fxl_q16_16 radius = any_radius(&centre);
        uint32_t planes = fxl_sphere_planes(&camera, &frustum, &centre, radius);
        bool seen[FXL_PLANE_COUNT] = {false};
        uint32_t model_view = 0;
        for (int k = 0; k < 4 * FXL_PLANE_COUNT; k++) {
            /* Towards each plane, away from it, and anywhere. */
            fxl_direction towards = world.planes[k / 4].normal;
            if (k % 4 == 1) {
                towards = (fxl_direction){-towards.x, -towards.y, -towards.z};
            } else if (k % 4 > 1) {
                towards = unit_direction();
            }
            if (place_vertex(&towards, &centre, radius, &vertex)) {
                expect_vertex(planes, &vertex, seen);
                model_view++;
            }
        }
        if (planes == FXL_SPHERE_OUTSIDE && model_view > 0) {
            bool all = true;
            for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
                all = all && seen[plane];
            }
            TEST_ASSERT_FALSE(all);
        }
        outside += planes == FXL_SPHERE_OUTSIDE && model_view > 4;
        inside += planes < FXL_SPHERE_OUTSIDE - 1 && model_view > 4;
    }
    TEST_ASSERT_TRUE(outside > UNIT_REPEAT / 64 && inside > UNIT_REPEAT / 64);
}

/* Straight ahead, 90 degrees wide: side planes at |x| = z and |y| = 2/3 z. */
void test_boxes_about_a_known_frustum(void)
{
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    const fxl_lens lens = unit_lens(48, 32);
    const struct {
        fxl_box box;
        uint32_t planes;
    } cases[] = {
        {{{Q16(-1), Q16(-1), Q16(9)}, {Q16(1), Q16(1), Q16(11)}}, 0},
        {{{Q16(-1), Q16(-1), Q16(-3)}, {Q16(1), Q16(1), Q16(-1)}}, FXL_SPHERE_OUTSIDE},
        {{{Q16(-1), Q16(-1), Q16(999)}, {Q16(1), Q16(1), Q16(1001)}}, 1u << FXL_PLANE_FAR},
        {{{Q16(-1), Q16(-1), Q16(1001)}, {Q16(1), Q16(1), Q16(1002)}}, FXL_SPHERE_OUTSIDE},
        {{{Q16(-11), Q16(-1), Q16(9)}, {Q16(-8), Q16(1), Q16(10)}}, 1u << FXL_PLANE_LEFT},
        {{{Q16(8), Q16(-1), Q16(9)}, {Q16(11), Q16(1), Q16(10)}}, 1u << FXL_PLANE_RIGHT},
        {{{Q16(-1), Q16(-9), Q16(9)}, {Q16(1), Q16(-1), Q16(10)}}, 1u << FXL_PLANE_BOTTOM},
        {{{Q16(-1), Q16(1), Q16(9)}, {Q16(1), Q16(9), Q16(10)}}, 1u << FXL_PLANE_TOP},
        {{{Q16(-1), Q16(7), Q16(9)}, {Q16(1), Q16(9), Q16(10)}}, FXL_SPHERE_OUTSIDE},
        /* A long wall beside the view, which a sphere about it would reach into. */
        {{{Q16(11), Q16(-1), Q16(-90)}, {Q16(12), Q16(1), Q16(10)}}, FXL_SPHERE_OUTSIDE},
        {{{-FXL_COORDINATE_MAX, -FXL_COORDINATE_MAX, -FXL_COORDINATE_MAX},
          {FXL_COORDINATE_MAX, FXL_COORDINATE_MAX, FXL_COORDINATE_MAX}},
         (1u << FXL_PLANE_COUNT) - 1},
    };
    clip_look(&pose, &lens, &camera, &frustum, &world);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        TEST_ASSERT_EQUAL_HEX32(cases[i].planes, fxl_box_planes(&world, &cases[i].box));
    }
}

static fxl_q16_16 held(int64_t value)
{
    value = value > FXL_COORDINATE_MAX ? FXL_COORDINATE_MAX : value;
    return value < -FXL_COORDINATE_MAX ? -FXL_COORDINATE_MAX : (fxl_q16_16)value;
}

static void spread(fxl_q16_16 at, int32_t size, fxl_q16_16 *least, fxl_q16_16 *most)
{
    *least = held((int64_t)at - unit_between(0, size));
    *most = held((int64_t)at + unit_between(0, size));
}

/* A box about a point that the frustum is likely to be near. */
static fxl_box any_box(const fxl_pose *pose)
{
    int32_t far = 1 << unit_between(8, 29), size = 1 << unit_between(0, 29);
    fxl_box box;
    spread(held((int64_t)pose->position.x + unit_between(-far, far)), size, &box.least.x,
           &box.most.x);
    spread(held((int64_t)pose->position.y + unit_between(-far, far)), size, &box.least.y,
           &box.most.y);
    spread(held((int64_t)pose->position.z + unit_between(-far, far)), size, &box.least.z,
           &box.most.z);
    return box;
}

/* Each coordinate at an end, or anywhere between. */
static fxl_q16_16 any_of(fxl_q16_16 least, fxl_q16_16 most)
{
    uint32_t which = unit_random() % 4;
    return which == 0 ? least : which == 1 ? most : unit_between(least, most);
}

static uint32_t by_all_corners(const fxl_box *box)
{
    uint32_t crossed = 0;
    for (uint32_t i = 0; i < FXL_PLANE_COUNT; i++) {
        uint32_t outside = 0, inside = 0;
        for (uint32_t k = 0; k < 8; k++) {
            const fxl_point corner = {k & 1 ? box->most.x : box->least.x,
                                      k & 2 ? box->most.y : box->least.y,
                                      k & 4 ? box->most.z : box->least.z};
            fxl_q18_46 distance = fxl_plane_distance(&world.planes[i], &corner);
            outside += distance < -((fxl_q18_46)1 << 37);
            inside += distance >= (fxl_q18_46)1 << 37;
        }
        if (outside == 8) {
            return FXL_SPHERE_OUTSIDE;
        }
        crossed |= (uint32_t)(inside < 8) << i;
    }
    return crossed;
}

/* What all eight corners say; and of what lies in the box nothing is inside the plane that
 * the box lies outside of, in the view as in the world, nor outside one that it is inside. */
void test_any_box(void)
{
    uint32_t left_out = 0, inside = 0, crossing = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_pose pose = unit_pose();
        fxl_lens lens = unit_any_lens();
        clip_look(&pose, &lens, &camera, &frustum, &world);
        fxl_box box = any_box(&pose);
        uint32_t planes = fxl_box_planes(&world, &box), seen = 0;
        TEST_ASSERT_EQUAL_HEX32(by_all_corners(&box), planes);
        for (int k = 0; k < 8; k++) {
            const fxl_point at = {any_of(box.least.x, box.most.x), any_of(box.least.y, box.most.y),
                                  any_of(box.least.z, box.most.z)};
            fxl_view_point from_eye;
            fxl_transform_point(&camera, &at, &from_eye);
            for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
                bool in_view = fxl_view_distance(&frustum, plane, &from_eye) >= 0;
                bool in_world = fxl_plane_distance(&world.planes[plane], &at) >= 0;
                seen |= (uint32_t)(in_view || in_world) << plane;
                TEST_ASSERT_TRUE((planes >> plane & 1u) || planes == FXL_SPHERE_OUTSIDE ||
                                 (in_view && in_world));
            }
        }
        TEST_ASSERT_FALSE(planes == FXL_SPHERE_OUTSIDE && seen == FXL_SPHERE_OUTSIDE - 1);
        left_out += planes == FXL_SPHERE_OUTSIDE;
        inside += planes == 0;
        crossing += planes != 0 && planes != FXL_SPHERE_OUTSIDE;
    }
    TEST_ASSERT_TRUE(left_out > UNIT_REPEAT / 4 && crossing > UNIT_REPEAT / 8 &&
                     inside > UNIT_REPEAT / 500);
}

void test_the_box_of_an_object(void)
{
    static const fxl_point vertices[] = {
        {9, 9, 9}, {Q16(1), Q16(-2), 0}, {Q16(-3), 0, Q16(5)}, {0, Q16(4), Q16(-6)}};
    static const fxl_model models[] = {{0, 1, 0, 1, FXL_MODEL_CONVEX, 0, 0, Q16(9), 0},
                                       {1, 3, 0, 1, FXL_MODEL_CONVEX, 0, 0, Q16(9), 0}};
    static const fxl_instance instances[] = {{{Q16(10), Q16(20), Q16(30)}, 1, 0, 0}};
    static fxl_scene scene;
    scene.vertices = vertices;
    scene.models = models;
    scene.instances = instances;
    fxl_box box;
    fxl_box_of_instance(&scene, &instances[0], &box);
    const fxl_box wanted = {{Q16(7), Q16(18), Q16(24)}, {Q16(11), Q16(24), Q16(35)}};
    TEST_ASSERT_EQUAL_MEMORY(&wanted, &box, sizeof box);
}

/* Of one that has a placement: the points of every face, the first and the last. */
void test_the_box_of_a_turned_object(void)
{
    static const fxl_point vertices[] = {{Q16(1), Q16(-2), 0}, {Q16(-3), 0, Q16(5)},
                                         {0, Q16(4), Q16(-6)}, {Q16(2), Q16(-1), 0},
                                         {Q16(-4), 0, Q16(4)}, {0, Q16(5), Q16(-5)}};
    static const uint16_t indices[] = {0, 1, 2, 3, 4, 5};
    static const fxl_face faces[] = {{{0, 0, 0}, 3, 0, {0, 1, 2}}, {{0, 0, 0}, 3, 0, {3, 4, 5}}};
    static const fxl_model models[] = {{0, 6, 0, 2, FXL_MODEL_CONVEX, 0, 0, Q16(9), 0}};
    static const fxl_instance instances[] = {{{Q16(10), Q16(20), Q16(30)}, 0, 0, 0}};
    static const fxl_placement placements[] = {FXL_PLACEMENT_NONE};
    const fxl_scene scene = {.vertices = vertices,
                             .indices = indices,
                             .faces = faces,
                             .models = models,
                             .instances = instances,
                             .placements = placements,
                             .placement_code = &fxl_turned_instances,
                             .instance_count = 1};
    fxl_box box;
    fxl_box_of_instance(&scene, &instances[0], &box);
    const fxl_box wanted = {{Q16(6), Q16(18), Q16(24)}, {Q16(12), Q16(25), Q16(35)}};
    TEST_ASSERT_EQUAL_MEMORY(&wanted, &box, sizeof box);
}

/* A box whose farthest corner is 2^-9 outside a plane, which is 128 units, may still be seen; one
 * whose nearest corner is 2^-9 inside does not cross the plane. One unit more or less decides. */
void test_the_margin_is_exact(void)
{
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    const fxl_lens lens = unit_lens(48, 32);
    const fxl_q16_16 near = lens.near_z + lens.inset, far = lens.far_z - lens.inset;
    clip_look(&pose, &lens, &camera, &frustum, &world);
    for (int unit = -1; unit <= 1; unit++) {
        fxl_box box = {{-64, -64, near - 2000}, {64, 64, near - 128 + unit}};
        TEST_ASSERT_EQUAL(unit < 0, fxl_box_planes(&world, &box) == FXL_SPHERE_OUTSIDE);
        box = (fxl_box){{-64, -64, near + 128 + unit}, {64, 64, Q16(9)}};
        TEST_ASSERT_EQUAL(unit < 0, fxl_box_planes(&world, &box) >> FXL_PLANE_NEAR & 1u);
        box = (fxl_box){{-64, -64, far + 128 + unit}, {64, 64, far + 2000}};
        TEST_ASSERT_EQUAL(unit > 0, fxl_box_planes(&world, &box) == FXL_SPHERE_OUTSIDE);
        box = (fxl_box){{-64, -64, Q16(9)}, {64, 64, far - 128 + unit}};
        TEST_ASSERT_EQUAL(unit > 0, fxl_box_planes(&world, &box) >> FXL_PLANE_FAR & 1u);
    }
}
