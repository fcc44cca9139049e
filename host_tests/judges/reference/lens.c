/* SPDX-License-Identifier: MIT */
#include "reference/lens.h"

#include <math.h>

#include "reference/angle.h"

/* accuracy 4.1 */
ref_lens ref_lens_from_fov(int width, int height, ref_angle fov, double near_z, double far_z,
                           double inset)
{
    double focal = width / 2.0 / tan(ref_radians(fov) / 2);
    return (ref_lens){.width = width,
                      .height = height,
                      .focal = floor(focal * REF_ONE + 0.5) / REF_ONE,
                      .near_z = near_z,
                      .far_z = far_z,
                      .inset = inset,
                      .centre_x = width / 2.0,
                      .centre_y = height / 2.0};
}
