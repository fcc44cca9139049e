/* SPDX-License-Identifier: MIT */
#include "columns.h"
#include "draw_outline.h"
#include "fill.h"

static void set_pixel(const fxl_band *band, int32_t x, int32_t y, uint8_t colour)
{
    const int32_t row = y - band->first_row;
    if (x >= band->first_column && x < (int32_t)fxl_band_end_column(band) &&
        row >= 0 && row < band->rows) {
        fxl_set_pixel(band, (size_t)row * band->stride + (size_t)x, colour);
    }
}

/* wire 2.2, 2.3 */
void fxl_draw_line_pixels(fxl_line_pixels *line, int32_t first, int32_t end, uint8_t colour,
                          const fxl_band *band)
{
    for (int32_t along = first; along < end; along++) {
        if (line->upright) {
            set_pixel(band, line->across, along, colour);
        } else {
            set_pixel(band, along, line->across, colour);
        }
        line->left += line->step;
        if (line->left >= line->pixel) {
            line->left -= line->pixel;
            line->across++;
        } else if (line->left < 0) {
            line->left += line->pixel;
            line->across--;
        }
    }
}
