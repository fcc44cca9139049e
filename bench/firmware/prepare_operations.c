/* SPDX-License-Identifier: MIT */
/* Measures the clipping of a polygon. If the clipper cut a face, it is called for that face
 * again, as a region of its own; its vertices are then in the cache. */
#include "combination.h"

static const fxl_clipper *asked;
static fxl_clipper counting;
static fxl_screen_polygon scratch;

/* A program that counts operations counts those between these two calls. */
void operations_begin(void);
void operations_end(void);

__attribute__((naked, noinline)) void operations_begin(void)
{
    __asm__ volatile("bx lr");
}

__attribute__((naked, noinline)) void operations_end(void)
{
    __asm__ volatile("bx lr");
}

/* Takes all polygons of a face. */
static bool take(const fxl_model_view *placed, const fxl_face *face, fxl_clipper_work *work)
{
    fxl_clip_result result = asked->clip(placed, face, work, &scratch);
    bool cut = false;
    while (result == FXL_CLIP_CUT || result == FXL_CLIP_INSIDE) {
        cut |= result == FXL_CLIP_CUT;
        result = asked->next != NULL ? asked->next(placed, work, &scratch) : FXL_CLIP_OUTSIDE;
    }
    return cut;
}

static fxl_clip_result clip(const fxl_model_view *placed, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    if (take(placed, face, work)) {
        operations_begin();
        take(placed, face, work);
        operations_end();
    }
    return asked->clip(placed, face, work, screen);
}

void combination_prepare(fxl_renderer *renderer)
{
    asked = renderer->clipper;
    counting = *asked;
    counting.clip = clip;
    renderer->clipper = &counting;
}
