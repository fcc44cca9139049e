/* SPDX-License-Identifier: MIT */
/* The division of an edge's set-up: the inline kernel of this core's family. */
#include "family.h"
#if FXL_CORE_ARMV6M
#include "armv6m/edge_divide.h"
#elif FXL_CORE_ARMV7M
#include "armv7m/edge_divide.h"
#else
#include "portable/edge_divide.h"
#endif
