/* SPDX-License-Identifier: MIT */
#include "parts.h"

#include <string.h>

#include "answers.h"
#include "study/clip_world.h"

enum {
    TEXEL_MAX = 16383 * 65536,
    ROUNDS = 16,
    BAND_PIXELS = 24 * 12
};

/* Up to 61 bits, every length as likely, either sign. */
static fxl_q18_46 any_sum(fuzz_input *in)
{
    uint32_t kind = fuzz_below(in, 128);
    uint64_t magnitude = fuzz_bits(in, 8) >> (3 + kind % 61);
    return kind < 64 ? (int64_t)magnitude : -(int64_t)magnitude;
}

static fxl_view_point any_view_point(fuzz_input *in)
{
    fxl_view_point point;
    point.x = any_sum(in);
    point.y = any_sum(in);
    point.z = any_sum(in);
    return point;
}

void fuzz_project(fuzz_input *in)
{
    fxl_lens lens = fuzz_lens(in, FXL_SCREEN_MAX * FXL_SCREEN_MAX);
    for (int i = 0; i < ROUNDS && in->left > 0; i++) {
        fxl_view_point point = any_view_point(in);
        fxl_screen_point before = {12345, -54321};
        fxl_screen_point screen = before;
        fxl_status status = fxl_project_point(&lens, &point, &screen);
        judge_projection(&lens, &point, status, &screen);
        DEMAND(status == FXL_OK || memcmp(&before, &screen, sizeof screen) == 0);
        record_bytes(&screen, sizeof screen);
    }
}

/* A screen coordinate: about the band, at quarter pixels so that centres are
 * met, or anywhere. */
static fxl_q16_16 any_screen_coordinate(fuzz_input *in)
{
    uint32_t kind = fuzz_below(in, 8);
    if (kind < 4) {
        return (int8_t)fuzz_bits(in, 1) * 16384;
    }
    if (kind == 7) {
        return fuzz_any(in);
    }
    return fuzz_coordinate(in, FXL_SCREEN_COORDINATE_MAX);
}

static bool screen_polygon_in_range(const fxl_screen_polygon *polygon)
{
    for (uint32_t i = 0; i < polygon->count; i++) {
        const fxl_screen_point *point = &polygon->points[i];
        if (point->x < -FXL_SCREEN_COORDINATE_MAX || point->x > FXL_SCREEN_COORDINATE_MAX ||
            point->y < -FXL_SCREEN_COORDINATE_MAX || point->y > FXL_SCREEN_COORDINATE_MAX) {
            return false;
        }
    }
    return true;
}

/* Draws the spans with 1 into a band of 0, and demands their order. */
static void draw_spans(fxl_scan *scan, const fxl_band *band)
{
    fxl_span span, before = {-1, 0, 0};
    while (fxl_scan_next(scan, &span)) {
        DEMAND(span.y > before.y || (span.y == before.y && span.x0 > before.x1));
        DEMAND(span.y >= band->first_row && span.x0 >= 0 && span.x0 < span.x1);
        fxl_fill_span(band, &span, 1);
        before = span;
    }
    before = span;
    DEMAND(!fxl_scan_next(scan, &span) && memcmp(&before, &span, sizeof span) == 0);
}

/* The same pixels by way of a list that just holds the polygon. */
static void draw_listed(const fxl_screen_polygon *polygon, const fxl_band *drawn)
{
    uint8_t pixels[BAND_PIXELS] = {0};
    fxl_band band = *drawn;
    fxl_rows rows = fxl_scan_rows(polygon, FXL_SCREEN_MAX);
    fxl_rows wanted = {band.first_row, (uint16_t)(band.first_row + band.rows)};
    fxl_display_list list = {NULL, FXL_DISPLAY_LIST_WORDS((uint32_t)polygon->count), 0};
    fxl_scan scan;
    uint32_t place = 0;
    list.words = malloc(list.capacity * sizeof *list.words);
    band.pixels = pixels;
    DEMAND(list.words != NULL && rows.first <= rows.end && rows.end <= FXL_SCREEN_MAX);
    if (rows.first < rows.end) {
        DEMAND(fxl_display_list_append(&list, polygon, rows));
        DEMAND(!fxl_display_list_append(&list, polygon, rows));
    }
    const fxl_screen_polygon *record = fxl_display_list_next(&list, wanted, &place);
    if (record != NULL) {
        fxl_scan_outline(record->points, record->count, &band, &scan);
        draw_spans(&scan, &band);
    }
    for (uint32_t row = 0; row < band.rows; row++) {
        DEMAND(memcmp(pixels + row * band.stride, drawn->pixels + row * band.stride, band.width) ==
               0);
    }
    free(list.words);
}

