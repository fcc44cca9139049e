/* SPDX-License-Identifier: MIT */
/* The kernels of outlines in a depth buffer, of one colour, in C too, with light and with colours at
 * corners, with texels, and of runs in it, against the rows of lib/paint/depth_row.h, painted by fxl_paint_pixels
 * where there is light or colours. Each side has cells and pixels of its own. All of that memory must
 * be equal, also what lies around it.
 */

#include <string.h>

#include "clip/clip_by_view.h"
#include "equality.h"
#include "paint/depth_rows.h"
#include "paint/smooth_outline.h"
#include "raster/draw_outline.h"
#include "raster/edge.h"
#include "sides.h"

#if FXL_DRAWS_DEPTH_OUTLINES

#include "outline_inputs.h"

typedef struct {
    const polygon *of;
    uint8_t *pixels; /* of column 0 */
    int32_t y;
} row_of_pixels;

/* fxl_run_painter. */
static void paint_run(const void *with, int32_t x0, int32_t x1, void *cells, fxl_depth_line line)
{
    const row_of_pixels *row = (const row_of_pixels *)with;
    (void)cells;
    (void)line;
    if (row->of->is_smooth || row->of->has_colours) {
        const fxl_paint_row painted = {.pixels = row->pixels, .y = row->y};
        (row->of->has_colours        ? fxl_paint_colours_565
         : row->of->pixel_bits == 16 ? fxl_paint_pixels_565
                                     : fxl_paint_pixels)(&row->of->paint, &painted, x0, x1);
        return;
    }
    for (int32_t x = x0; x < x1; x++) {
        if (row->of->pixel_bits == 16) {
            ((uint16_t *)(void *)row->pixels)[x] = COLOUR;
        } else {
            row->pixels[x] = (uint8_t)COLOUR;
        }
    }
}

/* Far to near no depth is kept, as of what is blended. */
static void begin(fxl_depth_painting *painting, const void *head, const fxl_depth_plane *plane,
                  const fxl_band *band)
{
    fxl_depth_begin(painting, head, plane, band);
    painting->keeps = painting->head->or_equal ? FXL_DEPTH_KEEPS_NONE : FXL_DEPTH_KEEPS_ALL;
}

static void draw_by_rows(const polygon *of, const fxl_band *band)
{
    static fxl_scan scan;
    fxl_depth_painting painting;
    const fxl_trapezoid *trapezoid;
    if (of->has_texels) {
        (void)portable_draw_texels(&of->paint, &of->plane, &by_portable, of->points, of->count,
                                   band, &scan);
        return;
    }
    begin(&painting, &by_portable, &of->plane, band);
    portable_scan_outline(of->points, of->count, band, &scan);
    while ((trapezoid = portable_scan_next_trapezoid(&scan)) != NULL) {
        fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
        for (int32_t y = trapezoid->first_row; y < trapezoid->end_row; y++) {
            const int32_t x0 = a.x < b.x ? a.x : b.x, x1 = a.x < b.x ? b.x : a.x;
            const row_of_pixels row = {of,
                                       band->pixels + (uint32_t)(y - band->first_row) *
                                                          band->stride * of->pixel_bits / 8,
                                       y};
            fxl_depth_paint_row(&painting, y, x0, x1, 16, paint_run, &row);
            fxl_edge_advance(&a, 1);
            fxl_edge_advance(&b, 1);
        }
    }
}

#if FXL_DRAWS_SMOOTH_OUTLINES

/* Whether all rows of an outline that the band has are cleared. */
static bool is_clear(const polygon *of, const fxl_band *band)
{
    const fxl_depth_head *head = &by_core.head;
    const int32_t end = band->first_row + band->rows;
    const fxl_rows rows = fxl_rows_of_points(of->points, of->count, (uint16_t)end);
    const int32_t first = rows.first > band->first_row ? rows.first : band->first_row;
    return first >= rows.end || (first >= head->clear_from && rows.end <= head->clear_to);
}

