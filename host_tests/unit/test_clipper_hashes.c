/* SPDX-License-Identifier: MIT */
/* What the clippers leave is the same, bit for bit, on every core: hashes on record, as in
 * test_surface_hashes.c. */
#include "clip_unit.h"
#include "polygon_face.h"
#include "clippers_list.h"
#include "study/half_space.h"

enum {
    FACES = 600, /* by each clipper */
    SHAPES = 1000,
    WIDTH = 48,
    HEIGHT = 32
};

static uint32_t hash;
static FXL_ALIGN_8 fxl_clipper_workspace room;
static fxl_clip_workspace workspace;
static fxl_clip_once_workspace once;
static fxl_triangle_workspace triangles;

void setUp(void)
{
    hash = 0;
}

static void mix(int64_t value)
{
    hash = unit_mix(hash, value);
}

static void mix_screen(const fxl_screen_polygon *screen)
{
    mix(screen->count);
    for (uint32_t i = 0; i < screen->count; i++) {
        mix(screen->points[i].x);
        mix(screen->points[i].y);
    }
}

static void mix_stats(const fxl_clip_stats *stats)
{
    mix(stats->distances);
    mix(stats->intersections);
}

/* What the renderer would ask for: all polygons of a face. */
static void mix_face(const fxl_clipper *clipper, const fxl_model_view *model_view,
                     const fxl_face *face)
{
    fxl_clipper_work work;
    fxl_screen_polygon screen;
    fxl_clip_result result = clipper->clip(model_view, face, &work, &screen);
    mix(result);
    while (result == FXL_CLIP_INSIDE || result == FXL_CLIP_CUT || result == FXL_CLIP_BETWEEN) {
        mix_screen(&screen);
        result =
            clipper->next != NULL ? clipper->next(model_view, &work, &screen) : FXL_CLIP_OUTSIDE;
        mix(result);
    }
}

static uint32_t hash_of_faces(const fxl_clipper *clipper)
{
    static polygon_face face;
    hash = 0;
    memset(&room, 0, sizeof room);
    for (uint32_t i = 0; i < FACES; i++) {
        fxl_view view = clip_random_view(WIDTH, HEIGHT);
        const fxl_polygon polygon = clip_random_face(&view);
        view.frame = i + 1;
        if (clipper->begin != NULL) {
            clipper->begin(&view);
        }
        polygon_face_set(&face, &polygon, &view, 1 + i % 8);
        face.model_view.clipper_workspace = &room;
        mix_face(clipper, &face.model_view, &face.face);
    }
    mix_stats(&room.stats);
    return hash;
}

/* place clipper: a hash of each clipper */
void test_the_outlines_of_faces_are_those_on_record(void)
{
    static const struct {
        const fxl_clipper *clipper;
        uint32_t hash;
    } record[] = {
        {&fxl_clipper_view, 0x3459DD88},        {&fxl_clipper_world, 0x29D86BE1},
        {&fxl_clipper_normalised, 0x2AE655A5},  {&fxl_clipper_once, 0xDFE8407A},
        {&fxl_clipper_half_spaces, 0x65C38E14}, {&fxl_clipper_triangles, 0x9BC84F61},
        {&fxl_clipper_near, 0x2C8CC885},        {&fxl_clipper_left, 0x54CC4D13},
    };
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < sizeof record / sizeof record[0]; i++) {
        wrong += unit_tell_hash(i, hash_of_faces(record[i].clipper), record[i].hash);
    }
    TEST_ASSERT_EQUAL_UINT32(0, wrong);
}

static void mix_vertex(const fxl_varying_vertex *vertex, uint32_t carried)
{
    mix(vertex->position.x);
    mix(vertex->position.y);
    mix(vertex->position.z);
    for (uint32_t i = 0; i < carried; i++) {
        mix(vertex->carried[i]);
    }
}

static void mix_clipped(fxl_clip_result result, const fxl_varying_polygon *polygon)
{
    mix(result);
    if (result == FXL_CLIP_INSIDE || result == FXL_CLIP_CUT) {
        mix(polygon->count);
        for (uint32_t i = 0; i < polygon->count; i++) {
            mix_vertex(&polygon->vertices[i], polygon->carried);
        }
    }
}

