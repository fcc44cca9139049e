/* SPDX-License-Identifier: MIT */
/* The turned view of an instance: vertices, facing, order and the sphere test. */
#include "view/placement.h"
#include "unit.h"
#include "wide.h"

enum {
    VERTICES = 12,
    FACES = 4
};

static fxl_point vertices[VERTICES];
static const uint16_t indices[VERTICES] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
static fxl_face faces[FACES];
static fxl_face_bounds bounds[FACES];
static fxl_model model = {.vertex_count = VERTICES, .face_count = FACES, .kind = FXL_MODEL_SORTED};
static fxl_instance instance;
static fxl_placement placement;
static fxl_scene scene = {.vertices = vertices,
                          .indices = indices,
                          .faces = faces,
                          .models = &model,
                          .instances = &instance,
                          .model_count = 1,
                          .instance_count = 1,
                          .placements = &placement,
                          .placement_code = &fxl_turned_instances};
static fxl_view view;
static fxl_vertex_cache cache;
static fxl_turned_view turned;

static uint64_t square(int64_t value)
{
    return (uint64_t)(value * value);
}

static void make_bounds(void)
{
    for (uint32_t i = 0; i < FACES; i++) {
        int32_t box[3];
        uint64_t height = 0;
        for (int k = 0; k < 3; k++) {
            int32_t low = INT32_MAX, high = INT32_MIN;
            for (uint32_t c = 0; c < 3; c++) {
                const int32_t at = (&vertices[3 * i + c].x)[k];
                low = at < low ? at : low;
                high = at > high ? at : high;
            }
            box[k] = low + high;
            height += (uint64_t)((int64_t)(&faces[i].normal.x)[k] * (&vertices[3 * i].x)[k]);
        }
        bounds[i] =
            (fxl_face_bounds){(uint32_t)height, (uint32_t)(height >> 32), box[0], box[1], box[2]};
    }
}

/* A random model at a random place, and an eye: anywhere, or near a vertex. */
static void start(void)
{
    placement = unit_placement();
    const int64_t most =
        ((int64_t)(FXL_COORDINATE_MAX - FXL_PLACEMENT_SLACK) << 16) / placement.scale;
    model.radius = most < FXL_RADIUS_MAX ? (fxl_q16_16)most : FXL_RADIUS_MAX;
    model.radius >>= unit_between(0, 12);
    for (uint32_t i = 0; i < VERTICES; i++) {
        vertices[i] = unit_point((fxl_q16_16)((int64_t)model.radius * 577 / 1000));
    }
    for (uint32_t i = 0; i < FACES; i++) {
        faces[i] = (fxl_face){.normal = unit_direction(), .count = 3};
        fxl_face_take_indices(&faces[i], indices, 3 * i);
    }
    make_bounds();
    scene.face_bounds = unit_between(0, 1) ? bounds : NULL;
    const fxl_q16_16 reach = fxl_placement_radius(&placement, model.radius);
    instance.centre = unit_point(FXL_COORDINATE_MAX - reach);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_placement_check(&placement, &instance.centre, model.radius));
    fxl_lens lens = unit_any_lens();
    fxl_pose pose = unit_pose();
    if (unit_between(0, 2) != 0) {
        fxl_placement_point(&placement, &instance.centre, &vertices[unit_random() % VERTICES],
                            &pose.position);
    }
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    fxl_vertex_cache_init(&cache, NULL, 0);
}

static void set_up(uint32_t planes)
{
    fxl_turned_view_of_instance(&turned, &scene, 0, &view, &cache, planes);
}

/* t + 2^shift (M . v), exact, with t = view . (centre - eye). */
static fxl_view_point position_of(uint32_t number)
{
    fxl_axes matrix;
    const unsigned shift = fxl_placement_matrix(&placement, &view.camera.axes, &matrix);
    const fxl_point *v = &vertices[number], *c = &instance.centre, *e = &view.camera.position;
    fxl_q18_46 at[3];
    for (int i = 0; i < 3; i++) {
        const fxl_direction *axis = &view.camera.axes.right + i, *row = &matrix.right + i;
        at[i] = (int64_t)axis->x * (c->x - e->x) + (int64_t)axis->y * (c->y - e->y) +
                (int64_t)axis->z * (c->z - e->z) +
                (((int64_t)row->x * v->x + (int64_t)row->y * v->y + (int64_t)row->z * v->z) *
                 ((int64_t)1 << shift));
    }
    return (fxl_view_point){at[0], at[1], at[2]};
}

/* SPEC 8.2a-c */
void test_vertices_in_the_view(void)
{
    uint32_t scaled = 0, outside = 0;
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        start();
        const fxl_planes planes = (fxl_planes)(unit_random() & FXL_PLANES_ALL);
        set_up(planes);
        for (uint32_t i = 0; i < VERTICES; i++) {
            const fxl_view_point expected = position_of(i);
            const fxl_cached_vertex *seen = fxl_fetch_vertex(&turned.model_view, i);
            TEST_ASSERT_EQUAL_MEMORY(&expected, &seen->position, sizeof expected);
            const fxl_planes outcode = fxl_outcode(&view.view_frustum, planes, &expected);
            TEST_ASSERT_EQUAL_HEX32(outcode | FXL_VERTEX_UNPROJECTED, seen->clip_flags);
            outside += outcode != 0;
        }
        scaled += turned.model_view.shift != 0;
    }
    TEST_ASSERT_TRUE(scaled > UNIT_REPEAT / 100 && outside > UNIT_REPEAT / 100);
}

