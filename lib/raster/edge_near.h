/* SPDX-License-Identifier: MIT */
/* An edge on its first row: the kernel of this core's family. */
#include "../math/family.h"
#if FXL_KERNELS_ARMV6M
#include "edge_near_armv6m.h"
#else
#include "edge_near_portable.h"
#endif
