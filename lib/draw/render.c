/* SPDX-License-Identifier: MIT */
/* The pipeline on one page.
 *
 *   fxl_frame_begin   camera -> cull and sort the instances ->
 *                     for each face: transform -> clip -> project -> append to the display list
 *   fxl_frame_draw    for each polygon of the display list: scan -> fill;
 *                     then, where the list was full, every face that is left:
 *                     transform -> clip -> project -> scan -> fill
 *
 * The clipper transforms, clips and projects (fxl_clipper.clip), the order gives the faces
 * (fxl_order.submit), and the target scans and fills (fxl_target.flat). A flat face meets two
 * indirect calls on its way: the clipper's and the target's. */
#include "../math/arith.h"
#include "../math/memory.h"
#include "../raster/columns.h"
#include "../raster/draw_outline.h"
#include "../raster/scan.h"
#include "../view/order.h"
#include "../view/view.h"
#include "display_list.h"
#include "submit.h"
#include "renderer.h"
#include "submit_sorted.h"

/* --- begin ---------------------------------------------------------------------------- */

/* Resets the counters for a frame; culled: the faces of the instances that were culled. */
/* SPEC 4.11 */
static void begin_counters(fxl_counters *counters, uint32_t culled)
{
    uint32_t refused_calls = counters->refused_calls;
    memset(counters, 0, sizeof *counters);
    counters->refused_calls = refused_calls;
    counters->in = culled;
    counters->outside = culled;
}

/* Whether bands that pass over what does not reach them are worth a traversal more. Without a
 * display list the frame is drawn in one band, or in few. */
static bool measures_rows(const fxl_renderer *renderer)
{
    return !FXL_IS_SMALL && renderer->frame.display_list.capacity > 0 &&
           renderer->order == &fxl_by_distance;
}

/* How faces are submitted while a frame begins. */
static inline fxl_submit_mode mode_of_begin(const fxl_renderer *renderer)
{
    return FXL_IS_COMPACT || renderer->clipper->next != NULL ? FXL_SUBMIT_ANY : FXL_SUBMIT_APPEND;
}

/* find_visible for a scene without placements. */
static fxl_status look_at_still(fxl_renderer *renderer, const fxl_pose *pose, uint32_t *culled)
{
    fxl_frame *frame = &renderer->frame;
    const fxl_status status = fxl_view_set_pose(&frame->view, pose);
    if (status != FXL_OK) {
        return status;
    }
    if (!FXL_IS_SMALL) {
        fxl_extents_take_back(renderer, &renderer->workspace);
    }
    frame->visible_count = (uint16_t)fxl_list_still_instances(
        renderer->scene, &frame->view.camera, &frame->view.view_frustum, frame->draw_list, culled);
    return FXL_OK;
}

/* What goes together, the camera, and the order of the instances in sight; culled: the faces of the
 * others. The code of placements tests the order's room itself, because it ends the frame before.
 */
static fxl_status find_visible(fxl_renderer *renderer, const fxl_pose *pose, uint32_t *culled)
{
    const fxl_scene *scene = renderer->scene;
    if (renderer->clipper == NULL || renderer->target == NULL) {
        return FXL_E_ORDER;
    }
    if (renderer->check != NULL) {
        const fxl_status status = renderer->check(renderer);
        if (status != FXL_OK) {
            return status;
        }
    }
    if (scene->placements != NULL) {
        if (scene->placement_code == NULL) {
            return FXL_E_ORDER;
        }
        return scene->placement_code->find_visible(renderer, pose, culled);
    }
    if (scene->instance_count > renderer->instance_capacity) {
        return FXL_E_CAPACITY;
    }
    return look_at_still(renderer, pose, culled);
}

/* SPEC 4.1 */
fxl_status fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_frame *frame = &renderer->frame;
    fxl_workspace *workspace = &renderer->workspace;
    uint32_t culled;
    const fxl_status status = find_visible(renderer, pose, &culled);
    if (status != FXL_OK) {
        return fxl_refuse(workspace, status);
    }
    if (renderer->clipper->begin != NULL) {
        renderer->clipper->begin(&frame->view);
    }
    begin_counters(&workspace->counters, culled);
    fxl_workspace_begin(workspace, false);
    /* for each face: transform, clip, project, append */
    frame->display_list.used = 0;
    frame->resume.instances = 0;
    frame->resume.faces = 0;
    fxl_traversal traversal = fxl_traversal_of(renderer, workspace, &frame->resume);
    traversal.display_list = &frame->display_list;
    traversal.mode = mode_of_begin(renderer);
    frame->state = FXL_FRAME_BEGUN;
    if (!renderer->order->submit(&traversal) && measures_rows(renderer)) {
        fxl_extents_measure(&traversal, frame);
        workspace->rest_counted = true;
    }
    return FXL_OK;
}

