/* SPDX-License-Identifier: MIT */
/* The span buffer, and scanning by bounding box. */
#ifndef FXL_EXTRA_SPANS_H
#define FXL_EXTRA_SPANS_H

#include "fixel/study/scan_box.h"
#include "fixel/study/span_buffer.h"

#endif
