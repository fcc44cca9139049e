/* SPDX-License-Identifier: MIT */
/* How a setup divides its memory. Internal. */
#ifndef FXL_SETUP_SHARES_H
#define FXL_SETUP_SHARES_H

#include "fixel/setup.h"

/* Bytes of each share, in the order of the block: multiples of 8. The renderer's comes last, and
 * takes what is left, at least `renderer`, 0 with tables of the program's own. */
typedef struct {
    uint32_t instances, motions; /* the copies; the first of the two is a part of the second */
    uint32_t beams, tree, lines, depth;
    uint32_t before_renderer; /* the sum of these */
    uint32_t renderer;
} fxl_setup_shares;

/* Looks at the arguments of fxl_setup_init but for the memory's size, and writes the shares.
 * The statuses of fxl_setup_init, without FXL_E_CAPACITY: *shares untouched. */
fxl_status fxl_setup_divide(const fxl_setup *setup, const fxl_setup_plan *plan, uint16_t rows,
                            const void *memory, fxl_setup_shares *shares);

#endif
