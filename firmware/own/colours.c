/* SPDX-License-Identifier: MIT */
#include "own.h"

#define GREY(level)   (level), (level), (level)
#define GREYS4(first) GREY(first), GREY((first) + 1), GREY((first) + 2), GREY((first) + 3)
#define GREYS16(first) GREYS4(first), GREYS4((first) + 4), GREYS4((first) + 8), GREYS4((first) + 12)
#define GREYS64(first) GREYS16(first), GREYS16((first) + 16), GREYS16((first) + 32), GREYS16((first) + 48)

const uint8_t own_colours[768] = {GREYS64(0), GREYS64(64), GREYS64(128), GREYS64(192)};
