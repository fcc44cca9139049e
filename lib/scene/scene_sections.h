/* SPDX-License-Identifier: MIT */
/* The sections of a scene image, and where its records have their fields (docs/formats.md).
 * Written by `fixel formats` of tools/fixel/image/fields.py: change that. Internal. */
#ifndef FXL_SCENE_SECTIONS_H
#define FXL_SCENE_SECTIONS_H

#include "scene_header.h"

#define IMAGE_VERSION 9u

/* The kinds of sections. */
enum {
    SECTION_PALETTE = 1,
    SECTION_VERTICES = 2,
    SECTION_INDICES = 3,
    SECTION_FACES = 4,
    SECTION_MODELS = 5,
    SECTION_INSTANCES = 6,
    SECTION_POSES = 7,
    SECTION_SEGMENTS = 8,
    SECTION_FACE_BOUNDS = 9,
    SECTION_BSP_NODES = 10,
    SECTION_BEAMS = 11,
    SECTION_LIT_COLOURS = 12,
    SECTION_CLUSTERS = 13,
    SECTION_PLACEMENTS = 14,
    SECTION_MOTIONS = 15,
    SECTION_KEYS_OF_MOTIONS = 16,
    SECTION_LIGHT = 17,
    SECTION_POINT_LIGHTS = 18,
    SECTION_RAMP = 19,
    SECTION_TEXTURES = 20,
    SECTION_TEXELS = 21,
    SECTION_SURFACES = 22,
    SECTION_MAPPED_FACES = 23,
    SECTION_CORNERS = 24,
    SECTION_FACE_MAP = 25,
    SECTION_NORMALS_OF_CORNERS = 26,
    SECTION_BLEND_TABLE = 27,
    SECTION_BILLBOARDS = 28,
    SECTION_BILLBOARD_MAP = 29,
    SECTION_SPRITE_PIXELS = 30,
    SECTION_LENS_CENTRE = 31,
    SECTION_WHOLE_FACES = 32,
    SECTION_LENS_SCALE = 33,
    SECTION_LINES = 34,
    SECTION_LINE_MAP = 35,
    SECTION_HORIZON_SINES = 36,
    SECTION_HORIZON_COLOURS = 37,
    SECTION_KINDS = 38 /* one more than the greatest */
};

/* Of each kind: bytes of an entry, whether a reader that does not know it must refuse the image, the most
 * entries, and its name in a fault. */
#define SECTION_TABLE                                    \
    {3, 1, 256, "palette table"},                        \
    {12, 1, FXL_SCENE_VERTICES_MAX, "vertex table"},     \
    {2, 1, FXL_SCENE_INDICES_MAX, "index table"},        \
    {20, 1, FXL_SCENE_FACES_MAX, "face table"},          \
    {28, 1, FXL_SCENE_MODELS_MAX, "model table"},        \
    {16, 1, FXL_SCENE_INSTANCES_MAX, "instance table"},  \
    {24, 1, FXL_SCENE_PATH_MAX, "path table"},           \
    {4, 1, FXL_SCENE_PATH_MAX, "path table"},            \
    {20, 0, FXL_SCENE_FACES_MAX, "face bounds table"},   \
    {48, 1, FXL_BSP_NODES_MAX, "BSP node table"},        \
    {176, 1, FXL_BEAMS_MAX, "beam table"},               \
    {256, 1, 1, "lit table"},                            \
    {48, 1, FXL_SCENE_CLUSTERS_MAX, "cluster table"},    \
    {40, 1, FXL_SCENE_INSTANCES_MAX, "placement table"}, \
    {76, 1, FXL_SCENE_INSTANCES_MAX, "motion table"},    \
    {32, 1, FXL_MOTION_KEYS_MAX, "motion key table"},    \
    {28, 1, 1, "light table"},                           \
    {20, 1, FXL_LIGHT_POINTS_MAX, "point light table"},  \
    {256, 1, FXL_LIGHT_LEVELS_MAX, "ramp"},              \
    {16, 1, FXL_SCENE_TABLE_MAX, "texture table"},       \
    {1, 1, FXL_SCENE_IMAGE_MAX, "texel table"},          \
    {12, 1, FXL_SCENE_TABLE_MAX, "surface table"},       \
    {8, 1, FXL_SCENE_TABLE_MAX, "mapped face table"},    \
    {12, 1, FXL_SCENE_CORNERS_MAX, "corner table"},      \
    {2, 1, FXL_SCENE_FACES_MAX, "face map"},             \
    {12, 1, FXL_SCENE_TABLE_MAX, "corner normal table"}, \
    {256, 1, 256, "blend table"},                        \
    {32, 1, FXL_SCENE_TABLE_MAX, "billboard table"},     \
    {2, 1, FXL_SCENE_MODELS_MAX, "billboard map"},       \
    {1, 1, FXL_SCENE_IMAGE_MAX, "sprite pixels"},        \
    {8, 1, 1, "lens centre"},                            \
    {4, 1, FXL_SCENE_FACES_MAX, "whole face table"},     \
    {4, 1, 1, "lens scale"},                             \
    {12, 1, FXL_SCENE_FACES_MAX, "line table"},          \
    {4, 1, 65536, "line map"},                           \
    {4, 1, FXL_HORIZON_MAX, "horizon"},                  \
    {1, 1, 65, "horizon colours"},