void fuzz_scan(fuzz_input *in)
{
    uint8_t pixels[BAND_PIXELS] = {0};
    fxl_scan scan;
    fxl_screen_polygon polygon;
    fxl_band band = {.palette = NULL};
    polygon.colour = 1;
    band.width = (uint16_t)(1 + fuzz_below(in, 24));
    band.stride = 24;
    band.rows = (uint16_t)(1 + fuzz_below(in, 12));
    band.first_row = (uint16_t)(fuzz_below(in, 2) ? fuzz_below(in, FXL_SCREEN_MAX - 11) : 0);
    band.pixels = pixels;
    polygon.count = (uint8_t)fuzz_below(in, FXL_POLYGON_CAPACITY + 2);
    bool legal_count = polygon.count >= 3 && polygon.count <= FXL_POLYGON_CAPACITY;
    for (uint32_t i = 0; i < polygon.count && i < FXL_POLYGON_CAPACITY; i++) {
        polygon.points[i].x = any_screen_coordinate(in);
        polygon.points[i].y = any_screen_coordinate(in);
        if (polygon.points[i].y < FXL_SCREEN_COORDINATE_MAX) {
            polygon.points[i].y += band.first_row * 65536;
        }
    }
    fxl_status status = fxl_scan_begin(&polygon, &band, &scan);
    DEMAND((status == FXL_OK) == (legal_count && screen_polygon_in_range(&polygon)));
    draw_spans(&scan, &band);
    record_band(&band);
    if (status == FXL_OK) {
        judge_coverage(&polygon, &band);
        draw_listed(&polygon, &band);
    }
}

void fuzz_clip_world(fuzz_input *in)
{
    fxl_clip_world_work work;
    fxl_polygon polygon;
    const fxl_polygon *result;
    fxl_view view;
    fxl_pose pose = fuzz_pose(in);
    fxl_lens lens = fuzz_lens(in, FXL_SCREEN_MAX * FXL_SCREEN_MAX);
    fxl_view_set_lens(&view, &lens);
    DEMAND(fxl_view_set_pose(&view, &pose) == FXL_OK);
    fxl_view_set_world_frustum(&view);
    const fxl_frustum *frustum = &view.frustum;
    polygon.colour = 7;
    polygon.textured = true;
    polygon.count = (uint8_t)(3 + fuzz_below(in, FXL_POLYGON_CAPACITY - 2));
    for (uint32_t i = 0; i < polygon.count; i++) {
        fxl_vertex *vertex = &polygon.vertices[i];
        vertex->position = fuzz_point(in, FXL_COORDINATE_MAX);
        vertex->u = fuzz_coordinate(in, TEXEL_MAX);
        vertex->v = fuzz_coordinate(in, TEXEL_MAX);
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            const fxl_plane *side = &frustum->planes[plane];
            judge_plane_distance(side, &vertex->position,
                                 fxl_plane_distance(side, &vertex->position));
        }
    }
    fxl_clip_result cut =
        fxl_clip_world_to_planes(&polygon, frustum, FXL_PLANES_ALL, &work, &result);
    DEMAND((result != NULL) == (cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT));
    DEMAND((result == &polygon) == (cut == FXL_CLIP_INSIDE));
    for (uint32_t i = 0; result != NULL && i < result->count; i++) {
        fxl_view_point point;
        fxl_transform_point(&view.camera, &result->vertices[i].position, &point);
        judge_transform(&view.camera, &result->vertices[i].position, &point);
        record_bytes(&point, sizeof point);
        record_number(result->vertices[i].u);
        record_number(result->vertices[i].v);
    }
}

