/* SPDX-License-Identifier: MIT */
/* Estimates of sums of products: the inline kernel of this core's family. */
#include "family.h"
#if FXL_KERNELS_ARMV6M
#include "armv6m/estimate.h"
#else
#include "portable/estimate.h"
#endif
