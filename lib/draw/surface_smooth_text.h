/* SPDX-License-Identifier: MIT */
/* The kernel of smooth outlines draws polygons whose planes are in words, in a target with a depth
 * buffer of 16 bits. A part of surfaces_text.h. Internal. */
#ifndef FXL_SURFACE_SMOOTH_TEXT_H
#define FXL_SURFACE_SMOOTH_TEXT_H

#include "../paint/smooth_outline.h"
#include "surface_depth_text.h"

#if FXL_DRAWS_SMOOTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16

/* Draws a polygon by the kernel of smooth outlines: an opaque one that is lit and in no beam, whose
 * planes are in words, where the kernel can draw. What it needs of a paint is found here alone. Not
 * inline: what it has would stay on the stack of others. */
static __attribute__((noinline)) fxl_depth_drawn
draw_words(const fxl_surfaces *surfaces, fxl_workspace *workspace,
           const fxl_surface_polygon *polygon, uint8_t colour, const fxl_screen_point *points,
           uint32_t count, const fxl_band *band)
{
    fxl_smooth_outline smooth;
    fxl_paint paint;
    fxl_surface_light_of(surfaces, &paint);
    paint.gradients = &polygon->gradients;
    paint.colour = colour;
    mix_light(surfaces, band, &paint);
    fxl_smooth_outline_set((const fxl_depth_head *)workspace->target_memory, &polygon->depth,
                           &paint, band, FXL_PIXEL_BITS / 8, &smooth);
    return FXL_DRAW_SMOOTH(points, count, band, &smooth);
}

/* The same, whether the cells of its rows are cleared or not. */
static inline fxl_depth_drawn clear_and_draw_words(const fxl_surfaces *surfaces,
                                                   fxl_workspace *workspace,
                                                   const fxl_surface_polygon *polygon,
                                                   uint8_t colour, const fxl_screen_point *points,
                                                   uint32_t count, const fxl_band *band)
{
    const fxl_depth_drawn drawn =
        draw_words(surfaces, workspace, polygon, colour, points, count, band);
    if (drawn != FXL_DEPTH_NOT_CLEAR) {
        return drawn;
    }
    clear_under(workspace, points, count, band);
    return draw_words(surfaces, workspace, polygon, colour, points, count, band);
}

/* Whether the kernel of smooth outlines can draw into a band. */
static inline bool can_draw_smooth(const fxl_workspace *workspace, const fxl_band *band)
{
    return fxl_depth_outline_can_draw((const fxl_depth_head *)workspace->target_memory, band,
                                      FXL_PIXEL_BITS / 8);
}

#if FXL_PIXEL_IS_MIXED

/* The same of an outline with colours at its corners, which is opaque, by the kernel of colours: it leaves
 * an outline as it was where rows are not clear. */
static inline __attribute__((always_inline)) fxl_depth_drawn
draw_colours(const fxl_colours_code *code, fxl_workspace *workspace,
             const fxl_colour_outline *outline, const fxl_screen_point *points, uint32_t count,
             const fxl_band *band)
{
    const fxl_depth_drawn drawn = code->outline(points, count, band, outline);
    if (drawn != FXL_DEPTH_NOT_CLEAR) {
        return drawn;
    }
    fxl_depth_clear_rest(workspace, band, &FXL_TARGET);
    return code->outline(points, count, band, outline);
}

/* The same of a polygon. Not inline: its outline would be on the stack of others. */
static __attribute__((noinline)) fxl_depth_drawn
draw_colour_polygon(const fxl_colours_code *code, fxl_workspace *workspace,
                    const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                    uint32_t count, const fxl_band *band)
{
    fxl_colour_outline outline;
    fxl_colour_outline_set((const fxl_depth_head *)workspace->target_memory, &polygon->depth,
                           &polygon->gradients, band, &outline);
    return draw_colours(code, workspace, &outline, points, count, band);
}

#endif

/* Draws any polygon in words by the kernel for it, where that can. */
static inline fxl_depth_drawn draw_smooth(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                                          const fxl_surface_polygon *polygon,
                                          const fxl_screen_point *points, uint32_t count,
                                          const fxl_band *band)
{
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    if (surface->opacity != 16 || fxl_surface_is_blended(surface) ||
        !can_draw_smooth(workspace, band)) {
        return FXL_DEPTH_NOT_DRAWN;
    }
#if FXL_PIXEL_IS_MIXED
    if (surface->flags & FXL_SURFACE_COLOURS) {
        return draw_colour_polygon(surfaces->painter->colours, workspace, polygon, points, count,
                                   band);
    }
#endif
    if (polygon->is_in_beam || !fxl_surface_is_lit(surfaces, surface)) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    return clear_and_draw_words(surfaces, workspace, polygon, polygon->colour, points, count, band);
}

