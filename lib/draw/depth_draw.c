/* SPDX-License-Identifier: MIT */
#include "depth_draw.h"

#include "submit.h"
#include "../paint/depth_row.h"

#define CLEARED_AT_ONCE 1024u /* bytes; the kernel that fills is fastest in long rows */

/* Sets so many bytes, aligned to 4, to 0. */
static void clear(uint8_t *bytes, uint32_t count)
{
    const uint32_t rows = count / CLEARED_AT_ONCE, remaining = count % CLEARED_AT_ONCE;
    fxl_band band = {.pixels = bytes,
                     .width = CLEARED_AT_ONCE,
                     .stride = CLEARED_AT_ONCE,
                     .first_row = 0,
                     .rows = (uint16_t)rows};
    if (rows > 0) {
        fxl_fill_band(&band, 0);
    }
    if (remaining > 0) {
        band.pixels += rows * CLEARED_AT_ONCE;
        band.width = band.stride = (uint16_t)remaining;
        band.rows = 1;
        fxl_fill_band(&band, 0);
    }
}

static void draw_pass(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band,
                      uint8_t pass)
{
    ((fxl_depth_head *)workspace->target_memory)->pass = pass;
    (void)fxl_draw_band(renderer, workspace, band);
}

static void draw_part(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band)
{
    if (renderer->near_first) {
        draw_pass(renderer, workspace, band, FXL_DEPTH_ALL);
        return;
    }
    for (uint8_t pass = FXL_DEPTH_OPAQUE; pass <= FXL_DEPTH_BLENDED; pass++) {
        draw_pass(renderer, workspace, band, pass);
    }
}

void fxl_depth_draw_parts(const fxl_renderer *renderer, fxl_workspace *workspace,
                          const fxl_band *band, uint32_t cell_bytes, uint32_t pixel_bytes)
{
    fxl_depth_head *head = (fxl_depth_head *)workspace->target_memory;
    const uint32_t row_bytes = band->width * cell_bytes;
    const uint32_t room =
        (workspace->target_memory_size - (uint32_t)sizeof(fxl_depth_head)) / row_bytes;
    fxl_band part = *band;
    uint32_t left = band->rows;
    FXL_ASSERT(room > 0);
    head->scale = fxl_depth_scale_of(&renderer->frame.view.lens);
    head->or_equal = !renderer->near_first;
    for (;;) {
        part.rows = (uint16_t)(left < room ? left : room);
        clear((uint8_t *)(head + 1), part.rows * row_bytes);
        draw_part(renderer, workspace, &part);
        left -= part.rows;
        if (left == 0) {
            return;
        }
        if (workspace->counters.split_bands < UINT16_MAX) {
            workspace->counters.split_bands++;
        }
        part.first_row = (uint16_t)(part.first_row + part.rows);
        part.pixels += (size_t)part.rows * part.stride * pixel_bytes;
    }
}
