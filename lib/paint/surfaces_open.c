/* SPDX-License-Identifier: MIT */
/* The surfaces of a scene image (docs/formats.md, section 1.12). */
#include "../math/memory.h"
#include "../math/plane.h"
#include "../scene/scene_check.h"
#include "fixel/surfaces.h"
#include "surface_sections.h"

FXL_STATIC_ASSERT(FXL_TEXTURES_MAX == FXL_SCENE_TABLE_MAX, "docs/formats.md, section 1");

#define COLOURS_4 16u /* of a texture of 4 bits */

/* surfaces 3.1 */
static uint32_t level_side(uint32_t log_side, uint32_t level, uint32_t log_least)
{
    return 1u << (log_side > level + log_least ? log_side - level : log_least);
}

/* place pixel-format: if textures or surfaces may be others than in frames of as many bits */
/* Bytes of the texels of all levels: at most 9 times 2^17. */
/* formats 1.12 */
static uint32_t texel_bytes(const fxl_scene_texture *texture)
{
    const bool is_4 = texture->format == FXL_TEXTURE_4;
    uint32_t texels = 0;
    for (uint32_t i = 0; i < texture->levels; i++) {
        texels +=
            level_side(texture->log_width, i, is_4 ? 1 : 0) * level_side(texture->log_height, i, 0);
    }
    return texture->format == FXL_TEXTURE_565 ? 2 * texels : texels >> is_4;
}

/* formats 1.12 */
static bool lies_in(uint32_t place, uint32_t bytes, uint32_t size)
{
    return place <= size && bytes <= size - place;
}

/* Whether a texture lies within the texels of the image. */
static FXL_COLD fxl_status check_place(const fxl_scene_texture *texture, uint32_t size)
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

/* formats 1.12 */
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
    to->key_565 = from->key_565;
}

/* place field: what sets the pointer to surfaces; their checks */
/* formats 1.12 */
FXL_COLD fxl_status fxl_surfaces_open(const fxl_scene_image *image, fxl_texture *textures,
                                      uint32_t capacity, fxl_surface_set *set,
                                      fxl_scene_fault *fault)
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
    found.corners = from->corners;
    found.normals = from->normals;
    found.texture_count = from->texture_count;
    found.surface_count = from->surface_count;
    found.face_count = from->face_count;
    found.corner_count = from->corner_count;
    found.normal_count = from->normal_count;
    found.blend = from->blend;
    found.blend_first = from->blend_first;
    found.blend_count = from->blend_count;
    const fxl_status status = fxl_surfaces_check(&found, &image->scene, image->pixel_bits, fault);
    if (status == FXL_OK) {
        *set = found;
    }
    return status;
}

/* What frames of 16 bits a pixel have beyond those of a palette. */
typedef struct {
    uint8_t last_format, surface_flags;
    bool is_565;
} frame_kind;

static const frame_kind of_palette = {FXL_TEXTURE_4, FXL_SURFACE_LIT | FXL_SURFACE_BLEND, false};
static const frame_kind of_565 = {
    FXL_TEXTURE_565, FXL_SURFACE_LIT | FXL_SURFACE_BLEND | FXL_SURFACE_ADD | FXL_SURFACE_COLOURS,
    true};

/* surfaces 1.3 */
static FXL_COLD fxl_status check_texture(const fxl_texture *texture, const frame_kind *kind)
{
    const bool is_565 = texture->format == FXL_TEXTURE_565;
    const uint32_t smallest = texture->format == FXL_TEXTURE_4 ? 1 : 0;
    const uint32_t larger =
        texture->log_width > texture->log_height ? texture->log_width : texture->log_height;
    if (texture->texels == NULL ||
        (texture->format == FXL_TEXTURE_4) != (texture->colours != NULL)) {
        return FXL_E_ARGUMENT;
    }
    if (texture->format > kind->last_format || (is_565 && texture->key != 0) ||
        texture->flags > (FXL_TEXTURE_CLAMP | FXL_TEXTURE_KEYED) ||
        (!is_565 && texture->key_565 != 0)) {
        return FXL_E_RESERVED;
    }
    if (texture->log_width > FXL_TEXTURE_LOG_MAX || texture->log_height > FXL_TEXTURE_LOG_MAX ||
        texture->log_width < smallest || texture->levels < 1 || texture->levels > larger + 1) {
        return FXL_E_RANGE;
    }
    return is_565 && ((uintptr_t)texture->texels & 1u) != 0 ? FXL_E_ALIGNMENT : FXL_OK;
}

