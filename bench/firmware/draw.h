/* SPDX-License-Identifier: MIT */
/* The functions that draw a frame: with Fixel, the chapter's listing, or a plain memset. A
 * program links one of them. */
#ifndef BENCH_DRAW_H
#define BENCH_DRAW_H

#include "fixel/render.h"

/* The largest screen of a workload, in pixels. */
#ifndef DRAW_PIXELS_MAX
#define DRAW_PIXELS_MAX (320u * 240u)
#endif

/* Prepares for a scene, which must stay valid; not measured. Returns a SYSTEM_EXIT_... code. */
int draw_open(const fxl_scene_image *image);

/* Draws a frame over a cleared band of the whole screen. This is what is measured. Returns false
 * where the renderer refused. */
bool draw_frame(const fxl_pose *pose, const fxl_band *band);

/* Bytes of RAM that drawing needs beside the band, the scene and the stack. */
uint32_t draw_memory(void);

/* After draw_open: what draws. Of programs that draw with Fixel and change what is drawn. */
fxl_renderer *draw_renderer(void);

/* The counters of the frame; zeroes where the renderer does not count. */
const fxl_counters *draw_counters(void);

#define NOT_CLEARED (-1)

/* Draws a frame into a band of the whole screen. background: the colour that each band is filled
 * with first, or NOT_CLEARED. False where the renderer refused. */
static inline bool draw_in_bands(fxl_renderer *renderer, const fxl_pose *pose,
                                 const fxl_band *whole, uint32_t rows, int background)
{
    const uint32_t row_bytes = whole->stride * (renderer->target->pixel_bits / 8u);
    fxl_band band = *whole;

    if (fxl_frame_begin(renderer, pose) != FXL_OK) {
        return false;
    }
    for (uint32_t row = 0; row < whole->rows; row += rows) {
        const uint32_t left = whole->rows - row;
        band.pixels = whole->pixels + row * row_bytes;
        band.first_row = (uint16_t)row;
        band.rows = (uint16_t)(left < rows ? left : rows);
        if (background != NOT_CLEARED) {
            renderer->fill(renderer, &band, (uint8_t)background);
        }
        if (fxl_frame_draw(renderer, &band) != FXL_OK) {
            return false;
        }
    }
    return true;
}

#endif
