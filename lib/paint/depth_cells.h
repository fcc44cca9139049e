/* SPDX-License-Identifier: MIT */
/* The depth test of a pixel and of a run of pixels, by cells of 16 or 32 bits, near to far or far to
 * near. Runs by cells of 16 bits near to far have kernels: each family of cores has its own.
 * Internal. */
#ifndef FXL_DEPTH_CELLS_H
#define FXL_DEPTH_CELLS_H

#include <stdint.h>

#include "fixel/types.h"

#include "../math/family.h"

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

static inline void fxl_depth_go_on(fxl_depth_line *line, int32_t *x, uint32_t count)
{
    line->code += count * line->step;
    *x += (int32_t)count;
}

/* Whether the pixels of four columns from x on are visible. */
static inline bool fxl_depth_four_pass(const void *cells, int32_t x, const fxl_depth_line *line,
                                       fxl_depth_rule rule)
{
    const uint32_t code = line->code, step = line->step;
    return fxl_depth_passes(cells, x, code, rule) &&
           fxl_depth_passes(cells, x + 1, code + step, rule) &&
           fxl_depth_passes(cells, x + 2, code + 2 * step, rule) &&
           fxl_depth_passes(cells, x + 3, code + 3 * step, rule);
}

/* The first column, from x on and below end, whose pixel is hidden; end if there is none. The
 * pixels before it are visible, and kept where `keeps`. *line goes along. A pixel that is nearer
 * than its cell is visible by either rule. */
static inline int32_t fxl_depth_visible_end(void *cells, int32_t x, int32_t end,
                                            fxl_depth_line *line, bool keeps, fxl_depth_rule rule)
{
    if (keeps && !rule.wide) {
        fxl_depth_go_on(line, &x,
                        fxl_depth_keep_visible((uint16_t *)cells + x, (uint32_t)(end - x),
                                               line->code, line->step));
        if (!rule.or_equal) {
            return x;
        }
    }
    while (!FXL_IS_COMPACT && !keeps && end - x >= 4 && fxl_depth_four_pass(cells, x, line, rule)) {
        fxl_depth_go_on(line, &x, 4);
    }
    for (; x < end && fxl_depth_passes(cells, x, line->code, rule); x++) {
        if (keeps) {
            fxl_depth_keep(cells, x, line->code, rule.wide);
        }
        line->code += line->step;
    }
    return x;
}

/* Whether the codes of so many pixels, from 1 on, are below the largest code; their sums do not come
 * round, so those between both ends are if these are. */
static inline bool fxl_depth_codes_have_next(const fxl_depth_line *line, uint32_t count)
{
    const uint32_t last = line->code + (count - 1u) * line->step;
    return (line->code > last ? line->code : last) < 0xFFFF0000u;
}

/* The first column, from x on and below end, whose pixel is visible; end if there is none. A pixel
 * is as near as its cell, or nearer, if the next code is nearer than its cell. */
static inline int32_t fxl_depth_hidden_end(const void *cells, int32_t x, int32_t end,
                                           fxl_depth_line *line, fxl_depth_rule rule)
{
    const uint32_t count = (uint32_t)(end - x);
    if (!rule.wide && (!rule.or_equal || (count != 0 && fxl_depth_codes_have_next(line, count)))) {
        fxl_depth_go_on(line, &x,
                        fxl_depth_skip_hidden((const uint16_t *)cells + x, count,
                                              line->code + (rule.or_equal ? 65536u : 0),
                                              line->step));
        return x;
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
