/* SPDX-License-Identifier: MIT */
/* The boxes of what changed: those of instances on the screen, and how they are joined. */
#include "../math/memory.h"
#include "../scene/lens.h"
#include "../scene/placement_code.h"
#include "../view/outcode.h"
#include "../view/placement.h"
#include "../view/project.h"
#include "../view/view.h"
#include "changed_boxes.h"

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
void fxl_changed_join(fxl_changed *changed, const fxl_screen_box *box)
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
 * it is below 2^24. With an orthographic lens, whose focal length is a scale of at most 4096, it is
 * rounding * scale away at every depth. */
/* changed 2.1, 2.4 */
static fxl_q16_16 margin_of(const fxl_renderer *renderer, fxl_q18_46 depth)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    const uint32_t focal = (uint32_t)fxl_view_drawn_focal(&renderer->frame.view) >> 16;
    const uint32_t rounding = rounding_of(renderer), at = (uint32_t)(depth >> 30);
    const uint32_t moved = rounding * (focal + 1u + larger(lens->width, lens->height));
    if (fxl_orthographic_of(lens) != NULL) {
        return (fxl_q16_16)(rounding * (((uint32_t)lens->focal >> 16) + 1u) + 3u * 256u);
    }
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

static bool project(const fxl_view *view, const fxl_view_point *point, fxl_screen_point *at)
{
    const fxl_orthographic_code *code = fxl_orthographic_of(&view->lens);
    return (code != NULL ? code->project(view, point, at)
                         : fxl_project_visible(&view->projection, point, at)) == FXL_OK;
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
        if (!project(model_view->view, &vertex->position, &at)) {
            return false;
        }
        extend(found, &at);
        found->depth = vertex->position.z < found->depth ? vertex->position.z : found->depth;
    }
    return true;
}

/* Whether the clipper is the default one of the lens, whose roundings margin_of knows. */
/* changed 2.2 */
static bool has_clipper_of_lens(const fxl_renderer *renderer)
{
    const fxl_orthographic_code *code = fxl_orthographic_of(&renderer->frame.view.lens);
    return code != NULL ? code->has_clipper(renderer) : renderer->clipper == &fxl_clipper_view;
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
    if (!has_clipper_of_lens(renderer)) {
        *box = fxl_box_of_frame(&seen->lens);
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
        *box = fxl_box_of_frame(&seen->lens);
        return true;
    }
    return box_of_extent(&seen->lens, &found,
                         margin_of(renderer, found.depth) + width_of_lines(renderer), box);
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

void fxl_changed_show(fxl_changed *changed, const fxl_renderer *renderer, const fxl_scene *scene,
                      uint32_t number, const fxl_billboard *billboard)
{
    fxl_screen_box box;
    if (billboard != NULL ? find_billboard_box(renderer, scene, number, billboard, &box)
                          : find_model_box(renderer, scene, number, &box)) {
        fxl_changed_join(changed, &box);
    }
}

/* --- whole columns and rows ------------------------------------------------------------- */

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
        fxl_changed_join(changed, &box);
    }
    return FXL_OK;
}
