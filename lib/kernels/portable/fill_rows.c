/* SPDX-License-Identifier: MIT */
#include "fixel/fill.h"

#include "arith.h"

typedef uint32_t __attribute__((may_alias)) word;

#define IS_WORD(address) (((uintptr_t)(address)&3u) == 0)

static void fill_row(uint8_t *pixel, uint8_t *end, uint32_t four)
{
    while (pixel != end && !IS_WORD(pixel)) {
        *pixel++ = (uint8_t)four;
    }
    for (; end - pixel >= 16; pixel += 16) {
        word *words = (word *)(void *)pixel;
        words[0] = four;
        words[1] = four;
        words[2] = four;
        words[3] = four;
    }
    for (; end - pixel >= 4; pixel += 4) {
        *(word *)(void *)pixel = four;
    }
    while (pixel != end) {
        *pixel++ = (uint8_t)four;
    }
}

/* The fraction's carry is a pixel. */
static void step(fxl_edge *edge)
{
    uint64_t fraction = (uint64_t)edge->fraction + edge->step_fraction;
    edge->fraction = (uint32_t)fraction;
    edge->x += edge->step + (int32_t)(fraction >> 32);
}

void fxl_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour)
{
    FXL_ASSERT(trapezoid->first_row >= band->first_row &&
               trapezoid->first_row < trapezoid->end_row &&
               trapezoid->end_row <= band->first_row + band->rows);
    const uint32_t four = colour * 0x01010101u;
    uint8_t *row = band->pixels + (size_t)(trapezoid->first_row - band->first_row) * band->stride;
    fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
    for (int32_t rows = trapezoid->end_row - trapezoid->first_row; rows > 0; rows--) {
        if (a.x <= b.x) {
            fill_row(row + a.x, row + b.x, four);
        } else {
            fill_row(row + b.x, row + a.x, four);
        }
        step(&a);
        step(&b);
        row += band->stride;
    }
}