/* How light at corners is found for the faces of a walk. */
typedef struct {
    const fxl_surface_light_code *code; /* null where nothing is lit */
    fxl_kept_lights *kept;              /* undefined then; null where none can be kept */
    bool is_stale;                      /* a face was cut since: nothing is kept any more */
} run_light;

/* fxl_corner_light of all three corners, without what is kept. */
static inline void find_lights_at_once(const fxl_surfaces *surfaces,
                                       const fxl_model_view *model_view,
                                       const fxl_traversal *traversal,
                                       const fxl_corner *const of[3], const run_light *run,
                                       int32_t light[3])
{
    if (run->kept != NULL) {
        run->code->corners_of(&surfaces->light->settings, surfaces->set->normals, of, light);
    } else {
        run->code->light_corners(surfaces, model_view, traversal, of, light);
    }
}

/* The same by what is kept, or in a palette without it, which takes fewer bytes. */
static inline __attribute__((always_inline)) void
find_corner_light(const fxl_surfaces *surfaces, const fxl_model_view *model_view,
                  const fxl_traversal *traversal, const fxl_corner *const of[3],
                  const run_light *run, int32_t light[3])
{
    fxl_kept_lights *kept = run->kept;
    if (!FXL_PIXEL_IS_MIXED || kept == NULL) {
        find_lights_at_once(surfaces, model_view, traversal, of, run, light);
        return;
    }
    fxl_kept_light_finder *const find = run->code->find_kept;
    light[0] = fxl_kept_light(surfaces, of[0]->normal, kept, find);
    light[1] = fxl_kept_light(surfaces, of[1]->normal, kept, find);
    light[2] = fxl_kept_light(surfaces, of[2]->normal, kept, find);
}

/* Whether pixels of a surface are those of the kernel of colours, which have no texture, and need not
 * be divided. */
static inline bool has_colours_alone(const fxl_surfaces *surfaces, const fxl_surface *surface)
{
    const uint32_t flags = surface->flags & ~(uint32_t)FXL_SURFACE_LIT;
    return FXL_PIXEL_IS_MIXED && flags == FXL_SURFACE_COLOURS && surface->opacity == 16 &&
           surface->division != FXL_DIVIDE_1 && surfaces->beams == NULL;
}

/* Whether what the clipper leaves of a mapped face is drawn at once, as one polygon, by the kernel
 * of smooth outlines if its planes are in words. */
static inline bool may_be_smooth(const fxl_surfaces *surfaces, const fxl_surface *surface,
                                 const fxl_traversal *traversal)
{
    return surface->texture == 0 && traversal->draws_one &&
           (has_colours_alone(surfaces, surface) ||
            (surfaces->light != NULL && fxl_has_light_alone(surfaces, surface))) &&
           can_draw_smooth(traversal->workspace, traversal->band);
}

#include "surface_mapped_text.h"

/* What became of a triangle of a walk. */
typedef enum {
    IS_DRAWN,    /* and counted */
    IS_OTHER,    /* it is no triangle, or not inside all planes */
    HAS_NO_WORDS /* its planes are no words, or the kernel cannot scan it */
} inside_result;

/* What the pixels of its faces have. */
typedef enum {
    HAS_LIGHT,
    HAS_COLOURS,
    HAS_TEXELS
} inside_kind;

/* What the faces of a walk that come one after the other with the same surface share. */
typedef struct {
    uint32_t drawn,
        without_rows; /* of all faces of the walk: those drawn here, and that reach no row */
    const fxl_corner *corners; /* of the surface; null: its faces are not drawn at once */
    const fxl_surface *surface;
    uint32_t number;      /* of the surface */
    bool is_part;         /* the band has not all rows of the screen */
    inside_result result; /* of the face that was not drawn */
    inside_kind kind;
    bool has_values; /* colours at corners are lit, or may be asked to bend at will: set_colours */
    int32_t colour; /* of faces of one colour: that of the face before; below 0: there is none */
    fxl_words_lens lens;
    run_light light;
    union {
        struct {
            fxl_smooth_outline outline;
            int32_t one; /* of the depth plane of the face before; 0: there is none */
        } smooth;
        fxl_colour_face colours;
#if FXL_PIXEL_IS_MIXED
        texel_run texels;
#endif
    } outline;
} smooth_run;

