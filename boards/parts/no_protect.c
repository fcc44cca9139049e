/* SPDX-License-Identifier: MIT */
/* For a core without a memory protection unit. The stack is the lowest memory,
 * so that an overflow leaves the RAM; and it is painted. */
#include "parts/cortexm.h"

bool cortexm_protect(void)
{
    return false;
}
