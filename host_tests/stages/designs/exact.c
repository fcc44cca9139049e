/* SPDX-License-Identifier: MIT */
#include "designs/exact.h"

#include <math.h>

#include "designs/cover.h"

__extension__ typedef __int128 int128;

static const double half_pi = 1.57079632679489661923;

/* |x| <= pi/4: the first term left out is below 2^-60. */
static double sine_series(double x)
{
    double square = x * x, sum = 0;
    for (int n = 17; n >= 3; n -= 2) {
        sum = (1 + sum) * -square / (n * (n - 1));
    }
    return x * (1 + sum);
}

static double cosine_series(double x)
{
    double square = x * x, sum = 0;
    for (int n = 16; n >= 2; n -= 2) {
        sum = (1 + sum) * -square / (n * (n - 1));
    }
    return 1 + sum;
}

double exact_sine(fxl_angle angle)
{
    uint32_t quarter = (angle + 0x20000000u) >> 30;
    double rest = (double)(int32_t)(angle - (quarter << 30)) * (half_pi * 0x1p-30);
    double value = quarter & 1 ? cosine_series(rest) : sine_series(rest);
    return quarter & 2 ? -value : value;
}

void exact_matrix(const fxl_pose *pose, double entries[9])
{
    double sy = exact_sine(pose->yaw), cy = exact_sine(pose->yaw + FXL_ANGLE_QUARTER);
    double sp = exact_sine(pose->pitch), cp = exact_sine(pose->pitch + FXL_ANGLE_QUARTER);
    double sr = exact_sine(pose->roll), cr = exact_sine(pose->roll + FXL_ANGLE_QUARTER);
    double rows[9] = {cr * cy - sr * sp * sy,
                      sr * cp,
                      -cr * sy - sr * sp * cy,
                      -sr * cy - cr * sp * sy,
                      cr * cp,
                      sr * sy - cr * sp * cy,
                      cp * sy,
                      sp,
                      cp * cy};
    for (int i = 0; i < 9; i++) {
        entries[i] = rows[i] * 0x1p30;
    }
}

/* Below 3 * 2^60. */
static int64_t dot(const fxl_direction *row, int64_t dx, int64_t dy, int64_t dz)
{
    return row->x * dx + row->y * dy + row->z * dz;
}

fxl_view_point exact_view_point(const designs_input *input, int number)
{
    const fxl_camera *camera = &input->camera;
    const fxl_point *point = &input->points[number];
    int64_t dx = (int64_t)point->x - camera->position.x;
    int64_t dy = (int64_t)point->y - camera->position.y;
    int64_t dz = (int64_t)point->z - camera->position.z;
    return (fxl_view_point){dot(&camera->axes.right, dx, dy, dz), dot(&camera->axes.up, dx, dy, dz),
                            dot(&camera->axes.forward, dx, dy, dz)};
}

/* |found - focal side / depth|: the quotient's whole part is subtracted as an
 * integer, so that nothing is lost to the size of either. */
static double quotient_error(double found, fxl_q16_16 focal, int64_t side, int64_t depth)
{
    int128 product = (int128)focal * side;
    int64_t whole = (int64_t)(product / depth);
    int64_t rest = (int64_t)(product % depth);
    return fabs((found - (double)whole) - (double)rest / (double)depth);
}

double exact_vertex_error(const designs_input *input, const designs_screen *screen)
{
    fxl_view_point view = exact_view_point(input, 0);
    const fxl_lens *lens = &input->lens;
    double x = quotient_error(screen->x - lens->width * 32768.0, lens->focal, view.x, view.z);
    double y = quotient_error(lens->height * 32768.0 - screen->y, lens->focal, view.y, view.z);
    return x > y ? x : y;
}

static int bit_length(int128 value)
{
    int bits = 0;
    for (value = value < 0 ? -value : value; value; value >>= 1) {
        bits++;
    }
    return bits;
}

/* a b - c d, of numbers below 2^62. */
static int128 cross(int64_t a, int64_t b, int64_t c, int64_t d)
{
    return (int128)a * b - (int128)c * d;
}

/* The eye and the edge span a plane with the normal a x b; the screen's point
 * (u, v) is the ray (u, v, focal). So its distance from the image of the edge
 * is normal . (u, v, focal) / |(normal.x, normal.y)|. Positions are taken in
 * 2^-24 pixel (a float on the screen is no finer near its middle, and a bit
 * less of it does not matter), the normal with 84 bits: the sum is below 2^126,
 * and what was cut off is below 2^-40 of 1/65536 pixel on the screen. */
