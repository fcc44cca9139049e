/* SPDX-License-Identifier: MIT */
/* Which instances and faces are drawn with an orthographic lens, and in which order. */
#include "../math/arith.h"
#include "../scene/face_bounds.h"
#include "../scene/placement_code.h"
#include "../view/order.h"
#include "orthographic.h"
#include "renderer.h"
#include "rounded_faces.h"
#include "submit_instance.h"

/* --- which faces are drawn ------------------------------------------------------------------- */

/* orthographic 2.4 */
static bool is_front(const fxl_model_view *model_view, const fxl_face *face)
{
    return fxl_along(&fxl_orthographic_view_of(model_view)->forward, face->normal.x, face->normal.y,
                     face->normal.z) < 0;
}

/* orthographic 2.3, 2.4 */
bool fxl_orthographic_face_is_front(const fxl_view *view, const fxl_scene *scene, uint32_t number,
                                    const fxl_face *face)
{
    const fxl_axes *axes = &view->camera.axes;
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
    const fxl_direction *normal = &face->normal;
    fxl_axes rows;
    if (turned != NULL) {
        turned->rows(axes, &fxl_placement_of(scene, number)->orientation, &rows);
        axes = &rows;
    }
    return fxl_along(&axes->forward, normal->x, normal->y, normal->z) < 0;
}

/* Keys are unsigned: what is below 2^62 in magnitude is moved above 0. */
static uint64_t key_of(int64_t depth)
{
    return (uint64_t)(depth + ((int64_t)1 << 62));
}

/* Of fxl_cluster_tests: the faces from first on that are fronts, by number. */
/* orthographic 2.4, 2.5 */
static uint32_t find_front(const fxl_scene *scene, const fxl_model *model, uint32_t first,
                           uint32_t count, const fxl_model_view *model_view, const fxl_point *eye,
                           fxl_draw_entry *entries)
{
    const fxl_direction *forward = &fxl_orthographic_view_of(model_view)->forward;
    const fxl_face_bounds *known =
        scene->face_bounds != NULL ? &scene->face_bounds[model->first_face_bounds] : NULL;
    uint32_t found = 0;
    (void)eye;
    for (uint32_t i = first; i < first + count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        if (!is_front(model_view, face)) {
            continue;
        }
        const fxl_point box =
            fxl_face_box_of(known, i, model_view->vertices,
                            fxl_face_indices(model_view->indices, face), face->count);
        entries[found++] =
            fxl_draw_entry_of(key_of(fxl_along(forward, box.x, box.y, box.z)), (uint16_t)i, 0);
    }
    return found;
}

static uint32_t find_all_front(const fxl_scene *scene, const fxl_model *model,
                               const fxl_model_view *model_view, fxl_draw_entry *entries)
{
    return find_front(scene, model, 0, model->face_count, model_view, NULL, entries);
}

/* The test of an eye that is as far as the cone's apex less forward: u = forward. */
/* orthographic 2.4 */
static bool is_turned_away(const fxl_cluster *cluster, const fxl_point *eye,
                           const fxl_model_view *model_view)
{
    static const fxl_point origin = {0, 0, 0};
    const fxl_direction *forward = &fxl_orthographic_view_of(model_view)->forward;
    fxl_cluster at_origin = *cluster;
    (void)eye;
    at_origin.apex.x = forward->x;
    at_origin.apex.y = forward->y;
    at_origin.apex.z = forward->z;
    return fxl_orthographic_view_of(model_view)
        ->scene->cluster_code->is_turned_away(&at_origin, &origin, model_view);
}

static void find_clusters(const fxl_traversal *traversal, const fxl_model_view *model_view,
                          const fxl_model *model)
{
    const fxl_scene *scene = traversal->renderer->scene;
    const fxl_cluster_code *by = scene->cluster_code;
    const bool is_turned = fxl_orthographic_view_of(model_view)->turned.placement != NULL;
    const fxl_cluster_tests tests = {is_turned ? scene->placement_code->cluster_planes : by->planes,
                                     is_turned_away, find_front};
    by->find_faces_by(traversal, model_view, model, &tests);
}

