/* SPDX-License-Identifier: MIT */
/* What changed from one frame to the next. */
#include "fixel/changed.h"

#include "../math/memory.h"
#include "../scene/placement_code.h"
#include "../view/outcode.h"
#include "../view/placement.h"
#include "../view/project.h"
#include "../view/view.h"
#include "submit.h"

/* An instance that is turned, as it was. */
typedef struct {
    fxl_instance instance;
    fxl_placement placement;
} turned_record;

/* --- boxes ------------------------------------------------------------------------------ */

/* At most 2^20. */
static int32_t area_of(const fxl_screen_box *box)
{
    return box->columns * box->rows;
}

static uint16_t larger(uint32_t a, uint32_t b)
{
    return (uint16_t)(a > b ? a : b);
}

static fxl_screen_box box_about(const fxl_screen_box *a, const fxl_screen_box *b)
{
    fxl_screen_box both;
    both.first_column = a->first_column < b->first_column ? a->first_column : b->first_column;
    both.first_row = a->first_row < b->first_row ? a->first_row : b->first_row;
    both.columns = (uint16_t)(larger((uint32_t)a->first_column + a->columns,
                                     (uint32_t)b->first_column + b->columns) -
                              both.first_column);
    both.rows =
        (uint16_t)(larger((uint32_t)a->first_row + a->rows, (uint32_t)b->first_row + b->rows) -
                   both.first_row);
    return both;
}

/* Joins the two boxes that grow the least, and returns whether it did. Areas are at most 2^20. */
/* changed 3.1 */
static bool join_two(fxl_screen_box *boxes, uint32_t *count)
{
    int32_t least = *count > FXL_CHANGED_BOXES_MAX ? INT32_MAX : 1;
    uint32_t first = 0, second = 0;
    for (uint32_t i = 0; i < *count; i++) {
        for (uint32_t j = i + 1; j < *count; j++) {
            const fxl_screen_box both = box_about(&boxes[i], &boxes[j]);
            const int32_t growth = area_of(&both) - area_of(&boxes[i]) - area_of(&boxes[j]);
            if (growth < least) {
                least = growth;
                first = i;
                second = j;
            }
        }
    }
    if (first == second) {
        return false;
    }
    boxes[first] = box_about(&boxes[first], &boxes[second]);
    boxes[second] = boxes[--*count];
    return true;
}

/* changed 3.1 */
static void add_box(fxl_changed *changed, const fxl_screen_box *box)
{
    fxl_screen_box boxes[FXL_CHANGED_BOXES_MAX + 1];
    uint32_t count = changed->count;
    memcpy(boxes, changed->boxes, sizeof changed->boxes);
    boxes[count++] = *box;
    while (join_two(boxes, &count)) {
    }
    memcpy(changed->boxes, boxes, sizeof changed->boxes);
    changed->count = count;
}

static fxl_screen_box box_of_frame(const fxl_lens *lens)
{
    const fxl_screen_box all = {0, lens->width, 0, lens->height};
    return all;
}

/* --- the box of an instance ----------------------------------------------------------------- */

/* Points of the screen, and the least depth of one. */
typedef struct {
    fxl_screen_point least, most;
    fxl_q18_46 depth;
} extent;

static const extent no_extent = {{INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN}, INT64_MAX};

static void extend(extent *to, const fxl_screen_point *point)
{
    to->least.x = point->x < to->least.x ? point->x : to->least.x;
    to->least.y = point->y < to->least.y ? point->y : to->least.y;
    to->most.x = point->x > to->most.x ? point->x : to->most.x;
    to->most.y = point->y > to->most.y ? point->y : to->most.y;
}

/* How far a point that was rounded in the world may be from where the vertices of an instance are, in
 * units of 1/65536. Vertices, rounded in the view and in the world, are off by 1.5 each; a cut by a
 * beam's plane or a node's rounds once more: there are at most 32 and FXL_BSP_DEPTH_MAX of these. */
/* changed 2.1 */
static uint32_t rounding_of(const fxl_renderer *renderer)
{
    const uint32_t nodes = renderer->order_memory != NULL ? renderer->scene->bsp_node_count : 0;
    return (renderer->shader != NULL ? 40u : 4u) +
           (nodes < FXL_BSP_DEPTH_MAX ? nodes : FXL_BSP_DEPTH_MAX);
}

