/* SPDX-License-Identifier: MIT */
/* The player of motions (docs/extras/motion.md). */
#include "fixel/motion.h"

#include "../math/arith.h"
#include "../math/memory.h"
#include "fixel/orientation.h"

/* What the keys say of a frame. */
typedef struct {
    fxl_point centre;
    fxl_angle yaw, pitch, roll;
    fxl_q16_16 scale;
} key_place;

/* The number of the last key that is not after a frame. The first key is at frame 0. */
/* motion 2.1 */
static uint32_t last_key_at(const fxl_motion_key *keys, uint32_t count, uint32_t frame)
{
    uint32_t low = 0, high = count;
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        if (keys[middle].frame <= frame) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

/* a + difference * part / whole, rounded once. |difference| <= 2^31 and part < whole <= 10^6, so
 * the product is below 2^51 and the quotient below 2^31. Wraps for angles. Error: half a unit. */
/* motion 2.1 */
static uint32_t between(uint32_t a, int32_t difference, uint32_t part, uint32_t whole)
{
    return a + (uint32_t)fxl_divide_round(fxl_multiply_s64(difference, part), whole);
}

/* Coordinates and scales are below 2^30, and so are their differences in magnitude below 2^31. */
/* motion 2.1 */
static int32_t coordinate_between(int32_t a, int32_t b, uint32_t part, uint32_t whole)
{
    return (int32_t)between((uint32_t)a, b - a, part, whole);
}

/* Angles take the short way. */
/* motion 2.1 */
static fxl_angle angle_between(fxl_angle a, fxl_angle b, uint32_t part, uint32_t whole)
{
    return between(a, (int32_t)(b - a), part, whole);
}

static void interpolate(const fxl_motion_key *a, const fxl_motion_key *b, uint32_t part,
                        key_place *place)
{
    const uint32_t whole = b->frame - a->frame;
    place->centre.x = coordinate_between(a->centre.x, b->centre.x, part, whole);
    place->centre.y = coordinate_between(a->centre.y, b->centre.y, part, whole);
    place->centre.z = coordinate_between(a->centre.z, b->centre.z, part, whole);
    place->yaw = angle_between(a->yaw, b->yaw, part, whole);
    place->pitch = angle_between(a->pitch, b->pitch, part, whole);
    place->roll = angle_between(a->roll, b->roll, part, whole);
    place->scale = coordinate_between(a->scale, b->scale, part, whole);
}

/* Where the keys are in a frame. After the last key the motion stays there, or repeats. */
/* motion 2.2 */
static void place_by_keys(const fxl_motion *motion, const fxl_motion_key *keys, uint32_t frame,
                          key_place *place)
{
    const uint32_t last = motion->key_count - 1;
    if (motion->repeats && last > 0) {
        uint32_t remainder;
        (void)fxl_divide_u32(frame, keys[last].frame, &remainder);
        frame = remainder;
    }
    const uint32_t at = last_key_at(keys, motion->key_count, frame);
    if (at < last) {
        interpolate(&keys[at], &keys[at + 1], frame - keys[at].frame, place);
        return;
    }
    place->centre = keys[at].centre;
    place->yaw = keys[at].yaw;
    place->pitch = keys[at].pitch;
    place->roll = keys[at].roll;
    place->scale = keys[at].scale;
}

/* radius * sine, rounded: at most 2^30 * 2^31. Error: 0.5 + 0.52 * 2^-31 * radius < 0.76 unit. */
/* motion 2.3 */
static int32_t on_circle(fxl_q16_16 radius, int64_t sine)
{
    return (int32_t)fxl_round_shift(fxl_multiply_s64(radius, sine), 31);
}

/* motion 2.3 */
static void add_circle(const fxl_motion *motion, uint32_t frame, fxl_point *centre)
{
    const fxl_angle angle = motion->circle + frame * motion->circle_step;
    centre->x += on_circle(motion->radius, fxl_sin_q31(angle));
    centre->z += on_circle(motion->radius, fxl_cos_q31(angle));
}

/* Orientation: the angles after the spin. Either alone where the other turns nothing. */
/* motion 2.4 */
static void orient(const fxl_motion *motion, const key_place *place, uint32_t frame,
                   fxl_orientation *orientation)
{
    const fxl_angle yaw = place->yaw + frame * motion->yaw_step;
    const fxl_angle pitch = place->pitch + frame * motion->pitch_step;
    const fxl_angle roll = place->roll + frame * motion->roll_step;
    fxl_orientation spun;
    fxl_status status = FXL_OK;
    if ((motion->axis.x | motion->axis.y | motion->axis.z) == 0) {
        status = fxl_orientation_from_angles(yaw, pitch, roll, orientation);
    } else {
        const fxl_angle spin = motion->spin + frame * motion->spin_step;
        status = fxl_orientation_from_axis(&motion->axis, spin, &spun);
        if ((yaw | pitch | roll) == 0) {
            *orientation = spun;
        } else if (status == FXL_OK) {
            (void)fxl_orientation_from_angles(yaw, pitch, roll, orientation);
            status = fxl_orientation_multiply(orientation, &spun, orientation);
        }
    }
    FXL_ASSERT(status == FXL_OK);
    (void)status;
}

/* motion 1.2, 2.5 */
static void play_one(const fxl_motion_player *player, uint32_t number, uint32_t frame)
{
    const fxl_motion *motion = &player->set.motions[number];
    fxl_point *centre = &player->instances[number].centre;
    fxl_placement *placement = &player->placements[number];
    key_place place;
    place_by_keys(motion, &player->set.keys[motion->first_key], frame, &place);
    if (motion->radius != 0) {
        add_circle(motion, frame, &place.centre);
    }
    orient(motion, &place, frame, &placement->orientation);
    placement->scale = place.scale;
    *centre = place.centre;
    if (motion->parent != 0) {
        const uint32_t parent = motion->parent - 1u; /* below number: it has this frame's place */
        const fxl_status status =
            fxl_placement_attach(&player->instances[parent].centre, &player->placements[parent],
                                 &place.centre, placement, centre, placement);
        FXL_ASSERT(status == FXL_OK);
        (void)status;
    }
}

/* motion 1.2 */
FXL_COLD void fxl_motion_play(const fxl_motion_player *player, uint32_t frame)
{
    for (uint32_t i = 0; i < player->set.motion_count; i++) {
        play_one(player, i, frame);
    }
}

static bool is_aligned(const fxl_motion_set *set, const fxl_motion_memory *memory)
{
    return fxl_is_aligned(set->motions, FXL_WORD) && fxl_is_aligned(set->keys, FXL_WORD) &&
           fxl_is_aligned(memory->instances, FXL_WORD) &&
           fxl_is_aligned(memory->placements, FXL_WORD);
}

/* motion 1.1, 1.3, world 2.5 */
fxl_status fxl_motion_begin(fxl_motion_player *player, const fxl_motion_set *set, fxl_scene *scene,
                            const fxl_motion_memory *memory)
{
    if (player == NULL || set == NULL || scene == NULL || memory == NULL ||
        memory->instances == NULL || memory->placements == NULL || scene->instances == NULL ||
        scene->placements == NULL || (set->motions == NULL && set->motion_count > 0) ||
        (set->keys == NULL && (set->motion_count > 0 || set->key_count > 0))) {
        return FXL_E_ARGUMENT;
    }
    if (scene->instance_capacity > 0) {
        return FXL_E_ORDER;
    }
    if (!is_aligned(set, memory)) {
        return FXL_E_ALIGNMENT;
    }
    const uint32_t turned = scene->instance_count - scene->first_turned;
    if (set->motion_count > turned) {
        return FXL_E_COUNT;
    }
    if (memory->instance_capacity < scene->instance_count || memory->placement_capacity < turned) {
        return FXL_E_CAPACITY;
    }
    memcpy(memory->instances, scene->instances, scene->instance_count * sizeof(fxl_instance));
    memcpy(memory->placements, scene->placements, turned * sizeof(fxl_placement));
    scene->instances = memory->instances;
    scene->placements = memory->placements;
    player->set = *set;
    player->instances = &memory->instances[scene->instance_count - set->motion_count];
    player->placements = &memory->placements[turned - set->motion_count];
    fxl_motion_play(player, 0);
    return FXL_OK;
}
