/* SPDX-License-Identifier: MIT */
#include "../raster/columns.h"
#include "fixel/crc.h"
#include "overlay_band.h"

/* Pixels of RGB565 whose bytes are put in order at a time: 32 bytes of stack. */
#define TURNED_MAX 16u

static uint32_t continue_by_colours(uint32_t crc, const uint16_t *pixels, uint32_t count)
{
    uint8_t bytes[2u * TURNED_MAX];
    uint32_t filled = 0;
    for (uint32_t i = 0; i < count; i++) {
        bytes[filled] = (uint8_t)(pixels[i] >> 8);
        bytes[filled + 1u] = (uint8_t)pixels[i];
        filled += 2u;
        if (filled == sizeof bytes) {
            crc = fxl_crc(crc, bytes, filled);
            filled = 0;
        }
    }
    return fxl_crc(crc, bytes, filled);
}

fxl_status fxl_band_crc(uint32_t *crc, const fxl_band *band)
{
    const fxl_status status = crc == NULL ? FXL_E_ARGUMENT : fxl_overlay_check(band);
    if (status != FXL_OK) {
        return status;
    }
    const uint32_t columns = fxl_band_columns(band);
    for (uint32_t row = 0; row < band->rows; row++) {
        const size_t place = (size_t)row * band->stride; /* < 2^32: 16 bits by 16 bits */
        if (fxl_kind_of_band(band).is_colour) {
            const uint16_t *pixels = (const uint16_t *)(const void *)band->pixels;
            *crc = continue_by_colours(*crc, pixels + place, columns);
        } else {
            *crc = fxl_crc(*crc, band->pixels + place, columns);
        }
    }
    return FXL_OK;
}
