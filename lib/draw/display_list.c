/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "../math/memory.h"
#include "display_list.h"

/* A record: first row and, above it, end row, 16 bits each; a word that is the polygon's first:
 * colour, count, kind and shade; then x and y of each point, read where they lie. */
FXL_STATIC_ASSERT(sizeof(fxl_screen_point) == 2 * sizeof(uint32_t), "two words a point");
FXL_STATIC_ASSERT(offsetof(fxl_screen_polygon, points) == sizeof(uint32_t),
                  "a word before the points");
FXL_STATIC_ASSERT(FXL_POLYGON_CAPACITY <= 255, "8 bits for the count");

/* SPEC 7.2 */
bool fxl_display_list_append(fxl_display_list *list, const fxl_screen_polygon *polygon,
                             fxl_rows rows)
{
    FXL_ASSERT(polygon->count >= 3 && polygon->count <= FXL_POLYGON_CAPACITY);
    FXL_ASSERT(rows.first < rows.end && list->used <= list->capacity);
    uint32_t words = FXL_DISPLAY_LIST_WORDS((uint32_t)polygon->count);
    if (list->capacity - list->used < words) {
        return false;
    }
    uint32_t *to = list->words + list->used;
    to[0] = (uint32_t)rows.end << 16 | rows.first;
    memcpy(to + 1, polygon, (words - 1) * sizeof *to);
    list->used += words;
    return true;
}

/* SPEC 7.4 */
const fxl_screen_polygon *fxl_display_list_next(const fxl_display_list *list, fxl_rows rows,
                                                uint32_t *place)
{
    if (*place >= list->used) {
        return NULL; /* before any address: the words of an empty list may be null */
    }
    const uint32_t *record = list->words + *place, *end = list->words + list->used;
    const fxl_screen_polygon *found = NULL;
    do {
        const fxl_rows reached = {fxl_low_16(record[0]), (uint16_t)(record[0] >> 16)};
        const fxl_screen_polygon *polygon = (const fxl_screen_polygon *)(const void *)(record + 1);
        record += FXL_DISPLAY_LIST_WORDS((uint32_t)polygon->count);
        if (fxl_rows_meet(reached, rows)) {
            found = polygon;
        }
    } while (record < end && found == NULL);
    *place = (uint32_t)(record - list->words);
    return found;
}
