/* SPDX-License-Identifier: MIT */
/* Opens a scene image (docs/formats.md, section 1) in place. */
#include "../math/arith.h"
#include "../math/memory.h"
#include "fault.h"
#include "fixel/scene.h"
#include "fixel/stage/lens.h"
#include "motion_limits.h"
#include "scene_sections.h"

/* An image says where the centre is only if that is not the middle, so a scene has one image. */
static fxl_status check_lens(const fxl_image_header *head, const fxl_image_table *found, fxl_lens *lens)
{
    const fxl_image_centre *centre = (const fxl_image_centre *)found[SECTION_LENS_CENTRE].first;
    fxl_status status = fxl_lens_from_fov(head->width, head->height, head->fov, head->near_z,
                                          head->far_z, head->inset, lens);
    if (status != FXL_OK || centre == NULL) {
        return status;
    }
    status = fxl_lens_set_centre(lens, centre->x, centre->y);
    return status == FXL_OK && lens->off_centre == NULL ? FXL_E_RESERVED : status;
}

/* Lens, start pose and motion limits. */
static fxl_status check_settings(const fxl_image_header *head, const fxl_image_table *found, fxl_scene_image *opened,
                                 fxl_scene_fault *fault)
{
    fxl_status status = check_lens(head, found, &opened->lens);
    if (status != FXL_OK) {
        return fxl_fault_at(fault, "lens", 0, status);
    }
    opened->background = head->background;
    opened->visibility = head->visibility; /* bug: wish-of-image */
    opened->start.pose = head->start;
    opened->start.speed = 0;
    opened->start.clamped = 0;
    opened->motion_limits.acceleration = head->acceleration;
    opened->motion_limits.friction = head->friction;
    opened->motion_limits.speed_max = head->speed_max;
    opened->motion_limits.turn = head->turn;
    if (!fxl_point_in_range(&head->start.position)) {
        return fxl_fault_at(fault, "start pose", 0, FXL_E_RANGE);
    }
    if (!fxl_motion_limits_in_range(&opened->motion_limits)) {
        return fxl_fault_at(fault, "motion limits", 0, FXL_E_RANGE);
    }
    return FXL_OK;
}

static fxl_status check_light(const fxl_scene_light *light, fxl_scene_fault *fault)
{
    fxl_light_settings settings;
    if (light->base == NULL) {
        return FXL_OK;
    }
    fxl_light_settings_of(light, &settings);
    return fxl_light_check(&settings, fault);
}

static fxl_status check_path(const fxl_scene_image *opened, fxl_scene_fault *fault)
{
    uint64_t frames = 0; /* at most 10^6 entries of 16 bits */
    for (uint32_t i = 0; i < opened->path_count; i++) {
        if (opened->poses != NULL) {
            if (!fxl_point_in_range(&opened->poses[i].position)) {
                return fxl_fault_at(fault, "pose", i, FXL_E_RANGE);
            }
            frames += 1;
            continue;
        }
        const fxl_path_segment *segment = &opened->segments[i];
        if ((segment->keys & ~(uint32_t)FXL_KEY_ALL) != 0) {
            return fxl_fault_at(fault, "path segment", i, FXL_E_RESERVED);
        }
        if (segment->frames == 0) {
            return fxl_fault_at(fault, "path segment", i, FXL_E_COUNT);
        }
        frames += segment->frames;
    }
    if (frames != opened->frame_count || frames > FXL_SCENE_PATH_MAX) {
        return fxl_fault_at(fault, "path table", 0, FXL_E_COUNT);
    }
    return FXL_OK;
}

static void open_geometry(const fxl_image_header *head, const fxl_image_table *found, fxl_scene *scene)
{
    scene->vertices = (const fxl_point *)found[SECTION_VERTICES].first;
    scene->vertex_count = found[SECTION_VERTICES].count;
    scene->indices = (const uint16_t *)found[SECTION_INDICES].first;
    scene->index_count = found[SECTION_INDICES].count;
    scene->faces = (const fxl_face *)found[SECTION_FACES].first;
    scene->face_count = found[SECTION_FACES].count;
    scene->models = (const fxl_model *)found[SECTION_MODELS].first;
    scene->model_count = found[SECTION_MODELS].count;
    scene->instances = (const fxl_instance *)found[SECTION_INSTANCES].first;
    scene->instance_count = found[SECTION_INSTANCES].count;
    scene->face_bounds = (const fxl_face_bounds *)found[SECTION_FACE_BOUNDS].first;
    scene->face_bounds_count = found[SECTION_FACE_BOUNDS].count;
    scene->bsp_nodes = (const fxl_bsp_node *)found[SECTION_BSP_NODES].first;
    scene->bsp_node_count = found[SECTION_BSP_NODES].count;
    scene->bsp_instance = head->bsp_instance;
    scene->clusters = (const fxl_cluster *)found[SECTION_CLUSTERS].first;
    scene->cluster_count = found[SECTION_CLUSTERS].count;
    scene->beams = (const fxl_beam *)found[SECTION_BEAMS].first;
    scene->beam_count = found[SECTION_BEAMS].count;
    scene->lit = (const uint8_t *)found[SECTION_LIT_COLOURS].first;
    scene->turns = (const fxl_turn *)found[SECTION_TURNS].first;
    if (scene->turns != NULL) {
        scene->first_turned = scene->instance_count - found[SECTION_TURNS].count;
    }
}

