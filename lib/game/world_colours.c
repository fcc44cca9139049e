/* SPDX-License-Identifier: MIT */
/* Instances in colours of their own. A file of its own, so that a world that recolours nothing does
 * not link it. */
#include "../draw/submit.h"
#include "../math/arith.h"
#include "world_place.h"

static bool reaches(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    (void)shader;
    (void)scene;
    return instance->recolour != 0;
}

static uint8_t colour(const fxl_shader *shader, const fxl_renderer *renderer,
                      const fxl_instance *instance, const fxl_face *face, uint8_t of_model)
{
    const fxl_world *world = ((const fxl_world_colours *)(const void *)shader)->world;
    const uint32_t table = instance->recolour - 1u;
    (void)renderer;
    (void)face;
    FXL_ASSERT(instance->recolour <= world->memory.colour_count);
    return world->memory.colours[256u * table + of_model];
}

fxl_status fxl_world_set_colours(fxl_world *world, fxl_renderer *renderer,
                                 fxl_world_colours *colours)
{
    static const fxl_shader_code code = {reaches, fxl_submit_coloured_face, NULL, colour, false};
    fxl_status status;
    if (fxl_world_find_attached(world, renderer, &status) == NULL) {
        return status;
    }
    if (colours != NULL) {
        colours->shader.code = &code;
        colours->world = world;
    }
    fxl_renderer_set_shader(renderer, FXL_SHADER_RECOLOUR,
                            colours != NULL ? &colours->shader : NULL);
    return FXL_OK;
}