/* What light needs of a paint. */
static inline void find_light_paint(const fxl_surfaces *surfaces, const fxl_band *band,
                                    fxl_paint *paint)
{
    fxl_surface_light_of(surfaces, paint);
    mix_light(surfaces, band, paint);
}

/* Light that was kept before a face was cut is forgotten where it would be asked for. */
static inline void renew_kept(const fxl_surfaces *surfaces, const fxl_traversal *traversal,
                              smooth_run *run)
{
    if (run->light.is_stale && run->kind == HAS_LIGHT) {
        run->light.kept = run->light.code->kept_lights(surfaces, traversal);
        run->light.is_stale = false;
    }
}

/* Not inline: its paint would be on the stack of others. */
static __attribute__((noinline)) void begin_run(const fxl_surfaces *surfaces, uint32_t number,
                                                const fxl_traversal *traversal, smooth_run *run)
{
    const fxl_surface *surface = &surfaces->set->surfaces[number];
    const fxl_depth_head *head = (const fxl_depth_head *)traversal->workspace->target_memory;
    const fxl_band *band = traversal->band;
    run->number = number;
    run->surface = surface;
    run->corners = NULL;
    run->colour = -1;
#if FXL_PIXEL_IS_MIXED
    if (may_be_texels(surfaces, surface, traversal)) {
        run->corners = surfaces->set->corners + surface->first_corner;
        run->kind = HAS_TEXELS;
        begin_texels(surfaces, surface, traversal, &run->outline.texels);
        return;
    }
#endif
    if (!may_be_smooth(surfaces, surface, traversal)) {
        return;
    }
    run->corners = surfaces->set->corners + surface->first_corner;
#if FXL_PIXEL_IS_MIXED
    if (surface->flags & FXL_SURFACE_COLOURS) {
        run->kind = HAS_COLOURS;
        fxl_colour_outline_of_band(head, band, &run->outline.colours.outline);
        run->outline.colours.is_lit = fxl_surface_is_lit(surfaces, surface);
        run->outline.colours.limit =
            surface->division == FXL_DIVIDE_8 ? FXL_BEND_FINE : FXL_BEND_NONE;
        run->has_values = run->outline.colours.is_lit || surface->division == FXL_AFFINE;
        return;
    }
#endif
    fxl_paint paint;
    find_light_paint(surfaces, band, &paint);
    run->kind = HAS_LIGHT;
    renew_kept(surfaces, traversal, run);
    run->outline.smooth.one = 0;
    fxl_smooth_outline_of_band(head, &paint, band, FXL_PIXEL_BITS / 8,
                               &run->outline.smooth.outline);
}

static inline __attribute__((always_inline)) fxl_depth_drawn
draw_inside_light(const fxl_surfaces *surfaces, const fxl_corner *const of[3],
                  const fxl_inside_corners *corners, const fxl_model_view *model_view,
                  const fxl_face *face, const fxl_traversal *traversal, smooth_run *run)
{
    const fxl_band *band = traversal->band;
    const fxl_depth_head *head = (const fxl_depth_head *)traversal->workspace->target_memory;
    fxl_smooth_outline *smooth = &run->outline.smooth.outline;
    int32_t light[3];
    find_corner_light(surfaces, model_view, traversal, of, &run->light, light);
    const int32_t one = fxl_find_smooth_words(&corners->corners, &run->lens, light, &smooth->words);
    if (one == 0) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    if (face->material != run->colour) {
        run->colour = face->material;
        fxl_paint paint;
        find_light_paint(surfaces, band, &paint);
        fxl_smooth_outline_of_colour(&paint, face->material, FXL_PIXEL_BITS / 8, smooth);
    }
    if (one != run->outline.smooth.one) {
        run->outline.smooth.one = one;
        fxl_smooth_outline_of_one(head, one & ~FXL_WORDS_HAVE_MEAN, FXL_PIXEL_BITS / 8, smooth);
        smooth->small_rows = fxl_smooth_small_rows(one);
    }
    smooth->words.light += fxl_smooth_light_more(FXL_PIXEL_BITS / 8, smooth);
    return FXL_DRAW_SMOOTH_FACE(corners, band, smooth);
}

