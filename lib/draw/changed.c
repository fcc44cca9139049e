/* SPDX-License-Identifier: MIT */
/* What changed from one frame to the next: what is kept of the frame before, and compared. */
#include "../math/memory.h"
#include "../scene/placement_code.h"
#include "changed_boxes.h"

/* An instance that is turned, as it was. */
typedef struct {
    fxl_instance instance;
    fxl_placement placement;
} turned_record;

/* --- what is kept ----------------------------------------------------------------------- */

static bool is_same_direction(const fxl_direction *a, const fxl_direction *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

static bool is_same_point(const fxl_point *a, const fxl_point *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

static bool is_same_placement(const fxl_placement *a, const fxl_placement *b)
{
    return a->scale == b->scale && is_same_direction(&a->orientation.x, &b->orientation.x) &&
           is_same_direction(&a->orientation.y, &b->orientation.y) &&
           is_same_direction(&a->orientation.z, &b->orientation.z);
}

static bool is_same_instance(const fxl_instance *a, const fxl_instance *b)
{
    return is_same_point(&a->centre, &b->centre) && a->model == b->model && a->layer == b->layer &&
           a->recolour == b->recolour;
}

static bool is_same_camera(const fxl_camera *a, const fxl_camera *b)
{
    return is_same_point(&a->position, &b->position) &&
           is_same_direction(&a->axes.right, &b->axes.right) &&
           is_same_direction(&a->axes.up, &b->axes.up) &&
           is_same_direction(&a->axes.forward, &b->axes.forward);
}

static bool is_same_lens(const fxl_lens *a, const fxl_lens *b)
{
    return a->width == b->width && a->height == b->height && a->focal == b->focal &&
           a->near_z == b->near_z && a->far_z == b->far_z && a->inset == b->inset &&
           a->centre_x == b->centre_x && a->centre_y == b->centre_y &&
           a->off_centre == b->off_centre;
}

static bool is_same_billboard(const fxl_kept_billboard *kept, const fxl_billboard *now)
{
    const fxl_billboard *a = &kept->billboard;
    const fxl_sprite *b = &kept->sprite, *sprite = now->sprite;
    return a->sprite == sprite && a->width == now->width && a->height == now->height &&
           a->anchor_x == now->anchor_x && a->anchor_y == now->anchor_y &&
           b->pixels == sprite->pixels && b->colours == sprite->colours &&
           b->width == sprite->width && b->height == sprite->height && b->bits == sprite->bits &&
           b->key == sprite->key;
}

/* The parts of the caller's memory: of each billboard, of each model, of instances that are not turned
 * from the first on, and of those that are from the last one. */
static fxl_kept_billboard *kept_billboards(const fxl_changed *changed)
{
    return (fxl_kept_billboard *)(void *)changed->memory;
}

/* Of so many billboards and models. Each is below 2^16. */
static size_t billboard_bytes(uint32_t billboards, uint32_t models)
{
    return (billboards * sizeof(fxl_kept_billboard) + 7u) / 8u * 8u + (models + 3u) / 4u * 8u;
}

static uint16_t *kept_map(const fxl_changed *changed)
{
    return (uint16_t *)(void *)(changed->memory + billboard_bytes(changed->billboards, 0));
}

static fxl_instance *kept_instance(const fxl_changed *changed, uint32_t number)
{
    return (fxl_instance *)(void *)(changed->memory +
                                    billboard_bytes(changed->billboards, changed->models)) +
           number;
}

static turned_record *kept_turned(const fxl_changed *changed, uint32_t number)
{
    return (turned_record *)(void *)(changed->memory + changed->memory_size / 8u * 8u) - 1 - number;
}

/* --- the frame before, and now ---------------------------------------------------------------- */

/* A frame's instances by their places: of those that are not turned, and of those that are. In a
 * world the former grow downward from the first that is turned (lib/game/world_place.h). */
static uint32_t number_of_place(const fxl_scene *scene, bool turned, uint32_t place)
{
    const uint32_t first_turned = fxl_first_turned(scene);
    if (turned) {
        return first_turned + place;
    }
    return scene->instance_capacity > 0 ? first_turned - 1u - place : place;
}

/* The billboard that the instances of a model show now, and showed; null: none. */
static const fxl_billboard *billboard_now(const fxl_renderer *renderer, uint32_t model)
{
    const fxl_billboard_set *set = renderer->billboards != NULL ? renderer->billboards->set : NULL;
    const uint32_t number = set != NULL ? set->model_map[model] : 0;
    return number != 0 ? &set->billboards[number - 1u] : NULL;
}

static const fxl_billboard *billboard_before(const fxl_changed *changed, uint32_t model)
{
    const uint32_t number = changed->set != NULL ? kept_map(changed)[model] : 0;
    return number != 0 ? &kept_billboards(changed)[number - 1u].billboard : NULL;
}

/* Whether the instances of a model show what they showed. */
/* changed 1.2 */
static bool shows_the_same(const fxl_changed *changed, const fxl_renderer *renderer, uint32_t model)
{
    if (changed->set == NULL) {
        return true;
    }
    const uint32_t number = changed->set->model_map[model];
    return number == kept_map(changed)[model] &&
           (number == 0 || is_same_billboard(&kept_billboards(changed)[number - 1u],
                                             billboard_now(renderer, model)));
}

/* What is found of one place. */
typedef struct {
    fxl_changed *changed;
    const fxl_renderer *renderer;
    bool cuts_others; /* an instance of the tree's layer changed */
} search;

static bool is_of_tree(const fxl_renderer *renderer, const fxl_instance *instance)
{
    const fxl_scene *scene = renderer->scene;
    return renderer->order_memory != NULL && scene->bsp_nodes != NULL &&
           instance->layer == scene->instances[scene->bsp_instance].layer;
}

/* Adds the instance as it was. The scene of one instance has its tables. */
/* changed 1.2 */
static void add_before(search *to, const fxl_instance *instance, const fxl_placement *placement)
{
    fxl_scene one = *to->renderer->scene;
    one.instances = instance;
    one.instance_count = 1;
    one.placements = placement;
    one.first_turned = 0;
    to->cuts_others |= is_of_tree(to->renderer, instance);
    fxl_changed_show(to->changed, to->renderer, &one, 0,
                     billboard_before(to->changed, instance->model));
}

/* changed 1.2 */
static void add_now(search *to, uint32_t number)
{
    const fxl_scene *scene = to->renderer->scene;
    const fxl_instance *instance = &scene->instances[number];
    to->cuts_others |= is_of_tree(to->renderer, instance);
    fxl_changed_show(to->changed, to->renderer, scene, number,
                     billboard_now(to->renderer, instance->model));
}

/* changed 1.2 */
static void compare_places(search *to, bool turned, uint32_t before, uint32_t now)
{
    const fxl_scene *scene = to->renderer->scene;
    for (uint32_t place = 0; place < before || place < now; place++) {
        const turned_record *record = turned ? kept_turned(to->changed, place) : NULL;
        const fxl_instance *was = turned ? &record->instance : kept_instance(to->changed, place);
        const uint32_t number = number_of_place(scene, turned, place);
        if (place < before && place < now && is_same_instance(was, &scene->instances[number]) &&
            (!turned || is_same_placement(&record->placement, fxl_placement_of(scene, number))) &&
            shows_the_same(to->changed, to->renderer, was->model)) {
            continue;
        }
        if (place < before) {
            add_before(to, was, turned ? &record->placement : NULL);
        }
        if (place < now) {
            add_now(to, number);
        }
    }
}

/* changed 1.5 */
static void add_movers(search *to)
{
    const fxl_scene *scene = to->renderer->scene;
    for (uint32_t number = 0; to->cuts_others && number < scene->instance_count; number++) {
        if (number != scene->bsp_instance && is_of_tree(to->renderer, &scene->instances[number])) {
            add_now(to, number);
        }
    }
}

/* Whether nothing but instances may be different. */
/* changed 1.3 */
static bool is_comparable(const fxl_changed *changed, const fxl_renderer *renderer)
{
    const fxl_frame *frame = &renderer->frame;
    const fxl_billboard_set *set = renderer->billboards != NULL ? renderer->billboards->set : NULL;
    return changed->renderer == renderer && changed->scene == renderer->scene &&
           changed->frame != UINT32_MAX && frame->view.frame == changed->frame + 1u &&
           renderer->workspace.settings_number == changed->settings_number &&
           changed->settings_number != UINT32_MAX && frame->background == changed->background &&
           changed->set == set &&
           (set == NULL || (changed->billboards == set->count &&
                            changed->models == renderer->scene->model_count)) &&
           is_same_camera(&frame->view.camera, &changed->camera) &&
           is_same_lens(&frame->view.lens, &changed->lens);
}

/* Keeps what the next frame is compared with. */
/* changed 5.1 */
static void keep_frame(fxl_changed *changed, const fxl_renderer *renderer, uint32_t unturned,
                       uint32_t turned)
{
    const fxl_frame *frame = &renderer->frame;
    const fxl_scene *scene = renderer->scene;
    const fxl_billboard_set *set = renderer->billboards != NULL ? renderer->billboards->set : NULL;
    changed->renderer = renderer;
    changed->scene = scene;
    changed->set = set;
    changed->camera = frame->view.camera;
    changed->lens = frame->view.lens;
    changed->frame = frame->view.frame;
    changed->settings_number = renderer->workspace.settings_number;
    changed->background = frame->background;
    changed->unturned = unturned;
    changed->turned = turned;
    changed->models = set != NULL ? scene->model_count : 0;
    changed->billboards = set != NULL ? set->count : 0;
    for (uint32_t i = 0; i < changed->billboards; i++) {
        fxl_kept_billboard *kept = &kept_billboards(changed)[i];
        kept->billboard = set->billboards[i];
        kept->sprite = *set->billboards[i].sprite;
    }
    if (set != NULL) {
        memcpy(kept_map(changed), set->model_map, changed->models * sizeof(uint16_t));
    }
    for (uint32_t place = 0; place < unturned; place++) {
        *kept_instance(changed, place) = scene->instances[number_of_place(scene, false, place)];
    }
    for (uint32_t place = 0; place < turned; place++) {
        const uint32_t number = number_of_place(scene, true, place);
        turned_record *record = kept_turned(changed, place);
        record->instance = scene->instances[number];
        record->placement = *fxl_placement_of(scene, number);
    }
}

/* --- the functions ------------------------------------------------------------------------ */

fxl_status fxl_changed_init(fxl_changed *changed, void *memory, size_t memory_size)
{
    if (changed == NULL || memory == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_is_aligned(memory, 8)) {
        return FXL_E_ALIGNMENT;
    }
    memset(changed, 0, sizeof *changed);
    changed->memory = (uint8_t *)memory;
    changed->memory_size = memory_size;
    return FXL_OK;
}

/* The records of all are below 2^16 (16 + 56) and 2^16 (2 + 64) bytes. */
/* changed 1.1, 1.3, 5.3 */
fxl_status fxl_changed_find(fxl_changed *changed, const fxl_renderer *renderer)
{
    if (changed == NULL || renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (changed->memory == NULL || renderer->frame.state == FXL_FRAME_NONE ||
        renderer->frame.state == FXL_FRAME_RELEASED) {
        return FXL_E_ORDER;
    }
    const fxl_scene *scene = renderer->scene;
    const fxl_billboard_set *set = renderer->billboards != NULL ? renderer->billboards->set : NULL;
    const uint32_t unturned = fxl_first_turned(scene), turned = scene->instance_count - unturned;
    if (changed->memory_size / 8u * 8u <
        unturned * sizeof(fxl_instance) + turned * sizeof(turned_record) +
            (set != NULL ? billboard_bytes(set->count, scene->model_count) : 0)) {
        return FXL_E_CAPACITY;
    }
    changed->count = 0;
    if (is_comparable(changed, renderer)) {
        search to = {changed, renderer, false};
        compare_places(&to, false, changed->unturned, unturned);
        compare_places(&to, true, changed->turned, turned);
        add_movers(&to);
    } else {
        changed->boxes[0] = fxl_box_of_frame(&renderer->frame.view.lens);
        changed->count = 1;
    }
    keep_frame(changed, renderer, unturned, turned);
    changed->whole = changed->count == 1 && changed->boxes[0].columns == changed->lens.width &&
                     changed->boxes[0].rows == changed->lens.height;
    return FXL_OK;
}

/* changed 1.4 */
fxl_status fxl_changed_add(fxl_changed *changed, const fxl_screen_box *box)
{
    if (changed == NULL || box == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (changed->renderer == NULL) {
        return FXL_E_ORDER;
    }
    if (box->columns == 0 || box->rows == 0 ||
        (uint32_t)box->first_column + box->columns > changed->lens.width ||
        (uint32_t)box->first_row + box->rows > changed->lens.height) {
        return FXL_E_RANGE;
    }
    fxl_changed_join(changed, box);
    return FXL_OK;
}

/* changed 1.4 */
fxl_status fxl_changed_add_model(fxl_changed *changed, const fxl_renderer *renderer, uint32_t model)
{
    if (changed == NULL || renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (changed->renderer != renderer || renderer->frame.state == FXL_FRAME_NONE ||
        renderer->frame.state == FXL_FRAME_RELEASED ||
        renderer->frame.view.frame != changed->frame) {
        return FXL_E_ORDER;
    }
    const fxl_scene *scene = renderer->scene;
    if (model >= scene->model_count) {
        return FXL_E_INDEX;
    }
    for (uint32_t number = 0; number < scene->instance_count; number++) {
        if (scene->instances[number].model == model) {
            fxl_changed_show(changed, renderer, scene, number, billboard_now(renderer, model));
        }
    }
    return FXL_OK;
}
