/* SPDX-License-Identifier: MIT */
#include "reference/sections.h"

#include <stdbool.h>
#include <string.h>
#include <math.h>
#include <stdlib.h>

#include "reference/light.h"

/* place field: the reference's reader: sizes of entries, and offsets as numbers */
/* place field: a field of the header: HEADER_BYTES */
enum {
    HEADER_BYTES = 92,
    ENTRY_BYTES = 12,
    BSP_INSTANCE_AT = 84, /* in the header */
    BLEND_FIRST_AT = 88
};

/* Bytes of an entry and the most entries of each kind. */
static const struct {
    uint32_t bytes, most;
} kinds[REF_LAST_KIND + 1] = {[REF_PALETTE] = {3, 256},
                              [REF_VERTICES] = {12, 1000000},
                              [REF_INDICES] = {2, 4000000},
                              [REF_FACES] = {20, 1000000},
                              [REF_MODELS] = {28, 65535},
                              [REF_INSTANCES] = {16, 65535},
                              [REF_POSES] = {24, 1000000},
                              [REF_SEGMENTS] = {4, 1000000},
                              [REF_FACE_BOUNDS] = {20, 1000000},
                              [REF_BSP_NODES] = {48, 65535},
                              [REF_BEAMS] = {176, 4},
                              [REF_LIT_COLOURS] = {256, 1},
                              [REF_CLUSTERS] = {48, 65535},
                              [REF_PLACEMENTS] = {40, 65535},
                              [REF_MOTIONS] = {76, 65535},
                              [REF_MOTION_KEYS] = {32, 1000000},
                              [REF_LIGHT] = {28, 1},
                              [REF_POINT_LIGHTS] = {20, 4},
                              [REF_RAMP] = {256, 64},
                              [REF_TEXTURES] = {16, 65535},
                              [REF_TEXELS] = {1, 16u << 20},
                              [REF_SURFACES] = {12, 65535},
                              [REF_MAPPED_FACES] = {8, 65535},
                              [REF_CORNERS] = {12, 3 * 65535},
                              [REF_FACE_MAP] = {2, 1000000},
                              [REF_CORNER_NORMALS] = {12, 65535},
                              [REF_BLEND_TABLE] = {256, 256},
                              [REF_BILLBOARDS] = {32, 65535},
                              [REF_BILLBOARD_MAP] = {2, 65535},
                              [REF_SPRITE_PIXELS] = {1, 16u << 20},
                              [REF_LENS_CENTRE] = {8, 1},
                              [REF_WHOLE_FACES] = {4, 1000000},
                              [REF_LENS_SCALE] = {4, 1},
                              [REF_LINES] = {12, 1000000},
                              [REF_LINE_MAP] = {4, 65536},
                              [REF_HORIZON_SINES] = {4, 64},
                              [REF_HORIZON_COLOURS] = {1, 65}};

static const uint8_t *entry_at(const uint8_t *bytes, uint32_t number)
{
    return bytes + HEADER_BYTES + ENTRY_BYTES * number;
}

const uint8_t *ref_section(const uint8_t *bytes, int kind, uint32_t *count)
{
    for (uint32_t i = 0; i < ref_u16(bytes + 6); i++) {
        const uint8_t *entry = entry_at(bytes, i);
        if (ref_u16(entry) == kind) {
            *count = ref_u32(entry + 8);
            return bytes + ref_u32(entry + 4);
        }
    }
    *count = 0;
    return NULL;
}

void *ref_table(const uint8_t *bytes, int kind, size_t size, const uint8_t **entries,
                uint32_t *count)
{
    *entries = ref_section(bytes, kind, count);
    return calloc(*count + 1u, size);
}

/* Where a section ends before rounding; 0 where its entry is wrong. */
static uint64_t end_of(const uint8_t *entry)
{
    const uint32_t kind = ref_u16(entry), count = ref_u32(entry + 8);
    if (kind == 0 || entry[3] != 0 || entry[2] > 1) {
        return 0;
    }
    if (kind > REF_LAST_KIND) {
        return entry[2] == 1 ? 0 : ref_u32(entry + 4);
    }
    if (entry[2] != (kind != REF_FACE_BOUNDS) || count == 0 || count > kinds[kind].most) {
        return 0;
    }
    return ref_u32(entry + 4) + (uint64_t)count * kinds[kind].bytes;
}

