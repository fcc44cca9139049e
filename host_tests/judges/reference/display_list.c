/* SPDX-License-Identifier: MIT */
#include "reference/display_list.h"

#include <stdlib.h>

#include "reference/grow.h"

bool ref_display_list_append(ref_display_list *list, const ref_drawn *drawn)
{
    ref_drawn *drawn_list =
        ref_grown(list->drawn, list->count, &list->capacity, 256, sizeof *drawn_list);
    if (!drawn_list) {
        return false;
    }
    list->drawn = drawn_list;
    list->drawn[list->count++] = *drawn;
    return true;
}

/* Tells whether two ranges of rows have a row in common. */
static bool share_a_row(ref_rows these, ref_rows those)
{
    int first = these.first > those.first ? these.first : those.first;
    int end = these.end < those.end ? these.end : those.end;
    return first < end;
}

const ref_drawn *ref_display_list_next(const ref_display_list *list, ref_rows rows, size_t *place)
{
    while (*place < list->count) {
        const ref_drawn *drawn = &list->drawn[(*place)++];
        if (share_a_row(drawn->rows, rows)) {
            return drawn;
        }
    }
    return NULL;
}

void ref_display_list_close(ref_display_list *list)
{
    free(list->drawn);
    *list = (ref_display_list){0};
}
