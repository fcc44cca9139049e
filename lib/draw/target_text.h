/* SPDX-License-Identifier: MIT */
/* The text of all targets: how a face of one colour is drawn. The file that includes this one
 * defines:
 *
 *   FXL_TARGET             the target's name
 *   FXL_TARGET_FORMAT      a format of pixel_row.h
 *   FXL_TARGET_DEPTH_BITS  0, 16 or 32
 *
 * So no target tests at run time what it is. Internal. */
#ifndef FXL_TARGET_TEXT_H
#define FXL_TARGET_TEXT_H

#include "../clip/clip_by_view.h"
#include "../raster/fill.h"
#include "../raster/scan.h"
#include "../view/model_view.h"
#include "../view/project.h"
#include "pixel_row.h"
#include "renderer.h"
#include "submit.h"

#if FXL_TARGET_DEPTH_BITS == 0

/* A face goes from the clipper straight to here where it can (render.c). */
static bool flat(fxl_workspace *workspace, const fxl_screen_polygon *polygon, const fxl_band *band)
{
    return fxl_draw_flat(&workspace->work.scan, polygon, band, workspace->dark);
}

#else

/* Paints the pixels x0 <= x < x1 of row y; with: the painter's own. */
typedef void flat_row_painter(void *with, fxl_pixel *pixels, int32_t y, int32_t x0, int32_t x1);

/* The rows of an outline. pixels: of column 0. */
static inline __attribute__((always_inline)) void paint_rows(const fxl_screen_point *points,
                                                             uint32_t count, const fxl_band *band,
                                                             fxl_scan *scan,
                                                             flat_row_painter *paint, void *with)
{
    const fxl_trapezoid *trapezoid;
    fxl_scan_outline(points, count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
        fxl_pixel *pixels = fxl_pixels_of_row(band, (uint32_t)trapezoid->first_row);
        for (int32_t y = trapezoid->first_row; y < trapezoid->end_row; y++) {
            const int32_t x0 = a.x < b.x ? a.x : b.x, x1 = a.x < b.x ? b.x : a.x;
            if (x0 < x1) {
                paint(with, pixels, y, x0, x1);
            }
            fxl_edge_step(&a);
            fxl_edge_step(&b);
            pixels += band->stride;
        }
    }
}

#endif

#if FXL_TARGET_DEPTH_BITS != 0

#include "surface_polygon.h"
#include "../paint/depth_outline.h"
#include "depth_plane.h"

/* A polygon of one colour, and its depth. */
typedef struct {
    fxl_depth_painting depth;
    fxl_filling filling;
} flat_painting;

/* A run of visible pixels of a row. */
typedef struct {
    fxl_pixel *pixels;
    fxl_filling filling;
} flat_row;

static inline __attribute__((always_inline)) void
paint_run(const void *with, int32_t x0, int32_t x1, void *cells, fxl_depth_line line)
{
    const flat_row *row = (const flat_row *)with;
    (void)cells;
    (void)line;
    fxl_fill_pixels(row->pixels + x0, row->pixels + x1, row->filling);
}

static inline __attribute__((always_inline)) void paint_row(void *with, fxl_pixel *pixels,
                                                            int32_t y, int32_t x0, int32_t x1)
{
    flat_painting *of = (flat_painting *)with;
    const flat_row row = {pixels, of->filling};
    fxl_depth_paint_row(&of->depth, y, x0, x1, FXL_TARGET_DEPTH_BITS, false, paint_run, &row);
}

/* A plane, where the kernel of outlines takes it, if there is one. */
#if FXL_DRAWS_DEPTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16
typedef fxl_depth_outline flat_outline;
#else
typedef struct {
    fxl_depth_plane plane;
} flat_outline;
#endif

