/* SPDX-License-Identifier: MIT */
/* Checks of what a scene image has beside its scene: motions, and the settings of a light. */
#include "../math/arith.h"
#include "../math/memory.h"
#include "../math/plane.h"
#include "scene_check.h"
#include "placement_code.h"

/* --- motions (docs/extras/motion.md, section 4) ------------------------------------------------ */

/* A motion states the extent of its keys, so that the reach of a chain of parents takes a step a
 * parent, and no key. */

/* motion 4.3 */
static bool is_scale(fxl_q16_16 scale)
{
    return scale >= FXL_SCALE_MIN && scale <= FXL_SCALE_MAX;
}

/* formats 1.10 */
static bool motion_is_plain(const fxl_motion *motion, uint32_t number)
{
    return motion->repeats <= 1 && motion->reserved == 0 && motion->parent <= number;
}

/* The largest |coordinate| of a motion's place: that of its keys, and the radius along x and z.
 * Below 2^31. */
/* motion 4.2 */
static void local_extent(const fxl_motion *motion, int64_t extent[3])
{
    extent[0] = (int64_t)motion->extent.x + motion->radius;
    extent[1] = motion->extent.y;
    extent[2] = (int64_t)motion->extent.z + motion->radius;
}

/* motion 4.1 */
static bool extents_in_range(const fxl_motion *motion)
{
    const int64_t limit = ((int64_t)1 << 30) - 1;
    int64_t extent[3];
    local_extent(motion, extent);
    return motion->extent.x >= 0 && motion->extent.y >= 0 && motion->extent.z >= 0 &&
           motion->radius >= 0 && extent[0] <= limit && extent[1] <= limit && extent[2] <= limit &&
           fxl_within(motion->axis.x, limit) && fxl_within(motion->axis.y, limit) &&
           fxl_within(motion->axis.z, limit) && is_scale(motion->scale_low) &&
           is_scale(motion->scale_high);
}

/* A key within what its motion states. */
/* motion 4.1 */
static bool key_in_range(const fxl_motion *motion, const fxl_motion_key *key)
{
    return fxl_within(key->centre.x, motion->extent.x) &&
           fxl_within(key->centre.y, motion->extent.y) &&
           fxl_within(key->centre.z, motion->extent.z) && key->scale >= motion->scale_low &&
           key->scale <= motion->scale_high;
}

/* place field: the check of a motion's values */
/* formats 1.10 */
static FXL_COLD fxl_status check_keys(const fxl_motion_set *set, const fxl_motion *motion,
                                      fxl_scene_fault *fault)
{
    const fxl_motion_key *keys = &set->keys[motion->first_key];
    for (uint32_t i = 0; i < motion->key_count; i++) {
        const bool in_turn = i == 0 ? keys[0].frame == 0 : keys[i].frame > keys[i - 1].frame;
        if (!in_turn || keys[i].frame > FXL_SCENE_PATH_MAX) {
            return fxl_fault_at(fault, "motion key", motion->first_key + i, FXL_E_INDEX);
        }
        if (!key_in_range(motion, &keys[i])) {
            return fxl_fault_at(fault, "motion key", motion->first_key + i, FXL_E_RANGE);
        }
    }
    return FXL_OK;
}

/* The chain of a motion: itself last, its farthest parent first. Returns how many there are, 0 if
 * there are too many. Each parent stands before its child, so the chain ends. */
static uint32_t chain_of(const fxl_motion_set *set, const fxl_motion *motion,
                         const fxl_motion *chain[FXL_MOTION_DEPTH_MAX + 1])
{
    uint32_t first = FXL_MOTION_DEPTH_MAX + 1;
    while (first > 0) {
        chain[--first] = motion;
        if (motion->parent == 0) {
            const uint32_t count = FXL_MOTION_DEPTH_MAX + 1 - first;
            for (uint32_t i = 0; i < count; i++) {
                chain[i] = chain[first + i];
            }
            return count;
        }
        motion = &set->motions[motion->parent - 1];
    }
    return 0;
}

/* scale * length / 2^16, rounded up, and what the rounding of an orientation and a centre adds:
 * less than for fxl_placement_radius. Below 2^40. */
/* motion 4.2 */
static int64_t reach_of(fxl_q16_16 scale, int64_t length)
{
    return (fxl_multiply_s64(scale, length) + 65535) / 65536 + FXL_PLACEMENT_SLACK;
}

/* |place|, rounded up. Components below 2^30. */
/* motion 4.2 */
static int64_t length_of(const int64_t place[3])
{
    const uint64_t square = (uint64_t)(place[0] * place[0]) + (uint64_t)(place[1] * place[1]) +
                            (uint64_t)(place[2] * place[2]);
    return (int64_t)fxl_square_root(square) + 1;
}

/* Whether every frame keeps the instance in the world, and every scale in its range. reach bounds
 * how far the centre and the sphere are from the first parent's place. */
/* motion 4.2, 4.3 */
static bool chain_in_world(const fxl_motion *const *chain, uint32_t count, fxl_q16_16 radius)
{
    int64_t low = chain[0]->scale_low, high = chain[0]->scale_high, reach = 0;
    int64_t root[3], place[3];
    local_extent(chain[0], root);
    for (uint32_t i = 1; i < count; i++) {
        local_extent(chain[i], place);
        reach += reach_of((fxl_q16_16)high, length_of(place));
        low = fxl_round_shift(fxl_multiply_s64(low, chain[i]->scale_low), 16);
        high = fxl_round_shift(fxl_multiply_s64(high, chain[i]->scale_high), 16);
        if (low < FXL_SCALE_MIN || high > FXL_SCALE_MAX) {
            return false;
        }
    }
    reach += reach_of((fxl_q16_16)high, radius);
    return root[0] + reach <= FXL_COORDINATE_MAX && root[1] + reach <= FXL_COORDINATE_MAX &&
           root[2] + reach <= FXL_COORDINATE_MAX;
}

