/* SPDX-License-Identifier: MIT */
#include "reference/clip.h"

#include <math.h>

/* A vertex that is left: the polygon's vertex number inner, where outer is negative; else the
 * intersection of the edge from inner, which is inside, to outer. */
typedef struct {
    int inner, outer;
} ref_cut_vertex;

typedef struct {
    ref_cut_vertex vertices[REF_POLYGON_CAPACITY];
    int count;
} ref_cut;

/* Appends a vertex if there is space. Counts it in any case. */
static void add(ref_cut *cut, int inner, int outer)
{
    if (cut->count < REF_POLYGON_CAPACITY) {
        cut->vertices[cut->count] = (ref_cut_vertex){inner, outer};
    }
    cut->count++;
}

/* What a plane leaves of a polygon, given only on which side each vertex lies. sides: 1 inside, 0 in
 * the plane, -1 outside. The cut is valid where REF_CLIP_CUT is returned. */
static ref_clip_result cut_by_sides(const int *sides, int count, ref_cut *cut)
{
    int inside_count = 0;
    for (int i = 0; i < count; i++) {
        inside_count += sides[i] >= 0;
    }
    if (inside_count == 0) {
        return REF_CLIP_OUTSIDE;
    }
    if (inside_count == count) {
        return REF_CLIP_INSIDE;
    }
    cut->count = 0;
    for (int i = 0; i < count; i++) {
        int next = (i + 1) % count;
        bool from_inside = sides[i] >= 0, to_inside = sides[next] >= 0;
        if (from_inside) {
            add(cut, i, -1);
        }
        int inner = from_inside ? i : next, outer = from_inside ? next : i;
        if (from_inside != to_inside &&
            sides[inner] > 0) { /* at 0 the inside end is the intersection */
            add(cut, inner, outer);
        }
    }
    if (cut->count < 3) {
        return REF_CLIP_DEGENERATE;
    }
    return cut->count > REF_POLYGON_CAPACITY ? REF_CLIP_CAPACITY : REF_CLIP_CUT;
}

static double between(double inside, double outside, double t)
{
    return inside + t * (outside - inside);
}

/* Computes the intersection from the inside end to the outside end, whatever the direction of
 * the edge: neighbours get the same vertex. */
static ref_vertex intersection(const ref_vertex *inside, const ref_vertex *outside, double t)
{
    return (ref_vertex){
        .position = {between(inside->position.x, outside->position.x, t),
                     between(inside->position.y, outside->position.y, t),
                     between(inside->position.z, outside->position.z, t)},
        .u = between(inside->u, outside->u, t),
        .v = between(inside->v, outside->v, t),
    };
}

/* How far along the edge from the inside end the plane is. */
static double fraction(long double inside, long double outside)
{
    return (double)(inside / (inside - outside));
}

ref_clip_result ref_clip_world_to_plane(const ref_polygon *in, const ref_plane *plane,
                                        ref_polygon *out)
{
    long double distances[REF_POLYGON_CAPACITY];
    int sides[REF_POLYGON_CAPACITY];
    ref_cut cut;
    for (int i = 0; i < in->count; i++) {
        distances[i] = ref_plane_distance(plane, &in->vertices[i].position);
        sides[i] = (distances[i] > 0) - (distances[i] < 0);
    }
    ref_clip_result result = cut_by_sides(sides, in->count, &cut);
    if (result == REF_CLIP_INSIDE) {
        *out = *in;
    }
    if (result != REF_CLIP_CUT) {
        return result;
    }
    out->colour = in->colour;
    out->count = cut.count;
    for (int i = 0; i < cut.count; i++) {
        const ref_cut_vertex *vertex = &cut.vertices[i];
        out->vertices[i] = in->vertices[vertex->inner];
        if (vertex->outer >= 0) {
            out->vertices[i] =
                intersection(&in->vertices[vertex->inner], &in->vertices[vertex->outer],
                             fraction(distances[vertex->inner], distances[vertex->outer]));
        }
    }
    return REF_CLIP_CUT;
}

ref_clip_result ref_clip_world_to_planes(const ref_polygon *in, const ref_frustum *frustum,
                                         unsigned planes, ref_polygon *out)
{
    ref_clip_result result = REF_CLIP_INSIDE;
    ref_polygon before = *in;
    *out = before;
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        if ((planes >> i & 1) == 0) {
            continue;
        }
        ref_clip_result one = ref_clip_world_to_plane(&before, &frustum->planes[i], out);
        if (one != REF_CLIP_INSIDE && one != REF_CLIP_CUT) {
            return one;
        }
        if (one == REF_CLIP_CUT) {
            result = REF_CLIP_CUT;
        }
        before = *out;
    }
    return result;
}

ref_clip_result ref_clip_world_to_frustum(const ref_polygon *in, const ref_frustum *frustum,
                                          ref_polygon *out)
{
    return ref_clip_world_to_planes(in, frustum, (1u << REF_PLANE_COUNT) - 1, out);
}

static ref_view_plane side_plane(bool upright, double across, double along, double inset)
{
    double length = sqrt(across * across + along * along);
    return (ref_view_plane){upright, across / length, along / length, inset};
}

