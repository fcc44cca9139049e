/* SPDX-License-Identifier: MIT */
/* Opens a scene image (docs/formats.md, section 1) in place. */
#include "../math/arith.h"
#include "../math/memory.h"
#include "fixel/camera.h"
#include "fixel/scene.h"
#include "scene_check.h"
#include "scene_sections.h"

/* place field: what sets the pointer */
/* Of a section, which need not be there: its first entry, else null; and how many there are. */
static __attribute__((noinline)) const void *first_of(const fxl_image_header *head, uint32_t kind)
{
    const fxl_image_section *one = fxl_scene_section(head, kind);
    return one != NULL ? (const uint8_t *)head + one->offset : NULL;
}

static __attribute__((noinline)) uint32_t count_of(const fxl_image_header *head, uint32_t kind)
{
    const fxl_image_section *one = fxl_scene_section(head, kind);
    return one != NULL ? one->count : 0;
}

/* An image says where the centre is only if that is not the middle, so a scene has one image. The
 * lens of one with a scale has no focal length, with which no renderer takes it. */
static FXL_COLD fxl_status check_lens(const fxl_image_header *head, fxl_scene_image *opened)
{
    const fxl_image_scale *scale = (const fxl_image_scale *)first_of(head, SECTION_LENS_SCALE);
    fxl_lens *lens = &opened->lens;
    const fxl_image_centre *centre = (const fxl_image_centre *)first_of(head, SECTION_LENS_CENTRE);
    fxl_status status = fxl_lens_from_fov(head->width, head->height, head->fov, head->near_z,
                                          head->far_z, head->inset, lens);
    opened->scale = 0;
    if (status == FXL_OK && centre != NULL) {
        status = fxl_lens_set_centre(lens, centre->x, centre->y);
        status = status == FXL_OK && lens->off_centre == NULL ? FXL_E_RESERVED : status;
    }
    if (status == FXL_OK && scale != NULL) {
        opened->scale = scale->scale;
        lens->focal = 0;
        status = scale->scale >= FXL_ORTHOGRAPHIC_SCALE_MIN &&
                         scale->scale <= FXL_ORTHOGRAPHIC_SCALE_MAX && head->inset == 0
                     ? FXL_OK
                     : FXL_E_RANGE;
    }
    return status;
}

