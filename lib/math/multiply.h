/* SPDX-License-Identifier: MIT */
/* Products of 32 by 32 bits: the inline kernel of this core's family. */
#include "family.h"
#if FXL_CORE_ARMV6M
#include "multiply_armv6m.h"
#else
#include "multiply_portable.h"
#endif