/* Draws a polygon by the kernel of outlines, where there is one and it can. */
static inline fxl_depth_drawn draw_outline(fxl_workspace *workspace, flat_outline *outline,
                                           const fxl_screen_point *points, uint32_t count,
                                           uint8_t colour, uint8_t shade, const fxl_band *band)
{
#if FXL_DRAWS_DEPTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16
    if (!workspace->draws_outlines ||
        !fxl_depth_outline_begin(workspace->target_memory, band, FXL_PIXEL_BITS / 8, outline)) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    outline->filling = fxl_filling_word(fxl_filling_of(band, colour, shade, workspace->dark));
#if !FXL_KERNELS_ARMV7M
    outline->scan = &workspace->work.scan;
#endif
    return FXL_DRAW_DEPTH_OUTLINE(points, count, band, outline);
#else
    (void)workspace;
    (void)outline;
    (void)points;
    (void)count;
    (void)colour;
    (void)shade;
    (void)band;
    return FXL_DEPTH_NOT_DRAWN;
#endif
}

/* Not inline: what it has would stay on the stack while the kernel draws. */
static __attribute__((noinline)) void paint_by_rows(fxl_workspace *workspace,
                                                    const fxl_depth_plane *plane,
                                                    const fxl_screen_point *points, uint32_t count,
                                                    uint8_t colour, uint8_t shade,
                                                    const fxl_band *band)
{
    flat_painting of;
    fxl_depth_begin(&of.depth, workspace->target_memory, plane, band);
    if (of.depth.head->pass != FXL_DEPTH_BLENDED) {
        of.filling = fxl_filling_of(band, colour, shade, workspace->dark);
        paint_rows(points, count, band, &workspace->work.scan, paint_row, &of);
    }
}

/* Returns true if it is known that the polygon reaches a row. */
static inline __attribute__((always_inline)) bool
paint_flat_here(fxl_workspace *workspace, flat_outline *outline, const fxl_screen_point *points,
                uint32_t count, uint8_t colour, uint8_t shade, const fxl_band *band)
{
    fxl_depth_clear_rest(workspace, band, FXL_TARGET_DEPTH_BITS / 8);
    const fxl_depth_drawn drawn =
        draw_outline(workspace, outline, points, count, colour, shade, band);
    if (drawn == FXL_DEPTH_NOT_DRAWN) {
        paint_by_rows(workspace, &outline->plane, points, count, colour, shade, band);
    }
    return drawn == FXL_DEPTH_DRAWN;
}

static __attribute__((noinline)) bool
paint_flat(fxl_workspace *workspace, const fxl_depth_plane *plane, const fxl_screen_point *points,
           uint32_t count, uint8_t colour, uint8_t shade, const fxl_band *band)
{
    flat_outline outline;
    outline.plane = *plane;
    return paint_flat_here(workspace, &outline, points, count, colour, shade, band);
}

/* fxl_target.flat: what has no depth is at infinity. Front to back, the first of these to cover a
 * pixel is seen, as in a span buffer; far to near, the last one. */
static bool flat(fxl_workspace *workspace, const fxl_screen_polygon *polygon, const fxl_band *band)
{
    static const fxl_depth_plane infinity = {{0, 0, 0}, 0};
    (void)paint_flat(workspace, &infinity, polygon->points, polygon->count, polygon->colour,
                     polygon->shade, band);
    return true;
}

static void flat_with_depth(fxl_workspace *workspace, const fxl_screen_polygon *record,
                            const fxl_band *band)
{
    fxl_surface_polygon polygon;
    const uint32_t count = fxl_surface_polygon_read(record, &polygon);
    (void)paint_flat(workspace, &polygon.depth, record->points, count, polygon.colour,
                     polygon.shade, band);
}

/* --- faces and pieces ----------------------------------------------------------------------- */

/* fxl_polygon_finder. */
static inline __attribute__((always_inline)) void
find(const void *what, const fxl_model_view *model_view, const fxl_face *face,
     const fxl_traversal *traversal, fxl_surface_polygon *polygon)
{
    (void)what;
    polygon->surface = FXL_NO_SURFACE;
    polygon->gradients.count = 0;
    for (uint32_t i = 0; i < FXL_ATTRIBUTES; i++) {
        polygon->gradients.shifts[i] = 0;
    }
    polygon->level = 0;
    polygon->colour = face->material;
    polygon->shade = FXL_PIXEL_IS_MIXED ? traversal->workspace->screen.shade : 0;
    polygon->is_in_beam = false;
    polygon->is_evenly_lit = false;
    polygon->has_depth = true;
    fxl_find_depth_by_normal(model_view, face, traversal, &polygon->depth);
}

