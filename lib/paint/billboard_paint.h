/* SPDX-License-Identifier: MIT */
/* What paints the billboards of a renderer, and how they become part of its visibility method.
 * Internal. */
#ifndef FXL_BILLBOARD_PAINT_H
#define FXL_BILLBOARD_PAINT_H

#include "fixel/billboards.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The points of a record of the display list, of the kind FXL_POLYGON_SPRITE: left and top; right
 * and bottom; the number of the model, and 0; with a depth buffer the distance in 18.46, high word
 * first. */
#define FXL_BILLBOARD_POINTS_MAX 4

/* Paints into a band what a record says. */
typedef struct fxl_billboard_painter {
    void (*paint)(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_screen_point *points, const fxl_band *band);
    uint8_t points; /* of a record: 3, or 4 where there is a depth buffer */
} fxl_billboard_painter;

/* Over what is there. */
extern const fxl_billboard_painter fxl_billboard_paints_over;

/* The billboards of a renderer that has some. */
static inline const fxl_billboards *fxl_billboards_of(const fxl_renderer *renderer)
{
    return (const fxl_billboards *)renderer->submit_workspace;
}

static inline const fxl_sprite *fxl_billboard_sprite(const fxl_renderer *renderer, uint32_t model)
{
    const fxl_billboard_set *set = fxl_billboards_of(renderer)->of.set;
    return set->billboards[set->model_map[model] - 1].sprite;
}

/* Checks the arguments of a setter, and the set: what it answers. */
fxl_status fxl_billboards_check_setting(const fxl_renderer *renderer,
                                        const fxl_billboards *billboards,
                                        const fxl_billboard_set *set);

/* Has the renderer's own visibility method, which draws surfaces, submit billboards too, and keeps
 * its memory. Requires arguments that were checked. */
fxl_status fxl_billboards_join(fxl_renderer *renderer, fxl_billboards *billboards,
                               const fxl_billboard_set *set, const fxl_billboard_painter *painter);

/* Whether the renderer draws by the method itself, or by one that billboards have joined. */
bool fxl_billboards_may_join(const fxl_renderer *renderer);

#ifdef __cplusplus
}
#endif

#endif
