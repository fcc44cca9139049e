/* SPDX-License-Identifier: MIT */
/* Small pictures as text: what scan covers, a character a pixel. */
#ifndef PICTURE_H
#define PICTURE_H

#include "unit.h"

#define PICTURE_MAX 24

/* A canvas that stands in for fill: it fails the test where a span is empty,
 * leaves the canvas, comes out of order, or draws a pixel a second time. */
typedef struct {
    uint16_t width, height;
    char pixels[PICTURE_MAX][PICTURE_MAX]; /* '.' where nothing was drawn */
} picture;

void picture_clear(picture *canvas, uint16_t width, uint16_t height);

/* Draws one more polygon; a pixel that any polygon drew before is a failure. */
void picture_add(picture *canvas, const fxl_screen_polygon *polygon, char ink);

/* The same, through a band of some rows only. */
void picture_add_band(picture *canvas, const fxl_screen_polygon *polygon, uint16_t first_row,
                      uint16_t rows, char ink);

/* A polygon from pixel coordinates x, y, x, y ... */
fxl_screen_polygon picture_polygon(const double *coordinates, uint8_t count);

/* Compares with rows of text; prints both pictures where they differ. */
void picture_expect(const picture *canvas, const char *const *rows);

/* place fill-rule: definition: picture_winding */
/* Whether SPEC.md, section 5, covers the pixel: the winding number by its
 * definition, exact. Below 2^59: coordinates are below 2^28 and half a pixel. */
int32_t picture_winding(const fxl_screen_polygon *polygon, int32_t column, int32_t row);

/* CHECK_PICTURE(POINTS(x, y, x, y ...), ROWS(row, row ...)): one polygon, one picture. */
#define POINTS(...) ((const double[]){__VA_ARGS__})
#define ROWS(...)   ((const char *const[]){__VA_ARGS__, NULL})

/* Draws a polygon of these points and compares. */
void picture_check(const double *points, uint8_t count, const char *const *rows);
#define CHECK_PICTURE(points, rows) \
    picture_check(points, (uint8_t)(sizeof(points) / sizeof(double) / 2), rows)

#endif
