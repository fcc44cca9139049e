/* SPDX-License-Identifier: MIT */
/* A world at run time: instances that come, go, move and change while the models stay where they
 * are, in flash. docs/extras/world.md. */
#ifndef FXL_WORLD_H
#define FXL_WORLD_H

#include "fixel/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The most renderers that may draw one world at the same time. */
#define FXL_WORLD_RENDERERS_MAX 4

/* The handle by which a program names an instance of a world. It goes stale when the instance is
 * removed. A stale handle stays stale until its slot has been given to 2^31 - 1 other instances. A
 * handle of zeros is always stale. */
typedef struct {
    uint32_t slot, generation;
} fxl_handle;

/* A slot of a world. The table serves two searches: slot n has the place of the instance whose
 * handle names slot n; and it has the slot of the instance that is at place n. */
typedef struct {
    uint32_t generation; /* odd: that of the handle; even: the slot is free */
    uint16_t place;      /* in the table of instances; of a free slot: the next free one */
    uint16_t holder;     /* the slot of the instance at this place */
} fxl_world_slot;

/* Memory of the caller that a world works in for as long as it lives. */
typedef struct {
    fxl_instance *instances;   /* capacity + turned_capacity */
    fxl_world_slot *slots;     /* as many */
    fxl_placement *placements; /* turned_capacity; may be null where that is 0 */
    uint32_t capacity;         /* instances without a placement, hidden ones included */
    uint32_t turned_capacity;  /* instances with a placement, hidden ones included; both are
                                  1..FXL_SCENE_INSTANCES_MAX */
    /* Tables of 256 colours that fxl_world_recolour chooses from: by table n, colours[256 * n + c]
     * is drawn in place of colour c. May be null where colour_count is 0. */
    const uint8_t *colours;
    uint32_t colour_count;                    /* tables, 0..255 */
    const fxl_placement_code *placement_code; /* &fxl_turned_instances where turned_capacity is
                                       above 0: a program that turns nothing links no code for it */
} fxl_world_memory;

/* A world, which the caller owns. Members are for reading only. It may not be moved while a
 * renderer is attached to it. */
typedef struct {
    fxl_scene scene; /* what a renderer draws: the models of the scene, the instances shown */
    fxl_world_memory memory;
    uint32_t counts[4];     /* hidden and shown, then shown and hidden with a placement */
    uint32_t free_slot;     /* the first free slot; the number of slots: there is none */
    uint32_t bsp_slot;      /* of the instance of the BSP tree, where the scene has one */
    uint32_t refused_calls; /* calls that changed nothing and answered an error */
    fxl_renderer *renderers[FXL_WORLD_RENDERERS_MAX]; /* attached ones; null: none */
} fxl_world;

/* What has a renderer recolour the instances of a world, which the caller owns. */
typedef struct {
    fxl_shader shader;
    const fxl_world *world;
} fxl_world_colours;

/* Sets up a world over a scene that was checked. The world takes the scene's instances over, all of
 * them shown, and keeps pointers to the scene's other tables and to the memory. The scene itself is
 * neither changed nor needed afterwards: what a player of motions (fixel/motion.h) writes there
 * does not move the world. world->scene.draw_list_needed is then enough for the whole capacity. A
 * renderer that drew this world before must be initialised and attached again.
 * The scene may be the scene of another world: the instances that are shown there, in the colours
 * that they have there, are then in both worlds.
 * Requires that the scene's instances and placements do not lie in the memory.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ALIGNMENT: instances, slots or placements are not aligned to 4 bytes.
 * FXL_E_ORDER: the scene was not checked.
 * FXL_E_COUNT: a capacity or colour_count is out of range.
 * FXL_E_CAPACITY: the scene has more instances, or more with a placement.
 * FXL_E_INDEX: an instance is in the colours of a table beyond colour_count.
 * With each of these statuses: nothing is changed. */
fxl_status fxl_world_init(fxl_world *world, const fxl_scene *scene, const fxl_world_memory *memory);

/* Attaches a renderer that was initialised with &world->scene: after that it draws, before that
 * fxl_frame_begin answers FXL_E_CAPACITY. From fxl_frame_begin on until fxl_frame_end, or
 * fxl_frame_release_scene, the world refuses changes. A renderer that is initialised again must be
 * attached again; one that is moved, or ends before the world does, must be detached.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the renderer draws another scene.
 * FXL_E_CAPACITY: there are FXL_WORLD_RENDERERS_MAX others, or the renderer's order has no room
 * for the world's capacity.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_attach(fxl_world *world, fxl_renderer *renderer);

/* Detaches a renderer, ends its frame, and has fxl_frame_begin refuse the next.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_INDEX: it is not attached.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_detach(fxl_world *world, fxl_renderer *renderer);

/* Has an attached renderer draw instances in the colours that fxl_world_recolour gave them. The
 * renderer keeps the pointer; each renderer has a record of its own. The renderer must begin a
 * frame anew. colours null: it draws all in the colours of the models.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_INDEX: the renderer is not attached.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_set_colours(fxl_world *world, fxl_renderer *renderer,
                                 fxl_world_colours *colours);

/* The time of the functions below does not depend on the number of instances.
 *
 * An instance must lie within the world: |c| + r <= FXL_COORDINATE_MAX for each coordinate c of its
 * centre. r is its model's radius; if it has a placement, r is the radius times its scale, rounded
 * up to 1/65536 unit, and 32/65536 unit more. The instances that fxl_world_init took over may reach
 * beyond that; they are tested when they are moved, get a placement or get another model.
 *
 * If the scene has a BSP tree, its instance may be recoloured and changed in no other way. No other
 * instance may have its model, and none in its layer may have a sorted model. */

