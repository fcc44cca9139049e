/* SPDX-License-Identifier: MIT */
/* What changed from one frame to the next: at most four boxes of the screen that hold every pixel
 * in which two frames differ. docs/extras/changed.md. */
#ifndef FXL_CHANGED_H
#define FXL_CHANGED_H

#include "fixel/billboards.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_CHANGED_BOXES_MAX 4

/* Boxes, and what is known of the frame before. The caller owns it. Members are for reading only. */
typedef struct {
    fxl_screen_box boxes[FXL_CHANGED_BOXES_MAX]; /* the first `count` hold what changed */
    uint32_t count;                              /* 0: nothing changed */
    bool whole;                                  /* the one box is the whole frame */

    /* The rest is internal. */
    uint8_t background;
    uint8_t *memory; /* the caller's: records of billboards, then of instances from its two ends */
    size_t memory_size;
    const fxl_renderer *renderer; /* of the frame before; null: there was none */
    const fxl_scene *scene;
    const fxl_billboard_set *set;
    fxl_camera camera;
    fxl_lens lens;
    uint32_t frame, settings_number;
    uint32_t unturned, turned, models, billboards; /* records of the frame before */
} fxl_changed;

/* A billboard and its sprite, as they were. Internal. */
typedef struct {
    fxl_billboard billboard;
    fxl_sprite sprite;
} fxl_kept_billboard;

/* uint64_t of memory for so many instances, of which so many at most are turned, and for the models
 * and billboards of a scene with billboards, else 0 and 0. A constant expression. */
#define FXL_CHANGED_MEMORY(instances, turned, models, billboards) \
    ((16 * (instances) + 40 * (turned) + 7) / 8 + ((models) + 3) / 4 + \
     (billboards) * ((sizeof(fxl_kept_billboard) + 7) / 8))

/* Sets up a record that knows no frame, in memory of the caller's; it keeps the pointer.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ALIGNMENT: memory is not aligned to 8 bytes.
 * With each of these statuses: *changed untouched. */
fxl_status fxl_changed_init(fxl_changed *changed, void *memory, size_t memory_size);

/* Finds what changed since the frame for which it was last called: writes boxes, count and whole.
 * If a pixel is in no box, the renderer draws the same there as in that frame. Its time is that of
 * a comparison an instance, and two transforms of each vertex of each changed instance. Call it
 * after fxl_frame_begin, before the scene changes again. A renderer has a record of its own.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: fxl_changed_init did not set *changed up; no frame has begun, or its scene was
 * released.
 * FXL_E_CAPACITY: memory_size is too small for the instances of the scene, or its billboards.
 * With each of these statuses: *changed untouched; the next call that succeeds finds the whole
 * frame. */
fxl_status fxl_changed_find(fxl_changed *changed, const fxl_renderer *renderer);

/* Adds a box to those that fxl_changed_find found, for pixels that the program draws over the
 * frame. Exact.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: fxl_changed_find has found nothing yet.
 * FXL_E_RANGE: a box without pixels, or beyond the frame.
 * With each of these statuses: *changed untouched. */
fxl_status fxl_changed_add(fxl_changed *changed, const fxl_screen_box *box);

/* Adds the boxes of all instances of a model, whose texture, sprite or colours the program has
 * rewritten. The renderer is that of fxl_changed_find, and the scene is as it was then.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: fxl_changed_find was not called for the renderer's frame, or that has ended.
 * FXL_E_INDEX: there is no such model.
 * With each of these statuses: *changed untouched. */
fxl_status fxl_changed_add_model(fxl_changed *changed, const fxl_renderer *renderer,
                                 uint32_t model);

/* Moves the sides of all boxes outward to multiples of columns and rows, and joins boxes again. A
 * side at the frame's right or lower end stays. fxl_pump_widen calls it with what a pump sends.
 * columns: 1, 2, 4 or 8; 0: whole rows. rows: 1, 2, 4 or 8. Exact.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: fxl_changed_find has found nothing yet.
 * FXL_E_RANGE: another number of columns or rows.
 * With each of these statuses: *changed untouched. */
fxl_status fxl_changed_widen(fxl_changed *changed, uint32_t columns, uint32_t rows);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_changed_reasons[];

#ifdef __cplusplus
}
#endif

#endif
