/* SPDX-License-Identifier: MIT */
#include "frame_bands.h"

void frame_draw_band(const fxl_renderer *renderer, fxl_workspace *workspace, uint8_t *frame,
                     uint32_t first, uint32_t rows, uint8_t background)
{
    const uint16_t width = renderer->frame.view.lens.width;
    const fxl_band band = UNIT_BAND(frame + first * width, width, (uint16_t)first, (uint16_t)rows);
    fxl_fill_band(&band, background);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_with(renderer, workspace, &band));
}

void frame_draw_bands(fxl_renderer *renderer, uint8_t *frame, uint32_t rows, uint8_t background)
{
    const uint32_t height = renderer->frame.view.lens.height;
    for (uint32_t row = 0; row < height; row += rows) {
        const uint32_t left = height - row;
        frame_draw_band(renderer, &renderer->workspace, frame, row, rows < left ? rows : left,
                        background);
    }
}

void frame_draw_pose(fxl_renderer *renderer, const fxl_pose *pose, uint8_t *frame, uint32_t rows,
                     uint8_t background)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(renderer, pose));
    frame_draw_bands(renderer, frame, rows, background);
}

bool frame_has_near(const uint8_t *frame, int width, int height, int pixel, uint8_t colour)
{
    int x = pixel % width, y = pixel / width;
    for (int j = y - 1; j <= y + 1; j++) {
        for (int i = x - 1; i <= x + 1; i++) {
            if (i >= 0 && i < width && j >= 0 && j < height && frame[j * width + i] == colour) {
                return true;
            }
        }
    }
    return false;
}
