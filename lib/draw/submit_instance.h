/* SPDX-License-Identifier: MIT */
/* How the faces of instances are submitted, whether these are turned or not: the callers differ in
 * the functions that they give. The functions are inlined. Internal. */
#ifndef FXL_SUBMIT_INSTANCE_H
#define FXL_SUBMIT_INSTANCE_H

#include "display_list.h"
#include "submit_sorted.h"

/* Whether the loops over a frame's instances and over a sorted model's faces measure rows and pass
 * over what does not reach a band: in a library for size. Otherwise lib/draw/extents.c has loops
 * of its own, so that a full frame pays nothing for bands. */
#define ONE_LOOP (FXL_IS_COMPACT && !FXL_IS_SMALL)

/* A library for size has what follows, and fxl_submit_all, once: in submit_by_distance.c. */

/* fxl_submit_sorted by ONE_LOOP. */
#if FXL_IS_COMPACT
bool fxl_submit_sorted_once(const fxl_traversal *traversal, const fxl_model_view *model_view,
                            const fxl_model *model, fxl_face_orderer *order_faces);
#else
static inline bool fxl_submit_sorted_once(const fxl_traversal *traversal,
                                          const fxl_model_view *model_view, const fxl_model *model,
                                          fxl_face_orderer *order_faces)
{
    return fxl_submit_sorted(traversal, model_view, model, order_faces, ONE_LOOP);
}
#endif

/* fxl_submit_instance. */
typedef bool fxl_instance_submit(const fxl_traversal *traversal, const fxl_draw_entry *entry);

/* A convex instance: none of its faces hides another, so any order will do. Front to back
 * they come in reverse, so that the first face to cover a pixel is the one that would cover it
 * last back to front. Where faces are not walked, also one whose faces a depth buffer orders: of
 * these, many may lie outside. */
/* SPEC 6.2, 6.4 */
static inline bool fxl_submit_convex(const fxl_traversal *traversal,
                                     const fxl_model_view *model_view, const fxl_model *model,
                                     fxl_facing_test *is_front)
{
    const fxl_face *faces = traversal->renderer->scene->faces;
    const bool reverse = traversal->near_first;
    const uint32_t first = traversal->resume->faces, step = reverse ? UINT32_MAX : 1;
    const bool drops = !FXL_WALKS_SORTED && model->kind == FXL_MODEL_SORTED &&
                       fxl_drops_outside(traversal, model_view, model);
    uint32_t left = model->face_count - first, backfacing = 0, outside = 0;
    uint32_t at = reverse ? left - 1 : first;
    at += model->first_face; /* not before: a scene without faces may have no table */
    for (; left != 0; left--) {
        if (!is_front(model_view, &faces[at])) {
            backfacing++;
        } else if (drops && fxl_face_is_outside(model_view, &faces[at])) {
            outside++;
        } else if (!fxl_submit_face(model_view, &faces[at], traversal)) {
            break;
        }
        at += step;
    }
    const uint32_t number = model->face_count - left;
    traversal->resume->faces = (uint16_t)number;
    traversal->counters->in += number - first;
    traversal->counters->backfacing += backfacing;
    traversal->counters->outside += outside;
    return left == 0;
}

#if FXL_WALKS_FACES

/* Whether the faces of an instance that has no list of them are walked: those of a sorted model, of
 * which many may be turned away or lie outside, and those that the shader takes at once, which are
 * triangles but where it is the last shader: the middle one stands for all. The target has a depth
 * buffer then. */
static inline bool fxl_walks_faces(const fxl_traversal *traversal, const fxl_model_view *model_view,
                                   const fxl_model *model)
{
    const fxl_shader *shader = model_view->shader;
    return shader != NULL && (FXL_WALKS_SORTED || shader->code->faces != NULL) &&
           (model->kind == FXL_MODEL_SORTED ||
            (shader->code->faces != NULL && model->face_count != 0 &&
             (shader->code->walk != NULL ||
              traversal->renderer->scene->faces[model->first_face + model->face_count / 2].count ==
                  3)));
}

/* fxl_submit_walk, which a flat program does not link. */
static inline bool fxl_walk_instance(const fxl_traversal *traversal,
                                     const fxl_model_view *model_view, const fxl_model *model,
                                     fxl_next_face *next)
{
    const fxl_shader *last = traversal->renderer->target->extras->last;
    return last->code->walk(traversal, model_view, model, next);
}

#endif

/* fxl_submit_all. */
static inline bool fxl_submit_all_by(const fxl_traversal *traversal, fxl_instance_submit *submit)
{
    const fxl_frame *frame = &traversal->renderer->frame;
    const uint32_t count = frame->visible_count;
    const bool reverse = traversal->near_first;
    const bool measures = ONE_LOOP && traversal->mode == FXL_SUBMIT_MEASURE;
    const bool passes_over = ONE_LOOP && frame->state == FXL_FRAME_MEASURED;
    const fxl_rows wanted = passes_over ? fxl_rows_of_band(traversal->band) : fxl_no_rows;
    for (; traversal->resume->instances < count; traversal->resume->instances++) {
        const uint32_t number = traversal->resume->instances;
        fxl_draw_entry *entry = &frame->draw_list[reverse ? count - 1 - number : number];
        if (measures) {
            *traversal->reached = fxl_no_rows;
        }
        if ((!passes_over || fxl_rows_meet(entry->rows, wanted)) && !submit(traversal, entry)) {
            return false;
        }
        if (measures) {
            entry->rows = *traversal->reached;
        }
        traversal->resume->faces = 0;
    }
    return true;
}

/* All instances in sight that are left, in the order of drawing. */
#if FXL_IS_COMPACT
bool fxl_submit_all(const fxl_traversal *traversal, fxl_instance_submit *submit);
#else
static inline bool fxl_submit_all(const fxl_traversal *traversal, fxl_instance_submit *submit)
{
    return fxl_submit_all_by(traversal, submit);
}
#endif

#endif
