/* SPDX-License-Identifier: MIT */
#include "listing.h"

#include <string.h>

#define PLANES  4
#define EPSILON ((real)0.0001) /* every plane moves in by this much */

typedef struct {
    listing_point normal; /* points inside */
    real distance;
} listing_plane;

typedef struct {
    uint8_t count, colour;
    listing_point vertices[LISTING_POLYGON_MAX];
} listing_polygon;

typedef struct {
    real x, y;
} screen_point;

typedef struct {
    uint8_t count, colour;
    screen_point points[LISTING_POLYGON_MAX];
} screen_polygon;

typedef struct {
    listing_point position, right, up, forward;
    listing_plane planes[PLANES];
} listing_view;

static real dot(const listing_point *a, const listing_point *b)
{
    return a->v[0] * b->v[0] + a->v[1] * b->v[1] + a->v[2] * b->v[2];
}

static void cross(const listing_point *a, const listing_point *b, listing_point *out)
{
    out->v[0] = a->v[1] * b->v[2] - a->v[2] * b->v[1];
    out->v[1] = a->v[2] * b->v[0] - a->v[0] * b->v[2];
    out->v[2] = a->v[0] * b->v[1] - a->v[1] * b->v[0];
}

static void subtract(const listing_point *a, const listing_point *b, listing_point *out)
{
    for (int i = 0; i < 3; i++) {
        out->v[i] = a->v[i] - b->v[i];
    }
}

static void multiply(real (*a)[3], real (*b)[3], real (*out)[3])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
}

/* Three rotations, one after the other; their product's rows are the view's
 * axes in the world. */
