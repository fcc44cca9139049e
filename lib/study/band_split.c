/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "target_spans.h"

/* spans 3.1, 3.2 */
fxl_status fxl_band_split_draw(const fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_band *band, fxl_band_begin *begin)
{
    const uint32_t end = (uint32_t)band->first_row + band->rows;
    fxl_band part = *band;
    uint16_t rows = band->rows;
    while (part.first_row < end) {
        const fxl_counters before = workspace->counters;
        part.rows = (uint16_t)(end - part.first_row < rows ? end - part.first_row : rows);
        begin(renderer, workspace, &part);
        if (fxl_draw_band(renderer, workspace, &part) == FXL_OK) {
            part.first_row = (uint16_t)(part.first_row + part.rows);
            part.pixels += (size_t)part.rows * part.stride;
        } else {
            FXL_ASSERT(part.rows > 1);
            workspace->counters = before;
            if (workspace->counters.split_bands < UINT16_MAX) {
                workspace->counters.split_bands++;
            }
            rows = (uint16_t)((part.rows + 1) / 2);
        }
    }
    return FXL_OK;
}
