/* SPDX-License-Identifier: MIT */
/* The depth test of a run of pixels, in a depth buffer of 16 bits front to back. Kernels: each
 * family of cores has its own. Internal. */
#ifndef FXL_DEPTH_CELLS_H
#define FXL_DEPTH_CELLS_H

#include <stdint.h>

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The code of pixel i is code + i step, where -2^31 <= step < 2^31, and no sum wraps. A pixel is
 * visible if its code / 2^16, rounded down, is above its cell.
 *
 * Returns how many pixels from the first on, of count, are visible, and keeps their codes / 2^16 in
 * the cells. */
uint32_t fxl_depth_keep_visible(uint16_t *cells, uint32_t count, uint32_t code, uint32_t step);

/* Returns how many pixels from the first on, of count, are not visible. */
uint32_t fxl_depth_skip_hidden(const uint16_t *cells, uint32_t count, uint32_t code, uint32_t step);

/* How cells are compared; constant where the functions below are called. */
typedef struct {
    bool wide;     /* cells of 32 bits */
    bool or_equal; /* what is as near as the cell is visible too: far to near */
} fxl_depth_rule;

/* A stretch of a row whose codes are linear. */
typedef struct {
    uint32_t code; /* of the first pixel; with 16 bits after the point */
    uint32_t step; /* a pixel */
} fxl_depth_line;

/* Whether a pixel of this code is visible. */
/* SPEC 10.4 */
static inline bool fxl_depth_passes(const void *cells, int32_t x, uint32_t code,
                                    fxl_depth_rule rule)
{
    const uint32_t cell = rule.wide ? ((const uint32_t *)cells)[x] : ((const uint16_t *)cells)[x];
    const uint32_t nearness = rule.wide ? code : code >> 16;
    return rule.or_equal ? nearness >= cell : nearness > cell;
}

/* SPEC 10.4 */
static inline void fxl_depth_keep(void *cells, int32_t x, uint32_t code, bool wide)
{
    if (wide) {
        ((uint32_t *)cells)[x] = code;
    } else {
        ((uint16_t *)cells)[x] = (uint16_t)(code >> 16);
    }
}

/* The first column, from x on and below end, whose pixel is hidden; end if there is none. The
 * pixels before it are visible, and kept where `keeps`. *line goes along. */
static inline int32_t fxl_depth_visible_end(void *cells, int32_t x, int32_t end,
                                            fxl_depth_line *line, bool keeps, fxl_depth_rule rule)
{
    if (keeps && !rule.wide && !rule.or_equal) {
        const uint32_t count = fxl_depth_keep_visible((uint16_t *)cells + x, (uint32_t)(end - x),
                                                      line->code, line->step);
        line->code += count * line->step;
        return x + (int32_t)count;
    }
    for (; x < end && fxl_depth_passes(cells, x, line->code, rule); x++) {
        if (keeps) {
            fxl_depth_keep(cells, x, line->code, rule.wide);
        }
        line->code += line->step;
    }
    return x;
}

/* The first column, from x on and below end, whose pixel is visible; end if there is none. */
static inline int32_t fxl_depth_hidden_end(const void *cells, int32_t x, int32_t end,
                                           fxl_depth_line *line, fxl_depth_rule rule)
{
    if (!rule.wide && !rule.or_equal) {
        const uint32_t count = fxl_depth_skip_hidden((const uint16_t *)cells + x,
                                                     (uint32_t)(end - x), line->code, line->step);
        line->code += count * line->step;
        return x + (int32_t)count;
    }
    for (; x < end && !fxl_depth_passes(cells, x, line->code, rule); x++) {
        line->code += line->step;
    }
    return x;
}

#ifdef __cplusplus
}
#endif

#endif
