/* SPDX-License-Identifier: MIT */
/* From a matrix that is nearly a rotation to the nearest rotation. Internal. */
#ifndef FXL_ORTHONORMAL_H
#define FXL_ORTHONORMAL_H

#include <stdbool.h>
#include <stdint.h>

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Three rows in units of 2^-60. */
typedef struct {
    int64_t rows[3][3];
} fxl_wide_matrix;

/* Writes the rotation that is nearest to a matrix. Requires a matrix C for which no eigenvalue of
 * C C' - I is above 2^-22 in magnitude.
 * Error: at most 0.501 unit of 2^-30 an entry. So a row is at most
 * sqrt(3) * 0.501 = 0.87 unit off unit length, and two rows are 1.74 units off a right angle. */
void fxl_orthonormalise(const fxl_wide_matrix *matrix, fxl_orientation *orientation);

/* unit = vector / |vector| in units of 2^-31. Takes components below 2^62. Returns false for a
 * vector of length 0, and leaves unit untouched.
 * Error: at most 1 unit of 2^-31 an entry if every component is below 2^31, else 2.5. */
bool fxl_unit_length(const int64_t vector[3], int64_t unit[3]);

#ifdef __cplusplus
}
#endif

#endif
