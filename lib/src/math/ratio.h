/* SPDX-License-Identifier: MIT */
/* The quotient that every projection of the family is made of. Not part of the
 * public interface. */
#ifndef FXL_RATIO_H
#define FXL_RATIO_H

#include "fixel/types.h"

/* factor * side / depth, rounded to the nearest unit of factor; false where it
 * lies beyond limit either way. Requires 0 < factor < 2^29, |side| < 2^61,
 * 0 < depth < 2^61, 0 < limit < 2^29.
 * Error: 0.5 + 2^-30 + 2^-31 of the quotient. */
bool fxl_ratio(fxl_q16_16 factor, fxl_q18_46 side, fxl_q18_46 depth, int32_t limit,
               int32_t *quotient);

#endif
