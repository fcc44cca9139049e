/* SPDX-License-Identifier: MIT */
/* The chapter in 16.16, as one would port it in an afternoon: every number has
 * 16 bits after the point, every product and quotient drops the rest. */
#include "designs/cover.h"
#include "designs/exact.h"
#include "designs/naive.h"
#include "designs/surface.h"

/* A 16.16 sine from a perfect table, cut. */
static fixed sine(fxl_angle angle)
{
    return (fixed)(exact_sine(angle) * 65536.0);
}

static void naive_matrix(const fxl_pose *pose, double entries[9])
{
    fixed sy = sine(pose->yaw), cy = sine(pose->yaw + FXL_ANGLE_QUARTER);
    fixed sp = sine(pose->pitch), cp = sine(pose->pitch + FXL_ANGLE_QUARTER);
    fixed sr = sine(pose->roll), cr = sine(pose->roll + FXL_ANGLE_QUARTER);
    fixed rows[9] = {multiply(cr, cy) - multiply(multiply(sr, sp), sy),
                     multiply(sr, cp),
                     -multiply(cr, sy) - multiply(multiply(sr, sp), cy),
                     -multiply(sr, cy) - multiply(multiply(cr, sp), sy),
                     multiply(cr, cp),
                     multiply(sr, sy) - multiply(multiply(cr, sp), cy),
                     multiply(cp, sy),
                     sp,
                     multiply(cp, cy)};
    for (int i = 0; i < 9; i++) {
        entries[i] = rows[i] * 16384.0;
    }
}

static designs_screen show(const designs_input *input, const vector *point)
{
    naive_point shown = naive_project(&input->camera, &input->lens, point);
    return (designs_screen){shown.x, shown.y};
}

static designs_screen naive_vertex(const designs_input *input)
{
    vector point = vector_of(&input->points[0]);
    return show(input, &point);
}

/* SetUpFrustum: the view's plane turned into the world. */
static vector plane_of(const designs_input *input, fixed *distance)
{
    const fxl_camera *camera = &input->camera;
    fxl_view_frustum frustum;
    fxl_view_frustum_from_lens(&input->lens, &frustum);
    fixed side_x = 0, side_y = 0, depth = 0;
    switch (input->plane) {
    case FXL_PLANE_LEFT:
    case FXL_PLANE_RIGHT:
        side_x = (input->plane == FXL_PLANE_LEFT ? 1 : -1) * (frustum.x_side >> 14);
        depth = frustum.x_depth >> 14;
        break;
    case FXL_PLANE_BOTTOM:
    case FXL_PLANE_TOP:
        side_y = (input->plane == FXL_PLANE_BOTTOM ? 1 : -1) * (frustum.y_side >> 14);
        depth = frustum.y_depth >> 14;
        break;
    default:
        depth = input->plane == FXL_PLANE_NEAR ? 65536 : -65536;
    }
    vector right = row_of(&camera->axes.right), up = row_of(&camera->axes.up);
    vector forward = row_of(&camera->axes.forward), eye = vector_of(&camera->position);
    vector normal = {
        multiply(side_x, right.x) + multiply(side_y, up.x) + multiply(depth, forward.x),
        multiply(side_x, right.y) + multiply(side_y, up.y) + multiply(depth, forward.y),
        multiply(side_x, right.z) + multiply(side_y, up.z) + multiply(depth, forward.z)};
    *distance = held((int64_t)dot(&normal, &eye) + input->lens.inset);
    if (input->plane == FXL_PLANE_NEAR) {
        *distance = held((int64_t)*distance + input->lens.near_z);
    } else if (input->plane == FXL_PLANE_FAR) {
        *distance = held((int64_t)*distance - input->lens.far_z);
    }
    return normal;
}

/* ClipToPlane of Listing 65.2. */
static designs_screen naive_clip(const designs_input *input)
{
    fixed distance;
    vector normal = plane_of(input, &distance);
    vector a = vector_of(&input->points[0]), b = vector_of(&input->points[1]);
    fixed dot_a = dot(&normal, &a), dot_b = dot(&normal, &b);
    fixed scale = divide(held((int64_t)distance - dot_a), held((int64_t)dot_b - dot_a));
    scale = scale < 0 ? 0 : scale > 65536 ? 65536 : scale;
    vector cut = {held(a.x + (int64_t)multiply(held((int64_t)b.x - a.x), scale)),
                  held(a.y + (int64_t)multiply(held((int64_t)b.y - a.y), scale)),
                  held(a.z + (int64_t)multiply(held((int64_t)b.z - a.z), scale))};
    return show(input, &cut);
}

/* place fill-rule: definition: the designs in 16.16 and in float */
/* An edge stepped by its slope, from its first row's centre. */
static void naive_fill(const fxl_screen_polygon *outline, const designs_bitmap *bitmap)
{
    designs_cover_begin(bitmap);
    for (int i = 0; i < outline->count; i++) {
        designs_edge edge = designs_edge_of(outline, i);
        if (edge.top.y == edge.bottom.y) {
            continue;
        }
        fixed slope = divide(edge.bottom.x - edge.top.x, edge.bottom.y - edge.top.y);
        int row = (edge.top.y + 32767) >> 16, end = (edge.bottom.y + 32767) >> 16;
        int64_t x = edge.top.x + (int64_t)multiply(slope, row * 65536 + 32768 - edge.top.y);
        for (; row < end && row < bitmap->height; row++) {
            if (row >= 0) {
                designs_cover_add(bitmap, row, (x + 32767) >> 16, edge.winding);
            }
            x += slope;
        }
    }
    designs_cover_end(bitmap);
}

const designs_design designs_naive = {"naive",    naive_matrix, naive_vertex, naive_clip,
                                      naive_fill, naive_texel,  naive_level,  naive_nearer};
