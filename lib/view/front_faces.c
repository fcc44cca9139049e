/* SPDX-License-Identifier: MIT */

#include "../math/family.h"
#include "../scene/face_bounds.h"
#include "cull.h"
#include "order.h"

#if !FXL_KERNELS_ARMV6M && !FXL_KERNELS_ARMV7M

fxl_draw_entry *fxl_front_faces(const fxl_face *faces, const fxl_face_bounds *bounds,
                                const fxl_point *eye, fxl_draw_entry *entry, uint32_t count,
                                uint32_t end)
{
    const fxl_point from = *eye;
    for (uint32_t i = 0; i < count; i++) {
        const fxl_face_bounds *face_bounds = &bounds[i];
        if (fxl_dot(&faces[i].normal, from.x, from.y, from.z) >
            fxl_face_bounds_height(face_bounds)) {
            uint64_t distance =
                fxl_box_distance(face_bounds->box_x, face_bounds->box_y, face_bounds->box_z, &from);
            *entry++ = fxl_draw_entry_of(distance, (uint16_t)(end - count + i), 0);
        }
    }
    return entry;
}

#endif
