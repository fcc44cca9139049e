/* SPDX-License-Identifier: MIT */
/* A vector brought to unit length, with one bit more than 2.30. Internal. */
#ifndef FXL_UNIT_LENGTH_H
#define FXL_UNIT_LENGTH_H

#include <stdbool.h>
#include <stdint.h>

/* unit = vector / |vector| in units of 2^-31. Takes components below 2^62. Returns false for a
 * vector of length 0, and leaves unit untouched.
 * Error: at most 1 unit of 2^-31 an entry if every component is below 2^31, else 2.5. */
bool fxl_unit_length(const int64_t vector[3], int64_t unit[3]);

#endif
