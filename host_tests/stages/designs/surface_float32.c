/* SPDX-License-Identifier: MIT */
/* Surfaces and depth in single precision, by the steps of surface_naive.c. */
#include <math.h>

#include "designs/float32.h"
#include "designs/surface.h"

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
int float32_texel(designs_surface *face, uint8_t division)
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

int float32_level(designs_surface *face)
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

int float32_nearer(const depth_sample *faces, bool wide)
{
    return cell_of(faces, 1, wide) > cell_of(faces, 0, wide);
}
