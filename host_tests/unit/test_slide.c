/* SPDX-License-Identifier: MIT */
/* A sphere among cubes: it slides along them, and is never within one. */
#include <math.h>

#include "slides.h"
#include "tiny.h"

static tiny_scene *tiny;

void setUp(void)
{
    tiny = tiny_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
}

void tearDown(void)
{
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

/* collide 3.1 */
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
/* collide 3.1 */
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
/* collide 3.4, accuracy 1.2 */
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
/* collide 3.2 */
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
/* collide 3.4 */
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
/* collide 3.2, 3.3 */
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
/* collide 3.3 */
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
/* collide 3.1 */
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
/* collide 3.1 */
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
/* collide 3.1 */
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

/* collide 3.4 */
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
