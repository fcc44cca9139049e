/* SPDX-License-Identifier: MIT */
/* A file of its own: a renderer whose surfaces are not lit does not link it. */
#include "surface_polygon.h"

#include "renderer.h"
#include "submit.h"
#include "../math/arith.h"
#include "../scene/placement_code.h"
#include "../paint/light_level.h"

/* A corner and its normal in the world. Points of the world are within FXL_COORDINATE_MAX, so
 * doubled ones are below 2^30. */
static void place_corner(const fxl_point *point, const fxl_direction *normal, fxl_lit_place *place)
{
    place->normal = *normal;
    place->middle.x = 2 * point->x;
    place->middle.y = 2 * point->y;
    place->middle.z = 2 * point->z;
}

/* The three corners in a turned instance. fxl_placement_code turns the normal of a face. */
static void place_turned_corners(const fxl_scene *scene, uint32_t number,
                                 const fxl_mapped_face *mapped, const fxl_direction *normals,
                                 fxl_lit_place places[3])
{
    const fxl_placement_code *code = scene->placement_code;
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_face corner = {.normal = normals[mapped->normals[i]]};
        const fxl_direction normal = code->normal(scene, number, &corner);
        const fxl_point point = code->place_vertex(scene, number, mapped->vertices[i]);
        place_corner(&point, &normal, &places[i]);
    }
}

static void place_corners(const fxl_scene *scene, const fxl_instance *instance,
                          const fxl_mapped_face *mapped, const fxl_direction *normals,
                          fxl_lit_place places[3])
{
    const fxl_point *vertices = &scene->vertices[scene->models[instance->model].first_vertex];
    const fxl_point *centre = &instance->centre;
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_point *vertex = &vertices[mapped->vertices[i]];
        const fxl_point point = {centre->x + vertex->x, centre->y + vertex->y,
                                 centre->z + vertex->z};
        place_corner(&point, &normals[mapped->normals[i]], &places[i]);
    }
}

/* Below 2^30 * 63. Error: half a unit of 1/65536 level, and FXL_LIGHT_ERROR_MAX of the brightness,
 * which is at most 0.7 of that unit. */
static int32_t level_of(fxl_q2_30 brightness, uint32_t levels)
{
    return (int32_t)fxl_round_shift((int64_t)brightness * (levels - 1), 14) + 32768;
}

static void light_corners(const fxl_surfaces *surfaces, const fxl_renderer *renderer,
                          const fxl_instance *instance, const fxl_mapped_face *mapped,
                          int32_t values[3])
{
    const fxl_light_settings *settings = &surfaces->light->settings;
    const fxl_direction *normals = surfaces->set->normals;
    const fxl_scene *scene = renderer->scene;
    const uint32_t number = fxl_instance_number(scene, instance);
    fxl_lit_place places[3];
    if (fxl_placement_code_of(scene, number) != NULL) {
        place_turned_corners(scene, number, mapped, normals, places);
    } else {
        place_corners(scene, instance, mapped, normals, places);
    }
    for (uint32_t i = 0; i < 3; i++) {
        values[i] =
            level_of(fxl_light_brightness(settings, &renderer->frame.view.camera, &places[i]),
                     settings->levels);
    }
}

static const fxl_surface_light_code code = {light_corners};

fxl_status fxl_attach_lit(fxl_renderer *renderer, fxl_lit_surfaces *lit)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->scene == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ORDER);
    }
    if (lit != NULL) {
        lit->shader.code = &fxl_mark;
        lit->code = &code;
    }
    fxl_renderer_attach(renderer, FXL_SHADER_LIT, lit != NULL ? &lit->shader : NULL);
    return FXL_OK;
}
