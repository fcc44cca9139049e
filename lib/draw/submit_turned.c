/* SPDX-License-Identifier: MIT */
/* Instances that turn and scale. Only a scene with placements names this file's record. */
#include "../scene/face_bounds.h"
#include "../scene/placement_code.h"
#include "../view/order.h"
#include "../view/outcode.h"
#include "../view/placement.h"
#include "../view/view.h"
#include "rounded_faces.h"
#include "submit.h"
#include "submit_instance.h"

/* --- the scene ----------------------------------------------------------------------------- */

static const fxl_model *model_of(const fxl_scene *scene, uint32_t number)
{
    return &scene->models[scene->instances[number].model];
}

static fxl_q16_16 radius_of(const fxl_scene *scene, uint32_t number)
{
    return fxl_placement_radius(fxl_placement_of(scene, number), model_of(scene, number)->radius);
}

static bool face_is_front(const fxl_scene *scene, uint32_t number, const fxl_face *face,
                          const fxl_point *eye)
{
    const fxl_point *vertices = &scene->vertices[model_of(scene, number)->first_vertex];
    fxl_point from_eye;
    fxl_subtract(&scene->instances[number].centre, eye, &from_eye);
    return fxl_placement_is_front(fxl_placement_of(scene, number), &from_eye, &face->normal,
                                  fxl_face_height(vertices, face));
}

static fxl_point place_vertex(const fxl_scene *scene, uint32_t number, uint32_t vertex)
{
    const fxl_point *vertices = &scene->vertices[model_of(scene, number)->first_vertex];
    fxl_point point;
    fxl_placement_point(fxl_placement_of(scene, number), &scene->instances[number].centre,
                        &vertices[vertex], &point);
    FXL_ASSERT(fxl_point_in_range(&point));
    return point;
}

static void place_face(const fxl_scene *scene, uint32_t number, const fxl_face *face,
                       fxl_point *points)
{
    const uint16_t *indices = fxl_face_indices(scene->indices, face);
    FXL_ASSERT(face->count >= 3 && face->count <= FXL_FACE_VERTICES_MAX);
    for (uint32_t i = 0; i < face->count; i++) {
        points[i] = place_vertex(scene, number, indices[i]);
    }
}

static fxl_direction normal_of(const fxl_scene *scene, uint32_t number, const fxl_face *face)
{
    fxl_direction normal;
    fxl_placement_direction(fxl_placement_of(scene, number), &face->normal, &normal);
    return normal;
}

#if FXL_IS_COMPACT

#define LIST_INSTANCES fxl_list_still_instances

#else

#define LIST_INSTANCES list_instances

/* Where the entries of an order go. */
typedef struct {
    const fxl_camera *camera;
    const fxl_view_frustum *frustum;
    fxl_draw_entry *next;
    uint32_t left_out;
} order_writer;

static inline void write_entry(order_writer *to, const fxl_instance *instance, uint32_t number,
                               const fxl_model *model, fxl_q16_16 radius)
{
    const uint32_t planes = fxl_sphere_planes(to->camera, to->frustum, &instance->centre, radius);
    if (planes == FXL_SPHERE_OUTSIDE) {
        to->left_out += model->face_count; /* below 2^16 * 2^16 */
    } else {
        *to->next++ = fxl_draw_instance_of(instance, number, planes, to->camera);
    }
}

static uint32_t list_instances(const fxl_scene *scene, const fxl_camera *camera,
                               const fxl_view_frustum *frustum, fxl_draw_entry *entries,
                               uint32_t *left_out)
{
    order_writer to = {camera, frustum, entries, 0};
    const fxl_instance *instance = scene->instances;
    const fxl_placement *placement = scene->placements;
    const uint32_t first_turned = fxl_first_turned(scene);
    for (uint32_t i = 0; i < first_turned; i++, instance++) {
        const fxl_model *model = &scene->models[instance->model];
        write_entry(&to, instance, i, model, model->radius);
    }
    for (uint32_t i = first_turned; i < scene->instance_count; i++, instance++, placement++) {
        const fxl_model *model = &scene->models[instance->model];
        write_entry(&to, instance, i, model, fxl_scaled_radius(placement->scale, model->radius));
    }
    const uint32_t count = (uint32_t)(to.next - entries);
    *left_out = to.left_out;
    fxl_sort_instances(entries, count);
    return count;
}

#endif

/* Whether the orientations of all instances in sight are rotations. */
static bool are_rotations(const fxl_scene *scene, const fxl_draw_entry *entries, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        if (entries[i].index >= scene->first_turned &&
            !fxl_is_rotation(&fxl_placement_of(scene, entries[i].index)->orientation)) {
            return false;
        }
    }
    return true;
}