FXL_STATIC_ASSERT(FXL_SCENE_VERTICES_MAX == 1000000, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_SCENE_INDICES_MAX == 4000000, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_SCENE_FACES_MAX == 1000000, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_SCENE_MODELS_MAX == 65535, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_SCENE_INSTANCES_MAX == 65535, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_SCENE_PATH_MAX == 1000000, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_BSP_NODES_MAX == 65535, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_BEAMS_MAX == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_SCENE_CLUSTERS_MAX == 65535, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_MOTION_KEYS_MAX == 1000000, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_LIGHT_POINTS_MAX == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_LIGHT_LEVELS_MAX == 64, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_SCENE_TABLE_MAX == 65535, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_SCENE_IMAGE_MAX == 16777216, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_SCENE_CORNERS_MAX == 196605, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(FXL_HORIZON_MAX == 64, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_image_header) == 92, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, magic) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, version) == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, section_count) == 6, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, image_size) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, crc) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, width) == 16, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, height) == 18, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, fov) == 20, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, near_z) == 24, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, far_z) == 28, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, inset) == 32, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, background) == 36, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, target) == 37, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, dark) == 38, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, start) == 40, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, start.yaw) == 52, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, acceleration) == 64, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, turn) == 76, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, frame_count) == 80, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, bsp_instance) == 84, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_header, blend_first) == 88, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_image_section) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_point) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_point, x) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_face) == 20, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_face, normal) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_face, count) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_face, material) == 13, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_face, indices) == 14, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_model) == 28, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_model, first_vertex) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_model, kind) == 16, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_model, reserved) == 17, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_model, first_cluster) == 18, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_model, radius) == 20, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_model, first_face_bounds) == 24, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_instance) == 16, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_instance, centre) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_instance, model) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_instance, layer) == 14, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_instance, recolour) == 15, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_pose) == 24, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_pose, position) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_pose, yaw) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_path_segment) == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_path_segment, keys) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_path_segment, frames) == 2, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_face_bounds) == 20, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_face_bounds, height_low) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_face_bounds, box_x) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_bsp_node) == 48, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_bsp_node, normal) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_bsp_node, distance_low) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_bsp_node, front) == 20, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_bsp_node, reserved) == 30, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_bsp_node, centre) == 32, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_bsp_node, radius) == 44, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_beam) == 176, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_beam, from) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_beam, kind) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_beam, plane_count) == 13, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_beam, reserved) == 14, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_beam, planes) == 16, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_beam, planes[0].distance_low) == 28, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_cluster) == 48, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_cluster, centre) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_cluster, radius) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_cluster, axis) == 16, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_cluster, cutoff) == 28, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_cluster, apex) == 32, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_cluster, face_count) == 44, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_cluster, reserved) == 46, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_placement) == 40, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_placement, scale) == 36, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_motion) == 76, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, yaw_step) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, axis) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, spin) == 24, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, radius) == 32, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, circle) == 36, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, extent) == 44, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, scale_low) == 56, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, first_key) == 64, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, parent) == 72, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, repeats) == 74, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion, reserved) == 75, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_motion_key) == 32, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion_key, frame) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion_key, centre) == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion_key, yaw) == 16, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_motion_key, scale) == 28, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_light_base) == 28, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_light_base, ambient) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_light_base, direction) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_light_base, fog_near) == 20, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_point_light) == 20, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_point_light, position) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_point_light, range) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_point_light, strength) == 16, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_scene_texture) == 16, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_texture, texels) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_texture, colours) == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_texture, log_width) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_texture, format) == 10, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_texture, flags) == 11, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_texture, key) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_texture, key_565) == 14, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_direction) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_direction, x) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_scene_billboard) == 32, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_billboard, pixels) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_billboard, colours) == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_billboard, pixel_width) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_billboard, key) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_billboard, bits) == 14, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_billboard, reserved) == 15, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_scene_billboard, width) == 16, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_image_centre) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_centre, x) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_image_scale) == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_image_scale, scale) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_line) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_line, from) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_line, faces) == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_line, colour) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_line, width) == 9, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_line, reserved) == 10, FXL_AS_DOCUMENTED);

#endif