/* A margin of all coordinates that reaches every pixel. */
#define EVERYWHERE (2 * FXL_SCREEN_COORDINATE_MAX)

/* In units of 1/65536 pixel. Take a point of an instance that is drawn on the screen, `rounding` away
 * from where it is among the exact ones: on the screen that is at most
 * (focal + half the screen) rounding / (depth - rounding) away, and the 3 of 256 units are for the
 * quotient, the clipper and the projection. The factors of `moved` are at most 1063 and 8192 + 1024, so
 * it is below 2^24. */
/* changed 2.1 */
static fxl_q16_16 margin_of(const fxl_renderer *renderer, fxl_q18_46 depth)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    const uint32_t focal = (uint32_t)fxl_view_drawn_focal(&renderer->frame.view) >> 16;
    const uint32_t rounding = rounding_of(renderer), at = (uint32_t)(depth >> 30);
    const uint32_t moved = rounding * (focal + 1u + larger(lens->width, lens->height));
    if (at < 2u * rounding) {
        return EVERYWHERE;
    }
    const uint32_t margin = moved * 256u / (at - rounding) + 3u;
    return margin < FXL_SCREEN_MAX * 256u ? (fxl_q16_16)(margin * 256u) : EVERYWHERE;
}

/* How far lines over models reach beyond their ends: half of the largest width, which is 16 pixels,
 * and a pixel. */
/* changed 2.1 */
static fxl_q16_16 width_of_lines(const fxl_renderer *renderer)
{
    const fxl_shader *shader = renderer->shader;
    while (shader != NULL && shader->rank != FXL_SHADER_LINES) {
        shader = shader->next;
    }
    return shader != NULL ? 9 * 65536 : 0;
}

/* The pixels from a coordinate to another one, both included, of so many. False: there are none. */
static bool find_pixels(fxl_q16_16 least, fxl_q16_16 most, int32_t size, uint16_t *first,
                        uint16_t *count)
{
    const int32_t from = least < 0 ? 0 : least >> 16;
    const int32_t end = most >= size * 65536 ? size : (most >> 16) + 1;
    if (from >= end) {
        return false;
    }
    *first = (uint16_t)from;
    *count = (uint16_t)(end - from);
    return true;
}

/* The sum of a coordinate and a margin is at most three times FXL_SCREEN_COORDINATE_MAX: below 2^30. */
static bool box_of_extent(const fxl_lens *lens, const extent *of, fxl_q16_16 margin,
                          fxl_screen_box *box)
{
    return find_pixels(of->least.x - margin, of->most.x + margin, lens->width, &box->first_column,
                       &box->columns) &&
           find_pixels(of->least.y - margin, of->most.y + margin, lens->height, &box->first_row,
                       &box->rows);
}

/* Whether all vertices of a model are before the eye, on the screen or beside it: then *found holds
 * them. Those nearer than the near plane, or beyond the far one, are among them: what is between the
 * planes lies between the vertices. */
/* changed 2.1, 2.2 */
static bool find_vertices(const fxl_model_view *model_view, uint32_t count, extent *found)
{
    *found = no_extent;
    for (uint32_t i = 0; i < count; i++) {
        const fxl_cached_vertex *vertex = fxl_fetch_vertex(model_view, i);
        fxl_screen_point at;
        if (fxl_project_visible(&model_view->view->projection, &vertex->position, &at) != FXL_OK) {
            return false;
        }
        extend(found, &at);
        found->depth = vertex->position.z < found->depth ? vertex->position.z : found->depth;
    }
    return true;
}

