/* SPDX-License-Identifier: MIT */
#include "game/exact.h"
#include "view_planes.h"

static fxl_camera camera;
static fxl_view_frustum frustum;
static fxl_frustum world;

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
    view_planes_look(&pose, &lens, &camera, &frustum, &world);
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
        view_planes_look(&pose, &lens, &camera, &frustum, &world);
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
    static const fxl_face faces[] = {{{0, 0, 0}, 0, 3, 0, 0}, {{0, 0, 0}, 3, 3, 0, 0}};
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
    view_planes_look(&pose, &lens, &camera, &frustum, &world);
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