ref_view_frustum ref_view_frustum_from_lens(const ref_lens *lens)
{
    double x = lens->centre_x, y = lens->centre_y;
    double focal = lens->focal, inset = lens->inset;
    ref_view_frustum frustum;
    if (lens->scale != 0) {
        const double scale = lens->scale;
        frustum.planes[REF_PLANE_LEFT] = side_plane(false, 1, 0, -x / scale);
        frustum.planes[REF_PLANE_RIGHT] = side_plane(false, -1, 0, (x - lens->width) / scale);
        frustum.planes[REF_PLANE_BOTTOM] = side_plane(true, 1, 0, (y - lens->height) / scale);
        frustum.planes[REF_PLANE_TOP] = side_plane(true, -1, 0, -y / scale);
    } else {
        frustum.planes[REF_PLANE_LEFT] = side_plane(false, focal, x, inset);
        frustum.planes[REF_PLANE_RIGHT] = side_plane(false, -focal, lens->width - x, inset);
        frustum.planes[REF_PLANE_BOTTOM] = side_plane(true, focal, lens->height - y, inset);
        frustum.planes[REF_PLANE_TOP] = side_plane(true, -focal, y, inset);
    }
    frustum.planes[REF_PLANE_NEAR] = (ref_view_plane){false, 0, 1, lens->near_z + inset};
    frustum.planes[REF_PLANE_FAR] = (ref_view_plane){false, 0, -1, inset - lens->far_z};
    return frustum;
}

ref_wide ref_view_distance(const ref_view_plane *plane, const ref_view_point *point)
{
    ref_wide across = plane->upright ? point->y : point->x;
    return plane->across * across + plane->along * (ref_wide)point->z - plane->distance;
}

unsigned ref_outcode(const ref_view_frustum *frustum, const ref_view_point *point)
{
    unsigned outside = 0;
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        outside |= ref_view_distance(&frustum->planes[i], point) < 0 ? 1u << i : 0;
    }
    return outside;
}

static long double between_wide(long double inside, long double outside, ref_wide t)
{
    return (long double)(inside + t * ((ref_wide)outside - inside));
}

/* Computes the intersection from the inside end to the outside end, whatever the direction of
 * the edge. */
static ref_view_vertex view_intersection(const ref_view_vertex *inside,
                                         const ref_view_vertex *outside, ref_wide t)
{
    const ref_view_point *from = &inside->position, *to = &outside->position;
    return (ref_view_vertex){
        .position = {between_wide(from->x, to->x, t), between_wide(from->y, to->y, t),
                     between_wide(from->z, to->z, t)},
    };
}

ref_clip_result ref_clip_view_to_plane(const ref_view_polygon *in, const ref_view_plane *plane,
                                       ref_view_polygon *out)
{
    ref_wide distances[REF_POLYGON_CAPACITY];
    int sides[REF_POLYGON_CAPACITY];
    ref_cut cut;
    for (int i = 0; i < in->count; i++) {
        distances[i] = ref_view_distance(plane, &in->vertices[i].position);
        sides[i] = (distances[i] > 0) - (distances[i] < 0);
    }
    ref_clip_result result = cut_by_sides(sides, in->count, &cut);
    if (result == REF_CLIP_INSIDE) {
        *out = *in;
    }
    if (result != REF_CLIP_CUT) {
        return result;
    }
    out->colour = in->colour;
    out->count = cut.count;
    for (int i = 0; i < cut.count; i++) {
        const int inner = cut.vertices[i].inner, outer = cut.vertices[i].outer;
        out->vertices[i] =
            outer < 0 ? in->vertices[inner]
                      : view_intersection(&in->vertices[inner], &in->vertices[outer],
                                          distances[inner] / (distances[inner] - distances[outer]));
    }
    return REF_CLIP_CUT;
}

/* A point is inside where a x + b y + c >= 0. */
typedef struct {
    double a, b, c;
} half_plane;

static double distance(const half_plane *of, const ref_screen_point *at)
{
    return of->a * at->x + of->b * at->y + of->c;
}

static void cut(const ref_screen_polygon *in, const half_plane *by, ref_screen_polygon *out)
{
    out->colour = in->colour;
    out->count = 0;
    for (int i = 0; i < in->count; i++) {
        const ref_screen_point *here = &in->points[i], *next = &in->points[(i + 1) % in->count];
        const double from = distance(by, here), to = distance(by, next);
        if (from >= 0) {
            out->points[out->count++] = *here;
        }
        if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
            const double t = from / (from - to);
            out->points[out->count++] = (ref_screen_point){here->x + t * (next->x - here->x),
                                                           here->y + t * (next->y - here->y)};
        }
    }
}

bool ref_clip_to_rectangle(const ref_screen_polygon *in, const ref_rectangle *rectangle,
                           ref_screen_polygon *out)
{
    const half_plane borders[] = {{1, 0, -rectangle->left},
                                  {-1, 0, rectangle->right},
                                  {0, 1, -rectangle->top},
                                  {0, -1, rectangle->bottom}};
    ref_screen_polygon before = *in;
    for (int i = 0; i < 4 && before.count >= 3; i++) {
        cut(&before, &borders[i], out);
        before = *out;
    }
    *out = before;
    return before.count >= 3;
}

