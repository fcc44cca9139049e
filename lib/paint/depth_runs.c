/* SPDX-License-Identifier: MIT */
#include "../math/family.h"
#include "depth_cells.h"

#if !FXL_KERNELS_ARMV7M

/* Four pixels a turn save the test of the end at three of them. */
#define AT_ONCE (FXL_IS_COMPACT ? 1u : 4u)

/* Keeps the code of a visible pixel. */
/* SPEC 10.4 */
static inline int keeps(uint16_t *cell, uint32_t code)
{
    if (code >> 16 <= *cell) {
        return 0;
    }
    *cell = (uint16_t)(code >> 16);
    return 1;
}

uint32_t fxl_depth_keep_visible(uint16_t *cells, uint32_t count, uint32_t code, uint32_t step)
{
    uint32_t i = 0;
    if (AT_ONCE == 4) {
        for (; count - i >= 4; i += 4) {
            if (!keeps(cells + i, code)) {
                return i;
            }
            if (!keeps(cells + i + 1, code + step)) {
                return i + 1;
            }
            if (!keeps(cells + i + 2, code + 2 * step)) {
                return i + 2;
            }
            if (!keeps(cells + i + 3, code + 3 * step)) {
                return i + 3;
            }
            code += 4 * step;
        }
    }
    for (; i < count && keeps(cells + i, code); i++) {
        code += step;
    }
    return i;
}

uint32_t fxl_depth_skip_hidden(const uint16_t *cells, uint32_t count, uint32_t code, uint32_t step)
{
    uint32_t i = 0;
    if (AT_ONCE == 4) {
        for (; count - i >= 4; i += 4) {
            if (code >> 16 > cells[i]) {
                return i;
            }
            if ((code + step) >> 16 > cells[i + 1]) {
                return i + 1;
            }
            if ((code + 2 * step) >> 16 > cells[i + 2]) {
                return i + 2;
            }
            if ((code + 3 * step) >> 16 > cells[i + 3]) {
                return i + 3;
            }
            code += 4 * step;
        }
    }
    for (; i < count && code >> 16 <= cells[i]; i++) {
        code += step;
    }
    return i;
}

#endif
