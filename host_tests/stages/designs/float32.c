/* SPDX-License-Identifier: MIT */
/* The chapter in single precision. */
#include <math.h>

#include "designs/cover.h"
#include "designs/exact.h"

typedef struct {
    float x, y, z;
} vector;

static inline float q16(int32_t value)
{
    return (float)value * 0x1p-16f;
}

static inline float dot(const vector *a, const vector *b)
{
    return a->x * b->x + a->y * b->y + a->z * b->z;
}

static inline vector vector_of(const fxl_point *point)
{
    return (vector){q16(point->x), q16(point->y), q16(point->z)};
}

static inline vector row_of(const fxl_direction *row)
{
    return (vector){(float)row->x * 0x1p-30f, (float)row->y * 0x1p-30f, (float)row->z * 0x1p-30f};
}

typedef struct {
    float x, y;       /* on the screen, pixels */
    float z;          /* the depth */
    float reciprocal; /* 1 / z */
} float32_point;

static inline float32_point float32_project(const fxl_camera *camera, const fxl_lens *lens,
                                            const vector *point)
{
    vector eye = vector_of(&camera->position);
    vector from_eye = {point->x - eye.x, point->y - eye.y, point->z - eye.z};
    vector right = row_of(&camera->axes.right), up = row_of(&camera->axes.up);
    vector forward = row_of(&camera->axes.forward);
    float z = dot(&forward, &from_eye), reciprocal = 1.0f / z, focal = q16(lens->focal);
    float centre_x = (float)lens->width * 0.5f, centre_y = (float)lens->height * 0.5f;
    return (float32_point){dot(&right, &from_eye) * reciprocal * focal + centre_x,
                           centre_y - dot(&up, &from_eye) * reciprocal * focal, z, reciprocal};
}

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

/* --- surfaces and depth ------------------------------------------------------- */

/* Surfaces and depth in single precision, by the steps of naive.c. */
static void project(const oracle_setup *setup, const fxl_point corners[3], float32_point points[3])
{
    for (int i = 0; i < 3; i++) {
        vector corner = vector_of(&corners[i]);
        points[i] = float32_project(&setup->view.camera, &setup->view.lens, &corner);
    }
}

static float at_pixel(const float32_point points[3], const float values[3], int64_t column,
                      int64_t row)
{
    float x1 = points[1].x - points[0].x, y1 = points[1].y - points[0].y;
    float x2 = points[2].x - points[0].x, y2 = points[2].y - points[0].y;
    float v1 = values[1] - values[0], v2 = values[2] - values[0];
    float area = x1 * y2 - x2 * y1;
    float along = (v1 * y2 - v2 * y1) / area, down = (v2 * x1 - v1 * x2) / area;
    return values[0] + along * ((float)column + 0.5f - points[0].x) +
           down * ((float)row + 0.5f - points[0].y);
}

static float divided(const float32_point points[3], const float values[3], int64_t column,
                     int64_t row)
{
    float over[3], reciprocals[3];
    for (int i = 0; i < 3; i++) {
        reciprocals[i] = points[i].reciprocal;
        over[i] = values[i] * reciprocals[i];
    }
    return at_pixel(points, over, column, row) / at_pixel(points, reciprocals, column, row);
}

static float value_of(const designs_surface *face, const float values[3], uint8_t division)
{
    const surface_sample *sample = &face->sample;
    const int64_t every = division == FXL_DIVIDE_16 ? 16 : division == FXL_DIVIDE_8 ? 8 : 1;
    float32_point points[3];
    project(&sample->setup, sample->corners, points);
    if (division == FXL_AFFINE) {
        return at_pixel(points, values, sample->x, sample->y);
    }
    int64_t first = sample->x & -every;
    float from = divided(points, values, first, sample->y);
    if (every == 1) {
        return from;
    }
    float to = divided(points, values, first + every, sample->y);
    return from + (to - from) * ((float)(sample->x - first) / (float)every);
}

/* The whole part, held so that it fits; 0 where it is not a number. */
static int whole_of(float value)
{
    return isnan(value) ? 0 : (int)floorf(fminf(fmaxf(value, -1e9f), 1e9f));
}

/* place sampling: the texel of a pixel in other arithmetic */
static int float32_texel(designs_surface *face, uint8_t division)
{
    float values[3];
    for (int i = 0; i < 3; i++) {
        values[i] = q16((int32_t)face->sample.values[i][0]);
    }
    return whole_of(value_of(face, values, division)) & ((1 << DESIGNS_TEXEL_LOG) - 1);
}

static float lamp(const fxl_light_settings *light, const fxl_point *corner, const vector *normal)
{
    vector at = vector_of(&light->points[0].position), from = vector_of(corner);
    vector way = {at.x - from.x, at.y - from.y, at.z - from.z};
    float length = sqrtf(dot(&way, &way)), share = length / q16(light->points[0].range);
    float along = dot(normal, &way);
    return !(length > 0) || share >= 1 || along < 0 ? 0 : along / length * (1 - share * share);
}

static float brightness(const designs_surface *face, int number)
{
    const fxl_light_settings *light = &face->light;
    const fxl_camera *camera = &face->sample.setup.view.camera;
    const fxl_point *corner = &face->sample.corners[number];
    vector normal = row_of(&face->normals[number]), way = row_of(&light->direction);
    float sun = -dot(&normal, &way);
    float sum = (float)light->ambient * 0x1p-30f +
                (float)light->strength * 0x1p-30f * fmaxf(sun, 0) + lamp(light, corner, &normal);
    sum = fminf(sum, 1);
    if (light->fog_far > 0) {
        vector at = vector_of(corner);
        float far = q16(light->fog_far), z = float32_project(camera, &face->sample.lens, &at).z;
        sum *= fminf(fmaxf((far - z) / far, 0), 1);
    }
    return sum;
}

static int float32_level(designs_surface *face)
{
    float values[3];
    for (int i = 0; i < 3; i++) {
        values[i] = 0.5f + brightness(face, i) * (SURFACE_LEVELS - 1);
    }
    int level = whole_of(value_of(face, values, FXL_DIVIDE_1));
    return level < 0 ? 0 : level >= SURFACE_LEVELS ? SURFACE_LEVELS - 1 : level;
}

/* 1/z in 32 bits, or near/z in 16 bits after the point. */
static float cell_of(const depth_sample *faces, int face, bool wide)
{
    float32_point points[3];
    float values[3];
    project(&faces->setup, &faces->corners[3 * face], points);
    for (int i = 0; i < 3; i++) {
        values[i] = points[i].reciprocal;
    }
    float cell = at_pixel(points, values, faces->pixel[0], faces->pixel[1]);
    float narrow = floorf(cell * q16(faces->lens.near_z) * 65535.0f);
    return wide ? cell : fminf(fmaxf(narrow, 0), 65535.0f);
}

static int float32_nearer(const depth_sample *faces, bool wide)
{
    return cell_of(faces, 1, wide) > cell_of(faces, 0, wide);
}

const designs_design designs_float32 = {"float32",     float32_matrix, float32_vertex,
                                        float32_clip,  float32_fill,   float32_texel,
                                        float32_level, float32_nearer};
