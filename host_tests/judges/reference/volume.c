/* SPDX-License-Identifier: MIT */
#include "reference/volume.h"

#include <math.h>

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
static void cut(const ref_volume_polygon *in, const ref_half_space *plane, ref_volume_polygon *out)
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
        cut(&before, &planes[i], out);
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
