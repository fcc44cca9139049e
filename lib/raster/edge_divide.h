/* SPDX-License-Identifier: MIT */
/* The division of an edge's set-up: the inline kernel of this core's family. */
#include "../math/family.h"
#if FXL_CORE_ARMV6M
#include "edge_divide_armv6m.h"
#elif FXL_CORE_ARMV7M
#include "edge_divide_armv7m.h"
#else
#include "edge_divide_portable.h"
#endif