/* False: the instance covers no pixel. */
/* changed 2.1, 2.2 */
static bool find_model_box(const fxl_renderer *renderer, const fxl_scene *scene, uint32_t number,
                           fxl_screen_box *box)
{
    FXL_ALIGN_8 fxl_turned_view view;
    fxl_vertex_cache cache;
    extent found;
    const fxl_view *seen = &renderer->frame.view;
    const fxl_instance *instance = &scene->instances[number];
    const fxl_model *model = &scene->models[instance->model];
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
    if (renderer->clipper != &fxl_clipper_view) {
        *box = box_of_frame(&seen->lens);
        return true;
    }
    const uint32_t planes = fxl_sphere_planes(&seen->camera, &seen->view_frustum, &instance->centre,
                                              fxl_instance_radius(scene, instance));
    if (planes == FXL_SPHERE_OUTSIDE) {
        return false;
    }
    memset(&cache, 0, sizeof cache);
    fxl_vertex_cache_init(&cache, NULL, 0);
    if (turned != NULL) {
        (void)turned->view(&view, scene, number, seen, &cache, planes);
    } else {
        fxl_model_view_of_instance(&view.model_view, scene, instance, seen, &cache);
        view.model_view.planes = (fxl_planes)planes;
    }
    if (!find_vertices(&view.model_view, model->vertex_count, &found)) {
        *box = box_of_frame(&seen->lens);
        return true;
    }
    return box_of_extent(&seen->lens, &found, margin_of(renderer, found.depth) + width_of_lines(renderer),
                         box);
}

/* changed 2.3 */
static bool find_billboard_box(const fxl_renderer *renderer, const fxl_scene *scene,
                               uint32_t number, const fxl_billboard *billboard, fxl_screen_box *box)
{
    const fxl_view *view = &renderer->frame.view;
    fxl_view_point centre;
    fxl_screen_point corners[2];
    extent found = no_extent;
    if (renderer->billboards->code->place(view, scene, number, billboard, &centre, corners) !=
        FXL_CLIP_INSIDE) {
        return false;
    }
    extend(&found, &corners[0]);
    extend(&found, &corners[1]);
    return box_of_extent(&view->lens, &found, 0, box);
}

static void add_instance(fxl_changed *changed, const fxl_renderer *renderer, const fxl_scene *scene,
                         uint32_t number, const fxl_billboard *billboard)
{
    fxl_screen_box box;
    if (billboard != NULL ? find_billboard_box(renderer, scene, number, billboard, &box)
                          : find_model_box(renderer, scene, number, &box)) {
        add_box(changed, &box);
    }
}

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
    add_instance(to->changed, to->renderer, &one, 0,
                 billboard_before(to->changed, instance->model));
}

/* changed 1.2 */
static void add_now(search *to, uint32_t number)
{
    const fxl_scene *scene = to->renderer->scene;
    const fxl_instance *instance = &scene->instances[number];
    to->cuts_others |= is_of_tree(to->renderer, instance);
    add_instance(to->changed, to->renderer, scene, number,
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
        changed->boxes[0] = box_of_frame(&renderer->frame.view.lens);
        changed->count = 1;
    }
    keep_frame(changed, renderer, unturned, turned);
    const fxl_screen_box all = box_of_frame(&changed->lens);
    changed->whole = changed->count == 1 && area_of(&changed->boxes[0]) == area_of(&all);
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
    add_box(changed, box);
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
            add_instance(changed, renderer, scene, number, billboard_now(renderer, model));
        }
    }
    return FXL_OK;
}

/* Moves the sides of some pixels outward, within so many. Below 2^11. */
static void widen(uint16_t *first, uint16_t *count, uint32_t step, uint32_t size)
{
    const uint32_t from = *first / step * step;
    const uint32_t end = ((uint32_t)*first + *count + step - 1u) / step * step;
    *first = (uint16_t)from;
    *count = (uint16_t)((end < size ? end : size) - from);
}

/* changed 3.2 */
fxl_status fxl_changed_widen(fxl_changed *changed, uint32_t columns, uint32_t rows)
{
    if (changed == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (changed->renderer == NULL) {
        return FXL_E_ORDER;
    }
    if (columns > 8 || (columns & (columns - 1u)) != 0 || rows == 0 || rows > 8 ||
        (rows & (rows - 1u)) != 0) {
        return FXL_E_RANGE;
    }
    const uint32_t width = changed->lens.width, count = changed->count;
    changed->count = 0;
    for (uint32_t i = 0; i < count; i++) {
        fxl_screen_box box = changed->boxes[i];
        widen(&box.first_column, &box.columns, columns != 0 ? columns : width, width);
        widen(&box.first_row, &box.rows, rows, changed->lens.height);
        add_box(changed, &box);
    }
    return FXL_OK;
}
