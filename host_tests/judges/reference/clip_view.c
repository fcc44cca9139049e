/* SPDX-License-Identifier: MIT */
#include "reference/clip_view.h"

#include <math.h>

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
    frustum.planes[REF_PLANE_LEFT] = side_plane(false, focal, x, inset);
    frustum.planes[REF_PLANE_RIGHT] = side_plane(false, -focal, lens->width - x, inset);
    frustum.planes[REF_PLANE_BOTTOM] = side_plane(true, focal, lens->height - y, inset);
    frustum.planes[REF_PLANE_TOP] = side_plane(true, -focal, y, inset);
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

static long double between(long double inside, long double outside, ref_wide t)
{
    return (long double)(inside + t * ((ref_wide)outside - inside));
}

/* Computes the intersection from the inside end to the outside end, whatever the direction of
 * the edge. */
static ref_view_vertex intersection(const ref_view_vertex *inside, const ref_view_vertex *outside,
                                    ref_wide t)
{
    const ref_view_point *from = &inside->position, *to = &outside->position;
    return (ref_view_vertex){
        .position = {between(from->x, to->x, t), between(from->y, to->y, t),
                     between(from->z, to->z, t)},
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
    ref_clip_result result = ref_cut_by_sides(sides, in->count, &cut);
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
                      : intersection(&in->vertices[inner], &in->vertices[outer],
                                     distances[inner] / (distances[inner] - distances[outer]));
    }
    return REF_CLIP_CUT;
}