static void open_surfaces(const fxl_image_header *head, const fxl_image_table *found, fxl_scene_surfaces *to)
{
    to->textures = (const fxl_scene_texture *)found[SECTION_TEXTURES].first;
    to->texture_count = found[SECTION_TEXTURES].count;
    to->texels = (const uint8_t *)found[SECTION_TEXELS].first;
    to->texel_bytes = found[SECTION_TEXELS].count;
    to->surfaces = (const fxl_surface *)found[SECTION_SURFACES].first;
    to->surface_count = found[SECTION_SURFACES].count;
    to->faces = (const fxl_mapped_face *)found[SECTION_MAPPED_FACES].first;
    to->face_count = found[SECTION_MAPPED_FACES].count;
    to->face_map = (const uint16_t *)found[SECTION_FACE_MAP].first;
    to->normals = (const fxl_direction *)found[SECTION_NORMALS_OF_CORNERS].first;
    to->normal_count = found[SECTION_NORMALS_OF_CORNERS].count;
    to->blend = (const uint8_t *)found[SECTION_BLEND_TABLE].first;
    to->blend_count = found[SECTION_BLEND_TABLE].count;
    to->blend_first = head->blend_first;
}

/* Has what is opened point to the sections. */
static void open_sections(const fxl_image_header *head, const fxl_image_table *found, fxl_scene_image *opened)
{
    open_geometry(head, found, &opened->scene);
    open_surfaces(head, found, &opened->surfaces);
    opened->palette = (const uint8_t *)found[SECTION_PALETTE].first;
    opened->poses = (const fxl_pose *)found[SECTION_POSES].first;
    opened->segments = (const fxl_path_segment *)found[SECTION_SEGMENTS].first;
    opened->path_count = found[SECTION_POSES].count + found[SECTION_SEGMENTS].count;
    opened->frame_count = head->frame_count;
    opened->motion.motions = (const fxl_motion *)found[SECTION_MOTIONS].first;
    opened->motion.motion_count = found[SECTION_MOTIONS].count;
    opened->motion.keys = (const fxl_motion_key *)found[SECTION_KEYS_OF_MOTIONS].first;
    opened->motion.key_count = found[SECTION_KEYS_OF_MOTIONS].count;
    opened->light.base = (const fxl_light_base *)found[SECTION_LIGHT].first;
    opened->light.points = (const fxl_point_light *)found[SECTION_POINT_LIGHTS].first;
    opened->light.point_count = found[SECTION_POINT_LIGHTS].count;
    opened->light.ramp = (const uint8_t *)found[SECTION_RAMP].first;
    opened->light.levels = found[SECTION_RAMP].count; /* bug: light-ramp-of-image */
    opened->billboards.billboards = (const fxl_scene_billboard *)found[SECTION_BILLBOARDS].first;
    opened->billboards.count = found[SECTION_BILLBOARDS].count;
    opened->billboards.model_map = (const uint16_t *)found[SECTION_BILLBOARD_MAP].first;
    opened->billboards.pixels = (const uint8_t *)found[SECTION_SPRITE_PIXELS].first;
    opened->billboards.pixel_bytes = found[SECTION_SPRITE_PIXELS].count;
}

fxl_status fxl_scene_open(const void *image, size_t size, fxl_scene_image *opened,
                          fxl_scene_fault *fault)
{
    if (image == NULL || opened == NULL) {
        return fxl_fault_at(fault, "image", 0, FXL_E_ARGUMENT);
    }
    if ((uintptr_t)image % 4 != 0) {
        return fxl_fault_at(fault, "image", 0, FXL_E_ALIGNMENT);
    }
    const fxl_image_header *head = (const fxl_image_header *)image;
    fxl_image_table sections[SECTION_KINDS];
    fxl_scene_image found;
    memset(sections, 0, sizeof sections);
    memset(&found, 0, sizeof found);
    fxl_status status = fxl_scene_sections_find(head, size, sections, fault);
    if (status == FXL_OK) {
        status = check_settings(head, sections, &found, fault);
    }
    if (status != FXL_OK) {
        return status;
    }
    open_sections(head, sections, &found);
    status = fxl_scene_check_all(&found.scene, fault);
    if (status == FXL_OK && found.motion.motions != NULL) {
        status = fxl_motion_check(&found.motion, &found.scene, fault);
    }
    if (status == FXL_OK) {
        status = check_light(&found.light, fault);
    }
    if (status == FXL_OK) {
        status = check_path(&found, fault);
    }
    if (status == FXL_OK) {
        *opened = found;
    }
    return status;
}
