/* SPDX-License-Identifier: MIT */
/* The list of a frame's polygons (SPEC.md, section 7), in double and without end. */
#ifndef REF_LIST_H
#define REF_LIST_H

#include "reference/record.h"

/* A polygon that was drawn: its outline as the twin has it, the rows that it
 * reaches, and where it came from. */
typedef struct {
    ref_screen_polygon polygon; /* no points: the twin leaves it out, but see below */
    ref_rows rows;
    uint32_t instance, face; /* numbers in the scene and in the model */

    /* Whether the rounding of depths may decide what near and far leave of it
     * (docs/accuracy.md, section 4).
     * Then least and most are what they leave at the least and at the most; either may have
     * no points. Asked only where the renderer says so. */
    bool in_doubt;
    ref_screen_polygon least, most;
} ref_drawn;

/* In the order of drawing. Unlike the library's, it keeps the polygons that
 * reach no row: a judge asks what might have been drawn. */
typedef struct {
    ref_drawn *drawn;
    size_t count, capacity;
} ref_display_list;

/* False where memory is short. An empty list is all zero. */
bool ref_display_list_append(ref_display_list *list, const ref_drawn *drawn);

/* The next polygon from *place on that reaches one of the given rows; *place is
 * then behind it. Null when there are no more. */
const ref_drawn *ref_display_list_next(const ref_display_list *list, ref_rows rows, size_t *place);

void ref_display_list_close(ref_display_list *list);

#endif
