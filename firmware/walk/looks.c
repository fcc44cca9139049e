/* SPDX-License-Identifier: MIT */
#include "looks.h"

#include "fixel/all.h"
#include "surfaces.h"

static uint32_t aligned(size_t bytes)
{
    return ((uint32_t)bytes + 7u) & ~7u;
}

static uint32_t beam_bytes(const fxl_scene *scene)
{
    return aligned(fxl_beam_light_workspace_size(scene->beams, scene->beam_count));
}

static uint32_t light_bytes(const fxl_scene_image *image)
{
    return image->light.base != NULL ? aligned(sizeof(fxl_light)) : 0;
}

uint32_t walk_looks_bytes(const fxl_scene_image *image)
{
    return beam_bytes(&image->scene) + light_bytes(image) + walk_surface_bytes(&image->surfaces);
}

fxl_status walk_looks_open(const fxl_scene_image *image, const fxl_painter *painter,
                           fxl_renderer *renderer, uint8_t *memory)
{
    const fxl_scene *scene = renderer->scene;
    uint8_t *const lights = memory + beam_bytes(&image->scene);
    fxl_light *const light = image->light.base != NULL ? (fxl_light *)(void *)lights : NULL;
    fxl_status status = FXL_OK;

    if (scene->beam_count > 0) {
        const fxl_beam_set set = {scene->beams, scene->beam_count, scene->lit};

        status = fxl_attach_beams(renderer, &set, memory, beam_bytes(&image->scene));
    }
    if (status == FXL_OK && light != NULL) {
        fxl_light_settings settings;

        fxl_light_settings_of(&image->light, &settings);
        status = fxl_attach_light(renderer, light, &settings);
    }
    if (status == FXL_OK && image->surfaces.face_map != NULL && painter != NULL) {
        status = walk_surfaces_open(image, painter, renderer, lights + light_bytes(image));
    }
    return status;
}
