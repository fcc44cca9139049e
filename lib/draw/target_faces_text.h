/* SPDX-License-Identifier: MIT */
/* How faces and pieces of one colour are submitted to a target with a depth buffer: its last shader's
 * functions. A part of target_text.h. Internal. */
#ifndef FXL_TARGET_FACES_TEXT_H
#define FXL_TARGET_FACES_TEXT_H

#include "../clip/clip_by_view.h"
#include "../view/model_view.h"
#include "../view/project.h"
#include "depth_pixel.h"
#include "submit.h"
#include "target_flat_text.h"

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

/* The depth of the face that is drawn now: fxl_find_depth_by_normal, whose usual case is here: the
 * plane is that of the normal through the first vertex, in the view. */
static inline void find_depth(const fxl_model_view *model_view, const fxl_face *face,
                              const fxl_traversal *traversal, bool usual, fxl_depth_plane *plane)
{
    if (usual) {
        const uint32_t number = face->indices[0];
        fxl_find_depth_plane(&face->normal, model_view->axes,
                             &fxl_fetch_vertex(model_view, number)->position, model_view->view,
                             plane);
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
static __attribute__((noinline)) tiny_drawn draw_tiny(const fxl_model_view *model_view,
                                                      const fxl_face *face,
                                                      const fxl_traversal *traversal, bool usual)
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
    find_depth(model_view, face, traversal, usual, &plane);
    fxl_depth_clear_rest(workspace, band, &FXL_TARGET);
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
                                const fxl_traversal *traversal, bool usual)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_screen_polygon *screen = &workspace->screen;
    const uint8_t shade = FXL_PIXEL_IS_MIXED ? screen->shade : 0;
    flat_outline outline;
    bool draws = true;
#if !(FXL_DRAWS_DEPTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16)
    if (FXL_HAS_TINY && screen->count == 3) { /* most are higher */
        const tiny_drawn drawn = draw_tiny(model_view, face, traversal, usual);
        if (drawn == TINY_IS_DRAWN) {
            return true;
        }
        draws = drawn == TINY_IS_NOT;
    }
#endif
    if (draws) {
        find_depth(model_view, face, traversal, usual, &outline.plane);
    }
    return (draws && paint_flat_here(workspace, &outline, screen->points, screen->count,
                                     face->material, shade, traversal->band)) ||
           fxl_outline_has_rows(screen, traversal->renderer->frame.view.lens.height);
}

#define DRAWS_TINY (FXL_DRAWS_DEPTH_TINY && FXL_TARGET_DEPTH_BITS == 16)

#if DRAWS_TINY

/* The least of three places in the upper bits of words becomes *first; the result is how far the
 * greatest is from it. */
static inline int32_t extent_of(uint32_t a, uint32_t b, uint32_t c, int32_t *first)
{
    uint32_t least = a, most = b;
    if (a > b) {
        least = b;
        most = a;
    }
    if (c < least) {
        least = c;
    } else if (c > most) {
        most = c;
    }
    *first = (int32_t)(least >> 20);
    return (int32_t)(most >> 20) - *first;
}

/* The rows of a triangle that may be tiny, at most. Most of the higher ones have too many centres, or
 * cost less as an outline of a kernel. */
#define TINY_ROWS (FXL_KERNELS_ARMV6M ? 4 : 6)

/* fxl_clip_by_view of a triangle, less the colour, which is the face's. It also finds the box of its
 * centres; columns is 0 of one that does not lie inside, and of one of more than TINY_ROWS. */
static inline __attribute__((always_inline)) fxl_clip_result
clip_triangle(const fxl_model_view *model_view, const fxl_face *face,
              const fxl_traversal *traversal, fxl_tiny *box)
{
    fxl_screen_polygon *screen = &traversal->workspace->screen;
    uint32_t states[3];
    FXL_EACH_CORNER
    for (uint32_t i = 0; i < 3; i++) {
        fxl_cached_vertex *vertex = fxl_fetch_placed(model_view, face->indices[i]);
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
        states[i] = state;
    }
    screen->count = 3;
    const uint32_t a = states[0], b = states[1], c = states[2];
    box->columns = 0;
    box->rows = extent_of(a, b, c, &box->row);
    if (box->rows > TINY_ROWS) {
        return ((a ^ b) | (b ^ c)) << 12 >> 20 == 0 ? FXL_CLIP_BETWEEN : FXL_CLIP_INSIDE;
    }
    box->columns = extent_of(a << 12, b << 12, c << 12, &box->column);
    return box->rows == 0 || box->columns == 0 ? FXL_CLIP_BETWEEN : FXL_CLIP_INSIDE;
}

