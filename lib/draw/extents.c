/* SPDX-License-Identifier: MIT */
#include "../view/cull.h"
#include "../view/model_view.h"
#include "display_list.h"
#include "submit.h"

#include "../scene/placement_code.h"
#include "submit_sorted.h"

/* The rows that a face reaches, in units of 2^shift rows, rounded outward; end 0: none. They are
 * kept in the order in which a method submits the faces, for those groups of consecutive faces of
 * which one reaches a row: fxl_draw_entry.faces has the place of the first in its lower half, and
 * a bit for each group in its upper half. */
typedef struct {
    uint8_t first, end;
} face_rows;

#define GROUPS   16u
#define NO_FACES UINT16_MAX /* the place where there was no memory for an instance's faces */

#define ROWS_MAX UINT8_MAX /* of an `end` */

static unsigned shift_of(const fxl_frame *frame)
{
    unsigned shift = 0;
    while (frame->view.lens.height > ROWS_MAX << shift) {
        shift++;
    }
    return shift;
}

/* The memory behind the entries of the instances in sight, up to the first entry of the faces. */
static face_rows *faces_of(const fxl_frame *frame)
{
    return (face_rows *)(void *)(frame->draw_list + frame->visible_count);
}

static uint32_t place_of(const fxl_renderer *renderer, uint32_t number)
{
    return renderer->near_first ? renderer->frame.visible_count - 1 - number : number;
}

/* --- measuring ------------------------------------------------------------------------- */

/* Where the rows of faces are written. */
typedef struct {
    face_rows *start;
    uint32_t used, room;
} store;

/* The faces of a group, from number `first` on. Returns whether one reaches a row; then their rows
 * are in the store, so far as there is room. */
static bool measure_group(const fxl_traversal *traversal, const fxl_model_view *model_view,
                          const fxl_model *model, uint32_t first, uint32_t end, store *to)
{
    const unsigned shift = shift_of(&traversal->renderer->frame);
    const fxl_face *faces = &traversal->renderer->scene->faces[model->first_face];
    const bool reverse = traversal->renderer->near_first;
    const uint32_t used = to->used;
    bool reaches = false;
    for (uint32_t number = first; number < end; number++) {
        const fxl_face *face = &faces[reverse ? model->face_count - 1 - number : number];
        fxl_rows rows = {0, 0};
        traversal->counters->in += 1;
        if (fxl_model_view_face_is_front(model_view, face)) {
            rows = fxl_measure_face(traversal, model_view, face);
        } else {
            traversal->counters->backfacing += 1;
        }
        if (to->used < to->room) {
            /* At most 255, since rows are not above the screen's height. */
            to->start[to->used].first = (uint8_t)(rows.end == 0 ? 0 : rows.first >> shift);
            to->start[to->used].end = (uint8_t)((rows.end + (1u << shift) - 1) >> shift);
        }
        to->used += 1;
        reaches |= rows.end != 0;
    }
    if (!reaches) {
        to->used = used;
    }
    return reaches;
}

/* Faces of a group. */
static uint32_t group_of(const fxl_model *model)
{
    return (model->face_count + GROUPS - 1) / GROUPS;
}

/* Returns the instance's `faces`. */
static uint32_t measure_convex(const fxl_traversal *traversal, const fxl_model_view *model_view,
                               const fxl_model *model, store *to)
{
    const uint32_t place = to->used, size = group_of(model);
    uint32_t groups = 0, bit = 1u << GROUPS;
    for (uint32_t number = 0; number < model->face_count; number += size, bit <<= 1) {
        const uint32_t end = number + size < model->face_count ? number + size : model->face_count;
        const uint32_t first =
            number > traversal->resume->faces ? number : traversal->resume->faces;
        if (first < end && measure_group(traversal, model_view, model, first, end, to)) {
            groups |= bit;
        }
    }
    if (to->used > to->room || place >= NO_FACES) {
        to->used = place;
        return NO_FACES;
    }
    return groups | place;
}

/* --- a cache in what is left ----------------------------------------------------------- */

/* The first address behind the memory of the instances' entries. */
static uintptr_t end_of_order(const fxl_renderer *renderer)
{
    return (uintptr_t)renderer->workspace.face_list;
}

/* Vertices of an instance are then transformed once a band, not once a face. */
static void lend_cache(const fxl_renderer *renderer, fxl_vertex_cache *cache, const face_rows *from)
{
    const uintptr_t start = ((uintptr_t)from + 7u) & ~(uintptr_t)7u, end = end_of_order(renderer);
    if (cache->entries == NULL && start < end) {
        fxl_vertex_cache_init(cache, (fxl_cached_vertex *)start,
                              (uint32_t)((end - start) / sizeof(fxl_cached_vertex)));
    }
}

void fxl_extents_take_back(const fxl_renderer *renderer, fxl_workspace *workspace)
{
    const uintptr_t at = (uintptr_t)workspace->cache.entries;
    if (at >= (uintptr_t)renderer->frame.draw_list && at < end_of_order(renderer)) {
        fxl_vertex_cache_init(&workspace->cache, NULL, 0);
    }
}

