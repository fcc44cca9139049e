/* SPDX-License-Identifier: MIT */
/* The chapter in 16.16, as one would port it in an afternoon: every number has
 * 16 bits after the point, every product and quotient drops the rest. */
#include "designs/cover.h"
#include "designs/exact.h"

typedef int32_t fixed;

/* Kinder than the wrap of a real port. */
static inline fixed held(int64_t value)
{
    return (fixed)(value > INT32_MAX ? INT32_MAX : value < INT32_MIN ? INT32_MIN : value);
}

static inline fixed multiply(fixed a, fixed b)
{
    return held(((int64_t)a * b) >> 16);
}

static inline fixed divide(fixed a, fixed b)
{
    return b == 0 ? (a < 0 ? INT32_MIN : INT32_MAX) : held((int64_t)a * 65536 / b);
}

typedef struct {
    fixed x, y, z;
} vector;

static inline fixed dot(const vector *a, const vector *b)
{
    return held((int64_t)multiply(a->x, b->x) + multiply(a->y, b->y) + multiply(a->z, b->z));
}

static inline vector vector_of(const fxl_point *point)
{
    return (vector){point->x, point->y, point->z};
}

static inline vector row_of(const fxl_direction *row)
{
    return (vector){row->x >> 14, row->y >> 14, row->z >> 14};
}

typedef struct {
    fixed x, y;       /* on the screen, pixels */
    fixed z;          /* the depth */
    fixed reciprocal; /* 1 / z */
} naive_point;

/* TransformPoint and ProjectPolygon of Listing 65.3. */
static inline naive_point naive_project(const fxl_camera *camera, const fxl_lens *lens,
                                        const vector *point)
{
    vector eye = vector_of(&camera->position);
    vector from_eye = {held((int64_t)point->x - eye.x), held((int64_t)point->y - eye.y),
                       held((int64_t)point->z - eye.z)};
    vector right = row_of(&camera->axes.right), up = row_of(&camera->axes.up);
    vector forward = row_of(&camera->axes.forward);
    fixed z = dot(&forward, &from_eye), reciprocal = divide(65536, z);
    fixed x = multiply(multiply(dot(&right, &from_eye), reciprocal), lens->focal);
    fixed y = multiply(multiply(dot(&up, &from_eye), reciprocal), lens->focal);
    return (naive_point){held(lens->width * INT64_C(32768) + x),
                         held(lens->height * INT64_C(32768) - y), z, reciprocal};
}

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

/* --- surfaces and depth ------------------------------------------------------- */

/* Surfaces and depth in 16.16: 1/z and u/z at the corners, gradients over the screen, a quotient a
 * pixel. */
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
static int naive_texel(designs_surface *face, uint8_t division)
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

static int naive_level(designs_surface *face)
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

static int naive_nearer(const depth_sample *faces, bool wide)
{
    return cell_of(faces, 1, wide) > cell_of(faces, 0, wide);
}

const designs_design designs_naive = {"naive",    naive_matrix, naive_vertex, naive_clip,
                                      naive_fill, naive_texel,  naive_level,  naive_nearer};