/* Whether a face is turned to the eye, by fxl_placement_is_front, which uses all bits. */
static bool is_front(uint32_t number)
{
    const fxl_face *face = &faces[number];
    const fxl_point *first = &vertices[3 * number], *centre = &instance.centre,
                    *eye = &view.camera.position;
    const fxl_point from_eye = {centre->x - eye->x, centre->y - eye->y, centre->z - eye->z};
    return fxl_placement_is_front(&placement, &from_eye, &face->normal,
                                  (int64_t)face->normal.x * first->x +
                                      (int64_t)face->normal.y * first->y +
                                      (int64_t)face->normal.z * first->z);
}

/* The estimate never decides what the exact sign does not. */
/* SPEC 8.3a */
void test_facing(void)
{
    int fronts = 0, undecided = 0;
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        start();
        set_up(0);
        for (uint32_t i = 0; i < FACES; i++) {
            TEST_ASSERT_EQUAL(is_front(i), fxl_turned_view_face_is_front(&turned, &faces[i],
                                                                         turned.eye_shift == 0));
            fronts += is_front(i);
            if (turned.eye_shift == 0) {
                const fxl_point first = fxl_model_view_vertex(&turned.model_view, 3 * i);
                undecided += fxl_estimated_side((int64_t)faces[i].normal.x * first.x +
                                                (int64_t)faces[i].normal.y * first.y +
                                                (int64_t)faces[i].normal.z * first.z) == 0;
            }
        }
    }
    TEST_ASSERT_TRUE(fronts > UNIT_REPEAT / 10 && undecided > 0);
}

/* The key of a face: the squared distance of the eye, rounded as fxl_placement_eye says, from the
 * box, rounded down to the same unit. */
static uint64_t distance_of(uint32_t number, const fxl_point *eye, unsigned shift)
{
    const fxl_face_bounds *box = &bounds[number];
    return square((int64_t)(box->box_x >> shift) - 2 * (int64_t)eye->x) +
           square((int64_t)(box->box_y >> shift) - 2 * (int64_t)eye->y) +
           square((int64_t)(box->box_z >> shift) - 2 * (int64_t)eye->z);
}

/* SPEC 8.3b, 8.4c */
void test_the_order_of_faces(void)
{
    int shifted = 0;
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        fxl_draw_entry entries[FACES];
        fxl_point eye;
        uint32_t count = 0;
        start();
        set_up(0);
        const fxl_point *c = &instance.centre, *e = &view.camera.position;
        const fxl_point from_eye = {c->x - e->x, c->y - e->y, c->z - e->z};
        const unsigned shift = fxl_placement_eye(&placement, &from_eye, model.radius, &eye);
        const uint32_t found =
            fxl_list_turned_faces(&turned, &scene, &model, 0, model.face_count, entries);
        for (uint32_t i = 0; i < FACES; i++) {
            if (is_front(i)) {
                TEST_ASSERT_TRUE(count < found);
                TEST_ASSERT_EQUAL_UINT16(i, entries[count].index);
                TEST_ASSERT_TRUE(distance_of(i, &eye, shift) ==
                                 fxl_draw_entry_distance(&entries[count]));
                count++;
            }
        }
        TEST_ASSERT_EQUAL_UINT32(count, found);
        shifted += shift > 0;
    }
    TEST_ASSERT_TRUE(shifted > 0);
}

/* No vertex, by the matrix or rounded in the world, lies outside of a plane that the order says the
 * instance does not cross; and all lie outside of one where it is left out. */
void test_the_sphere_of_a_turned_instance(void)
{
    uint32_t counts[2] = {0, 0};
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        fxl_draw_entry entry;
        uint32_t left_out, all = FXL_PLANES_ALL, any = 0;
        start();
        const uint32_t seen = scene.placement_code->list_instances(
            &scene, &view.camera, &view.view_frustum, &entry, &left_out);
        TEST_ASSERT_EQUAL_UINT32(seen ? 0 : FACES, left_out);
        for (uint32_t i = 0; i < VERTICES; i++) {
            fxl_view_point at = position_of(i);
            fxl_point point;
            uint32_t code = fxl_outcode(&view.view_frustum, FXL_PLANES_ALL, &at);
            all &= code;
            any |= code;
            fxl_placement_point(&placement, &instance.centre, &vertices[i], &point);
            fxl_transform_point(&view.camera, &point, &at);
            code = fxl_outcode(&view.view_frustum, FXL_PLANES_ALL, &at);
            all &= code;
            any |= code;
        }
        TEST_ASSERT_TRUE(seen ? (any & ~(uint32_t)entry.instance.planes) == 0 : all != 0);
        counts[seen]++;
    }
    TEST_ASSERT_TRUE(counts[0] > UNIT_REPEAT / 100 && counts[1] > UNIT_REPEAT / 100);
}
