/* SPDX-License-Identifier: MIT */
#include "exact_light.h"

#include <math.h>

/* --- the definitions --------------------------------------------------------------------- */

exact_vector exact_point(const fxl_point *point, double unit)
{
    return (exact_vector){point->x * unit, point->y * unit, point->z * unit};
}

exact_vector exact_direction(const fxl_direction *direction)
{
    const double unit = 1.0 / FXL_Q2_30_ONE;
    return (exact_vector){direction->x * unit, direction->y * unit, direction->z * unit};
}

double exact_dot(exact_vector a, exact_vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

exact_vector exact_minus(exact_vector a, exact_vector b)
{
    return (exact_vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static double held(double value)
{
    return value < 0 ? 0 : value > 1 ? 1 : value;
}

/* place light: definition: light; a new setting too */
/* The brightness of a face, by its middle and normal. */
double exact_brightness(const fxl_light_settings *of, const fxl_camera *camera, exact_vector middle,
                        exact_vector normal)
{
    double sum = of->ambient / (double)FXL_Q2_30_ONE;
    sum += of->strength / (double)FXL_Q2_30_ONE *
           held(-exact_dot(normal, exact_direction(&of->direction)));
    for (uint32_t i = 0; i < of->point_count; i++) {
        const fxl_point_light *point = &of->points[i];
        const exact_vector to = exact_minus(exact_point(&point->position, 1.0 / 65536), middle);
        const double square = exact_dot(to, to), range = point->range / 65536.0;
        if (square > 0 && square < range * range && exact_dot(normal, to) > 0) {
            sum += point->strength / (double)FXL_Q2_30_ONE *
                   (exact_dot(normal, to) / sqrt(square)) * (1 - square / (range * range));
        }
    }
    sum = sum > 1 ? 1 : sum;
    if (of->fog_far != 0) {
        const exact_vector from = exact_minus(middle, exact_point(&camera->position, 1.0 / 65536));
        const double depth = exact_dot(from, exact_direction(&camera->axes.forward));
        const double near_z = of->fog_near / 65536.0, far_z = of->fog_far / 65536.0;
        sum *= held((far_z - depth) / (far_z - near_z));
    }
    return sum;
}

/* --- random settings ------------------------------------------------------------------------ */

static fxl_q2_30 any_fraction(void)
{
    const int32_t kind = unit_between(0, 5);
    return kind == 0 ? 0 : kind == 1 ? FXL_Q2_30_ONE : unit_between(0, FXL_Q2_30_ONE);
}

fxl_light_settings exact_light_any(const uint8_t *ramp, const fxl_point *about)
{
    fxl_light_settings made;
    memset(&made, 0, sizeof made);
    made.ambient = any_fraction() / 8;
    made.strength = unit_between(0, 1) ? any_fraction() : 0;
    made.direction = unit_direction();
    made.point_count = (uint32_t)unit_between(0, FXL_LIGHT_POINTS_MAX);
    for (uint32_t i = 0; i < made.point_count; i++) {
        fxl_point_light *point = &made.points[i];
        const int32_t far_off = unit_between(1, 1 << unit_between(1, 26));
        point->position = (fxl_point){about->x + unit_between(-far_off, far_off),
                                      about->y + unit_between(-far_off, far_off),
                                      about->z + unit_between(-far_off, far_off)};
        point->range = unit_between(1, 3) == 1 ? far_off : unit_between(1, FXL_COORDINATE_MAX);
        point->strength = any_fraction();
    }
    if (unit_between(0, 1)) {
        made.fog_near = unit_between(0, Q16(200));
        made.fog_far = made.fog_near + unit_between(1, 1 << unit_between(1, 26));
    }
    made.ramp = ramp;
    made.levels = (uint32_t)unit_between(FXL_LIGHT_LEVELS_MIN, FXL_LIGHT_LEVELS_MAX);
    return made;
}
