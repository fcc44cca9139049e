/* SPDX-License-Identifier: MIT */
/* Orthographic lenses of unit tests. */
#ifndef ORTHOGRAPHIC_UNIT_H
#define ORTHOGRAPHIC_UNIT_H

#include "unit.h"

/* A lens whose centre is the middle of the screen. */
static inline fxl_lens orthographic_any_lens(void)
{
    const fxl_q16_16 near_z = unit_between(FXL_NEAR_MIN, Q16(100));
    const unsigned bits = (unsigned)unit_between(12, 27);
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_orthographic((uint16_t)unit_between(1, 1024),
                                                    (uint16_t)unit_between(1, 1024),
                                                    unit_between(1 << bits, 2 << bits), near_z,
                                                    unit_between(near_z + 1, Q16(30000)), &lens));
    return lens;
}

#endif