/* Some rows of every fourth outline are not cleared. */
static void clear_some(const fxl_band *band)
{
    const bool clears = (any_32() & 0x600u) != 0;
    const int32_t from = (int32_t)((any_32() >> 9) % band->rows) + band->first_row;
    by_core.head.clear_from = (int16_t)(clears ? FXL_DEPTH_ALL_CLEAR : from);
    by_core.head.clear_to =
        (int16_t)(clears ? INT16_MAX : from + (int32_t)((any_32() >> 9) % band->rows));
}

/* What a kernel says that draws nothing where rows are not cleared. Returns whether it drew. */
static bool has_drawn(const polygon *of, const fxl_band *band, fxl_depth_drawn drawn)
{
    if (drawn == FXL_DEPTH_NOT_CLEAR || drawn == FXL_DEPTH_NOT_DRAWN) {
        equality_case(drawn == FXL_DEPTH_NOT_DRAWN || !is_clear(of, band));
        return false;
    }
    equality_case(drawn == FXL_DEPTH_NO_ROW || is_clear(of, band));
    return true;
}

/* The corners of a triangle, of three of four whose points are in the columns of the band. */
static bool find_corners(const polygon *of, const fxl_band *band, fxl_inside_corners *inside)
{
    fxl_screen_corners *corners = &inside->corners;
    fxl_screen_point least = of->points[0], most = least;
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_screen_point at = corners->points[i] = of->points[i];
        least.x = at.x < least.x ? at.x : least.x;
        least.y = at.y < least.y ? at.y : least.y;
        most.x = at.x > most.x ? at.x : most.x;
        most.y = at.y > most.y ? at.y : most.y;
    }
    corners->width = most.x - least.x;
    corners->height = most.y - least.y;
    inside->least = least;
    return least.x >= 0 && most.x <= band->width << 16 && (any_32() & 0x600u) != 0;
}

/* Whether light at all centres of a box of at most 6 rows and 8 columns is of the ramp. */
static bool has_small_light(const fxl_inside_corners *inside, const fxl_smooth_outline *smooth)
{
    const fxl_smooth_words *words = &smooth->words;
    /* place fill-rule: the first centre that a box has */
    const int32_t x = (inside->least.x + 0x7FFF) >> 16, y = (inside->least.y + 0x7FFF) >> 16;
    for (uint32_t i = 0; i < 6 * 8; i++) {
        const uint32_t column = (uint32_t)x + i % 8, row = (uint32_t)y + i / 8;
        if (words->light + words->light_along * column + words->light_down * row >= smooth->limit) {
            return false;
        }
    }
    return true;
}

static bool draw_smooth(const polygon *of, const fxl_band *band)
{
    fxl_smooth_outline smooth;
    clear_some(band);
    if (!fxl_smooth_outline_begin(&by_core, &of->plane, &of->paint, band, of->pixel_bits / 8,
                                  &smooth)) {
        return false;
    }
    fxl_inside_corners corners;
    if (of->pixel_bits == 16 && of->count == 3 && find_corners(of, band, &corners)) {
        smooth.small_rows =
            has_small_light(&corners, &smooth) ? fxl_smooth_small_rows(FXL_DEPTH_IS_LINEAR) : 0;
        return has_drawn(of, band, fxl_draw_smooth_triangle_16(&corners, band, &smooth));
    }
    const fxl_depth_drawn drawn =
        (of->pixel_bits == 16 ? fxl_draw_smooth_outline_16
                              : fxl_draw_smooth_outline_8)(of->points, of->count, band, &smooth);
    return has_drawn(of, band, drawn);
}

static bool draw_colours(const polygon *of, const fxl_band *band)
{
    fxl_colour_outline outline;
    clear_some(band);
    if (!fxl_depth_outline_can_draw(&by_core.head, band, 2)) {
        return false;
    }
    fxl_colour_outline_set(&by_core.head, &of->plane, &of->gradients, band, &outline);
    return has_drawn(of, band, fxl_draw_colour_outline(of->points, of->count, band, &outline));
}

#endif

#if FXL_DRAWS_SMOOTH_OUTLINES

static bool draw_texels(const polygon *of, const fxl_band *band)
{
    static fxl_scan scan;
    (void)fxl_draw_texels(&of->paint, &of->plane, &by_core, of->points, of->count, band, &scan);
    return true;
}

