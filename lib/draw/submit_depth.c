/* SPDX-License-Identifier: MIT */
/* The shader of depth: a face, or a piece of one, goes with its plane to the display list or into
 * the band. It is the last shader, so what others have made of a face comes to it. */
#include "renderer.h"
#include "submit.h"
#include "depth_plane.h"
#include "fixel/depth.h"

static bool reaches(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    (void)shader;
    (void)scene;
    (void)instance;
    return true;
}

static bool has_depth(const fxl_renderer *renderer)
{
    return renderer->visibility->backend->draws_surfaces &&
           fxl_surface_backend_of(renderer)->find_depth != NULL;
}

/* fxl_surface_finder. */
static void find(const void *what, const fxl_model_view *model_view, const fxl_face *face,
                 const fxl_traversal *on, fxl_surface_polygon *polygon)
{
    (void)what;
    polygon->surface = FXL_NO_SURFACE;
    polygon->gradients.count = 0;
    for (uint32_t i = 0; i < FXL_ATTRIBUTES; i++) {
        polygon->gradients.shifts[i] = 0;
    }
    polygon->level = 0;
    polygon->colour = face->material;
    polygon->has_depth = true;
    fxl_surface_backend_of(on->renderer)->find_depth(model_view, face, on, &polygon->depth);
}

static bool submit(const fxl_model_view *model_view, const fxl_face *face, const fxl_traversal *on,
                   const fxl_shader *shader)
{
    (void)shader;
    if (!has_depth(on->renderer)) {
        return fxl_submit_shaded_face(model_view, face, on);
    }
    const uint32_t used = on->renderer->frame.display_list.used;
    return fxl_count_outcome(on, fxl_submit_surface_polygons(model_view, face, on, find, NULL),
                             used);
}

static bool split(const fxl_shader *shader, fxl_pieces *pieces, const fxl_face *face,
                  const fxl_point *points, uint32_t count)
{
    const fxl_traversal *on = pieces->on;
    fxl_model_view model_view;
    (void)shader;
    if (!has_depth(on->renderer)) {
        return fxl_submit_piece(pieces, points, count, face->material);
    }
    fxl_model_view_of_polygon(&model_view, points, &on->renderer->frame.view,
                              &on->workspace->cache);
    model_view.planes = pieces->planes;
    pieces->outcome |= fxl_submit_surface_polygons(&model_view, face, on, find, NULL);
    return pieces->outcome < FXL_OUTCOME_FULL;
}

/* What is blended must be drawn far to near, after what is opaque. */
static bool has_blended_surfaces(const fxl_renderer *renderer)
{
    const fxl_surfaces *surfaces = fxl_surfaces_of(renderer);
    for (uint32_t i = 0; surfaces != NULL && i < surfaces->set->surface_count; i++) {
        if (surfaces->set->surfaces[i].flags & FXL_SURFACE_BLEND) {
            return true;
        }
    }
    return false;
}

fxl_status fxl_renderer_set_depth(fxl_renderer *renderer, fxl_depth *depth,
                                  const fxl_visibility *method, void *memory, uint32_t size)
{
    static const fxl_shader_code code = {reaches, submit, split, NULL, false};
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (depth == NULL || method == NULL || !method->backend->draws_surfaces ||
        ((const fxl_surface_backend *)(const void *)method->backend)->find_depth == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ARGUMENT);
    }
    if (has_blended_surfaces(renderer)) {
        method = ((const fxl_surface_backend *)(const void *)method->backend)->far_to_near;
    }
    const fxl_status status = fxl_renderer_set_visibility(renderer, method, memory, size);
    if (status == FXL_OK) {
        depth->shader.code = &code;
        fxl_renderer_set_shader(renderer, FXL_SHADER_DEPTH, &depth->shader);
    }
    return status;
}
