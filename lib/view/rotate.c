/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#define FXL_HERE
#include "model_view.h"
