/* SPDX-License-Identifier: MIT */
/* The interface of scan and its kernel, fxl_scan_next_trapezoid. Internal. */
#ifndef FXL_CHAINS_H
#define FXL_CHAINS_H

#include "fixel/stage/scan.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Returns the next span of a scan by active edges, as a trapezoid of one row; null if there are no
 * more. The kernel calls it if a scan has no more rows by chains and is not by chains. */
const fxl_trapezoid *fxl_scan_next_of_active_edges(fxl_scan *scan);

#ifdef __cplusplus
}
#endif

#endif