/* fxl_tiny_cover, apart from what the caller has in registers; a walk has it in place. */
static __attribute__((noinline, flatten)) bool cover(const fxl_screen_point *points,
                                                     fxl_tiny *tiny)
{
    return fxl_tiny_cover(points, tiny);
}

/* fxl_depth_draw_pixel of a copy, so that other triangles keep what they have in registers. */
FXL_APART bool draw_pixel(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *traversal, const fxl_tiny *tiny)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_band *band = traversal->band;
    fxl_tiny pixel = *tiny;
    fxl_depth_clear_rest(workspace, band, &FXL_TARGET);
    return fxl_depth_draw_pixel(
        model_view, face, traversal, &pixel,
        fxl_filling_of(band, face->material, FXL_PIXEL_IS_MIXED ? workspace->screen.shade : 0,
                       workspace->dark),
        FXL_PIXEL_BITS / 8);
}

/* Draws a triangle in a box by the pixels that it covers. False: it is not drawn. */
static inline __attribute__((always_inline)) bool draw_tiny(const fxl_model_view *model_view,
                                                            const fxl_face *face,
                                                            const fxl_traversal *traversal,
                                                            bool in_walk, fxl_tiny *tiny)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_band *band = traversal->band;
    const fxl_depth_head *head = (const fxl_depth_head *)workspace->target_memory;
    fxl_depth_plane plane;
    if (!(in_walk ? fxl_tiny_cover(workspace->screen.points, tiny)
                  : cover(workspace->screen.points, tiny))) {
        return false;
    }
    if (tiny->pixels == 0) {
        return true;
    }
    if ((tiny->pixels & (tiny->pixels - 1u)) == 0 &&
        draw_pixel(model_view, face, traversal, tiny)) {
        return true;
    }
    find_depth(model_view, face, traversal, true, &plane);
    fxl_depth_clear_rest(workspace, band, &FXL_TARGET);
    const fxl_filling filling = fxl_filling_of(
        band, face->material, FXL_PIXEL_IS_MIXED ? workspace->screen.shade : 0, workspace->dark);
    return fxl_depth_tiny_draw(&plane, tiny, head, band, filling, FXL_PIXEL_BITS);
}

#endif

/* fxl_submit_polygons and fxl_count_outcome of such a face. usual: as of find_depth. */
static inline __attribute__((always_inline)) void draw_face_here(const fxl_model_view *model_view,
                                                                 const fxl_face *face,
                                                                 const fxl_traversal *traversal,
                                                                 bool usual, bool in_walk)
{
    fxl_clip_result cut;
    bool is_drawn = false;
    (void)in_walk;
#if DRAWS_TINY
    if (usual && face->count == 3 && traversal->workspace->draws_outlines) {
        fxl_tiny box;
        cut = clip_triangle(model_view, face, traversal, &box);
        is_drawn = cut == FXL_CLIP_INSIDE && fxl_tiny_fits(&box, traversal->band) &&
                   draw_tiny(model_view, face, traversal, in_walk, &box);
    } else
#endif
    {
        cut = fxl_first_polygon(model_view, face, traversal);
    }
    if (cut > FXL_CLIP_CUT) {
        (void)fxl_count_outcome(traversal, (fxl_outcome)1 << cut, 0);
        return;
    }
    fxl_count_drawn(traversal->counters, cut,
                    is_drawn || draw_polygon(model_view, face, traversal, usual));
}

