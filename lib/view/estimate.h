/* SPDX-License-Identifier: MIT */
/* Estimates of sums of products: the inline kernel of this core's family. */
#include "../math/family.h"
#if FXL_KERNELS_ARMV6M
#include "estimate_armv6m.h"
#else
#include "estimate_portable.h"
#endif