/* fxl_polygon_painter. */
static inline __attribute__((always_inline)) bool
paint_polygon(const void *what, fxl_workspace *workspace, const fxl_surface_polygon *polygon,
              const fxl_screen_point *points, uint32_t count, const fxl_band *band)
{
    (void)what;
    return paint_flat(workspace, &polygon->depth, points, count, polygon->colour, polygon->shade,
                      band);
}

static fxl_outcome submit_polygons(const fxl_model_view *model_view, const fxl_face *face,
                                   const fxl_traversal *traversal)
{
    fxl_surface_polygon polygon;
    return fxl_submit_found_polygons(model_view, face, traversal, find, paint_polygon, NULL,
                                     &polygon, false);
}

/* The depth of the face that is drawn now: fxl_find_depth_by_normal, whose usual case is here. */
static inline void find_depth(const fxl_model_view *model_view, const fxl_face *face,
                              const fxl_traversal *traversal, fxl_depth_plane *plane)
{
    const fxl_view *view = model_view->view;
    if (!FXL_IS_COMPACT && traversal->clipper->by_clip_flags && view->lens.off_centre == NULL) {
        const uint32_t number = face->indices[0];
        fxl_find_depth_plane(&face->normal, model_view->axes,
                             &fxl_fetch_vertex(model_view, number)->position, view, plane);
        return;
    }
    fxl_find_depth_by_normal(model_view, face, traversal, plane);
}

#if !(FXL_DRAWS_DEPTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16)

/* What became of a face that may be tiny. */
typedef enum {
    TINY_IS_NOT,
    TINY_HAS_NO_PIXEL, /* in the band */
    TINY_IS_DRAWN
} tiny_drawn;

/* Draws the pixels of a tiny triangle, and finds its depth if it has some. */
static __attribute__((noinline)) tiny_drawn
draw_tiny(const fxl_model_view *model_view, const fxl_face *face, const fxl_traversal *traversal)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_band *band = traversal->band;
    const fxl_depth_head *head = (const fxl_depth_head *)workspace->target_memory;
    const fxl_depth_rule rule = {FXL_TARGET_DEPTH_BITS == 32, head->or_equal};
    fxl_depth_plane plane;
    fxl_tiny tiny;
    if (!fxl_tiny_find(workspace->screen.points, band, &tiny)) {
        return TINY_IS_NOT;
    }
    if (tiny.pixels == 0) {
        return TINY_HAS_NO_PIXEL;
    }
    if (head->pass == FXL_DEPTH_BLENDED) {
        return TINY_IS_DRAWN;
    }
    find_depth(model_view, face, traversal, &plane);
    fxl_depth_clear_rest(workspace, band, FXL_TARGET_DEPTH_BITS / 8);
    const fxl_filling filling = fxl_filling_of(
        band, face->material, FXL_PIXEL_IS_MIXED ? workspace->screen.shade : 0, workspace->dark);
    uint32_t pixels = tiny.pixels;
    for (int32_t y = tiny.row; pixels != 0; y++) {
        const int64_t depth =
            plane.gradient.at + fxl_multiply_s64_u16(plane.gradient.down, (uint32_t)y);
        void *cells = (uint8_t *)(uintptr_t)(head + 1) +
                      (size_t)(y - band->first_row) * band->width * (FXL_TARGET_DEPTH_BITS / 8);
        for (int32_t i = 0; i < tiny.columns; i++, pixels <<= 1) {
            if (pixels >> 31 == 0) {
                continue;
            }
            const int32_t x = tiny.column + i;
            const uint32_t code = fxl_depth_code_at(head->scale, &plane, depth, x);
            if (fxl_depth_passes(cells, x, code, rule)) {
                fxl_depth_keep(cells, x, code, rule.wide);
                fxl_pixels_of_row(band, (uint32_t)y)[x] = (fxl_pixel)filling;
            }
        }
    }
    return TINY_IS_DRAWN;
}

#endif

/* Draws the polygon that the clipper has left of a face. Returns whether it reaches a row of the
 * screen. */
