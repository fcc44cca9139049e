/* SPDX-License-Identifier: MIT */
/* The kernels that process faces. */

#include "draw/surface_polygon.h"
#include "equality.h"
#include "sides.h"

#include <string.h>

#define VERTICES 8u
#define ENTRIES  4u /* at most: some vertices evict each other */
#define FACES    5u

static int32_t within(int32_t limit)
{
    return (int32_t)(any_32() % (2u * (uint32_t)limit + 1u)) - limit;
}

/* --- which face the eye ------------------------------------------------------ */

/* As a scene may have it: a coordinate below 2^30, a normal's below 2^30 + 1. */
static int32_t coordinate(void)
{
    static const int32_t ends[] = {0, 1, -1, (1 << 30) - 1, 1 - (1 << 30), 65536, -65536};
    uint32_t choice = any_32() >> 7 & 31u;
    return choice < 7 ? ends[choice] : (int32_t)any_32() >> (2 + (any_32() >> 9 & 15u));
}

static int64_t dot(const fxl_direction *normal, const fxl_point *eye)
{
    return (int64_t)normal->x * eye->x + (int64_t)normal->y * eye->y + (int64_t)normal->z * eye->z;
}

/* A unit vector's coordinates, near enough for the sum's bound: one of them alone, or three of
 * half of one. */
static fxl_direction any_normal(void)
{
    fxl_direction normal = {0, 0, 0};
    switch (any_32() >> 13 & 3u) {
    case 0:
        normal.x = any_32() & 64u ? 1 << 30 : -(1 << 30);
        break;
    case 1:
        normal.z = within(1 << 30);
        break;
    default:
        normal = (fxl_direction){within(1 << 29), within(1 << 29), within(1 << 29)};
    }
    return normal;
}

static void any_faces(fxl_face *faces, fxl_face_bounds *keys, const fxl_point *eye)
{
    for (uint32_t i = 0; i < FACES; i++) {
        faces[i].normal = any_normal();
        int64_t height = dot(&faces[i].normal, eye) + within(2);
        if (any_32() & 128u) {
            height = (int64_t)any_64() >> (3 + (any_32() >> 5 & 31u));
        }
        keys[i].height_low = (uint32_t)height;
        keys[i].height_high = (uint32_t)((uint64_t)height >> 32);
        keys[i].box_x = 2 * coordinate();
        keys[i].box_y = 2 * coordinate();
        keys[i].box_z = 2 * coordinate();
        /* Of a box and an eye less than 2^30 apart. */
        keys[i].box_x = eye->x + keys[i].box_x / 2;
        keys[i].box_y = eye->y + keys[i].box_y / 2;
        keys[i].box_z = eye->z + keys[i].box_z / 2;
    }
}

static bool same_entries(const fxl_draw_entry *a, const fxl_draw_entry *b, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        if (fxl_draw_entry_distance(&a[i]) != fxl_draw_entry_distance(&b[i]) ||
            a[i].index != b[i].index) {
            return false;
        }
    }
    return true;
}

void test_front_faces(uint32_t rounds)
{
    static fxl_face faces[FACES];
    static fxl_face_bounds keys[FACES];
    fxl_draw_entry core[FACES], portable[FACES];
    for (uint32_t i = 0; i < rounds; i++) {
        const fxl_point eye = {coordinate(), coordinate(), coordinate()};
        const uint32_t count = 1u + (any_32() >> 11) % FACES;
        const uint32_t end = count + (any_32() >> 9) % (FXL_MODEL_FACES_MAX - FACES);
        any_faces(faces, keys, &eye);
        uint32_t by_core = (uint32_t)(fxl_front_faces(faces, keys, &eye, core, count, end) - core);
        uint32_t by_portable =
            (uint32_t)(portable_front_faces(faces, keys, &eye, portable, count, end) - portable);
        equality_case(by_core == by_portable && same_entries(core, portable, by_core));
    }
}

/* --- to the screen ------------------------------------------------------------ */

static fxl_view view;
static fxl_point vertices[VERTICES];
static uint16_t corners[FXL_FACE_VERTICES_MAX];

typedef struct {
    fxl_cached_vertex entries[ENTRIES];
    fxl_model_view placed;
    fxl_clipper_work work;
    fxl_screen_polygon screen;
} side;

static side by_core, by_portable;

static void any_view(void)
{
    fxl_pose pose = {{0, 0, 0}, any_32(), any_32(), any_32()};
    fxl_lens lens;
    fxl_angle fov = FXL_FOV_MIN + any_32() % (FXL_FOV_MAX - FXL_FOV_MIN + 1u);
    fxl_lens_from_fov((uint16_t)(1u + any_32() % 1024u), (uint16_t)(1u + any_32() % 1024u), fov,
                      FXL_NEAR_MIN << (any_32() >> 9 & 7u), FXL_FAR_MAX, 4, &lens);
    any_centre(&lens);
    fxl_view_set_lens(&view, &lens);
    fxl_view_set_pose(&view, &pose);
}

