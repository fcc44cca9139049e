/* SPDX-License-Identifier: MIT */
#include "reference/angle.h"

#include <math.h>

static const double two_pi = 6.283185307179586476925286766559;

double ref_radians(ref_angle angle)
{
    return (double)angle / 4294967296.0 * two_pi;
}

/* The angle is reduced, in integers, to at most an eighth of a turn from a multiple of a quarter
 * turn, because libm's sine of a rounded pi is not 0, and a camera that looks along an axis must
 * do so exactly. */
double ref_sin(ref_angle angle)
{
    uint32_t quarters = (angle + 0x20000000u) >> 30;
    int64_t rest = (int64_t)angle - ((int64_t)quarters << 30);
    if (rest > INT64_C(0x20000000)) { /* the last eighth belongs to the next turn */
        rest -= INT64_C(0x100000000);
    }
    double radians = (double)rest / 4294967296.0 * two_pi;
    switch (quarters) {
    case 0:
        return sin(radians);
    case 1:
        return cos(radians);
    case 2:
        return -sin(radians);
    default:
        return -cos(radians);
    }
}

double ref_cos(ref_angle angle)
{
    return ref_sin(angle + 0x40000000u);
}
