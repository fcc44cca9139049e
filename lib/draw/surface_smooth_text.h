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

/* The same of a polygon with colours at its corners, which is opaque. */
static __attribute__((noinline)) fxl_depth_drawn draw_colours(fxl_workspace *workspace,
                                                              const fxl_surface_polygon *polygon,
                                                              const fxl_screen_point *points,
                                                              uint32_t count, const fxl_band *band)
{
    const fxl_depth_head *head = (const fxl_depth_head *)workspace->target_memory;
    fxl_colour_outline outline;
    fxl_colour_outline_set(head, &polygon->depth, &polygon->gradients, band, &outline);
    fxl_depth_drawn drawn = FXL_DRAW_COLOURS(points, count, band, &outline);
    if (drawn == FXL_DEPTH_NOT_CLEAR) {
        fxl_depth_clear_rest(workspace, band, FXL_TARGET_DEPTH_BITS / 8);
        fxl_colour_outline_set(head, &polygon->depth, &polygon->gradients, band, &outline);
        drawn = FXL_DRAW_COLOURS(points, count, band, &outline);
    }
    return drawn;
}

#endif

/* Draws any polygon in words by the kernel for it, where that can. */
static inline fxl_depth_drawn draw_smooth(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                                          const fxl_surface_polygon *polygon,
                                          const fxl_screen_point *points, uint32_t count,
                                          const fxl_band *band)
{
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    if (surface->opacity != 16 || fxl_surface_is_blended(surface) || !can_draw_smooth(workspace, band)) {
        return FXL_DEPTH_NOT_DRAWN;
    }
#if FXL_PIXEL_IS_MIXED
    if (surface->flags & FXL_SURFACE_COLOURS) {
        return draw_colours(workspace, polygon, points, count, band);
    }
#endif
    if (polygon->is_in_beam || !fxl_surface_is_lit(surfaces, surface)) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    return clear_and_draw_words(surfaces, workspace, polygon, polygon->colour, points, count, band);
}

/* Whether pixels of a surface are those of the kernel of colours, which have no texture, and need not
 * be divided. */
static inline bool has_colours_alone(const fxl_surfaces *surfaces, const fxl_surface *surface)
{
    const uint32_t flags = surface->flags & ~(uint32_t)FXL_SURFACE_LIT;
    return FXL_PIXEL_IS_MIXED && flags == FXL_SURFACE_COLOURS && surface->opacity == 16 && surface->division != FXL_DIVIDE_1 &&
           surfaces->beams == NULL;
}

/* Whether what the clipper leaves of a mapped face is drawn at once, as one polygon, by the kernel
 * of smooth outlines if its planes are in words. */
static inline bool may_be_smooth(const fxl_surfaces *surfaces, const fxl_surface *surface,
                                 const fxl_traversal *traversal)
{
    return surface->texture == 0 &&
           (has_colours_alone(surfaces, surface) ||
            (surfaces->light != NULL && fxl_has_light_alone(surfaces, surface))) &&
           traversal->display_list == NULL && traversal->mode != FXL_SUBMIT_MEASURE &&
           traversal->clipper->next == NULL &&
           can_draw_smooth(traversal->workspace, traversal->band);
}

#if FXL_PIXEL_IS_MIXED

/* The planes of a face with colours at its corners, in words. Not inline: what it has would be on the
 * stack of others. */
static __attribute__((noinline)) bool
find_colour_planes(const fxl_surfaces *surfaces, const fxl_surface *surface,
                   const fxl_corner *const of[3], const fxl_model_view *model_view,
                   const fxl_renderer *renderer, const fxl_screen_corners *corners,
                   fxl_surface_polygon *polygon)
{
    const fxl_lens *lens = &model_view->view->lens;
    fxl_colour_values values;
    fxl_corner_colours(of, values.of);
    if (fxl_surface_is_lit(surfaces, surface)) {
        int32_t light[3];
        surfaces->light_code->light_corners(surfaces, renderer, model_view->instance, of, light);
        fxl_corner_colours_light(&surfaces->light->settings, light, values.of);
    }
    values.limit = surface->division == FXL_AFFINE && fxl_corners_are_on_screen(corners, lens)
                       ? FXL_BEND_ANY
                   : surface->division == FXL_DIVIDE_8 ? FXL_BEND_FINE
                                                       : FXL_BEND_NONE;
    return fxl_find_colour_planes(corners, lens, &values, &polygon->gradients, &polygon->depth);
}

#endif

/* Such a face, from its corners to its pixels. False if its planes are no words, or the kernel
 * cannot scan it: then nothing is drawn or counted. */
static __attribute__((noinline)) bool draw_smooth_face(const fxl_surfaces *surfaces,
                                                       const fxl_surface *surface,
                                                       const fxl_corner *const of[3],
                                                       const fxl_model_view *model_view,
                                                       const fxl_face *face,
                                                       const fxl_traversal *traversal)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_screen_polygon *screen = &workspace->screen;
    fxl_counters *counters = traversal->counters;
    const fxl_clip_result cut = fxl_first_polygon(model_view, face, traversal);
    fxl_surface_polygon polygon;
    fxl_screen_corners corners;
    int32_t light[3];
    if (cut > FXL_CLIP_CUT) {
        return fxl_count_outcome(traversal, (fxl_outcome)1 << cut, 0);
    }
    if (!fxl_find_screen_corners(model_view, face, of, traversal, &corners)) {
        return false;
    }
    fxl_depth_drawn drawn;
    (void)surface; /* a palette's pixels have no colours of corners */
#if FXL_PIXEL_IS_MIXED
    if (surface->flags & FXL_SURFACE_COLOURS) {
        if (!find_colour_planes(surfaces, surface, of, model_view, renderer, &corners, &polygon)) {
            return false;
        }
        drawn = draw_colours(workspace, &polygon, screen->points, screen->count, traversal->band);
    } else
#endif
    {
        surfaces->light_code->light_corners(surfaces, renderer, model_view->instance, of, light);
        if (!fxl_find_smooth_planes(&corners, &model_view->view->lens, light, &polygon.gradients,
                                    &polygon.depth)) {
            return false;
        }
        drawn = clear_and_draw_words(surfaces, workspace, &polygon, face->material, screen->points,
                                     screen->count, traversal->band);
    }
    if (drawn == FXL_DEPTH_NOT_DRAWN) {
        return false;
    }
    if (drawn == FXL_DEPTH_DRAWN ||
        fxl_outline_has_rows(screen, renderer->frame.view.lens.height)) {
        counters->spilled += 1;
    }
    counters->drawn += 1;
    if (cut == FXL_CLIP_CUT) {
        counters->clipped += 1;
    }
    return true;
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
