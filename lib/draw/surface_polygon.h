/* SPDX-License-Identifier: MIT */
/* A polygon of the screen that has a surface, or a depth: its record in the display list, and its
 * pixels. Internal. */
#ifndef FXL_SURFACE_POLYGON_H
#define FXL_SURFACE_POLYGON_H

#include "../raster/draw_outline.h"
#include "../raster/scan.h"
#include "submit_sorted.h"
#include "submit.h"
#include "fixel/lines.h"
#include "fixel/surfaces.h"
#include "../paint/corner_planes.h"
#include "../paint/depth_row.h"
#include "../paint/light_level.h"
#include "../paint/paint.h"
#include "../paint/smooth_outline.h"
#include "../view/placement.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- light at the corners of faces --------------------------------------------------------- */

/* The light at the three vertices of a mapped face: levels of the ramp in 16.16, and a half, so that
 * rounding them down gives the nearest. From 32768 to levels - 1/2. */
typedef void fxl_corner_light(const fxl_surfaces *surfaces, const fxl_model_view *model_view,
                              const fxl_traversal *traversal, const fxl_corner *const corners[3],
                              int32_t values[3]);

/* What a renderer with lit surfaces links. */
typedef struct fxl_surface_light_code {
    fxl_corner_light *light_corners;
    /* Where light depends on normals alone: the light that is kept, of none yet. It is behind the scan of the
     * workspace, until a face is cut or faces are sorted. Else null. */
    fxl_kept_lights *(*kept_lights)(const fxl_surfaces *surfaces, const fxl_traversal *traversal);
    fxl_kept_light_finder *find_kept;
    fxl_corners_light *corners_of; /* where it does: of all three corners */
    fxl_smooth_drawer *draw_words; /* null where kernels or rows draw polygons in words */
} fxl_surface_light_code;

static inline bool fxl_surface_is_lit(const fxl_surfaces *surfaces, const fxl_surface *surface)
{
    return (surface->flags & FXL_SURFACE_LIT) && surfaces->light != NULL;
}

/* The light of a surface that is lit. */
static inline void fxl_surface_light_of(const fxl_surfaces *surfaces, fxl_paint *paint)
{
    const fxl_light_settings *settings = &surfaces->light->settings;
    paint->ramp = settings->ramp;
    paint->levels_less_1 = (uint8_t)(settings->levels - 1);
}

/* Whether pixels of a lit surface are those of fxl_paint.has_light_rows, all of the face, and need
 * not be divided: planes of words are for these alone. */
static inline bool fxl_has_light_alone(const fxl_surfaces *surfaces, const fxl_surface *surface)
{
    const uint32_t other = surface->texture | (surface->opacity ^ 16u) |
                           (surface->flags ^ (uint32_t)FXL_SURFACE_LIT); /* one branch */
    return other == 0 && surface->division != FXL_DIVIDE_1 && surfaces->beams == NULL;
}

/* Whether texels of a small triangle may be found as words: opaque ones, repeated and without a key,
 * in no beam. */
/* SPEC 9.1.1 */
static inline bool fxl_may_have_words(const fxl_surfaces *surfaces, const fxl_surface *surface,
                                      const fxl_texture *texture)
{
    const uint32_t other =
        (surface->opacity ^ 16u) | (surface->flags & ~(uint32_t)FXL_SURFACE_LIT) | texture->flags;
    return other == 0 && texture->format != FXL_TEXTURE_4 && surfaces->beams == NULL &&
           (surface->division == FXL_DIVIDE_16 || surface->division == FXL_AFFINE);
}

#define FXL_NO_SURFACE UINT16_MAX
FXL_STATIC_ASSERT(FXL_SURFACES_MAX <= FXL_NO_SURFACE, "no surface has this number");

static inline bool fxl_surface_is_blended(const fxl_surface *surface)
{
    return (surface->flags & (FXL_SURFACE_BLEND | FXL_SURFACE_ADD)) != 0;
}

