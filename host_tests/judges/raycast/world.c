/* SPDX-License-Identifier: MIT */
#include "world.h"

#include <math.h>
#include <stdlib.h>

#include "file.h"

enum {
    POINT = 20
};

static double part(const uint8_t *at)
{
    return get_i32(at) / 1073741824.0;
}

static double length(const uint8_t *at)
{
    return get_i32(at) / 65536.0;
}

static double of_point(const uint8_t *point, const light_face *face)
{
    const vector at = {length(point), length(point + 4), length(point + 8)};
    const vector way = vector_minus(at, face->middle);
    const double reach = length(point + 12), away = sqrt(vector_dot(way, way));
    const double facing = vector_dot(way, face->normal);
    return away > 0 && away < reach && facing > 0
               ? part(point + 16) * facing / away * (1 - away * away / (reach * reach))
               : 0;
}

/* place light: definition: the ray-cast oracle */
/* place light: a new setting: the ray-cast oracle's reader */
uint8_t light_colour(const light_tables *light, const light_face *face, vector eye, vector forward)
{
    const uint8_t *base = light->base;
    const vector way = {part(base + 8), part(base + 12), part(base + 16)};
    const double fog_near = length(base + 20), fog_far = length(base + 24);
    double bright = part(base) + part(base + 4) * fmax(-vector_dot(way, face->normal), 0);
    for (uint32_t i = 0; i < light->point_count; i++)
        bright += of_point(light->points + (size_t)POINT * i, face);
    bright = fmin(bright, 1);
    if (fog_far > 0) {
        const double depth = vector_dot(forward, vector_minus(face->middle, eye));
        bright *= fmin(1, fmax(0, (fog_far - depth) / (fog_far - fog_near)));
    }
    const uint32_t level = (uint32_t)(bright * (light->levels - 1) + 0.5);
    return light->ramp[256 * level + face->material];
}

#define LEAF_POLYGONS 2
#define DEPTH_STACK   96
#define DEPTH_UNEVEN  48
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

typedef struct {
    double low[3], high[3];
} box;

static const box nothing = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static void grow(box *grown, const world *w, const world_polygon *polygon)
{
    for (uint32_t i = 0; i < polygon->count; i++)
        for (int axis = 0; axis < 3; axis++) {
            double c = component(w->corners[polygon->first + i], axis);
            if (c < grown->low[axis])
                grown->low[axis] = c;
            if (c > grown->high[axis])
                grown->high[axis] = c;
        }
}

static void box_of(const world *w, world_node *node, uint32_t first, uint32_t count)
{
    box all = nothing;
    for (uint32_t p = first; p < first + count; p++)
        grow(&all, w, &w->polygons[p]);
    for (int axis = 0; axis < 3; axis++) {
        node->bounds[0][axis] = all.low[axis] - BOX_MARGIN;
        node->bounds[1][axis] = all.high[axis] + BOX_MARGIN;
    }
}

/* Half of the surface of a box: how likely a ray meets it. */
static double half_surface(const box *of)
{
    double a = of->high[0] - of->low[0], b = of->high[1] - of->low[1], c = of->high[2] - of->low[2];
    return a * b + b * c + c * a;
}

static void sort_by_middle(world *w, uint32_t first, uint32_t count, int axis)
{
    sort_axis = axis;
    qsort(w->polygons + first, count, sizeof *w->polygons, by_middle);
}

/* Returns how many of the polygons, sorted, to put into the first half so that a ray is expected
 * to test the fewest: the sum over both halves of surface times polygons, which *least gets where
 * it is less. Returns 0 where no number gives less. */
static uint32_t best_half(const world *w, uint32_t first, uint32_t count, double *surfaces,
                          double *least)
{
    box right = nothing, left = nothing;
    for (uint32_t i = count - 1; i > 0; i--) {
        grow(&right, w, &w->polygons[first + i]);
        surfaces[i] = half_surface(&right);
    }
    uint32_t best = 0;
    for (uint32_t i = 1; i < count; i++) {
        grow(&left, w, &w->polygons[first + i - 1]);
        double cost = half_surface(&left) * i + surfaces[i] * (count - i);
        if (cost < *least) {
            *least = cost;
            best = i;
        }
    }
    return best;
}

/* Sorts polygons and returns how many of them are the first half. */
static uint32_t halve(world *w, uint32_t first, uint32_t count, double *surfaces, int depth)
{
    double least = INFINITY;
    int axis = 0;
    uint32_t half = 0;
    for (int each = 0; each < 3; each++) {
        sort_by_middle(w, first, count, each);
        uint32_t best = best_half(w, first, count, surfaces, &least);
        if (best) {
            half = best;
            axis = each;
        }
    }
    sort_by_middle(w, first, count, axis);
    return half && depth < DEPTH_UNEVEN ? half : count / 2;
}

/* Up to DEPTH_UNEVEN the halves may be uneven; below, halving the count bounds the depth by log2
 * of the number of polygons. */
