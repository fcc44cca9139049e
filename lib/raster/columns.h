/* SPDX-License-Identifier: MIT */
/* What a pixel of a band is, and the columns of a band. What draws works with columns of the frame,
 * in a band whose pixels are those from column 0 on: fxl_band_begin_at_column_0. Internal. */
#ifndef FXL_COLUMNS_H
#define FXL_COLUMNS_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* place pixel-format: if pixels are neither bytes nor RGB565: the kind of a pixel, and whatever asks for is_colour */
/* What a pixel is, for the functions that read or write bands. No other file looks whether a band
 * has a palette. fxl_target says the same to functions that have a renderer, and draw/pixel_row.h
 * to the texts of the targets. */
typedef struct {
    uint8_t shift;  /* a pixel takes 1 << shift bytes, at an address that is a multiple of them */
    bool is_colour; /* a colour of RGB565: the band's palette has that of each entry; else the byte
                       that is drawn, as it is */
} fxl_pixel_kind;

/* palette: that of a band, or of what draws bands. */
static inline fxl_pixel_kind fxl_kind_of_palette(const uint16_t *palette)
{
    const fxl_pixel_kind entry = {0, false}, colour = {1, true};
    return palette != NULL ? colour : entry;
}

static inline fxl_pixel_kind fxl_kind_of_band(const fxl_band *band)
{
    return fxl_kind_of_palette(band->palette);
}

/* Bytes of so many pixels. */
static inline size_t fxl_pixel_bytes(fxl_pixel_kind kind, size_t pixels)
{
    return pixels << kind.shift;
}

/* A pixel of a row: the entry, or the colour. */
static inline uint32_t fxl_pixel_at(fxl_pixel_kind kind, const void *row, uint32_t column)
{
    return kind.is_colour ? ((const uint16_t *)row)[column] : ((const uint8_t *)row)[column];
}

/* Gives a pixel a colour of the palette. place: in pixels, from the band's first pixel. */
static inline void fxl_set_pixel(const fxl_band *band, size_t place, uint8_t colour)
{
    if (!fxl_kind_of_band(band).is_colour) {
        band->pixels[place] = colour;
    } else {
        ((uint16_t *)(void *)band->pixels)[place] = band->palette[colour];
    }
}

/* How many columns there are. */
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

/* Whether the pixels and the palette of a band begin at even addresses, as those of RGB565 must. */
static inline bool fxl_band_is_even(const fxl_band *band)
{
    return (((uintptr_t)band->pixels | (uintptr_t)band->palette) & 1u) == 0;
}

/* Whether they begin at a multiple of the bytes of a pixel: those of bytes, anywhere. */
static inline bool fxl_band_is_aligned(const fxl_band *band)
{
    const uintptr_t places = (uintptr_t)band->pixels | (uintptr_t)band->palette;
    return (places & (fxl_pixel_bytes(fxl_kind_of_band(band), 1) - 1u)) == 0;
}

/* Has the address of a band's pixels be that of column 0 of the frame. No pixel before the first
 * column is read or written: the address is that of none. */
static inline void fxl_band_begin_at_column_0(fxl_band *band)
{
    band->pixels = (uint8_t *)((uintptr_t)band->pixels -
                               fxl_pixel_bytes(fxl_kind_of_band(band), band->first_column));
}

#ifdef __cplusplus
}
#endif

#endif