/* Whether a depth buffer's band is drawn in two passes, and what has this surface in the other one. */
/* SPEC 10.5, surfaces 4.4 */
static inline bool fxl_is_of_other_pass(const fxl_depth_head *head, const fxl_surface *surface)
{
    return head->pass == (fxl_surface_is_blended(surface) ? FXL_DEPTH_OPAQUE : FXL_DEPTH_BLENDED);
}

/* What a polygon has beside its outline. */
typedef struct {
    fxl_gradients gradients; /* where it has a surface */
    fxl_depth_plane depth;   /* where it has one */
    uint16_t surface;        /* a number; FXL_NO_SURFACE: the face's own colour */
    uint8_t level;           /* of its texture; u and v are in texels of that level */
    uint8_t colour;          /* of the face */
    uint8_t shade;           /* of a face without a surface: as of fxl_screen_polygon */
    bool has_depth;
    bool is_in_beam;    /* it is a lit piece */
    bool is_evenly_lit; /* it has a texture, and the same light everywhere: no attribute of light */
    uint16_t light;     /* then: in 1/256 level, and a half level */
} fxl_surface_polygon;

/* What a face with a surface is found and painted by. */
typedef struct {
    const fxl_surfaces *surfaces;
    const fxl_mapped_face *mapped;
    /* Where a piece of the face is drawn: */
    const fxl_pieces *pieces;
    fxl_surface_polygon *polygon; /* what all pieces of the face have beside their outlines */
    bool is_found;                /* what that is */
} fxl_mapped_surface;

/* fxl_find_colours: what a painter of RGB565 links. */
typedef bool fxl_colours_finder(const fxl_surfaces *surfaces, const fxl_corner *const mapped[3],
                                const fxl_corner_planes *planes, bool is_affine, bool is_coarse,
                                fxl_gradient_corners *corners, fxl_gradients *gradients);

/* The attributes of a face with colours at its corners. On entry the first one of corners->values
 * is light, if their count is not 0. planes: of the face, where it has some and is not divided at
 * each pixel; else null. is_affine, is_coarse: as of fxl_corner_colours_linear. Returns true if *gradients are found, as fxl_corner_colours_linear has them. */
fxl_colours_finder fxl_find_colours;

/* What draws the faces that have surfaces into a target: a constant record for each target. */
struct fxl_painter {
    const fxl_target *target;
    /* Takes the faces of a renderer. Those without a surface go to the next shader. */
    const fxl_shader_code *code;
    /* Draws a record of the kind FXL_POLYGON_SURFACE into a band. */
    void (*draw)(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                 const fxl_screen_polygon *record, const fxl_band *band);
    /* Submits a piece of a mapped face; model_view: of the piece's points. */
    fxl_outcome (*submit_piece)(const fxl_mapped_surface *of, const fxl_model_view *model_view,
                                const fxl_face *piece, const fxl_traversal *traversal);
    /* fxl_polygon_finder of pieces: finds what all pieces of a face have. */
    void (*find)(const void *what, const fxl_model_view *model_view, const fxl_face *face,
                 const fxl_traversal *traversal, fxl_surface_polygon *polygon);
    /* Null where no surface has colours at corners. */
    fxl_colours_finder *find_colours;
    const fxl_colours_code *colours;
};

/* The three corners of a mapped face of a surface. */
static inline void fxl_find_mapped_corners(const fxl_surface_set *set, const fxl_surface *surface,
                                           const fxl_mapped_face *mapped,
                                           const fxl_corner *corners[3])
{
    const fxl_corner *first = set->corners + surface->first_corner;
    corners[0] = &first[mapped->corners[0]];
    corners[1] = &first[mapped->corners[1]];
    corners[2] = &first[mapped->corners[2]];
}

/* fxl_renderer_shader, once in a program: the record that begins with the shader. */
const void *fxl_find_shader(const fxl_renderer *renderer, uint32_t rank);

/* fxl_target_extras.draw_display_list. */
bool fxl_mixed_draw_list(const fxl_traversal *traversal);

