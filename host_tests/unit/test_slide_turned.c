/* SPDX-License-Identifier: MIT */
/* A sphere among cubes that are turned and scaled: it slides along them, and is never within one.
 */
#include <math.h>

#include "slides.h"
#include "tiny.h"
#include "placements.h"

static tiny_scene *tiny;
static fxl_placement placements[TINY_INSTANCES];

void setUp(void)
{
    tiny = tiny_make();
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        placements[i] = (fxl_placement)FXL_PLACEMENT_NONE;
    }
    tiny->scene.placements = placements;
    tiny->scene.placement_code = &fxl_turned_instances;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
}

void tearDown(void)
{
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

static double distance(const fxl_point *point)
{
    double nearest = 1e30;
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        const double here = distance_from(point, i);
        nearest = here < nearest ? here : nearest;
    }
    return nearest;
}

static void place_all(fxl_q16_16 scale_most)
{
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        placements[i].orientation = placements_orientation();
        placements[i].scale = unit_between(FXL_Q16_16_ONE / 4, scale_most);
    }
}

/* As of cubes that stand still: free after every call, however long the way. */
/* collide 3.5 */
void test_no_sphere_is_ever_within_a_turned_face(void)
{
    slide_counts counts = {0, 0};
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        place_all(Q16(3));
        fxl_sphere sphere = {unit_point(Q16(6)), unit_between(FXL_SLIDE_RADIUS_MIN, Q16(1.5))};
        sphere.centre.z += unit_between(0, Q16(8));
        if (distance(&sphere.centre) < sphere.radius + 64) {
            continue;
        }
        slides_stay_free(&tiny->scene, &sphere, distance, 3, &counts);
    }
    TEST_ASSERT_TRUE(counts.contacts > 10 && counts.slid > 3);
}

/* Straight into a face that is turned by half a right angle it stops there, a gap away. */
/* collide 3.5 */
void test_a_sphere_stops_at_a_turned_face(void)
{
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
/* collide 3.5 */
void test_a_vertex_off_its_plane_is_kept_away_from(void)
{
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
        placements[0] = (fxl_placement){placements_orientation(), scale};
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

/* collide 3.5 */
void test_placements_that_cannot_be_are_refused(void)
{
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
