/* SPDX-License-Identifier: MIT */
#include "exact_turn.h"

#include <math.h>

void exact_entries(const fxl_orientation *o, fxl_q2_30 out[3][3])
{
    memcpy(out, o, sizeof *o);
}

long double exact_distance(const exact_turn *wanted, const fxl_orientation *actual)
{
    fxl_q2_30 found[3][3];
    long double most = 0;
    exact_entries(actual, found);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            most = fmaxl(most, fabsl(wanted->at[i][j] * EXACT_ONE - found[i][j]));
        }
    }
    return most;
}

exact_turn exact_angles(fxl_angle yaw, fxl_angle pitch, fxl_angle roll)
{
    const long double turn = EXACT_PI / 2147483648.0L;
    const long double sy = sinl(yaw * turn), cy = cosl(yaw * turn);
    const long double sp = sinl(pitch * turn), cp = cosl(pitch * turn);
    const long double sr = sinl(roll * turn), cr = cosl(roll * turn);
    return (exact_turn){{{cr * cy - sr * sp * sy, -sr * cy - cr * sp * sy, cp * sy},
                         {sr * cp, cr * cp, sp},
                         {-cr * sy - sr * sp * cy, sr * sy - cr * sp * cy, cp * cy}}};
}

exact_turn exact_axis(fxl_point axis, fxl_angle angle)
{
    const long double length = sqrtl((long double)axis.x * axis.x + (long double)axis.y * axis.y +
                                     (long double)axis.z * axis.z);
    const long double a[3] = {axis.x / length, axis.y / length, axis.z / length};
    const long double s = sinl(angle * EXACT_PI / 2147483648.0L),
                      c = cosl(angle * EXACT_PI / 2147483648.0L);
    exact_turn result;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        result.at[i][i] = c + (1 - c) * a[i] * a[i];
        result.at[i][j] = (1 - c) * a[i] * a[j] - s * a[k];
        result.at[j][i] = (1 - c) * a[i] * a[j] + s * a[k];
    }
    return result;
}

exact_turn exact_product(const exact_turn *a, const exact_turn *b)
{
    exact_turn product;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            product.at[i][j] =
                a->at[i][0] * b->at[0][j] + a->at[i][1] * b->at[1][j] + a->at[i][2] * b->at[2][j];
        }
    }
    return product;
}
