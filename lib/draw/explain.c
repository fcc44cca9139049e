/* SPDX-License-Identifier: MIT */
/* Sentences about calls that were refused. Each function looks at the arguments in the order in
 * which the call does. A file of its own, so that a program which asks for no sentence does not
 * link it. */
#include "../math/arith.h"
#include "../raster/columns.h"
#include "../scene/lens.h"
#include "../scene/placement_code.h"
#include "../view/outcode.h"
#include "../view/view.h"
#include "renderer.h"

#define NULL_RENDERER    "renderer must not be null"
#define NOT_INITIALISED  "renderer was never initialised: fxl_renderer_init must answer FXL_OK first"
#define NOT_ALIGNED_TO_2 "pixels must begin at an even address: a pixel of RGB565 takes 2 bytes"

static const char *explain_lens(const fxl_config *config, fxl_lens *lens)
{
    if (config->width < 1 || config->width > FXL_SCREEN_MAX) {
        return "config->width must be 1..1024 pixels";
    }
    if (config->height < 1 || config->height > FXL_SCREEN_MAX) {
        return "config->height must be 1..1024 pixels";
    }
    if (config->fov < FXL_FOV_MIN || config->fov > FXL_FOV_MAX) {
        return "config->fov must be FXL_DEGREES(10)..FXL_DEGREES(150)";
    }
    if (config->near_z < FXL_NEAR_MIN) {
        return "config->near_z must be at least FXL_RATIO(1, 256) world units";
    }
    if (config->far_z < 0 || config->far_z > FXL_FAR_MAX) {
        return "config->far_z must be at most FXL_UNITS(32767) world units";
    }
    if (config->inset < 0 || config->inset > FXL_INSET_MAX) {
        return "config->inset must be 0..FXL_UNITS(1)";
    }
    return fxl_lens_from_fov(config->width, config->height, config->fov, config->near_z,
                             config->far_z, config->inset, lens) == FXL_OK
               ? NULL
               : "config->far_z must be more than config->near_z + 2 config->inset";
}

static const char *explain_target(const fxl_config *config, const fxl_lens *lens)
{
    const fxl_target *target = config->target;
    const fxl_status palette = fxl_check_palette(config);
    if (palette == FXL_E_ARGUMENT) {
        return "config->palette must not be null: an RGB565 target takes 256 colours of 16 bits";
    }
    if (palette != FXL_OK) {
        return "config->palette must begin at an even address";
    }
    if (target->memory_size == NULL) {
        return NULL;
    }
    if (config->depth == NULL || ((uintptr_t)config->depth & 7u) != 0) {
        return "config->depth must be memory aligned to 8 bytes, of FXL_DEPTH_BYTES(width, rows, "
               "bits): the target has a depth buffer";
    }
    return config->depth_size < target->memory_size(lens)
               ? "config->depth_size must be at least FXL_DEPTH_BYTES(width, 1, bits) of the target"
               : NULL;
}

static const char *explain_order(const fxl_config *config, const fxl_scene *scene)
{
    const fxl_order *order = fxl_order_of(config);
    const uint32_t needed = order->memory_size != NULL ? order->memory_size(scene) : 0;
    if (needed == 0) {
        return NULL;
    }
    if (config->tree == NULL || ((uintptr_t)config->tree & 7u) != 0) {
        return "config->tree must be memory aligned to 8 bytes, of fxl_bsp_workspace_size of the "
               "scene: the order is by tree";
    }
    return config->tree_size < needed
               ? "config->tree_size must be at least fxl_bsp_workspace_size of the scene"
               : NULL;
}

FXL_COLD const char *fxl_renderer_explain(const fxl_renderer *renderer, const fxl_scene *scene,
                                          const fxl_config *config, const void *memory,
                                          size_t memory_size)
{
    fxl_lens lens;
    if (renderer == NULL) {
        return NULL_RENDERER;
    }
    if (scene == NULL) {
        return "scene must not be null";
    }
    if (config == NULL) {
        return "config must not be null: fxl_config_default makes one";
    }
    if (memory == NULL) {
        return "memory must not be null";
    }
    if (config->target == NULL) {
        return "config->target must not be null: fxl_config_default sets &fxl_palette";
    }
    if (((uintptr_t)memory & 7u) != 0) {
        return "memory must be aligned to 8 bytes: make it an array of uint64_t";
    }
    if (scene->draw_list_needed == 0) {
        return "scene was not checked: fxl_scene_open or fxl_scene_check must answer FXL_OK first";
    }
    if (scene->draw_list_needed < fxl_list_instances_most(scene)) {
        return "scene->instance_count was raised after fxl_scene_check: check the scene again";
    }
    const char *wrong = explain_lens(config, &lens);
    if (wrong != NULL) {
        return wrong;
    }
    if (memory_size < fxl_aligned(scene->draw_list_needed * sizeof(fxl_draw_entry))) {
        return "memory_size must be at least 12 bytes for each of scene->draw_list_needed, rounded "
               "up to 8: renderer->memory_missing bytes more";
    }
    wrong = explain_target(config, &lens);
    if (wrong == NULL) {
        wrong = explain_order(config, scene);
    }
    return wrong != NULL ? wrong : fxl_conflict_sentence(renderer);
}

static bool is_in_sight(const fxl_scene *scene, uint32_t number, const fxl_view *view)
{
    const fxl_instance *instance = &scene->instances[number];
    const fxl_q16_16 radius = fxl_scaled_radius(fxl_placement_of(scene, number)->scale,
                                                scene->models[instance->model].radius);
    return fxl_sphere_planes(&view->camera, &view->view_frustum, &instance->centre, radius) !=
           FXL_SPHERE_OUTSIDE;
}