/* The entries in turn: kinds rise, and each section begins behind the one before it. */
static bool places_are_sound(const uint8_t *bytes, size_t size)
{
    const uint32_t count = ref_u16(bytes + 6);
    uint64_t next = HEADER_BYTES + (uint64_t)ENTRY_BYTES * count;
    bool is_known = true;
    for (uint32_t i = 0; i < count; i++) {
        const uint8_t *entry = entry_at(bytes, i);
        const uint64_t begin = ref_u32(entry + 4), end = end_of(entry);
        if (end == 0 || end > size || begin % 4 != 0 || begin < next ||
            (is_known && begin > next) ||
            (i > 0 && ref_u16(entry) <= ref_u16(entry - ENTRY_BYTES))) {
            return false;
        }
        next = end;
        while (next % 4 != 0) {
            if (bytes[next++] != 0) {
                return false;
            }
        }
        is_known = ref_u16(entry) <= REF_LAST_KIND;
    }
    return next == size || !is_known;
}

static bool has(const uint8_t *bytes, int kind)
{
    uint32_t count;
    return ref_section(bytes, kind, &count) != NULL;
}

static bool has_any(const uint8_t *bytes, int first, int last)
{
    for (int kind = first; kind <= last; kind++) {
        if (has(bytes, kind)) {
            return true;
        }
    }
    return false;
}

static uint32_t count_of(const uint8_t *bytes, int kind)
{
    uint32_t count;
    ref_section(bytes, kind, &count);
    return count;
}

/* Which sections are there, and which counts go together. */
static bool set_is_sound(const uint8_t *bytes)
{
    const bool surfaces = has(bytes, REF_SURFACES) && has(bytes, REF_MAPPED_FACES) &&
                          has(bytes, REF_CORNERS) && has(bytes, REF_FACE_MAP) &&
                          count_of(bytes, REF_FACE_MAP) == count_of(bytes, REF_FACES);
    const bool billboards = has(bytes, REF_BILLBOARDS) && has(bytes, REF_SPRITE_PIXELS) &&
                            count_of(bytes, REF_BILLBOARD_MAP) == count_of(bytes, REF_MODELS);
    for (int kind = REF_PALETTE; kind <= REF_INSTANCES; kind++) {
        if (kind != REF_INDICES && kind != REF_FACES && !has(bytes, kind)) {
            return false;
        }
    }
    return count_of(bytes, REF_PALETTE) == 256 &&
           (!has(bytes, REF_WHOLE_FACES) ||
            count_of(bytes, REF_WHOLE_FACES) == count_of(bytes, REF_FACES)) &&
           has(bytes, REF_POSES) != has(bytes, REF_SEGMENTS) &&
           has(bytes, REF_BEAMS) == has(bytes, REF_LIT_COLOURS) &&
           has(bytes, REF_MOTIONS) == has(bytes, REF_MOTION_KEYS) &&
           count_of(bytes, REF_MOTIONS) <= count_of(bytes, REF_PLACEMENTS) &&
           count_of(bytes, REF_PLACEMENTS) <= count_of(bytes, REF_INSTANCES) &&
           has(bytes, REF_LIGHT) == has(bytes, REF_RAMP) &&
           (has(bytes, REF_LIGHT) || !has(bytes, REF_POINT_LIGHTS)) &&
           (surfaces || !has_any(bytes, REF_TEXTURES, REF_BLEND_TABLE)) &&
           (billboards || !has_any(bytes, REF_BILLBOARDS, REF_SPRITE_PIXELS)) &&
           has(bytes, REF_LINES) == has(bytes, REF_LINE_MAP) &&
           (!has(bytes, REF_LINE_MAP) ||
            count_of(bytes, REF_LINE_MAP) == count_of(bytes, REF_MODELS) + 1) &&
           has(bytes, REF_HORIZON_SINES) == has(bytes, REF_HORIZON_COLOURS) &&
           (!has(bytes, REF_HORIZON_SINES) || count_of(bytes, REF_HORIZON_COLOURS) ==
                                                  count_of(bytes, REF_HORIZON_SINES) + 1) &&
           (has(bytes, REF_BSP_NODES) || ref_u32(bytes + BSP_INSTANCE_AT) == 0) &&
           (has(bytes, REF_BLEND_TABLE) || ref_u32(bytes + BLEND_FIRST_AT) == 0);
}

