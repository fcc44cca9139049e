/* SPDX-License-Identifier: MIT */
/* The order by distance that draws billboards: its traversal takes the instances in their order,
 * and submits a rectangle of the screen for an instance whose model has a billboard. The order by
 * tree calls the same for the billboards that come to it. */
#include "../math/arith.h"
#include "../math/memory.h"
#include "../paint/billboard_paint.h"
#include "../paint/billboard_walk.h"
#include "../scene/lens.h"
#include "../scene/placement_code.h"
#include "../view/model_view.h"
#include "../view/project.h"
#include "../view/view.h"
#include "display_list.h"
#include "fixel/billboards.h"
#include "renderer.h"
#include "submit_instance.h"
#include "surface_polygon.h"

/* --- submission ------------------------------------------------------------------------- */

/* A length of a billboard, by the scale of its instance. Both are at least 0; the product is that
 * of a length within the radius, which the scale leaves within FXL_COORDINATE_MAX, so it is below
 * 2^29 2^16, or of a side, below twice as much. Exact. */
static fxl_q18_46 scaled(fxl_q16_16 length, fxl_q16_16 scale)
{
    return (int64_t)fxl_multiply_u32((uint32_t)length, (uint32_t)scale) << 14;
}

/* A length along right or up, in the view. The rows of a sheared view are shorter, by the ratio of
 * the focal lengths (SPEC.md, section 4.2), which is rounded to 2^-30; the rest of the product is
 * cut off: a unit of 2^-46. The focal lengths are below 2^29 and the length below 2^60, so the
 * products are below 2^59 and 2^62. */
/* billboards 2.1 */
static fxl_q18_46 in_view(const fxl_view *view, fxl_q18_46 length)
{
    const fxl_q16_16 focal = view->lens.focal, drawn = fxl_view_drawn_focal(view);
    if (focal == drawn || fxl_orthographic_of(&view->lens) != NULL) {
        return length;
    }
    const int32_t ratio = fxl_divide_round((int64_t)focal * FXL_Q2_30_ONE, (uint32_t)drawn);
    return fxl_multiply_s32(ratio, (int32_t)(length >> 32)) * 4 +
           (int64_t)(fxl_multiply_u32((uint32_t)ratio, (uint32_t)length) >> 30);
}

/* fxl_projector of a lens with an eye. */
static fxl_status project_by_eye(const fxl_view *view, const fxl_view_point *point,
                                 fxl_screen_point *screen)
{
    return fxl_project_visible(&view->projection, point, screen);
}

/* Left and top, right and bottom. False where a corner is out of the range of screen coordinates.
 * A coordinate of the view is below 2^61, a side below 2^60: sums are below 2^62. */
/* billboards 2.1, orthographic 2.8 */
static bool find_corners(const fxl_view *view, const fxl_view_point *centre,
                         const fxl_billboard *billboard, fxl_q16_16 scale,
                         fxl_screen_point *corners)
{
    const fxl_orthographic_code *code = fxl_orthographic_of(&view->lens);
    fxl_projector *project = code != NULL ? code->project : project_by_eye;
    const int64_t limit = ((int64_t)1 << 61) - 1; /* of what is projected */
    fxl_view_point left_top, right_bottom;
    left_top.x = centre->x - in_view(view, scaled(billboard->anchor_x, scale));
    right_bottom.x = left_top.x + in_view(view, scaled(billboard->width, scale));
    right_bottom.y = centre->y - in_view(view, scaled(billboard->anchor_y, scale));
    left_top.y = right_bottom.y + in_view(view, scaled(billboard->height, scale));
    left_top.z = right_bottom.z = centre->z;
    return fxl_within(left_top.x, limit) && fxl_within(left_top.y, limit) &&
           fxl_within(right_bottom.x, limit) && fxl_within(right_bottom.y, limit) &&
           project(view, &left_top, &corners[0]) == FXL_OK &&
           project(view, &right_bottom, &corners[1]) == FXL_OK;
}

