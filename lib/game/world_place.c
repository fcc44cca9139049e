/* SPDX-License-Identifier: MIT */
#include "world_place.h"

#include "../math/arith.h"

/* The place of instance `number` of a group. */
static uint32_t place_in(const fxl_world *world, uint32_t group, uint32_t number)
{
    switch (group) {
    case FXL_WORLD_HIDDEN:
        return number;
    case FXL_WORLD_SHOWN:
        return world->memory.capacity - 1 - number;
    case FXL_WORLD_SHOWN_TURNED:
        return world->memory.capacity + number;
    default:
        return fxl_world_places(world) - 1 - number;
    }
}

uint32_t fxl_world_group(const fxl_world *world, uint32_t place)
{
    if (place < world->memory.capacity) {
        return place < world->counts[FXL_WORLD_HIDDEN] ? FXL_WORLD_HIDDEN : FXL_WORLD_SHOWN;
    }
    return place - world->memory.capacity < world->counts[FXL_WORLD_SHOWN_TURNED]
               ? FXL_WORLD_SHOWN_TURNED
               : FXL_WORLD_HIDDEN_TURNED;
}

bool fxl_world_has_room(const fxl_world *world, bool turned)
{
    const uint32_t *counts = world->counts;
    return turned ? counts[FXL_WORLD_SHOWN_TURNED] + counts[FXL_WORLD_HIDDEN_TURNED] <
                        world->memory.turned_capacity
                  : counts[FXL_WORLD_HIDDEN] + counts[FXL_WORLD_SHOWN] < world->memory.capacity;
}

static void write_place(fxl_world *world, uint32_t place, const fxl_world_entry *entry)
{
    const fxl_world_memory *memory = &world->memory;
    memory->instances[place] = entry->instance;
    if (place >= memory->capacity) {
        memory->placements[place - memory->capacity] = entry->placement;
    }
    memory->slots[place].holder = (uint16_t)entry->slot;
    memory->slots[entry->slot].place = (uint16_t)place;
}

static void read_place(const fxl_world *world, uint32_t place, fxl_world_entry *entry)
{
    const fxl_world_memory *memory = &world->memory;
    entry->instance = memory->instances[place];
    if (place >= memory->capacity) {
        entry->placement = memory->placements[place - memory->capacity];
    }
    entry->slot = memory->slots[place].holder;
}

void fxl_world_put(fxl_world *world, uint32_t group, const fxl_world_entry *entry)
{
    FXL_ASSERT(fxl_world_has_room(world, fxl_world_is_turned(group)));
    write_place(world, place_in(world, group, world->counts[group]++), entry);
}

void fxl_world_take(fxl_world *world, uint32_t place, fxl_world_entry *entry)
{
    const uint32_t group = fxl_world_group(world, place);
    FXL_ASSERT(world->counts[group] > 0);
    const uint32_t last = place_in(world, group, --world->counts[group]);
    read_place(world, place, entry);
    if (place != last) {
        fxl_world_entry moved;
        read_place(world, last, &moved);
        write_place(world, place, &moved);
    }
}

void fxl_world_publish(fxl_world *world)
{
    const fxl_world_memory *memory = &world->memory;
    const uint32_t shown = world->counts[FXL_WORLD_SHOWN];
    const uint32_t turned = world->counts[FXL_WORLD_SHOWN_TURNED];
    fxl_scene *scene = &world->scene;
    scene->instances = memory->instances + (memory->capacity - shown);
    scene->instance_count = shown + turned;
    scene->placements = turned > 0 ? memory->placements : NULL;
    scene->first_turned = turned > 0 ? shown : 0;
    if (scene->bsp_nodes != NULL) {
        scene->bsp_instance = memory->slots[world->bsp_slot].place - (memory->capacity - shown);
    }
}
