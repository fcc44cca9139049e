/* SPDX-License-Identifier: MIT */
/* What is attached to a renderer is looked at together, once before the next frame begins. So the
 * sequence in which it was attached does not matter. */
#include "renderer.h"

#include "submit.h"
#include "surface_polygon.h"
#include "../paint/billboard_paint.h"

/* --- attaching ------------------------------------------------------------------------------ */

static bool reaches_nothing(const fxl_shader *shader, const fxl_scene *scene,
                            const fxl_instance *instance)
{
    (void)shader;
    (void)scene;
    (void)instance;
    return false;
}

const fxl_shader_code fxl_mark = {.reaches = reaches_nothing};

/* combinations 1.4 */
void fxl_renderer_attach(fxl_renderer *renderer, uint32_t rank, fxl_shader *shader)
{
    fxl_renderer_set_shader(renderer, rank, shader);
    fxl_take_lens(renderer);
    renderer->check = fxl_check_combination;
}

/* --- conflicts ------------------------------------------------------------------------------ */

/* place pixel-format: what cannot be drawn together */
/* The first that a renderer has is named. */
static const fxl_conflict conflicts[] = {
    {FXL_HAS_TREE, FXL_HAS_DEPTH},
    {FXL_HAS_STUDY, FXL_HAS_SURFACES},
    {FXL_HAS_STUDY, FXL_HAS_BILLBOARDS},
    {FXL_HAS_STUDY, FXL_HAS_OUTLINES},
    {FXL_HAS_FLAT_OUTLINES, FXL_HAS_DEPTH},
    {FXL_HAS_OUTLINES, FXL_HAS_BEAMS},
    {FXL_HAS_OUTLINES, FXL_HAS_MOVERS},
    {FXL_HAS_TREE, FXL_HAS_LINES},
    {FXL_HAS_STUDY, FXL_HAS_LINES},
    {FXL_HAS_BEAMS, FXL_HAS_LINES},
    {FXL_HAS_LINES, FXL_HAS_WORLD_CLIPPER},
    {FXL_HAS_DEEP_OUTLINES, FXL_HAS_WORLD_CLIPPER},
    {FXL_HAS_TEXELS_565, FXL_HAS_BEAMS},
    {FXL_HAS_COLOURS, FXL_HAS_BEAMS},
    {FXL_HAS_OTHER_PAINTER, FXL_HAS_TARGET},
    {FXL_HAS_TREE, FXL_HAS_ORTHOGRAPHIC},
    {FXL_HAS_ORTHOGRAPHIC, FXL_HAS_HORIZON},
    {FXL_HAS_ORTHOGRAPHIC, FXL_HAS_SPLIT},
    {FXL_HAS_ORTHOGRAPHIC, FXL_HAS_OTHER_CLIPPER},
};

/* Whether another instance is on the layer of the tree's, which cuts it. */
static bool has_movers(const fxl_scene *scene)
{
    if (scene->bsp_nodes == NULL) {
        return false;
    }
    const uint8_t layer = scene->instances[scene->bsp_instance].layer;
    uint32_t count = 0;
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        count += scene->instances[i].layer == layer;
    }
    return count > 1;
}

/* beams 6.5 */
static bool has_texels_565(const fxl_surfaces *surfaces)
{
    for (uint32_t i = 0; surfaces != NULL && i < surfaces->set->texture_count; i++) {
        if (surfaces->set->textures[i].format == FXL_TEXTURE_565) {
            return true;
        }
    }
    return false;
}

/* Whether a surface has one of some flags. */
static bool have_flag(const fxl_surfaces *surfaces, uint32_t flags)
{
    for (uint32_t i = 0; surfaces != NULL && i < surfaces->set->surface_count; i++) {
        if (surfaces->set->surfaces[i].flags & flags) {
            return true;
        }
    }
    return false;
}

static uint32_t bit_if(bool has, uint32_t number)
{
    return (uint32_t)has << number;
}

