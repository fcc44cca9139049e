/* SPDX-License-Identifier: MIT */
/* Divisions of 32 bits: the inline kernel of this core's family. */
#include "family.h"
#if FXL_CORE_ARMV6M
#include "divide_armv6m.h"
#else
#include "divide_portable.h"
#endif