void ref_volume_from_lens(const ref_lens *lens, ref_half_space planes[REF_PLANE_COUNT])
{
    ref_view_frustum frustum = ref_view_frustum_from_lens(lens);
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        const ref_view_plane *plane = &frustum.planes[i];
        planes[i] =
            (ref_half_space){plane->upright ? 0 : plane->across, plane->upright ? plane->across : 0,
                             plane->along, -(ref_wide)plane->distance};
    }
}

void ref_volume_from_window(double left, double right, double bottom, double top, double near_z,
                            double far_z, ref_half_space planes[REF_PLANE_COUNT])
{
    planes[REF_PLANE_NEAR] = (ref_half_space){0, 0, 1, -near_z};
    planes[REF_PLANE_FAR] = (ref_half_space){0, 0, -1, far_z};
    planes[REF_PLANE_LEFT] = (ref_half_space){near_z, 0, -left, 0};
    planes[REF_PLANE_RIGHT] = (ref_half_space){-near_z, 0, right, 0};
    planes[REF_PLANE_BOTTOM] = (ref_half_space){0, near_z, -bottom, 0};
    planes[REF_PLANE_TOP] = (ref_half_space){0, -near_z, top, 0};
}

ref_wide ref_half_space_distance(const ref_half_space *plane, const ref_volume_vertex *vertex)
{
    return plane->a * vertex->x + plane->b * vertex->y + plane->c * vertex->z + plane->d;
}

bool ref_volume_holds(const ref_half_space *planes, int count, const ref_volume_vertex *vertex)
{
    for (int i = 0; i < count; i++) {
        if (ref_half_space_distance(&planes[i], vertex) < 0) {
            return false;
        }
    }
    return true;
}

ref_volume_vertex ref_volume_between(const ref_volume_vertex *from, const ref_volume_vertex *to,
                                     ref_wide t)
{
    ref_volume_vertex vertex = {from->x + t * (to->x - from->x),
                                from->y + t * (to->y - from->y),
                                from->z + t * (to->z - from->z),
                                {0}};
    for (int i = 0; i < REF_CARRIED_MAX; i++) {
        vertex.carried[i] =
            (double)(from->carried[i] + t * ((ref_wide)to->carried[i] - from->carried[i]));
    }
    return vertex;
}

/* Clips a polygon to one plane. The intersection of an edge is computed from its inside end. */
static void cut_volume(const ref_volume_polygon *in, const ref_half_space *plane,
                       ref_volume_polygon *out)
{
    out->count = 0;
    out->carried = in->carried;
    for (int i = 0; i < in->count; i++) {
        const ref_volume_vertex *a = &in->vertices[i], *b = &in->vertices[(i + 1) % in->count];
        ref_wide da = ref_half_space_distance(plane, a), db = ref_half_space_distance(plane, b);
        if (da >= 0) {
            out->vertices[out->count++] = *a;
        }
        if (da > 0 && db < 0) {
            out->vertices[out->count++] = ref_volume_between(a, b, da / (da - db));
        } else if (da < 0 && db > 0) {
            out->vertices[out->count++] = ref_volume_between(b, a, db / (db - da));
        }
    }
}

bool ref_clip_to_volume(const ref_volume_polygon *in, const ref_half_space *planes, int count,
                        ref_volume_polygon *out)
{
    bool any = false;
    ref_volume_polygon before = *in;
    for (int i = 0; i < count && before.count > 0; i++) {
        for (int k = 0; k < before.count; k++) {
            any |= ref_half_space_distance(&planes[i], &before.vertices[k]) < 0;
        }
        cut_volume(&before, &planes[i], out);
        before = *out;
    }
    *out = before;
    return any;
}

bool ref_clip_line(const ref_volume_vertex *from, const ref_volume_vertex *to,
                   const ref_half_space *planes, int count, ref_wide *enter, ref_wide *leave)
{
    *enter = 0;
    *leave = 1;
    for (int i = 0; i < count; i++) {
        ref_wide a = ref_half_space_distance(&planes[i], from);
        ref_wide b = ref_half_space_distance(&planes[i], to);
        if (a < 0 && b < 0) {
            return false;
        }
        if (a < 0 && a / (a - b) > *enter) {
            *enter = a / (a - b);
        }
        if (b < 0 && a / (a - b) < *leave) {
            *leave = a / (a - b);
        }
    }
    return *enter <= *leave;
}

/* The difference of the distances is the normal times that of the points, and is exact where each
 * distance is. */
ref_line_relation ref_line_meet_plane(const ref_volume_vertex *from, const ref_volume_vertex *to,
                                      const ref_half_space *plane, ref_wide *t)
{
    const ref_wide a = ref_half_space_distance(plane, from);
    const ref_wide b = ref_half_space_distance(plane, to);
    if (a == b) {
        return a == 0 ? REF_LINE_LIES_IN : REF_LINE_IS_PARALLEL;
    }
    *t = a / (a - b);
    return REF_LINE_MEETS;
}
