/* SPDX-License-Identifier: MIT */
/* The order of drawing: far to near, by exact integer keys. Internal. */
#ifndef FXL_VIEW_ORDER_H
#define FXL_VIEW_ORDER_H

#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

static inline fxl_draw_entry fxl_draw_entry_of(uint64_t distance, uint16_t index, uint8_t layer)
{
    fxl_draw_entry entry;
    entry.distance_low = FXL_CAST(uint32_t, distance & UINT32_MAX);
    entry.distance_high = FXL_CAST(uint32_t, distance >> 32);
    entry.index = index;
    entry.instance.layer = layer;
    entry.instance.planes = 0;
    return entry;
}

static inline uint64_t fxl_draw_entry_distance(const fxl_draw_entry *entry)
{
    return FXL_CAST(uint64_t, entry->distance_high) << 32 | entry->distance_low;
}

/* The squared distance of a point from the eye, in units of 2^-32.
 * Requires both within FXL_COORDINATE_MAX. Exact: each difference is below 2^30
 * units, so the sum is below 3 * 2^60. */
uint64_t fxl_distance_squared(const fxl_point *eye, const fxl_point *point);

/* Sorts instances in place by the order of drawing: layer upward, then distance
 * downward, then index upward. It is a total order, so the result is unique. */
void fxl_sort_instances(fxl_draw_entry *entries, uint32_t count);

/* Sorts faces in place: distance downward, then index upward; if work is null, by index alone. Then
 * `face` of entry n is the n-th face of the order; all other members have no meaning.
 * Requires entries by rising index and of layer 0, and count <= FXL_MODEL_FACES_MAX.
 * It is fastest if the distances are spread evenly, or rise or fall in long runs: of order count
 * from 6 FXL_ORDER_CHAINS faces on. Its time is at most of order count * log(count), or
 * count^2 / FXL_ORDER_CHAINS where that is less;
 * with FXL_SMALL, or with -Os where distances are not spread, of order count^(4/3). */
void fxl_sort_faces(fxl_draw_entry *entries, uint32_t count, fxl_sort_work *work);

/* Fills entries with the scene's instances in the order of drawing, without those that the
 * sphere test rejects. Returns their number. *left_out becomes the number of faces of the
 * rejected instances.
 * Requires a checked scene of which no instance is turned (a library for size lists turned ones
 * too), a camera and a frustum made by their functions, and
 * instance_count entries. The order is exact; for the sphere test see fxl_sphere_planes.
 * Source: A7 (Listing 65.3, ZSortObjects). */
uint32_t fxl_list_still_instances(const fxl_scene *scene, const fxl_camera *camera,
                                  const fxl_view_frustum *frustum, fxl_draw_entry *entries,
                                  uint32_t *left_out);

/* Fills entries with those faces of a model that face the eye, by rising index and with their
 * distances. Returns their number.
 * Requires a checked scene, an eye relative to the instance's centre, each coordinate below 2^30,
 * and as many entries as the model has faces. Exact. */
uint32_t fxl_list_front_faces(const fxl_scene *scene, const fxl_model *model, const fxl_point *eye,
                              fxl_draw_entry *entries);

/* Takes those faces out of count entries whose vertices all lie outside one of the model view's
 * planes: it fetches the vertices. Returns the number of entries that are left, in their order.
 * faces are the model's. Exact. */
uint32_t fxl_drop_outside(const fxl_model_view *model_view, const fxl_face *faces,
                          fxl_draw_entry *entries, uint32_t count);

/* The entry of an instance that may cross planes. */
static inline fxl_draw_entry fxl_draw_instance_of(const fxl_instance *instance, uint32_t number,
                                                  uint32_t planes, const fxl_camera *camera)
{
    fxl_draw_entry entry =
        fxl_draw_entry_of(fxl_distance_squared(&camera->position, &instance->centre),
                          (uint16_t)number, instance->layer);
    entry.instance.planes = (uint8_t)planes;
    return entry;
}

#ifdef __cplusplus
}
#endif

#endif
