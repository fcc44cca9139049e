/* SPDX-License-Identifier: MIT */
/* The order of drawing: exact integer keys, far to near (Listing 65.3,
 * ZSortObjects). Today's answer to hidden surfaces. */
#ifndef FXL_ORDER_H
#define FXL_ORDER_H

#include "fixel/scene.h"
#include "fixel/stage/sphere.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where an instance comes in the order of drawing, and what it may cross. */
typedef struct {
    uint8_t layer;
    uint8_t planes; /* that the object may cross (fxl_sphere_planes) */
} fxl_order_instance;

/* What is drawn, and its key: 12 bytes. The squared distance is in units of
 * 2^-32 (objects) or 2^-34 (faces), whole; in two halves, because a member of
 * 64 bits would make it 16. */
typedef struct {
    union {
        uint32_t distance_low;
        uint32_t face; /* once faces are sorted: which comes at this place */
    };
    uint32_t distance_high;
    uint16_t index; /* of an object of the scene, or of a face of its model */
    union {
        fxl_order_instance instance;
        uint16_t next; /* faces, while they are sorted */
    };
} fxl_order_entry;

FXL_STATIC_ASSERT(FXL_SCENE_INSTANCES_MAX <= 65535 && FXL_MODEL_FACES_MAX <= 65535, "index");

static inline fxl_order_entry fxl_order_entry_of(uint64_t distance, uint16_t index, uint8_t layer)
{
    fxl_order_entry entry;
    entry.distance_low = FXL_CAST(uint32_t, distance);
    entry.distance_high = FXL_CAST(uint32_t, distance >> 32);
    entry.index = index;
    entry.instance.layer = layer;
    entry.instance.planes = 0;
    return entry;
}

static inline uint64_t fxl_order_distance(const fxl_order_entry *entry)
{
    return FXL_CAST(uint64_t, entry->distance_high) << 32 | entry->distance_low;
}

/* The squared distance of a point from the eye, in units of 2^-32. Exact:
 * each difference is below 2^30 units, so the sum is below 3 * 2^60. */
uint64_t fxl_distance_squared(const fxl_point *eye, const fxl_point *point);

/* The squared distance from the eye of the middle of a face's bounding box,
 * taken twice (minimum + maximum - 2 eye), in units of 2^-34. Exact: each term
 * is below 2^31 units, so the sum is below 3 * 2^62. */
uint64_t fxl_face_distance_squared(const fxl_point *eye, const fxl_scene *scene,
                                   const fxl_instance *instance, const fxl_face *face);

/* Sorts objects in place by the order of drawing: layer upward, then distance
 * downward, then index upward. A total order, so the result is unique. */
void fxl_order_sort(fxl_order_entry *entries, uint32_t count);

/* Sorts faces: distance downward, then index upward. Entry n becomes that of the n-th
 * face of this order: its `face` is it, all else means nothing. Requires that the
 * entries come by rising index, and count <= FXL_MODEL_FACES_MAX. Quick where
 * distances are spread evenly, or rise or fall for a while; never slow. */
void fxl_order_sort_faces(fxl_order_entry *entries, uint32_t count);

/* Fills entries with the scene's objects in the order of drawing, but for those
 * whose sphere lies outside the frustum; answers how many. *left_out becomes the
 * number of the others' faces. Requires room for every object. */
uint32_t fxl_order_instances(const fxl_scene *scene, const fxl_camera *camera,
                             const fxl_view_frustum *frustum, fxl_order_entry *entries,
                             uint32_t *left_out);

/* Fills entries with those faces of an object that face the eye, in the order
 * of drawing (their `face` alone means something); answers how many. Requires room for the model's
 * face_count. */
uint32_t fxl_order_faces(const fxl_scene *scene, const fxl_instance *instance, const fxl_point *eye,
                         fxl_order_entry *entries);

#ifdef __cplusplus
}
#endif

#endif
