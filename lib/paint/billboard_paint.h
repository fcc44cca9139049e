/* SPDX-License-Identifier: MIT */
/* What paints the billboards of a renderer. Internal. */
#ifndef FXL_BILLBOARD_PAINT_H
#define FXL_BILLBOARD_PAINT_H

#include "fixel/billboards.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The points of a record of the display list, of the kind FXL_POLYGON_SPRITE: left and top; right
 * and bottom; the number of the model, and 0, or 1 + the only column that is painted; with a depth buffer the distance in 18.46, high word
 * first. */
#define FXL_BILLBOARD_POINTS_MAX 4

struct fxl_sprite_painter {
    const fxl_target *target;
    /* Paints into a band what a record says. */
    void (*paint)(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_screen_point *points, const fxl_band *band);
    uint8_t points; /* of a record: 3, or 4 where there is a depth buffer */
};

static inline const fxl_sprite *fxl_billboard_sprite(const fxl_renderer *renderer, uint32_t model)
{
    const fxl_billboard_set *set = renderer->billboards->set;
    return set->billboards[set->model_map[model] - 1].sprite;
}

/* fxl_by_distance with billboards among the faces. */
extern const fxl_order fxl_by_distance_with_billboards;

#ifdef __cplusplus
}
#endif

#endif