const char *ref_sections_check(const uint8_t *bytes, size_t size)
{
    if (size < HEADER_BYTES || memcmp(bytes, "FXLS", 4) != 0) {
        return "it is not a scene image (no FXLS at its start)";
    }
    if (ref_u16(bytes + 4) != 9) {
        return "the scene image is of another version: build it again";
    }
    const uint32_t stated = ref_u32(bytes + 8);
    if (stated < HEADER_BYTES + (uint64_t)ENTRY_BYTES * ref_u16(bytes + 6) || stated > size ||
        stated > 16u << 20 || stated % 4 != 0) {
        return "the scene image is shorter than its header says";
    }
    if (ref_crc32(0, bytes + 16, stated - 16) != ref_u32(bytes + 12)) {
        return "the scene image's checksum does not match";
    }
    if (bytes[37] > 15 || bytes[37] % 4 > 2) {
        return "the scene image asks for a target that is not known";
    }
    return places_are_sound(bytes, stated) && set_is_sound(bytes)
               ? NULL
               : "the scene image's sections are not those that it must have, or not where they "
                 "must be";
}

/* Reads the light. Returns true also where there is none. */
bool ref_light_part_read(const uint8_t *bytes, ref_scene_image *image)
{
    uint32_t lights, points, levels;
    const uint8_t *base = ref_section(bytes, REF_LIGHT, &lights);
    const uint8_t *at = ref_section(bytes, REF_POINT_LIGHTS, &points);
    const uint8_t *ramp = ref_section(bytes, REF_RAMP, &levels);
    if (!base) {
        return true;
    }
    image->light = levels >= 2 ? calloc(1, sizeof *image->light) : NULL;
    if (!image->light) {
        return false;
    }
    ref_light_read(image->light, base, at, (int)points, ramp, (int)levels);
    image->scene.light = image->light;
    return true;
}

/* Reads the placements. Returns true also where there are none. */
bool ref_placements_read(const uint8_t *bytes, ref_scene_image *image)
{
    ref_scene *scene = &image->scene;
    uint32_t count;
    const uint8_t *placements = ref_section(bytes, REF_PLACEMENTS, &count);
    (void)ref_section(bytes, REF_MOTIONS, &image->motion_count);
    if (!placements) {
        return true;
    }
    scene->placements = calloc(count, sizeof *scene->placements);
    if (!scene->placements) {
        return false;
    }
    scene->first_turned = scene->instance_count - count;
    for (uint32_t i = 0; i < count; i++) {
        const uint8_t *p = placements + 40 * (size_t)i;
        for (int k = 0; k < 9; k++) {
            scene->placements[i].rows[k / 3][k % 3] = ref_i32(p + 4 * k);
        }
        scene->placements[i].scale = ref_i32(p + 36);
    }
    return true;
}

/* Reads the BSP. Returns true also where there is none. A child's number must be greater than
 * its parent's, because nodes are stored in the order root, front, back. So every path downward
 * ends. */
