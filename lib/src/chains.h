/* SPDX-License-Identifier: MIT */
/* Two chains of an outline, walked down together. A kernel: one for each family
 * of cores (lib/kernels), all with the same bits. Internal to scan. */
#ifndef FXL_CHAINS_H
#define FXL_CHAINS_H

#include "fixel/scan.h"

/* The scan's next trapezoid, from the end of the last to the next end of an
 * edge on either side; null where there are no more rows. Edges are set up
 * where they begin. Requires a scan by chains. */
const fxl_trapezoid *fxl_chains_next(fxl_scan *scan);

#endif
