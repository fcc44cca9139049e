/* SPDX-License-Identifier: MIT */
/* The count of leading zeros: the inline kernel of this core's family. */
#include "family.h"
#if FXL_CORE_ARMV6M
#include "armv6m/leading_zeros.h"
#else
#include "portable/leading_zeros.h"
#endif
