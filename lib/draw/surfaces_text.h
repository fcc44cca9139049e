/* SPDX-License-Identifier: MIT */
/* The text of all painters of surfaces. The file that includes this one defines FXL_TARGET,
 * FXL_TARGET_FORMAT and FXL_TARGET_DEPTH_BITS as for target_text.h, and
 *
 *   FXL_TARGET_SURFACES  the painter's name
 *   FXL_TARGET_TEXTURES  that of the painter without colours at corners
 *
 * Internal. */
#ifndef FXL_SURFACES_TEXT_H
#define FXL_SURFACES_TEXT_H

#include "../view/model_view.h"
#include "surface_paint_text.h"
#include "surface_polygon.h"

/* --- a polygon ------------------------------------------------------------------------------ */

#if FXL_TARGET_DEPTH_BITS == 0

/* fxl_row_painter. */
static inline __attribute__((always_inline)) void
paint_row(void *with, const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    if (!FXL_PIXEL_IS_MIXED && !FXL_IS_COMPACT) {
        fxl_paint_simply(with, paint, row, x0, x1);
    } else {
        PAINT_PIXELS(paint, row, x0, x1);
    }
}

/* Returns true if it is known that the polygon reaches a row of the band. */
/* SPEC 10.5, surfaces 4.4 */
static bool paint_surface(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                          const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                          uint32_t count, const fxl_band *band)
{
    fxl_paint paint;
    fxl_segment_face face;
    paint_of(surfaces, polygon, band, &paint);
    const fxl_segment_face *segments = segments_of(&paint, &face);
    if (has_plain_rows(&paint, segments)) {
        fxl_paint_plain_polygon(&paint, segments, points, count, band, FXL_PIXEL_BITS / 8,
                                &workspace->work.scan, PAINT_ROWS, PAINT_PIXELS);
    } else if (FXL_IS_COMPACT || !FXL_PIXEL_IS_MIXED || paint.colours == NULL ||
               !paint.colours->polygon(&paint, points, count, band, &workspace->work.scan)) {
        fxl_paint_polygon(&paint, segments, points, count, band, FXL_PIXEL_BITS / 8,
                          &workspace->work.scan, paint_row, NULL);
    }
    return false;
}

#define FIND_DEPTH  NULL
#define FIND_LINEAR NULL
#define FIND_TEXELS NULL

#else

#include "surface_depth_text.h"
#include "surface_smooth_text.h"

/* Returns true if it is known that the polygon reaches a row of the band. What clears has little of
 * others on the stack below it. */
static bool paint_surface(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                          const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                          uint32_t count, const fxl_band *band)
{
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    if (DRAWS_TEXELS && surface->texture != 0 && fxl_has_texel_words(&polygon->gradients)) {
        return draw_texels(surfaces, workspace, polygon, points, count, band);
    }
    if (fxl_depth_is_in_words(&polygon->depth)) {
        const fxl_depth_drawn drawn =
            draw_smooth(surfaces, workspace, polygon, points, count, band);
        if (drawn != FXL_DEPTH_NOT_DRAWN) {
            return drawn == FXL_DEPTH_DRAWN;
        }
    }
    if (fxl_is_of_other_pass((const fxl_depth_head *)workspace->target_memory, surface)) {
        return false;
    }
    if (polygon->gradients.count == 1) {
        clear_under(workspace, points, count, band);
    } else {
        fxl_depth_clear_rest(workspace, band, &FXL_TARGET);
    }
    return paint_by_rows(surfaces, workspace, polygon, points, count, band);
}

#if FXL_TARGET_DEPTH_BITS == 32
#define FIND_DEPTH  fxl_find_exact_depth
#define FIND_LINEAR NULL
#define FIND_TEXELS NULL
#else
#define FIND_DEPTH  fxl_find_depth
#define FIND_LINEAR fxl_find_smooth_planes
#if FXL_PIXEL_IS_MIXED
#define FIND_TEXELS fxl_find_texels
#else
#define FIND_TEXELS NULL
#endif
#endif

#endif

/* --- a face --------------------------------------------------------------------------------- */

/* fxl_polygon_finder. Of a face that is in the other pass only what paint_surface asks for before it
 * knows that: it has no words. */
static inline __attribute__((always_inline)) void
find(const void *what, const fxl_model_view *model_view, const fxl_face *face,
     const fxl_traversal *traversal, fxl_surface_polygon *polygon)
{
    const fxl_mapped_surface *of = (const fxl_mapped_surface *)what;
#if FXL_TARGET_DEPTH_BITS != 0
    const fxl_depth_head *head = (const fxl_depth_head *)traversal->workspace->target_memory;
    if (head->pass != FXL_DEPTH_ALL && traversal->display_list == NULL &&
        traversal->mode != FXL_SUBMIT_MEASURE &&
        fxl_is_of_other_pass(head, &of->surfaces->set->surfaces[of->mapped->surface])) {
        polygon->surface = of->mapped->surface;
        polygon->gradients.shifts[0] = 0;
        polygon->depth.one = 0;
        return;
    }
#endif
#if FXL_TARGET_DEPTH_BITS == 0 && FXL_IS_COMPACT
    fxl_surface_find(of->surfaces, of->mapped, model_view, face, traversal, polygon);
#else
    fxl_surface_find_deep(of->surfaces, of->mapped, model_view, face, traversal, FIND_DEPTH,
                          FIND_LINEAR, FIND_TEXELS, polygon);
#endif
}

