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

/* The faces of an instance that reach a band, by what was measured. */
typedef struct {
    fxl_face_walk walk; /* the first member; its face is the first of all, and stays */
    const face_rows *rows;
    uint32_t groups;       /* those to come have a bit each */
    const face_rows *end;  /* of the group that is walked; and the number of the face after it */
    uint32_t ahead;
    uint32_t next, size;   /* the number of the next group's first face, and faces of a group */
    uint32_t resumed;      /* the number of the first face that is wanted */
    uint32_t face_count;
    uint32_t first_row, last_row; /* of the band, in units of 2^shift rows */
} rows_walk;

static inline rows_walk rows_walk_of(const fxl_traversal *traversal, const fxl_model *model,
                                     uint32_t kept)
{
    const fxl_renderer *renderer = traversal->renderer;
    const unsigned shift = shift_of(&renderer->frame);
    const fxl_band *band = traversal->band;
    const bool reverse = renderer->near_first;
    const uint32_t count = model->face_count;
    rows_walk of;
    of.walk.face = renderer->scene->faces + model->first_face + (reverse ? count - 1u : 0);
    of.walk.step = reverse ? -1 : 1;
    of.walk.left = count;
    of.walk.submitted = 0;
    of.rows = faces_of(&renderer->frame) + (kept & UINT16_MAX);
    of.groups = kept >> GROUPS;
    of.end = of.rows;
    of.ahead = of.next = 0;
    of.size = group_of(model);
    of.resumed = traversal->resume->faces;
    of.face_count = count;
    of.first_row = band->first_row >> shift;
    of.last_row = (band->first_row + band->rows - 1u) >> shift;
    return of;
}

/* The next one, or null. In place, a walk has no address, and takes no stack. */
static inline __attribute__((always_inline)) const fxl_face *next_of_walk(rows_walk *of)
{
    const face_rows *rows = of->rows;
    const uint32_t first_row = of->first_row, last_row = of->last_row;
    for (;;) {
        for (const face_rows *end = of->end; rows != end; rows++) {
            if (rows->first <= last_row && rows->end > first_row) {
                of->rows = rows + 1;
                return of->walk.face +
                       of->walk.step * ((int32_t)of->ahead - (int32_t)(of->end - rows));
            }
        }
        if (of->groups == 0) {
            return NULL;
        }
        if ((of->groups & 1u) != 0) {
            const uint32_t number = of->next > of->resumed ? of->next : of->resumed;
            of->ahead = of->next + of->size < of->face_count ? of->next + of->size : of->face_count;
            of->end = rows + (of->ahead - number);
        }
        of->groups >>= 1;
        of->next += of->size;
    }
}

#if FXL_WALKS_FACES

/* A fxl_next_face: whether a face is turned to the eye was measured, too. */
static const fxl_face *next_in_rows(const fxl_model_view *model_view, fxl_face_walk *walk)
{
    (void)model_view;
    return next_of_walk((rows_walk *)(void *)walk);
}

typedef enum {
    NONE_TAKEN = 0,
    SOME_TAKEN, /* one could not be submitted */
    ALL_TAKEN
} taken_faces;

/* All faces at once, as fxl_submit_walk does. Not inline: its walk would be on the stack of others. */
static __attribute__((noinline)) taken_faces take_faces(const fxl_traversal *traversal,
                                                        const fxl_model_view *model_view,
                                                        const fxl_model *model, uint32_t kept)
{
    rows_walk of = rows_walk_of(traversal, model, kept);
    of.walk.next = next_in_rows;
    return !model_view->shader->code->faces(model_view, traversal, &of.walk) ? NONE_TAKEN
           : of.walk.left == model->face_count                               ? ALL_TAKEN
                                                                              : SOME_TAKEN;
}

#endif

static bool draw_convex(const fxl_traversal *traversal, const fxl_model_view *model_view,
                        const fxl_model *model, uint32_t kept)
{
#if FXL_WALKS_FACES
    if (model_view->shader != NULL && model_view->shader->code->faces != NULL) {
        const taken_faces taken = take_faces(traversal, model_view, model, kept);
        if (taken != NONE_TAKEN) {
            return taken == ALL_TAKEN;
        }
    }
#endif
    rows_walk of = rows_walk_of(traversal, model, kept);
    const fxl_face *face;
    while ((face = next_of_walk(&of)) != NULL) {
        if (!fxl_submit_face(model_view, face, traversal)) {
            return false;
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
