/* SPDX-License-Identifier: MIT */
/* Surfaces and depth in 16.16: 1/z and u/z at the corners, gradients over the screen, a quotient a
 * pixel. */
#include "designs/naive.h"
#include "designs/surface.h"

static void project(const oracle_setup *setup, const fxl_point corners[3], naive_point points[3])
{
    for (int i = 0; i < 3; i++) {
        vector corner = vector_of(&corners[i]);
        points[i] = naive_project(&setup->view.camera, &setup->view.lens, &corner);
    }
}

/* A value that is linear on the screen, at the centre of a pixel. */
static fixed at_pixel(const naive_point points[3], const fixed values[3], int64_t column,
                      int64_t row)
{
    fixed x1 = held((int64_t)points[1].x - points[0].x);
    fixed y1 = held((int64_t)points[1].y - points[0].y);
    fixed x2 = held((int64_t)points[2].x - points[0].x);
    fixed y2 = held((int64_t)points[2].y - points[0].y);
    fixed v1 = held((int64_t)values[1] - values[0]), v2 = held((int64_t)values[2] - values[0]);
    fixed area = held((int64_t)multiply(x1, y2) - multiply(x2, y1));
    fixed along = divide(held((int64_t)multiply(v1, y2) - multiply(v2, y1)), area);
    fixed down = divide(held((int64_t)multiply(v2, x1) - multiply(v1, x2)), area);
    fixed x = held(column * 65536 + 32768 - points[0].x);
    fixed y = held(row * 65536 + 32768 - points[0].y);
    return held((int64_t)values[0] + multiply(along, x) + multiply(down, y));
}

static fixed divided(const naive_point points[3], const fixed values[3], int64_t column,
                     int64_t row)
{
    fixed over[3], reciprocals[3];
    for (int i = 0; i < 3; i++) {
        reciprocals[i] = points[i].reciprocal;
        over[i] = multiply(values[i], reciprocals[i]);
    }
    return divide(at_pixel(points, over, column, row), at_pixel(points, reciprocals, column, row));
}

static fixed value_of(const designs_surface *face, const fixed values[3], uint8_t division)
{
    const surface_sample *sample = &face->sample;
    const int64_t every = division == FXL_DIVIDE_16 ? 16 : division == FXL_DIVIDE_8 ? 8 : 1;
    naive_point points[3];
    project(&sample->setup, sample->corners, points);
    if (division == FXL_AFFINE) {
        return at_pixel(points, values, sample->x, sample->y);
    }
    int64_t first = sample->x & -every;
    fixed from = divided(points, values, first, sample->y);
    if (every == 1) {
        return from;
    }
    fixed to = divided(points, values, first + every, sample->y);
    fixed part = (fixed)((sample->x - first) * 65536 / every);
    return held((int64_t)from + multiply(held((int64_t)to - from), part));
}

/* place sampling: the texel of a pixel in other arithmetic */
int naive_texel(designs_surface *face, uint8_t division)
{
    fixed values[3];
    for (int i = 0; i < 3; i++) {
        values[i] = (fixed)face->sample.values[i][0];
    }
    return (value_of(face, values, division) >> 16) & ((1 << DESIGNS_TEXEL_LOG) - 1);
}

static fixed square_root(int64_t number)
{
    int64_t root = 0;
    for (int64_t bit = INT64_C(1) << 31; bit > 0; bit >>= 1) {
        if ((root + bit) * (root + bit) <= number) {
            root += bit;
        }
    }
    return held(root);
}

static fixed lamp(const fxl_light_settings *light, const fxl_point *corner, const vector *normal)
{
    const fxl_point *at = &light->points[0].position;
    vector way = {held((int64_t)at->x - corner->x), held((int64_t)at->y - corner->y),
                  held((int64_t)at->z - corner->z)};
    fixed length =
        square_root((int64_t)way.x * way.x + (int64_t)way.y * way.y + (int64_t)way.z * way.z);
    fixed along = dot(normal, &way), share = divide(length, light->points[0].range);
    return length == 0 || share >= 65536 || along < 0
               ? 0
               : multiply(divide(along, length), 65536 - multiply(share, share));
}

static fixed brightness(const designs_surface *face, int number)
{
    const fxl_light_settings *light = &face->light;
    const fxl_camera *camera = &face->sample.setup.view.camera;
    const fxl_point *corner = &face->sample.corners[number];
    vector normal = row_of(&face->normals[number]), way = row_of(&light->direction);
    fixed sun = -dot(&normal, &way);
    fixed sum = (light->ambient >> 14) + multiply(light->strength >> 14, sun > 0 ? sun : 0) +
                lamp(light, corner, &normal);
    sum = sum > 65536 ? 65536 : sum;
    if (light->fog_far > 0) {
        vector at = vector_of(corner);
        fixed z = naive_project(camera, &face->sample.lens, &at).z;
        fixed clear = divide(held((int64_t)light->fog_far - z), light->fog_far);
        sum = multiply(sum, clear < 0 ? 0 : clear > 65536 ? 65536 : clear);
    }
    return sum;
}

int naive_level(designs_surface *face)
{
    fixed values[3];
    for (int i = 0; i < 3; i++) {
        values[i] = 32768 + brightness(face, i) * (SURFACE_LEVELS - 1);
    }
    int level = value_of(face, values, FXL_DIVIDE_1) >> 16;
    return level < 0 ? 0 : level >= SURFACE_LEVELS ? SURFACE_LEVELS - 1 : level;
}

/* 1/z, or near/z in 16 bits after the point. */
static fixed cell_of(const depth_sample *faces, int face, bool wide)
{
    naive_point points[3];
    fixed values[3];
    project(&faces->setup, &faces->corners[3 * face], points);
    for (int i = 0; i < 3; i++) {
        values[i] = wide ? points[i].reciprocal : divide(faces->lens.near_z, points[i].z);
    }
    fixed cell = at_pixel(points, values, faces->pixel[0], faces->pixel[1]);
    return wide ? cell : cell < 0 ? 0 : cell > 65535 ? 65535 : cell;
}

int naive_nearer(const depth_sample *faces, bool wide)
{
    return cell_of(faces, 1, wide) > cell_of(faces, 0, wide);
}
