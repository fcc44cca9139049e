/* SPDX-License-Identifier: MIT */
/* The count of leading zeros: the inline kernel of this core's family. */
#include "family.h"
#if FXL_CORE_ARMV6M
#include "leading_zeros_armv6m.h"
#else
#include "leading_zeros_portable.h"
#endif
