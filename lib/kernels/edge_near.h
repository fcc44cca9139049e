/* SPDX-License-Identifier: MIT */
/* An edge on its first row: the kernel of this core's family. */
#include "family.h"
#if FXL_KERNELS_ARMV6M
#include "armv6m/edge_near.h"
#else
#include "portable/edge_near.h"
#endif