#endif

#if FXL_DRAWS_SMOOTH_WORDS

/* Light whose gradient has more bits becomes words. */
static bool draw_words(const polygon *of, const fxl_band *band)
{
    static fxl_scan scan;
    const fxl_light_plane light = fxl_light_plane_of(&of->gradients);
    fxl_gradients gradients = of->gradients;
    fxl_paint paint = of->paint;
    gradients.attributes[0] = (fxl_gradient){light.at, light.along, light.down};
    paint.gradients = &gradients;
    fxl_scan_outline(of->points, of->count, band, &scan);
    fxl_draw_smooth_words(&paint, &of->plane, &by_core, of->pixel_bits / 8, band, &scan);
    return true;
}

#endif

/* Draws nothing where the outline has more than two chains, or the plane is not the kernel's. */
static bool draw_by_kernel(const polygon *of, const fxl_band *band)
{
    static fxl_scan scan;
    fxl_depth_outline outline;
    outline.plane = of->plane;
    if (!fxl_depth_outline_can_draw(&by_core.head, band, of->pixel_bits / 8) ||
        !fxl_depth_outline_begin(&by_core, band, of->pixel_bits / 8, &outline)) {
        return false;
    }
    outline.scan = &scan;
    if (of->pixel_bits == 16) {
        outline.filling = COLOUR * 65537u;
        return fxl_draw_depth_outline_16(of->points, of->count, band, &outline) !=
               FXL_DEPTH_NOT_DRAWN;
    }
    outline.filling = (COLOUR & 255u) * 0x01010101u;
    return fxl_draw_depth_outline_8(of->points, of->count, band, &outline) != FXL_DEPTH_NOT_DRAWN;
}

#if FXL_DRAWS_SMOOTH_OUTLINES

/* A triangle of a model view, whose vertices are projected. */
static struct {
    fxl_view view;
    fxl_cached_vertex entries[4];
    fxl_model_view model_view;
    fxl_face face;
} drawn_face;

static int32_t any_tilt(void)
{
    return (int32_t)any_32() >> (3u + (any_32() >> 9 & 15u));
}

/* Of the points, with a plane before the eye. */
static void any_face(const fxl_band *band, polygon *of)
{
    fxl_view *view = &drawn_face.view;
    const int32_t near_z = (int32_t)(1024u + (any_32() >> 8 >> (any_32() >> 9 & 7u)));
    const int64_t z = ((int64_t)near_z << 30) * (int32_t)(1u + (any_32() >> 9) % 64u);
    const uint32_t tag = any_32() | 1u << 31;
    const fxl_direction normal = {any_tilt(), any_tilt(), 900000000};
    view->lens.near_z = near_z;
    view->projection.factor = 4u * ((20u + (any_32() >> 9) % 400u) << 16);
    view->projection.centre_x = (int32_t)(band->width << 15);
    view->projection.centre_y = (int32_t)(band->first_row + band->rows) << 15;
    for (uint32_t i = 0; i < 3; i++) {
        fxl_screen_point *point = &of->points[i];
        point->y = point->y < 0 ? 0 : point->y;
        drawn_face.entries[i] = (fxl_cached_vertex){
            .tag = tag + i, .clip_flags = fxl_vertex_place_flags(point), .screen = *point};
        drawn_face.face.indices[i] = (uint16_t)i;
    }
    drawn_face.entries[0].position =
        (fxl_view_point){z >> (any_32() >> 9 & 7u), -(z >> (any_32() >> 9 & 7u)), z};
    drawn_face.face.normal = normal;
    drawn_face.face.count = 3;
    drawn_face.model_view =
        (fxl_model_view){.view = view, .entries = drawn_face.entries, .mask = 3, .tag = tag};
    portable_find_depth_plane(&normal, NULL, &drawn_face.entries[0].position, view, &of->plane);
}