/* fxl_polygon_painter. */
static inline __attribute__((always_inline)) bool
paint_polygon(const void *what, fxl_workspace *workspace, const fxl_surface_polygon *polygon,
              const fxl_screen_point *points, uint32_t count, const fxl_band *band)
{
    return paint_surface(((const fxl_mapped_surface *)what)->surfaces, workspace, polygon, points,
                         count, band);
}

/* The same for a piece of a face: its texels, light and depth are those of the whole face. Not
 * inline: the view of the whole face would stay on the stack while the piece is painted. */
static __attribute__((noinline)) void find_whole(const void *what, const fxl_model_view *model_view,
                                                 const fxl_face *face,
                                                 const fxl_traversal *traversal,
                                                 fxl_surface_polygon *polygon)
{
    const fxl_pieces *pieces = ((const fxl_mapped_surface *)what)->pieces;
    FXL_ALIGN_8 fxl_turned_view view;
    (void)model_view;
    (void)face;
    find(what, fxl_surfaces_view(traversal, pieces->instance, &view), pieces->face, traversal,
         polygon);
}

/* The polygons of a face, or of a piece of one, by what finds what they have. */
FXL_ONCE fxl_outcome submit_polygons(const fxl_model_view *model_view, const fxl_face *face,
                                     const fxl_traversal *traversal, fxl_polygon_finder *finder,
                                     const fxl_mapped_surface *of, fxl_surface_polygon *polygon,
                                     bool found)
{
    return fxl_submit_found_polygons(model_view, face, traversal, finder, paint_polygon, of,
                                     polygon, found);
}

/* fxl_painter.submit_piece. */
static fxl_outcome submit_piece(const fxl_mapped_surface *of, const fxl_model_view *model_view,
                                const fxl_face *piece, const fxl_traversal *traversal)
{
    return submit_polygons(model_view, piece, traversal, find_whole, of, of->polygon, of->is_found);
}

/* A mapped face that no beam reaches. Not inline: what its polygons have would stay on the stack
 * while a face is split. */
static __attribute__((noinline)) bool submit_mapped(const fxl_model_view *model_view,
                                                    const fxl_face *face,
                                                    const fxl_traversal *traversal,
                                                    const fxl_mapped_surface *of)
{
    const uint32_t used = traversal->renderer->frame.display_list.used;
    fxl_surface_polygon polygon;
    return fxl_count_outcome(
        traversal, submit_polygons(model_view, face, traversal, find, of, &polygon, false), used);
}

/* fxl_shader_code.face. */
static bool submit(const fxl_model_view *model_view, const fxl_face *face,
                   const fxl_traversal *traversal, const fxl_shader *shader)
{
    const fxl_surfaces *surfaces = (const fxl_surfaces *)(const void *)shader;
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_mapped_face *mapped;
    const fxl_surface_set *set = surfaces->set;
    uint32_t number = 0;
    if (!FXL_IS_COMPACT && surfaces->beams == NULL && renderer->target == &FXL_TARGET) {
        number = set->face_map[face - renderer->scene->faces];
    }
    if (number != 0) {
        mapped = &set->faces[number - 1];
    } else {
        bool fitted;
        mapped = fxl_surfaces_take(surfaces, model_view, face, traversal, &fitted);
        if (mapped == NULL) {
            return fitted;
        }
    }
    const fxl_mapped_surface of = {surfaces, mapped, NULL, NULL, false};
    return submit_mapped(model_view, face, traversal, &of);
}

#if FXL_DRAWS_SMOOTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16

/* Draws the faces of a walk until one is drawn otherwise, and returns that; null: all are drawn. */
static inline __attribute__((always_inline)) const fxl_face *
draw_faces(const fxl_model_view *model_view, const fxl_traversal *traversal, fxl_face_walk *walk,
           smooth_run *run, bool has_colours)
{
    const fxl_surfaces *surfaces = (const fxl_surfaces *)(const void *)model_view->shader;
    const fxl_surface_set *set = surfaces->set;
    const fxl_face *const faces = traversal->renderer->scene->faces, *face;
    for (; (face = walk->next(model_view, walk)) != NULL; walk->submitted++) {
        const uint32_t number = set->face_map[face - faces];
        const fxl_mapped_face *mapped = &set->faces[number - 1];
        if (number == 0) {
            run->result = IS_OTHER;
            break;
        }
        if (mapped->surface != run->number) {
            begin_run(surfaces, mapped->surface, traversal, run);
        }
        if (run->corners == NULL) {
            run->result = IS_OTHER;
            break;
        }
        const inside_result result =
            draw_inside(surfaces, mapped, model_view, face, traversal, run, has_colours);
        if (result != IS_DRAWN) {
            run->result = result;
            break;
        }
    }
    return face;
}