double exact_edge_distance(const designs_input *input, const designs_screen *screen)
{
    fxl_view_point a = exact_view_point(input, 0), b = exact_view_point(input, 1);
    int128 normal[3] = {cross(a.y, b.z, a.z, b.y), cross(a.z, b.x, a.x, b.z),
                        cross(a.x, b.y, a.y, b.x)};
    int bits = 0;
    for (int i = 0; i < 3; i++) {
        int length = bit_length(normal[i]);
        bits = length > bits ? length : bits;
    }
    for (int i = 0; i < 3 && bits > 84; i++) {
        normal[i] >>= bits - 84;
    }
    if (normal[0] == 0 && normal[1] == 0) {
        return -1;
    }
    int64_t u = (int64_t)rint((screen->x - input->lens.width * 32768.0) * 256);
    int64_t v = (int64_t)rint((input->lens.height * 32768.0 - screen->y) * 256);
    int128 sum = normal[0] * u + normal[1] * v + normal[2] * ((int64_t)input->lens.focal * 256);
    double nx = (double)normal[0], ny = (double)normal[1];
    return fabs((double)sum) / sqrt(nx * nx + ny * ny) / 256;
}

/* In units of 2^-76, against the library's planes of the view, which are given. */
static int128 plane_distance(const designs_input *input, const fxl_view_point *point)
{
    fxl_view_frustum frustum;
    fxl_view_frustum_from_lens(&input->lens, &frustum);
    int128 inset = (int128)frustum.inset << 30, one = (int128)1 << 30;
    int sign = input->plane == FXL_PLANE_RIGHT || input->plane == FXL_PLANE_TOP ? -1 : 1;
    switch (input->plane) {
    case FXL_PLANE_LEFT:
    case FXL_PLANE_RIGHT:
        return (int128)sign * frustum.x_side * point->x + (int128)frustum.x_depth * point->z -
               inset;
    case FXL_PLANE_BOTTOM:
    case FXL_PLANE_TOP:
        return (int128)sign * frustum.y_side * point->y + (int128)frustum.y_depth * point->z -
               inset;
    case FXL_PLANE_NEAR:
        return one * (point->z - frustum.near_z);
    default:
        return one * (frustum.far_z - point->z);
    }
}

static int64_t part_way(int64_t from, int64_t to, double part)
{
    return from + (int64_t)((double)(to - from) * part);
}

bool exact_crossing(const designs_input *input, fxl_view_point *cut)
{
    fxl_view_point a = exact_view_point(input, 0), b = exact_view_point(input, 1);
    int128 inside = plane_distance(input, &a), outside = plane_distance(input, &b);
    if (inside <= 0 || outside >= 0) {
        return false;
    }
    double part = (double)inside / (double)(inside - outside);
    *cut = (fxl_view_point){part_way(a.x, b.x, part), part_way(a.y, b.y, part),
                            part_way(a.z, b.z, part)};
    return true;
}

designs_screen exact_screen(const designs_input *input, const fxl_view_point *point)
{
    double focal = input->lens.focal, z = (double)point->z;
    return (designs_screen){input->lens.width * 32768.0 + focal * (double)point->x / z,
                            input->lens.height * 32768.0 - focal * (double)point->y / z};
}

/* ceil(a / b), b > 0 */
static int64_t divide_up(int64_t a, int64_t b)
{
    return a / b + (a % b > 0);
}

/* The first column whose centre is not left of the edge, at a row's centre. All
 * products are below 2^30 * 2^30. */
static int64_t first_column(const fxl_screen_point *top, const fxl_screen_point *bottom,
                            int64_t centre_y)
{
    int64_t dx = (int64_t)bottom->x - top->x, dy = (int64_t)bottom->y - top->y;
    return divide_up((top->x - 32768) * dy + dx * (centre_y - top->y), 65536 * dy);
}

/* place fill-rule: definition: the exact design */
/* The winding rule of SPEC.md, section 5. */
void exact_fill(const fxl_screen_polygon *outline, const designs_bitmap *bitmap)
{
    designs_cover_begin(bitmap);
    for (int i = 0; i < outline->count; i++) {
        designs_edge edge = designs_edge_of(outline, i);
        for (int row = 0; row < bitmap->height; row++) {
            int64_t centre_y = row * INT64_C(65536) + 32768;
            if (centre_y >= edge.top.y && centre_y < edge.bottom.y) {
                designs_cover_add(bitmap, row, first_column(&edge.top, &edge.bottom, centre_y),
                                  edge.winding);
            }
        }
    }
    designs_cover_end(bitmap);
}