static void build(world *w, uint32_t at, uint32_t first, uint32_t count, double *surfaces,
                  int depth)
{
    world_node *node = &w->nodes[at];
    box_of(w, node, first, count);
    node->first = first;
    node->count = count;
    if (count <= LEAF_POLYGONS)
        return;
    uint32_t half = halve(w, first, count, surfaces, depth);
    uint32_t children = w->node_count;
    w->node_count += 2;
    node->first = children;
    node->count = 0;
    build(w, children, first, half, surfaces, depth + 1);
    build(w, children + 1, first + half, count - half, surfaces, depth + 1);
}

void world_prepare(world *w)
{
    for (uint32_t p = 0; p < w->polygon_count; p++)
        plane_of(w, &w->polygons[p]);
    w->nodes = allocate((size_t)w->polygon_count * 2, sizeof *w->nodes);
    w->node_count = 1;
    double *surfaces = allocate(w->polygon_count, sizeof *surfaces);
    build(w, 0, 0, w->polygon_count, surfaces, 0);
    free(surfaces);
}

typedef struct {
    const world *w;
    const world_ray *ray;
    double reciprocal[3], eye[3];
    int side[3];          /* of a box, which the ray meets first: 0 low, 1 high */
    vector across, along; /* perpendicular to the ray and to each other */
} search;

static search search_begin(const world *w, const world_ray *ray)
{
    search s = {.w = w, .ray = ray};
    for (int axis = 0; axis < 3; axis++) {
        s.reciprocal[axis] = 1.0 / component(ray->direction, axis);
        s.eye[axis] = component(ray->eye, axis);
        s.side[axis] = s.reciprocal[axis] < 0;
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
static inline double box_entry(const search *s, const world_node *node, double far)
{
    double enter = s->ray->near, leave = far;
    for (int axis = 0; axis < 3; axis++) {
        double a = (node->bounds[s->side[axis]][axis] - s->eye[axis]) * s->reciprocal[axis];
        double b = (node->bounds[!s->side[axis]][axis] - s->eye[axis]) * s->reciprocal[axis];
        enter = a > enter ? a : enter;
        leave = b < leave ? b : leave;
    }
    return enter <= leave ? enter : (double)INFINITY;
}

/* place fill-rule: definition: winding and ties of the ray-cast oracle */
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

/* Returns the depth of the hit, within near..far, or infinity. A polygon is not there for a ray
 * that meets its back. */
static double polygon_depth(const search *s, const world_polygon *polygon, double far)
{
    double slope = vector_dot(polygon->normal, s->ray->direction);
    double z = vector_dot(polygon->normal, vector_minus(polygon->middle, s->ray->eye)) / slope;
    if (!(slope < 0 && z >= s->ray->near && z <= far) || !outline_holds_ray(s, polygon))
        return INFINITY;
    return z;
}

/* Visits every leaf that the ray meets before hit->z, nearer halves first. Finds the nearest
 * hit; or, where colour >= 0, any hit of that colour. */
static void walk_nodes(const search *s, world_hit *hit, int colour)
{
    struct {
        uint32_t node;
        double entry;
    } stack[DEPTH_STACK];
    stack[0].node = 0;
    stack[0].entry = box_entry(s, &s->w->nodes[0], hit->z);
    int height = s->w->polygon_count > 0 && stack[0].entry < (double)INFINITY;
    while (height) {
        height--;
        if (stack[height].entry > hit->z)
            continue;
        const world_node *node = &s->w->nodes[stack[height].node];
        if (!node->count) {
            double first = box_entry(s, &s->w->nodes[node->first], hit->z);
            double second = box_entry(s, &s->w->nodes[node->first + 1], hit->z);
            bool swap = second < first;
            double far = swap ? first : second, near = swap ? second : first;
            stack[height].node = node->first + !swap;
            stack[height].entry = far;
            height += far < (double)INFINITY;
            stack[height].node = node->first + swap;
            stack[height].entry = near;
            height += near < (double)INFINITY;
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
            hit->polygon = polygon;
        }
    }
}

world_hit world_nearest(const world *w, const world_ray *ray, const world_polygon *guess)
{
    search s = search_begin(w, ray);
    world_hit hit = {.z = ray->far};
    double z = guess ? polygon_depth(&s, guess, ray->far) : (double)INFINITY;
    if (z < (double)INFINITY)
        hit = (world_hit){true, z, guess->colour, guess};
    walk_nodes(&s, &hit, -1);
    return hit;
}

bool world_shows(const world *w, const world_ray *ray, uint8_t colour)
{
    world_hit nearest = world_nearest(w, ray, NULL);
    if (!nearest.found)
        return false;
    search s = search_begin(w, ray);
    world_hit hit = {.z = fmin(nearest.z * (1 + TIE), ray->far)};
    walk_nodes(&s, &hit, colour);
    return hit.found;
}