static uint32_t parts_of(const fxl_renderer *renderer)
{
    const fxl_target *target = fxl_painted_target(renderer);
    const fxl_surfaces *surfaces = fxl_surfaces_of(renderer);
    const fxl_billboards *billboards = renderer->billboards;
    const fxl_overdraw *outlines =
        (const fxl_overdraw *)fxl_find_shader(renderer, FXL_SHADER_OUTLINES);
    const bool has_tree = renderer->order->memory_size != NULL;
    const fxl_orthographic_code *orthographic = fxl_orthographic_of(&renderer->frame.view.lens);
    return bit_if(has_tree, FXL_HAS_TREE) |
           bit_if(has_tree && has_movers(renderer->scene), FXL_HAS_MOVERS) |
           bit_if(target->depth_bits != 0, FXL_HAS_DEPTH) |
           bit_if(target->pixel_bits == 8 && target->depth_bits == 0 && !target->draws_over,
                  FXL_HAS_STUDY) |
           bit_if(surfaces != NULL, FXL_HAS_SURFACES) |
           bit_if(has_texels_565(surfaces), FXL_HAS_TEXELS_565) |
           bit_if(have_flag(surfaces, FXL_SURFACE_COLOURS), FXL_HAS_COLOURS) |
           bit_if(billboards != NULL, FXL_HAS_BILLBOARDS) |
           bit_if(fxl_find_shader(renderer, FXL_SHADER_BEAMS) != NULL, FXL_HAS_BEAMS) |
           bit_if(outlines != NULL, FXL_HAS_OUTLINES) |
           bit_if(outlines != NULL && outlines->draw_over == NULL, FXL_HAS_FLAT_OUTLINES) |
           bit_if(outlines != NULL && outlines->draw_over != NULL, FXL_HAS_DEEP_OUTLINES) |
           bit_if(orthographic != NULL, FXL_HAS_ORTHOGRAPHIC) |
           bit_if(renderer->horizon != NULL, FXL_HAS_HORIZON) |
           bit_if(surfaces != NULL && fxl_find_shader(renderer, FXL_SHADER_BEAMS) != NULL,
                  FXL_HAS_SPLIT) |
           bit_if(orthographic != NULL && !orthographic->has_clipper(renderer),
                  FXL_HAS_OTHER_CLIPPER) |
           bit_if(fxl_find_shader(renderer, FXL_SHADER_LINES) != NULL, FXL_HAS_LINES) |
           bit_if(renderer->clipper->by_points != NULL, FXL_HAS_WORLD_CLIPPER) |
           bit_if((surfaces != NULL && surfaces->painter->target != target) ||
                      (billboards != NULL && billboards->painter->target != target),
                  FXL_HAS_OTHER_PAINTER) |
           bit_if(true, FXL_HAS_TARGET);
}

/* beams 6.5, combinations 1.2 */
FXL_COLD const fxl_conflict *fxl_find_conflict(const fxl_renderer *renderer)
{
    const uint32_t parts = parts_of(renderer);
    for (uint32_t i = 0; i < sizeof conflicts / sizeof *conflicts; i++) {
        if ((parts >> conflicts[i].first & 1u) && (parts >> conflicts[i].second & 1u)) {
            return &conflicts[i];
        }
    }
    return NULL;
}

/* --- what goes together --------------------------------------------------------------------- */

/* combinations 1.2 */
FXL_COLD fxl_status fxl_check_combination(fxl_renderer *renderer)
{
    fxl_surfaces *surfaces = (fxl_surfaces *)(uintptr_t)fxl_surfaces_of(renderer);
    const fxl_light *light = (const fxl_light *)fxl_find_shader(renderer, FXL_SHADER_LIGHT);
    const fxl_lit_surfaces *lit =
        (const fxl_lit_surfaces *)fxl_find_shader(renderer, FXL_SHADER_LIT);
    if (fxl_find_conflict(renderer) != NULL) {
        return FXL_E_COMBINATION;
    }
    if (surfaces != NULL) {
        surfaces->beams = (const fxl_shader *)fxl_find_shader(renderer, FXL_SHADER_BEAMS);
        const bool is_lit = lit != NULL && light != NULL;
        surfaces->light = is_lit ? light : NULL;
        surfaces->light_code = is_lit ? lit->code : NULL;
    }
    renderer->dark = light != NULL ? light->settings.dark : 0;
    fxl_set_direction(renderer, renderer->target->near_first &&
                                    !(renderer->target->depth_bits != 0 &&
                                      have_flag(surfaces, FXL_SURFACE_BLEND | FXL_SURFACE_ADD)));
    renderer->check = NULL;
    return FXL_OK;
}
