/* SPDX-License-Identifier: MIT */
/* The upper half of a product of 64 by 64 bits: the inline kernel, the same for every family. */
#include "multiply_high_portable.h"
