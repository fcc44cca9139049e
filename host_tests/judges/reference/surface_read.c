/* SPDX-License-Identifier: MIT */
/* The surfaces of a scene image (docs/formats.md, section 1.12). */
#include <stdlib.h>
#include <string.h>

/* place field: the reference's reader: sizes of entries, and offsets as numbers */
#include "reference/sections.h"
#include "reference/surface.h"

/* Where the texels of a texture are. */
typedef struct {
    const uint8_t *texels;
    uint32_t bytes, at, colours;
    int bits; /* of a texel */
} texel_source;

/* The colour of texel i of a level that begins at a byte. */
static uint16_t texel_at(const texel_source *from, uint32_t at, uint32_t i)
{
    return from->bits == 16 ? ref_u16(from->texels + at + 2 * (size_t)i)
           : from->bits == 4
               ? from->texels[from->colours + (from->texels[at + i / 2] >> 4 * (i % 2) & 15)]
               : from->texels[at + i];
}

static bool read_level(const texel_source *from, uint32_t at, ref_texture_level *level)
{
    const uint32_t count = (uint32_t)level->width * (uint32_t)level->height;
    if ((uint64_t)at + (uint64_t)count * (unsigned)from->bits / 8 > from->bytes) {
        return false;
    }
    level->colours = malloc(count * sizeof *level->colours);
    for (uint32_t i = 0; level->colours && i < count; i++) {
        level->colours[i] = texel_at(from, at, i);
    }
    return level->colours != NULL;
}

static bool read_texture(const uint8_t *p, const uint8_t *texels, uint32_t bytes,
                         ref_texture *texture)
{
    static const int bits[] = {8, 4, 16}; /* of the formats */
    if (p[8] > 8 || p[9] > 8 || p[10] > 2 || p[13] < 1 || p[13] > REF_TEXTURE_LEVELS) {
        return false;
    }
    const texel_source from = {texels, bytes, ref_u32(p), ref_u32(p + 4), bits[p[10]]};
    const int least = from.bits == 4 ? 2 : 1; /* texels in a row */
    if (from.bits == 4 && (p[8] == 0 || from.colours + 16ull > bytes)) {
        return false;
    }
    *texture = (ref_texture){.clamps = p[11] & 1,
                             .is_keyed = p[11] >> 1 & 1,
                             .is_565 = from.bits == 16,
                             .key = from.bits == 16 ? ref_u16(p + 14) : p[12],
                             .level_count = p[13]};
    uint32_t at = from.at;
    for (int i = 0; i < texture->level_count; i++) {
        ref_texture_level *level = &texture->levels[i];
        level->width = 1 << p[8] >> i;
        level->width = level->width < least ? least : level->width;
        level->height = 1 << p[9] >> i;
        level->height = level->height < 1 ? 1 : level->height;
        if (!read_level(&from, at, level)) {
            return false;
        }
        at += (uint32_t)level->width * (uint32_t)level->height * (unsigned)from.bits / 8;
    }
    return true;
}

static bool read_textures(const uint8_t *bytes, ref_surfaces *surfaces)
{
    uint32_t texel_bytes;
    const uint8_t *textures;
    surfaces->textures = ref_table(bytes, REF_TEXTURES, sizeof *surfaces->textures, &textures,
                                   &surfaces->texture_count);
    const uint8_t *texels = ref_section(bytes, REF_TEXELS, &texel_bytes);
    if (!surfaces->textures || (textures && !texels)) {
        return false;
    }
    for (uint32_t i = 0; textures && i < surfaces->texture_count; i++) {
        if (!read_texture(textures + 16 * (size_t)i, texels, texel_bytes, &surfaces->textures[i])) {
            return false;
        }
    }
    return true;
}

/* place stipple: a blend: its flag in an image */
static bool read_surfaces(const uint8_t *bytes, ref_surfaces *surfaces)
{
    const uint8_t *p;
    surfaces->surfaces =
        ref_table(bytes, REF_SURFACES, sizeof *surfaces->surfaces, &p, &surfaces->surface_count);
    if (!p || !surfaces->surfaces) {
        return false;
    }
    for (uint32_t i = 0; i < surfaces->surface_count; i++, p += 12) {
        surfaces->surfaces[i] = (ref_surface){.texture = ref_u16(p),
                                              .division = p[2],
                                              .opacity = p[4],
                                              .sixteenths = p[5] != 0 ? p[5] : 8,
                                              .is_lit = p[3] & 1,
                                              .blends = p[3] >> 1 & 1,
                                              .adds = p[3] >> 2 & 1,
                                              .has_colours = p[3] >> 3 & 1,
                                              .first_corner = ref_u32(p + 8)};
        if (ref_u16(p) > surfaces->texture_count || p[4] < 1 || p[4] > REF_OPAQUE ||
            p[5] > REF_OPAQUE) {
            return false;
        }
    }
    return true;
}

static void read_corner(const uint8_t *p, ref_mapped_face *face, int k)
{
    face->texels[k][0] = ref_i32(p) / REF_ONE;
    face->texels[k][1] = ref_i32(p + 4) / REF_ONE;
    face->vertices[k] = ref_u16(p + 8);
    face->normals[k] = ref_u16(p + 10);
    for (int channel = 0; channel < REF_CHANNELS; channel++) {
        face->colours[k][channel] = ref_u32(p) >> (16 - 8 * channel) & 255;
    }
}