/* The caller may have changed placements and centres since the frame before began. Drawing reads
 * them for what the display list had no room for, unchecked, and a pick reads all. So the frame
 * before ends, whatever the reason for which this one is refused.
 *
 * The sphere test takes scales and places, so these are checked before it, and orientations of
 * instances in sight after it: no stage reads another orientation. If one is refused, the view is
 * that of the frame before. */
/* SPEC 8.1 */
static fxl_status find_visible(fxl_renderer *renderer, const fxl_pose *pose, uint32_t *culled)
{
    fxl_frame *frame = &renderer->frame;
    fxl_view *view = &frame->view;
    const fxl_scene *scene = renderer->scene;
    const fxl_camera before = view->camera;
    const uint32_t number = view->frame;
    frame->state = FXL_FRAME_NONE;
    if (scene->instance_count > renderer->instance_capacity) {
        return FXL_E_CAPACITY;
    }
    if (!fxl_placement_places_are_in_range(scene)) {
        return FXL_E_RANGE;
    }
    const fxl_status status = fxl_view_set_pose(view, pose);
    if (status != FXL_OK) {
        return status;
    }
    if (!FXL_IS_SMALL) {
        fxl_extents_take_back(renderer, &renderer->workspace);
    }
    const uint32_t count =
        LIST_INSTANCES(scene, &view->camera, &view->view_frustum, frame->draw_list, culled);
    if (are_rotations(scene, frame->draw_list, count)) {
        frame->visible_count = (uint16_t)count;
        return FXL_OK;
    }
    view->camera = before;
    view->frame = number;
    return FXL_E_PLACEMENT;
}

/* --- points rounded in the world ------------------------------------------------------------ */

/* What takes the rounded faces of an instance, if its clipper or a shader takes only such: else
 * null. */
/* SPEC 8.5 */
static const fxl_shader_code *rounding_of(const fxl_traversal *traversal, uint32_t number)
{
    const fxl_scene *scene = traversal->renderer->scene;
    const fxl_instance *instance = &scene->instances[number];
    const fxl_shader_code *code = traversal->clipper->by_points;
    const fxl_shader *shader = traversal->renderer->shader;
    while (code == NULL && (shader = fxl_shader_reaching(shader, scene, instance)) != NULL) {
        code = shader->code->in_world;
        shader = shader->next;
    }
    return code;
}

/* SPEC 8.5 */
static uint32_t count_rounded(const fxl_traversal *traversal, uint32_t first, uint32_t end)
{
    const fxl_frame *frame = &traversal->renderer->frame;
    uint32_t count = 0;
    if (first == end && traversal->clipper->by_points == NULL &&
        traversal->renderer->shader == NULL) {
        return 0;
    }
    for (uint32_t i = 0; i < frame->visible_count; i++) {
        const uint32_t number = frame->draw_list[i].index;
        count += fxl_placement_code_of(traversal->renderer->scene, number) != NULL &&
                 ((i >= first && i < end) || rounding_of(traversal, number) != NULL);
    }
    return count;
}

/* --- submission ----------------------------------------------------------------------------- */

/* The facing tests of an eye that is near, and of any eye: fxl_turned_view_face_is_front. */
static bool face_is_front_to_near(const fxl_model_view *model_view, const fxl_face *face)
{
    return fxl_turned_view_face_is_front((const fxl_turned_view *)model_view, face, true);
}

static bool face_is_front_to_any(const fxl_model_view *model_view, const fxl_face *face)
{
    const fxl_turned_view *turned = (const fxl_turned_view *)model_view;
    return fxl_turned_view_face_is_front(turned, face, turned->eye_shift == 0);
}

static uint32_t cluster_planes(const fxl_cluster *cluster, const fxl_model_view *model_view)
{
    return fxl_turned_cluster_planes((const fxl_turned_view *)model_view, cluster);
}

static uint32_t find_front(const fxl_scene *scene, const fxl_model *model, uint32_t first,
                           uint32_t count, const fxl_model_view *model_view, const fxl_point *eye,
                           fxl_draw_entry *entries)
{
    (void)eye;
    return fxl_list_turned_faces((const fxl_turned_view *)model_view, scene, model, first, count,
                                 entries);
}

/* An eye so far that it has another unit: cones are not tested. */
static bool is_never_turned_away(const fxl_cluster *cluster, const fxl_point *eye,
                                 const fxl_model_view *model_view)
{
    (void)cluster;
    (void)eye;
    (void)model_view;
    return false;
}

