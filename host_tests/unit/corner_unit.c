/* SPDX-License-Identifier: MIT */
#include "corner_unit.h"

corner_triangle triangle;

double corner_plane_at(const double values[3], double x, double y)
{
    const fxl_screen_point *p = triangle.corners.points;
    const double x1 = p[1].x - (double)p[0].x, y1 = p[1].y - (double)p[0].y;
    const double x2 = p[2].x - (double)p[0].x, y2 = p[2].y - (double)p[0].y;
    const double area = x1 * y2 - x2 * y1, dx = x - p[0].x, dy = y - p[0].y;
    return values[0] + (values[1] - values[0]) * (dx * y2 - dy * x2) / area +
           (values[2] - values[0]) * (dy * x1 - dx * y1) / area;
}

static double largest(const double values[3])
{
    return fmax(fabs(values[0]), fmax(fabs(values[1]), fabs(values[2])));
}

static double range(const double values[3])
{
    return fmax(values[0], fmax(values[1], values[2])) -
           fmin(values[0], fmin(values[1], values[2]));
}

double corner_twice_area(void)
{
    const fxl_screen_point *p = triangle.corners.points;
    return fabs((p[1].x - (double)p[0].x) * (p[2].y - (double)p[0].y) -
                (p[2].x - (double)p[0].x) * (p[1].y - (double)p[0].y));
}

/* What rounding costs a plane through values at the corners, beside what is cut off its steps:
 * accuracy 5.1.1. With W and H the sides of the box and L the longer one, the triangle fills 1/n of
 * the box, so twice its area is 2 W H / n. A side is scaled to 2^30 or more and the reciprocal of
 * the area is 2^30 or more, so the largest possible coefficient, L over twice the area, is at least
 * 2^28 units. Each of the two coefficients of a step loses less than a unit, times a difference of
 * at most the range: together 2 range units a pixel, over W + H pixels. The reciprocal is within
 * 2^-29, which changes all coefficients alike. */
double corner_plane_rounding(const double values[3])
{
    const double w = triangle.corners.width, h = triangle.corners.height,
                 n = 2 * w * h / corner_twice_area();
    return range(values) * (ldexp(1, -29) + ldexp(n, -28) * (1 + fmax(w, h) / fmin(w, h)));
}

/* The same of depth, whose values at the corners are rounded too: each by less than 2^-25 of the
 * largest. */
double corner_depth_rounding(const double values[3])
{
    return corner_plane_rounding(values) + ldexp(largest(values), -25);
}

/* Sets the box of the corners, which it keeps on the screen. */
static void find_box(void)
{
    const int32_t width = triangle.view.lens.width * 65536,
                  height = triangle.view.lens.height * 65536;
    int32_t x[2] = {width, 0}, y[2] = {height, 0};
    for (int i = 0; i < 3; i++) {
        fxl_screen_point *p = &triangle.corners.points[i];
        p->x = p->x < 0 ? 0 : p->x < width ? p->x : width;
        p->y = p->y < 0 ? 0 : p->y < height ? p->y : height;
        x[0] = p->x < x[0] ? p->x : x[0];
        x[1] = p->x > x[1] ? p->x : x[1];
        y[0] = p->y < y[0] ? p->y : y[0];
        y[1] = p->y > y[1] ? p->y : y[1];
    }
    triangle.corners.width = x[1] - x[0];
    triangle.corners.height = y[1] - y[0];
    triangle.corners.is_triangle = true;
}

void corner_make(double spread)
{
    const int32_t width = triangle.view.lens.width * 65536,
                  height = triangle.view.lens.height * 65536;
    const int32_t wide = unit_between(1, unit_random() % 2 ? 70 << 16 : 3 << 16);
    const int32_t high = unit_between(1, unit_random() % 2 ? 70 << 16 : 3 << 16);
    const int32_t left = unit_between(0, width), top = unit_between(0, height);
    const double depth = ldexp(1 + unit_between(0, 65535) / 65536.0, unit_between(40, 58));
    for (int i = 0; i < 3; i++) {
        triangle.corners.points[i].x = left + unit_between(0, wide);
        triangle.corners.points[i].y = top + unit_between(0, high);
        triangle.corners.depths[i] =
            (fxl_q18_46)(depth * (1 + spread * unit_between(0, 65535) / 65536));
    }
    find_box();
}

void corner_make_thin(double part)
{
    const double along = unit_between(10, 90) / 100.0;
    const double beside = 2 * part * unit_between(960, 1080) / 1000.0;
    fxl_screen_point *p = triangle.corners.points;
    const double wide = unit_random() % 2 ? 63.99 * 65536 : triangle.corners.width;
    const double high = unit_random() % 2 ? 63.99 * 65536 : triangle.corners.height;
    p[1].x = p[0].x + (int32_t)wide;
    p[1].y = p[0].y + (int32_t)high;
    p[2].x = p[0].x + (int32_t)(wide * (along + beside / 2));
    p[2].y = p[0].y + (int32_t)(high * (along - beside / 2));
    find_box();
}

void corner_choose_point(double *x, double *y)
{
    double share[3] = {unit_between(0, 1000), unit_between(0, 1000), unit_between(1, 1000)};
    const double sum = share[0] + share[1] + share[2];
    *x = *y = 0;
    for (int i = 0; i < 3; i++) {
        *x += triangle.corners.points[i].x * share[i] / sum;
        *y += triangle.corners.points[i].y * share[i] / sum;
    }
}

void corner_choose_place(double *x, double *y)
{
    const int corner = unit_between(0, 5);
    corner_choose_point(x, y);
    if (corner < 3) {
        *x = triangle.corners.points[corner].x;
        *y = triangle.corners.points[corner].y;
    }
}

/* An attribute with the weight, where it is divided. */
typedef struct {
    double products[3], weights[3];
} divided_planes;

static divided_planes divided_of(const double values[3])
{
    divided_planes of;
    for (int k = 0; k < 3; k++) {
        of.weights[k] = 1 / (double)triangle.corners.depths[k];
        of.products[k] = values[k] * of.weights[k];
    }
    return of;
}

double corner_attribute_at(const double values[3], double x, double y)
{
    const divided_planes of = divided_of(values);
    return corner_plane_at(of.products, x, y) / corner_plane_at(of.weights, x, y);
}

/* What rounding costs it: that of both planes, a part of the weight there; weights at the corners,
 * which differ by less than 2^-24 of their exact ratios, and so move it by less than a quarter of
 * that of the range; and products at the corners, rounded downward, by less than 2^-25 of the
 * largest value times the largest weight. */
double corner_divided_rounding(const double values[3], double x, double y)
{
    const divided_planes of = divided_of(values);
    const double weight = corner_plane_at(of.weights, x, y);
    const double planes_cost =
        corner_plane_rounding(of.products) +
        fabs(corner_attribute_at(values, x, y)) * corner_plane_rounding(of.weights);
    const double products_cost = ldexp(largest(values) * largest(of.weights), -25);
    return (planes_cost + products_cost) / weight + ldexp(range(values), -26);
}

void corner_begin(void)
{
    const int width = 2 * unit_between(1, 512), height = 2 * unit_between(1, 300);
    triangle.view = clip_random_view((uint16_t)width, (uint16_t)height);
}

void corner_begin_seed(uint32_t seed)
{
    unit_seed(seed);
    corner_begin();
}
