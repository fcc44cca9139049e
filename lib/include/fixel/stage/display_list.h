/* SPDX-License-Identifier: MIT */
/* The display list: a frame's polygons of the screen, in the order of drawing, in memory of the
 * caller. begin computes a frame once into the list; draw draws it from the list band by band. */
#ifndef FXL_DISPLAY_LIST_H
#define FXL_DISPLAY_LIST_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The words of 32 bits that a polygon of so many vertices takes in a display list: one for its
 * rows, one for its kind, colour and count, and two for each point, unchanged. */
#define FXL_DISPLAY_LIST_WORDS(vertices) (2u + 2u * (vertices))

/* A display list. The first `used` of `capacity` words hold records. */
typedef struct {
    uint32_t *words; /* the caller's; may be null where capacity is 0 */
    uint32_t capacity, used;
} fxl_display_list;

/* A polygon of a display list. Its points lie in the list itself. */
typedef struct fxl_display_list_record {
    fxl_rows rows;
    uint8_t colour, count;
    uint8_t kind; /* FXL_POLYGON_FLAT */
    const fxl_screen_point *points;
} fxl_display_list_record;

/* Appends a polygon that reaches the given rows of the screen. Returns false if it
 * does not fit: list untouched.
 * Requires 3 <= count <= FXL_POLYGON_CAPACITY, rows.first < rows.end. Exact. */
bool fxl_display_list_append(fxl_display_list *list, const fxl_screen_polygon *polygon,
                             fxl_rows rows);

/* Finds the next polygon, from *place on, that reaches one of the given rows, and moves *place
 * behind it. *place is a number of words; begin with 0. Returns false if there is none: record
 * untouched. Exact. */
bool fxl_display_list_next(const fxl_display_list *list, fxl_rows rows, uint32_t *place,
                           fxl_display_list_record *record);

#ifdef __cplusplus
}
#endif

#endif