void fuzz_clip_view(fuzz_input *in)
{
    fxl_clip_view_work work;
    fxl_view_polygon polygon;
    const fxl_view_polygon *result;
    fxl_view view;
    fxl_planes needed = 0;
    fxl_lens lens = fuzz_lens(in, FXL_SCREEN_MAX * FXL_SCREEN_MAX);
    fxl_view_set_lens(&view, &lens);
    polygon.colour = 7;
    polygon.count = (uint8_t)(3 + fuzz_below(in, FXL_POLYGON_CAPACITY - 2));
    for (uint32_t i = 0; i < polygon.count; i++) {
        const fxl_view_point point = any_view_point(in);
        needed |= judge_outcode(&view.view_frustum, &point, fuzz_below(in, FXL_PLANES_ALL + 1u));
        polygon.vertices[i].position = point;
    }
    fxl_clip_result cut = fxl_clip_view_by_planes(&polygon, &view.view_frustum, FXL_PLANES_ALL,
                                                  &work, NULL, &result);
    DEMAND((result == &polygon) == (cut == FXL_CLIP_INSIDE));
    judge_view_clip(cut, result, &view);
    record_number(cut);
    record_bytes(result != NULL ? result->vertices : NULL,
                 result != NULL ? result->count * sizeof result->vertices[0] : 0);
    fxl_clip_view_work again;
    for (int which = 0; which < 2; which++) { /* the input within the work */
        const fxl_view_polygon *same;
        again.polygons[which] = polygon;
        DEMAND(fxl_clip_view_by_planes(&again.polygons[which], &view.view_frustum, FXL_PLANES_ALL,
                                       &again, NULL, &same) == cut);
        DEMAND((same == NULL) == (result == NULL));
        DEMAND(same == NULL || (same->count == result->count &&
                                memcmp(same->vertices, result->vertices,
                                       same->count * sizeof same->vertices[0]) == 0));
    }
    /* By the planes that a vertex is outside of, and no others. */
    cut = fxl_clip_view_by_planes(&polygon, &view.view_frustum, needed, &again, NULL, &result);
    DEMAND((cut == FXL_CLIP_INSIDE) == (needed == 0));
    judge_view_clip(cut, result, &view);
}

/* A viewer and a gait in range; most choices leave them so, the
 * others spoil one number. Answers whether one was. */
static bool any_viewer(fuzz_input *in, fxl_player *viewer, fxl_motion_limits *motion_limits)
{
    viewer->pose = fuzz_pose(in);
    viewer->speed = fuzz_coordinate(in, FXL_MOTION_MAX);
    viewer->clamped = 0;
    motion_limits->acceleration = fuzz_between(in, 0, FXL_MOTION_MAX);
    motion_limits->friction = fuzz_between(in, 0, FXL_MOTION_MAX);
    motion_limits->speed_max = fuzz_between(in, 0, FXL_MOTION_MAX);
    motion_limits->turn = fuzz_below(in, FXL_ANGLE_QUARTER + 1);
    int32_t *const numbers[] = {&viewer->pose.position.x,     &viewer->pose.position.y,
                                &viewer->pose.position.z,     &viewer->speed,
                                &motion_limits->acceleration, &motion_limits->friction,
                                &motion_limits->speed_max};
    uint32_t which = fuzz_below(in, 32);
    if (which < sizeof numbers / sizeof numbers[0]) {
        *numbers[which] = fuzz_any(in);
    } else if (which == 7) {
        motion_limits->turn = (fxl_angle)fuzz_any(in);
    }
    return which < 8;
}

static void demand_walked(const fxl_player *viewer, const fxl_player *before,
                          const fxl_motion_limits *motion_limits, const bool *held, bool flies)
{
    const fxl_point *place = &viewer->pose.position;
    DEMAND(place->x >= -FXL_COORDINATE_MAX && place->x <= FXL_COORDINATE_MAX);
    DEMAND(place->z >= -FXL_COORDINATE_MAX && place->z <= FXL_COORDINATE_MAX);
    DEMAND(flies || place->y == before->pose.position.y);
    DEMAND(place->y >= -FXL_COORDINATE_MAX && place->y <= FXL_COORDINATE_MAX);
    DEMAND(viewer->speed >= -motion_limits->speed_max && viewer->speed <= motion_limits->speed_max);
    DEMAND(viewer->clamped - before->clamped <= 1);
    DEMAND(held == NULL || *held == (viewer->clamped != before->clamped));
}

void fuzz_viewer(fuzz_input *in)
{
    fxl_player viewer;
    fxl_motion_limits motion_limits;
    bool spoilt = any_viewer(in, &viewer, &motion_limits);
    for (uint32_t i = 0; i < 4 * ROUNDS && (i == 0 || in->left > 0); i++) {
        bool held = false;
        bool *report = fuzz_below(in, 2) == 1 ? &held : NULL;
        uint32_t keys = (uint32_t)fuzz_bits(in, fuzz_below(in, 16) == 0 ? 2 : 1);
        fxl_player before = viewer;
        const bool flies = fuzz_below(in, 4) == 0;
        fxl_status status =
            (flies ? fxl_player_fly : fxl_player_step)(&viewer, keys, &motion_limits, report);
        if (status != FXL_OK) {
            DEMAND(status == FXL_E_RANGE && (spoilt || keys > FXL_KEY_ALL));
            DEMAND(memcmp(&before, &viewer, sizeof viewer) == 0);
            return;
        }
        demand_walked(&viewer, &before, &motion_limits, report, flies);
        record_bytes(&viewer, sizeof viewer);
    }
}

