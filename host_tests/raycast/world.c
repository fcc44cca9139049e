/* SPDX-License-Identifier: MIT */
#include "world.h"

#include <math.h>
#include <stdlib.h>

#include "file.h"

#define LEAF_POLYGONS 4
#define DEPTH_STACK   96
#define TIE           1e-6

/* A face may be off its plane by 4/65536 unit, so boxes are a little larger. */
#define BOX_MARGIN (16.0 / 65536.0)

static double component(vector v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static int sort_axis;

static int by_middle(const void *left, const void *right)
{
    double a = component(((const world_polygon *)left)->middle, sort_axis);
    double b = component(((const world_polygon *)right)->middle, sort_axis);
    return (a > b) - (a < b);
}

static void plane_of(const world *w, world_polygon *polygon)
{
    const vector *corners = w->corners + polygon->first;
    vector sum = {0, 0, 0};
    for (uint32_t i = 0; i < polygon->count; i++)
        sum = vector_plus(sum, corners[i]);
    polygon->middle = vector_times(sum, 1.0 / polygon->count);
    vector normal = {0, 0, 0};
    for (uint32_t i = 0; i < polygon->count; i++) {
        vector a = vector_minus(corners[i], polygon->middle);
        vector b = vector_minus(corners[(i + 1) % polygon->count], polygon->middle);
        normal = vector_plus(normal, vector_cross(a, b));
    }
    polygon->normal = normal;
}

static void box_of(const world *w, world_node *node, uint32_t first, uint32_t count)
{
    for (int axis = 0; axis < 3; axis++) {
        node->low[axis] = INFINITY;
        node->high[axis] = -INFINITY;
    }
    for (uint32_t p = first; p < first + count; p++) {
        const world_polygon *polygon = &w->polygons[p];
        for (uint32_t i = 0; i < polygon->count; i++)
            for (int axis = 0; axis < 3; axis++) {
                double c = component(w->corners[polygon->first + i], axis);
                node->low[axis] = fmin(node->low[axis], c - BOX_MARGIN);
                node->high[axis] = fmax(node->high[axis], c + BOX_MARGIN);
            }
    }
}

/* Halving the count at each level bounds the depth by log2 of the number of polygons. */
static void build(world *w, uint32_t at, uint32_t first, uint32_t count)
{
    world_node *node = &w->nodes[at];
    box_of(w, node, first, count);
    node->first = first;
    node->count = count;
    if (count <= LEAF_POLYGONS)
        return;
    sort_axis = 0;
    for (int axis = 1; axis < 3; axis++)
        if (node->high[axis] - node->low[axis] > node->high[sort_axis] - node->low[sort_axis])
            sort_axis = axis;
    qsort(w->polygons + first, count, sizeof *w->polygons, by_middle);
    uint32_t children = w->node_count;
    w->node_count += 2;
    node->first = children;
    node->count = 0;
    build(w, children, first, count / 2);
    build(w, children + 1, first + count / 2, count - count / 2);
}

void world_prepare(world *w)
{
    for (uint32_t p = 0; p < w->polygon_count; p++)
        plane_of(w, &w->polygons[p]);
    w->nodes = allocate((size_t)w->polygon_count * 2, sizeof *w->nodes);
    w->node_count = 1;
    build(w, 0, 0, w->polygon_count);
}

typedef struct {
    const world *w;
    const world_ray *ray;
    double reciprocal[3], eye[3];
    vector across, along; /* perpendicular to the ray and to each other */
} search;

static search search_begin(const world *w, const world_ray *ray)
{
    search s = {.w = w, .ray = ray};
    for (int axis = 0; axis < 3; axis++) {
        s.reciprocal[axis] = 1.0 / component(ray->direction, axis);
        s.eye[axis] = component(ray->eye, axis);
    }
    vector d = ray->direction;
    double ax = fabs(d.x), ay = fabs(d.y), az = fabs(d.z);
    vector least = ax <= ay && ax <= az ? (vector){1, 0, 0}
                   : ay <= az           ? (vector){0, 1, 0}
                                        : (vector){0, 0, 1};
    s.across = vector_cross(d, least);
    s.along = vector_cross(d, s.across);
    return s;
}

/* Returns the depth at which the ray enters the box, or infinity. A 0/0 compares false, so its
 * slab does not restrict the interval; the test then errs on the side of entering. */
static double box_entry(const search *s, const world_node *node, double far)
{
    double enter = s->ray->near, leave = far;
    for (int axis = 0; axis < 3; axis++) {
        double a = (node->low[axis] - s->eye[axis]) * s->reciprocal[axis];
        double b = (node->high[axis] - s->eye[axis]) * s->reciprocal[axis];
        if (a > b) {
            double swap = a;
            a = b;
            b = swap;
        }
        if (a > enter)
            enter = a;
        if (b < leave)
            leave = b;
    }
    return enter <= leave ? enter : INFINITY;
}

/* Projecting along the ray flattens the polygon to two dimensions and the ray to the origin. The
 * ray meets the polygon where the outline's winding number about the origin is not 0. */
static bool outline_holds_ray(const search *s, const world_polygon *polygon)
{
    const vector *corners = s->w->corners + polygon->first;
    vector last = vector_minus(corners[polygon->count - 1], s->ray->eye);
    double au = vector_dot(last, s->across), av = vector_dot(last, s->along);
    int winding = 0;
    for (uint32_t i = 0; i < polygon->count; i++) {
        vector corner = vector_minus(corners[i], s->ray->eye);
        double bu = vector_dot(corner, s->across), bv = vector_dot(corner, s->along);
        double side = au * bv - av * bu;
        if (av <= 0 && bv > 0 && side <= 0)
            winding++;
        if (bv <= 0 && av > 0 && side >= 0)
            winding--;
        au = bu;
        av = bv;
    }
    return winding != 0;
}

/* Returns the depth of the hit, within near..far, or infinity. */
static double polygon_depth(const search *s, const world_polygon *polygon, double far)
{
    double slope = vector_dot(polygon->normal, s->ray->direction);
    double z = vector_dot(polygon->normal, vector_minus(polygon->middle, s->ray->eye)) / slope;
    if (!(z >= s->ray->near && z <= far) || !outline_holds_ray(s, polygon))
        return INFINITY;
    return z;
}

/* Visits every leaf that the ray meets before hit->z, nearer halves first. Finds the nearest
 * hit; or, where colour >= 0, any hit of that colour. */
static void walk_nodes(const search *s, world_hit *hit, int colour)
{
    uint32_t stack[DEPTH_STACK];
    int height = 0;
    stack[height++] = 0;
    while (height) {
        const world_node *node = &s->w->nodes[stack[--height]];
        if (box_entry(s, node, hit->z) == (double)INFINITY)
            continue;
        if (!node->count) {
            double first = box_entry(s, &s->w->nodes[node->first], hit->z);
            double second = box_entry(s, &s->w->nodes[node->first + 1], hit->z);
            bool swap = second < first;
            if (fmax(first, second) < (double)INFINITY)
                stack[height++] = node->first + !swap;
            if (fmin(first, second) < (double)INFINITY)
                stack[height++] = node->first + swap;
            continue;
        }
        for (uint32_t p = node->first; p < node->first + node->count; p++) {
            const world_polygon *polygon = &s->w->polygons[p];
            if (colour >= 0 && polygon->colour != colour)
                continue;
            double z = polygon_depth(s, polygon, hit->z);
            if (z == (double)INFINITY)
                continue;
            hit->found = true;
            hit->colour = polygon->colour;
            if (colour >= 0)
                return;
            hit->z = z;
        }
    }
}

world_hit world_nearest(const world *w, const world_ray *ray)
{
    search s = search_begin(w, ray);
    world_hit hit = {false, ray->far, 0};
    walk_nodes(&s, &hit, -1);
    return hit;
}

bool world_shows(const world *w, const world_ray *ray, uint8_t colour)
{
    world_hit nearest = world_nearest(w, ray);
    if (!nearest.found)
        return false;
    search s = search_begin(w, ray);
    world_hit hit = {false, fmin(nearest.z * (1 + TIE), ray->far), 0};
    walk_nodes(&s, &hit, colour);
    return hit.found;
}