/* A corner of a face in the view, by the matrix of its instance. A clipper by clip flags keeps the
 * same positions in the cache. */
void fxl_find_corner(const fxl_model_view *model_view, uint32_t number,
                     const fxl_traversal *traversal, fxl_view_point *corner);

/* Where all vertices of a whole face can be projected, between the near and the far plane, and the
 * given three are some of them: these three on the screen, and the box of all; false otherwise, and
 * *corners is undefined. Requires the model view of the face's instance. */
bool fxl_find_screen_corners(const fxl_model_view *model_view, const fxl_face *face,
                             const fxl_corner *const of[3], const fxl_traversal *traversal,
                             fxl_screen_corners *corners);

#if FXL_DRAWS_SMOOTH_OUTLINES

/* fxl_clip_by_view of a triangle, and its vertices on the screen with their box: of one that it
 * answers FXL_CLIP_INSIDE for. Also FXL_CLIP_BETWEEN; FXL_CLIP_CUT stands for any other answer. */
fxl_clip_result fxl_find_inside_corners(const fxl_model_view *model_view, const fxl_face *face,
                                        fxl_inside_corners *corners);

#endif

/* Whether all three corners are on the screen, not beside it. */
static inline bool fxl_corners_are_on_screen(const fxl_screen_corners *corners,
                                             const fxl_lens *lens)
{
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_screen_point *point = &corners->points[i];
        if (point->x < 0 || point->x > lens->width * 65536 || point->y < 0 ||
            point->y > lens->height * 65536) {
            return false;
        }
    }
    return true;
}

/* Appends a polygon that reaches the given rows of the screen to the display list. Returns false if
 * it does not fit: list untouched. */
bool fxl_surface_polygon_append(fxl_display_list *list, const fxl_screen_polygon *screen,
                                fxl_rows rows, const fxl_surface_polygon *polygon);

/* How many points of a record of the kind FXL_POLYGON_SURFACE or FXL_POLYGON_DEPTH are the
 * outline's: the byte that is the shade of others. */
static inline uint32_t fxl_surface_polygon_points(const fxl_screen_polygon *record)
{
    return record->shade;
}

/* The target of a renderer as painters know it, with outlines or without. */
static inline const fxl_target *fxl_painted_target(const fxl_renderer *renderer)
{
    const fxl_target *target = renderer->target;
    return target->extras != NULL && target->extras->outlined != NULL ? target->extras->outlined
                                                                      : target;
}

/* The edges of a polygon that was painted into the band, where the renderer has outlines. */
static inline void fxl_outline_polygon(const fxl_traversal *traversal,
                                       const fxl_screen_point *points, uint32_t count)
{
    const fxl_target_extras *extras = traversal->renderer->target->extras;
    if (extras != NULL && extras->outline != NULL) {
        extras->outline(traversal->workspace, points, count, traversal->band);
    }
}

/* Reads a record of the kind FXL_POLYGON_SURFACE or FXL_POLYGON_DEPTH. Returns how many of its
 * points are the outline's. */
uint32_t fxl_surface_polygon_read(const fxl_screen_polygon *record, fxl_surface_polygon *polygon);

/* How a polygon that has a surface is painted. */
void fxl_surface_paint_of(const fxl_surfaces *surfaces, const fxl_surface_polygon *polygon,
                          fxl_paint *paint);

/* fxl_find_depth: what a painter with a depth buffer links. planes: of the face, where it is small,
 * or has_words and sides up to FXL_WORDS_SIDE_MAX; else null. has_words: its attributes are words,
 * so its depth may be words too. */
typedef void fxl_depth_finder(const fxl_model_view *model_view, const fxl_face *face,
                              const fxl_traversal *traversal, fxl_corner_planes *planes,
                              bool has_words, fxl_depth_plane *plane);

/* fxl_find_smooth_planes: what a painter with a depth buffer of 16 bits links. */
typedef bool fxl_linear_finder(const fxl_screen_corners *corners, const fxl_lens *lens,
                               const int32_t light[3], fxl_gradients *gradients,
                               fxl_depth_plane *depth);

