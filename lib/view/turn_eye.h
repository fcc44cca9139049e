/* SPDX-License-Identifier: MIT */
/* The eye in the space of a model that is scaled, or far away. Internal. */
#ifndef FXL_TURN_EYE_H
#define FXL_TURN_EYE_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* fxl_turn_eye from the exact eye, orientation^T . (eye - centre) in units of 2^-46. */
unsigned fxl_turn_divide_eye(const fxl_q18_46 exact[3], fxl_q16_16 scale, fxl_q16_16 radius,
                             fxl_point *eye);

#ifdef __cplusplus
}
#endif

/* Whether no coordinate exceeds the limit, which is at least 0. */
static inline bool fxl_eye_is_within(const fxl_point *point, int32_t limit)
{
    const uint32_t most = (uint32_t)limit;
    return (uint32_t)point->x + most <= 2 * most && (uint32_t)point->y + most <= 2 * most &&
           (uint32_t)point->z + most <= 2 * most;
}

#endif
