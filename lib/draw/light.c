/* SPDX-License-Identifier: MIT */
/* The light of a renderer: a shader that gives a face the colour of its level, or in RGB565 a
 * shade. */
#include "renderer.h"
#include "submit.h"
#include "../math/arith.h"
#include "../math/plane.h"
#include "../scene/face_bounds.h"
#include "../scene/placement_code.h"
#include "../paint/light_level.h"

static bool reaches(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    (void)shader;
    (void)scene;
    (void)instance;
    return true;
}

/* scale * (row . box), in the unit of the box. A box is below 2^31 in each coordinate, so the sum
 * is below 2^62. The instance lies within the world, so scale * (row . box) * 2^-46 is below 2^31,
 * and after the first shift the product is below 2^55. Errors: half a unit of the first shift is
 * 2^21 of 2^46 with a scale of 2^24, half a unit of the box; the second shift makes it one. */
/* light 2.1 */
static int32_t turn_middle(const fxl_direction *row, const fxl_point *box, fxl_q16_16 scale)
{
    const int64_t sum =
        (int64_t)row->x * box->x + (int64_t)row->y * box->y + (int64_t)row->z * box->z;
    return (int32_t)fxl_round_shift(fxl_round_shift(sum, 22) * scale, 24);
}

/* The box of a face, of a part that of the whole face. */
/* light 2.1 */
static fxl_point box_of(const fxl_scene *scene, const fxl_model *model, const fxl_face *face)
{
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    const fxl_face_outline outline = fxl_whole_face(scene, face);
    return fxl_face_box(vertices, outline.indices, outline.count);
}

/* A face of an instance in the world. Coordinates are within FXL_COORDINATE_MAX, so doubled ones
 * are below 2^30, but for the rounding of a placement. */
/* light 2.1 */
static void place_face(const fxl_scene *scene, const fxl_instance *instance, const fxl_face *face,
                       fxl_lit_place *place)
{
    const fxl_point *centre = &instance->centre;
    const uint32_t number = fxl_instance_number(scene, instance);
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
    fxl_point box = box_of(scene, &scene->models[instance->model], face);
    place->normal = face->normal;
    if (turned != NULL) {
        const fxl_placement *placement = fxl_placement_of(scene, number);
        const fxl_orientation *to = &placement->orientation;
        const fxl_point of_model = box;
        place->normal = turned->normal(scene, number, face);
        box.x = turn_middle(&to->x, &of_model, placement->scale);
        box.y = turn_middle(&to->y, &of_model, placement->scale);
        box.z = turn_middle(&to->z, &of_model, placement->scale);
    }
    place->middle.x = 2 * centre->x + box.x;
    place->middle.y = 2 * centre->y + box.y;
    place->middle.z = 2 * centre->z + box.z;
}

static FXL_ONE_COPY fxl_q2_30 brightness_of(const fxl_light_settings *settings,
                                            const fxl_renderer *renderer,
                                            const fxl_instance *instance, const fxl_face *face)
{
    fxl_lit_place place;
    place_face(renderer->scene, instance, face, &place);
    return fxl_light_brightness(settings, &renderer->frame.view.camera, &place);
}

static const fxl_light_settings *settings_of(const fxl_shader *shader)
{
    return &((const fxl_light *)(const void *)shader)->settings;
}

/* place light: normal and middle of a face in the world, and its colour */
/* In a palette: the entry of the ramp. */
/* light 3.1 */
static uint8_t colour(const fxl_shader *shader, const fxl_traversal *traversal,
                      const fxl_instance *instance, const fxl_face *face, uint8_t full)
{
    const fxl_light_settings *settings = settings_of(shader);
    const fxl_q2_30 brightness = brightness_of(settings, traversal->renderer, instance, face);
    return settings->ramp[256u * fxl_light_level(brightness, settings->levels) + full];
}

/* Where light mixes colours: the same colour, of which a part is left. */
/* light 3.1, 5.1 */
static uint8_t shade(const fxl_shader *shader, const fxl_traversal *traversal,
                     const fxl_instance *instance, const fxl_face *face, uint8_t full)
{
    traversal->workspace->screen.shade =
        fxl_light_shade(brightness_of(settings_of(shader), traversal->renderer, instance, face));
    return full;
}

/* light 5.2, 5.3 */
fxl_status fxl_attach_light(fxl_renderer *renderer, fxl_light *light,
                            const fxl_light_settings *settings)
{
    static const fxl_shader_code of_table = {
        .reaches = reaches, .face = fxl_submit_coloured_face, .colour = colour};
    static const fxl_shader_code of_mixed = {
        .reaches = reaches, .face = fxl_submit_coloured_face, .colour = shade};
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->scene == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ORDER);
    }
    if (settings == NULL) {
        fxl_renderer_attach(renderer, FXL_SHADER_LIGHT, NULL);
        return FXL_OK;
    }
    fxl_status status = FXL_E_ARGUMENT;
    if (light != NULL && settings->ramp != NULL) {
        status = fxl_light_check(settings, NULL);
    }
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    light->settings = *settings;
    /* A renderer with an attachment keeps its target's pixels. */
    light->shader.code =
        renderer->target != NULL && renderer->target->is_mixed ? &of_mixed : &of_table;
    fxl_renderer_attach(renderer, FXL_SHADER_LIGHT, &light->shader);
    return FXL_OK;
}
