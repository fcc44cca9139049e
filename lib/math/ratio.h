/* SPDX-License-Identifier: MIT */
/* The quotient in the projections of the other clippers (lib/study). Internal. */
#ifndef FXL_RATIO_H
#define FXL_RATIO_H

#include "fixel/types.h"

/* factor * side / depth, rounded to the nearest unit of factor. Returns false if its
 * magnitude is above limit: quotient untouched.
 * Requires 0 < factor < 2^29, |side| < 2^61, 0 < depth < 2^61, 0 < limit < 2^29.
 * Error: 0.5 + 2^-30 unit + 2^-31 of the quotient. */
bool fxl_ratio(fxl_q16_16 factor, fxl_q18_46 side, fxl_q18_46 depth, int32_t limit,
               int32_t *quotient);

#endif
