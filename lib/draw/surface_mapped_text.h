/* SPDX-License-Identifier: MIT */
/* Small triangles with a texture whose texels are in words, from their corners to their pixels. A part
 * of surface_smooth_text.h. Internal. */
#ifndef FXL_SURFACE_MAPPED_TEXT_H
#define FXL_SURFACE_MAPPED_TEXT_H

#if FXL_PIXEL_IS_MIXED

/* Whether small mapped triangles of a surface with a texture of one level are drawn at once if their
 * texels are in words. */
static inline bool may_be_texels(const fxl_surfaces *surfaces, const fxl_surface *surface,
                                 const fxl_traversal *traversal)
{
    const fxl_workspace *workspace = traversal->workspace;
    if (surface->texture == 0 || !traversal->draws_one ||
        !can_draw_smooth(workspace, traversal->band) ||
        ((const fxl_depth_head *)workspace->target_memory)->pass == FXL_DEPTH_BLENDED) {
        return false;
    }
    const fxl_texture *texture = &surfaces->set->textures[surface->texture - 1];
    return texture->levels == 1 && fxl_may_have_words(surfaces, surface, texture);
}

/* What such triangles of a surface share. */
typedef struct {
    fxl_paint paint;
    fxl_texel_outline outline;
    int32_t one;         /* of the last depth plane; 0: none yet, or its light was the same all over */
    uint32_t v_drop;     /* of fxl_find_texel_planes */
    uint32_t light_more; /* what is added to the light of one that is lit unevenly */
} texel_run;

/* Once a run. */
static inline void begin_texels(const fxl_surfaces *surfaces, const fxl_surface *surface,
                                const fxl_traversal *traversal, texel_run *run)
{
    const fxl_texture *texture = &surfaces->set->textures[surface->texture - 1];
    fxl_texture_level_set(texture, texture->texels, texture->log_width, texture->log_height,
                          &run->paint.level);
    paint_texels_of(surfaces, surface, traversal->band, &run->paint);
    const fxl_depth_head *head = (const fxl_depth_head *)traversal->workspace->target_memory;
    fxl_texel_outline_of_surface(head, &run->paint, &run->outline);
    run->outline.pixels = fxl_depth_outline_pixels(head, traversal->band, 2) - 2u;
    run->one = 0;
    run->v_drop = 8u - run->paint.level.log_width;
    run->light_more = fxl_surface_is_lit(surfaces, surface)
                          ? fxl_texel_light_more(run->paint.levels_less_1)
                          : 0;
}

/* Such a triangle, inside all planes. FXL_DEPTH_NOT_DRAWN if its planes are no words: then nothing is
 * drawn. */
static inline __attribute__((always_inline)) fxl_depth_drawn
draw_texel_corners(const fxl_surfaces *surfaces, const fxl_surface *surface,
                   const fxl_corner *const of[3], const fxl_screen_corners *corners,
                   const fxl_model_view *model_view, const fxl_traversal *traversal,
                   const fxl_words_lens *lens, const run_light *lighting, texel_run *run)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_band *band = traversal->band;
    const bool is_lit = run->outline.part_of_level != 0;
    int32_t light[3];
    bool is_even = false;
    if (is_lit) {
        /* Three look-ups take what one of two kept values saves. */
        find_lights_at_once(surfaces, model_view, traversal, of, lighting, light);
        is_even = light[0] == light[1] && light[0] == light[2];
    }
    const int32_t one = fxl_find_texel_planes(
        corners, lens, of, &run->outline.planes, is_lit && !is_even ? light : NULL,
        surface->division == FXL_AFFINE && fxl_corners_are_on_screen(corners, lens->lens),
        run->v_drop);
    if (one == 0) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    if (one == run->one && !is_even) {
        run->outline.planes.at.light += run->light_more;
    } else { /* as of the first face of a run */
        fxl_depth_clear_rest(workspace, band, &FXL_TARGET);
        run->paint.is_evenly_lit = is_even;
        run->paint.light = is_even ? (uint16_t)(light[0] >> 8) : 0;
        fxl_texel_outline_of_face((const fxl_depth_head *)workspace->target_memory, &run->paint,
                                  one, &run->outline);
        run->one = is_even ? 0 : one;
    }
    return fxl_draw_texel_outline(corners->points, 3, band, &run->outline);
}

#endif

#endif
