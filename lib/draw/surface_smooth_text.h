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
    return surface->texture == 0 && traversal->draws_one &&
           (has_colours_alone(surfaces, surface) ||
            (surfaces->light != NULL && fxl_has_light_alone(surfaces, surface))) &&
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
    fxl_count_drawn(traversal->counters, cut,
                    drawn == FXL_DEPTH_DRAWN ||
                        fxl_outline_has_rows(screen, renderer->frame.view.lens.height));
    return true;
}

#if FXL_PIXEL_IS_MIXED

/* Whether what the clipper leaves of a small mapped triangle with a texture of one level is drawn at
 * once, as one polygon, if its texels are in words. */
static inline bool may_be_texels(const fxl_surfaces *surfaces, const fxl_surface *surface,
                                 const fxl_face *face, const fxl_traversal *traversal)
{
    const fxl_workspace *workspace = traversal->workspace;
    if (surface->texture == 0 || face->count != 3 || !traversal->draws_one ||
        ((const fxl_depth_head *)workspace->target_memory)->pass == FXL_DEPTH_BLENDED) {
        return false;
    }
    const fxl_texture *texture = &surfaces->set->textures[surface->texture - 1];
    return texture->levels == 1 && fxl_may_have_words(surfaces, surface, texture);
}

/* The values of the corners, and whether light is the same at all of them. Returns how many
 * attributes they are. */
static inline uint32_t find_texel_values(const fxl_surfaces *surfaces, const fxl_surface *surface,
                                         const fxl_corner *const of[3],
                                         const fxl_instance *instance,
                                         const fxl_renderer *renderer, int32_t (*values)[3],
                                         fxl_paint *paint)
{
    for (uint32_t i = 0; i < 3; i++) {
        values[FXL_ATTRIBUTE_U][i] = of[i]->texel.u;
        values[FXL_ATTRIBUTE_V][i] = of[i]->texel.v;
    }
    paint->is_evenly_lit = false;
    if (!fxl_surface_is_lit(surfaces, surface)) {
        return FXL_SEGMENT_LIGHT;
    }
    int32_t *light = values[FXL_SEGMENT_LIGHT];
    surfaces->light_code->light_corners(surfaces, renderer, instance, of, light);
    paint->is_evenly_lit = light[0] == light[1] && light[0] == light[2];
    paint->light = (uint16_t)(light[0] >> 8);
    return paint->is_evenly_lit ? FXL_SEGMENT_LIGHT : FXL_SEGMENT_LIGHT + 1u;
}

/* Such a face, from its corners to its pixels. False if its planes are no words: then nothing is
 * drawn or counted. */
static __attribute__((noinline)) bool draw_texel_face(const fxl_surfaces *surfaces,
                                                      const fxl_surface *surface,
                                                      const fxl_corner *const of[3],
                                                      const fxl_model_view *model_view,
                                                      const fxl_face *face,
                                                      const fxl_traversal *traversal)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_screen_polygon *screen = &workspace->screen;
    const fxl_band *band = traversal->band;
    const fxl_lens *lens = &model_view->view->lens;
    const fxl_texture *texture = &surfaces->set->textures[surface->texture - 1];
    const fxl_clip_result cut = fxl_first_polygon(model_view, face, traversal);
    fxl_screen_corners corners;
    fxl_texel_outline outline;
    fxl_paint paint;
    int32_t values[FXL_ATTRIBUTES][3];
    if (cut > FXL_CLIP_CUT) {
        return fxl_count_outcome(traversal, (fxl_outcome)1 << cut, 0);
    }
    if (!fxl_find_screen_corners(model_view, face, of, traversal, &corners)) {
        return false;
    }
    const uint32_t count = find_texel_values(surfaces, surface, of, model_view->instance, renderer,
                                             values, &paint);
    const int32_t one = fxl_find_texel_planes(
        &corners, lens, values, &outline.planes, count,
        surface->division == FXL_AFFINE && fxl_corners_are_on_screen(&corners, lens));
    if (one == 0) {
        return false;
    }
    fxl_depth_clear_rest(workspace, band, FXL_TARGET_DEPTH_BITS / 8);
    fxl_texture_level_set(texture, texture->texels, texture->log_width, texture->log_height,
                          &paint.level);
    paint_texels_of(surfaces, surface, band, &paint);
    fxl_texel_planes_scale(&outline.planes, 0, 8u - paint.level.log_width);
    fxl_texel_outline_set((const fxl_depth_head *)workspace->target_memory, &paint, one, &outline);
    fxl_count_drawn(traversal->counters, cut,
                    fxl_draw_texel_words(&outline, workspace->target_memory, screen->points,
                                         screen->count, band, &workspace->work.scan) ||
                        fxl_outline_has_rows(screen, renderer->frame.view.lens.height));
    return true;
}

#endif

/* A face that needs no record of a polygon. False: nothing is drawn or counted. */
static inline bool draw_at_once(const fxl_surfaces *surfaces, const fxl_mapped_face *mapped,
                                const fxl_model_view *model_view, const fxl_face *face,
                                const fxl_traversal *traversal)
{
    const fxl_surface *surface = &surfaces->set->surfaces[mapped->surface];
    const fxl_corner *corners[3];
#if FXL_PIXEL_IS_MIXED
    if (may_be_texels(surfaces, surface, face, traversal)) {
        fxl_find_mapped_corners(surfaces->set, surface, mapped, corners);
        return draw_texel_face(surfaces, surface, corners, model_view, face, traversal);
    }
#endif
    if (may_be_smooth(surfaces, surface, traversal)) {
        fxl_find_mapped_corners(surfaces->set, surface, mapped, corners);
        return draw_smooth_face(surfaces, surface, corners, model_view, face, traversal);
    }
    return false;
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
