/* SPDX-License-Identifier: MIT */
/* A scene whose tables are those of its image, in place. */
#include "scene_header.h"

static const void *at(const header *head, uint32_t offset)
{
    return (const uint8_t *)head + offset;
}

static void point_to_turns(const header *head, fxl_scene_image *opened)
{
    const turn_header *more = turn_header_of(head);
    if (more == NULL) {
        return;
    }
    if (more->turns.count > 0) {
        opened->scene.turns = (const fxl_turn *)at(head, more->turns.offset);
        opened->scene.first_turned = head->instances.count - more->turns.count;
    }
    if (more->motions.count > 0) {
        opened->motion.motions = (const fxl_motion *)at(head, more->motions.offset);
        opened->motion.motion_count = more->motions.count;
    }
    if (more->keys.count > 0) {
        opened->motion.keys = (const fxl_motion_key *)at(head, more->keys.offset);
        opened->motion.key_count = more->keys.count;
    }
}

static void point_to_light(const header *head, fxl_scene_image *opened)
{
    const light_header *more = light_header_of(head);
    if (more == NULL || more->light.count == 0) {
        return;
    }
    opened->light.base = (const fxl_light_base *)at(head, more->light.offset);
    if (more->points.count > 0) {
        opened->light.points = (const fxl_point_light *)at(head, more->points.offset);
        opened->light.point_count = more->points.count;
    }
    opened->light.ramp = (const uint8_t *)at(head, more->ramp.offset);
    opened->light.levels = more->ramp.count; /* bug: light-ramp-of-image */
}

static void point_to_surfaces(const header *head, fxl_scene_image *opened)
{
    const surface_header *more = surface_header_of(head);
    fxl_scene_surfaces *to = &opened->surfaces;
    if (more == NULL || more->face_map.count == 0) {
        return;
    }
    to->textures = (const fxl_scene_texture *)at(head, more->textures.offset);
    to->texels = (const uint8_t *)at(head, more->texels.offset);
    to->surfaces = (const fxl_surface *)at(head, more->surfaces.offset);
    to->faces = (const fxl_mapped_face *)at(head, more->mapped_faces.offset);
    to->face_map = (const uint16_t *)at(head, more->face_map.offset);
    to->normals = (const fxl_direction *)at(head, more->corner_normals.offset);
    to->texture_count = more->textures.count;
    to->texel_bytes = more->texels.count;
    to->surface_count = more->surfaces.count;
    to->face_count = more->mapped_faces.count;
    to->normal_count = more->corner_normals.count;
    if (more->blend.count > 0) {
        to->blend = (const uint8_t *)at(head, more->blend.offset);
        to->blend_count = more->blend.count;
        to->blend_first = more->blend_first;
    }
}

static void point_to_billboards(const header *head, fxl_scene_image *opened)
{
    const billboard_header *more = billboard_header_of(head);
    fxl_scene_billboards *to = &opened->billboards;
    if (more == NULL) {
        return;
    }
    to->billboards = (const fxl_scene_billboard *)at(head, more->billboards.offset);
    to->model_map = (const uint16_t *)at(head, more->model_map.offset);
    to->pixels = (const uint8_t *)at(head, more->pixels.offset);
    to->count = more->billboards.count;
    to->pixel_bytes = more->pixels.count;
}

void fxl_scene_tables_open(const header *head, fxl_scene_image *opened)
{
    opened->palette = (const uint8_t *)at(head, head->palette.offset);
    opened->scene.vertices = (const fxl_point *)at(head, head->vertices.offset);
    opened->scene.indices = (const uint16_t *)at(head, head->indices.offset);
    opened->scene.faces = (const fxl_face *)at(head, head->faces.offset);
    opened->scene.models = (const fxl_model *)at(head, head->models.offset);
    opened->scene.instances = (const fxl_instance *)at(head, head->instances.offset);
    opened->scene.face_bounds = head->face_bounds.count > 0
                                    ? (const fxl_face_bounds *)at(head, head->face_bounds.offset)
                                    : NULL;
    opened->scene.face_bounds_count = head->face_bounds.count;
    opened->scene.bsp_nodes =
        head->bsp_nodes.count > 0 ? (const fxl_bsp_node *)at(head, head->bsp_nodes.offset) : NULL;
    opened->scene.bsp_node_count = head->bsp_nodes.count;
    opened->scene.bsp_instance = head->bsp_instance;
    if (cluster_header_of(head) != NULL && cluster_header_of(head)->clusters.count > 0) {
        const table *clusters = &cluster_header_of(head)->clusters;
        opened->scene.clusters = (const fxl_cluster *)at(head, clusters->offset);
        opened->scene.cluster_count = clusters->count;
    }
    if (beam_header_of(head) != NULL && beam_header_of(head)->beams.count > 0) {
        opened->scene.beams = (const fxl_beam *)at(head, beam_header_of(head)->beams.offset);
        opened->scene.beam_count = beam_header_of(head)->beams.count;
        opened->scene.lit = (const uint8_t *)at(head, beam_header_of(head)->lit);
    }
    point_to_turns(head, opened);
    point_to_light(head, opened);
    point_to_surfaces(head, opened);
    point_to_billboards(head, opened);
    opened->scene.vertex_count = head->vertices.count;
    opened->scene.index_count = head->indices.count;
    opened->scene.face_count = head->faces.count;
    opened->scene.model_count = head->models.count;
    opened->scene.instance_count = head->instances.count;
    opened->poses =
        head->path_kind == PATH_POSES ? (const fxl_pose *)at(head, head->path.offset) : NULL;
    opened->segments = head->path_kind == PATH_SEGMENTS
                           ? (const fxl_path_segment *)at(head, head->path.offset)
                           : NULL;
    opened->path_count = head->path.count;
    opened->frame_count = head->frame_count;
}