/* Along an axis, 2^30 / scale of it. */
static int32_t along(fxl_q2_30 axis, int32_t length)
{
    return (int32_t)((int64_t)axis * length >> 30);
}

/* Relative to the eye: mostly before it, some of it together, so that a face may lie between
 * the centres of pixels. */
static void any_vertices(void)
{
    const fxl_camera *camera = &view.camera;
    int32_t depth = 1 + (int32_t)(any_32() >> (4u + (any_32() >> 9) % 24u));
    int32_t x = within(depth), y = within(depth);
    int32_t spread = 1 + depth / (1 << (any_32() >> 11) % 14u);
    for (uint32_t i = 0; i < VERTICES; i++) {
        int32_t right = x + within(spread), up = y + within(spread),
                forward = depth + within(spread);
        vertices[i].x = along(camera->axes.right.x, right) + along(camera->axes.up.x, up) +
                        along(camera->axes.forward.x, forward);
        vertices[i].y = along(camera->axes.right.y, right) + along(camera->axes.up.y, up) +
                        along(camera->axes.forward.y, forward);
        vertices[i].z = along(camera->axes.right.z, right) + along(camera->axes.up.z, up) +
                        along(camera->axes.forward.z, forward);
    }
}

static void place(side *to, uint32_t mask, uint32_t tag, fxl_planes planes)
{
    memset(to, 0x5A, sizeof *to);
    memset(to->entries, 0, sizeof to->entries);
    to->placed = (fxl_model_view){.view = &view,
                                  .axes = &view.camera.axes,
                                  .entries = to->entries,
                                  .mask = mask,
                                  .tag = tag,
                                  .vertices = vertices,
                                  .indices = corners,
                                  .planes = planes};
}

/* The planes that a vertex lies outside of. */
static fxl_planes crossed(void)
{
    fxl_planes planes = 0;
    place(&by_core, 0, 0, FXL_PLANES_ALL);
    for (uint32_t i = 0; i < VERTICES; i++) {
        fxl_transform_vertex(&by_core.placed, i, by_core.entries);
        planes = (fxl_planes)(planes | (by_core.entries[0].clip_flags & FXL_PLANES_ALL));
    }
    return planes;
}

/* One face twice, or two faces that share vertices, so some vertices are found in the cache. */
static void compare(const fxl_face *face)
{
    fxl_clip_result core = fxl_clip_by_view(&by_core.placed, face, &by_core.work, &by_core.screen);
    fxl_clip_result portable =
        portable_clip_by_view(&by_portable.placed, face, &by_portable.work, &by_portable.screen);
    bool drawn = core == FXL_CLIP_INSIDE || core == FXL_CLIP_CUT || core == FXL_CLIP_BETWEEN;
    equality_case(
        core == portable &&
        memcmp(by_core.entries, by_portable.entries, sizeof by_core.entries) == 0 &&
        (!drawn || (by_core.screen.colour == by_portable.screen.colour &&
                    by_core.screen.count == by_portable.screen.count &&
                    memcmp(by_core.screen.points, by_portable.screen.points,
                           by_core.screen.count * sizeof by_core.screen.points[0]) == 0)));
}

#if FXL_DRAWS_SMOOTH_OUTLINES

/* The corners of a triangle that the clipper finds inside, with their box. Then its entries are those that the
 * clipper leaves. */
static void compare_inside(const fxl_face *face)
{
    static fxl_inside_corners found, expected;
    int32_t least[2] = {INT32_MAX, INT32_MAX}, most[2] = {INT32_MIN, INT32_MIN};
    if (face->count != 3) {
        return;
    }
    memset(&found, 0x5A, sizeof found);
    memset(&expected, 0x5A, sizeof expected);
    const fxl_clip_result core = fxl_find_inside_corners(&by_core.placed, face, &found);
    const fxl_clip_result portable =
        portable_clip_by_view(&by_portable.placed, face, &by_portable.work, &by_portable.screen);
    if (core == FXL_CLIP_CUT) {
        equality_case(portable != FXL_CLIP_INSIDE && portable != FXL_CLIP_BETWEEN);
        (void)fxl_clip_by_view(&by_core.placed, face, &by_core.work, &by_core.screen);
        return;
    }
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_screen_point *point = &by_portable.screen.points[i];
        const int32_t at[2] = {point->x, point->y};
        fxl_cached_vertex vertex;
        portable_transform_vertex(&by_portable.placed, face->indices[i], &vertex);
        expected.corners.points[i] = *point;
        expected.corners.depths[i] = vertex.position.z;
        for (uint32_t k = 0; k < 2; k++) {
            least[k] = at[k] < least[k] ? at[k] : least[k];
            most[k] = at[k] > most[k] ? at[k] : most[k];
        }
    }
    if (core == FXL_CLIP_INSIDE) {
        expected.corners.width = most[0] - least[0];
        expected.corners.height = most[1] - least[1];
        expected.least.x = least[0];
        expected.least.y = least[1];
    }
    equality_case(core == portable && memcmp(&found, &expected, sizeof found) == 0 &&
                  memcmp(by_core.entries, by_portable.entries, sizeof by_core.entries) == 0);
}

