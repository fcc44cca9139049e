/* SPDX-License-Identifier: MIT */
/* The columns of a band. What draws works with columns of the frame, in a band whose pixels are
 * those from column 0 on: fxl_band_begin_at_column_0. Internal. */
#ifndef FXL_COLUMNS_H
#define FXL_COLUMNS_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How many there are. */
static inline uint32_t fxl_band_columns(const fxl_band *band)
{
    return band->columns != 0 ? band->columns : band->width;
}

static inline uint32_t fxl_band_end_column(const fxl_band *band)
{
    return band->first_column + fxl_band_columns(band);
}

/* Whether rows and columns lie within a frame, and those of a row within the stride. */
static inline bool fxl_band_is_within(const fxl_band *band, uint32_t width, uint32_t height)
{
    return band->stride >= fxl_band_columns(band) && fxl_band_end_column(band) <= width &&
           band->rows >= 1 && (uint32_t)band->first_row + band->rows <= height;
}

/* place pixel-format: asks: where a column is */
/* Whether the pixels and the palette of a band of RGB565 begin at even addresses. A band of bytes has
 * no palette, and may begin anywhere. */
static inline bool fxl_band_is_aligned(const fxl_band *band)
{
    const uintptr_t places = (uintptr_t)band->pixels | (uintptr_t)band->palette;
    return band->palette == NULL || (places & 1u) == 0;
}

/* Has the address of a band's pixels be that of column 0 of the frame. No pixel before the first
 * column is read or written: the address is that of none. */
static inline void fxl_band_begin_at_column_0(fxl_band *band)
{
    const uint32_t bytes = (uint32_t)band->first_column << (band->palette != NULL);
    band->pixels = (uint8_t *)((uintptr_t)band->pixels - bytes);
}

#ifdef __cplusplus
}
#endif

#endif
