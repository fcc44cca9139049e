/* SPDX-License-Identifier: MIT */
#include "turn_check.h"

#include "../math/arith.h"
#include "../math/is_rotation.h"
#include "fault.h"

/* Whether |coordinate| + scale * radius is within the world, for each coordinate. The product is
 * below 2^24 * 2^31 in units of 2^-32. Exact. */
static bool sphere_in_world(const fxl_point *centre, fxl_q16_16 scale, fxl_q16_16 radius)
{
    const int64_t room = (int64_t)FXL_COORDINATE_MAX * 65536 - fxl_multiply_s32(scale, radius);
    return fxl_within((int64_t)centre->x * 65536, room) &&
           fxl_within((int64_t)centre->y * 65536, room) &&
           fxl_within((int64_t)centre->z * 65536, room); /* bug: turn-reach */
}

fxl_status fxl_turn_check(const fxl_scene *scene, fxl_scene_fault *fault)
{
    if (scene->turns == NULL) {
        return FXL_OK;
    }
    if (scene->first_turned >= scene->instance_count) {
        return fxl_fault_at(fault, "turn table", 0, FXL_E_COUNT);
    }
    if (scene->bsp_nodes != NULL && scene->bsp_instance >= scene->first_turned) {
        return fxl_fault_at(fault, "instance", scene->bsp_instance, FXL_E_BSP);
    }
    for (uint32_t i = scene->first_turned; i < scene->instance_count; i++) {
        const fxl_instance *instance = &scene->instances[i];
        const fxl_turn *turn = &scene->turns[i - scene->first_turned];
        if (!fxl_is_rotation(&turn->orientation)) {
            return fxl_fault_at(fault, "turn", i - scene->first_turned, FXL_E_RANGE);
        }
        if (!fxl_is_scale(turn->scale)) {
            return fxl_fault_at(fault, "turn", i - scene->first_turned, FXL_E_RANGE);
        }
        if (!sphere_in_world(&instance->centre, turn->scale,
                             scene->models[instance->model].radius)) {
            return fxl_fault_at(fault, "instance", i, FXL_E_RANGE);
        }
    }
    return FXL_OK;
}