/* fxl_list_model. */
static void order_faces(const fxl_traversal *traversal, const fxl_model_view *model_view,
                        const fxl_model *model)
{
    fxl_list_found_faces(traversal, model_view, model, find_clusters, find_all_front);
}

/* Has vertices made flat, if the renderer has surfaces. */
static void make_flat(fxl_orthographic_view *view, const fxl_renderer *renderer)
{
    fxl_model_view *model_view = &view->turned.model_view;
    if (fxl_renderer_shader(renderer, FXL_SHADER_SURFACES) == NULL) {
        return;
    }
    if ((model_view->planes & FXL_MODEL_VIEW_SCALED) != 0) {
        view->scale_vertex = model_view->scale_vertex;
    }
    model_view->planes |= FXL_MODEL_VIEW_SCALED;
    model_view->scale_vertex = fxl_flatten_vertex;
}

/* Sets up the view of an instance, with its shader. rounded: room for one. Answers its model. */
/* orthographic 2.3 */
static const fxl_model *view_instance(const fxl_traversal *traversal, const fxl_draw_entry *entry,
                                      fxl_orthographic_view *view, fxl_rounded_instance *rounded)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_axes *axes = &renderer->frame.view.camera.axes;
    const fxl_placement_code *turned = fxl_placement_code_of(scene, entry->index);
    fxl_model_view *model_view = &view->turned.model_view;
    view->scene = scene;
    view->is_deep = renderer->target->depth_bits != 0;
    view->scale_vertex = NULL;
    if (turned == NULL) {
        const fxl_instance *instance = fxl_view_instance(traversal, entry, model_view);
        view->turned.placement = NULL;
        view->forward = axes->forward;
        make_flat(view, renderer);
        return &scene->models[instance->model];
    }
    const fxl_model *model = turned->view(&view->turned, scene, entry->index, &renderer->frame.view,
                                          &traversal->workspace->cache, entry->instance.planes);
    fxl_axes rows;
    turned->rows(axes, &view->turned.placement->orientation, &rows);
    view->forward = rows.forward;
    turned->set_shader(traversal, entry, NULL, model_view, rounded);
    make_flat(view, renderer);
    return model;
}

bool fxl_submit_orthographic(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    FXL_ALIGN_8 fxl_orthographic_view view;
    fxl_rounded_instance rounded;
    const fxl_model *model = view_instance(traversal, entry, &view, &rounded);
    const fxl_model_view *model_view = &view.turned.model_view;
    return fxl_lists_faces(traversal->renderer, model)
               ? fxl_submit_sorted_once(traversal, model_view, model, order_faces)
               : fxl_submit_convex(traversal, model_view, model, is_front);
}

/* --- the order ------------------------------------------------------------------------------- */

/* The instances in sight were sorted by distance. A difference of two points of the world is below
 * 2^30, so a depth is below 2^61. */
/* orthographic 2.5 */
void fxl_orthographic_begin(const fxl_traversal *traversal)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_frame *frame = &renderer->frame;
    const fxl_camera *camera = &frame->view.camera;
    if (traversal->display_list == NULL) {
        return;
    }
    for (uint32_t i = 0; i < frame->visible_count; i++) {
        fxl_draw_entry *entry = &frame->draw_list[i];
        const fxl_draw_instance kept = entry->instance;
        fxl_point from_eye;
        fxl_subtract(&scene->instances[entry->index].centre, &camera->position, &from_eye);
        *entry = fxl_draw_entry_of(
            key_of(fxl_along(&camera->axes.forward, from_eye.x, from_eye.y, from_eye.z)),
            entry->index, kept.layer);
        entry->instance = kept;
    }
    fxl_sort_instances(frame->draw_list, frame->visible_count);
    if (scene->placements != NULL) {
        traversal->counters->rounded =
            (uint16_t)scene->placement_code->count_rounded(traversal, 0, 0);
    }
}

static bool submit(const fxl_traversal *traversal)
{
    fxl_orthographic_begin(traversal);
    return fxl_submit_all(traversal, fxl_submit_orthographic);
}

const fxl_order fxl_by_depth = {.submit = submit};