static void find_clusters(const fxl_traversal *traversal, const fxl_model_view *model_view,
                          const fxl_model *model)
{
    const fxl_turned_view *turned = (const fxl_turned_view *)model_view;
    const fxl_cluster_code *code = traversal->renderer->scene->cluster_code;
    const fxl_cluster_tests tests = {
        cluster_planes, turned->eye_shift == 0 ? code->is_turned_away : is_never_turned_away,
        find_front};
    code->find_faces_by(traversal, model_view, model, &tests);
}

static uint32_t find_all_front(const fxl_scene *scene, const fxl_model *model,
                               const fxl_model_view *model_view, fxl_draw_entry *entries)
{
    return find_front(scene, model, 0, model->face_count, model_view, NULL, entries);
}

/* fxl_list_model. */
static void order_faces(const fxl_traversal *traversal, const fxl_model_view *model_view,
                        const fxl_model *model)
{
    fxl_list_found_faces(traversal, model_view, model, find_clusters, find_all_front);
}

/* What takes the faces of an instance before they are clipped. */
static void set_shader(const fxl_traversal *traversal, const fxl_draw_entry *entry,
                       const fxl_shader_code *rounded, fxl_model_view *model_view,
                       fxl_rounded_instance *instance)
{
    const fxl_renderer *renderer = traversal->renderer;
    model_view->instance = &renderer->scene->instances[entry->index];
    instance->shader.code = rounded != NULL ? rounded : rounding_of(traversal, entry->index);
    if (instance->shader.code != NULL) {
        instance->number = entry->index;
        instance->planes = entry->instance.planes;
        model_view->shader = &instance->shader;
    } else {
        model_view->shader =
            fxl_shader_reaching(renderer->shader, renderer->scene, model_view->instance);
    }
}

#if FXL_WALKS_FACES

static const fxl_face *next_face_to_near(const fxl_model_view *model_view, fxl_face_walk *walk)
{
    return fxl_next_face_by(model_view, walk, face_is_front_to_near);
}

static const fxl_face *next_face_to_any(const fxl_model_view *model_view, fxl_face_walk *walk)
{
    return fxl_next_face_by(model_view, walk, face_is_front_to_any);
}

#endif

static bool submit_turned(const fxl_traversal *traversal, const fxl_draw_entry *entry,
                          const fxl_shader_code *rounded)
{
    const fxl_renderer *renderer = traversal->renderer;
    FXL_ALIGN_8 fxl_turned_view view;
    fxl_rounded_instance instance;
    const fxl_model *model =
        fxl_turned_view_of_instance(&view, renderer->scene, entry->index, &renderer->frame.view,
                                    &traversal->workspace->cache, entry->instance.planes);
    if (rounded != NULL || traversal->clipper->by_points != NULL || renderer->shader != NULL) {
        set_shader(traversal, entry, rounded, &view.model_view, &instance);
    }
    if (fxl_lists_faces(renderer, model)) {
        return fxl_submit_sorted_once(traversal, &view.model_view, model, order_faces);
    }
#if FXL_WALKS_FACES
    if (fxl_walks_faces(traversal, &view.model_view, model)) {
        return fxl_walk_instance(traversal, &view.model_view, model,
                                 view.eye_shift == 0 ? next_face_to_near : next_face_to_any);
    }
#endif
    return !FXL_IS_COMPACT && view.eye_shift == 0
               ? fxl_submit_convex(traversal, &view.model_view, model, face_is_front_to_near)
               : fxl_submit_convex(traversal, &view.model_view, model, face_is_front_to_any);
}

static bool submit_one(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    return fxl_submit_any_instance(traversal, entry);
}

static bool submit(const fxl_traversal *traversal)
{
    if (traversal->display_list != NULL) {
        traversal->counters->rounded = (uint16_t)count_rounded(traversal, 0, 0);
    }
    return fxl_submit_all(traversal, submit_one);
}

const fxl_placement_code fxl_turned_instances = {.check = fxl_placement_check_all,
                                                 .find_visible = find_visible,
                                                 .radius = radius_of,
                                                 .face_is_front = face_is_front,
                                                 .place_vertex = place_vertex,
                                                 .place_face = place_face,
                                                 .normal = normal_of,
                                                 .list_instances = LIST_INSTANCES,
                                                 .submit = submit,
                                                 .submit_instance = submit_turned,
                                                 .count_rounded = count_rounded,
                                                 .view = fxl_turned_view_of_instance,
                                                 .rows = fxl_placement_rows,
                                                 .cluster_planes = cluster_planes,
                                                 .set_shader = set_shader};
