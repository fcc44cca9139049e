/* SPDX-License-Identifier: MIT */
/* The surfaces of a scene image (docs/formats.md, section 1.12). */
#include "../math/aligned.h"
#include "../math/memory.h"
#include "../scene/fault.h"
#include "surface_sections.h"

FXL_STATIC_ASSERT(FXL_TEXTURES_MAX == FXL_SCENE_TABLE_MAX, "docs/formats.md, section 1");

#define COLOURS_4 16u /* of a texture of 4 bits */

static uint32_t level_side(uint32_t log_side, uint32_t level, uint32_t log_least)
{
    return 1u << (log_side > level + log_least ? log_side - level : log_least);
}

/* Bytes of the texels of all levels: at most 9 times 2^16. */
static uint32_t texel_bytes(const fxl_scene_texture *texture)
{
    const bool is_4 = texture->format == FXL_TEXTURE_4;
    uint32_t bytes = 0;
    for (uint32_t i = 0; i < texture->levels; i++) {
        bytes += level_side(texture->log_width, i, is_4 ? 1 : 0) *
                 level_side(texture->log_height, i, 0) / (is_4 ? 2 : 1);
    }
    return bytes;
}

static bool lies_in(uint32_t place, uint32_t bytes, uint32_t size)
{
    return place <= size && bytes <= size - place;
}

/* Whether a texture lies within the texels of the image. */
static fxl_status check_place(const fxl_scene_texture *texture, uint32_t size)
{
    if (texture->log_width > FXL_TEXTURE_LOG_MAX || texture->log_height > FXL_TEXTURE_LOG_MAX ||
        texture->levels < 1 || texture->levels > FXL_TEXTURE_LOG_MAX + 1u) {
        return FXL_E_RANGE;
    }
    if (!lies_in(texture->texels, texel_bytes(texture), size)) {
        return FXL_E_OFFSET;
    }
    if (texture->format == FXL_TEXTURE_4) {
        return lies_in(texture->colours, COLOURS_4, size) ? FXL_OK : FXL_E_OFFSET;
    }
    return texture->colours == 0 ? FXL_OK : FXL_E_RESERVED;
}

static void make_texture(const fxl_scene_texture *from, const uint8_t *texels, fxl_texture *to)
{
    memset(to, 0, sizeof *to);
    to->texels = texels + from->texels;
    to->colours = from->format == FXL_TEXTURE_4 ? texels + from->colours : NULL;
    to->log_width = from->log_width;
    to->log_height = from->log_height;
    to->format = from->format;
    to->flags = from->flags;
    to->key = from->key;
    to->levels = from->levels;
    to->key_565 = from->reserved; /* 0, or it is refused */
}

fxl_status fxl_surfaces_open(const fxl_scene_image *image, fxl_texture *textures, uint32_t capacity,
                             fxl_surface_set *set, fxl_scene_fault *fault)
{
    if (image == NULL || set == NULL || image->surfaces.face_map == NULL ||
        (textures == NULL && image->surfaces.texture_count != 0)) {
        return fxl_fault_at(fault, "surfaces", 0, FXL_E_ARGUMENT);
    }
    if (!fxl_is_aligned(textures, FXL_POINTER)) {
        return fxl_fault_at(fault, "texture table", 0, FXL_E_ALIGNMENT);
    }
    const fxl_scene_surfaces *from = &image->surfaces;
    if (from->texture_count > capacity) {
        return fxl_fault_at(fault, "texture table", 0, FXL_E_CAPACITY);
    }
    for (uint32_t i = 0; i < from->texture_count; i++) {
        const fxl_status status = check_place(&from->textures[i], from->texel_bytes);
        if (status != FXL_OK) {
            return fxl_fault_at(fault, "texture", i, status);
        }
        make_texture(&from->textures[i], from->texels, &textures[i]);
    }
    fxl_surface_set found;
    memset(&found, 0, sizeof found);
    found.textures = textures;
    found.surfaces = from->surfaces;
    found.faces = from->faces;
    found.face_map = from->face_map;
    found.normals = from->normals;
    found.texture_count = from->texture_count;
    found.surface_count = from->surface_count;
    found.face_count = from->face_count;
    found.normal_count = from->normal_count;
    found.blend = from->blend;
    found.blend_first = from->blend_first;
    found.blend_count = from->blend_count;
    const fxl_status status = fxl_surfaces_check(&found, &image->scene, fault);
    if (status == FXL_OK) {
        *set = found;
    }
    return status;
}
