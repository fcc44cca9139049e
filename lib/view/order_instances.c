/* SPDX-License-Identifier: MIT */
/* A file of its own, so that the compiler does not spend registers of the loop on the choice. */
#include "../scene/turn_code.h"
#include "order.h"

uint32_t fxl_order_instances(const fxl_scene *scene, const fxl_camera *camera,
                             const fxl_view_frustum *frustum, fxl_order_entry *entries,
                             uint32_t *left_out)
{
    return scene->turns != NULL
               ? scene->turn_code->order(scene, camera, frustum, entries, left_out)
               : fxl_order_still_instances(scene, camera, frustum, entries, left_out);
}
