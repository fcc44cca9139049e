/* SPDX-License-Identifier: MIT */
/* What a scene with placements links. All other code reaches turned instances through this record,
 * so that a program whose scenes have no placements links none of it. Internal. */
#ifndef FXL_PLACEMENT_CODE_H
#define FXL_PLACEMENT_CODE_H

#include "../math/arith.h"
#include "fixel/records.h"

struct fxl_camera;
struct fxl_view_frustum;
struct fxl_draw_entry;
struct fxl_renderer;
struct fxl_shader_code;
struct fxl_traversal;
struct fxl_turned_view; /* lib/view/placement.h */
struct fxl_rounded_instance; /* lib/draw/rounded_faces.h */

struct fxl_placement_code {
    /* Whether all instances from first_turned on may be turned as they are: fxl_placement_check. On
     * failure *number is the instance. */
    fxl_status (*check)(const fxl_scene *scene, uint32_t *number);
    /* fxl_frame_begin's part from the camera to the order of the instances. *culled: the faces of
     * those out of sight. FXL_E_ARGUMENT, FXL_E_RANGE, FXL_E_PLACEMENT, FXL_E_CAPACITY (the order):
     * the frame before has ended. */
    fxl_status (*find_visible)(struct fxl_renderer *renderer, const fxl_pose *pose,
                               uint32_t *culled);
    /* fxl_placement_radius of a turned instance. */
    fxl_q16_16 (*radius)(const fxl_scene *scene, uint32_t number);
    /* fxl_face_is_front of a turned instance. */
    bool (*face_is_front)(const fxl_scene *scene, uint32_t number, const fxl_face *face,
                          const fxl_point *eye);
    /* A vertex of a turned instance in the world, rounded once, by its number within the model. */
    fxl_point (*place_vertex)(const fxl_scene *scene, uint32_t number, uint32_t vertex);
    /* The points of a face of a turned instance in the world, rounded once, at most
     * FXL_FACE_VERTICES_MAX. */
    void (*place_face)(const fxl_scene *scene, uint32_t number, const fxl_face *face,
                       fxl_point *points);
    /* The normal of a face of a turned instance in the world, rounded once. */
    fxl_direction (*normal)(const fxl_scene *scene, uint32_t number, const fxl_face *face);
    /* fxl_list_still_instances of any scene. */
    uint32_t (*list_instances)(const fxl_scene *scene, const struct fxl_camera *camera,
                               const struct fxl_view_frustum *frustum,
                               struct fxl_draw_entry *entries, uint32_t *left_out);
    /* fxl_submit_by_distance. */
    bool (*submit)(const struct fxl_traversal *traversal);
    /* fxl_submit_instance of a turned instance. rounded: fxl_rounded_faces, if its points are
     * rounded in the world, whatever the clipper needs; else null. */
    bool (*submit_instance)(const struct fxl_traversal *traversal,
                            const struct fxl_draw_entry *entry,
                            const struct fxl_shader_code *rounded);
    /* The instances in sight whose points are rounded in the world, if all in the places from first
     * to end - 1 of the frame's order are: fxl_counters.rounded. */
    uint32_t (*count_rounded)(const struct fxl_traversal *traversal, uint32_t first, uint32_t end);
    /* fxl_turned_view_of_instance. */
    const fxl_model *(*view)(struct fxl_turned_view *turned, const fxl_scene *scene,
                             uint32_t number, const fxl_view *view, fxl_vertex_cache *cache,
                             uint32_t planes);
    /* For an orthographic lens: fxl_placement_rows; fxl_turned_cluster_planes, of a view's first
     * member; and what sets the model view's shader, for which `rounded` is room. */
    void (*rows)(const fxl_axes *view, const fxl_orientation *of, fxl_axes *matrix);
    uint32_t (*cluster_planes)(const fxl_cluster *cluster, const fxl_model_view *model_view);
    void (*set_shader)(const struct fxl_traversal *traversal, const struct fxl_draw_entry *entry,
                       const struct fxl_shader_code *rounded, fxl_model_view *model_view,
                       struct fxl_rounded_instance *instance);
};

#ifdef __cplusplus
extern "C" {
#endif

/* Added to scale * radius, in units of 1/65536: more than tolerated rows and all rounding move a
 * point of an instance away from its centre. */
#define FXL_PLACEMENT_SLACK 32

/* The radius of a turned instance: scale * radius, rounded upward, and FXL_PLACEMENT_SLACK. No
 * point of the instance is farther from its centre. Requires a scale within its range and
 * scale * radius <= 2 * FXL_COORDINATE_MAX. */
fxl_q16_16 fxl_placement_radius(const fxl_placement *placement, fxl_q16_16 radius);

/* fxl_placement_code.check. */
fxl_status fxl_placement_check_all(const fxl_scene *scene, uint32_t *number);

/* Whether the scales of all turned instances are in range and their spheres lie in the world: what
 * fxl_placement_check answers FXL_E_RANGE for where they do not. */
bool fxl_placement_places_are_in_range(const fxl_scene *scene);

/* Whether rows are those of a rotation: what fxl_placement_check answers FXL_E_PLACEMENT for if
 * not. */
bool fxl_is_rotation(const fxl_orientation *rows)
    FXL_REQUIRES(FXL_READABLE(rows)) FXL_ASSIGNS();

#ifdef __cplusplus
}
#endif

/* Whether all placements of a scene are those of rotations in range: fxl_placement_check. A scene
 * without placements passes. */
static inline fxl_status fxl_check_placements(const fxl_scene *scene)
{
    uint32_t number;
    if (scene->placements == NULL) {
        return FXL_OK;
    }
    return scene->placement_code == NULL ? FXL_E_ORDER
                                         : scene->placement_code->check(scene, &number);
}

/* fxl_placement_radius. scale * radius is below 2^24 2^31. */
static inline fxl_q16_16 fxl_scaled_radius(fxl_q16_16 scale, fxl_q16_16 radius)
{
    const uint64_t scaled = fxl_multiply_u32((uint32_t)scale, (uint32_t)radius);
    return (fxl_q16_16)((scaled + 0xFFFF) >> 16) + FXL_PLACEMENT_SLACK;
}

/* The number of the first turned instance; the number of instances where none is turned. */
static inline uint32_t fxl_first_turned(const fxl_scene *scene)
{
    return scene->placements != NULL && scene->first_turned < scene->instance_count
               ? scene->first_turned
               : scene->instance_count;
}

/* The code for an instance; null for one that is not turned. */
static inline const fxl_placement_code *fxl_placement_code_of(const fxl_scene *scene,
                                                              uint32_t number)
{
    return scene->placements != NULL && number >= scene->first_turned ? scene->placement_code
                                                                      : NULL;
}

static inline const fxl_placement *fxl_placement_of(const fxl_scene *scene, uint32_t number)
{
    return &scene->placements[number - scene->first_turned];
}

/* The number of an instance of the scene. */
static inline uint32_t fxl_instance_number(const fxl_scene *scene, const fxl_instance *instance)
{
    return (uint32_t)(instance - scene->instances);
}

/* The radius of an instance, turned or not. */
static inline fxl_q16_16 fxl_instance_radius(const fxl_scene *scene, const fxl_instance *instance)
{
    const uint32_t number = fxl_instance_number(scene, instance);
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
    return turned != NULL ? turned->radius(scene, number) : scene->models[instance->model].radius;
}

#endif