/* Draws nothing where the triangle covers no row or column, or is not the kernel's. */
static bool draw_face(const polygon *of, const fxl_band *band)
{
    static fxl_screen_polygon screen;
    fxl_depth_outline outline;
    (void)of;
    if (!fxl_depth_outline_can_draw(&by_core.head, band, 2)) {
        return false;
    }
    fxl_depth_outline_of_band(&by_core.head, band, 2, &outline);
    outline.filling = COLOUR * 65537u;
    return fxl_draw_depth_face_16(&drawn_face.model_view, &drawn_face.face, &outline, band,
                                  &screen) != FXL_DEPTH_FACE_IS_OTHER;
}

/* Paints the runs of a list, and empties it. *row: that of the run before. */
static void paint_list(const polygon *of, const fxl_band *band, uint32_t *list,
                       fxl_depth_rows *rows, row_of_pixels *row)
{
    for (const uint32_t *run = list; run != rows->runs; run++) {
        if (*run & FXL_RUN_BELOW) {
            row->pixels += band->stride * of->pixel_bits / 8;
        }
        paint_run(row, (int32_t)(*run & 0xFFFFu), (int32_t)(*run >> 16 & 0x7FFFu), NULL,
                  (fxl_depth_line){0, 0});
    }
    rows->runs = list;
}

/* The same by a list of runs, of any length. A trapezoid that goes on below the one before may go
 * on with its list. */
static bool draw_by_runs(const polygon *of, const fxl_band *band)
{
    static fxl_scan scan;
    uint32_t list[32];
    fxl_depth_painting painting;
    fxl_depth_rows rows;
    const fxl_trapezoid *trapezoid;
    row_of_pixels row = {of, band->pixels, 0};
    int32_t y = -1;
    bool (*const find_runs)(fxl_depth_rows * rows) =
        by_core.head.or_equal ? fxl_find_visible_runs : fxl_find_depth_runs;
    begin(&painting, &by_core, &of->plane, band);
    if (!fxl_depth_rows_take(&painting)) {
        return false;
    }
    fxl_depth_rows_begin(&painting, &rows);
    rows.runs = list;
    rows.runs_end = list + 1u + (any_32() >> 9) % 32u;
    portable_scan_outline(of->points, of->count, band, &scan);
    while ((trapezoid = portable_scan_next_trapezoid(&scan)) != NULL) {
        rows.rows = (uint32_t)(trapezoid->end_row - trapezoid->first_row);
        if (trapezoid->first_row == y) {
            rows.rows |= FXL_RUN_BELOW;
        } else {
            paint_list(of, band, list, &rows, &row);
            row.pixels = band->pixels + (uint32_t)(trapezoid->first_row - band->first_row) *
                                            band->stride * of->pixel_bits / 8;
            fxl_depth_rows_go(&painting, trapezoid->first_row, &rows);
        }
        y = trapezoid->end_row;
        rows.edges[0] = trapezoid->edges[0];
        rows.edges[1] = trapezoid->edges[1];
        while (find_runs(&rows)) {
            paint_list(of, band, list, &rows, &row);
        }
        if (rows.runs == rows.runs_end) {
            paint_list(of, band, list, &rows, &row);
        }
    }
    paint_list(of, band, list, &rows, &row);
    return true;
}

#endif

static bool is_same(void)
{
    const bool same =
        equality_same_words(by_core.cells, by_portable.cells, sizeof by_core.cells) &&
        equality_same_words(by_core.pixels, by_portable.pixels, sizeof by_core.pixels);
    memset(by_core.pixels, 0, sizeof by_core.pixels);
    memset(by_portable.pixels, 0, sizeof by_portable.pixels);
    return same;
}

enum {
    PLAIN,
    SMOOTH,
    COLOURED,
    TEXTURED,
    BLENDED,
    FROM_VERTICES
};