/* --- a face ----------------------------------------------------------------------------- */

/* Where the polygon on the screen goes: to the end of the display list, or into the band. One
 * that reaches no row goes nowhere. */
/* SPEC 7.3 */
static fxl_outcome emit(const fxl_traversal *traversal)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_screen_polygon *screen = &workspace->screen;
    fxl_rows rows = fxl_scan_rows(screen, traversal->renderer->frame.view.lens.height);
    if (rows.first == rows.end) {
        return 0;
    }
    if (traversal->display_list != NULL) {
        return fxl_display_list_append(traversal->display_list, screen, rows) ? 0
                                                                              : FXL_OUTCOME_FULL;
    }
    if (!FXL_IS_SMALL && traversal->mode == FXL_SUBMIT_MEASURE) {
        fxl_rows_add(traversal->reached, rows);
        return FXL_OUTCOME_SPILLED;
    }
    const fxl_target *target = traversal->renderer->target;
    return target->flat(workspace, screen, traversal->band) || target->draws_over
               ? FXL_OUTCOME_SPILLED
               : FXL_OUTCOME_FULL;
}

/* Delivers all polygons of a face; cut is what the clipper answered for the first. */
/* SPEC 7.3 */
static fxl_outcome emit_all(const fxl_traversal *traversal, const fxl_model_view *model_view,
                            fxl_clip_result cut)
{
    fxl_outcome outcome = (fxl_outcome)1 << cut;
    while (cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT) {
        outcome |= emit(traversal);
        if (traversal->clipper->next == NULL || outcome >= FXL_OUTCOME_FULL) {
            break;
        }
        cut = fxl_next_polygon(model_view, traversal);
        outcome |= (fxl_outcome)1 << cut;
    }
    return outcome;
}

fxl_outcome fxl_submit_polygons(const fxl_model_view *model_view, const fxl_face *face,
                                const fxl_traversal *traversal)
{
    return emit_all(traversal, model_view, fxl_first_polygon(model_view, face, traversal));
}

/* SPEC 4.11 */
bool fxl_count_outcome(const fxl_traversal *traversal, fxl_outcome outcome, uint32_t used)
{
    fxl_counters *counters = traversal->counters;
    if (outcome >= FXL_OUTCOME_FULL) {
        if (traversal->display_list != NULL) {
            traversal->display_list->used = used;
        }
        return false;
    }
    uint32_t *count = &counters->outside;
    if (outcome & (1u << FXL_CLIP_CAPACITY | 1u << FXL_CLIP_RANGE)) {
        count = &counters->refused;
    } else if (outcome & (1u << FXL_CLIP_INSIDE | 1u << FXL_CLIP_CUT | 1u << FXL_CLIP_BETWEEN)) {
        count = &counters->drawn;
        counters->clipped += outcome >> FXL_CLIP_CUT & 1u;
        counters->spilled += (outcome & FXL_OUTCOME_SPILLED) != 0;
    } else if (outcome & 1u << FXL_CLIP_DEGENERATE) {
        count = &counters->degenerate;
    }
    *count += 1;
    return true;
}

/* The polygon on the screen straight into the band. One that has no row there may have one on the
 * rest of the screen, which matters only where it is counted. */
static inline void draw_at_once(const fxl_traversal *traversal, fxl_workspace *workspace,
                                fxl_counters *counters)
{
    const fxl_screen_polygon *screen = &workspace->screen;
    if (traversal->draw(workspace, screen, traversal->band) ||
        (!FXL_IS_COMPACT && workspace->rest_counted) ||
        fxl_outline_has_rows(screen, traversal->renderer->frame.view.lens.height)) {
        counters->spilled += 1;
    }
}

static inline bool submit_flat_face(const fxl_model_view *model_view, const fxl_face *face,
                                    const fxl_traversal *traversal)
{
    const fxl_clip_result cut = fxl_first_polygon(model_view, face, traversal);
    fxl_counters *counters = traversal->counters;
    if (!FXL_IS_SMALL && cut <= FXL_CLIP_CUT && traversal->draw != NULL) {
        draw_at_once(traversal, traversal->workspace, counters);
    } else if (FXL_IS_SMALL || cut != FXL_CLIP_BETWEEN) {
        if (FXL_IS_COMPACT || traversal->mode <= FXL_SUBMIT_MEASURE || cut > FXL_CLIP_CUT) {
            const uint32_t used = traversal->renderer->frame.display_list.used;
            return fxl_count_outcome(traversal, emit_all(traversal, model_view, cut), used);
        }
        if (emit(traversal) != 0) {
            return false;
        }
    }
    fxl_count_drawn(counters, cut, false); /* draw_at_once has counted its rows */
    return true;
}