/* What a face with a surface has beside its outlines, without depth: in a library for size. */
void fxl_surface_find(const fxl_surfaces *surfaces, const fxl_mapped_face *mapped,
                      const fxl_model_view *model_view, const fxl_face *face,
                      const fxl_traversal *traversal, fxl_surface_polygon *polygon);

/* The same with depth. find_depth: null: it has none. find_linear, find_texels: null: planes are never found as words. */
void fxl_surface_find_deep(const fxl_surfaces *surfaces, const fxl_mapped_face *mapped,
                           const fxl_model_view *model_view, const fxl_face *face,
                           const fxl_traversal *traversal, fxl_depth_finder *find_depth,
                           fxl_linear_finder *find_linear, fxl_texels_finder *find_texels,
                           fxl_surface_polygon *polygon);

/* The view of an instance, turned or not, in which the corners of a whole face are found where
 * pieces of it are drawn. view: room for it. */
const fxl_model_view *fxl_surfaces_view(const fxl_traversal *traversal,
                                        const fxl_instance *instance, fxl_turned_view *view);

/* fxl_shader_code.takes of all painters: whether a face has a surface. */
bool fxl_surfaces_map(const fxl_shader *shader, const fxl_renderer *renderer, const fxl_face *face);

/* fxl_shader_code.split of all painters. */
bool fxl_surfaces_split(const fxl_shader *shader, fxl_pieces *pieces, const fxl_face *face,
                        const fxl_point *points, uint32_t count);

/* The mapped face of a face that is to be submitted whole. Null: the face has been submitted, in
 * pieces of beams, or by the next shader, and *fitted is whether there was room. */
const fxl_mapped_face *fxl_surfaces_take(const fxl_surfaces *surfaces,
                                         const fxl_model_view *model_view, const fxl_face *face,
                                         const fxl_traversal *traversal, bool *fitted);

/* fxl_shader_code.reaches of all painters. */
bool fxl_surfaces_reach(const fxl_shader *shader, const fxl_scene *scene,
                        const fxl_instance *instance);

/* The surfaces of a renderer that has some; or null. */
static inline const fxl_surfaces *fxl_surfaces_of(const fxl_renderer *renderer)
{
    const fxl_shader *first = renderer->shader;
    return first != NULL && first->rank == FXL_SHADER_SURFACES
               ? (const fxl_surfaces *)(const void *)first
               : NULL;
}

/* --- polygons of a face -------------------------------------------------------------------- */

/* The polygons of a face that have more than an outline, to the display list or into the band. The
 * callers differ in what that is, and in what paints it; both are inlined. */

/* Finds what a face's polygons have beside their outlines; what: the finder's own. */
typedef void fxl_polygon_finder(const void *what, const fxl_model_view *model_view,
                                const fxl_face *face, const fxl_traversal *traversal,
                                fxl_surface_polygon *polygon);

/* Paints a polygon in a band; what: as above. Returns true if it is known that it reaches a row. */
typedef bool fxl_polygon_painter(const void *what, fxl_workspace *workspace,
                                 const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                                 uint32_t count, const fxl_band *band);

/* Paints a polygon in the band. One that has no row there may have one on the rest of the screen,
 * which is all that counts. */
static inline __attribute__((always_inline)) fxl_outcome
fxl_draw_polygon(const fxl_traversal *traversal, const fxl_surface_polygon *polygon,
                 fxl_polygon_painter *paint, const void *what)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_screen_polygon *screen = &workspace->screen;
    if (!paint(what, workspace, polygon, screen->points, screen->count, traversal->band) &&
        !fxl_outline_has_rows(screen, traversal->renderer->frame.view.lens.height)) {
        return 0;
    }
    fxl_outline_polygon(traversal, screen->points, screen->count);
    return FXL_OUTCOME_SPILLED;
}

