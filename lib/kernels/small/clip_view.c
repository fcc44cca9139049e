/* SPDX-License-Identifier: MIT */
/* The numbers of lib/src/clip_view.c, which says why they fit; here every
 * distance comes from one function. */
#include "fixel/clip_view.h"

#include "arith.h"

static int32_t upper(int64_t value)
{
    return (int32_t)((uint64_t)value >> 32);
}

fxl_q18_46 fxl_view_distance(const fxl_view_frustum *frustum, int plane,
                             const fxl_view_point *point)
{
    if (plane == FXL_PLANE_NEAR) {
        return point->z - frustum->near;
    }
    if (plane == FXL_PLANE_FAR) {
        return frustum->far - point->z;
    }
    fxl_q2_30 side = frustum->x_side, depth = frustum->x_depth;
    fxl_q18_46 across = point->x;
    if (plane >= FXL_PLANE_BOTTOM) {
        side = frustum->y_side;
        depth = frustum->y_depth;
        across = point->y;
    }
    if (plane == FXL_PLANE_RIGHT || plane == FXL_PLANE_TOP) {
        across = -across;
    }
    int64_t high = fxl_multiply_s32(side, upper(across)) + fxl_multiply_s32(depth, upper(point->z));
    uint64_t low = fxl_multiply_u32((uint32_t)side, (uint32_t)across) +
                   fxl_multiply_u32((uint32_t)depth, (uint32_t)point->z);
    return high * 4 + (int64_t)(low >> 30) - frustum->inset;
}

/* floor(|extent| fraction / 2^64), with the sign of the extent. */
static int64_t part_of(int64_t extent, uint64_t fraction)
{
    int64_t part = (int64_t)fxl_multiply_high(fxl_magnitude(extent), fraction);
    return extent < 0 ? -part : part;
}

/* To the nearest, a half away from `from`. */
static fxl_q16_16 interpolate_texel(fxl_q16_16 from, fxl_q16_16 to, uint64_t fraction)
{
    int64_t twice = part_of(2 * ((int64_t)to - from), fraction);
    return (fxl_q16_16)(from + (twice < 0 ? -((1 - twice) >> 1) : (twice + 1) >> 1));
}

/* What an edge crosses a plane with, from its inside to its outside end. */
static void set_crossing(const fxl_view_vertex *inside, const fxl_view_vertex *outside,
                         uint64_t fraction, bool textured, fxl_view_vertex *vertex)
{
    const fxl_view_point *from = &inside->position, *to = &outside->position;
    vertex->position.x = from->x + part_of(to->x - from->x, fraction);
    vertex->position.y = from->y + part_of(to->y - from->y, fraction);
    vertex->position.z = from->z + part_of(to->z - from->z, fraction);
    if (textured) {
        vertex->u = interpolate_texel(inside->u, outside->u, fraction);
        vertex->v = interpolate_texel(inside->v, outside->v, fraction);
    }
}

fxl_clip_result fxl_clip_view_to_plane(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                       int plane, fxl_view_polygon *out, fxl_q18_46 *distances)
{
    FXL_ASSERT(in != out && in->count >= 3 && in->count <= FXL_POLYGON_CAPACITY);
    uint32_t inside_count = 0, count = 0;
    for (uint32_t i = 0; i < in->count; i++) {
        distances[i] = fxl_view_distance(frustum, plane, &in->vertices[i].position);
        inside_count += distances[i] >= 0;
    }
    if (inside_count == in->count) {
        return FXL_CLIP_INSIDE;
    }
    if (inside_count == 0) {
        return FXL_CLIP_OUTSIDE;
    }
    /* What an edge contributes: its first vertex, then its crossing. An inside end
     * that lies on the plane is the crossing already. */
    for (uint32_t i = 0; i < in->count; i++) {
        const uint32_t next = i + 1 == in->count ? 0 : i + 1;
        const bool is_inside = distances[i] >= 0;
        const uint32_t inside = is_inside ? i : next, outside = is_inside ? next : i;
        if (is_inside) {
            if (count == FXL_POLYGON_CAPACITY) {
                return FXL_CLIP_CAPACITY;
            }
            out->vertices[count++] = in->vertices[i];
        }
        if (distances[inside] > 0 && distances[outside] < 0) {
            if (count == FXL_POLYGON_CAPACITY) {
                return FXL_CLIP_CAPACITY;
            }
            set_crossing(&in->vertices[inside], &in->vertices[outside],
                         fxl_fraction((uint64_t)distances[inside],
                                      (uint64_t)(distances[inside] - distances[outside])),
                         in->textured, &out->vertices[count++]);
        }
    }
    if (count < 3) {
        return FXL_CLIP_DEGENERATE;
    }
    out->colour = in->colour;
    out->textured = in->textured;
    out->count = (uint8_t)count;
    return FXL_CLIP_CUT;
}

fxl_clip_result fxl_clip_view_to_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                        fxl_planes planes, fxl_clip_view_work *work,
                                        const fxl_view_polygon **result)
{
    const fxl_view_polygon *current = in;
    uint32_t spare = in == &work->polygons[0] ? 1 : 0;
    fxl_clip_result all = FXL_CLIP_INSIDE;
    unsigned left = planes;
    for (int plane = 0; left != 0; plane++, left >>= 1) {
        if ((left & 1) == 0) {
            continue;
        }
        fxl_view_polygon *out = &work->polygons[spare];
        fxl_clip_result cut = fxl_clip_view_to_plane(current, frustum, plane, out, work->distances);
        if (cut == FXL_CLIP_CUT) {
            current = out;
            spare ^= 1u;
            all = FXL_CLIP_CUT;
        } else if (cut != FXL_CLIP_INSIDE) {
            *result = NULL;
            return cut;
        }
    }
    *result = current;
    return all;
}