/* rgb565 2.3, 3.3 */
static FXL_COLD fxl_status check_surface(const fxl_surface_set *set, const fxl_surface *surface,
                                         const frame_kind *kind)
{
    if (surface->texture > set->texture_count || surface->first_corner > set->corner_count) {
        return FXL_E_INDEX;
    }
    if (surface->opacity < 1 || surface->opacity > 16 || surface->sixteenths > 16) {
        return FXL_E_RANGE;
    }
    if (!kind->is_565 && (surface->flags & FXL_SURFACE_BLEND) && set->blend == NULL) {
        return FXL_E_ARGUMENT;
    }
    const uint32_t both = FXL_SURFACE_BLEND | FXL_SURFACE_ADD;
    const bool plain = surface->division <= FXL_AFFINE &&
                       (surface->flags & ~(uint32_t)kind->surface_flags) == 0 &&
                       (surface->flags & both) != both &&
                       (surface->texture == 0 || (surface->flags & FXL_SURFACE_COLOURS) == 0) &&
                       ((surface->flags & FXL_SURFACE_BLEND) || surface->sixteenths == 0) &&
                       (surface->reserved[0] | surface->reserved[1]) == 0;
    return plain ? FXL_OK : FXL_E_RESERVED;
}

/* Whether three points of a model are on one line. Coordinates are within 2 * 8191 world units, so
 * differences are at most 32764 units, below 2^31, and products of two are below 2^62. */
/* surfaces 1.2 */
static FXL_ONE_COPY bool on_one_line(const fxl_point *a, const fxl_point *b, const fxl_point *c)
{
    const int32_t x1 = b->x - a->x, y1 = b->y - a->y, z1 = b->z - a->z;
    const int32_t x2 = c->x - a->x, y2 = c->y - a->y, z2 = c->z - a->z;
    return fxl_multiply_s32(y1, z2) == fxl_multiply_s32(z1, y2) &&
           fxl_multiply_s32(z1, x2) == fxl_multiply_s32(x1, z2) &&
           fxl_multiply_s32(x1, y2) == fxl_multiply_s32(y1, x2);
}

/* A corner of a face of a model that has a surface with these flags. */
/* surfaces 1.4 */
static FXL_COLD FXL_ONE_COPY fxl_status check_corner(const fxl_surface_set *set,
                                                     const fxl_model *model, uint32_t flags,
                                                     const fxl_corner *corner)
{
    const fxl_texel *texel = &corner->texel;
    if (corner->vertex >= model->vertex_count ||
        ((flags & FXL_SURFACE_LIT) && corner->normal >= set->normal_count)) {
        return FXL_E_INDEX;
    }
    const bool in_range = (flags & FXL_SURFACE_COLOURS)
                              ? (fxl_bits_32(texel->u) >> 24 | fxl_bits_32(texel->v)) == 0
                              : texel->u >= -FXL_TEXEL_MAX && texel->u <= FXL_TEXEL_MAX &&
                                    texel->v >= -FXL_TEXEL_MAX && texel->v <= FXL_TEXEL_MAX;
    return in_range ? FXL_OK : FXL_E_RANGE;
}

