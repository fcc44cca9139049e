/* SPDX-License-Identifier: MIT */
/* What a renderer may have, and which two of it do not go together. Internal. */
#ifndef FXL_COMBINATION_H
#define FXL_COMBINATION_H

#include "fixel/render.h"

/* Bits of what a renderer has. conflict.c has the names. */
enum {
    FXL_HAS_TREE,     /* fxl_by_tree */
    FXL_HAS_MOVERS,   /* which the tree cuts */
    FXL_HAS_DEPTH,    /* the target has a depth buffer */
    FXL_HAS_STUDY,    /* the target is a span buffer, or scans bounding boxes */
    FXL_HAS_SURFACES, /* these and what follows are attached */
    FXL_HAS_TEXELS_565, /* surfaces with textures of RGB565 */
    FXL_HAS_BILLBOARDS,
    FXL_HAS_BEAMS,
    FXL_HAS_OUTLINES,
    FXL_HAS_OTHER_PAINTER, /* surfaces or billboards of another target */
    FXL_HAS_TARGET,        /* always */
    FXL_HAS_COUNT
};

/* Two things that do not go together. */
typedef struct {
    uint8_t first, second; /* FXL_HAS_... */
} fxl_conflict;

/* Returns the first conflict of the table that a renderer has; or null. */
const fxl_conflict *fxl_find_conflict(const fxl_renderer *renderer);

#endif
