/* SPDX-License-Identifier: MIT */
#include "billboard_paint.h"

#include "billboard_walk.h"

static inline void paint_row(fxl_billboard_row *row, const void *with)
{
    (void)with;
    for (uint32_t x = row->columns.first; x < row->columns.end; x++) {
        fxl_sprite_put(row->sprite, row->texels, row->along.texel, row->shift, row->pixels + x);
        fxl_take_step(&row->along);
    }
}

static void paint(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_screen_point *points, const fxl_band *band)
{
    (void)workspace;
    fxl_billboard_walk_rows(fxl_billboard_sprite(renderer, (uint32_t)points[2].x), &points[0],
                            &points[1], band, paint_row, NULL);
}

const fxl_billboard_painter fxl_billboard_paints_over = {paint, 3};
