/* SPDX-License-Identifier: MIT */
/* Where a world keeps its instances. Internal.
 *
 * The table has two parts: `capacity` places of instances without a placement, then
 * `turned_capacity` places of those with one. Those that are shown lie on both sides of the border
 * between the parts, without a gap, so they are one table for the renderer: first those without a
 * placement. The hidden ones lie at the outer ends. Each group grows away from its end of a part:
 *
 *   | hidden ->   <- shown | shown, turned ->   <- hidden, turned |
 *
 * An instance that leaves a group is replaced by the group's last. */
#ifndef FXL_WORLD_PLACE_H
#define FXL_WORLD_PLACE_H

#include "fixel/world.h"

enum {
    FXL_WORLD_HIDDEN,
    FXL_WORLD_SHOWN,
    FXL_WORLD_SHOWN_TURNED,
    FXL_WORLD_HIDDEN_TURNED
};

/* An instance on its way from one place to another. */
typedef struct {
    fxl_instance instance;
    fxl_placement placement; /* where it has one */
    uint32_t slot;
} fxl_world_entry;

static inline uint32_t fxl_world_places(const fxl_world *world)
{
    return world->memory.capacity + world->memory.turned_capacity;
}

static inline bool fxl_world_is_turned(uint32_t group)
{
    return group >= FXL_WORLD_SHOWN_TURNED;
}

/* The group of the instance at a place. */
uint32_t fxl_world_group(const fxl_world *world, uint32_t place);

/* Whether a part of the table has room for one more. */
bool fxl_world_has_room(const fxl_world *world, bool turned);

/* Adds an entry to a group. Requires room. */
void fxl_world_put(fxl_world *world, uint32_t group, const fxl_world_entry *entry);

/* Takes the instance at a place out of its group; *entry becomes that instance. */
void fxl_world_take(fxl_world *world, uint32_t place, fxl_world_entry *entry);

/* Counts a call that is refused; answers its status. */
/* world 1.5 */
static inline fxl_status fxl_world_refuse(fxl_world *world, fxl_status status)
{
    world->refused_calls += 1;
    return status;
}

/* The place of an attached renderer. Null: it is none, or an argument is null; the call is refused
 * with *status. */
fxl_renderer **fxl_world_find_attached(fxl_world *world, const fxl_renderer *renderer,
                                       fxl_status *status);

/* Has the scene show the groups that are shown. */
void fxl_world_publish(fxl_world *world);

#endif
