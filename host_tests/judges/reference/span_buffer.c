/* SPDX-License-Identifier: MIT */
#include "reference/span_buffer.h"

#include <string.h>

void ref_span_buffer_begin(ref_span_buffer *cover, bool *covered, const ref_band *band)
{
    *cover = (ref_span_buffer){covered, band->width, band->first_row, band->rows};
    memset(covered, 0, (size_t)band->width * (size_t)band->rows * sizeof *covered);
}

static bool *row_of(const ref_span_buffer *cover, int y)
{
    return cover->covered + (ptrdiff_t)(y - cover->first_row) * cover->width;
}

static long runs_of(const bool *row, int width)
{
    long runs = 0;
    for (int x = 0; x < width; x++) {
        runs += row[x] && (x == 0 || !row[x - 1]);
    }
    return runs;
}

long ref_span_buffer_intervals(const ref_span_buffer *cover)
{
    long runs = 0;
    for (int y = 0; y < cover->rows; y++) {
        runs += runs_of(row_of(cover, cover->first_row + y), cover->width);
    }
    return runs;
}

bool ref_span_buffer_draw(ref_span_buffer *cover, const ref_span *span, uint8_t colour,
                          const ref_band *band, long runs)
{
    bool *row = row_of(cover, span->y), with[REF_SCREEN_MAX];
    memcpy(with, row, (size_t)cover->width * sizeof *row);
    for (int x = span->x0; x < span->x1; x++) {
        with[x] = true;
    }
    if (ref_span_buffer_intervals(cover) - runs_of(row, cover->width) +
            runs_of(with, cover->width) >
        runs) {
        return false;
    }
    uint8_t *pixels = band->pixels + (ptrdiff_t)(span->y - band->first_row) * band->stride;
    for (int x = span->x0; x < span->x1; x++) {
        if (!row[x]) {
            pixels[x] = colour;
        }
        row[x] = true;
    }
    return true;
}
