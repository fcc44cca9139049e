/* SPDX-License-Identifier: MIT */
/* A world, and the renderers that draw it. */
#include "fixel/world.h"

#include "../draw/renderer.h"
#include "../math/memory.h"
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

/* world 1.1 */
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

/* world 1.4 */
void fxl_world_put(fxl_world *world, uint32_t group, const fxl_world_entry *entry)
{
    FXL_ASSERT(fxl_world_has_room(world, fxl_world_is_turned(group)));
    write_place(world, place_in(world, group, world->counts[group]++), entry);
}

/* world 1.4 */
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

/* world 2.1 */
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

/* Slots from `first` on are free, each followed by the next. Slot n of the others is that of the
 * scene's instance n. */
static void free_slots(fxl_world *world, uint32_t first)
{
    const uint32_t count = fxl_world_places(world);
    fxl_world_slot *slots = world->memory.slots;
    for (uint32_t i = 0; i < count; i++) {
        slots[i].generation = i < first;
        slots[i].place = (uint16_t)(i + 1);
        slots[i].holder = 0;
    }
    world->free_slot = first;
}

/* Instances of the scene without a placement. */
static uint32_t unturned(const fxl_scene *scene)
{
    return scene->placements != NULL ? scene->first_turned : scene->instance_count;
}

/* Whether there is a table of colours for each instance of a scene, which may be another world's.
 */
static bool has_tables(const fxl_scene *scene, uint32_t colour_count)
{
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        if (scene->instances[i].recolour > colour_count) {
            return false;
        }
    }
    return true;
}

static fxl_status check(const fxl_scene *scene, const fxl_world_memory *memory)
{
    if (memory->instances == NULL || memory->slots == NULL ||
        ((memory->placements == NULL || memory->placement_code == NULL) &&
         memory->turned_capacity > 0) ||
        (memory->colours == NULL && memory->colour_count > 0)) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_is_aligned(memory->instances, FXL_WORD) || !fxl_is_aligned(memory->slots, FXL_WORD) ||
        !fxl_is_aligned(memory->placements, FXL_WORD)) {
        return FXL_E_ALIGNMENT;
    }
    if (scene->draw_list_needed == 0) {
        return FXL_E_ORDER;
    }
    const uint64_t places = (uint64_t)memory->capacity + memory->turned_capacity;
    if (places == 0 || places > FXL_SCENE_INSTANCES_MAX || memory->colour_count > UINT8_MAX) {
        return FXL_E_COUNT;
    }
    if (unturned(scene) > memory->capacity ||
        scene->instance_count - unturned(scene) > memory->turned_capacity) {
        return FXL_E_CAPACITY;
    }
    return has_tables(scene, memory->colour_count) ? FXL_OK : FXL_E_INDEX;
}

/* Takes the scene's instances over. Those without a placement come last to first, so that they lie
 * in the table in the order that they have in the scene. */
/* world 1.1 */
static void take_over(fxl_world *world, const fxl_scene *scene)
{
    const uint32_t first_turned = unturned(scene);
    fxl_world_entry entry;
    for (uint32_t i = first_turned; i-- > 0;) {
        entry.instance = scene->instances[i];
        entry.slot = i;
        fxl_world_put(world, FXL_WORLD_SHOWN, &entry);
    }
    for (uint32_t i = first_turned; i < scene->instance_count; i++) {
        entry.instance = scene->instances[i];
        entry.placement = scene->placements[i - first_turned];
        entry.slot = i;
        fxl_world_put(world, FXL_WORLD_SHOWN_TURNED, &entry);
    }
}

fxl_status fxl_world_init(fxl_world *world, const fxl_scene *scene, const fxl_world_memory *memory)
{
    if (world == NULL || scene == NULL || memory == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = check(scene, memory);
    if (status != FXL_OK) {
        return status;
    }
    const fxl_scene from = *scene; /* it may lie in a world */
    memset(world, 0, sizeof *world);
    world->scene = from;
    world->memory = *memory;
    world->scene.placement_code = memory->placement_code;
    world->bsp_slot = from.bsp_instance;
    free_slots(world, from.instance_count);
    take_over(world, &from);
    world->scene.instance_capacity = fxl_world_places(world);
    world->scene.draw_list_needed =
        from.draw_list_needed - fxl_list_instances_most(&from) + world->scene.instance_capacity;
    fxl_world_publish(world);
    return FXL_OK;
}

fxl_handle fxl_world_handle(uint32_t number)
{
    const fxl_handle handle = {number, 1};
    return handle;
}

/* --- renderers ------------------------------------------------------------------------- */

/* The place of a renderer among those attached, or of null. Null: it is not there. */
static fxl_renderer **find(fxl_world *world, const fxl_renderer *renderer)
{
    for (uint32_t i = 0; i < FXL_WORLD_RENDERERS_MAX; i++) {
        if (world->renderers[i] == renderer) {
            return &world->renderers[i];
        }
    }
    return NULL;
}

/* world 2.4 */
fxl_status fxl_world_attach(fxl_world *world, fxl_renderer *renderer)
{
    if (world == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer == NULL) {
        return fxl_world_refuse(world, FXL_E_ARGUMENT);
    }
    if (renderer->scene != &world->scene) {
        return fxl_world_refuse(world, FXL_E_RANGE);
    }
    fxl_renderer **place = find(world, renderer);
    if (place == NULL) {
        place = find(world, NULL);
    }
    /* fxl_renderer_init divided the order, but left the instances' part unused. */
    const uint32_t capacity = (uint32_t)(renderer->workspace.face_list - renderer->frame.draw_list);
    if (place == NULL || capacity < world->scene.instance_capacity) {
        return fxl_world_refuse(world, FXL_E_CAPACITY);
    }
    *place = renderer;
    renderer->instance_capacity = capacity;
    return FXL_OK;
}

fxl_renderer **fxl_world_find_attached(fxl_world *world, const fxl_renderer *renderer,
                                       fxl_status *status)
{
    fxl_renderer **place = NULL;
    if (world == NULL) {
        *status = FXL_E_ARGUMENT;
    } else if (renderer == NULL) {
        *status = fxl_world_refuse(world, FXL_E_ARGUMENT);
    } else {
        place = find(world, renderer);
        *status = place != NULL ? FXL_OK : fxl_world_refuse(world, FXL_E_INDEX);
    }
    return place;
}

/* world 2.4 */
fxl_status fxl_world_detach(fxl_world *world, fxl_renderer *renderer)
{
    fxl_status status;
    fxl_renderer **place = fxl_world_find_attached(world, renderer, &status);
    if (place != NULL) {
        *place = NULL;
        renderer->instance_capacity = 0;
        renderer->frame.state = FXL_FRAME_NONE;
    }
    return status;
}
