/* SPDX-License-Identifier: MIT */
#include "../../src/view/front_faces.h"

#include "../../src/scene/face_bounds.h"
#include "../family.h"

#if !FXL_KERNELS_ARMV7M

fxl_order_entry *fxl_front_faces(const fxl_face *faces, const fxl_face_bounds *keys,
                                 const fxl_point *from, fxl_order_entry *entry, uint32_t count)
{
    const fxl_point eye = *from;
    for (uint32_t i = 0; i < count; i++) {
        const fxl_face_bounds *key = &keys[i];
        if (fxl_dot(&faces[i].normal, eye.x, eye.y, eye.z) > fxl_face_bounds_height(key)) {
            uint64_t distance = fxl_box_distance(key->box_x, key->box_y, key->box_z, &eye);
            *entry++ = fxl_order_entry_of(distance, (uint16_t)i, 0);
        }
    }
    return entry;
}

#endif
