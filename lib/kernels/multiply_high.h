/* SPDX-License-Identifier: MIT */
/* The inline kernel, the same for every family. */
#include "portable/multiply_high.h"