/* Finds the first instance that fxl_frame_begin refuses with this status: without a view any
 * instance, otherwise one in sight. Returns false if there is none: *number untouched. */
static bool find_refused(const fxl_scene *scene, fxl_status refusal, const fxl_view *view,
                         uint32_t *number)
{
    for (uint32_t i = fxl_first_turned(scene); i < scene->instance_count; i++) {
        const fxl_instance *instance = &scene->instances[i];
        if (fxl_placement_check(fxl_placement_of(scene, i), &instance->centre,
                                scene->models[instance->model].radius) == refusal &&
            (view == NULL || is_in_sight(scene, i, view))) {
            *number = i;
            return true;
        }
    }
    return false;
}

static const char *explain_place(const fxl_scene *scene, uint32_t *number)
{
    if (!find_refused(scene, FXL_E_RANGE, NULL, number)) {
        return NULL;
    }
    const fxl_q16_16 scale = fxl_placement_of(scene, *number)->scale;
    return scale < FXL_SCALE_MIN || scale > FXL_SCALE_MAX
               ? "the scale in the placement of instance *number must be 1/256..256, as "
                 "FXL_RATIO(1, 256)..FXL_UNITS(256): a placement begins as FXL_PLACEMENT_NONE"
               : "the sphere of instance *number, with the scale of its placement, must lie within "
                 "FXL_UNITS(-8191)..FXL_UNITS(8191)";
}

static const char *explain_orientation(const fxl_renderer *renderer, const fxl_pose *pose,
                                       uint32_t *number)
{
    const fxl_scene *scene = renderer->scene;
    fxl_view view = renderer->frame.view;
    if (fxl_view_set_pose(&view, pose) != FXL_OK) {
        return "eye->position, moved to the middle of the screen of an orthographic lens, must be "
               "within FXL_UNITS(-8191)..FXL_UNITS(8191)";
    }
    if (fxl_first_turned(scene) == scene->instance_count) {
        return NULL;
    }
    return find_refused(scene, FXL_E_PLACEMENT, &view, number)
               ? "the rows of the orientation in the placement of instance *number must be those "
                 "of a rotation, to within 2^-28"
               : NULL;
}

static const char *explain_begin(const fxl_renderer *renderer, const fxl_pose *pose,
                                 uint32_t *number)
{
    const fxl_scene *scene = renderer->scene;
    if (renderer->clipper == NULL || renderer->target == NULL) {
        return NOT_INITIALISED;
    }
    const char *apart = fxl_conflict_sentence(renderer);
    if (apart != NULL) {
        return apart;
    }
    if (scene->placements != NULL && scene->placement_code == NULL) {
        return "scene has placements, so its placement_code must not be null";
    }
    if (scene->instance_count > renderer->instance_capacity) {
        return "scene->instance_count must be at most renderer->instance_capacity";
    }
    const char *wrong = explain_place(scene, number);
    if (wrong != NULL) {
        return wrong;
    }
    if (pose == NULL) {
        return "eye must not be null";
    }
    if (!fxl_point_in_range(&pose->position)) {
        return "eye->position must be within FXL_UNITS(-8191)..FXL_UNITS(8191)";
    }
    return explain_orientation(renderer, pose, number);
}

FXL_COLD const char *fxl_render_explain(const fxl_renderer *renderer, const fxl_pose *eye,
                                        const void *pixels, uint16_t stride, uint32_t *number)
{
    uint32_t found;
    if (renderer == NULL) {
        return NULL_RENDERER;
    }
    if (renderer->scene == NULL) {
        return NOT_INITIALISED;
    }
    if (pixels == NULL) {
        return "pixels must not be null: memory for config.height rows of stride pixels";
    }
    if (stride < renderer->frame.view.lens.width) {
        return "stride must be at least config.width: pixels, not bytes, from a row to the next";
    }
    if (fxl_kind_of_palette(renderer->palette).shift != 0 && ((uintptr_t)pixels & 1u) != 0) {
        return NOT_ALIGNED_TO_2;
    }
    return explain_begin(renderer, eye, number != NULL ? number : &found);
}

FXL_COLD const char *fxl_frame_explain(const fxl_renderer *renderer, const fxl_band *band)
{
    if (renderer == NULL) {
        return NULL_RENDERER;
    }
    if (band == NULL) {
        return "band must not be null";
    }
    if (band->pixels == NULL) {
        return "band->pixels must not be null: memory for band->rows rows of band->stride pixels";
    }
    const fxl_lens *lens = &renderer->frame.view.lens;
    if (renderer->frame.state == FXL_FRAME_NONE) {
        return "renderer has no frame: fxl_frame_begin must answer FXL_OK before each frame";
    }
    if (!fxl_has_pixels_of(renderer, band)) {
        return fxl_kind_of_band(band).is_colour
                   ? "band->palette must be null: the target is no RGB565"
                   : "band->palette must be config.palette: the target is RGB565";
    }
    if (band->width != lens->width) {
        return "band->width must be config.width, also of a band of some columns";
    }
    if (band->stride < fxl_band_columns(band)) {
        return "band->stride must be at least the pixels of a row";
    }
    if (fxl_band_end_column(band) > lens->width) {
        return "band->first_column + band->columns must be at most config.width";
    }
    if (!fxl_band_is_within(band, lens->width, lens->height)) {
        return "band->rows must be at least 1, and band->first_row + band->rows at most "
               "config.height";
    }
    return fxl_band_is_aligned(band) ? NULL : NOT_ALIGNED_TO_2;
}
