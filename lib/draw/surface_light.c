/* SPDX-License-Identifier: MIT */
/* A file of its own: a renderer whose surfaces are not lit does not link it. */
#include "surface_polygon.h"

#include "renderer.h"
#include "submit.h"
#include "../math/arith.h"
#include "../scene/placement_code.h"
/* place light: the corners of a lit surface, with a level_of of its own */
#include "../paint/light_level.h"

/* A corner of a face of an instance in the world. Points of the world are within
 * FXL_COORDINATE_MAX, so doubled ones are below 2^30. */
/* SPEC 9.7, surfaces 5.1 */
static void place_corner(const fxl_scene *scene, const fxl_instance *instance, uint32_t number,
                         const fxl_placement_code *turned, uint32_t vertex, fxl_point *middle)
{
    fxl_point point;
    if (turned != NULL) {
        point = turned->place_vertex(scene, number, vertex);
    } else {
        const uint32_t first = scene->models[instance->model].first_vertex;
        const fxl_point *of_model = &scene->vertices[first + vertex];
        point.x = instance->centre.x + of_model->x;
        point.y = instance->centre.y + of_model->y;
        point.z = instance->centre.z + of_model->z;
    }
    middle->x = 2 * point.x;
    middle->y = 2 * point.y;
    middle->z = 2 * point.z;
}

/* Only point lights and fog need the places of corners. fxl_placement_code turns the normal of a
 * face. */
/* SPEC 9.7, surfaces 5.1 */
static void light_corners(const fxl_surfaces *surfaces, const fxl_model_view *model_view,
                          const fxl_traversal *traversal, const fxl_corner *const corners[3],
                          int32_t values[3])
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_instance *instance = model_view->instance;
    const fxl_light_settings *settings = &surfaces->light->settings;
    const fxl_direction *normals = surfaces->set->normals;
    const fxl_scene *scene = renderer->scene;
    const uint32_t number = scene->placements != NULL ? fxl_instance_number(scene, instance) : 0;
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
    const bool has_places = settings->point_count != 0 || settings->fog_far != 0;
    if (!FXL_IS_COMPACT && turned == NULL && !has_places) {
        fxl_light_corners_of(settings, normals, corners, values);
        return;
    }
    fxl_lit_place place = {{0, 0, 0}, {0, 0, 0}};
    for (uint32_t i = 0; i < 3; i++) {
        place.normal = normals[corners[i]->normal];
        if (turned != NULL) {
            const fxl_face corner = {.normal = place.normal};
            place.normal = turned->normal(scene, number, &corner);
        }
        if (has_places) {
            place_corner(scene, instance, number, turned, corners[i]->vertex, &place.middle);
        }
        values[i] = fxl_light_corner_level(
            fxl_light_brightness(settings, &renderer->frame.view.camera, &place),
            settings->levels - 1u);
    }
}

#if FXL_DRAWS_SMOOTH_OUTLINES

static fxl_kept_lights *kept_lights(const fxl_surfaces *surfaces, const fxl_traversal *traversal)
{
    const fxl_light_settings *settings = &surfaces->light->settings;
    fxl_workspace *workspace = traversal->workspace;
    fxl_kept_lights *kept = (fxl_kept_lights *)(void *)(&workspace->work.scan + 1);
    if (sizeof(fxl_scan) + sizeof *kept > sizeof workspace->work ||
        traversal->renderer->scene->placements != NULL || settings->point_count != 0 ||
        settings->fog_far != 0) {
        return NULL;
    }
    fxl_kept_lights_begin(kept);
    return kept;
}

#define KEPT_LIGHT kept_lights, fxl_kept_light_find, fxl_light_corners_of

#else
#define KEPT_LIGHT NULL, NULL, NULL
#endif

#if FXL_DRAWS_SMOOTH_WORDS
#define DRAW_WORDS fxl_draw_smooth_words
#else
#define DRAW_WORDS NULL
#endif

static const fxl_surface_light_code code = {light_corners, KEPT_LIGHT, DRAW_WORDS};

/* surfaces 5.5 */
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