static void set_view(listing_view *view, const listing_eye *eye)
{
    real s = REAL(sin)(eye->roll), c = REAL(cos)(eye->roll);
    real roll[3][3] = {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
    s = REAL(sin)(eye->pitch), c = REAL(cos)(eye->pitch);
    real pitch[3][3] = {{1, 0, 0}, {0, c, -s}, {0, s, c}};
    s = REAL(sin)(eye->yaw), c = REAL(cos)(eye->yaw);
    real yaw[3][3] = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
    real pitched[3][3], turned[3][3];
    multiply(pitch, yaw, pitched);
    multiply(roll, pitched, turned);
    view->position = eye->position;
    for (int i = 0; i < 3; i++) {
        view->right.v[i] = turned[0][i];
        view->up.v[i] = turned[1][i];
        view->forward.v[i] = turned[2][i];
    }
}

static void set_plane(const listing_view *view, real x, real y, real z, listing_plane *plane)
{
    for (int i = 0; i < 3; i++) {
        plane->normal.v[i] = x * view->right.v[i] + y * view->up.v[i] + z * view->forward.v[i];
    }
    plane->distance = dot(&view->position, &plane->normal) + EPSILON;
}

static void set_frustum(listing_view *view, real focal, const listing_screen *screen)
{
    real angle = REAL(atan)((real)screen->width / 2 / focal);
    real s = REAL(sin)(angle), c = REAL(cos)(angle);
    set_plane(view, c, 0, s, &view->planes[0]);
    set_plane(view, -c, 0, s, &view->planes[1]);
    angle = REAL(atan)((real)screen->height / 2 / focal);
    s = REAL(sin)(angle), c = REAL(cos)(angle);
    set_plane(view, 0, c, s, &view->planes[2]);
    set_plane(view, 0, -c, s, &view->planes[3]);
}

/* Sorts the objects into a list, far to near, one after the other. */
static listing_object *sort_objects(listing_world *world, const listing_point *eye)
{
    listing_object *first = NULL;
    for (uint32_t i = 0; i < world->object_count; i++) {
        listing_object *object = &world->objects[i];
        listing_object **place = &first;
        listing_point away;
        subtract(&object->centre, eye, &away);
        object->distance = REAL(sqrt)(dot(&away, &away));
        while (*place != NULL &&
               ((*place)->layer < object->layer ||
                ((*place)->layer == object->layer && object->distance < (*place)->distance))) {
            place = &(*place)->next;
        }
        object->next = *place;
        *place = object;
    }
    return first;
}

/* Clockwise as seen from the front: edge by edge the cross product points away
 * from who sees the front. */
static bool faces_viewer(const listing_polygon *polygon, const listing_point *eye)
{
    listing_point sight, first, second, normal;
    subtract(&polygon->vertices[0], eye, &sight);
    subtract(&polygon->vertices[0], &polygon->vertices[1], &first);
    subtract(&polygon->vertices[2], &polygon->vertices[1], &second);
    cross(&first, &second, &normal);
    return dot(&sight, &normal) > 0;
}

/* Sutherland and Hodgman: edge by edge. False where nothing is left. */
static bool clip_to_plane(const listing_polygon *in, const listing_plane *plane,
                          listing_polygon *out)
{
    uint32_t count = 0;
    real current = dot(&in->vertices[0], &plane->normal);
    bool current_inside = current >= plane->distance;
    for (uint32_t i = 0; i < in->count; i++) {
        const listing_point *from = &in->vertices[i];
        const listing_point *to = &in->vertices[i + 1u == in->count ? 0 : i + 1u];
        real next = dot(to, &plane->normal);
        bool next_inside = next >= plane->distance;
        if (current_inside) {
            out->vertices[count++] = *from;
        }
        if (current_inside != next_inside) {
            real part = (plane->distance - current) / (next - current);
            for (int j = 0; j < 3; j++) {
                out->vertices[count].v[j] = from->v[j] + (to->v[j] - from->v[j]) * part;
            }
            count++;
        }
        current = next;
        current_inside = next_inside;
    }
    out->count = (uint8_t)count;
    out->colour = in->colour;
    return count >= 3;
}

static bool clip_to_frustum(const listing_polygon *in, const listing_view *view,
                            listing_polygon *out)
{
    listing_polygon between[2];
    const listing_polygon *current = in;
    for (int i = 0; i < PLANES - 1; i++) {
        if (!clip_to_plane(current, &view->planes[i], &between[i & 1])) {
            return false;
        }
        current = &between[i & 1];
    }
    return clip_to_plane(current, &view->planes[PLANES - 1], out);
}

static void transform(const listing_polygon *in, const listing_view *view, listing_polygon *out)
{
    for (uint32_t i = 0; i < in->count; i++) {
        listing_point moved;
        subtract(&in->vertices[i], &view->position, &moved);
        out->vertices[i].v[0] = dot(&moved, &view->right);
        out->vertices[i].v[1] = dot(&moved, &view->up);
        out->vertices[i].v[2] = dot(&moved, &view->forward);
    }
    out->colour = in->colour;
    out->count = in->count;
}

static void project(const listing_polygon *in, real focal, const listing_screen *screen,
                    screen_polygon *out)
{
    real centre_x = (real)screen->width / 2, centre_y = (real)screen->height / 2;
    for (uint32_t i = 0; i < in->count; i++) {
        real reciprocal = 1 / in->vertices[i].v[2];
        out->points[i].x = in->vertices[i].v[0] * reciprocal * focal + centre_x;
        out->points[i].y = centre_y - in->vertices[i].v[1] * reciprocal * focal;
    }
    out->colour = in->colour;
    out->count = in->count;
}

/* place fill-rule: the chapter's code, with a first_centre of its own */
/* The first row (column) whose centre is at or past a coordinate: the ceiling
 * of coordinate - 1/2, for coordinates that clipping left at or above 0, where
 * cutting off is rounding down. Ties go as they should but for the constant. */
static int first_centre(real coordinate)
{
    return (int)(coordinate + (real)(0.5 - 1e-6));
}

/* An edge of a convex polygon on its way down. */
typedef struct {
    uint32_t point; /* its lower end */
    int end_row;
    real x, step;
} listing_edge;

/* Goes on to the next edge in a direction (1 or count - 1) that reaches a row;
 * false where the polygon ends above it. */
static bool next_edge(const screen_polygon *polygon, listing_edge *edge, uint32_t direction,
                      int row)
{
    for (uint32_t tried = 0; tried < polygon->count; tried++) {
        const screen_point *top = &polygon->points[edge->point];
        edge->point += direction;
        edge->point -= edge->point >= polygon->count ? polygon->count : 0u;
        const screen_point *bottom = &polygon->points[edge->point];
        if (bottom->y < top->y) {
            return false;
        }
        edge->end_row = first_centre(bottom->y);
        if (edge->end_row > row) {
            edge->step = (bottom->x - top->x) / (bottom->y - top->y);
            edge->x = top->x + ((real)row + (real)0.5 - top->y) * edge->step;
            return true;
        }
    }
    return false;
}

static void fill_row(const listing_screen *screen, int row, real from, real to, uint8_t colour)
{
    int x0 = first_centre(from), x1 = first_centre(to);
    x0 = x0 < 0 ? 0 : x0;
    x1 = x1 > screen->width ? screen->width : x1;
    if (x0 < x1 && row >= 0) {
        memset(screen->pixels + (size_t)row * (size_t)screen->width + x0, colour,
               (size_t)(x1 - x0));
    }
}

/* Fills a convex polygon, clockwise on the screen, between its right edges and
 * its left ones. */
static void fill(const screen_polygon *polygon, const listing_screen *screen)
{
    uint32_t top = 0;
    if (polygon->count < 3) {
        return;
    }
    for (uint32_t i = 1; i < polygon->count; i++) {
        if (polygon->points[i].y < polygon->points[top].y) {
            top = i;
        }
    }
    int row = first_centre(polygon->points[top].y);
    listing_edge right = {top, row, 0, 0}, left = {top, row, 0, 0};
    for (; row < screen->height; row++) {
        if ((row >= right.end_row && !next_edge(polygon, &right, 1, row)) ||
            (row >= left.end_row && !next_edge(polygon, &left, polygon->count - 1u, row))) {
            return;
        }
        fill_row(screen, row, left.x, right.x, polygon->colour);
        right.x += right.step;
        left.x += left.step;
    }
}

static void draw_face(const listing_world *world, const listing_object *object,
                      const listing_face *face, const listing_view *view,
                      const listing_screen *screen)
{
    listing_polygon moved, clipped, seen;
    screen_polygon drawn;
    moved.count = face->count;
    moved.colour = face->colour;
    for (uint32_t i = 0; i < face->count; i++) {
        for (int j = 0; j < 3; j++) {
            moved.vertices[i].v[j] = face->vertices[i].v[j] + object->centre.v[j];
        }
    }
    if (!faces_viewer(&moved, &view->position) || !clip_to_frustum(&moved, view, &clipped)) {
        return;
    }
    transform(&clipped, view, &seen);
    project(&seen, world->focal, screen, &drawn);
    fill(&drawn, screen);
}

void listing_draw(listing_world *world, const listing_eye *eye, const listing_screen *screen)
{
    listing_view view;
    set_view(&view, eye);
    set_frustum(&view, world->focal, screen);
    for (const listing_object *object = sort_objects(world, &eye->position); object != NULL;
         object = object->next) {
        for (uint32_t i = 0; i < object->face_count; i++) {
            draw_face(world, object, &object->faces[i], &view, screen);
        }
    }
}
