/* SPDX-License-Identifier: MIT */
#include "../scene/placement_code.h"
#include "exact.h"

/* The hit that is nearest so far. */
typedef struct {
    uint64_t part; /* of the segment, in units of 2^-64, rounded downward; 1 is UINT64_MAX */
    uint16_t instance, face;
} nearest_hit;

/* Where the segment passes the plane of a face that its start is in front of, in units of 2^-64.
 * The heights are below 2^61. Only an end on the plane has a fraction of 1. */
static uint64_t part_of(fxl_q18_46 start, fxl_q18_46 end)
{
    return end == 0 ? UINT64_MAX : fxl_fraction((uint64_t)start, (uint64_t)(start - end));
}

/* collide 2.1, 2.2 */
static void try_instance(const fxl_scene *scene, uint16_t number, const fxl_point *from,
                         const fxl_point *to, nearest_hit *nearest)
{
    const fxl_instance *instance = &scene->instances[number];
    const fxl_model *model = &scene->models[instance->model];
    fxl_point direction;
    fxl_subtract(to, from, &direction);
    for (uint32_t i = 0; i < model->face_count; i++) {
        fxl_face_place face;
        fxl_place_face(&face, scene, instance, i);
        const fxl_q18_46 start = fxl_height_over(&face, from);
        if (start <= 0) {
            continue;
        }
        const fxl_q18_46 end = fxl_height_over(&face, to);
        if (end > 0) {
            continue;
        }
        const uint64_t part = part_of(start, end);
        if ((nearest->instance == FXL_HIT_NONE || part < nearest->part) &&
            fxl_line_is_within(&face, from, &direction)) {
            nearest->part = part;
            nearest->instance = number;
            nearest->face = (uint16_t)i;
        }
    }
}

/* from + fraction (to - from): the difference is below 2^30 and the fraction at most 2^31. Error:
 * half a unit, and half of 2^-31 of the difference. */
static fxl_q16_16 between(fxl_q16_16 from, fxl_q16_16 to, fxl_q1_31 fraction)
{
    return from + (fxl_q16_16)fxl_round_shift(fxl_multiply_su32(to - from, fraction), 31);
}

/* collide 2.3 */
fxl_status fxl_cast_segment(const fxl_scene *scene, const fxl_point *start, const fxl_point *end,
                            fxl_hit *hit)
{
    if (scene == NULL || start == NULL || end == NULL || hit == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (scene->draw_list_needed == 0) {
        return FXL_E_ORDER;
    }
    if (!fxl_point_in_range(start) || !fxl_point_in_range(end)) {
        return FXL_E_RANGE;
    }
    const fxl_status turned = fxl_check_placements(scene);
    if (turned != FXL_OK) {
        return turned;
    }
    nearest_hit nearest = {UINT64_MAX, FXL_HIT_NONE, 0};
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        if (fxl_segment_nears_instance(scene, &scene->instances[i], start, end, 0)) {
            try_instance(scene, (uint16_t)i, start, end, &nearest);
        }
    }
    /* Rounded to 31 bits after the point; 1 is 2^31. */
    const fxl_q1_31 fraction = (fxl_q1_31)(((nearest.part >> 32) + 1) >> 1);
    hit->point.x = between(start->x, end->x, fraction);
    hit->point.y = between(start->y, end->y, fraction);
    hit->point.z = between(start->z, end->z, fraction);
    hit->fraction = fraction;
    hit->instance = nearest.instance;
    hit->face = nearest.face;
    return FXL_OK;
}
