/* SPDX-License-Identifier: MIT */
/* The records of the reference renderer: those of the library, in double.
 *
 * The reference renderer is written from SPEC.md alone. It is a program for the host: it may use
 * the heap, libc and libm. Numbers that the specification calls exact (poses, the scene) stay
 * integers. Everything else is a double in world units or pixels. */
#ifndef REF_RECORD_H
#define REF_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#define REF_ONE               65536.0 /* units of 16.16 in 1 */
#define REF_POLYGON_CAPACITY  32
#define REF_FACE_VERTICES_MAX 24
#define REF_COORDINATE_MAX    8191
#define REF_SCREEN_MAX        1024

typedef uint32_t ref_angle; /* a full turn is 2^32 */

/* For sums of products of the scene's integers, exactly. */
__extension__ typedef __int128 ref_exact;

/* A point of the world, in units of 1/65536. */
typedef struct {
    int32_t x, y, z;
} ref_lattice_point;

/* A point or a vector, in world units. */
typedef struct {
    double x, y, z;
} ref_point;

/* A point is inside where normal . point >= distance. The distance has 64 bits, so the sign of a
 * difference is exact if the plane and the point are the library's own integers (below 2^62
 * units of 2^-46). */
typedef struct {
    ref_point normal;
    long double distance;
} ref_plane;

typedef struct {
    ref_lattice_point position;
    ref_angle yaw, pitch, roll;
} ref_pose;

typedef struct {
    ref_point position;
    double u, v;
} ref_vertex;

typedef struct {
    uint8_t colour;
    int count;
    ref_vertex vertices[REF_POLYGON_CAPACITY];
} ref_polygon;

/* A point relative to the eye, along right, up and forward. It has 64 bits, so the sums of the
 * library and of the reference renderer, of the same integers, are both exact. */
typedef struct {
    long double x, y, z;
} ref_view_point;

typedef struct {
    ref_view_point position;
} ref_view_vertex;

typedef struct {
    uint8_t colour;
    int count;
    ref_view_vertex vertices[REF_POLYGON_CAPACITY];
} ref_view_polygon;

/* A point of the screen, in pixels, y down. */
typedef struct {
    double x, y;
} ref_screen_point;

typedef struct {
    uint8_t colour;
    int count;
    ref_screen_point points[REF_POLYGON_CAPACITY];
} ref_screen_polygon;

/* Rows first <= row < end. */
typedef struct {
    int first, end;
} ref_rows;

/* Pixels x0 <= x < x1 of row y. */
typedef struct {
    int y, x0, x1;
} ref_span;

/* A strip of the frame; row first_row starts at pixels[0]. Its pixels are entries of the palette;
 * or, where pixels is null, of 16 bits. */
typedef struct {
    uint8_t *pixels;
    int width, stride, first_row, rows;
    uint16_t *pixels_16;
} ref_band;

typedef struct {
    uint32_t in, backfacing, outside, degenerate, refused, drawn, clipped;
} ref_counters;

/* Lists that grow. */

/* Makes space for one entry more behind count entries of so many bytes: the capacity becomes twice
 * what it was, or first. Returns the entries, which may have moved; null where memory is short:
 * then nothing has changed. */
static inline void *ref_grown(void *entries, size_t count, size_t *capacity, size_t first,
                              size_t size)
{
    if (count < *capacity) {
        return entries;
    }
    const size_t more = *capacity ? 2 * *capacity : first;
    void *moved = realloc(entries, more * size);
    *capacity = moved ? more : *capacity;
    return moved;
}

#endif