/* sin^2 + cos^2 is 1 to within what the roundings of both allow. */
static void judge_sine(fxl_angle angle)
{
    int64_t sine = fxl_sin(angle), cosine = fxl_cos(angle);
    record_number(sine);
    record_number(cosine);
    int64_t difference = sine * sine + cosine * cosine - ((int64_t)1 << 60);
    DEMAND(difference <= ((int64_t)1 << 31) && difference >= -((int64_t)1 << 31));
    DEMAND(fxl_sin(0u - angle) == -sine && fxl_cos(0u - angle) == cosine);
}

static void record_lens(fxl_status status, const fxl_lens *lens)
{
    record_number(status);
    record_number(lens->width);
    record_number(lens->height);
    record_number(lens->focal);
    record_number(lens->near_z);
    record_number(lens->far_z);
    record_number(lens->inset);
    record_number(lens->centre_x);
    record_number(lens->centre_y);
    record_number(status == FXL_OK && lens->off_centre != NULL);
}

/* Any centre, part and window: a valid lens, or a status and the lens as it was. */
static void judge_moved_lenses(const fxl_lens *lens, fuzz_input *in)
{
    fxl_lens moved, before;
    memset(&moved, 0x5A, sizeof moved);
    before = moved;
    const uint16_t width = (uint16_t)fuzz_between(in, 0, FXL_SCREEN_MAX + 1);
    const int32_t a = fuzz_any(in), b = fuzz_any(in);
    int32_t sides[6];
    for (uint32_t i = 0; i < 6; i++) {
        sides[i] = fuzz_coordinate(in, FXL_COORDINATE_MAX + 1);
    }
    fxl_status status = fxl_lens_from_window(width, sides[0], sides[1], sides[2], sides[3],
                                             sides[4], sides[5], &moved);
    DEMAND(status == FXL_OK || status == FXL_E_RANGE);
    DEMAND(status == FXL_OK ? fxl_lens_is_valid(&moved)
                            : memcmp(&before, &moved, sizeof moved) == 0);
    record_lens(status, &moved);
    if (lens == NULL) {
        return;
    }
    before = moved;
    status = fxl_lens_of_part(lens, (int16_t)a, (int16_t)b, width, (uint16_t)(b >> 16), &moved);
    DEMAND(status == FXL_OK ? fxl_lens_is_valid(&moved)
                            : memcmp(&before, &moved, sizeof moved) == 0);
    record_lens(status, &moved);
    before = moved = *lens;
    status = fxl_lens_set_centre(&moved, a, b);
    DEMAND(status == FXL_OK ? fxl_lens_is_valid(&moved)
                            : memcmp(&before, &moved, sizeof moved) == 0);
    record_lens(status, &moved);
}

void fuzz_lenses(fuzz_input *in)
{
    fxl_lens before, lens = fuzz_lens(in, FXL_SCREEN_MAX * FXL_SCREEN_MAX);
    uint16_t size[2] = {lens.width, lens.height};
    int32_t fov = FXL_ANGLE_QUARTER, depths[3] = {lens.near_z, lens.far_z, lens.inset};
    uint32_t which = fuzz_below(in, 8);
    if (which < 2) {
        size[which] = (uint16_t)fuzz_any(in);
    } else if (which < 5) {
        depths[which - 2] = fuzz_any(in);
    } else {
        fov = fuzz_any(in);
    }
    bool legal = size[0] >= 1 && size[0] <= FXL_SCREEN_MAX && size[1] >= 1 &&
                 size[1] <= FXL_SCREEN_MAX && (fxl_angle)fov >= FXL_FOV_MIN &&
                 (fxl_angle)fov <= FXL_FOV_MAX && depths[0] >= FXL_NEAR_MIN &&
                 depths[1] <= FXL_FAR_MAX && depths[2] >= 0 && depths[2] <= FXL_INSET_MAX &&
                 depths[0] + 2 * (int64_t)depths[2] < depths[1];
    memset(&lens, 0x5A, sizeof lens);
    before = lens;
    fxl_status status =
        fxl_lens_from_fov(size[0], size[1], (fxl_angle)fov, depths[0], depths[1], depths[2], &lens);
    DEMAND(status == (legal ? FXL_OK : FXL_E_RANGE));
    DEMAND(legal || memcmp(&before, &lens, sizeof lens) == 0);
    record_lens(status, &lens);
    DEMAND(fxl_status_text((fxl_status)fuzz_any(in)) != NULL);
    judge_sine((fxl_angle)fov);
    judge_moved_lenses(legal ? &lens : NULL, in);
}
