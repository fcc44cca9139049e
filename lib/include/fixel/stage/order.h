/* SPDX-License-Identifier: MIT */
/* The order of drawing: far to near, by exact integer keys. */
#ifndef FXL_ORDER_H
#define FXL_ORDER_H

#include "fixel/scene.h"
#include "fixel/stage/sphere.h"

/* An instance or a face, with its key. The squared distance is an integer, in units of
 * 2^-32 (instances) or 2^-34 (faces). It has two halves because a member of 64 bits
 * would make the entry 16 bytes instead of 12. */
typedef struct {
    union {
        uint32_t distance_low;
        uint32_t face; /* after fxl_order_sort_faces: the face at this place of the order */
    };
    uint32_t distance_high;
    uint16_t index; /* of an instance of the scene, or of a face of its model */
    union {
        struct {
            uint8_t layer;
            uint8_t planes; /* that the instance may cross (fxl_sphere_planes) */
        };
        uint16_t next; /* of faces, while they are sorted: the next entry of a chain */
    };
} fxl_order_entry;

_Static_assert(FXL_SCENE_INSTANCES_MAX <= 65535 && FXL_MODEL_FACES_MAX <= 65535, "index");

static inline fxl_order_entry fxl_order_entry_of(uint64_t distance, uint16_t index, uint8_t layer)
{
    fxl_order_entry entry = {
        .distance_low = (uint32_t)distance,
        .distance_high = (uint32_t)(distance >> 32),
        .index = index,
        .layer = layer,
    };
    return entry;
}

static inline uint64_t fxl_order_distance(const fxl_order_entry *entry)
{
    return (uint64_t)entry->distance_high << 32 | entry->distance_low;
}

/* The squared distance of a point from the eye, in units of 2^-32.
 * Requires both within FXL_COORDINATE_MAX. Exact: each difference is below 2^30
 * units, so the sum is below 3 * 2^60. */
uint64_t fxl_distance_squared(const fxl_point *eye, const fxl_point *point);

/* The squared distance from the eye to the middle of a face's bounding box, with all
 * coordinates doubled (minimum + maximum - 2 eye), in units of 2^-34.
 * Requires a checked scene, and an eye within FXL_COORDINATE_MAX. Exact: each term
 * is below 2^31 units, so the sum is below 3 * 2^62. */
uint64_t fxl_face_distance_squared(const fxl_point *eye, const fxl_scene *scene,
                                   const fxl_instance *instance, const fxl_face *face);

/* Sorts instances in place by the order of drawing: layer upward, then distance
 * downward, then index upward. It is a total order, so the result is unique. */
void fxl_order_sort(fxl_order_entry *entries, uint32_t count);

/* Sorts faces in place: distance downward, then index upward. Then `face` of entry n is
 * the n-th face of the order; all other members have no meaning.
 * Requires entries by rising index, and count <= FXL_MODEL_FACES_MAX.
 * It is fastest if the distances are spread evenly, or rise or fall in long runs. Its
 * time is at most of order count * log(count); with FXL_SMALL, of order count^(4/3). */
void fxl_order_sort_faces(fxl_order_entry *entries, uint32_t count);

/* Fills entries with the scene's instances in the order of drawing, without those that the
 * sphere test rejects. Returns their number. *left_out becomes the number of faces of the
 * rejected instances.
 * Requires a checked scene, a camera and a frustum made by their functions, and
 * instance_count entries. The order is exact; for the sphere test see fxl_sphere_planes.
 * Source: A7 (Listing 65.3, ZSortObjects). */
uint32_t fxl_order_instances(const fxl_scene *scene, const fxl_camera *camera,
                             const fxl_view_frustum *frustum, fxl_order_entry *entries,
                             uint32_t *left_out);

/* Fills entries with those faces of an instance that face the eye, in the order of drawing. Returns
 * their number. Only the member `face` of the entries has a meaning.
 * Requires a checked scene, an eye within FXL_COORDINATE_MAX, and as many entries as the model has
 * faces. Exact. */
uint32_t fxl_order_faces(const fxl_scene *scene, const fxl_instance *instance, const fxl_point *eye,
                         fxl_order_entry *entries);

#endif
