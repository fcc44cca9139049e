/* SPDX-License-Identifier: MIT */
#define FXL_HERE
#include "arith.h"
