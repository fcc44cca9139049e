/* SPDX-License-Identifier: MIT */
/* A world of faces, what a ray meets of it first, and the light on that. */
#ifndef RAYCAST_WORLD_H
#define RAYCAST_WORLD_H

#include <stdint.h>
#include <stdbool.h>

#include "vector.h"

/* Light at run time (docs/extras/light.md): the colour of a face that a ray meets. */

/* Of an image; ramp is null where it has no light. */
typedef struct {
    const uint8_t *base, *points, *ramp;
    uint32_t point_count, levels;
} light_tables;

/* A face: its normal, and the middle of its bounding box along the axes of the model. */
typedef struct {
    vector normal, middle;
    uint8_t material;
} light_face;

/* The colour of a face for an eye that looks along forward. */
uint8_t light_colour(const light_tables *light, const light_face *face, vector eye, vector forward);

/* The polygons of the world, and the test which of them a ray meets first. */

typedef struct {
    uint32_t first, count; /* corners */
    uint8_t colour;
    light_face lit; /* of a scene with light at run time */
    vector normal;  /* Newell's normal, of any length: it points to where the front is seen from */
    vector middle;  /* mean of the vertices: a point of the plane */
} world_polygon;

/* A box around polygons first .. first + count - 1 (a leaf, count > 0), or around the two nodes
 * first and first + 1 (count 0). */
typedef struct {
    double bounds[2][3]; /* the low ones, the high ones */
    uint32_t first, count;
} world_node;

typedef struct {
    world_polygon *polygons;
    vector *corners;
    world_node *nodes;
    uint32_t polygon_count, corner_count, node_count;
} world;

/* A ray from the eye. The direction advances 1 along forward, so a hit at
 * eye + z * direction lies at depth z. Only hits in near..far count. */
typedef struct {
    vector eye, direction;
    double near, far;
} world_ray;

typedef struct {
    bool found;
    double z;
    uint8_t colour;
    const world_polygon *polygon; /* null where there is none */
} world_hit;

/* Computes planes and boxes. The caller must have filled in polygons and vertices. */
void world_prepare(world *w);

/* Finds the nearest polygon whose front the ray meets. guess: a polygon that the ray may
 * meet, or null. What lies behind it is not looked at. */
world_hit world_nearest(const world *w, const world_ray *ray, const world_polygon *guess);

/* Tells whether a polygon of this colour lies no deeper than the nearest hit, to within 1e-6 of
 * its depth. Coplanar polygons have the same depth, so either may be drawn. */
bool world_shows(const world *w, const world_ray *ray, uint8_t colour);

#endif
