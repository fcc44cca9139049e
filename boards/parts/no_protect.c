/* SPDX-License-Identifier: MIT */
/* For a core without a memory protection unit. The stack is the lowest memory, so an overflow
 * leaves the RAM. The stack is painted, too. */
#include "parts/cortexm.h"

bool cortexm_protect(void)
{
    return false;
}
