/* SPDX-License-Identifier: MIT */
/* Opens a scene image (docs/formats.md, section 1) in place. */
#include "../math/arith.h"
#include "../math/memory.h"
#include "crc.h"
#include "fault.h"
#include "fixel/scene.h"
#include "fixel/stage/lens.h"
#include "motion_limits.h"
#include "scene_header.h"

static bool header_size_is_known(const header *head)
{
    if (head->version == VERSION_BOARDS) {
        return head->header_size == BOARD_HEADER_SIZE;
    }
    if (head->version == VERSION_LIGHT) {
        return head->header_size == LIGHT_HEADER_SIZE || head->header_size == SURFACE_HEADER_SIZE;
    }
    if (head->version == VERSION_TURNS) {
        return head->header_size == TURN_HEADER_SIZE;
    }
    if (head->version == VERSION_CLUSTERS) {
        return head->header_size == CLUSTER_HEADER_SIZE;
    }
    return head->header_size == sizeof *head ||
           (head->version == VERSION_MORE && head->header_size == BEAM_HEADER_SIZE);
}

/* *what is "image", and becomes "header" if only the header's own size is wrong. */
static fxl_status check_envelope(const header *head, size_t size, const char **what)
{
    if (size < sizeof *head) {
        return FXL_E_SIZE;
    }
    if (head->magic != MAGIC) {
        return FXL_E_MAGIC;
    }
    if (head->version < VERSION || head->version > VERSION_BOARDS) {
        return FXL_E_VERSION;
    }
    if (!header_size_is_known(head)) {
        *what = "header";
        return FXL_E_SIZE;
    }
    if (head->image_size < head->header_size || head->image_size > FXL_SCENE_IMAGE_MAX ||
        head->image_size % 4 != 0 || head->image_size > size) {
        return FXL_E_SIZE;
    }
    const uint8_t *bytes = (const uint8_t *)head;
    if (fxl_crc32(bytes + 16, head->image_size - 16) != head->crc) {
        return FXL_E_CRC;
    }
    if (head->has_centre > 1 || head->visibility > FXL_SCENE_BY_DEPTH || /* bug: wish-known */
        head->path_kind > PATH_SEGMENTS) {
        return FXL_E_RESERVED;
    }
    if (head->image_size - head->header_size < head->has_centre * sizeof(lens_centre)) {
        *what = "header"; /* bug: centre-behind */
        return FXL_E_SIZE;
    }
    if (beam_header_of(head) != NULL && beam_header_of(head)->reserved != 0) {
        return FXL_E_RESERVED;
    }
    bool has_bsp = (head->bsp_nodes.offset | head->bsp_nodes.count | head->bsp_instance) != 0;
    if (has_bsp && head->version == VERSION) {
        return FXL_E_RESERVED;
    }
    const surface_header *surfaces = surface_header_of(head);
    if (surfaces != NULL &&
        (surfaces->reserved != 0 || (surfaces->blend.count == 0 && surfaces->blend_first != 0))) {
        return FXL_E_RESERVED;
    }
    /* An image has VERSION_MORE only if it has a tree or beams, so a scene has one image. */
    return head->version == VERSION || has_bsp || beam_header_of(head) != NULL ? FXL_OK
                                                                               : FXL_E_VERSION;
}

/* An image says where the centre is only if that is not the middle, so a scene has one image. */
static fxl_status check_lens(const header *head, fxl_lens *lens)
{
    fxl_status status = fxl_lens_from_fov(head->width, head->height, head->fov, head->near_z,
                                          head->far_z, head->inset, lens);
    if (status != FXL_OK || head->has_centre == 0) {
        return status;
    }
    const lens_centre *centre =
        (const lens_centre *)(const void *)((const uint8_t *)head + head->header_size);
    status = fxl_lens_set_centre(lens, centre->x, centre->y);
    return status == FXL_OK && lens->off_centre == NULL ? FXL_E_RESERVED : status;
}

/* Lens, start pose and motion limits. */
static fxl_status check_settings(const header *head, fxl_scene_image *opened,
                                 fxl_scene_fault *fault)
{
    fxl_status status = check_lens(head, &opened->lens);
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

fxl_status fxl_scene_open(const void *image, size_t size, fxl_scene_image *opened,
                          fxl_scene_fault *fault)
{
    if (image == NULL || opened == NULL) {
        return fxl_fault_at(fault, "image", 0, FXL_E_ARGUMENT);
    }
    if ((uintptr_t)image % 4 != 0) {
        return fxl_fault_at(fault, "image", 0, FXL_E_ALIGNMENT);
    }
    const header *head = (const header *)image;
    const char *what = "image";
    fxl_status status = check_envelope(head, size, &what);
    if (status != FXL_OK) {
        return fxl_fault_at(fault, what, 0, status);
    }
    fxl_scene_image found;
    memset(&found, 0, sizeof found);
    status = check_settings(head, &found, fault);
    if (status != FXL_OK) {
        return status;
    }
    status = fxl_scene_tables_check(head, fault);
    if (status != FXL_OK) {
        return status;
    }
    fxl_scene_tables_open(head, &found);
    status = fxl_scene_check_all(&found.scene, fault);
    if (status != FXL_OK) {
        return status;
    }
    if (turn_header_of(head) != NULL) {
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