static inline bool draw_polygon(const fxl_model_view *model_view, const fxl_face *face,
                                const fxl_traversal *traversal)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_screen_polygon *screen = &workspace->screen;
    const uint8_t shade = FXL_PIXEL_IS_MIXED ? screen->shade : 0;
    flat_outline outline;
    bool draws = true;
#if !(FXL_DRAWS_DEPTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16)
    if (FXL_HAS_TINY && screen->count == 3) { /* most are higher */
        const tiny_drawn drawn = draw_tiny(model_view, face, traversal);
        if (drawn == TINY_IS_DRAWN) {
            return true;
        }
        draws = drawn == TINY_IS_NOT;
    }
#endif
    if (draws) {
        find_depth(model_view, face, traversal, &outline.plane);
    }
    return (draws && paint_flat_here(workspace, &outline, screen->points, screen->count,
                                     face->material, shade, traversal->band)) ||
           fxl_outline_has_rows(screen, traversal->renderer->frame.view.lens.height);
}

#define DRAWS_TINY (FXL_DRAWS_DEPTH_TINY && FXL_TARGET_DEPTH_BITS == 16)

#if DRAWS_TINY

/* fxl_clip_by_view of a triangle, which also finds the box of its centres; columns is 0 of one that
 * does not lie inside. Its places in the clip flags are the upper bits, so words are ordered as they
 * are. */
static inline fxl_clip_result clip_triangle(const fxl_model_view *model_view, const fxl_face *face,
                                            const fxl_traversal *traversal, fxl_tiny *box)
{
    fxl_screen_polygon *screen = &traversal->workspace->screen;
    uint32_t least = UINT32_MAX, most = 0, left = UINT32_MAX, right = 0;
    for (uint32_t i = 0; i < 3; i++) {
        fxl_cached_vertex *vertex = fxl_fetch_vertex(model_view, face->indices[i]);
        uint32_t state = vertex->clip_flags;
        if ((state & FXL_VERTEX_OUTSIDE) != 0) {
            if (state != FXL_VERTEX_UNPROJECTED ||
                fxl_project_inside(&model_view->view->projection, &vertex->position,
                                   &vertex->screen) != FXL_OK) {
                box->columns = 0;
                return fxl_first_polygon(model_view, face, traversal);
            }
            state = fxl_vertex_place_flags(&vertex->screen);
            vertex->clip_flags = state;
        }
        screen->points[i] = vertex->screen;
        least = state < least ? state : least;
        most = state > most ? state : most;
        state <<= 12;
        left = state < left ? state : left;
        right = state > right ? state : right;
    }
    screen->colour = face->material;
    screen->count = 3;
    box->row = (int32_t)(least >> 20);
    box->rows = (int32_t)(most >> 20) - box->row;
    box->column = (int32_t)(left >> 20);
    box->columns = (int32_t)(right >> 20) - box->column;
    return box->rows == 0 || box->columns == 0 ? FXL_CLIP_BETWEEN : FXL_CLIP_INSIDE;
}

/* Draws a triangle in a box by the pixels that it covers. False: it is not drawn. */
static bool draw_tiny(const fxl_model_view *model_view, const fxl_face *face,
                      const fxl_traversal *traversal, fxl_tiny *tiny)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_band *band = traversal->band;
    const fxl_depth_head *head = (const fxl_depth_head *)workspace->target_memory;
    fxl_depth_plane plane;
    if (!fxl_tiny_cover(workspace->screen.points, tiny)) {
        return false;
    }
    if (tiny->pixels == 0) {
        return true;
    }
    find_depth(model_view, face, traversal, &plane);
    fxl_depth_clear_rest(workspace, band, FXL_TARGET_DEPTH_BITS / 8);
    const fxl_filling filling = fxl_filling_of(
        band, face->material, FXL_PIXEL_IS_MIXED ? workspace->screen.shade : 0, workspace->dark);
    return fxl_depth_tiny_draw(&plane, tiny, head, band, filling, FXL_PIXEL_BITS);
}

#endif