/* Returns the instance's `faces`. */
static uint32_t measure_instance(const fxl_traversal *traversal, const fxl_draw_entry *entry,
                                 store *to)
{
    FXL_ALIGN_8 fxl_model_view model_view;
    const fxl_placement_code *turned =
        fxl_placement_code_of(traversal->renderer->scene, entry->index);
    if (turned != NULL) {
        (void)turned->submit_instance(traversal, entry, NULL); /* there is room for rows' numbers */
        return NO_FACES;
    }
    const fxl_model *model = &traversal->renderer->scene
                                  ->models[fxl_view_instance(traversal, entry, &model_view)->model];
    if (!fxl_lists_faces(traversal->renderer, model)) {
        return measure_convex(traversal, &model_view, model, to);
    }
    (void)fxl_submit_sorted(traversal, &model_view, model, fxl_list_model, true);
    return NO_FACES;
}

static void measure_instances(const fxl_traversal *traversal, const fxl_frame *frame, store *to)
{
    for (; traversal->resume->instances < frame->visible_count; traversal->resume->instances++) {
        fxl_draw_entry *entry =
            &frame->draw_list[place_of(traversal->renderer, traversal->resume->instances)];
        *traversal->reached = fxl_no_rows;
        entry->faces = measure_instance(traversal, entry, to);
        entry->rows = *traversal->reached;
        traversal->resume->faces = 0;
    }
}

FXL_COLD void fxl_extents_measure(const fxl_traversal *filling, fxl_frame *frame)
{
    const fxl_renderer *renderer = filling->renderer;
    fxl_resume_point resume = {filling->resume->instances, filling->resume->faces};
    fxl_traversal traversal = *filling;
    traversal.display_list = NULL;
    traversal.resume = &resume;
    traversal.mode = FXL_SUBMIT_MEASURE;
    store to = {faces_of(frame), 0,
                (renderer->instance_capacity - frame->visible_count) *
                    (uint32_t)(sizeof(fxl_draw_entry) / sizeof(face_rows))};
    fxl_rows reached;
    traversal.reached = &reached;
    if (FXL_IS_COMPACT) {
        (void)fxl_submit_by_distance(&traversal);
    } else {
        measure_instances(&traversal, frame, &to);
    }
    lend_cache(renderer, &filling->workspace->cache, to.start + to.used);
    frame->state = FXL_FRAME_MEASURED;
}

/* --- drawing --------------------------------------------------------------------------- */

static bool draw_convex(const fxl_traversal *traversal, const fxl_model_view *model_view,
                        const fxl_model *model, uint32_t kept)
{
    const unsigned shift = shift_of(&traversal->renderer->frame);
    const uint32_t first_row = traversal->band->first_row >> shift;
    const uint32_t last_row = (traversal->band->first_row + traversal->band->rows - 1u) >> shift;
    const fxl_face *faces = &traversal->renderer->scene->faces[model->first_face];
    const bool reverse = traversal->renderer->near_first;
    const face_rows *rows = faces_of(&traversal->renderer->frame) + (kept & UINT16_MAX);
    const uint32_t size = group_of(model);
    uint32_t number = 0;
    for (uint32_t groups = kept >> GROUPS; groups != 0; groups >>= 1, number += size) {
        if ((groups & 1u) == 0) {
            continue;
        }
        const uint32_t end = number + size < model->face_count ? number + size : model->face_count;
        const uint32_t first =
            number > traversal->resume->faces ? number : traversal->resume->faces;
        for (uint32_t i = first; i < end; i++, rows++) {
            const uint32_t at = reverse ? model->face_count - 1 - i : i;
            if (rows->first <= last_row && rows->end > first_row &&
                !fxl_submit_face(model_view, &faces[at], traversal)) {
                return false;
            }
        }
    }
    return true;
}

static bool draw_instance(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_model *model =
        &renderer->scene->models[renderer->scene->instances[entry->index].model];
    const bool is_sorted = fxl_lists_faces(renderer, model);
    if (fxl_placement_code_of(renderer->scene, entry->index) != NULL ||
        (!is_sorted && (entry->faces & UINT16_MAX) == NO_FACES)) {
        return fxl_submit_any_instance(traversal, entry);
    }
    FXL_ALIGN_8 fxl_model_view model_view;
    (void)fxl_view_instance(traversal, entry, &model_view);
    return is_sorted ? fxl_submit_sorted(traversal, &model_view, model, fxl_list_model, true)
                     : draw_convex(traversal, &model_view, model, entry->faces);
}

bool fxl_extents_submit(const fxl_traversal *traversal)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_rows wanted = fxl_rows_of_band(traversal->band);
    const uint32_t count = renderer->frame.visible_count;
    const int32_t step = renderer->near_first ? -1 : 1;
    uint32_t number = traversal->resume->instances;
    const fxl_draw_entry *entry = renderer->frame.draw_list + place_of(renderer, number);
    for (; number < count; number++, entry += step) {
        if (!fxl_rows_meet(entry->rows, wanted)) {
            continue;
        }
        if (number != traversal->resume->instances) {
            traversal->resume->instances = (uint16_t)number;
            traversal->resume->faces = 0;
        }
        if (!draw_instance(traversal, entry)) {
            return false;
        }
    }
    return true;
}
