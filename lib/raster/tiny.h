/* SPDX-License-Identifier: MIT */
/* Triangles of at most 2 x 2 pixel centres: which of these they cover, by the exact edge functions
 * at each centre instead of a scan. Internal. */
#ifndef FXL_TINY_H
#define FXL_TINY_H

#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_TINY_SIDE 2

/* Compiled for few bytes, triangles are scanned whatever their size. */
#define FXL_HAS_TINY (!FXL_IS_SMALL && !FXL_IS_COMPACT)

/* The pixels that a triangle covers in a band: bit FXL_TINY_SIDE j + i is that of column + i of
 * row + j. */
typedef struct {
    int32_t column, row;
    uint32_t pixels;
} fxl_tiny;

/* Finds the pixels of a band, all of whose columns are drawn, that a triangle covers: those of a
 * scan. Returns false if it is not tiny: *tiny is undefined then. Exact. */
bool fxl_tiny_find(const fxl_screen_point *points, const fxl_band *band, fxl_tiny *tiny);

#ifdef __cplusplus
}
#endif

#endif