/* fxl_submit_polygons and fxl_count_outcome of such a face. */
static bool draw_face(const fxl_model_view *model_view, const fxl_face *face,
                      const fxl_traversal *traversal)
{
    fxl_counters *counters = traversal->counters;
    fxl_clip_result cut;
    bool is_drawn = false;
#if DRAWS_TINY
    if (face->count == 3 && traversal->workspace->draws_outlines &&
        traversal->clipper->by_clip_flags && model_view->view->lens.off_centre == NULL) {
        fxl_tiny box;
        cut = clip_triangle(model_view, face, traversal, &box);
        is_drawn = cut == FXL_CLIP_INSIDE && fxl_tiny_fits(&box, traversal->band) &&
                   draw_tiny(model_view, face, traversal, &box);
    } else
#endif
    {
        cut = fxl_first_polygon(model_view, face, traversal);
    }
    if (cut > FXL_CLIP_CUT) {
        return fxl_count_outcome(traversal, (fxl_outcome)1 << cut, 0);
    }
    if (is_drawn || draw_polygon(model_view, face, traversal)) {
        counters->spilled += 1;
    }
    counters->drawn += 1;
    if (cut == FXL_CLIP_CUT) {
        counters->clipped += 1;
    }
    return true;
}

static bool submit(const fxl_model_view *model_view, const fxl_face *face,
                   const fxl_traversal *traversal, const fxl_shader *shader)
{
    (void)shader;
    if (traversal->draws_one) {
        return draw_face(model_view, face, traversal);
    }
    const uint32_t used = traversal->renderer->frame.display_list.used;
    return fxl_count_outcome(traversal, submit_polygons(model_view, face, traversal), used);
}

#if FXL_WALKS_FACES && FXL_TARGET_DEPTH_BITS == 16

/* Draws the polygon that the clipper has left of a face by the kernel of outlines, of which *outline
 * has what all faces of a band share. As draw_polygon, whose usual case this is. */
static inline __attribute__((always_inline)) bool
draw_by_outline(const fxl_model_view *model_view, const fxl_face *face, fxl_workspace *workspace,
                const fxl_band *band, fxl_depth_outline *outline)
{
    const fxl_screen_polygon *screen = &workspace->screen;
    const fxl_depth_head *head = (const fxl_depth_head *)workspace->target_memory;
    fxl_depth_drawn drawn = FXL_DEPTH_NOT_DRAWN;
    fxl_find_depth_plane(&face->normal, model_view->axes,
                         &fxl_fetch_vertex(model_view, face->indices[0])->position,
                         model_view->view, &outline->plane);
    const uint8_t colour = face->material;
    const uint8_t shade = FXL_PIXEL_IS_MIXED ? screen->shade : 0;
    if (fxl_depth_outline_of_plane(head, outline)) {
        outline->filling = fxl_filling_word(fxl_filling_of(band, colour, shade, workspace->dark));
        drawn = FXL_DRAW_DEPTH_OUTLINE(screen->points, screen->count, band, outline);
    }
    if (drawn == FXL_DEPTH_NOT_DRAWN) {
        paint_by_rows(workspace, &outline->plane, screen->points, screen->count, colour, shade,
                      band);
    }
    return drawn == FXL_DEPTH_DRAWN || fxl_outline_has_rows(screen, model_view->view->lens.height);
}

/* fxl_shader_code.faces: straight from the clipper to the kernel of outlines. */
static bool submit_faces(const fxl_model_view *model_view, const fxl_traversal *traversal,
                         fxl_face_walk *walk)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_clipper *clipper = traversal->clipper;
    const fxl_band *band = traversal->band;
    uint32_t submitted = 0, others = 0, without_rows = 0;
    fxl_depth_outline outline;
    if (!traversal->draws_one || !workspace->draws_outlines || !clipper->by_clip_flags ||
        model_view->view->lens.off_centre != NULL) {
        return false;
    }
    const fxl_face *face = walk->next(model_view, walk);
    if (face != NULL) {
        fxl_depth_clear_rest(workspace, band, FXL_TARGET_DEPTH_BITS / 8);
        fxl_depth_outline_of_band((const fxl_depth_head *)workspace->target_memory, band,
                                  FXL_PIXEL_BITS / 8, &outline);
    }
    for (; face != NULL; face = walk->next(model_view, walk)) {
        const fxl_clip_result cut =
            clipper->clip(model_view, face, &workspace->work.clip, &workspace->screen);
        submitted++;
        if (cut != FXL_CLIP_INSIDE) {
            if (cut != FXL_CLIP_CUT) {
                others++;
                (void)fxl_count_outcome(traversal, (fxl_outcome)1 << cut, 0);
                continue;
            }
            traversal->counters->clipped++;
        }
        if (!draw_by_outline(model_view, face, workspace, band, &outline)) {
            without_rows++;
        }
    }
    walk->submitted = submitted;
    traversal->counters->drawn += submitted - others;
    traversal->counters->spilled += submitted - others - without_rows;
    return true;
}