bool ref_bsp_read(const uint8_t *bytes, ref_scene *scene)
{
    scene->bsp_instance = ref_u32(bytes + 84);
    const uint8_t *bsp_nodes = ref_section(bytes, REF_BSP_NODES, &scene->bsp_node_count);
    if (!bsp_nodes) {
        return true;
    }
    scene->bsp_nodes = calloc(scene->bsp_node_count, sizeof *scene->bsp_nodes);
    if (!scene->bsp_nodes || scene->bsp_instance >= scene->instance_count) {
        return false;
    }
    const ref_model *model = &scene->models[scene->instances[scene->bsp_instance].model];
    for (uint32_t i = 0; i < scene->bsp_node_count; i++) {
        const uint8_t *p = bsp_nodes + 48 * (size_t)i;
        ref_bsp_node *node = &scene->bsp_nodes[i];
        *node = (ref_bsp_node){{ref_i32(p), ref_i32(p + 4), ref_i32(p + 8)},
                               (int64_t)(ref_u32(p + 12) | (uint64_t)ref_u32(p + 16) << 32),
                               ref_u16(p + 20),
                               ref_u16(p + 22),
                               ref_u16(p + 24),
                               ref_u16(p + 26),
                               ref_u16(p + 28)};
        const uint32_t below[2] = {node->front, node->back};
        for (int k = 0; k < 2; k++) {
            if (below[k] != REF_BSP_NONE && (below[k] <= i || below[k] >= scene->bsp_node_count)) {
                return false;
            }
        }
        if (node->first_face + node->face_count > model->face_count) {
            return false;
        }
    }
    return true;
}

/* Tells whether the clusters of a model hold all of its faces. */
static bool clusters_are_sound(const ref_scene *scene, const ref_model *model)
{
    uint32_t faces = 0;
    for (uint32_t i = model->first_cluster; i > 0 && faces < model->face_count; i++) {
        if (i > scene->cluster_count || scene->clusters[i - 1].face_count == 0) {
            return false;
        }
        faces += scene->clusters[i - 1].face_count;
    }
    return model->first_cluster == 0 || faces == model->face_count;
}

/* Reads the clusters. Returns true also where there are none. */
bool ref_clusters_read(const uint8_t *bytes, ref_scene *scene)
{
    const uint8_t *clusters = ref_section(bytes, REF_CLUSTERS, &scene->cluster_count);
    if (clusters) {
        scene->clusters = calloc(scene->cluster_count, sizeof *scene->clusters);
        if (!scene->clusters) {
            return false;
        }
        for (uint32_t i = 0; i < scene->cluster_count; i++) {
            const uint8_t *p = clusters + 48 * (size_t)i;
            scene->clusters[i] = (ref_cluster){ref_point_read(p), ref_i32(p + 12), ref_u16(p + 44)};
        }
    }
    for (uint32_t i = 0; i < scene->model_count; i++) {
        if (!clusters_are_sound(scene, &scene->models[i])) {
            return false;
        }
    }
    return true;
}

/* Reads a distance of 18.46, low word first, with all of its bits. */
static long double distance_read(const uint8_t *bytes)
{
    return ldexpl((long double)ref_i32(bytes + 4), -14) + ldexpl((long double)ref_u32(bytes), -46);
}

static void beam_read(const uint8_t *bytes, ref_beam *beam)
{
    for (int i = 0; i < 3; i++) {
        beam->from[i] = ref_i32(bytes + 4 * i);
    }
    beam->kind = bytes[12];
    beam->plane_count = bytes[13];
    for (int i = 0; i < beam->plane_count && i < 8; i++) {
        const uint8_t *p = bytes + 16 + 20 * i;
        beam->planes[i] = (ref_plane){
            {ldexp(ref_i32(p), -30), ldexp(ref_i32(p + 4), -30), ldexp(ref_i32(p + 8), -30)},
            distance_read(p + 12)};
    }
}

bool ref_beams_read(const uint8_t *bytes, ref_scene *scene)
{
    uint32_t lit_count;
    const uint8_t *beams = ref_section(bytes, REF_BEAMS, &scene->beam_count);
    const uint8_t *lit = ref_section(bytes, REF_LIT_COLOURS, &lit_count);
    if (!beams) {
        return true;
    }
    memcpy(scene->lit, lit, 256);
    scene->beams = calloc(scene->beam_count, sizeof *scene->beams);
    for (uint32_t i = 0; scene->beams && i < scene->beam_count; i++) {
        beam_read(beams + 176 * (size_t)i, &scene->beams[i]);
        if (scene->beams[i].plane_count < 1 || scene->beams[i].plane_count > 8 ||
            scene->beams[i].kind > REF_BEAM_DIRECTION) {
            return false;
        }
    }
    return scene->beams != NULL;
}
