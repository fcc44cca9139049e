/* SPDX-License-Identifier: MIT */
/* What chapter 65 of the Black Book describes in Listing 65.3, written plainly
 * from its algorithm in floating point, to compare with: planes of the frustum
 * turned into the world, objects sorted by distance into a list, back faces
 * found by a cross product, each polygon clipped to four planes in the world
 * one after the other, what is left transformed, projected by a reciprocal, and
 * filled by scan lines.
 *
 * It departs from the chapter where that does not draw the same picture or is
 * the system's affair: objects of a lower layer come first; angles and their
 * signs, the fill rule (pixel centres, top-left), near and far (none: four
 * planes through the eye leave nothing behind it) are as Fixel's or said here.
 * Movement is not part of it. */
/* place fill-rule: the chapter's code, with a first_centre of its own */
#ifndef LISTING_H
#define LISTING_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The numbers: LISTING_double or LISTING_float chooses. */
#ifdef LISTING_double
typedef double real;
#define REAL(function) function
#else
typedef float real;
#define REAL(function) function##f
#endif

/* The largest face of the scenes has 24 vertices, and four planes add one each. */
#define LISTING_POLYGON_MAX 28

typedef struct {
    real v[3];
} listing_point;

/* A face as the scene has it, about its object's centre. */
typedef struct {
    const listing_point *vertices;
    uint8_t count, colour;
} listing_face;

typedef struct listing_object {
    listing_point centre;
    const listing_face *faces;
    uint32_t face_count;
    uint32_t layer;
    real distance;
    struct listing_object *next;
} listing_object;

typedef struct {
    listing_object *objects;
    uint32_t object_count;
    real focal; /* pixels */
} listing_world;

typedef struct {
    listing_point position;
    real yaw, pitch, roll; /* radians */
} listing_eye;

typedef struct {
    uint8_t *pixels;
    int width, height;
} listing_screen;

/* Draws a frame over a screen that has been cleared. */
void listing_draw(listing_world *world, const listing_eye *eye, const listing_screen *screen);

#endif
