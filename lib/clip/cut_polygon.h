/* SPDX-License-Identifier: MIT */
/* A polygon cut by a plane after Sutherland and Hodgman, whatever its vertices hold: what writes
 * them is given. Both functions are constants where they are called, so that they are compiled
 * into the loop. Internal. */
#ifndef FXL_CUT_POLYGON_H
#define FXL_CUT_POLYGON_H

#include "fixel/types.h"

FXL_STATIC_ASSERT(FXL_POLYGON_CAPACITY <= 32, "a bit a vertex");

/* A polygon and the one that it becomes, of whatever type a clipper has. */
typedef struct {
    const void *in;
    void *out;
    const fxl_q18_46 *distances; /* of the vertices of in from the plane */
    uint32_t count;              /* of the vertices of out, so far */
} fxl_cut;

/* Each writes vertex `to` of out: as vertex `from` of in is, or where the edge between two of
 * them crosses the plane. That is always asked for from the inside to the outside, so that both
 * owners of an edge get the same bits. */
typedef void fxl_cut_copy(const fxl_cut *cut, uint32_t from, uint32_t to);
typedef void fxl_cut_cross(const fxl_cut *cut, uint32_t inside, uint32_t outside, uint32_t to);

/* The bit of a vertex; 0 where that is outside of the plane. */
/* SPEC 4.7 */
static inline uint32_t fxl_cut_bit(fxl_q18_46 distance, uint32_t vertex)
{
    return (uint32_t)(distance >= 0) << vertex;
}

/* Emits what an edge contributes: its first vertex if that is inside, then the crossing if one
 * end is inside and the other outside. An inside end that lies on the plane is that crossing
 * already. False when the polygon is full. */
/* SPEC 4.7, clippers 1.3 */
static inline bool fxl_cut_edge(fxl_cut *cut, fxl_cut_copy *copy, fxl_cut_cross *cross,
                                uint32_t bits, uint32_t current, uint32_t count)
{
    const bool current_inside = (bits >> current & 1u) != 0;
    if (current_inside) {
        if (cut->count == FXL_POLYGON_CAPACITY) {
            return false;
        }
        copy(cut, current, cut->count++);
    }
    const uint32_t next = current + 1 == count ? 0 : current + 1;
    if ((bits >> next & 1u) == (uint32_t)current_inside) {
        return true;
    }
    const uint32_t inside = current_inside ? current : next;
    const uint32_t outside = inside == current ? next : current;
    if (cut->distances[inside] == 0) {
        return true;
    }
    if (cut->count == FXL_POLYGON_CAPACITY) {
        return false;
    }
    cross(cut, inside, outside, cut->count++);
    return true;
}

/* Of bits those are set whose vertex of in, which has count of them, counts as inside. On
 * FXL_CLIP_CUT cut->count of out are written, and nothing else of it; else what it has means
 * nothing. */
/* clippers 1.3 */
static inline fxl_clip_result fxl_cut_polygon(fxl_cut *cut, fxl_cut_copy *copy,
                                              fxl_cut_cross *cross, uint32_t bits, uint32_t count)
{
    if (bits == UINT32_MAX >> (32u - count)) {
        return FXL_CLIP_INSIDE;
    }
    if (bits == 0) {
        return FXL_CLIP_OUTSIDE;
    }
    for (uint32_t current = 0; current < count; current++) {
        if (!fxl_cut_edge(cut, copy, cross, bits, current, count)) {
            return FXL_CLIP_CAPACITY;
        }
    }
    return cut->count < 3 ? FXL_CLIP_DEGENERATE : FXL_CLIP_CUT;
}

/* Cuts `current` by a plane into `out`; what a caller's `with` is, it knows. */
typedef fxl_clip_result fxl_cut_by_plane(const void *with, int plane, const void *current,
                                         void *out);

/* Cuts a polygon by some planes, in the order of their numbers, into one and the other of two
 * spare ones of `size` bytes, of which it may be one; after a cut by those of `then` too, as far
 * as they are still to come. *result is the input where no plane cut it, null where nothing is
 * left. */
/* SPEC 4.7 */
static inline fxl_clip_result fxl_cut_by_planes(const void *in, void *spares, size_t size,
                                                uint32_t planes, uint32_t then,
                                                fxl_cut_by_plane *by_plane, const void *with,
                                                const void **result)
{
    const void *current = in;
    size_t at = in == spares ? size : 0;
    fxl_clip_result all = FXL_CLIP_INSIDE;
    *result = NULL;
    for (int plane = 0; planes >> plane != 0; plane++) {
        if ((planes >> plane & 1u) == 0) {
            continue;
        }
        void *out = (uint8_t *)spares + at;
        fxl_clip_result cut = by_plane(with, plane, current, out);
        if (cut == FXL_CLIP_CUT) {
            current = out;
            at ^= size;
            all = FXL_CLIP_CUT;
            planes |= then;
        } else if (cut != FXL_CLIP_INSIDE) {
            return cut;
        }
    }
    *result = current;
    return all;
}

#endif
