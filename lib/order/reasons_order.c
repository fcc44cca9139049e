/* SPDX-License-Identifier: MIT */
/* What the functions of these headers refuse. */
#include "fixel/wire.h"
#include "../scene/reasons.h"

const char fxl_wire_reasons[] =
    ON_ARGUMENT "wire, scene, lens, clipper, pose, band, renderer and outlines must not be "
    "null\0"
    ON_RANGE "lens must be one that a function of camera.h made, pose->position within "
    "FXL_UNITS(-8191)..FXL_UNITS(8191), scales 1/256..256, and band within the "
    "screen\0"
    ON_ORDER "fxl_wire_init must come before fxl_wire_begin, that before fxl_wire_draw, "
    "fxl_renderer_init before fxl_attach_outlines; placements need a "
    "placement_code\0"
    ON_ALIGNMENT "outlines must be aligned to 8 bytes, pixels of RGB565 to 2\0"
    ON_PLACEMENT "the rows of each placement's orientation must be those of a rotation, to "
    "within 2^-28\0";
