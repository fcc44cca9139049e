/* SPDX-License-Identifier: MIT */
/* The numbers of lib/src/clip_view.c, which says why they fit; here every
 * distance comes from one function. */
#include "fixel/clip_view.h"

#include "arith.h"
#include "clip_flat.h"
#include "counted.h"

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

/* What sets texture coordinates; null, and not linked, where nobody has any. */
typedef void (*texel_setter)(const fxl_view_vertex *inside, const fxl_view_vertex *outside,
                             uint64_t fraction, fxl_view_vertex *vertex);

static void set_texel(const fxl_view_vertex *inside, const fxl_view_vertex *outside,
                      uint64_t fraction, fxl_view_vertex *vertex)
{
    vertex->u = interpolate_texel(inside->u, outside->u, fraction);
    vertex->v = interpolate_texel(inside->v, outside->v, fraction);
}

/* from + (to - from) fraction / 2^64, rounded towards from. */
static void interpolate(const fxl_q18_46 *from, const fxl_q18_46 *to, const uint64_t *fraction,
                        fxl_q18_46 *between)
{
    *between = *from + part_of(*to - *from, *fraction);
}

/* Where an edge crosses a plane, always from its inside to its outside end. */
static void set_crossing(const fxl_view_vertex *inside, const fxl_view_vertex *outside,
                         uint64_t fraction, texel_setter set, fxl_view_vertex *vertex)
{
    const fxl_view_point *from = &inside->position, *to = &outside->position;
    interpolate(&from->x, &to->x, &fraction, &vertex->position.x);
    interpolate(&from->y, &to->y, &fraction, &vertex->position.y);
    interpolate(&from->z, &to->z, &fraction, &vertex->position.z);
    if (set != NULL) {
        set(inside, outside, fraction, vertex);
    }
}

static fxl_clip_result clip_to_plane(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                     int plane, texel_setter set, fxl_view_polygon *out,
                                     fxl_q18_46 *distances)
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
                         set, &out->vertices[count++]);
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

static fxl_clip_result clip_to_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                      fxl_planes planes, texel_setter set, fxl_clip_view_work *work,
                                      fxl_clip_account *account, const fxl_view_polygon **result)
{
    fxl_view_polygon *out = &work->polygons[in == &work->polygons[0]];
    fxl_clip_result all = FXL_CLIP_INSIDE;
    *result = in;
    for (int plane = 0; planes >> plane != 0; plane++) {
        if ((planes >> plane & 1) == 0) {
            continue;
        }
        fxl_clip_result cut = clip_to_plane(*result, frustum, plane, set, out, work->distances);
        fxl_count_cut(account, work->distances, (*result)->count,
                      cut == FXL_CLIP_CUT ? out->count : 0);
        if (cut == FXL_CLIP_CUT) {
            *result = out;
            out = &work->polygons[out == &work->polygons[0]];
            all = FXL_CLIP_CUT;
        } else if (cut != FXL_CLIP_INSIDE) {
            *result = NULL;
            return cut;
        }
    }
    return all;
}

fxl_clip_result fxl_clip_view_to_plane(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                       int plane, fxl_view_polygon *out, fxl_q18_46 *distances)
{
    return clip_to_plane(in, frustum, plane, in->textured ? set_texel : NULL, out, distances);
}

fxl_clip_result fxl_cut_view_by_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                       fxl_planes planes, fxl_clip_view_work *work,
                                       fxl_clip_account *account, const fxl_view_polygon **result)
{
    return clip_to_planes(in, frustum, planes, in->textured ? set_texel : NULL, work, account,
                          result);
}

fxl_clip_result fxl_clip_view_to_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                        fxl_planes planes, fxl_clip_view_work *work,
                                        const fxl_view_polygon **result)
{
    return fxl_cut_view_by_planes(in, frustum, planes, work, NULL, result);
}

fxl_clip_result fxl_clip_view_flat(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                   fxl_planes planes, fxl_clip_view_work *work,
                                   fxl_clip_account *account, const fxl_view_polygon **result)
{
    return clip_to_planes(in, frustum, planes, NULL, work, account, result);
}