#endif

static bool split(const fxl_shader *shader, fxl_pieces *pieces, const fxl_face *face,
                  const fxl_point *points, uint32_t count)
{
    const fxl_traversal *traversal = pieces->traversal;
    fxl_face piece = *face;
    fxl_model_view model_view;
    (void)shader;
    fxl_set_face_of_points(&piece, count);
    fxl_model_view_of_polygon(&model_view, points, &traversal->renderer->frame.view,
                              &traversal->workspace->cache);
    model_view.planes = pieces->planes;
    pieces->outcome |= submit_polygons(&model_view, &piece, traversal);
    return pieces->outcome < FXL_OUTCOME_FULL;
}

static bool reaches(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    (void)shader;
    (void)scene;
    (void)instance;
    return true;
}

static const fxl_shader_code code = {
    .reaches = reaches,
    .face = submit,
    .split = split,
#if FXL_WALKS_FACES
#if FXL_TARGET_DEPTH_BITS == 16
    .faces = submit_faces,
#endif
    .walk = fxl_submit_walk,
#endif
};
static const fxl_shader last = {NULL, FXL_SHADER_TARGET, &code};
static const fxl_target_extras extras = {fxl_mixed_draw_list, flat_with_depth, &last, NULL, NULL};

/* --- bands ---------------------------------------------------------------------------------- */

static uint32_t memory_size(const fxl_lens *lens)
{
    return FXL_DEPTH_BYTES(lens->width, 1, FXL_TARGET_DEPTH_BITS);
}

static fxl_status draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band)
{
    const fxl_status status = fxl_check_band(band);
    if (status != FXL_OK) {
        return fxl_refuse(workspace, status);
    }
    if (FXL_PIXEL_IS_MIXED) {
        workspace->dark = renderer->dark;
    }
    fxl_depth_draw_parts(renderer, workspace, band, FXL_TARGET_DEPTH_BITS / 8, FXL_PIXEL_BITS / 8);
    return FXL_OK;
}

#elif FXL_PIXEL_IS_MIXED

static fxl_status draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band)
{
    const fxl_status status = fxl_check_band(band);
    if (status != FXL_OK) {
        return fxl_refuse(workspace, status);
    }
    workspace->dark = renderer->dark;
    return fxl_draw_band(renderer, workspace, band);
}

#endif

const fxl_target FXL_TARGET = {
    .pixel_bits = FXL_PIXEL_BITS,
    .depth_bits = FXL_TARGET_DEPTH_BITS,
    .draws_over = FXL_TARGET_DEPTH_BITS == 0,
    .near_first = FXL_TARGET_DEPTH_BITS != 0,
    .has_palette = FXL_PIXEL_HAS_PALETTE,
    .is_mixed = FXL_PIXEL_IS_MIXED,
    .fill = FXL_FILL_BAND,
#if FXL_PIXEL_IS_MIXED || FXL_TARGET_DEPTH_BITS != 0
    .choose = fxl_choose_with_memory,
#endif
#if FXL_TARGET_DEPTH_BITS != 0
    .memory_size = memory_size,
#endif
#if FXL_PIXEL_IS_MIXED || FXL_TARGET_DEPTH_BITS != 0
    .draw_band = draw_band,
#else
    .draw_band = fxl_draw_band,
#endif
    .flat = flat,
#if FXL_TARGET_DEPTH_BITS != 0
    .extras = &extras,
#endif
};

#endif