/* A triangle or a quadrilateral, whose other numbers are far from all limits or near them. */
static fxl_varying_polygon any_shape(uint32_t number)
{
    fxl_varying_polygon shape = clip_random_shape(44 + number % 18);
    const uint8_t step = shape.count / 4;
    shape.count = (uint8_t)(3 + number % 2);
    shape.carried = (uint8_t)(number % (FXL_CARRIED_MAX + 1));
    for (uint8_t i = 0; i < shape.count; i++) {
        shape.vertices[i] = shape.vertices[i * step];
    }
    return shape;
}

static fxl_normalised any_frustum(void)
{
    const int32_t width = unit_between(1, FXL_SCREEN_MAX);
    const fxl_view view =
        clip_random_view((uint16_t)width, (uint16_t)unit_between(1, FXL_SCREEN_MAX));
    fxl_normalised frustum;
    fxl_normalised_from_camera(&view.camera, &view.lens, &frustum);
    return frustum;
}

static fxl_volume any_volume(void)
{
    fxl_volume volume;
    const fxl_q16_16 left = unit_between(Q16(-3), Q16(2)), low = unit_between(Q16(-3), Q16(2));
    const fxl_q16_16 wide = unit_between(1, Q16(2)), high = unit_between(1, Q16(2));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_volume_from_window(left, left + wide, low, low + high, Q16(1),
                                                     Q16(100), &volume));
    return volume;
}

static void mix_normalised(const fxl_varying_polygon *shape)
{
    const fxl_normalised frustum = any_frustum();
    const fxl_varying_polygon *clipped = NULL;
    fxl_clip_result result = fxl_clip_normalised(shape, &frustum, &workspace, &clipped);
    mix_clipped(result, clipped);
}

static void mix_once(const fxl_varying_polygon *shape)
{
    const fxl_normalised frustum = any_frustum();
    const fxl_varying_polygon *clipped = NULL;
    fxl_clip_result result = fxl_clip_once(shape, &frustum, &once, &clipped);
    mix_clipped(result, clipped);
}

static void mix_volume(const fxl_varying_polygon *shape)
{
    workspace.stats.sliver = unit_between(0, 1) ? (fxl_q18_46)1 << unit_between(20, 46) : 0;
    const fxl_volume volume = any_volume();
    const fxl_varying_polygon *clipped = NULL;
    fxl_clip_result result = fxl_clip_to_volume(shape, &volume, &workspace, &clipped);
    mix_clipped(result, clipped);
}

/* By all planes, or by two of them and then by the borders of the screen. */
static void mix_triangle(const fxl_varying_polygon *shape)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_clip_triangle triangle = {
        {shape->vertices[0], shape->vertices[1], shape->vertices[2]}};
    const fxl_screen_triangle *piece;
    fxl_volume volume;
    fxl_status status = FXL_OK;
    clip_volume(&lens,
                unit_between(0, 1) ? FXL_PLANES_ALL : 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR,
                &volume);
    triangles.screen_sliver = unit_between(0, 1) ? 4 : 0;
    mix(fxl_triangle_begin(&triangle, shape->carried, &volume, &triangles));
    while ((piece = fxl_triangle_next(&volume, &lens, &triangles, &status)) != NULL) {
        for (uint32_t i = 0; i < 3; i++) {
            const fxl_screen_corner *corner = &piece->corners[i];
            mix(corner->at.x);
            mix(corner->at.y);
            mix(corner->depth);
            for (uint32_t k = 0; k < shape->carried; k++) {
                mix(corner->carried[k]);
            }
        }
    }
    mix(status);
}

void test_shapes_and_what_they_carry_are_those_on_record(void)
{
    static const struct {
        void (*mix)(const fxl_varying_polygon *);
        const fxl_clip_stats *stats;
        uint32_t hash;
    } record[] = {
        {mix_normalised, &workspace.stats, 0xA00EDF69},
        {mix_once, &once.stats, 0x4B79705A},
        {mix_volume, &workspace.stats, 0x88272639},
        {mix_triangle, &triangles.stats, 0x7F63AF68},
    };
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < sizeof record / sizeof record[0]; i++) {
        hash = 0;
        for (uint32_t k = 0; k < SHAPES; k++) {
            const fxl_varying_polygon shape = any_shape(k);
            record[i].mix(&shape);
        }
        mix_stats(record[i].stats);
        wrong += unit_tell_hash(i, hash, record[i].hash);
    }
    TEST_ASSERT_EQUAL_UINT32(0, wrong);
}