/* surfaces 1.4 */
static FXL_COLD FXL_ONE_COPY fxl_status check_face(const fxl_surface_set *set,
                                                   const fxl_scene *scene, const fxl_model *model,
                                                   const fxl_mapped_face *mapped)
{
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    const fxl_point *points[3];
    if (mapped->surface >= set->surface_count) {
        return FXL_E_INDEX;
    }
    const fxl_surface *surface = &set->surfaces[mapped->surface];
    for (uint32_t i = 0; i < 3; i++) {
        /* The surface was checked: its first corner is at most corner_count. */
        if (mapped->corners[i] >= set->corner_count - surface->first_corner) {
            return FXL_E_INDEX;
        }
        const fxl_corner *corner = &set->corners[surface->first_corner + mapped->corners[i]];
        const fxl_status status = check_corner(set, model, surface->flags, corner);
        if (status != FXL_OK) {
            return status;
        }
        points[i] = &vertices[corner->vertex];
    }
    return on_one_line(points[0], points[1], points[2]) ? FXL_E_DEGENERATE : FXL_OK;
}

static FXL_COLD fxl_status check_faces(const fxl_surface_set *set, const fxl_scene *scene,
                                       fxl_scene_fault *fault)
{
    for (uint32_t m = 0; m < scene->model_count; m++) {
        const fxl_model *model = &scene->models[m];
        for (uint32_t i = 0; i < model->face_count; i++) {
            const uint32_t number = model->first_face + i;
            const uint32_t mapped = set->face_map[number];
            if (mapped > set->face_count) {
                return fxl_fault_at(fault, "face", number, FXL_E_INDEX);
            }
            const fxl_status status =
                mapped == 0 ? FXL_OK : check_face(set, scene, model, &set->faces[mapped - 1]);
            if (status != FXL_OK) {
                return fxl_fault_at(fault, "mapped face", mapped - 1, status);
            }
        }
    }
    return FXL_OK;
}

/* Whether every table begins where its records may; a null one does. */
static bool is_aligned(const fxl_surface_set *set)
{
    const uintptr_t words =
        (uintptr_t)set->surfaces | (uintptr_t)set->corners | (uintptr_t)set->normals;
    const uintptr_t halves = (uintptr_t)set->faces | (uintptr_t)set->face_map;
    return (words & (FXL_WORD - 1)) == 0 && (halves & 1u) == 0 &&
           fxl_is_aligned(set->textures, FXL_POINTER);
}

FXL_COLD fxl_status fxl_surfaces_check(const fxl_surface_set *set, const fxl_scene *scene,
                                       uint32_t pixel_bits, fxl_scene_fault *fault)
{
    const frame_kind *kind = pixel_bits == 16 ? &of_565 : &of_palette;
    if (set == NULL || scene == NULL || set->face_map == NULL ||
        (set->textures == NULL && set->texture_count != 0) || set->surfaces == NULL ||
        set->faces == NULL || set->corners == NULL ||
        (set->normals == NULL && set->normal_count != 0)) {
        return fxl_fault_at(fault, "surfaces", 0, FXL_E_ARGUMENT);
    }
    if (!is_aligned(set)) {
        return fxl_fault_at(fault, "surfaces", 0, FXL_E_ALIGNMENT);
    }
    if (set->texture_count > FXL_TEXTURES_MAX || set->surface_count > FXL_SURFACES_MAX ||
        set->face_count > FXL_MAPPED_FACES_MAX || set->corner_count > FXL_SCENE_CORNERS_MAX ||
        set->normal_count > UINT16_MAX || set->blend_first > 255 ||
        set->blend_count > 256 - set->blend_first) {
        return fxl_fault_at(fault, "surfaces", 0, FXL_E_COUNT);
    }
    for (uint32_t i = 0; i < set->texture_count; i++) {
        const fxl_status status = check_texture(&set->textures[i], kind);
        if (status != FXL_OK) {
            return fxl_fault_at(fault, "texture", i, status);
        }
    }
    for (uint32_t i = 0; i < set->surface_count; i++) {
        const fxl_status status = check_surface(set, &set->surfaces[i], kind);
        if (status != FXL_OK) {
            return fxl_fault_at(fault, "surface", i, status);
        }
    }
    for (uint32_t i = 0; i < set->normal_count; i++) {
        if (!fxl_is_unit(&set->normals[i])) {
            return fxl_fault_at(fault, "normal", i, FXL_E_NORMAL);
        }
    }
    return check_faces(set, scene, fault);
}