static void compare(bool (*draw)(const polygon *of, const fxl_band *band), uint32_t kind)
{
    polygon of;
    const uint32_t width = 1u + (any_32() >> 8) % ROW, tall = CELLS / width;
    const uint32_t rows = 1u + (any_32() >> 7) % (tall < 50 ? tall : 50);
    const uint32_t most = (any_32() & 0x200u) != 0 ? 9 : CELLS; /* every other one is small */
    const uint32_t height = 1u + (any_32() >> 9) % (2 * rows < most ? 2 * rows : most);
    fxl_band band = {.width = (uint16_t)width,
                     .stride = (uint16_t)width,
                     .first_row = (uint16_t)((any_32() >> 9 & 1u) * (any_32() >> 11) % 900u),
                     .rows = (uint16_t)rows};
    const int32_t top =
        (int32_t)(band.first_row << 16) - (int32_t)((any_32() >> 8) % (height << 15));
    const uint32_t narrow = 1u + (any_32() >> 9) % (width < most ? width : most),
                   left = (any_32() >> 9) % (width - narrow + 1);
    of.count = (any_32() & 1u) != 0 ? 3u : 3u + (any_32() >> 11 & 3u);
    of.pixel_bits = 8u + (any_32() >> 9 & 8u);
    of.count = kind == FROM_VERTICES ? 3u : of.count;
    of.is_smooth = kind == SMOOTH;
    of.has_colours = kind == COLOURED;
    of.has_texels = kind == TEXTURED;
    of.pixel_bits = of.has_colours || of.has_texels || kind == FROM_VERTICES ? 16u : of.pixel_bits;
    for (uint32_t i = 0; i < of.count; i++) {
        of.points[i].x = (int32_t)(left << 16) + any_place(narrow);
        of.points[i].y = top + any_place(height);
    }
    const uint8_t octaves = (uint8_t)(1u + (any_32() >> 9) % 24u);
    uint8_t mantissa = 15;
    while ((uint32_t)octaves << mantissa >= 65536u) {
        mantissa--;
    }
    by_core.head.scale = by_portable.head.scale = (fxl_depth_scale){octaves, mantissa};
    by_core.head.or_equal = by_portable.head.or_equal = kind == BLENDED;
    any_plane(&band, &of.plane);
    if (of.is_smooth || of.has_colours || of.has_texels) {
        any_linear_plane(&band, &of.plane);
    }
#if FXL_DRAWS_SMOOTH_OUTLINES
    if (kind == FROM_VERTICES) {
        any_face(&band, &of);
    }
#endif
    any_cells(&band, &of.plane);
    if (of.is_smooth) {
        any_light(&band, &of);
    } else if (of.has_colours) {
        any_colours(&band, &of);
    } else if (of.has_texels) {
        any_texels(&of);
    }
    band.pixels = (uint8_t *)(by_core.pixels + AROUND);
    if (draw(&of, &band)) {
        band.pixels = (uint8_t *)(by_portable.pixels + AROUND);
        draw_by_rows(&of, &band);
    }
    equality_case(is_same());
}

void test_depth_outlines(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds; i++) {
        compare(draw_by_kernel, PLAIN);
    }
}

#if FXL_DRAWS_SMOOTH_OUTLINES || FXL_DRAWS_SMOOTH_WORDS

static void fill_ramp(void)
{
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)(any_32() >> 9);
    }
}

#endif

#if FXL_DRAWS_SMOOTH_WORDS

void test_smooth_words(uint32_t rounds)
{
    fill_ramp();
    for (uint32_t i = 0; i < rounds; i++) {
        compare(draw_words, SMOOTH);
    }
}

#endif

#if FXL_DRAWS_SMOOTH_OUTLINES

void test_depth_faces(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds; i++) {
        compare(draw_face, FROM_VERTICES);
    }
}

void test_smooth_outlines(uint32_t rounds)
{
    fill_ramp();
    for (uint32_t i = 0; i < rounds; i++) {
        compare(draw_smooth, SMOOTH);
    }
}

void test_colour_outlines(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds; i++) {
        compare(draw_colours, COLOURED);
    }
}

void test_texel_outlines(uint32_t rounds)
{
    fill_ramp();
    for (uint32_t i = 0; i < rounds; i++) {
        compare(draw_texels, TEXTURED);
    }
}

void test_depth_runs(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds; i++) {
        compare(draw_by_runs, (i & 1u) != 0 ? BLENDED : PLAIN);
    }
}

#endif

#endif
