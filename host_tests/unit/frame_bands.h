/* SPDX-License-Identifier: MIT */
/* Frames of a test, filled and drawn in bands. A frame has the size of the renderer's lens, and no
 * bytes between its rows. */
#ifndef FRAME_BANDS_H
#define FRAME_BANDS_H

#include "unit.h"

/* One band of the frame that was begun, by a workspace of its own or the renderer's. */
void frame_draw_band(const fxl_renderer *renderer, fxl_workspace *workspace, uint8_t *frame,
                     uint32_t first, uint32_t rows, uint8_t background);

/* The frame that was begun, in bands of so many rows; the last band has what is left. */
void frame_draw_bands(fxl_renderer *renderer, uint8_t *frame, uint32_t rows, uint8_t background);

/* The same from a pose on. */
void frame_draw_pose(fxl_renderer *renderer, const fxl_pose *pose, uint8_t *frame, uint32_t rows,
                     uint8_t background);

/* Whether the pixel, or one of the eight about it, has a colour. */
bool frame_has_near(const uint8_t *frame, int width, int height, int pixel, uint8_t colour);

#endif
