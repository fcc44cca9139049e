/* SPDX-License-Identifier: MIT */
/* In the place of lib/src/chains.h. */
#ifndef FXL_CHAINS_H
#define FXL_CHAINS_H

#include "fixel/scan.h"

#define FXL_SCAN_HAS_CHAINS 0

const fxl_trapezoid *fxl_scan_next_of_crossings(fxl_scan *scan);

#endif
