/* SPDX-License-Identifier: MIT */
/* What fxl_attach_outlines calls of outlines with a depth buffer. Internal. */
#ifndef FXL_OUTLINES_H
#define FXL_OUTLINES_H

#include "fixel/wire.h"

struct fxl_outline_code {
    /* Has outlines draw over a target with a depth buffer. Their style is set. */
    void (*attach)(fxl_outlines *outlines);
};

#endif
