/* SPDX-License-Identifier: MIT */
#include "reach.h"

#include "../view/facing.h"

/* The rows that a face reaches, in units of 2^shift rows, rounded outward; end 0: none. They are
 * kept in the order in which a method submits the faces, for those groups of consecutive faces of
 * which one reaches a row: fxl_order_entry.faces has the place of the first in its lower half, and
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
    return (face_rows *)(void *)(frame->order + frame->visible_count);
}

static uint32_t place_of(const fxl_renderer *renderer, uint32_t number)
{
    return renderer->visibility->front_to_back ? renderer->frame.visible_count - 1 - number
                                               : number;
}

static void add_rows(fxl_rows *sum, fxl_rows rows)
{
    sum->first = rows.first < sum->first ? rows.first : sum->first;
    sum->end = rows.end > sum->end ? rows.end : sum->end;
}

/* --- measuring ------------------------------------------------------------------------- */

/* Submits a face, adds what it reaches to *all, and returns it. */
static fxl_rows measure_face(const fxl_traversal *on, const fxl_model_view *model_view,
                             const fxl_face *face, fxl_rows *all)
{
    const fxl_rows none = {UINT16_MAX, 0};
    *on->reached = none;
    (void)fxl_submit_face(model_view, face, on); /* there is room for a row's number */
    add_rows(all, *on->reached);
    return *on->reached;
}

/* Where the rows of faces are written. */
typedef struct {
    face_rows *start;
    uint32_t used, room;
} store;

/* The faces of a group, from number `first` on. Returns whether one reaches a row; then their rows
 * are in the store, so far as there is room. */
