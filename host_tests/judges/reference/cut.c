/* SPDX-License-Identifier: MIT */
#include "reference/cut.h"

#include <stdbool.h>

/* Appends a vertex if there is space. Counts it in any case. */
static void add(ref_cut *cut, int inner, int outer)
{
    if (cut->count < REF_POLYGON_CAPACITY) {
        cut->vertices[cut->count] = (ref_cut_vertex){inner, outer};
    }
    cut->count++;
}

ref_clip_result ref_cut_by_sides(const int *sides, int count, ref_cut *cut)
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
