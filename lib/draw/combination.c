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

/* Sets of each part of FXL_HAS_... a pointer to what has it; null: the renderer has none. */
static void find_parts(const fxl_renderer *renderer, const void *parts[FXL_HAS_COUNT])
{
    const fxl_target *target = fxl_painted_target(renderer);
    const fxl_surfaces *surfaces = fxl_surfaces_of(renderer);
    const fxl_billboards *billboards = renderer->billboards;
    const fxl_overdraw *outlines =
        (const fxl_overdraw *)fxl_find_shader(renderer, FXL_SHADER_OUTLINES);
    const void *beams = fxl_find_shader(renderer, FXL_SHADER_BEAMS);
    const fxl_orthographic_code *orthographic = fxl_orthographic_of(&renderer->frame.view.lens);
    const bool is_drawn_over = outlines != NULL && outlines->draw_over != NULL;
    const bool has_colours = have_flag(surfaces, FXL_SURFACE_COLOURS);
    const void *tree = renderer->order->memory_size != NULL ? renderer : NULL;
    parts[FXL_HAS_TREE] = tree;
    parts[FXL_HAS_MOVERS] = has_movers(renderer->scene) ? tree : NULL;
    parts[FXL_HAS_DEPTH] = target->depth_bits != 0 ? target : NULL;
    parts[FXL_HAS_STUDY] =
        target->pixel_bits == 8 && target->depth_bits == 0 && !target->draws_over ? target : NULL;
    parts[FXL_HAS_SURFACES] = surfaces;
    parts[FXL_HAS_TEXELS_565] = has_texels_565(surfaces) ? surfaces : NULL;
    parts[FXL_HAS_COLOURS] = has_colours ? surfaces : NULL;
    parts[FXL_HAS_BILLBOARDS] = billboards;
    parts[FXL_HAS_BEAMS] = beams;
    parts[FXL_HAS_OUTLINES] = outlines;
    parts[FXL_HAS_FLAT_OUTLINES] = is_drawn_over ? NULL : outlines;
    parts[FXL_HAS_DEEP_OUTLINES] = is_drawn_over ? outlines : NULL;
    parts[FXL_HAS_ORTHOGRAPHIC] = orthographic;
    parts[FXL_HAS_HORIZON] = renderer->horizon;
    parts[FXL_HAS_SPLIT] = surfaces != NULL ? beams : NULL;
    parts[FXL_HAS_OTHER_CLIPPER] =
        orthographic != NULL && !orthographic->has_clipper(renderer) ? renderer : NULL;
    parts[FXL_HAS_LINES] = fxl_find_shader(renderer, FXL_SHADER_LINES);
    parts[FXL_HAS_WORLD_CLIPPER] = renderer->clipper->by_points != NULL ? renderer : NULL;
    parts[FXL_HAS_OTHER_PAINTER] =
        (has_colours && surfaces->painter->colours == NULL) ||
                (surfaces != NULL && surfaces->painter->target != target) ||
                (billboards != NULL && billboards->painter->target != target)
            ? target
            : NULL;
    parts[FXL_HAS_TARGET] = target;
}

/* beams 6.5, combinations 1.2 */
FXL_COLD const fxl_conflict *fxl_find_conflict(const fxl_renderer *renderer)
{
    const void *parts[FXL_HAS_COUNT];
    find_parts(renderer, parts);
    for (uint32_t i = 0; i < sizeof conflicts / sizeof *conflicts; i++) {
        if (parts[conflicts[i].first] != NULL && parts[conflicts[i].second] != NULL) {
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
