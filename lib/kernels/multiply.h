/* SPDX-License-Identifier: MIT */
/* Products of 32 by 32 bits: the inline kernel of this core's family. */
#include "family.h"
#if FXL_CORE_ARMV6M
#include "armv6m/multiply.h"
#else
#include "portable/multiply.h"
#endif
