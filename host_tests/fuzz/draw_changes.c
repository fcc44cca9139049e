/* SPDX-License-Identifier: MIT */
/* A world over any scene that is drawn by the boxes of what changed. What changes is chosen by chance. */
#include <stdlib.h>

#include "any_frame.h"

enum {
    MORE = 3, /* places beyond the scene's instances */
    CHANGES = 24,
    PLACES = 2 * (MADE_INSTANCES + MORE)
};

typedef struct {
    fxl_world world;
    fxl_instance instances[2 * PLACES];
    fxl_placement placements[PLACES];
    fxl_world_slot slots[2 * PLACES];
    uint8_t colours[2 * 256];
    fxl_world_colours recoloured;
} some_world;

static fxl_placement any_turn(void)
{
    fxl_camera camera;
    const fxl_pose pose = {.yaw = (fxl_angle)any(65536)};
    DEMAND(fxl_camera_from_pose(&pose, &camera) == FXL_OK);
    const fxl_placement placement = {{camera.axes.right, camera.axes.up, camera.axes.forward},
                                     (fxl_q16_16)(32768 + any(65536))};
    return placement;
}

static fxl_instance any_instance(const fxl_scene *scene, const fxl_view *view)
{
    const fxl_instance instance = {any_point(view), (uint16_t)any(scene->model_count),
                                   (uint8_t)any(3), 0};
    return instance;
}

static void change(some_world *of, const fxl_view *view)
{
    fxl_world *world = &of->world;
    const fxl_instance made = any_instance(&world->scene, view);
    const fxl_placement placement = any_turn();
    fxl_handle handle = world->scene.instance_count > 0
                            ? fxl_world_handle_at(world, any(world->scene.instance_count))
                            : fxl_world_handle(any(2 * PLACES));
    const fxl_instance *found = fxl_world_instance(world, handle);
    fxl_point centre = found != NULL ? found->centre : made.centre;
    fxl_q16_16 *const sides[] = {&centre.x, &centre.y, &centre.z};
    switch (any(12)) {
    case 0:
        (void)fxl_world_remove(world, handle);
        break;
    case 1:
        (void)fxl_world_hide(world, handle);
        break;
    case 2:
        (void)fxl_world_show(world, fxl_world_handle(any(2 * PLACES)));
        break;
    case 3:
        (void)fxl_world_move(world, handle, &made.centre);
        break;
    case 4:
        (void)fxl_world_set_placement(world, handle, one_in(4) ? NULL : &placement);
        break;
    case 5:
        (void)fxl_world_set_model(world, handle, made.model);
        break;
    case 6:
        (void)fxl_world_set_layer(world, handle, made.layer);
        break;
    case 7:
        (void)fxl_world_recolour(world, handle, any(3));
        break;
    case 8:
    case 9:
        (void)fxl_world_spawn(world, &made, one_in(2) ? &placement : NULL, &handle);
        break;
    default:
        *sides[any(3)] += (fxl_q16_16)any(65536) - 32768;
        (void)fxl_world_move(world, handle, &centre);
        break;
    }
}

/* Something of the frame, not of the world, changes; or nothing. */
static void change_frame(fxl_renderer *renderer, fxl_pose *pose)
{
    fxl_q16_16 *const sides[] = {&pose->position.x, &pose->position.y, &pose->position.z};
    switch (any(12)) {
    case 0:
        *sides[any(3)] ^= 1;
        break;
    case 1:
        pose->yaw = (fxl_angle)(pose->yaw ^ 64);
        break;
    case 2:
        pose->pitch = 0;
        break;
    case 3:
        renderer->frame.background ^= 1;
        break;
    case 4:
        (void)fxl_renderer_set_centre(renderer, renderer->frame.view.lens.centre_x + 65536,
                                      renderer->frame.view.lens.centre_y);
        break;
    case 5:
        (void)fxl_renderer_set_centre(renderer, renderer->frame.view.lens.centre_x,
                                      renderer->frame.view.lens.centre_y + 65536);
        break;
    default:
        break;
    }
}

