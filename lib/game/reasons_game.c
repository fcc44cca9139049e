/* SPDX-License-Identifier: MIT */
/* What the functions of these headers refuse. */
#include "fixel/collide.h"
#include "fixel/motion.h"
#include "fixel/orientation.h"
#include "fixel/pick.h"
#include "fixel/player.h"
#include "fixel/setup.h"
#include "fixel/world.h"
#include "../scene/reasons.h"

const char fxl_collide_reasons[] =
    ON_ARGUMENT "scene, start, end, hit, sphere and move must not be null\0"
    ON_RANGE "points and move must be within FXL_UNITS(-8191)..FXL_UNITS(8191), a "
    "sphere's radius 1/64..256 units, a move at most 1024 half radii; so must "
    "turned instances be within the world, with a scale of 1/256..256\0"
    ON_ORDER "scene must be checked, and have a placement_code where it has placements: "
    "fxl_scene_check_all sets both\0"
    ON_PLACEMENT "the rows of each placement's orientation must be those of a rotation, to "
    "within 2^-28\0";

const char fxl_motion_reasons[] =
    ON_ARGUMENT "player, set, scene, memory and the tables that they count must not be "
    "null, and scene must have placements\0"
    ON_CAPACITY "memory must have room for scene->instance_count instances, and for a "
    "placement of each from first_turned on\0"
    ON_ORDER "scene must not be that of a world: motions write a scene of their own\0"
    ON_ALIGNMENT "the tables of set and memory must be aligned to 4 bytes\0"
    ON_COUNT "set->motion_count must be at most the placements of scene: instance_count "
    "- first_turned\0";

const char fxl_orientation_reasons[] =
    ON_ARGUMENT "a pointer must not be null\0"
    ON_RANGE "coordinates of a vector must be below 2^30 and its length above 0, "
    "direction not parallel to up; numbers of a quaternion must be at most 2^30 in magnitude, "
    "and one of them not 0; centres must be within "
    "FXL_UNITS(-8191)..FXL_UNITS(8191), scales 1/256..256\0"
    ON_PLACEMENT "the rows of each orientation must be those of a rotation, to within "
    "2^-28\0";

const char fxl_pick_reasons[] =
    ON_ARGUMENT "renderer, picked, view, point and place must not be null\0"
    ON_RANGE "x must be below config.width and y below config.height; a point within "
    "FXL_UNITS(-8191)..FXL_UNITS(8191)\0"
    ON_ORDER "renderer has no frame: fxl_frame_begin must answer FXL_OK first, and "
    "fxl_frame_release_scene must not follow; a view must have a pose\0";

const char fxl_player_reasons[] =
    ON_ARGUMENT "viewer, limits, scaled, pose and target must not be null\0"
    ON_RANGE "keys must be an OR of FXL_KEY_..., acceleration, friction, speed and "
    "factor 0..256, positions within FXL_UNITS(-8191)..FXL_UNITS(8191)\0"
    ON_DEGENERATE "target must not be the position of pose\0";

const char fxl_setup_reasons[] =
    ON_ARGUMENT "setup, plan, memory, plan->scene, plan->config, its target and "
    "plan->init_renderer must not be null\0"
    ON_RANGE "rows must be 1..plan->config->height where the target has a depth buffer, "
    "and width and height at most 1024\0"
    ON_CAPACITY "memory_size must be at least the bytes that the scene needs: "
    "setup->memory_missing bytes more; NAME_SETUP_MEMORY(rows) uint64_t are "
    "enough\0"
    ON_ORDER "plan->scene must be checked first: its draw_list_needed is 0\0"
    ON_ALIGNMENT "memory must be aligned to 8 bytes: make it an array of uint64_t\0";

const char fxl_world_reasons[] =
    ON_ARGUMENT "world, scene, memory and its tables, renderer, instance, centre and handle "
    "must not be null\0"
    ON_RANGE "centre and the model's radius times scale must lie within "
    "FXL_UNITS(-8191)..FXL_UNITS(8191), scale 1/256..256; renderer must draw "
    "&world->scene\0"
    ON_CAPACITY "memory->capacity and turned_capacity must have room for all instances, "
    "those without a placement and those with one; at most 4 renderers, each "
    "initialised after fxl_world_init\0"
    ON_ORDER "scene must be checked first; a change must come after fxl_frame_end or "
    "fxl_frame_release_scene of each attached renderer\0"
    ON_ALIGNMENT "memory->instances, slots and placements must be aligned to 4 bytes\0"
    ON_COUNT "memory->capacity must be 1..65535, as turned_capacity where it is not 0, "
    "colour_count 0..255\0"
    ON_INDEX "model must be below scene.model_count, a table of colours at most "
    "memory->colour_count, and renderer attached\0"
    ON_RESERVED "instance->recolour must be 0: fxl_world_recolour sets it\0"
    ON_BSP "the instance of the tree must not be changed but for its colours; no other "
    "may have its model, and none in its layer a sorted model\0"
    ON_PLACEMENT "the rows of placement->orientation must be those of a rotation, to within "
    "2^-28\0"
    ON_STALE "handle must be that of an instance which was not removed\0";
