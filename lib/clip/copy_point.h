/* SPDX-License-Identifier: MIT */
/* Copying a point of the view by its members: for a whole record the compiler may call memcpy,
 * which takes four times the instructions on Armv6-M. Internal. */
#ifndef FXL_COPY_POINT_H
#define FXL_COPY_POINT_H

#include "../math/arith.h"

static inline void fxl_copy_point(const fxl_view_point *from, fxl_view_point *to)
{
    if (FXL_IS_SMALL) {
        *to = *from;
        return;
    }
    to->x = from->x;
    to->y = from->y;
    to->z = from->z;
}

#endif
