/* SPDX-License-Identifier: MIT */
#include "reference/scene_parts.h"

#include "reference/light.h"
/* place field: the reference's reader: sizes of entries, and offsets as numbers */
#include "reference/sections.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