/* place pixel-format: target of the image's header */
/* Lens, start pose and motion limits. */
/* formats 1.1 */
static FXL_COLD fxl_status check_settings(const fxl_image_header *head, fxl_scene_image *opened,
                                          fxl_scene_fault *fault)
{
    fxl_status status = check_lens(head, opened);
    if (status != FXL_OK) {
        return fxl_fault_at(fault, "lens", 0, status);
    }
    opened->background = head->background;
    opened->depth_bits = (uint8_t)(16 * (head->target % 4));
    opened->pixel_bits = head->target & 4 ? 16 : 8;
    opened->by_distance = (head->target & 8) != 0;
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

static FXL_COLD fxl_status check_light(const fxl_scene_light *light, fxl_scene_fault *fault)
{
    fxl_light_settings settings;
    if (light->base == NULL) {
        return FXL_OK;
    }
    fxl_light_settings_of(light, &settings);
    return fxl_light_check(&settings, fault);
}

static FXL_COLD fxl_status check_path(const fxl_scene_image *opened, fxl_scene_fault *fault)
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

static void open_geometry(const fxl_image_header *head, fxl_scene *scene)
{
    scene->vertices = (const fxl_point *)first_of(head, SECTION_VERTICES);
    scene->vertex_count = count_of(head, SECTION_VERTICES);
    scene->indices = (const uint16_t *)first_of(head, SECTION_INDICES);
    scene->index_count = count_of(head, SECTION_INDICES);
    scene->faces = (const fxl_face *)first_of(head, SECTION_FACES);
    scene->wholes = (const uint32_t *)first_of(head, SECTION_WHOLE_FACES);
    scene->face_count = count_of(head, SECTION_FACES);
    scene->models = (const fxl_model *)first_of(head, SECTION_MODELS);
    scene->model_count = count_of(head, SECTION_MODELS);
    scene->instances = (const fxl_instance *)first_of(head, SECTION_INSTANCES);
    scene->instance_count = count_of(head, SECTION_INSTANCES);
    scene->face_bounds = (const fxl_face_bounds *)first_of(head, SECTION_FACE_BOUNDS);
    scene->face_bounds_count = count_of(head, SECTION_FACE_BOUNDS);
    scene->bsp_nodes = (const fxl_bsp_node *)first_of(head, SECTION_BSP_NODES);
    scene->bsp_node_count = count_of(head, SECTION_BSP_NODES);
    scene->bsp_instance = head->bsp_instance;
    scene->clusters = (const fxl_cluster *)first_of(head, SECTION_CLUSTERS);
    scene->cluster_count = count_of(head, SECTION_CLUSTERS);
    scene->beams = (const fxl_beam *)first_of(head, SECTION_BEAMS);
    scene->beam_count = count_of(head, SECTION_BEAMS);
    scene->lit = (const uint8_t *)first_of(head, SECTION_LIT_COLOURS);
    scene->placements = (const fxl_placement *)first_of(head, SECTION_PLACEMENTS);
    if (scene->placements != NULL) {
        scene->first_turned = scene->instance_count - count_of(head, SECTION_PLACEMENTS);
    }
}

static void open_surfaces(const fxl_image_header *head, fxl_scene_surfaces *to)
{
    to->textures = (const fxl_scene_texture *)first_of(head, SECTION_TEXTURES);
    to->texture_count = count_of(head, SECTION_TEXTURES);
    to->texels = (const uint8_t *)first_of(head, SECTION_TEXELS);
    to->texel_bytes = count_of(head, SECTION_TEXELS);
    to->surfaces = (const fxl_surface *)first_of(head, SECTION_SURFACES);
    to->surface_count = count_of(head, SECTION_SURFACES);
    to->faces = (const fxl_mapped_face *)first_of(head, SECTION_MAPPED_FACES);
    to->face_count = count_of(head, SECTION_MAPPED_FACES);
    to->face_map = (const uint16_t *)first_of(head, SECTION_FACE_MAP);
    to->corners = (const fxl_corner *)first_of(head, SECTION_CORNERS);
    to->corner_count = count_of(head, SECTION_CORNERS);
    to->normals = (const fxl_direction *)first_of(head, SECTION_NORMALS_OF_CORNERS);
    to->normal_count = count_of(head, SECTION_NORMALS_OF_CORNERS);
    to->blend = (const uint8_t *)first_of(head, SECTION_BLEND_TABLE);
    to->blend_count = count_of(head, SECTION_BLEND_TABLE);
    to->blend_first = head->blend_first;
}

/* Has what is opened point to the sections. */
static void open_sections(const fxl_image_header *head, fxl_scene_image *opened)
{
    open_geometry(head, &opened->scene);
    open_surfaces(head, &opened->surfaces);
    opened->palette = (const uint8_t *)first_of(head, SECTION_PALETTE);
    opened->poses = (const fxl_pose *)first_of(head, SECTION_POSES);
    opened->segments = (const fxl_path_segment *)first_of(head, SECTION_SEGMENTS);
    opened->path_count = count_of(head, SECTION_POSES) + count_of(head, SECTION_SEGMENTS);
    opened->frame_count = head->frame_count;
    opened->motion.motions = (const fxl_motion *)first_of(head, SECTION_MOTIONS);
    opened->motion.motion_count = count_of(head, SECTION_MOTIONS);
    opened->motion.keys = (const fxl_motion_key *)first_of(head, SECTION_KEYS_OF_MOTIONS);
    opened->motion.key_count = count_of(head, SECTION_KEYS_OF_MOTIONS);
    opened->light.base = (const fxl_light_base *)first_of(head, SECTION_LIGHT);
    opened->light.points = (const fxl_point_light *)first_of(head, SECTION_POINT_LIGHTS);
    opened->light.point_count = count_of(head, SECTION_POINT_LIGHTS);
    opened->light.ramp = (const uint8_t *)first_of(head, SECTION_RAMP);
    opened->light.levels = count_of(head, SECTION_RAMP);
    opened->light.dark = head->dark;
    opened->billboards.billboards = (const fxl_scene_billboard *)first_of(head, SECTION_BILLBOARDS);
    opened->billboards.count = count_of(head, SECTION_BILLBOARDS);
    opened->billboards.model_map = (const uint16_t *)first_of(head, SECTION_BILLBOARD_MAP);
    opened->billboards.pixels = (const uint8_t *)first_of(head, SECTION_SPRITE_PIXELS);
    opened->billboards.pixel_bytes = count_of(head, SECTION_SPRITE_PIXELS);
    opened->lines.lines = (const fxl_line *)first_of(head, SECTION_LINES);
    opened->lines.count = count_of(head, SECTION_LINES);
    opened->lines.line_map = (const uint32_t *)first_of(head, SECTION_LINE_MAP);
    opened->horizon.sines = (const fxl_q2_30 *)first_of(head, SECTION_HORIZON_SINES);
    opened->horizon.count = count_of(head, SECTION_HORIZON_SINES);
    opened->horizon.colours = (const uint8_t *)first_of(head, SECTION_HORIZON_COLOURS);
}

/* formats 1.5 */
FXL_COLD fxl_status fxl_scene_open(const void *image, size_t size, fxl_scene_image *opened,
                                   fxl_scene_fault *fault)
{
    if (image == NULL || opened == NULL) {
        return fxl_fault_at(fault, "image", 0, FXL_E_ARGUMENT);
    }
    if ((uintptr_t)image % 4 != 0) {
        return fxl_fault_at(fault, "image", 0, FXL_E_ALIGNMENT);
    }
    const fxl_image_header *head = (const fxl_image_header *)image;
    fxl_scene_image found;
    memset(&found, 0, sizeof found);
    fxl_status status = fxl_scene_sections_check(head, size, fault);
    if (status == FXL_OK) {
        status = check_settings(head, &found, fault);
    }
    if (status != FXL_OK) {
        return status;
    }
    open_sections(head, &found);
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
