/* SPDX-License-Identifier: MIT */
#include "reference/display_list.h"

#include <stdlib.h>

bool ref_display_list_append(ref_display_list *list, const ref_drawn *drawn)
{
    if (list->count == list->capacity) {
        size_t capacity = list->capacity ? 2 * list->capacity : 256;
        ref_drawn *more = realloc(list->drawn, capacity * sizeof *more);
        if (!more) {
            return false;
        }
        list->drawn = more;
        list->capacity = capacity;
    }
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
