/* SPDX-License-Identifier: MIT */
#include "rectangle.h"

#include "../clip/cut_polygon.h"
#include "../math/arith.h"
#include "triangle.h"
#include "../clip/intersection.h"

/* How far a point lies inside a border. Coordinates are below 2^28, so this is below 2^29. */
/* clippers 3.5 */
static fxl_q18_46 border_distance(const fxl_rectangle *rectangle, int border,
                                  const fxl_screen_point *point)
{
    switch (border) {
    case FXL_BORDER_LEFT:
        return point->x - rectangle->left;
    case FXL_BORDER_RIGHT:
        return rectangle->right - point->x;
    case FXL_BORDER_TOP:
        return point->y - rectangle->top;
    default:
        FXL_ASSERT(border == FXL_BORDER_BOTTOM);
        return rectangle->bottom - point->y;
    }
}

/* A cut by one border. */
typedef struct {
    fxl_cut cut;
    bool upright;     /* the border is left or right */
    fxl_q16_16 limit; /* its place */
} border_cut;

static inline void copy(const fxl_cut *cut, uint32_t from, uint32_t to)
{
    ((fxl_screen_polygon *)cut->out)->points[to] =
        ((const fxl_screen_polygon *)cut->in)->points[from];
}

static inline void cross(const fxl_cut *cut, uint32_t inside, uint32_t outside, uint32_t to)
{
    const border_cut *by = (const border_cut *)cut;
    const fxl_screen_point *from = &((const fxl_screen_polygon *)cut->in)->points[inside];
    const fxl_screen_point *end = &((const fxl_screen_polygon *)cut->in)->points[outside];
    const fxl_q18_46 in = cut->distances[inside], out = cut->distances[outside];
    const fxl_screen_point point = {
        by->upright ? by->limit : fxl_intersection_screen(from->x, end->x, in, out),
        by->upright ? fxl_intersection_screen(from->y, end->y, in, out) : by->limit};
    ((fxl_screen_polygon *)cut->out)->points[to] = point;
}

typedef struct {
    const fxl_rectangle *rectangle;
    fxl_rectangle_work *work;
} clipping;

static inline fxl_clip_result by_border(const void *with, int border, const void *current,
                                        void *out)
{
    const clipping *to = (const clipping *)with;
    const fxl_screen_polygon *in = (const fxl_screen_polygon *)current;
    const fxl_rectangle *rectangle = to->rectangle;
    const fxl_q16_16 limits[] = {rectangle->left, rectangle->right, rectangle->top,
                                 rectangle->bottom};
    uint32_t bits = 0;
    for (uint32_t i = 0; i < in->count; i++) {
        to->work->distances[i] = border_distance(rectangle, border, &in->points[i]);
        bits |= fxl_cut_bit(to->work->distances[i], i);
    }
    border_cut by = {{current, out, to->work->distances, 0},
                     border == FXL_BORDER_LEFT || border == FXL_BORDER_RIGHT,
                     limits[border]};
    fxl_clip_result result = fxl_cut_polygon(&by.cut, copy, cross, bits, in->count);
    if (result == FXL_CLIP_CUT) {
        fxl_screen_polygon *left = (fxl_screen_polygon *)out;
        left->colour = in->colour;
        left->count = (uint8_t)by.cut.count;
        left->kind = in->kind;
        left->shade = in->shade;
    }
    return result;
}

/* clippers 3.5 */
fxl_clip_result fxl_clip_to_rectangle(const fxl_screen_polygon *in, const fxl_rectangle *rectangle,
                                      fxl_rectangle_work *work, const fxl_screen_polygon **result)
{
    FXL_ASSERT(in != &work->polygons[0] && in != &work->polygons[1]);
    FXL_ASSERT(in->count >= 3 && in->count <= FXL_POLYGON_CAPACITY);
    FXL_ASSERT(rectangle->left <= rectangle->right && rectangle->top <= rectangle->bottom);
    uint32_t any = 0, all = UINT32_MAX;
    for (uint32_t i = 0; i < in->count; i++) {
        uint32_t code = 0;
        for (int border = 0; border < FXL_BORDER_COUNT; border++) {
            code |= (uint32_t)(border_distance(rectangle, border, &in->points[i]) < 0) << border;
        }
        any |= code;
        all &= code;
    }
    *result = NULL;
    if (all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    const clipping to = {rectangle, work};
    const void *left;
    fxl_clip_result cut = fxl_cut_by_planes(in, work->polygons, sizeof work->polygons[0], any, 0,
                                            by_border, &to, &left);
    *result = (const fxl_screen_polygon *)left;
    return cut;
}
