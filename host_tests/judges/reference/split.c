/* SPDX-License-Identifier: MIT */
#include "reference/split.h"

#include <math.h>

#include "reference/plane.h"

static int32_t between(int32_t front, int32_t behind, long double t)
{
    long double way = t * fabsl((long double)behind - front);
    int64_t whole = (int64_t)floorl(way + 0.5L + 0x1p-25L);
    return (int32_t)(behind < front ? front - whole : front + whole);
}

ref_lattice_point ref_split_edge(const ref_lattice_point *front, const ref_lattice_point *behind,
                                 long double front_distance, long double behind_distance)
{
    long double t = front_distance / (front_distance - behind_distance);
    return (ref_lattice_point){between(front->x, behind->x, t), between(front->y, behind->y, t),
                               between(front->z, behind->z, t)};
}

long double ref_split_distance(const ref_plane *plane, const ref_lattice_point *point)
{
    const ref_point p = {point->x / REF_ONE, point->y / REF_ONE, point->z / REF_ONE};
    return ref_plane_distance(plane, &p);
}

/* Writes the points of one side: those at sign * distance >= 0, and the intersections. Returns
 * how many. */
static int part(const ref_piece *in, const long double *distances, int sign, ref_lattice_point *out)
{
    int count = 0;
    for (int i = 0; i < in->count; i++) {
        int next = (i + 1) % in->count;
        long double here = distances[i], there = distances[next];
        if (sign * here >= 0) {
            out[count++] = in->points[i];
        }
        if (here > 0 && there < 0) {
            out[count++] = ref_split_edge(&in->points[i], &in->points[next], here, there);
        } else if (here < 0 && there > 0) {
            out[count++] = ref_split_edge(&in->points[next], &in->points[i], there, here);
        }
    }
    return count;
}

static void keep(ref_piece *piece, const ref_lattice_point *points, int count)
{
    piece->count = count;
    for (int i = 0; i < count; i++) {
        piece->points[i] = points[i];
    }
}

ref_split_result ref_split_piece(const ref_piece *in, const ref_plane *plane, ref_piece *front,
                                 ref_piece *back)
{
    long double distances[REF_POLYGON_CAPACITY];
    bool before = false, behind = false;
    for (int i = 0; i < in->count; i++) {
        distances[i] = ref_split_distance(plane, &in->points[i]);
        before = before || distances[i] > 0;
        behind = behind || distances[i] < 0;
    }
    if (!behind) {
        return REF_SPLIT_FRONT;
    }
    if (!before) {
        return REF_SPLIT_BACK;
    }
    ref_lattice_point ahead[2 * REF_POLYGON_CAPACITY], rest[2 * REF_POLYGON_CAPACITY];
    int ahead_count = part(in, distances, 1, ahead);
    int rest_count = part(in, distances, -1, rest);
    if (ahead_count > REF_POLYGON_CAPACITY || rest_count > REF_POLYGON_CAPACITY) {
        return REF_SPLIT_CAPACITY;
    }
    keep(front, ahead, ahead_count);
    keep(back, rest, rest_count);
    return REF_SPLIT_BOTH;
}