/* Adds boxes that the program drew over, and a model; what is refused changes nothing. */
static void add_boxes(fxl_changed *changed, const fxl_renderer *renderer)
{
    static const fxl_renderer none;
    const fxl_lens *lens = &renderer->frame.view.lens;
    fxl_screen_box box = {(uint16_t)any(lens->width), 1, (uint16_t)any(lens->height), 1};
    fxl_changed before = *changed, empty;
    uint64_t memory[1];
    DEMAND(fxl_changed_init(NULL, memory, 8) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_init(&empty, NULL, 8) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_init(&empty, (uint8_t *)memory + 4, 4) == FXL_E_ALIGNMENT);
    DEMAND(fxl_changed_init(&empty, memory, 8) == FXL_OK);
    DEMAND(fxl_changed_find(&empty, &none) == FXL_E_ORDER);
    DEMAND(renderer->scene->instance_count == 0 ||
           fxl_changed_find(&empty, renderer) == FXL_E_CAPACITY);
    DEMAND(renderer->scene->instance_count == 0 || fxl_changed_add(&empty, &box) == FXL_E_ORDER);
    DEMAND(renderer->scene->instance_count == 0 || fxl_changed_widen(&empty, 1, 1) == FXL_E_ORDER);
    empty.memory = NULL;
    DEMAND(fxl_changed_find(&empty, renderer) == FXL_E_ORDER);
    DEMAND(fxl_changed_find(NULL, renderer) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_find(changed, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_add(NULL, &box) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_add(changed, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_widen(NULL, 1, 1) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_widen(changed, 3, 1) == FXL_E_RANGE);
    DEMAND(fxl_changed_widen(changed, 16, 1) == FXL_E_RANGE);
    DEMAND(fxl_changed_widen(changed, 1, 0) == FXL_E_RANGE);
    DEMAND(fxl_changed_widen(changed, 1, 16) == FXL_E_RANGE);
    DEMAND(fxl_changed_widen(changed, 1, 6) == FXL_E_RANGE);
    DEMAND(fxl_changed_add_model(NULL, renderer, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_add_model(changed, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_add_model(changed, &none, 0) == FXL_E_ORDER);
    DEMAND(fxl_changed_add_model(changed, renderer, UINT32_MAX) == FXL_E_INDEX);
    fxl_screen_box wrong[] = {box, box, box, box};
    wrong[0].columns = 0;
    wrong[1].rows = 0;
    wrong[2].columns = (uint16_t)(lens->width + 1);
    wrong[3].rows = (uint16_t)(lens->height + 1);
    DEMAND(fxl_changed_add(changed, &wrong[any(4)]) == FXL_E_RANGE);
    DEMAND(memcmp(&before, changed, sizeof before) == 0);
    if (one_in(2)) {
        box.columns = (uint16_t)(1 + any(lens->width - box.first_column));
        box.rows = (uint16_t)(1 + any(lens->height - box.first_row));
        DEMAND(fxl_changed_add(changed, &box) == FXL_OK);
    }
    if (one_in(3)) {
        DEMAND(fxl_changed_add_model(changed, renderer, any(renderer->scene->model_count)) ==
               FXL_OK);
    }
    if (one_in(2)) {
        DEMAND(fxl_changed_widen(changed, one_in(4) ? 0 : 1u << any(4), 1u << any(4)) == FXL_OK);
    }
}

/* The frame, whole; and over the frame before it, in the boxes. */
static void demand_boxes(fxl_renderer *renderer, fxl_changed *changed, const fxl_pose *pose, uint8_t *built,
                         uint8_t *pixels)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    const fxl_band band = draw_band(lens, pixels, 0, lens->height);
    const uint8_t background = renderer->frame.background;
    if (fxl_frame_begin(renderer, pose) != FXL_OK) {
        return;
    }
    DEMAND(fxl_changed_find(changed, renderer) == FXL_OK);
    add_boxes(changed, renderer);
    fxl_frame_fill(renderer, &band, background);
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    draw_changed_boxes(renderer, changed, built, background);
    DEMAND(memcmp(pixels, built, (size_t)lens->width * lens->height) == 0);
    if (one_in(8) && fxl_frame_release_scene(renderer) == FXL_OK) {
        DEMAND(fxl_changed_find(changed, renderer) == FXL_E_ORDER);
        DEMAND(fxl_changed_add_model(changed, renderer, 0) == FXL_E_ORDER);
    }
    DEMAND(fxl_frame_end(renderer) == FXL_OK);
}

/* A sprite for each model, or for some, and what may change of it. */
typedef struct {
    fxl_sprite sprite;
    fxl_billboard billboard;
    uint16_t map[MADE_MODELS];
    fxl_billboard_set set;
    fxl_billboards attached;
} some_billboards;

static const uint8_t texels[2][16] = {{1, 0, 2, 3}, {3, 2, 1}};

/* As large as the radii of the models allow; none, where one allows none. */
static bool attach_billboards(fxl_renderer *renderer, some_billboards *made)
{
    memset(made, 0, sizeof *made);
    made->sprite = (fxl_sprite){.pixels = texels[0], .width = 4, .height = 4, .bits = 8};
    made->billboard.sprite = &made->sprite;
    for (uint32_t i = 0; i < MADE_MODELS; i++) {
        made->map[i] = (uint16_t)any(2);
    }
    made->set =
        (fxl_billboard_set){.billboards = &made->billboard, .model_map = made->map, .count = 1};
    for (fxl_q16_16 side = 1 << 24; side > 0; side /= 2) {
        made->billboard.width = made->billboard.height = side;
        made->billboard.anchor_x = made->billboard.anchor_y = side / 2;
        if (fxl_attach_billboards(renderer, &made->attached, &made->set,
                                  FXL_SPRITES_OF(fxl_palette)) == FXL_OK) {
            return true;
        }
    }
    return false;
}

/* A change that the check allows. */
static void change_billboards(const fxl_renderer *renderer, some_billboards *made)
{
    const some_billboards before = *made;
    switch (any(9)) {
    case 0:
        made->sprite.pixels = texels[any(2)];
        break;
    case 1:
        made->sprite.width = (uint16_t)(made->sprite.width ^ 6u);
        break;
    case 2:
        made->sprite.height = (uint16_t)(made->sprite.height ^ 6u);
        break;
    case 3:
        made->billboard.width ^= 1;
        break;
    case 4:
        made->billboard.height ^= 1;
        break;
    case 5:
        made->billboard.anchor_x ^= 1;
        break;
    case 6:
        made->billboard.anchor_y ^= 1;
        break;
    default:
        made->map[any(MADE_MODELS)] ^= 1u;
        break;
    }
    if (fxl_billboards_check(&made->set, renderer->scene, NULL) != FXL_OK) {
        *made = before;
    }
}

/* What a world is drawn with. */
typedef struct {
    fxl_renderer renderer;
    draw_room room;
    some_lines lines;
    some_world placed;
    some_billboards billboards;
} some_frame;

static void draw_kind(some_frame *of, const fxl_scene *scene, const fxl_lens *lens,
                      const fxl_pose *first, uint32_t kind)
{
    static uint64_t kept[FXL_CHANGED_MEMORY(2 * PLACES, PLACES, MADE_MODELS, 4)];
    some_world *placed = &of->placed;
    const size_t size = (size_t)lens->width * lens->height;
    uint8_t *built = draw_memory(size), *pixels = draw_memory(size);
    fxl_pose pose = *first;
    fxl_changed changed;
    memset(placed, 0, sizeof *placed);
    for (uint32_t i = 0; i < sizeof placed->colours; i++) {
        placed->colours[i] = (uint8_t)(i * 7);
    }
    const fxl_world_memory memory = {placed->instances,
                                     placed->slots,
                                     placed->placements,
                                     scene->instance_count + MORE,
                                     MADE_INSTANCES + MORE,
                                     placed->colours,
                                     2,
                                     &fxl_turned_instances};
    if (fxl_world_init(&placed->world, scene, &memory) == FXL_OK) {
        const fxl_order *tree = scene->bsp_nodes != NULL && kind % 4 == 0 ? &fxl_by_tree : NULL;
        draw_init(&of->renderer, &of->room, &placed->world.scene, lens);
        draw_choose_in(&of->renderer, &of->room, tree,
                       kind % 2 ? &fxl_palette_depth_16 : &fxl_palette);
        if (kind == 3) {
            DEMAND(fxl_renderer_set_orthographic(&of->renderer, any_scale()) == FXL_OK);
        }
        DEMAND(fxl_world_attach(&placed->world, &of->renderer) == FXL_OK);
        if (kind == 1) {
            make_lines(&of->lines, scene);
            DEMAND(fxl_attach_lines(&of->renderer, &of->lines.attached, &of->lines.set) == FXL_OK);
        }
        const bool has_billboards = kind == 2 && attach_billboards(&of->renderer, &of->billboards);
        DEMAND(fxl_changed_init(&changed, kept, sizeof kept) == FXL_OK);
        for (uint32_t i = 0; i < CHANGES; i++) {
            demand_boxes(&of->renderer, &changed, &pose, built, pixels);
            for (uint32_t k = any(3); k > 0; k--) {
                change(placed, &of->renderer.frame.view);
            }
            if (has_billboards && one_in(2)) {
                change_billboards(&of->renderer, &of->billboards);
            }
            if (one_in(3)) {
                change_frame(&of->renderer, &pose);
            }
        }
    }
    free(built);
    free(pixels);
}

void draw_changes(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose)
{
    static some_frame frame;
    draw_open_room(&frame.room, scene, lens, 2 * PLACES);
    for (uint32_t kind = 0; kind < 4; kind++) {
        draw_kind(&frame, scene, lens, pose, kind);
    }
    draw_close_room(&frame.room);
}
