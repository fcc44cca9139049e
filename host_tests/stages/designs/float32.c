/* SPDX-License-Identifier: MIT */
/* The chapter in single precision. */
#include <math.h>

#include "designs/cover.h"
#include "designs/exact.h"
#include "designs/float32.h"
#include "designs/surface.h"

/* A correctly rounded sine, so that no library's sinf decides. */
static float sine(fxl_angle angle)
{
    return (float)exact_sine(angle);
}

static void float32_matrix(const fxl_pose *pose, double entries[9])
{
    float sy = sine(pose->yaw), cy = sine(pose->yaw + FXL_ANGLE_QUARTER);
    float sp = sine(pose->pitch), cp = sine(pose->pitch + FXL_ANGLE_QUARTER);
    float sr = sine(pose->roll), cr = sine(pose->roll + FXL_ANGLE_QUARTER);
    float rows[9] = {cr * cy - sr * sp * sy,
                     sr * cp,
                     -cr * sy - sr * sp * cy,
                     -sr * cy - cr * sp * sy,
                     cr * cp,
                     sr * sy - cr * sp * cy,
                     cp * sy,
                     sp,
                     cp * cy};
    for (int i = 0; i < 9; i++) {
        entries[i] = (double)rows[i] * 0x1p30;
    }
}

/* In 1/65536 pixel, held within 16.16. */
static double held(float pixels)
{
    double value = (double)pixels * 65536;
    if (!(value < 0x1p31)) { /* not a number, too */
        return 0x1p31;
    }
    return value < -0x1p31 ? -0x1p31 : value;
}

static designs_screen show(const designs_input *input, const vector *point)
{
    float32_point shown = float32_project(&input->camera, &input->lens, point);
    return (designs_screen){held(shown.x), held(shown.y)};
}

static designs_screen float32_vertex(const designs_input *input)
{
    vector point = vector_of(&input->points[0]);
    return show(input, &point);
}

static vector plane_of(const designs_input *input, float *distance)
{
    const fxl_camera *camera = &input->camera;
    fxl_view_frustum frustum;
    fxl_view_frustum_from_lens(&input->lens, &frustum);
    float side_x = 0, side_y = 0, depth = 0;
    switch (input->plane) {
    case FXL_PLANE_LEFT:
    case FXL_PLANE_RIGHT:
        side_x = (float)frustum.x_side * (input->plane == FXL_PLANE_LEFT ? 0x1p-30f : -0x1p-30f);
        depth = (float)frustum.x_depth * 0x1p-30f;
        break;
    case FXL_PLANE_BOTTOM:
    case FXL_PLANE_TOP:
        side_y = (float)frustum.y_side * (input->plane == FXL_PLANE_BOTTOM ? 0x1p-30f : -0x1p-30f);
        depth = (float)frustum.y_depth * 0x1p-30f;
        break;
    default:
        depth = input->plane == FXL_PLANE_NEAR ? 1.0f : -1.0f;
    }
    vector right = row_of(&camera->axes.right), up = row_of(&camera->axes.up);
    vector forward = row_of(&camera->axes.forward), eye = vector_of(&camera->position);
    vector normal = {side_x * right.x + side_y * up.x + depth * forward.x,
                     side_x * right.y + side_y * up.y + depth * forward.y,
                     side_x * right.z + side_y * up.z + depth * forward.z};
    *distance = dot(&normal, &eye) + q16(input->lens.inset);
    if (input->plane == FXL_PLANE_NEAR) {
        *distance += q16(input->lens.near_z);
    } else if (input->plane == FXL_PLANE_FAR) {
        *distance -= q16(input->lens.far_z);
    }
    return normal;
}

static designs_screen float32_clip(const designs_input *input)
{
    float distance;
    vector normal = plane_of(input, &distance);
    vector a = vector_of(&input->points[0]), b = vector_of(&input->points[1]);
    float dot_a = dot(&normal, &a), dot_b = dot(&normal, &b);
    float scale = (distance - dot_a) / (dot_b - dot_a);
    if (!(scale > 0)) {
        scale = 0;
    } else if (scale > 1) {
        scale = 1;
    }
    vector cut = {a.x + (b.x - a.x) * scale, a.y + (b.y - a.y) * scale, a.z + (b.z - a.z) * scale};
    return show(input, &cut);
}

/* place fill-rule: definition: the designs in 16.16 and in float */
static void float32_fill(const fxl_screen_polygon *outline, const designs_bitmap *bitmap)
{
    designs_cover_begin(bitmap);
    for (int i = 0; i < outline->count; i++) {
        designs_edge edge = designs_edge_of(outline, i);
        float top = q16(edge.top.y), bottom = q16(edge.bottom.y), left = q16(edge.top.x);
        if (!(top < bottom)) {
            continue;
        }
        float slope = (q16(edge.bottom.x) - left) / (bottom - top);
        int row = (int)ceilf(top - 0.5f), end = (int)ceilf(bottom - 0.5f);
        float x = left + slope * ((float)row + 0.5f - top);
        for (; row < end && row < bitmap->height; row++) {
            if (row >= 0) {
                designs_cover_add(bitmap, row, (int64_t)ceilf(x - 0.5f), edge.winding);
            }
            x += slope;
        }
    }
    designs_cover_end(bitmap);
}

const designs_design designs_float32 = {"float32",     float32_matrix, float32_vertex,
                                        float32_clip,  float32_fill,   float32_texel,
                                        float32_level, float32_nearer};
