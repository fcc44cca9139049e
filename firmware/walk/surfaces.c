/* SPDX-License-Identifier: MIT */
#include "surfaces.h"

#include "fixel/all.h"

#if defined WALK_WITHOUT_SURFACES && !defined WALK_SURFACES

uint32_t walk_surface_bytes(const fxl_scene_surfaces *surfaces)
{
    (void)surfaces;
    return 0;
}

fxl_status walk_surfaces_open(const fxl_scene_image *image, const fxl_painter *painter,
                              fxl_renderer *renderer, uint8_t *memory)
{
    (void)image;
    (void)painter;
    (void)renderer;
    (void)memory;
    return FXL_OK;
}

#else

static uint32_t aligned(size_t bytes)
{
    return ((uint32_t)bytes + 7u) & ~7u;
}

/* What surfaces want; a record of each texture follows. */
typedef struct {
    fxl_surfaces surfaces;
    fxl_lit_surfaces lit;
    fxl_surface_set set;
} surface_memory;

uint32_t walk_surface_bytes(const fxl_scene_surfaces *surfaces)
{
    return surfaces->face_map != NULL
               ? aligned(sizeof(surface_memory) + surfaces->texture_count * sizeof(fxl_texture))
               : 0;
}

fxl_status walk_surfaces_open(const fxl_scene_image *image, const fxl_painter *painter,
                              fxl_renderer *renderer, uint8_t *memory)
{
    surface_memory *const own = (surface_memory *)(void *)memory;
    const uint32_t count = image->surfaces.texture_count;
    fxl_texture *textures = (fxl_texture *)(void *)(own + 1);
    fxl_status status = fxl_surfaces_open(image, textures, count, &own->set, NULL);

    if (status == FXL_OK) {
        status = fxl_attach_surfaces(renderer, &own->surfaces, &own->set, painter);
    }
    if (status == FXL_OK && image->light.base != NULL) {
        status = fxl_attach_lit(renderer, &own->lit);
    }
    return status;
}

#endif
