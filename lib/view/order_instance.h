/* SPDX-License-Identifier: MIT */
/* An instance's entry in the order of drawing. Internal. */
#ifndef FXL_ORDER_INSTANCE_H
#define FXL_ORDER_INSTANCE_H

#include "fixel/stage/order.h"

#ifdef __cplusplus
extern "C" {
#endif

/* fxl_order_instances of a scene of which no instance is turned. */
uint32_t fxl_order_still_instances(const fxl_scene *scene, const fxl_camera *camera,
                                   const fxl_view_frustum *frustum, fxl_order_entry *entries,
                                   uint32_t *left_out);

#ifdef __cplusplus
}
#endif

/* The entry of an instance that may cross planes. */
static inline fxl_order_entry fxl_order_instance_of(const fxl_instance *instance, uint32_t number,
                                                    uint32_t planes, const fxl_camera *camera)
{
    fxl_order_entry entry =
        fxl_order_entry_of(fxl_distance_squared(&camera->position, &instance->centre),
                           (uint16_t)number, instance->layer);
    entry.instance.planes = (uint8_t)planes;
    return entry;
}

#endif
