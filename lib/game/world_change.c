/* SPDX-License-Identifier: MIT */
/* What changes the instances of a world. */
#include "../draw/submit.h"
#include "../math/arith.h"
#include "world_place.h"

/* --- handles --------------------------------------------------------------------------- */

/* world 1.2 */
static bool is_valid(const fxl_world *world, fxl_handle handle)
{
    if (world == NULL) {
        return false;
    }
    return handle.slot < fxl_world_places(world) && (handle.generation & 1u) != 0 &&
           world->memory.slots[handle.slot].generation == handle.generation;
}

static uint32_t place_of(const fxl_world *world, fxl_handle handle)
{
    return world->memory.slots[handle.slot].place;
}

/* world 1.2 */
fxl_handle fxl_world_handle_at(const fxl_world *world, uint32_t instance)
{
    fxl_handle handle = {0, 0};
    if (world != NULL && instance < world->scene.instance_count) {
        /* The scene's table begins with the last instance that was shown without a placement. */
        const uint32_t first = world->memory.capacity - world->counts[FXL_WORLD_SHOWN];
        handle.slot = world->memory.slots[first + instance].holder;
        handle.generation = world->memory.slots[handle.slot].generation;
    }
    return handle;
}

const fxl_instance *fxl_world_instance(const fxl_world *world, fxl_handle handle)
{
    return is_valid(world, handle) ? &world->memory.instances[place_of(world, handle)] : NULL;
}

const fxl_placement *fxl_world_placement(const fxl_world *world, fxl_handle handle)
{
    if (!is_valid(world, handle) || place_of(world, handle) < world->memory.capacity) {
        return NULL;
    }
    return &world->memory.placements[place_of(world, handle) - world->memory.capacity];
}

bool fxl_world_is_shown(const fxl_world *world, fxl_handle handle)
{
    if (!is_valid(world, handle)) {
        return false;
    }
    const uint32_t group = fxl_world_group(world, place_of(world, handle));
    return group == FXL_WORLD_SHOWN || group == FXL_WORLD_SHOWN_TURNED;
}

/* --- what may be changed --------------------------------------------------------------- */

/* Whether an attached renderer may read the scene for the frame that it draws. */
/* world 2.3 */
static bool is_drawn(const fxl_world *world)
{
    for (uint32_t i = 0; i < FXL_WORLD_RENDERERS_MAX; i++) {
        const fxl_renderer *renderer = world->renderers[i];
        if (renderer != NULL && renderer->frame.state != FXL_FRAME_NONE &&
            renderer->frame.state != FXL_FRAME_RELEASED) {
            return true;
        }
    }
    return false;
}

/* Whether the instance of a handle may be changed at all. */
/* world 1.5 */
static fxl_status check_change(const fxl_world *world, fxl_handle handle)
{
    if (is_drawn(world)) {
        return FXL_E_ORDER;
    }
    return is_valid(world, handle) ? FXL_OK : FXL_E_STALE;
}

/* The same for what the instance of the BSP tree refuses. */
static fxl_status check_free_change(const fxl_world *world, fxl_handle handle)
{
    const fxl_status status = check_change(world, handle);
    return status == FXL_OK && world->scene.bsp_nodes != NULL && handle.slot == world->bsp_slot
               ? FXL_E_BSP
               : status;
}

/* Whether an instance may be with the BSP tree, if there is one. */
static bool may_be_with_bsp(const fxl_world *world, const fxl_instance *instance)
{
    const fxl_scene *scene = &world->scene;
    if (scene->bsp_nodes == NULL) {
        return true;
    }
    const fxl_instance *owner = &scene->instances[scene->bsp_instance];
    return instance->model != owner->model &&
           (instance->layer != owner->layer ||
            scene->models[instance->model].kind == FXL_MODEL_CONVEX);
}

/* Whether an instance that is not turned lies within the world. */
/* world 2.2 */
static bool lies_in_world(const fxl_instance *instance, fxl_q16_16 radius)
{
    const int64_t limit = (int64_t)FXL_COORDINATE_MAX - radius;
    return fxl_within(instance->centre.x, limit) && fxl_within(instance->centre.y, limit) &&
           fxl_within(instance->centre.z, limit);
}