/* formats 1.10 */
static FXL_COLD fxl_status check_motion(const fxl_motion_set *set, uint32_t number,
                                        fxl_q16_16 radius, fxl_scene_fault *fault)
{
    const fxl_motion *motion = &set->motions[number];
    const fxl_motion *chain[FXL_MOTION_DEPTH_MAX + 1];
    if (!extents_in_range(motion)) {
        return fxl_fault_at(fault, "motion", number, FXL_E_RANGE);
    }
    const fxl_status status = check_keys(set, motion, fault);
    if (status != FXL_OK) {
        return status;
    }
    const uint32_t count = chain_of(set, motion, chain);
    if (count == 0) {
        return fxl_fault_at(fault, "motion", number, FXL_E_COUNT);
    }
    return chain_in_world(chain, count, radius)
               ? FXL_OK
               : fxl_fault_at(fault, "motion", number, FXL_E_RANGE);
}

FXL_COLD fxl_status fxl_motion_check(const fxl_motion_set *set, const fxl_scene *scene,
                                     fxl_scene_fault *fault)
{
    if (set == NULL || scene == NULL || (set->motion_count > 0 && set->motions == NULL) ||
        (set->key_count > 0 && set->keys == NULL)) {
        return fxl_fault_at(fault, "motion table", 0, FXL_E_ARGUMENT);
    }
    if (!fxl_is_aligned(set->motions, FXL_WORD) || !fxl_is_aligned(set->keys, FXL_WORD)) {
        return fxl_fault_at(fault, "motion table", 0, FXL_E_ALIGNMENT);
    }
    const uint32_t turned =
        scene->placements != NULL ? scene->instance_count - scene->first_turned : 0;
    if (set->motion_count > turned) {
        return fxl_fault_at(fault, "motion table", 0, FXL_E_COUNT);
    }
    const fxl_instance *instances = &scene->instances[scene->instance_count - set->motion_count];
    uint32_t key = 0;
    for (uint32_t i = 0; i < set->motion_count; i++) {
        const fxl_motion *motion = &set->motions[i];
        if (!motion_is_plain(motion, i)) {
            return fxl_fault_at(fault, "motion", i, FXL_E_RESERVED);
        }
        if (motion->first_key != key || motion->key_count == 0 ||
            motion->key_count > set->key_count - key) {
            return fxl_fault_at(fault, "motion", i, FXL_E_INDEX);
        }
        key += motion->key_count;
        const fxl_status status =
            check_motion(set, i, scene->models[instances[i].model].radius, fault);
        if (status != FXL_OK) {
            return status;
        }
    }
    return key == set->key_count ? FXL_OK : fxl_fault_at(fault, "motion key table", 0, FXL_E_COUNT);
}

/* --- light ------------------------------------------------------------------------------------- */

static bool is_fraction(fxl_q2_30 value)
{
    return value >= 0 && value <= FXL_Q2_30_ONE;
}

/* place light: a new setting: its check */
/* formats 1.11 */
static bool is_fog(const fxl_light_settings *settings)
{
    return (settings->fog_near == 0 && settings->fog_far == 0) ||
           (settings->fog_near >= 0 && settings->fog_near < settings->fog_far &&
            settings->fog_far <= FXL_FAR_MAX);
}

/* formats 1.11 */
static bool is_point_light(const fxl_point_light *light)
{
    return fxl_point_in_range(&light->position) && light->range >= 1 &&
           light->range <= FXL_COORDINATE_MAX && is_fraction(light->strength);
}

/* place field: the check of light's values */
/* formats 1.11 */
fxl_status fxl_light_check(const fxl_light_settings *settings, fxl_scene_fault *fault)
{
    if (settings == NULL) {
        return fxl_fault_at(fault, "light", 0, FXL_E_ARGUMENT);
    }
    if (settings->point_count > FXL_LIGHT_POINTS_MAX || settings->levels < FXL_LIGHT_LEVELS_MIN ||
        settings->levels > FXL_LIGHT_LEVELS_MAX) {
        return fxl_fault_at(fault, "light", 0, FXL_E_COUNT);
    }
    if (!is_fraction(settings->ambient) || !is_fraction(settings->strength) || !is_fog(settings)) {
        return fxl_fault_at(fault, "light", 0, FXL_E_RANGE);
    }
    for (uint32_t i = 0; i < settings->point_count; i++) {
        if (!is_point_light(&settings->points[i])) {
            return fxl_fault_at(fault, "point light", i, FXL_E_RANGE);
        }
    }
    return settings->strength == 0 || fxl_is_unit(&settings->direction)
               ? FXL_OK
               : fxl_fault_at(fault, "light", 0, FXL_E_NORMAL);
}

/* formats 1.11 */
void fxl_light_settings_of(const fxl_scene_light *light, fxl_light_settings *settings)
{
    const fxl_light_base *base = light->base;
    memset(settings, 0, sizeof *settings);
    settings->ambient = base->ambient;
    settings->strength = base->strength;
    settings->direction = base->direction;
    settings->point_count = light->point_count;
    for (uint32_t i = 0; i < light->point_count; i++) {
        settings->points[i] = light->points[i];
    }
    settings->fog_near = base->fog_near;
    settings->fog_far = base->fog_far;
    settings->ramp = light->ramp;
    settings->levels = light->levels;
    settings->dark = light->dark;
}