#if FXL_PIXEL_IS_MIXED

/* Finds the light at the corners of a lit face with colours, and how far an affine one may bend. Not inline:
 * other faces would keep for it what they need not. */
static __attribute__((noinline)) void
set_colours(const fxl_surfaces *surfaces, const fxl_corner *const of[3],
            const fxl_inside_corners *corners, const fxl_model_view *model_view,
            const fxl_traversal *traversal, smooth_run *run)
{
    fxl_colour_face *face = &run->outline.colours;
    if (face->is_lit) {
        int32_t light[3];
        fxl_corner_colours(of, face->values);
        run->light.code->light_corners(surfaces, model_view, traversal, of, light);
        fxl_corner_colours_light(&surfaces->light->settings, light, face->values);
    }
    if (run->surface->division == FXL_AFFINE) {
        face->limit = fxl_corners_are_on_screen(&corners->corners, &model_view->view->lens)
                          ? FXL_BEND_ANY
                          : FXL_BEND_NONE;
    }
}

/* A triangle of the run with colours at its corners. */
static inline __attribute__((always_inline)) fxl_depth_drawn
draw_inside_colours(const fxl_surfaces *surfaces, const fxl_corner *const of[3],
                    const fxl_inside_corners *corners, const fxl_model_view *model_view,
                    const fxl_traversal *traversal, smooth_run *run)
{
    if (run->has_values) {
        set_colours(surfaces, of, corners, model_view, traversal, run);
    }
    if (!fxl_find_colour_planes(&corners->corners, &run->lens, of, &run->outline.colours)) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    return draw_colours(COLOURS, traversal->workspace, &run->outline.colours.outline,
                        corners->corners.points, 3, traversal->band);
}

/* A triangle of less than a pixel whose planes are no words, if it covers no centre: such a thin one takes
 * as many instructions as one of rows and pixels otherwise. FXL_DEPTH_NOT_DRAWN of any other.
 * Not inline: its edges would be on the stack of others. Edges are below 2^26. */
static __attribute__((noinline)) fxl_depth_drawn
draw_no_centre(const fxl_screen_point p[3], const fxl_traversal *traversal)
{
    fxl_scan *scan = &traversal->workspace->work.scan;
    const int64_t area = fxl_product(p[1].x - p[0].x, p[2].y - p[0].y) -
                         fxl_product(p[2].x - p[0].x, p[1].y - p[0].y);
    const fxl_trapezoid *trapezoid;
    fxl_depth_drawn drawn = FXL_DEPTH_NO_ROW;
    if (fxl_magnitude(area) >> 33 != 0) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    fxl_scan_outline(p, 3, traversal->band, scan);
    if (!scan->by_chains) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
        for (int32_t y = trapezoid->first_row; y < trapezoid->end_row; y++) {
            if (a.x != b.x) {
                return FXL_DEPTH_NOT_DRAWN;
            }
            fxl_edge_step(&a);
            fxl_edge_step(&b);
        }
        drawn = FXL_DEPTH_DRAWN;
    }
    return drawn;
}

#endif

/* place fill-rule: the rows of a triangle, by its box */
/* The first row of a triangle inside all planes, and the row after its last. */
static inline int32_t first_row_of(const fxl_inside_corners *inside)
{
    return fxl_first_centre_from(inside->least.y);
}

static inline int32_t end_row_of(const fxl_inside_corners *inside)
{
    return fxl_first_centre_from(inside->least.y + inside->corners.height);
}

static inline bool has_rows(const fxl_inside_corners *inside)
{
    return first_row_of(inside) != end_row_of(inside);
}

/* Whether no row of it is in the band. Not inline: bands of all rows need no register for it. */
static __attribute__((noinline)) bool is_beside(const fxl_inside_corners *inside,
                                                const fxl_band *band)
{
    return first_row_of(inside) >= band->first_row + band->rows ||
           end_row_of(inside) <= band->first_row;
}

/* A triangle of the run, from its vertices to its pixels, if it lies inside all planes and its planes
 * are words. has_colours: whether a surface may have some at corners. */