bool fxl_submit_face(const fxl_model_view *model_view, const fxl_face *face,
                     const fxl_traversal *traversal)
{
    const fxl_shader *shader = model_view->shader;
    return shader != NULL ? shader->code->face(model_view, face, traversal, shader)
                          : submit_flat_face(model_view, face, traversal);
}

bool fxl_submit_shaded_face(const fxl_model_view *model_view, const fxl_face *face,
                            const fxl_traversal *traversal)
{
    return submit_flat_face(model_view, face, traversal);
}

/* --- draw -------------------------------------------------------------------------------- */

/* What the display list had no room for. Of a frame that was released that is nothing, and another
 * core may be changing the scene. */
static inline bool submit_rest(const fxl_traversal *traversal)
{
    const fxl_renderer *renderer = traversal->renderer;
    if (renderer->frame.state == FXL_FRAME_RELEASED) {
        return true;
    }
    return !FXL_IS_COMPACT && renderer->frame.state == FXL_FRAME_MEASURED
               ? fxl_extents_submit(traversal)
               : renderer->order->submit(traversal);
}

/* The polygons of the display list that reach the band, all flat. False where the target's memory
 * is full. */
static inline bool draw_display_list(const fxl_traversal *traversal)
{
    const fxl_target *target = traversal->renderer->target;
    const fxl_band *band = traversal->band;
    const fxl_rows wanted = {band->first_row, (uint16_t)(band->first_row + band->rows)};
    const fxl_display_list *list = &traversal->renderer->frame.display_list;
    const fxl_screen_polygon *polygon;
    uint32_t place = 0;
    while ((polygon = fxl_display_list_next(list, wanted, &place)) != NULL) {
        FXL_ASSERT(polygon->kind == FXL_POLYGON_FLAT);
        if (!target->flat(traversal->workspace, polygon, band) && !target->draws_over) {
            return false;
        }
    }
    return true;
}

/* SPEC 4.10, 7.5 */
fxl_status fxl_draw_band_turned(const fxl_renderer *renderer, fxl_workspace *workspace,
                                const fxl_band *band, bool is_turned)
{
    static const fxl_resume_point all = {0, 0};
    fxl_resume_point resume = is_turned ? all : renderer->frame.resume;
    fxl_counters uncounted;
    fxl_traversal traversal = fxl_traversal_of(renderer, workspace, &resume);
    traversal.band = band;
    traversal.near_first = renderer->near_first != is_turned;
    traversal.draws_one = renderer->clipper->next == NULL;
    if (!FXL_IS_SMALL && renderer->target->draws_over && traversal.draws_one) {
        traversal.draw = renderer->target->flat;
    }
    if (workspace->rest_counted) {
        memset(&uncounted, 0, sizeof uncounted);
        traversal.counters = &uncounted;
    }
    if (!(renderer->draw_display_list != NULL ? renderer->draw_display_list(&traversal)
                                              : draw_display_list(&traversal)) ||
        !submit_rest(&traversal)) {
        return FXL_E_CAPACITY;
    }
    workspace->rest_counted = true;
    return FXL_OK;
}

fxl_status fxl_draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                         const fxl_band *band)
{
    return fxl_draw_band_turned(renderer, workspace, band, false);
}

void fxl_frame_fill(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour)
{
    renderer->fill(renderer, band, colour);
}

/* rgb565 3.2 */
static bool is_band_of(const fxl_lens *lens, const fxl_band *band)
{
    return band->width == lens->width && fxl_band_is_within(band, lens->width, lens->height);
}

fxl_status fxl_draw_in_workspace(const fxl_renderer *renderer, fxl_workspace *workspace,
                                 const fxl_band *band)
{
    if (band == NULL || band->pixels == NULL) {
        return fxl_refuse(workspace, FXL_E_ARGUMENT);
    }
    const fxl_frame *frame = &renderer->frame;
    if (frame->state == FXL_FRAME_NONE || !fxl_has_pixels_of(renderer, band)) {
        return fxl_refuse(workspace, FXL_E_ORDER);
    }
    if (!is_band_of(&frame->view.lens, band)) {
        return fxl_refuse(workspace, FXL_E_RANGE);
    }
    fxl_band from_0 = *band;
    fxl_band_begin_at_column_0(&from_0);
    return renderer->target->draw_band(renderer, workspace, &from_0);
}

fxl_status fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band)
{
    return renderer == NULL ? FXL_E_ARGUMENT
                            : fxl_draw_in_workspace(renderer, &renderer->workspace, band);
}