/* The same of any face. */
static bool draw_face(const fxl_model_view *model_view, const fxl_face *face,
                      const fxl_traversal *traversal)
{
    draw_face_here(model_view, face, traversal,
                   !FXL_IS_COMPACT && traversal->clipper->by_clip_flags &&
                       model_view->view->lens.off_centre == NULL,
                   false);
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

#if !FXL_KERNELS_ARMV7M

/* fxl_shader_code.faces: the next one is found, and drawn, in one loop. */
static bool submit_faces(const fxl_model_view *model_view, const fxl_traversal *traversal,
                         fxl_face_walk *walk)
{
    const bool is_front_face = walk->next == fxl_next_front_face;
    uint32_t submitted = 0;
    const fxl_face *face;
    if (!traversal->draws_one || !traversal->workspace->draws_outlines ||
        !traversal->clipper->by_clip_flags || model_view->view->lens.off_centre != NULL) {
        return false;
    }
    while ((face = is_front_face ? fxl_next_face_by(model_view, walk, fxl_model_view_face_is_front)
                                 : walk->next(model_view, walk)) != NULL) {
        submitted++;
        draw_face_here(model_view, face, traversal, true, true);
    }
    walk->submitted = submitted;
    return true;
}

#else

#if FXL_PIXEL_BITS == 16

/* Draws a face that faces the eye, of which *outline has what all faces of a band share and the
 * filling: fxl_draw_depth_face_16, and what that does not draw, as draw_face does. Returns false if it has
 * counted the face. */
static inline __attribute__((always_inline)) bool draw_walked(const fxl_model_view *model_view,
                                                              const fxl_face *face,
                                                              const fxl_traversal *traversal,
                                                              fxl_depth_outline *outline)
{
    fxl_screen_polygon *screen = &traversal->workspace->screen;
    fxl_depth_face drawn = FXL_DEPTH_FACE_IS_OTHER;
    if (face->count == 3) {
        drawn = fxl_draw_depth_face_16(model_view, face, outline, traversal->band, screen);
        if (drawn == FXL_DEPTH_FACE_IS_DRAWN) {
            return true;
        }
    }
    if (drawn == FXL_DEPTH_FACE_IS_OTHER) {
        (void)draw_face(model_view, face, traversal);
        return false;
    }
    if (drawn == FXL_DEPTH_FACE_IS_BETWEEN) {
        (void)fxl_count_outcome(traversal, (fxl_outcome)1 << FXL_CLIP_BETWEEN, 0);
        return false;
    }
    screen->count = 3;
    if (!fxl_outline_has_rows(screen, model_view->view->lens.height)) {
        traversal->counters->drawn++;
        return false;
    }
    return true;
}

#else

/* The same of all faces, from the clipper. */
static inline __attribute__((always_inline)) bool draw_walked(const fxl_model_view *model_view,
                                                              const fxl_face *face,
                                                              const fxl_traversal *traversal,
                                                              fxl_depth_outline *outline)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_screen_polygon *screen = &workspace->screen;
    const fxl_clip_result cut = fxl_first_polygon(model_view, face, traversal);
    if (cut > FXL_CLIP_CUT) {
        (void)fxl_count_outcome(traversal, (fxl_outcome)1 << cut, 0);
        return false;
    }
    traversal->counters->clipped += cut;
    fxl_depth_drawn drawn = FXL_DEPTH_NOT_DRAWN;
    fxl_find_depth_plane(&face->normal, model_view->axes,
                         &fxl_fetch_vertex(model_view, face->indices[0])->position,
                         model_view->view, &outline->plane);
    if (fxl_depth_outline_of_plane((const fxl_depth_head *)workspace->target_memory, outline)) {
        drawn = FXL_DRAW_DEPTH_OUTLINE(screen->points, screen->count, traversal->band, outline);
    }
    if (drawn == FXL_DEPTH_NOT_DRAWN) {
        paint_by_rows(workspace, &outline->plane, screen->points, screen->count, face->material, 0,
                      traversal->band);
    }
    if (drawn != FXL_DEPTH_DRAWN && !fxl_outline_has_rows(screen, model_view->view->lens.height)) {
        traversal->counters->drawn++;
        return false;
    }
    return true;
}

#endif

/* fxl_shader_code.faces: straight from the vertices, or from the clipper, to the kernels. */
static bool submit_faces(const fxl_model_view *model_view, const fxl_traversal *traversal,
                         fxl_face_walk *walk)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_band *band = traversal->band;
    uint32_t submitted = 0, counted = 0;
    fxl_depth_outline outline;
    if (!traversal->draws_one || !workspace->draws_outlines || !traversal->clipper->by_clip_flags ||
        model_view->view->lens.off_centre != NULL ||
        (FXL_PIXEL_IS_MIXED && workspace->screen.shade != 0)) {
        return false;
    }
    const fxl_face *face = walk->next(model_view, walk);
    if (face != NULL) {
        fxl_depth_clear_rest(workspace, band, &FXL_TARGET);
        fxl_depth_outline_of_band((const fxl_depth_head *)workspace->target_memory, band,
                                  FXL_PIXEL_BITS / 8, &outline);
    }
    for (; face != NULL; face = walk->next(model_view, walk)) {
        submitted++;
        outline.filling = fxl_filling_word(fxl_filling_of(band, face->material, 0, 0));
        if (!draw_walked(model_view, face, traversal, &outline)) {
            counted++;
        }
    }
    walk->submitted = submitted;
    traversal->counters->drawn += submitted - counted;
    traversal->counters->spilled += submitted - counted;
    return true;
}

#endif
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

#endif
