/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "placement_code.h"

/* In units of 2^-60: 1; 2^-28; and a component of z. */
#define ONE           ((uint64_t)1 << 60)
#define TOLERANCE     ((uint64_t)1 << 32)
#define COMPONENT_ONE (-FXL_Q2_30_ONE)

static inline uint64_t product(int32_t a, int32_t b)
{
    return fxl_bits_64(fxl_multiply_s32(a, b));
}

/* The upper word of start + a . b. With start = limit - expected it is below limit / 2^31 if and
 * only if -limit <= a . b - expected < limit. */
static inline uint32_t upper_sum(uint64_t start, const fxl_direction *a, int32_t x, int32_t y,
                                 int32_t z)
{
    return (uint32_t)((start + product(a->x, x) + product(a->y, y) + product(a->z, z)) >> 32);
}

/* The upper word of start + (a d - b c) - z. */
static inline uint32_t upper_minor(uint64_t start, int32_t a, int32_t d, int32_t b, int32_t minus_c,
                                   int32_t z)
{
    return (uint32_t)((start + product(a, d) + product(b, minus_c) + product(z, COMPONENT_ONE)) >>
                      32);
}

/* Whether the rows are those of a rotation: x and y are of unit length and at right angles, to
 * within 2^-28, and z is x cross y, to within 2^-26 a component. Rows of which all six products are
 * within 2^-28 pass: z is then a combination of x, y and their product with coefficients within
 * 2^-28 and 1.5 2^-28 of those of the product, so a component is off by less than 2.1 2^-28.
 *
 * A sum of three squares is below 3 2^62, so it does not wrap. If both squared lengths pass, all
 * components of x and y are below 2^30 + 2^2 and no other sum wraps. */
/* SPEC 8.1 */
bool fxl_is_rotation(const fxl_orientation *rows)
{
    const fxl_direction x = rows->x, y = rows->y;
    uint32_t narrow = upper_sum(TOLERANCE - ONE, &x, x.x, x.y, x.z);
    narrow |= upper_sum(TOLERANCE - ONE, &y, y.x, y.y, y.z);
    narrow |= upper_sum(TOLERANCE, &x, y.x, y.y, y.z);
    if (narrow > 1) { /* also keeps the negations below in range */
        return false;
    }
    const uint32_t wide = upper_minor(4 * TOLERANCE, x.y, y.z, x.z, -y.y, rows->z.x) |
                          upper_minor(4 * TOLERANCE, x.z, y.x, x.x, -y.z, rows->z.y) |
                          upper_minor(4 * TOLERANCE, x.x, y.y, x.y, -y.x, rows->z.z);
    return wide < 8;
}

/* SPEC 8.1 */
fxl_q16_16 fxl_placement_radius(const fxl_placement *placement, fxl_q16_16 radius)
{
    return fxl_scaled_radius(placement->scale, radius);
}

/* Whether a scale and a radius are in range, and the sphere lies in the world. */
/* SPEC 8.1 */
static inline bool is_in_range(fxl_q16_16 scale, const fxl_point *centre, fxl_q16_16 radius)
{
    if (fxl_bits_32(scale) - FXL_SCALE_MIN > FXL_SCALE_MAX - FXL_SCALE_MIN ||
        fxl_bits_32(radius) > FXL_RADIUS_MAX) {
        return false;
    }
    const uint64_t scaled = fxl_multiply_u32((uint32_t)scale, (uint32_t)radius);
    /* fxl_placement_radius, of which the lower words are those of a number below 2^39. */
    const uint32_t limit =
        (uint32_t)(FXL_COORDINATE_MAX - FXL_PLACEMENT_SLACK) - fxl_low_32((scaled + 0xFFFF) >> 16);
    return scaled >> 32 < 1u << 14 && limit <= FXL_COORDINATE_MAX &&
           fxl_bits_32(centre->x) + limit <= 2 * limit &&
           fxl_bits_32(centre->y) + limit <= 2 * limit &&
           fxl_bits_32(centre->z) + limit <= 2 * limit;
}

/* is_in_range, first for instances as most scenes have them: a scale of at most 8 of a radius below
 * 256 is below 2048, and with a centre within 4096 the sphere lies within 6144 and the slack. By masks,
 * which the compiler drops: fxl_bits_32 makes longer code here. */
static inline bool is_surely_in_range(fxl_q16_16 scale, const fxl_point *centre, fxl_q16_16 radius)
{
    const int64_t mask = UINT32_MAX;
    const uint32_t near_by = (uint32_t)FXL_UNITS(4096);
    return (uint32_t)(scale & mask) - FXL_SCALE_MIN <= (uint32_t)(FXL_UNITS(8) - FXL_SCALE_MIN) &&
           (uint32_t)(radius & mask) < (uint32_t)FXL_UNITS(256) &&
           (((uint32_t)(centre->x & mask) + near_by) | ((uint32_t)(centre->y & mask) + near_by) |
            ((uint32_t)(centre->z & mask) + near_by)) < 2 * near_by;
}

static inline fxl_status check(const fxl_placement *placement, const fxl_point *centre,
                               fxl_q16_16 radius)
{
    if (!is_in_range(placement->scale, centre, radius)) {
        return FXL_E_RANGE;
    }
    return fxl_is_rotation(&placement->orientation) ? FXL_OK : FXL_E_PLACEMENT;
}

FXL_COLD fxl_status fxl_placement_check(const fxl_placement *placement, const fxl_point *centre,
                                        fxl_q16_16 radius)
{
    return placement == NULL || centre == NULL ? FXL_E_ARGUMENT : check(placement, centre, radius);
}

bool fxl_placement_places_are_in_range(const fxl_scene *scene)
{
    const fxl_placement *placement = scene->placements;
    const fxl_instance *instance = &scene->instances[scene->first_turned];
    const fxl_instance *const end = &scene->instances[scene->instance_count];
    for (; instance < end; instance++, placement++) {
        const fxl_q16_16 radius = scene->models[instance->model].radius;
        if ((FXL_IS_COMPACT ||
             !is_surely_in_range(placement->scale, &instance->centre, radius)) &&
            !is_in_range(placement->scale, &instance->centre, radius)) {
            return false;
        }
    }
    return true;
}

/* formats 1.9 */
FXL_COLD fxl_status fxl_placement_check_all(const fxl_scene *scene, uint32_t *number)
{
    const fxl_placement *placement = scene->placements;
    for (uint32_t i = scene->first_turned; i < scene->instance_count; i++, placement++) {
        const fxl_instance *instance = &scene->instances[i];
        const fxl_status status =
            check(placement, &instance->centre, scene->models[instance->model].radius);
        if (status != FXL_OK) {
            *number = i;
            return status;
        }
    }
    return FXL_OK;
}
