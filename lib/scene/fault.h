/* SPDX-License-Identifier: MIT */
/* How the checks of a scene say what is wrong. Internal. */
#ifndef FXL_FAULT_H
#define FXL_FAULT_H

#include "fixel/scene.h"

/* The status, and where it is not FXL_OK what of the scene is at fault; fault may be null. */
static inline fxl_status fxl_fault_at(fxl_scene_fault *fault, const char *what, uint32_t index,
                                      fxl_status status)
{
    if (fault != NULL) {
        fault->what = what;
        fault->index = index;
    }
    return status;
}

#endif
