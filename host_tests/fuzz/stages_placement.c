/* SPDX-License-Identifier: MIT */
/* Orientations of any kind, and instances attached to others. */
#include <string.h>

#include "demand.h"
#include "record.h"
#include "stages.h"

static const fxl_point origin = {0, 0, 0};

static fxl_point any_vector(fuzz_input *in)
{
    const fxl_q16_16 limit = (fxl_q16_16)1 << fuzz_below(in, 31);
    const fxl_point near = fuzz_point(in, limit < FXL_COORDINATE_MAX ? limit : FXL_COORDINATE_MAX);
    fxl_point any;
    any.x = fuzz_any(in);
    any.y = fuzz_any(in);
    any.z = fuzz_any(in);
    return fuzz_below(in, 4) ? near : any;
}

static void demand_made(fxl_status status, const fxl_orientation *o, const fxl_orientation *before)
{
    const fxl_placement placement = {*o, FXL_Q16_16_ONE};
    DEMAND(status == FXL_OK ? fxl_placement_check(&placement, &origin, 0) == FXL_OK
                            : memcmp(o, before, sizeof *o) == 0);
    record_bytes(o, sizeof *o);
}

/* An orientation by one of the functions, or of any numbers. */
static fxl_orientation any_orientation(fuzz_input *in)
{
    const fxl_orientation none = FXL_ORIENTATION_NONE;
    fxl_orientation o = none;
    const fxl_angle yaw = (fxl_angle)fuzz_bits(in, 4), pitch = (fxl_angle)fuzz_bits(in, 4);
    const fxl_point a = any_vector(in), b = any_vector(in);
    switch (fuzz_below(in, 4)) {
    case 0:
        demand_made(fxl_orientation_from_angles(yaw, pitch, (fxl_angle)fuzz_bits(in, 4), &o), &o,
                    &none);
        break;
    case 1:
        demand_made(fxl_orientation_from_axis(&a, yaw, &o), &o, &none);
        break;
    case 2:
        demand_made(fxl_orientation_look_at(&a, &b, &o), &o, &none);
        break;
    default:
        o.x.x += (fxl_q2_30)fuzz_bits(in, 1);
        o.y.z = fuzz_below(in, 2) ? fuzz_any(in) : 0;
        break;
    }
    return o;
}

void fuzz_orientations(fuzz_input *in)
{
    fxl_placement parent, child, placement, before = FXL_PLACEMENT_NONE;
    fxl_point centre = origin;
    parent.orientation = any_orientation(in);
    child.orientation = any_orientation(in);
    parent.scale = fuzz_below(in, 4) ? 1 + (fxl_q16_16)fuzz_bits(in, 2) : fuzz_any(in);
    child.scale = fuzz_below(in, 4) ? 256 + (fxl_q16_16)fuzz_bits(in, 2) : fuzz_any(in);
    placement = before;
    demand_made(
        fxl_orientation_multiply(&parent.orientation, &child.orientation, &placement.orientation),
        &placement.orientation, &before.orientation);
    const fxl_point at = any_vector(in), local = any_vector(in);
    placement = before;
    const fxl_status status =
        fxl_placement_attach(&at, &parent, &local, &child, &centre, &placement);
    record_bytes(&placement, sizeof placement);
    record_bytes(&centre, sizeof centre);
    if (status == FXL_OK) {
        DEMAND(fxl_placement_check(&placement, &centre, 0) == FXL_OK);
    } else {
        DEMAND(memcmp(&placement, &before, sizeof placement) == 0);
        DEMAND(memcmp(&centre, &origin, sizeof centre) == 0);
    }
    DEMAND(fxl_placement_attach(&at, NULL, &local, &child, &centre, &placement) == FXL_E_ARGUMENT);
    DEMAND(fxl_orientation_look_at(&at, &local, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_orientation_multiply(NULL, &child.orientation, &placement.orientation) ==
           FXL_E_ARGUMENT);
}