static fxl_status check_instance(const fxl_world *world, const fxl_instance *instance,
                                 const fxl_placement *placement)
{
    if (instance->model >= world->scene.model_count) {
        return FXL_E_INDEX;
    }
    const fxl_q16_16 radius = world->scene.models[instance->model].radius;
    const fxl_status status = placement != NULL
                                  ? fxl_placement_check(placement, &instance->centre, radius)
                              : lies_in_world(instance, radius) ? FXL_OK
                                                                : FXL_E_RANGE;
    if (status != FXL_OK) {
        return status;
    }
    return may_be_with_bsp(world, instance) ? FXL_OK : FXL_E_BSP;
}

/* --- spawn and remove ------------------------------------------------------------------ */

static fxl_status check_spawn(const fxl_world *world, const fxl_instance *instance,
                              const fxl_placement *placement, const fxl_handle *handle)
{
    if (instance == NULL || handle == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (is_drawn(world)) {
        return FXL_E_ORDER;
    }
    if (!fxl_world_has_room(world, placement != NULL)) {
        return FXL_E_CAPACITY;
    }
    return instance->recolour != 0 ? FXL_E_RESERVED : check_instance(world, instance, placement);
}

fxl_status fxl_world_spawn(fxl_world *world, const fxl_instance *instance,
                           const fxl_placement *placement, fxl_handle *handle)
{
    if (world == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = check_spawn(world, instance, placement, handle);
    if (status != FXL_OK) {
        return fxl_world_refuse(world, status);
    }
    const uint32_t slot = world->free_slot;
    fxl_world_entry entry;
    FXL_ASSERT(slot < fxl_world_places(world));
    entry.instance = *instance;
    if (placement != NULL) {
        entry.placement = *placement;
    }
    entry.slot = slot;
    world->free_slot = world->memory.slots[slot].place;
    world->memory.slots[slot].generation += 1;
    fxl_world_put(world, placement != NULL ? FXL_WORLD_SHOWN_TURNED : FXL_WORLD_SHOWN, &entry);
    fxl_world_publish(world);
    handle->slot = slot;
    handle->generation = world->memory.slots[slot].generation;
    return FXL_OK;
}

/* world 1.2 */
fxl_status fxl_world_remove(fxl_world *world, fxl_handle handle)
{
    if (world == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = check_free_change(world, handle);
    if (status != FXL_OK) {
        return fxl_world_refuse(world, status);
    }
    fxl_world_entry entry;
    fxl_world_slot *slot = &world->memory.slots[handle.slot];
    fxl_world_take(world, slot->place, &entry);
    slot->generation += 1;
    slot->place = (uint16_t)world->free_slot;
    world->free_slot = handle.slot;
    fxl_world_publish(world);
    return FXL_OK;
}

/* --- hide and show --------------------------------------------------------------------- */

/* Moves an instance from one group to another. */
static void regroup(fxl_world *world, fxl_handle handle, uint32_t group,
                    const fxl_placement *placement)
{
    fxl_world_entry entry;
    fxl_world_take(world, place_of(world, handle), &entry);
    if (placement != NULL) {
        entry.placement = *placement;
    }
    fxl_world_put(world, group, &entry);
    fxl_world_publish(world);
}

/* world 1.3 */
static fxl_status set_shown(fxl_world *world, fxl_handle handle, bool shown)
{
    if (world == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = check_free_change(world, handle);
    if (status != FXL_OK) {
        return fxl_world_refuse(world, status);
    }
    if (fxl_world_is_shown(world, handle) != shown) {
        const bool turned = fxl_world_is_turned(fxl_world_group(world, place_of(world, handle)));
        const uint32_t plain = shown ? FXL_WORLD_SHOWN : FXL_WORLD_HIDDEN;
        const uint32_t with_placement = shown ? FXL_WORLD_SHOWN_TURNED : FXL_WORLD_HIDDEN_TURNED;
        regroup(world, handle, turned ? with_placement : plain, NULL);
    }
    return FXL_OK;
}

fxl_status fxl_world_hide(fxl_world *world, fxl_handle handle)
{
    return set_shown(world, handle, false);
}

fxl_status fxl_world_show(fxl_world *world, fxl_handle handle)
{
    return set_shown(world, handle, true);
}

/* --- what an instance is ---------------------------------------------------------------- */

/* Puts *changed in place of the instance of a handle, if it may be there with this placement. */
static fxl_status replace(fxl_world *world, fxl_handle handle, const fxl_instance *changed)
{
    const fxl_status status = check_instance(world, changed, fxl_world_placement(world, handle));
    if (status != FXL_OK) {
        return fxl_world_refuse(world, status);
    }
    world->memory.instances[place_of(world, handle)] = *changed;
    return FXL_OK;
}

fxl_status fxl_world_move(fxl_world *world, fxl_handle handle, const fxl_point *centre)
{
    if (world == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = centre == NULL ? FXL_E_ARGUMENT : check_free_change(world, handle);
    if (status != FXL_OK) {
        return fxl_world_refuse(world, status);
    }
    fxl_instance changed = *fxl_world_instance(world, handle);
    changed.centre = *centre;
    return replace(world, handle, &changed);
}

/* world 1.3 */
fxl_status fxl_world_set_model(fxl_world *world, fxl_handle handle, uint16_t model)
{
    if (world == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = check_free_change(world, handle);
    if (status != FXL_OK) {
        return fxl_world_refuse(world, status);
    }
    fxl_instance changed = *fxl_world_instance(world, handle);
    changed.model = model;
    return replace(world, handle, &changed);
}

/* world 1.3 */
fxl_status fxl_world_set_layer(fxl_world *world, fxl_handle handle, uint8_t layer)
{
    if (world == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = check_free_change(world, handle);
    if (status != FXL_OK) {
        return fxl_world_refuse(world, status);
    }
    fxl_instance changed = *fxl_world_instance(world, handle);
    changed.layer = layer;
    if (!may_be_with_bsp(world, &changed)) {
        return fxl_world_refuse(world, FXL_E_BSP);
    }
    world->memory.instances[place_of(world, handle)] = changed;
    return FXL_OK;
}

fxl_status fxl_world_set_placement(fxl_world *world, fxl_handle handle,
                                   const fxl_placement *placement)
{
    if (world == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = check_free_change(world, handle);
    if (status != FXL_OK) {
        return fxl_world_refuse(world, status);
    }
    const uint32_t place = place_of(world, handle), group = fxl_world_group(world, place);
    const bool turned = fxl_world_is_turned(group);
    status = check_instance(world, &world->memory.instances[place], placement);
    if (status == FXL_OK && turned != (placement != NULL) && !fxl_world_has_room(world, !turned)) {
        status = FXL_E_CAPACITY;
    }
    if (status != FXL_OK) {
        return fxl_world_refuse(world, status);
    }
    if (turned && placement != NULL) {
        world->memory.placements[place - world->memory.capacity] = *placement;
    } else if (turned || placement != NULL) {
        /* The groups of a part mirror those of the other. */
        regroup(world, handle, FXL_WORLD_HIDDEN_TURNED - group, placement);
    }
    return FXL_OK;
}

fxl_status fxl_world_recolour(fxl_world *world, fxl_handle handle, uint32_t number)
{
    if (world == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = check_change(world, handle);
    if (status == FXL_OK && number > world->memory.colour_count) {
        status = FXL_E_INDEX;
    }
    if (status != FXL_OK) {
        return fxl_world_refuse(world, status);
    }
    world->memory.instances[place_of(world, handle)].recolour = (uint8_t)number;
    return FXL_OK;
}

/* Instances in colours of their own. A file of its own, so that a world that recolours nothing does
 * not link it. */

static bool reaches(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    (void)shader;
    (void)scene;
    return instance->recolour != 0;
}

static uint8_t colour(const fxl_shader *shader, const fxl_traversal *traversal,
                      const fxl_instance *instance, const fxl_face *face, uint8_t of_model)
{
    const fxl_world *world = ((const fxl_world_colours *)(const void *)shader)->world;
    const uint32_t table = instance->recolour - 1u;
    (void)traversal;
    (void)face;
    FXL_ASSERT(instance->recolour <= world->memory.colour_count);
    return world->memory.colours[256u * table + of_model];
}

fxl_status fxl_world_set_colours(fxl_world *world, fxl_renderer *renderer,
                                 fxl_world_colours *colours)
{
    static const fxl_shader_code code = {
        .reaches = reaches, .face = fxl_submit_coloured_face, .colour = colour};
    fxl_status status;
    if (fxl_world_find_attached(world, renderer, &status) == NULL) {
        return status;
    }
    if (colours != NULL) {
        colours->shader.code = &code;
        colours->world = world;
    }
    fxl_renderer_set_shader(renderer, FXL_SHADER_RECOLOUR,
                            colours != NULL ? &colours->shader : NULL);
    return FXL_OK;
}
