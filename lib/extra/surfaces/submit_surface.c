/* SPDX-License-Identifier: MIT */
/* The shader of surfaces: a face that has one goes, after the clipper, with its gradients to the
 * display list or into the band. */
#include "../../src/draw/renderer.h"
#include "../../src/draw/submit.h"
#include "affine.h"
#include "surface_light.h"
#include "surface_polygon.h"
#include "texture_level.h"

static bool reaches(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    (void)shader;
    (void)scene;
    (void)instance;
    return true;
}

/* A corner of a face in the view, by the matrix of its instance. A clipper by clip flags keeps the
 * same positions in the cache. */
static void find_corner(const fxl_model_view *model_view, uint32_t number, bool from_cache,
                        fxl_view_point *corner)
{
    if (from_cache) {
        *corner = fxl_fetch_vertex(model_view, number)->position;
    } else {
        fxl_cached_vertex vertex;
        fxl_transform_vertex(model_view, number, &vertex);
        *corner = vertex.position;
    }
}

/* The corners of a face in the view, and the values of its attributes there. */
static void find_corners(const fxl_surfaces *surfaces, const fxl_model_view *model_view,
                         const fxl_face *face, const fxl_mapped_face *mapped,
                         const fxl_traversal *on, fxl_gradient_corners *corners)
{
    const fxl_surface *surface = &surfaces->set->surfaces[mapped->surface];
    const uint16_t *indices = model_view->indices + face->first_index;
    for (uint32_t i = 0; i < 3; i++) {
        find_corner(model_view, indices[mapped->corners[i]], on->clipper->by_clip_flags,
                    &corners->corners[i]);
        corners->values[FXL_ATTRIBUTE_U][i] = mapped->texels[i].u;
        corners->values[FXL_ATTRIBUTE_V][i] = mapped->texels[i].v;
    }
    corners->count = surface->texture == 0 ? 0 : 2;
    if (fxl_surface_is_lit(surfaces, surface)) {
        surfaces->light_code->light_corners(surfaces, on->renderer, model_view->instance, face,
                                            mapped, corners->values[corners->count]);
        corners->count++;
    }
}

static void find_gradients(const fxl_surfaces *surfaces, const fxl_model_view *model_view,
                           const fxl_face *face, const fxl_mapped_face *mapped,
                           const fxl_traversal *on, fxl_surface_polygon *polygon)
{
    const fxl_surface *surface = &surfaces->set->surfaces[mapped->surface];
    fxl_gradient_corners corners;
    find_corners(surfaces, model_view, face, mapped, on, &corners);
    if (surface->division == FXL_AFFINE) {
        fxl_corners_make_affine(&corners, model_view->view);
    }
    fxl_gradients_find(&corners, model_view->view, &polygon->gradients);
    polygon->level = 0;
    if (surface->texture != 0) {
        polygon->level =
            fxl_texture_level_choose(&surfaces->set->textures[surface->texture - 1], &corners,
                                     model_view->view, &polygon->gradients);
    }
    polygon->surface = mapped->surface;
    polygon->colour = face->material;
}

/* Where the polygon on the screen goes. */
static fxl_outcome deliver(const fxl_surfaces *surfaces, const fxl_traversal *on,
                           const fxl_surface_polygon *polygon)
{
    fxl_workspace *workspace = on->workspace;
    const fxl_screen_polygon *screen = &workspace->screen;
    const fxl_rows rows = fxl_scan_rows(screen, on->renderer->frame.view.lens.height);
    if (rows.first == rows.end) {
        return 0;
    }
    if (on->display_list != NULL) {
        return fxl_surface_polygon_append(on->display_list, screen, rows, polygon)
                   ? 0
                   : FXL_OUTCOME_FULL;
    }
    if (on->way == FXL_SUBMIT_MEASURE) {
        on->reached->first = rows.first < on->reached->first ? rows.first : on->reached->first;
        on->reached->end = rows.end > on->reached->end ? rows.end : on->reached->end;
        return FXL_OUTCOME_SPILLED;
    }
    fxl_surface_polygon_paint(surfaces, polygon, screen->points, screen->count, on->band,
                              &workspace->work.scan);
    return FXL_OUTCOME_SPILLED;
}

/* All polygons of a face that has a surface. The gradients are found once one of them is left. */
static bool submit_mapped_face(const fxl_surfaces *surfaces, const fxl_model_view *model_view,
                               const fxl_face *face, const fxl_mapped_face *mapped,
                               const fxl_traversal *on)
{
    const uint32_t used = on->renderer->frame.display_list.used;
    fxl_surface_polygon polygon;
    bool found = false;
    fxl_clip_result cut = fxl_first_polygon(model_view, face, on);
    fxl_outcome outcome = (fxl_outcome)1 << cut;
    while (cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT) {
        if (!found) {
            find_gradients(surfaces, model_view, face, mapped, on, &polygon);
            found = true;
        }
        outcome |= deliver(surfaces, on, &polygon);
        if (on->clipper->next == NULL || outcome >= FXL_OUTCOME_FULL) {
            break;
        }
        cut = fxl_next_polygon(model_view, on);
        outcome |= (fxl_outcome)1 << cut;
    }
    return fxl_count_outcome(on, outcome, used);
}

static bool submit(const fxl_model_view *model_view, const fxl_face *face, const fxl_traversal *on,
                   const fxl_shader *shader)
{
    const fxl_surfaces *surfaces = (const fxl_surfaces *)(const void *)shader;
    const fxl_surface_set *set = surfaces->set;
    const fxl_scene *scene = on->renderer->scene;
    const uint32_t mapped = set->face_map[face - scene->faces];
    if (mapped != 0 && fxl_draws_surfaces(on->renderer)) {
        return submit_mapped_face(surfaces, model_view, face, &set->faces[mapped - 1], on);
    }
    const fxl_shader *next = fxl_shader_reaching(shader->next, scene, model_view->instance);
    return next != NULL ? next->code->face(model_view, face, on, next)
                        : fxl_submit_shaded_face(model_view, face, on);
}

/* A piece of a face that something else has split has no surface. */
static uint8_t own_colour(const fxl_shader *shader, const fxl_renderer *renderer,
                          const fxl_instance *instance, const fxl_face *face, uint8_t colour)
{
    (void)shader;
    (void)renderer;
    (void)instance;
    (void)face;
    return colour;
}

fxl_status fxl_renderer_set_surfaces(fxl_renderer *renderer, fxl_surfaces *surfaces,
                                     const fxl_surface_set *set)
{
    static const fxl_shader_code code = {reaches, submit, NULL, own_colour};
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = FXL_OK;
    if (renderer->scene == NULL) {
        status = FXL_E_ORDER;
    } else if (set != NULL) {
        status = surfaces == NULL ? FXL_E_ARGUMENT : fxl_surfaces_check(set, renderer->scene, NULL);
    }
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    if (set == NULL) {
        fxl_renderer_set_shader(renderer, FXL_SHADER_SURFACES, NULL);
        return FXL_OK;
    }
    surfaces->set = set;
    surfaces->light = NULL;
    surfaces->light_code = NULL;
    surfaces->shader.code = &code;
    fxl_renderer_set_shader(renderer, FXL_SHADER_SURFACES, &surfaces->shader);
    return fxl_renderer_set_visibility(renderer, &fxl_visibility_surfaces, NULL, 0);
}

const fxl_surfaces *fxl_surfaces_of(const fxl_renderer *renderer)
{
    const fxl_shader *first = renderer->shader;
    FXL_ASSERT(first != NULL && first->rank == FXL_SHADER_SURFACES);
    return (const fxl_surfaces *)(const void *)first;
}
