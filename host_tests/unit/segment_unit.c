/* SPDX-License-Identifier: MIT */
#include "segment_unit.h"

segment_row segment;

void segment_begin(void)
{
    segment.state = 2463534242u;
    memset(&segment.gradients, 0, sizeof segment.gradients);
    memset(&segment.paint, 0, sizeof segment.paint);
    memset(&segment.row, 0, sizeof segment.row);
    segment.gradients.count = 2;
    segment.gradients.weight_min[0] = segment.gradients.weight_min[1] = 1;
    segment.paint.gradients = &segment.gradients;
    segment.paint.level.texels = segment.texels;
    segment.paint.opacity = 16;
}

uint32_t segment_any(void)
{
    segment.state ^= segment.state << 13;
    segment.state ^= segment.state >> 17;
    segment.state ^= segment.state << 5;
    return segment.state;
}

/* place sampling: definition: texels of lit surfaces, segments, divided pixels, RGB565 */
void segment_choose_size(uint32_t log_width, uint32_t log_height)
{
    segment.paint.level.log_width = (uint8_t)log_width;
    segment.paint.level.columns_less_1 = (1u << log_width) - 1u;
    segment.paint.level.rows_less_1 = (1u << log_height) - 1u;
}

void segment_choose_gradient(fxl_gradient *gradient, int64_t *at, double from, double to)
{
    gradient->at = *at = (int64_t)ldexp(from, 32);
    gradient->along = (int64_t)(ldexp(to - from, 32) / SEGMENT_COLUMNS);
}

double segment_exact(const fxl_gradient *gradient, int column)
{
    return ldexp((double)(gradient->at + gradient->along * column), -32);
}

double segment_divided(uint32_t attribute, int column)
{
    return ldexp(segment_exact(&segment.gradients.attributes[attribute], column) /
                     segment_exact(&segment.gradients.weight, column),
                 segment.gradients.shifts[attribute] - 16);
}

double segment_on_line(uint32_t attribute, int x, int columns)
{
    const int first = x & -columns;
    const double from = segment_divided(attribute, first),
                 to = segment_divided(attribute, first + columns);
    return from + (to - from) * (x - first) / columns;
}

void segment_choose_log(uint32_t log)
{
    for (uint32_t i = 0; i < 3; i++) {
        segment.face.least[i] = log != 0 && i >= 4 - log ? 2 : INT32_MAX;
    }
    segment.face.least[3] = 2;
}

double segment_distance(double coordinate, uint32_t n, uint32_t log)
{
    const double size = ldexp(1, (int)log), from_middle = coordinate - n - 0.5;
    return fabs(from_middle - size * floor(from_middle / size + 0.5)) - 0.5;
}

void segment_choose_face(void)
{
    const double weights[2] = {67108864.0 + segment_any() % 900000000u,
                               67108864.0 + segment_any() % 900000000u};
    segment_choose_gradient(&segment.gradients.weight, &segment.row.weight, weights[0], weights[1]);
    for (uint32_t i = 0; i < 2; i++) {
        const double from = (int)(segment_any() % 400u) - 200 + (segment_any() & 255u) / 256.0;
        const double to = from + (int)(segment_any() % 161u) - 80;
        segment.gradients.shifts[i] = 24;
        segment_choose_gradient(&segment.gradients.attributes[i], &segment.row.attributes[i],
                                from * weights[0] / 256, to * weights[1] / 256);
    }
}

void segment_paint_row(uint8_t *pixels, int32_t x0, int32_t x1)
{
    memset(pixels, SEGMENT_UNTOUCHED, SEGMENT_COLUMNS);
    segment.row.pixels = pixels;
    fxl_paint_segments(&segment.face, &segment.row, x0, x1);
}