static bool measure_group(const fxl_traversal *on, const fxl_model_view *model_view,
                          const fxl_model *model, uint32_t first, uint32_t end, store *to,
                          fxl_rows *all)
{
    const unsigned shift = shift_of(&on->renderer->frame);
    const fxl_face *faces = &on->renderer->scene->faces[model->first_face];
    const bool reverse = on->renderer->visibility->front_to_back;
    const uint32_t used = to->used;
    bool reaches = false;
    for (uint32_t number = first; number < end; number++) {
        const fxl_face *face = &faces[reverse ? model->face_count - 1 - number : number];
        fxl_rows rows = {0, 0};
        on->counters->in += 1;
        if (fxl_model_view_face_is_front(model_view, face)) {
            rows = measure_face(on, model_view, face, all);
        } else {
            on->counters->backfacing += 1;
        }
        if (to->used < to->room) {
            /* At most 255, since rows are not above the screen's height. */
            to->start[to->used].first = (uint8_t)(rows.end == 0 ? 0 : rows.first >> shift);
            /* bug: reach-round */
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
static uint32_t measure_convex(const fxl_traversal *on, const fxl_model_view *model_view,
                               const fxl_model *model, store *to, fxl_rows *all)
{
    const uint32_t place = to->used, size = group_of(model);
    uint32_t groups = 0, bit = 1u << GROUPS;
    for (uint32_t number = 0; number < model->face_count; number += size, bit <<= 1) {
        const uint32_t end = number + size < model->face_count ? number + size : model->face_count;
        const uint32_t first = number > on->resume->faces ? number : on->resume->faces;
        if (first < end && measure_group(on, model_view, model, first, end, to, all)) {
            groups |= bit;
        }
    }
    if (to->used > to->room || place >= NO_FACES) {
        to->used = place;
        return NO_FACES;
    }
    return groups | place;
}

static void measure_sorted(const fxl_traversal *on, const fxl_model_view *model_view,
                           const fxl_model *model, fxl_rows *all)
{
    fxl_workspace *workspace = on->workspace;
    const fxl_face *faces = &on->renderer->scene->faces[model->first_face];
    const bool reverse = on->renderer->visibility->front_to_back;
    if (workspace->sorted_instance != on->resume->instances) {
        workspace->sorted_instance = on->resume->instances;
        fxl_order_model(on, model_view, model);
    }
    const uint32_t count = workspace->sorted_count;
    for (uint32_t number = on->resume->faces; number < count; number++) {
        fxl_order_entry *entry = &workspace->face_order[reverse ? count - 1 - number : number];
        entry->rows = measure_face(on, model_view, &faces[entry->face], all);
    }
    workspace->face_rows_known = true;
    on->counters->in += model->face_count - on->resume->faces;
    on->counters->backfacing += model->face_count - workspace->front_count;
    on->counters->outside += workspace->front_count - count;
}

/* --- a cache in what is left ----------------------------------------------------------- */

/* The first address behind the memory of the instances' entries. */
static uintptr_t end_of_order(const fxl_renderer *renderer)
{
    return (uintptr_t)(renderer->frame.order + renderer->instance_capacity);
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

void fxl_reach_take_back(const fxl_renderer *renderer, fxl_workspace *workspace)
{
    const uintptr_t at = (uintptr_t)workspace->cache.entries;
    if (at >= (uintptr_t)renderer->frame.order && at < end_of_order(renderer)) {
        fxl_vertex_cache_init(&workspace->cache, NULL, 0); /* bug: reach-cache */
    }
}

void fxl_reach_measure(const fxl_traversal *filling, fxl_frame *frame)
{
    const fxl_renderer *renderer = filling->renderer;
    const fxl_scene *scene = renderer->scene;
    fxl_rows reached;
    fxl_resume_point resume = *filling->resume;
    fxl_traversal on = *filling;
    on.display_list = NULL;
    on.reached = &reached;
    on.resume = &resume;
    on.way = FXL_SUBMIT_MEASURE;
    store to = {faces_of(frame), 0,
                (renderer->instance_capacity - frame->visible_count) *
                    (uint32_t)(sizeof(fxl_order_entry) / sizeof(face_rows))};
    for (; resume.instances < frame->visible_count; resume.instances++) {
        fxl_order_entry *entry = &frame->order[place_of(renderer, resume.instances)];
        fxl_rows all = {UINT16_MAX, 0};
        fxl_model_view model_view;
        const fxl_turn_code *turned = fxl_turn_code_of(scene, entry->index);
        if (turned != NULL) {
            reached = all;
            (void)turned->submit_instance(&on, entry, false); /* there is room for rows' numbers */
            entry->faces = NO_FACES;
            entry->rows = reached;
            resume.faces = 0;
            continue;
        }
        const fxl_model *model = &scene->models[fxl_view_instance(&on, entry, &model_view)->model];
        entry->faces = NO_FACES;
        if (model->kind == FXL_MODEL_SORTED) {
            measure_sorted(&on, &model_view, model, &all);
        } else {
            entry->faces = measure_convex(&on, &model_view, model, &to, &all);
        }
        entry->rows = all;
        resume.faces = 0;
    }
    lend_cache(renderer, &filling->workspace->cache, to.start + to.used);
    frame->state = FXL_FRAME_MEASURED;
}

/* --- drawing --------------------------------------------------------------------------- */

static bool draw_convex(const fxl_traversal *on, const fxl_model_view *model_view,
                        const fxl_model *model, uint32_t kept)
{
    const unsigned shift = shift_of(&on->renderer->frame);
    const uint32_t first_row = on->band->first_row >> shift;
    const uint32_t last_row = (on->band->first_row + on->band->rows - 1u) >> shift;
    const fxl_face *faces = &on->renderer->scene->faces[model->first_face];
    const bool reverse = on->renderer->visibility->front_to_back;
    const face_rows *rows = faces_of(&on->renderer->frame) + (kept & UINT16_MAX);
    const uint32_t size = group_of(model);
    uint32_t number = 0;
    for (uint32_t groups = kept >> GROUPS; groups != 0; groups >>= 1, number += size) {
        if ((groups & 1u) == 0) {
            continue;
        }
        const uint32_t end = number + size < model->face_count ? number + size : model->face_count;
        const uint32_t first = number > on->resume->faces ? number : on->resume->faces;
        for (uint32_t i = first; i < end; i++, rows++) {
            const uint32_t at = reverse ? model->face_count - 1 - i : i;
            if (rows->first <= last_row && rows->end > first_row &&
                !fxl_submit_face(model_view, &faces[at], on)) {
                return false;
            }
        }
    }
    return true;
}

static bool draw_sorted(const fxl_traversal *on, const fxl_model_view *model_view,
                        const fxl_model *model, fxl_rows wanted)
{
    const fxl_workspace *workspace = on->workspace;
    const fxl_face *faces = &on->renderer->scene->faces[model->first_face];
    const uint32_t count = workspace->sorted_count;
    const bool reverse = on->renderer->visibility->front_to_back;
    for (uint32_t number = on->resume->faces; number < count; number++) {
        const fxl_order_entry *entry =
            &workspace->face_order[reverse ? count - 1 - number : number];
        if (fxl_rows_meet(entry->rows, wanted) &&
            !fxl_submit_face(model_view, &faces[entry->face], on)) {
            return false;
        }
    }
    return true;
}

static bool draw_instance(const fxl_traversal *on, const fxl_order_entry *entry, fxl_rows wanted)
{
    const fxl_renderer *renderer = on->renderer;
    const fxl_workspace *workspace = on->workspace;
    const fxl_model *model =
        &renderer->scene->models[renderer->scene->instances[entry->index].model];
    const bool sorted_known = model->kind == FXL_MODEL_SORTED && workspace->face_rows_known &&
                              workspace->sorted_instance == on->resume->instances;
    if (!sorted_known && (entry->faces & UINT16_MAX) == NO_FACES) {
        return fxl_submit_any_instance(on, entry);
    }
    FXL_ALIGN_8 fxl_model_view model_view;
    (void)fxl_view_instance(on, entry, &model_view);
    return sorted_known ? draw_sorted(on, &model_view, model, wanted)
                        : draw_convex(on, &model_view, model, entry->faces);
}

bool fxl_reach_submit(const fxl_traversal *on)
{
    const fxl_renderer *renderer = on->renderer;
    const fxl_rows wanted = {on->band->first_row, (uint16_t)(on->band->first_row + on->band->rows)};
    for (; on->resume->instances < renderer->frame.visible_count; on->resume->instances++) {
        const fxl_order_entry *entry =
            &renderer->frame.order[place_of(renderer, on->resume->instances)];
        if (fxl_rows_meet(entry->rows, wanted) && !draw_instance(on, entry, wanted)) {
            return false;
        }
        on->resume->faces = 0;
    }
    return true;
}
