/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"

#define FXL_HERE
#include "face_bounds.h"