typedef const fxl_face *faces_drawer(const fxl_model_view *model_view,
                                     const fxl_traversal *traversal, fxl_face_walk *walk,
                                     smooth_run *run);

/* Not inline: what it has would be on the stack of what draws others. A painter without colours at corners
 * links nothing that draws them. */
static __attribute__((noinline)) const fxl_face *draw_inside_faces(const fxl_model_view *model_view,
                                                                   const fxl_traversal *traversal,
                                                                   fxl_face_walk *walk,
                                                                   smooth_run *run)
{
    return draw_faces(model_view, traversal, walk, run, true);
}

/* What the surfaces say is looked up once for all faces of a run. A model whose first face is not drawn at
 * once is not taken. */
static bool submit_walk(const fxl_model_view *model_view, const fxl_traversal *traversal,
                        fxl_face_walk *walk, faces_drawer *draw_inside_of)
{
    const fxl_shader *shader = model_view->shader;
    const fxl_surfaces *surfaces = (const fxl_surfaces *)(const void *)shader;
    const fxl_scene *scene = traversal->renderer->scene;
    const fxl_surface_set *set = surfaces->set;
    smooth_run run;
    if (!traversal->draws_one || surfaces->beams != NULL ||
        traversal->renderer->target != &FXL_TARGET || !traversal->clipper->by_clip_flags ||
        scene->wholes != NULL || walk->left == 0) {
        return false;
    }
    const uint32_t first = set->face_map[walk->face - scene->faces];
    if (first == 0 || walk->face->count != 3) {
        return false;
    }
    run.drawn = run.without_rows = 0;
    run.is_part = traversal->band->rows != model_view->view->lens.height;
    run.light.is_stale = false;
    run.lens = fxl_words_lens_of(&model_view->view->lens);
    run.light.code = surfaces->light != NULL ? surfaces->light_code : NULL;
    begin_run(surfaces, set->faces[first - 1].surface, traversal, &run);
    if (run.corners == NULL) {
        return false;
    }
    if (run.light.code != NULL) {
        run.light.kept = run.light.code->kept_lights(surfaces, traversal);
    }
    const fxl_face *face;
    while ((face = draw_inside_of(model_view, traversal, walk, &run)) != NULL) {
        const fxl_mapped_face *mapped = &set->faces[set->face_map[face - scene->faces] - 1];
        const fxl_mapped_surface of = {surfaces, mapped, NULL, NULL, false};
        if (!(run.result == IS_OTHER ? submit(model_view, face, traversal, shader)
                                     : submit_mapped(model_view, face, traversal, &of))) {
            walk->left++;
            break;
        }
        walk->submitted++;
        if (run.result == IS_OTHER) {
            run.light.is_stale = true;
            renew_kept(surfaces, traversal, &run);
        }
    }
    traversal->counters->drawn += run.drawn;
    traversal->counters->spilled += run.drawn - run.without_rows;
    return true;
}

/* fxl_shader_code.faces */
static bool submit_faces(const fxl_model_view *model_view, const fxl_traversal *traversal,
                         fxl_face_walk *walk)
{
    return submit_walk(model_view, traversal, walk, draw_inside_faces);
}

#if FXL_PIXEL_IS_MIXED

static __attribute__((noinline)) const fxl_face *
draw_textured_faces(const fxl_model_view *model_view, const fxl_traversal *traversal,
                    fxl_face_walk *walk, smooth_run *run)
{
    return draw_faces(model_view, traversal, walk, run, false);
}

static bool submit_textured(const fxl_model_view *model_view, const fxl_traversal *traversal,
                            fxl_face_walk *walk)
{
    return submit_walk(model_view, traversal, walk, draw_textured_faces);
}

#endif

#endif

static void draw(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                 const fxl_screen_polygon *record, const fxl_band *band)
{
    fxl_surface_polygon polygon;
    const uint32_t count = fxl_surface_polygon_read(record, &polygon);
    (void)paint_surface(surfaces, workspace, &polygon, record->points, count, band);
}

static const fxl_shader_code code = {
    .reaches = fxl_surfaces_reach,
    .face = submit,
    .split = fxl_surfaces_split,
    .takes = fxl_surfaces_map,
#if FXL_DRAWS_SMOOTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16
    .faces = submit_faces,
#endif
};

/* The same of the painter without colours at corners. */
#if FXL_DRAWS_SMOOTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16 && FXL_PIXEL_IS_MIXED
static const fxl_shader_code textures_code = {
    .reaches = fxl_surfaces_reach,
    .face = submit,
    .split = fxl_surfaces_split,
    .takes = fxl_surfaces_map,
    .faces = submit_textured,
};
#define TEXTURES_CODE (&textures_code)
#else
#define TEXTURES_CODE (&code)
#endif

const fxl_painter FXL_TARGET_SURFACES = {&FXL_TARGET, &code,        draw,   submit_piece,
                                         find_whole,  FIND_COLOURS, COLOURS};
const fxl_painter FXL_TARGET_TEXTURES = {&FXL_TARGET, TEXTURES_CODE, draw, submit_piece,
                                         find_whole,  NULL,          NULL};

#endif