/* billboards 2.2 */
static bool is_beside_screen(const fxl_lens *lens, const fxl_screen_point *corners)
{
    return corners[1].x <= 0 || corners[0].x >= lens->width * 65536 || corners[1].y <= 0 ||
           corners[0].y >= lens->height * 65536;
}

/* Into the display list or into the band. One that reaches no row goes nowhere. */
/* billboards 4.1 */
static fxl_outcome emit(const fxl_traversal *traversal, uint32_t model,
                        const fxl_screen_point *corners, fxl_q18_46 distance)
{
    const fxl_sprite_painter *painter = traversal->renderer->billboards->painter;
    const fxl_rows rows = fxl_pixels_between(corners[0].y, corners[1].y, 0,
                                             traversal->renderer->frame.view.lens.height);
    if (rows.first == rows.end) {
        return 0;
    }
    fxl_screen_polygon *screen = &traversal->workspace->screen;
    screen->count = painter->points;
    screen->kind = FXL_POLYGON_SPRITE;
    screen->points[0] = corners[0];
    screen->points[1] = corners[1];
    screen->points[2].x = (int32_t)model;
    screen->points[2].y = 0;
    screen->points[3].x = (int32_t)(distance >> 32);
    screen->points[3].y = (int32_t)(uint32_t)(uint64_t)distance;
    fxl_outcome outcome = FXL_OUTCOME_SPILLED;
    if (traversal->display_list == NULL) {
        painter->paint(traversal->renderer, traversal->workspace, screen->points, traversal->band);
    } else {
        outcome =
            fxl_display_list_append(traversal->display_list, screen, rows) ? 0 : FXL_OUTCOME_FULL;
    }
    screen->kind = FXL_POLYGON_FLAT;
    return outcome;
}

/* fxl_billboard_code.place: what becomes of an instance that shows a billboard, where its centre is
 * in the view, and its corners on the screen. */
/* billboards 2.2, 2.3 */
static fxl_clip_result place(const fxl_view *view, const fxl_scene *scene, uint32_t number,
                             const fxl_billboard *billboard, fxl_view_point *centre,
                             fxl_screen_point *corners)
{
    const fxl_q16_16 scale = fxl_placement_code_of(scene, number) != NULL
                                 ? fxl_placement_of(scene, number)->scale
                                 : 65536;
    fxl_transform_point(&view->camera, &scene->instances[number].centre, centre);
    if (centre->z < view->view_frustum.near_z || centre->z > view->view_frustum.far_z) {
        return FXL_CLIP_OUTSIDE;
    }
    if (!find_corners(view, centre, billboard, scale, corners)) {
        return FXL_CLIP_RANGE;
    }
    return is_beside_screen(&view->lens, corners) ? FXL_CLIP_OUTSIDE : FXL_CLIP_INSIDE;
}

FXL_COLD static fxl_outcome submit_sprite(const fxl_traversal *traversal, uint32_t number, uint32_t model,
                                 const fxl_billboard *billboard)
{
    fxl_view_point centre;
    fxl_screen_point corners[2];
    const fxl_view *view = &traversal->renderer->frame.view;
    const fxl_clip_result result =
        place(view, traversal->renderer->scene, number, billboard, &centre, corners);
    if (result != FXL_CLIP_INSIDE) {
        return 1u << result;
    }
    const fxl_orthographic_code *code = fxl_orthographic_of(&view->lens);
    return 1u << FXL_CLIP_INSIDE |
           emit(traversal, model, corners,
                code != NULL ? code->distance_of(view, centre.z) : centre.z);
}