/* A triangle that is drawn from its vertices, below the band: so only its points, its plane and the entries
 * are found. */
static void compare_drawn(const fxl_face *face)
{
    static fxl_depth_head head[2];
    static fxl_screen_polygon screen;
    static const fxl_band below = {.width = 2000, .first_row = 3000, .rows = 1};
    fxl_depth_outline outline;
    fxl_depth_plane plane;
    fxl_face drawn = *face;
    if (face->count != 3) {
        return;
    }
    drawn.normal = any_normal();
    head[0].scale = (fxl_depth_scale){(uint8_t)(1u + (any_32() >> 9) % 24u), 11};
    outline.cells = (uint16_t *)(void *)&head[1];
    const fxl_depth_face core =
        fxl_draw_depth_face_16(&by_core.placed, &drawn, &outline, &below, &screen);
    const fxl_clip_result portable =
        portable_clip_by_view(&by_portable.placed, &drawn, &by_portable.work, &by_portable.screen);
    const bool is_inside = portable == FXL_CLIP_INSIDE;
    bool has_plane = false;
    if (is_inside) {
        const uint32_t number = face->indices[0];
        const fxl_cached_vertex *entry = &by_portable.entries[number & by_portable.placed.mask];
        if (entry->tag == by_portable.placed.tag + number) {
            portable_find_depth_plane(&drawn.normal, by_portable.placed.axes, &entry->position,
                                      by_portable.placed.view, &plane);
            has_plane = plane.one >= 32 + head[0].scale.octaves;
        }
    }
    if (core == FXL_DEPTH_FACE_IS_OTHER) {
        equality_case(portable != FXL_CLIP_BETWEEN && !has_plane);
        (void)fxl_clip_by_view(&by_core.placed, &drawn, &by_core.work, &by_core.screen);
    } else {
        equality_case(
            core == FXL_DEPTH_FACE_IS_BETWEEN
                ? portable == FXL_CLIP_BETWEEN
                : core == FXL_DEPTH_FACE_HAS_NO_ROW && has_plane &&
                      memcmp(&plane.gradient, &outline.plane.gradient, sizeof plane.gradient) == 0);
        equality_case(
            memcmp(screen.points, by_portable.screen.points, 3 * sizeof screen.points[0]) == 0);
    }
    equality_case(memcmp(by_core.entries, by_portable.entries, sizeof by_core.entries) == 0);
}

#else

static void compare_inside(const fxl_face *face)
{
    (void)face;
}

static void compare_drawn(const fxl_face *face)
{
    (void)face;
}

#endif

#if !FXL_IS_COMPACT

/* A walk over copies of a face that look anywhere, along either direction. */
static void compare_walk(const fxl_face *face)
{
    fxl_face faces[4];
    const uint32_t count = 1u + (any_32() >> 9 & 3u);
    const bool is_reverse = (any_32() & 64u) != 0;
    for (uint32_t i = 0; i < count; i++) {
        faces[i] = *face;
        faces[i].normal = any_normal();
    }
    fxl_face_walk core = {.face = &faces[is_reverse ? count - 1u : 0],
                          .step = is_reverse ? -1 : 1,
                          .left = count,
                          .drops = (any_32() & 128u) != 0};
    fxl_face_walk portable = core;
    const fxl_face *found;
    bool same = true;
    do {
        found = fxl_next_front_face(&by_core.placed, &core);
        same = same && found == portable_next_front_face(&by_portable.placed, &portable) &&
               core.left == portable.left && core.outside == portable.outside;
    } while (found != NULL && same);
    equality_case(same &&
                  memcmp(by_core.entries, by_portable.entries, sizeof by_core.entries) == 0);
}

#else

static void compare_walk(const fxl_face *face)
{
    (void)face;
}

#endif

void test_clip_by_view(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds / 32u + 8u; i++) {
        any_view();
        for (uint32_t j = 0; j < 16; j++) {
            const uint32_t mask = ENTRIES / (1u + (any_32() >> 9 & 3u)) >> 1,
                           tag = any_32() << 16 | 1u << 31;
            any_vertices();
            const fxl_planes planes = (fxl_planes)(crossed() | (any_32() >> 5 & FXL_PLANES_ALL));
            place(&by_core, mask, tag, planes);
            place(&by_portable, mask, tag, planes);
            for (uint32_t k = 0; k < 2; k++) {
                const uint32_t first = any_32() >> 9 & 3u;
                fxl_face face = {.count = (uint8_t)(3u + (any_32() >> 9) % 6u),
                                 .material = (uint8_t)any_32()};
                for (uint32_t c = 0; c < FXL_FACE_VERTICES_MAX; c++) {
                    corners[c] = (uint16_t)(any_32() >> 11 & (VERTICES - 1u));
                }
                fxl_face_take_indices(&face, corners, first);
                if ((any_32() & 512u) != 0) {
                    compare_inside(&face);
                }
                if ((any_32() & 512u) != 0) {
                    compare_drawn(&face);
                }
                compare(&face);
                compare_walk(&face);
            }
        }
    }
}
