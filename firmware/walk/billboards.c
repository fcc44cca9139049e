/* SPDX-License-Identifier: MIT */
#include "billboards.h"

#include "contract/system.h"
#include "fixel/all.h"

#if defined WALK_WITHOUT_BILLBOARDS

uint32_t walk_billboards_bytes(const fxl_scene_image *image)
{
    (void)image;
    return 0;
}

fxl_status walk_billboards_open(const fxl_scene_image *image, const fxl_sprite_painter *painter,
                                fxl_renderer *renderer, uint8_t *memory)
{
    (void)image;
    (void)painter;
    (void)renderer;
    (void)memory;
    return FXL_OK;
}

#else

/* What billboards want; the records of each follow. */
typedef struct {
    fxl_billboards billboards;
    fxl_billboard_set set;
} billboard_memory;

uint32_t walk_billboards_bytes(const fxl_scene_image *image)
{
    const size_t each = sizeof(fxl_billboard) + sizeof(fxl_sprite);

    return image->billboards.model_map != NULL
               ? ((uint32_t)(sizeof(billboard_memory) + image->billboards.count * each) + 7u) & ~7u
               : 0;
}

fxl_status walk_billboards_open(const fxl_scene_image *image, const fxl_sprite_painter *painter,
                                fxl_renderer *renderer, uint8_t *memory)
{
    billboard_memory *const own = (billboard_memory *)(void *)memory;
    const uint32_t count = image->billboards.count;
    fxl_billboard *const boards = (fxl_billboard *)(void *)(own + 1);
    fxl_sprite *const sprites = (fxl_sprite *)(void *)(boards + count);
    fxl_status status;

    if (image->billboards.model_map == NULL) {
        return FXL_OK;
    }
    if (painter == NULL) {
        system_text("walk: the scene has billboards, which VISIBILITY=sorted, tree, surfaces, "
                    "depth and depth-32 draw\n");
        return FXL_E_COMBINATION;
    }
    status = fxl_billboards_open(image, sprites, boards, count, &own->set, NULL);
    return status == FXL_OK
               ? fxl_attach_billboards(renderer, &own->billboards, &own->set, painter)
               : status;
}

#endif