/* fxl_instance_submit. The one face of a model with a billboard is done or not. */
static bool submit_by(const fxl_traversal *traversal, const fxl_draw_entry *entry,
                             fxl_instance_submit *submit_faces)
{
    const fxl_billboard_set *set = traversal->renderer->billboards->set;
    const uint32_t model = traversal->renderer->scene->instances[entry->index].model;
    const uint32_t number = set->model_map[model];
    if (number == 0) {
        return submit_faces(traversal, entry);
    }
    const uint32_t used = traversal->renderer->frame.display_list.used;
    const fxl_outcome outcome =
        submit_sprite(traversal, entry->index, model, &set->billboards[number - 1]);
    if (!fxl_count_outcome(traversal, outcome, used)) {
        return false;
    }
    traversal->counters->in += 1;
    return true;
}

static bool submit_any(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    return submit_by(traversal, entry, fxl_submit_any_instance);
}

static bool submit(const fxl_traversal *traversal)
{
    const fxl_scene *scene = traversal->renderer->scene;
    if (traversal->display_list != NULL && scene->placements != NULL) {
        traversal->counters->rounded =
            (uint16_t)scene->placement_code->count_rounded(traversal, 0, 0);
    }
    return fxl_submit_all(traversal, traversal->renderer->billboards->code->instance);
}

static const fxl_billboard_code with_eye = {submit, submit_any, place, &fxl_by_distance_with_billboards};
const fxl_order fxl_by_distance_with_billboards = {.submit = submit};

static const fxl_orthographic_code *orthographic_of(const fxl_renderer *renderer)
{
    return fxl_orthographic_of(&renderer->frame.view.lens);
}

static bool submit_any_flat(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    return submit_by(traversal, entry, orthographic_of(traversal->renderer)->submit);
}

static bool submit_flat(const fxl_traversal *traversal)
{
    orthographic_of(traversal->renderer)->begin(traversal);
    return fxl_submit_all(traversal, traversal->renderer->billboards->code->instance);
}

/* Those of an orthographic lens. */
static const fxl_order by_depth = {.submit = submit_flat};
static const fxl_billboard_code without_eye = {submit_flat, submit_any_flat, place, &by_depth};

/* --- attaching -------------------------------------------------------------------------- */

/* combinations 1.1 */
static fxl_status check(const fxl_renderer *renderer, const fxl_billboards *billboards,
                        const fxl_billboard_set *set, const fxl_sprite_painter *painter)
{
    if (renderer->scene == NULL) {
        return FXL_E_ORDER;
    }
    if (set == NULL) {
        return FXL_OK;
    }
    if (billboards == NULL || painter == NULL) {
        return FXL_E_ARGUMENT;
    }
    return !fxl_is_aligned(billboards, FXL_POINTER)
               ? FXL_E_ALIGNMENT
               : fxl_billboards_check(set, renderer->scene, NULL);
}

/* The order with billboards stands in the place of that without. */
/* combinations 1.4 */
static void change_order(fxl_renderer *renderer, const fxl_order *from, const fxl_order *to)
{
    if (renderer->order == from) {
        renderer->order = to;
    }
}

/* billboards 4.4 */
fxl_status fxl_attach_billboards(fxl_renderer *renderer, fxl_billboards *billboards,
                                 const fxl_billboard_set *set, const fxl_sprite_painter *painter)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = check(renderer, billboards, set, painter);
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    const fxl_orthographic_code *flat = orthographic_of(renderer);
    const fxl_order *without = flat != NULL ? flat->order : &fxl_by_distance;
    const fxl_order *with = flat != NULL ? &by_depth : &fxl_by_distance_with_billboards;
    if (set != NULL) {
        billboards->set = set;
        billboards->painter = painter;
        billboards->code = flat != NULL ? &without_eye : &with_eye;
        renderer->billboards = billboards;
        renderer->draw_display_list = fxl_mixed_draw_list;
        change_order(renderer, without, with);
    } else if (renderer->billboards == NULL) {
        return FXL_OK; /* a frame that has begun stays */
    } else {
        renderer->billboards = NULL;
        change_order(renderer, with, without);
    }
    renderer->check = fxl_check_combination;
    fxl_view_count_change(&renderer->frame.view);
    renderer->frame.state = FXL_FRAME_NONE;
    return FXL_OK;
}
