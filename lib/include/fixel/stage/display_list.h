/* SPDX-License-Identifier: MIT */
/* The list: a frame's polygons as the screen shows them, in the order of
 * drawing, in memory of the caller. A frame is worked out once into the list
 * and drawn from it band by band. */
#ifndef FXL_DISPLAY_LIST_H
#define FXL_DISPLAY_LIST_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Words of 32 bits that a polygon with so many vertices takes in a list: its
 * rows, its colour and count, and each point as it is. */
#define FXL_DISPLAY_LIST_WORDS(vertices) (2u + 2u * (vertices))

/* The first `used` of `capacity` words hold records. */
typedef struct {
    uint32_t *words; /* the caller's; may be null where capacity is 0 */
    uint32_t capacity, used;
} fxl_display_list;

/* A polygon of a list; its points lie in the list itself. */
typedef struct {
    fxl_rows rows;
    uint8_t colour, count;
    uint8_t kind; /* FXL_POLYGON_FLAT */
    const fxl_screen_point *points;
} fxl_display_list_record;

/* Appends a polygon that reaches the given rows of the screen. False where it
 * does not fit: the list is then as it was.
 * Requires 3 <= count <= FXL_POLYGON_CAPACITY, rows.first < rows.end. Exact. */
bool fxl_display_list_append(fxl_display_list *list, const fxl_screen_polygon *polygon,
                             fxl_rows rows);

/* The next polygon, from *place on, that reaches one of the given rows; *place
 * is then behind it. Begin with a place of 0. False when there are no more;
 * record is then untouched. */
bool fxl_display_list_next(const fxl_display_list *list, fxl_rows rows, uint32_t *place,
                           fxl_display_list_record *record);

#ifdef __cplusplus
}
#endif

#endif
