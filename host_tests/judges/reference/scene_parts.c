/* SPDX-License-Identifier: MIT */
#include "reference/scene_parts.h"

#include "reference/light.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Reads the light of an image of version 6. Returns true also where there is none. */
bool ref_light_part_read(const uint8_t *bytes, size_t size, ref_scene_image *image)
{
    uint32_t lights, points = 0, levels;
    if (ref_u16(bytes + 4) < 6 || (ref_u16(bytes + 6) > 232 && ref_u32(bytes + 212) == 0)) {
        return true;
    }
    const uint8_t *base = ref_image_table(bytes, size, 208, 28, 1, &lights);
    const uint8_t *at = ref_image_table(bytes, size, 216, 20, REF_LIGHT_POINTS_MAX, &points);
    const uint8_t *ramp = ref_image_table(bytes, size, 224, 256, REF_LIGHT_LEVELS_MAX, &levels);
    image->light = base && ramp && levels >= 2 ? calloc(1, sizeof *image->light) : NULL;
    if (!image->light || (!at && ref_u32(bytes + 220) != 0)) {
        return false;
    }
    ref_light_read(image->light, base, at, (int)points, ramp, (int)levels);
    image->scene.light = image->light;
    return true;
}

/* Reads the turns of an image of version 5 or later. Returns true also where there are none. */
bool ref_turns_read(const uint8_t *bytes, size_t size, ref_scene_image *image)
{
    ref_scene *scene = &image->scene;
    uint32_t count;
    if (ref_u16(bytes + 4) < 5 || (ref_u16(bytes + 4) > 5 && ref_u32(bytes + 188) == 0)) {
        return true;
    }
    const uint8_t *turns = ref_image_table(bytes, size, 184, 40, scene->instance_count, &count);
    image->motion_count = ref_u32(bytes + 196);
    scene->turns = turns ? calloc(count, sizeof *scene->turns) : NULL;
    if (!scene->turns || image->motion_count > count) {
        return false;
    }
    scene->first_turned = scene->instance_count - count;
    for (uint32_t i = 0; i < count; i++) {
        const uint8_t *p = turns + 40 * (size_t)i;
        for (int k = 0; k < 9; k++) {
            scene->turns[i].rows[k / 3][k % 3] = ref_i32(p + 4 * k);
        }
        scene->turns[i].scale = ref_i32(p + 36);
    }
    return true;
}

/* Reads the BSP. Returns true also where there is none. A child's number must be greater than
 * its parent's, because nodes are stored in the order root, front, back. So every path downward
 * ends. */
bool ref_bsp_read(const uint8_t *bytes, size_t size, ref_scene *scene)
{
    if (ref_u16(bytes + 4) == 2) {
        return ref_u32(bytes + 148) == 0 && ref_u32(bytes + 152) == 0 && ref_u32(bytes + 156) == 0;
    }
    scene->bsp_instance = ref_u32(bytes + 156);
    if (ref_u32(bytes + 152) == 0) {
        return ref_u32(bytes + 148) == 0 && scene->bsp_instance == 0;
    }
    const uint8_t *bsp_nodes = ref_image_table(bytes, size, 148, 48, 65535, &scene->bsp_node_count);
    scene->bsp_nodes = bsp_nodes ? calloc(scene->bsp_node_count, sizeof *scene->bsp_nodes) : NULL;
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
bool ref_clusters_read(const uint8_t *bytes, size_t size, ref_scene *scene)
{
    if (ref_u16(bytes + 6) >= 184 && (ref_u16(bytes + 4) == 4 || ref_u32(bytes + 180) > 0)) {
        const uint8_t *clusters =
            ref_image_table(bytes, size, 176, 48, 65535, &scene->cluster_count);
        scene->clusters = clusters ? calloc(scene->cluster_count, sizeof *scene->clusters) : NULL;
        for (uint32_t i = 0; scene->clusters && i < scene->cluster_count; i++) {
            const uint8_t *p = clusters + 48 * (size_t)i;
            scene->clusters[i] = (ref_cluster){ref_point_read(p), ref_i32(p + 12), ref_u16(p + 44)};
        }
        if (!scene->clusters) {
            return false;
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

bool ref_beams_read(const uint8_t *bytes, size_t size, ref_scene *scene)
{
    /* With clusters or turns the header has the fields of beams also where there are none. */
    if (ref_u16(bytes + 6) == 160 || (ref_u16(bytes + 6) >= 184 && ref_u32(bytes + 164) == 0)) {
        return true;
    }
    const uint8_t *beams = ref_image_table(bytes, size, 160, 176, 4, &scene->beam_count);
    uint64_t lit = ref_u32(bytes + 168);
    if (!beams || lit + 256 > size) {
        return false;
    }
    memcpy(scene->lit, bytes + lit, 256);
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
