/* SPDX-License-Identifier: MIT */
#include "predict/shares.h"

#include "paint/lit_pieces.h"
#include "fixel/render.h"
#include "order/bsp_pieces.h"

static uint32_t aligned(uint32_t bytes)
{
    return (bytes + 7u) & ~7u;
}

static uint32_t motion_bytes(const fxl_scene_image *image)
{
    const fxl_scene *scene = &image->scene;
    return image->motion.motion_count == 0
               ? 0
               : aligned(ARM_INSTANCE * scene->instance_count +
                         ARM_PLACEMENT * (scene->instance_count - scene->first_turned));
}

/* fxl_beam_light_workspace_size on a board. */
static uint32_t beam_bytes(const fxl_scene *scene)
{
    if (scene->beam_count == 0) {
        return 0;
    }
    const uint32_t corners = fxl_lit_corners_needed(scene->beams, scene->beam_count);
    const uint32_t pieces = fxl_lit_pieces_needed(scene->beams, scene->beam_count);
    return aligned(ARM_BEAM_LIGHT) + aligned(ARM_LIT_PIECES) + aligned(ARM_POINT * corners) +
           aligned(2 * corners) + aligned(ARM_LIT_PIECE * pieces) +
           aligned(ARM_POINT * FXL_POLYGON_CAPACITY);
}

static uint32_t billboard_bytes(const fxl_scene_billboards *billboards)
{
    return billboards->model_map == NULL
               ? 0
               : aligned(ARM_BILLBOARD_SET + (ARM_BILLBOARD + ARM_SPRITE) * billboards->count);
}

uint32_t taken_bytes(const fxl_scene_image *image)
{
    return motion_bytes(image) + beam_bytes(&image->scene) +
           (image->surfaces.face_map != NULL
                ? aligned(ARM_SURFACE_SET + ARM_TEXTURE * image->surfaces.texture_count)
                : 0) +
           billboard_bytes(&image->billboards) +
           (image->pixel_bits == 16 ? 256 * (uint32_t)sizeof(uint16_t) : 0);
}

bool draws_by_tree(const fxl_scene_image *image)
{
    return image->scene.bsp_nodes != NULL && !image->by_distance && image->depth_bits == 0;
}

/* fxl_bsp_workspace_size on a board. */
static uint32_t least_tree_bytes(const fxl_scene *scene, uint32_t movers)
{
    const uint32_t bits = (scene->bsp_node_count + 31) / 32 * (uint32_t)sizeof(uint32_t);
    return ARM_BSP_WORKSPACE + bits +
           (movers > 0 ? bits + 2 * scene->bsp_node_count * (uint32_t)sizeof(uint16_t) +
                             movers * ARM_BSP_ITEM
                       : 0);
}

uint32_t tree_bytes(const fxl_scene_image *image, uint32_t room)
{
    if (!draws_by_tree(image)) {
        return 0;
    }
    const uint32_t movers = fxl_bsp_movers(&image->scene);
    const uint32_t least = aligned(least_tree_bytes(&image->scene, movers));
    return least + (movers > 0 && room > least ? (room - least) / 2u & ~7u : 0);
}

/* A row at least, and as many more as half of the rest holds. */
uint32_t depth_bytes(const fxl_scene_image *image, uint32_t room)
{
    if (image->depth_bits == 0) {
        return 0;
    }
    const uint32_t width = image->lens.width, height = image->lens.height;
    const uint32_t row = FXL_DEPTH_BYTES(width, 1, image->depth_bits);
    const uint32_t more = room > row ? (room - row) / 2u & ~7u : 0;
    const uint32_t rows = (row - 8u + more) / (width * (image->depth_bits / 8u));
    return FXL_DEPTH_BYTES(width, rows < height ? rows : height, image->depth_bits);
}