/* A polygon to the display list, or its rows to what is measured. */
static inline __attribute__((always_inline)) fxl_outcome
fxl_emit_polygon(const fxl_traversal *traversal, const fxl_surface_polygon *polygon)
{
    const fxl_rows rows =
        fxl_scan_rows(&traversal->workspace->screen, traversal->renderer->frame.view.lens.height);
    if (rows.first == rows.end) {
        return 0;
    }
    if (traversal->display_list != NULL) {
        return fxl_surface_polygon_append(traversal->display_list, &traversal->workspace->screen,
                                          rows, polygon)
                   ? 0
                   : FXL_OUTCOME_FULL;
    }
    fxl_rows_add(traversal->reached, rows);
    return FXL_OUTCOME_SPILLED;
}

/* All polygons of a face: fxl_submit_polygons. Once one of them is left that may cover a pixel, it
 * is found what they have, unless *polygon has it already. */
static inline __attribute__((always_inline)) fxl_outcome
fxl_submit_found_polygons(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *traversal, fxl_polygon_finder *find,
                          fxl_polygon_painter *paint, const void *what,
                          fxl_surface_polygon *polygon, bool found)
{
    const bool draws = traversal->display_list == NULL && traversal->mode != FXL_SUBMIT_MEASURE;
    fxl_clip_result cut = fxl_first_polygon(model_view, face, traversal);
    fxl_outcome outcome = (fxl_outcome)1 << cut;
    while (cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT) {
        if (!found) {
            find(what, model_view, face, traversal, polygon);
            found = true;
        }
        outcome |= draws ? fxl_draw_polygon(traversal, polygon, paint, what)
                         : fxl_emit_polygon(traversal, polygon);
        if (traversal->clipper->next == NULL || outcome >= FXL_OUTCOME_FULL) {
            break;
        }
        cut = fxl_next_polygon(model_view, traversal);
        outcome |= (fxl_outcome)1 << cut;
    }
    return outcome;
}

/* --- depth --------------------------------------------------------------------------------- */

/* The depth of a face: of a small one that of its corners (corner_planes.h), of any other that of
 * its normal. */
fxl_depth_finder fxl_find_depth;

/* That of its normal for all faces: where depths have 32 bits, the rounding of corners would show.
 */
fxl_depth_finder fxl_find_exact_depth;

/* The depth of the plane through the face's first corner with the face's normal. A face that is
 * seen edge-on, to within the rounding of its normal, is at infinity. Error: the normal is off by
 * less than 2^-28, and the depth of the plane relatively by less than 2^-27. */
void fxl_find_depth_by_normal(const fxl_model_view *model_view, const fxl_face *face,
                              const fxl_traversal *traversal, fxl_depth_plane *plane);

/* Before a polygon of the rows first <= y < end is painted: clears those of their cells that are in
 * the band and not cleared yet, and all between these and the cleared ones. So rows that nothing
 * reaches are not cleared. */
void fxl_depth_clear(fxl_workspace *workspace, const fxl_band *band, int32_t first, int32_t end,
                     const fxl_target *target);

/* The same for all rows of the band. */
void fxl_depth_clear_all(fxl_workspace *workspace, const fxl_band *band, const fxl_target *target);

/* Before a face of one colour or with a texture, or a billboard, is painted: these mostly come in
 * numbers that reach all rows, so they clear what is left at once. */
static inline void fxl_depth_clear_rest(fxl_workspace *workspace, const fxl_band *band,
                                        const fxl_target *target)
{
    const fxl_depth_head *head = (const fxl_depth_head *)workspace->target_memory;
    if (head->clear_from != FXL_DEPTH_ALL_CLEAR) {
        fxl_depth_clear_all(workspace, band, target);
    }
}

/* fxl_target.draw_band: as many rows at a time as the workspace has cells for. Far to near
 * each part is drawn in two passes: what is opaque, then what is blended. */
void fxl_depth_draw_parts(const fxl_renderer *renderer, fxl_workspace *workspace,
                          const fxl_band *band);

#ifdef __cplusplus
}
#endif

#endif