static bool read_faces(const uint8_t *bytes, ref_surfaces *surfaces)
{
    uint32_t corner_count;
    const uint8_t *p, *corners = ref_section(bytes, REF_CORNERS, &corner_count);
    surfaces->faces =
        ref_table(bytes, REF_MAPPED_FACES, sizeof *surfaces->faces, &p, &surfaces->face_count);
    if (!p || !surfaces->faces) {
        return false;
    }
    for (uint32_t i = 0; i < surfaces->face_count; i++, p += 8) {
        ref_mapped_face *face = &surfaces->faces[i];
        face->surface = ref_u16(p);
        if ((uint32_t)face->surface >= surfaces->surface_count) {
            return false;
        }
        for (int k = 0; k < 3; k++) {
            const uint64_t number =
                (uint64_t)surfaces->surfaces[face->surface].first_corner + ref_u16(p + 2 + 2 * k);
            if (number >= corner_count) {
                return false;
            }
            read_corner(corners + 12 * number, face, k);
        }
    }
    return true;
}

/* The normals of corners, and that those exist which lit faces have. */
static bool read_normals(const uint8_t *bytes, ref_surfaces *surfaces)
{
    const uint8_t *p;
    surfaces->normals = ref_table(bytes, REF_CORNER_NORMALS, sizeof *surfaces->normals, &p,
                                  &surfaces->normal_count);
    for (uint32_t i = 0; p && surfaces->normals && i < surfaces->normal_count; i++) {
        for (int k = 0; k < 3; k++) {
            surfaces->normals[i][k] = ref_i32(p + 12 * (size_t)i + 4 * k);
        }
    }
    for (uint32_t i = 0; i < surfaces->face_count; i++) {
        for (int k = 0; k < 3; k++) {
            if (surfaces->surfaces[surfaces->faces[i].surface].is_lit &&
                (uint32_t)surfaces->faces[i].normals[k] >= surfaces->normal_count) {
                return false;
            }
        }
    }
    return surfaces->normals != NULL;
}

static bool read_blend(const uint8_t *bytes, ref_surfaces *surfaces)
{
    const uint8_t *p;
    surfaces->blend = ref_table(bytes, REF_BLEND_TABLE, 256, &p, &surfaces->blend_count);
    surfaces->blend_first = ref_u32(bytes + 88);
    if (p && surfaces->blend) {
        memcpy(surfaces->blend, p, 256 * (size_t)surfaces->blend_count);
    }
    return surfaces->blend != NULL;
}

/* Whether the vertices of the mapped faces of a model's faces are the model's. */
static bool has_its_vertices(const ref_model *model, const ref_surfaces *surfaces)
{
    for (uint32_t i = 0; i < model->face_count; i++) {
        const uint16_t number = surfaces->face_map[model->first_face + i];
        for (int k = 0; number && k < 3; k++) {
            if ((uint32_t)surfaces->faces[number - 1].vertices[k] >= model->vertex_count) {
                return false;
            }
        }
    }
    return true;
}

static bool read_map(const uint8_t *bytes, const ref_scene *scene, ref_surfaces *surfaces)
{
    uint32_t count;
    const uint8_t *p = ref_section(bytes, REF_FACE_MAP, &count);
    surfaces->face_map = calloc(scene->face_count, sizeof *surfaces->face_map);
    if (!p || count != scene->face_count || !surfaces->face_map) {
        return false;
    }
    for (uint32_t i = 0; i < count; i++) {
        const uint16_t number = ref_u16(p + 2 * (size_t)i);
        if (number > surfaces->face_count) {
            return false;
        }
        surfaces->face_map[i] = number;
    }
    for (uint32_t m = 0; m < scene->model_count; m++) {
        if (!has_its_vertices(&scene->models[m], surfaces)) {
            return false;
        }
    }
    return true;
}

bool ref_surfaces_read(const uint8_t *bytes, ref_scene *scene)
{
    uint32_t count;
    if (!ref_section(bytes, REF_FACE_MAP, &count)) {
        return true;
    }
    ref_surfaces *surfaces = calloc(1, sizeof *surfaces);
    scene->surfaces = surfaces;
    return surfaces && read_textures(bytes, surfaces) && read_surfaces(bytes, surfaces) &&
           read_faces(bytes, surfaces) && read_normals(bytes, surfaces) &&
           read_blend(bytes, surfaces) && read_map(bytes, scene, surfaces);
}

void ref_surfaces_close(ref_surfaces *surfaces)
{
    for (uint32_t i = 0; surfaces && surfaces->textures && i < surfaces->texture_count; i++) {
        for (int k = 0; k < REF_TEXTURE_LEVELS; k++) {
            free(surfaces->textures[i].levels[k].colours);
        }
    }
    if (surfaces) {
        free(surfaces->normals);
        free(surfaces->blend);
        free(surfaces->textures);
        free(surfaces->surfaces);
        free(surfaces->faces);
        free(surfaces->face_map);
    }
    free(surfaces);
}