/* Adds an instance that is shown, and writes its handle. placement null: it has no placement. The
 * field recolour must be 0.
 * FXL_E_ARGUMENT: a null pointer, but for placement.
 * FXL_E_ORDER: a renderer that is attached draws a frame that was not released.
 * FXL_E_CAPACITY: there are as many as the memory has room for.
 * FXL_E_RESERVED: recolour is not 0.
 * FXL_E_INDEX: there is no such model.
 * FXL_E_RANGE: the instance would not lie within the world, or the scale is outside
 * FXL_SCALE_MIN..FXL_SCALE_MAX.
 * FXL_E_PLACEMENT: the orientation is no rotation.
 * FXL_E_BSP: the model is that of the BSP tree, or a sorted one in the tree's layer.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_spawn(fxl_world *world, const fxl_instance *instance,
                           const fxl_placement *placement, fxl_handle *handle);

/* Removes an instance. Its handle goes stale.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_STALE: the instance was removed.
 * FXL_E_ORDER: a renderer that is attached draws a frame that was not released.
 * FXL_E_BSP: it is the instance of the BSP tree.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_remove(fxl_world *world, fxl_handle handle);

/* fxl_world_hide takes an instance out of the picture, and fxl_world_show puts it back. A hidden
 * instance may be changed as others may. To hide a hidden instance, or to show a shown one, changes
 * nothing.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_STALE: the instance was removed.
 * FXL_E_ORDER: a renderer that is attached draws a frame that was not released.
 * FXL_E_BSP: it is the instance of the BSP tree.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_hide(fxl_world *world, fxl_handle handle);
fxl_status fxl_world_show(fxl_world *world, fxl_handle handle);

/* Moves the centre of an instance.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_STALE: the instance was removed.
 * FXL_E_ORDER: a renderer that is attached draws a frame that was not released.
 * FXL_E_RANGE: it would not lie within the world.
 * FXL_E_BSP: it is the instance of the BSP tree.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_move(fxl_world *world, fxl_handle handle, const fxl_point *centre);

/* Gives an instance a placement, which rotates and scales it. placement null: the instance loses
 * the one that it has.
 * FXL_E_ARGUMENT: world is null.
 * FXL_E_STALE: the instance was removed.
 * FXL_E_ORDER: a renderer that is attached draws a frame that was not released.
 * FXL_E_CAPACITY: it has none, and turned_capacity is used up; or it loses it, and capacity is.
 * FXL_E_RANGE: it would not lie within the world, or the scale is outside
 * FXL_SCALE_MIN..FXL_SCALE_MAX.
 * FXL_E_PLACEMENT: the orientation is no rotation.
 * FXL_E_BSP: it is the instance of the BSP tree.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_set_placement(fxl_world *world, fxl_handle handle,
                                   const fxl_placement *placement);

/* Gives an instance another model.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_STALE: the instance was removed.
 * FXL_E_ORDER: a renderer that is attached draws a frame that was not released.
 * FXL_E_INDEX: there is no such model.
 * FXL_E_RANGE: it would not lie within the world.
 * FXL_E_BSP: it is the instance of the BSP tree; or the model is the tree's, or a sorted one in the
 * tree's layer.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_set_model(fxl_world *world, fxl_handle handle, uint16_t model);

/* Puts an instance into another layer.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_STALE: the instance was removed.
 * FXL_E_ORDER: a renderer that is attached draws a frame that was not released.
 * FXL_E_BSP: it is the instance of the BSP tree, or has a sorted model and the layer is the tree's.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_set_layer(fxl_world *world, fxl_handle handle, uint8_t layer);

/* Gives an instance the colours of table number - 1; number 0: those of its model. A renderer shows
 * them if fxl_world_set_colours was called for it.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_STALE: the instance was removed.
 * FXL_E_ORDER: a renderer that is attached draws a frame that was not released.
 * FXL_E_INDEX: number is above colour_count.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_world_recolour(fxl_world *world, fxl_handle handle, uint32_t number);

/* Returns the handle of an instance that fxl_world_init took over, by its number in the scene that
 * fxl_world_init was given. It is stale if that instance was removed. Requires a number below that
 * scene's instance_count. fxl_world_handle_at takes the numbers of world->scene, which differ. */
fxl_handle fxl_world_handle(uint32_t number);

/* The handle of an instance that is shown, by its number in world->scene: that is how
 * fxl_pick_face, fxl_cast_segment and fxl_slide_sphere name what they find. The numbers hold until
 * the next change, which may give each instance another number. A number that world->scene does not
 * have, FXL_PICK_NONE and FXL_HIT_NONE among them, or a null pointer: a handle of zeros, which is
 * always stale. */
fxl_handle fxl_world_handle_at(const fxl_world *world, uint32_t instance);

/* An instance as it is. The pointer is valid until the next change; null: the handle is stale, or
 * world is null. */
const fxl_instance *fxl_world_instance(const fxl_world *world, fxl_handle handle);

/* Its placement, valid until the next change; null: it has none, the handle is stale, or world is
 * null. */
const fxl_placement *fxl_world_placement(const fxl_world *world, fxl_handle handle);

/* Whether it is shown. False if the handle is stale, or world is null. */
bool fxl_world_is_shown(const fxl_world *world, fxl_handle handle);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_world_reasons[];

#ifdef __cplusplus
}
#endif

#endif