static inline __attribute__((always_inline)) inside_result
draw_inside(const fxl_surfaces *surfaces, const fxl_mapped_face *mapped,
            const fxl_model_view *model_view, const fxl_face *face, const fxl_traversal *traversal,
            smooth_run *run, bool has_colours)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_corner *const of[3] = {&run->corners[mapped->corners[0]],
                                     &run->corners[mapped->corners[1]],
                                     &run->corners[mapped->corners[2]]};
    fxl_inside_corners inside;
    const fxl_screen_corners *corners = &inside.corners;
    (void)has_colours; /* a frame of a palette has none */
    if (face->count != 3 || face->indices[0] != of[0]->vertex ||
        face->indices[1] != of[1]->vertex || face->indices[2] != of[2]->vertex) {
        return IS_OTHER;
    }
    const fxl_clip_result cut = fxl_find_inside_corners(model_view, face, &inside);
    if (cut != FXL_CLIP_INSIDE) {
        return cut == FXL_CLIP_BETWEEN &&
                       fxl_count_outcome(traversal, (fxl_outcome)1 << FXL_CLIP_BETWEEN, 0)
                   ? IS_DRAWN
                   : IS_OTHER;
    }
    fxl_depth_drawn drawn;
    if (run->is_part && is_beside(&inside, traversal->band)) {
        drawn = FXL_DEPTH_NO_ROW;
    } else
#if FXL_PIXEL_IS_MIXED
        if (run->kind == HAS_TEXELS) {
        drawn = draw_texel_corners(surfaces, run->surface, of, corners, model_view, traversal,
                                   &run->lens, &run->light, &run->outline.texels);
    } else if (has_colours && run->kind == HAS_COLOURS) {
        drawn = draw_inside_colours(surfaces, of, &inside, model_view, traversal, run);
    } else
#endif
    {
        drawn = draw_inside_light(surfaces, of, &inside, model_view, face, traversal, run);
        if (drawn == FXL_DEPTH_NOT_CLEAR) {
            clear_under(workspace, corners->points, 3, traversal->band);
            drawn = FXL_DRAW_SMOOTH_FACE(&inside, traversal->band, &run->outline.smooth.outline);
        }
    }
    if (drawn != FXL_DEPTH_DRAWN) {
#if FXL_PIXEL_IS_MIXED
        if (drawn == FXL_DEPTH_NOT_DRAWN) {
            drawn = draw_no_centre(corners->points, traversal);
        }
#endif
        if (drawn == FXL_DEPTH_NOT_DRAWN) {
            return HAS_NO_WORDS;
        }
        run->without_rows += !has_rows(&inside);
    }
    run->drawn++;
    return IS_DRAWN;
}

#elif FXL_DRAWS_SMOOTH_WORDS && FXL_TARGET_DEPTH_BITS == 16

/* Draws a polygon in words as the kernel does: an opaque one that is lit and in no beam. Not inline: what
 * it has would be on the stack of others. */
static __attribute__((noinline)) fxl_depth_drawn draw_smooth(const fxl_surfaces *surfaces,
                                                             fxl_workspace *workspace,
                                                             const fxl_surface_polygon *polygon,
                                                             const fxl_screen_point *points,
                                                             uint32_t count, const fxl_band *band)
{
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    const fxl_depth_head *head = (const fxl_depth_head *)workspace->target_memory;
    fxl_scan *scan = &workspace->work.scan;
    fxl_paint paint;
    if (!fxl_has_light_alone(surfaces, surface) || surfaces->light == NULL || head->or_equal) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    fxl_scan_outline(points, count, band, scan);
    if (!fxl_scan_reaches(scan, band)) {
        return FXL_DEPTH_NO_ROW;
    }
    fxl_depth_clear(workspace, band, scan->outline_first, scan->outline_end,
                    &FXL_TARGET);
    fxl_surface_light_of(surfaces, &paint);
    paint.gradients = &polygon->gradients;
    paint.colour = polygon->colour;
    mix_light(surfaces, band, &paint);
    surfaces->light_code->draw_words(&paint, &polygon->depth, head, FXL_PIXEL_BITS / 8, band, scan);
    return FXL_DEPTH_DRAWN;
}

#else

static inline fxl_depth_drawn draw_smooth(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                                          const fxl_surface_polygon *polygon,
                                          const fxl_screen_point *points, uint32_t count,
                                          const fxl_band *band)
{
    (void)surfaces;
    (void)workspace;
    (void)polygon;
    (void)points;
    (void)count;
    (void)band;
    return FXL_DEPTH_NOT_DRAWN;
}

#endif

#endif
