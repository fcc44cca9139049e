/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "clippers/measure.h"
#include "study/clip_once.h"
#include "study/half_space.h"

#define UNIT 0x1p46

static ref_volume_vertex vertex_of(const fxl_varying_vertex *from)
{
    ref_volume_vertex made = {from->position.x / (ref_wide)UNIT,
                              from->position.y / (ref_wide)UNIT,
                              from->position.z / (ref_wide)UNIT,
                              {0}};
    for (int i = 0; i < REF_CARRIED_MAX; i++) {
        made.carried[i] = from->carried[i] / REF_ONE;
    }
    return made;
}

static void load(const clipper_case *of, fxl_varying_polygon *polygon)
{
    *polygon = (fxl_varying_polygon){.count = of->polygon.count, .carried = FXL_CARRIED_MAX};
    for (int i = 0; i < of->polygon.count; i++) {
        fxl_transform_point(&of->camera, &of->polygon.vertices[i].position,
                            &polygon->vertices[i].position);
        case_carry(of, i, &polygon->vertices[i]);
    }
}

/* Counts a clipped polygon of the view, its vertices and what they carry. */
static void count_result(clipper_tally *tally, const clipper_case *of, fxl_clip_result cut,
                         const fxl_varying_polygon *result, const ref_half_space *planes)
{
    outline expected, got;
    bool parallel;
    case_expected(of, planes, &expected, &parallel);
    tally->refused += cut == FXL_CLIP_CAPACITY;
    if (cut == FXL_CLIP_CUT) {
        fxl_screen_point points[FXL_POLYGON_CAPACITY];
        for (int i = 0; i < result->count; i++) {
            const fxl_view_point *at = &result->vertices[i].position;
            tally->verdicts += fxl_project_point(&of->lens, at, &points[i]) != FXL_OK;
            tally->carried =
                fmax(tally->carried,
                     case_carried_error(of, &result->vertices[i], (double)at->x * 0x1p-46,
                                        (double)at->y * 0x1p-46, (double)at->z * 0x1p-46));
        }
        got = outline_of_screen(points, result->count);
        case_compare(tally, &got, &expected, parallel);
    } else if (cut != FXL_CLIP_INSIDE) {
        case_compare(tally, NULL, &expected, parallel);
    }
}

static void measure(clipper_tally *tally, const clipper_case *of, uint32_t screen)
{
    static fxl_clip_workspace workspace;
    static fxl_varying_polygon polygon;
    const fxl_varying_polygon *result;
    fxl_volume volume;
    ref_half_space planes[REF_PLANE_COUNT];
    ref_lens lens = bridge_lens(&of->lens);
    volume_of(&of->lens, screen, &volume);
    ref_volume_from_lens(&lens, planes);
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        if ((screen >> i & 1) == 0) { /* by docs/extras/clippers.md: focal |x| <= 3500 z */
            bool upright = i >= REF_PLANE_BOTTOM;
            double across = i == REF_PLANE_LEFT || i == REF_PLANE_BOTTOM ? lens.focal : -lens.focal;
            planes[i] = (ref_half_space){upright ? 0 : across, upright ? across : 0, 3500, 0};
        }
    }
    load(of, &polygon);
    workspace.stats = (fxl_clip_stats){0, 0, 0};
    fxl_clip_result cut = fxl_clip_to_volume(&polygon, &volume, &workspace, &result);
    tally->crossings += workspace.stats.intersections;
    count_result(tally, of, cut, result, planes);
}

/* place clipper: the error of each clipper against the reference */
void measure_half_spaces(clipper_tally *tally, const clipper_case *of)
{
    measure(tally, of, (1u << FXL_PLANE_COUNT) - 1);
}

void measure_near_and_guard(clipper_tally *tally, const clipper_case *of)
{
    measure(tally, of, 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR);
}

void measure_left_and_guard(clipper_tally *tally, const clipper_case *of)
{
    measure(tally, of, 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR | 1u << FXL_PLANE_LEFT);
}

/* A frustum that looks anywhere, from numbers of the case. */
static void window_of(const clipper_case *of, fxl_volume *volume, ref_half_space *planes)
{
    fxl_q16_16 left = of->polygon.vertices[0].u / 64, bottom = of->polygon.vertices[0].v / 64;
    fxl_q16_16 right = left + 65536 + (of->polygon.vertices[1].u & 0xFFFFF);
    fxl_q16_16 top = bottom + 65536 + (of->polygon.vertices[1].v & 0xFFFFF);
    fxl_q16_16 near = FXL_NEAR_MIN + (of->polygon.vertices[2].u & 0xFFFFF), far = of->lens.far_z;
    far = far > near ? far : near + 1;
    fxl_volume_from_window(left, right, bottom, top, near, far, volume);
    ref_volume_from_window(left / REF_ONE, right / REF_ONE, bottom / REF_ONE, top / REF_ONE,
                           near / REF_ONE, far / REF_ONE, planes);
}

/* In view space: units of 2^-46. */
static double apart(const ref_volume_vertex *a, const ref_volume_vertex *b)
{
    long double x = (long double)(a->x - b->x), y = (long double)(a->y - b->y);
    return (double)hypotl(x, hypotl(y, (long double)(a->z - b->z))) * UNIT;
}

/* From the point to the line through two others, in units of 2^-46. */
static double from_line(const ref_volume_vertex *p, const ref_volume_vertex *a,
                        const ref_volume_vertex *b)
{
    ref_wide dx = b->x - a->x, dy = b->y - a->y, dz = b->z - a->z;
    ref_wide wx = p->x - a->x, wy = p->y - a->y, wz = p->z - a->z;
    long double x = (long double)(wy * dz - wz * dy), y = (long double)(wz * dx - wx * dz);
    long double z = (long double)(wx * dy - wy * dx);
    long double length = hypotl((long double)dx, hypotl((long double)dy, (long double)dz));
    return length > 0 ? (double)(hypotl(x, hypotl(y, z)) / length) * UNIT : apart(p, a);
}

static void measure_line(clipper_tally *tally, const clipper_case *of,
                         bool (*clip)(fxl_clip_line *, const fxl_volume *, uint32_t *))
{
    fxl_varying_polygon polygon;
    fxl_volume volume;
    ref_half_space planes[REF_PLANE_COUNT];
    window_of(of, &volume, planes);
    load(of, &polygon);
    for (int i = 0; i < polygon.count; i++) {
        fxl_clip_line line = {polygon.vertices[i], polygon.vertices[(i + 1) % polygon.count],
                              FXL_CARRIED_MAX};
        ref_volume_vertex from = vertex_of(&line.from), to = vertex_of(&line.to);
        ref_wide enter, leave;
        uint32_t intersections = 0;
        bool seen = clip(&line, &volume, &intersections);
        bool expected = ref_clip_line(&from, &to, planes, REF_PLANE_COUNT, &enter, &leave);
        tally->crossings += intersections;
        if (seen != expected) { /* a corner that it passes by less than rounding is either's */
            tally->verdicts += expected && (double)(leave - enter) * apart(&from, &to) > 64;
            tally->at_all = fmax(tally->at_all, seen ? (double)(enter - leave) : 0);
        } else if (seen && intersections > 0) {
            ref_volume_vertex a = vertex_of(&line.from), b = vertex_of(&line.to);
            double distance = fmax(from_line(&a, &from, &to), from_line(&b, &from, &to));
            tally->cut++;
            tally->outline = fmax(tally->outline, distance);
            tally->beyond += distance > tally->claimed;
            for (int k = 0; k < REF_PLANE_COUNT; k++) {
                double length =
                    sqrt((double)(planes[k].a * planes[k].a + planes[k].b * planes[k].b +
                                  planes[k].c * planes[k].c));
                double out = -fmin((double)ref_half_space_distance(&planes[k], &a),
                                   (double)ref_half_space_distance(&planes[k], &b));
                tally->at_all = fmax(tally->at_all, out / length * UNIT);
            }
        }
    }
}

void measure_line_by_planes(clipper_tally *tally, const clipper_case *of)
{
    measure_line(tally, of, fxl_line_by_planes);
}

void measure_line_by_codes(clipper_tally *tally, const clipper_case *of)
{
    measure_line(tally, of, fxl_line_by_codes);
}

/* --- in the normalised frustum ------------------------------------------------------------------- */

static void load_normalised(const clipper_case *of, const fxl_normalised *frustum,
                            fxl_varying_polygon *polygon)
{
    *polygon = (fxl_varying_polygon){.count = of->polygon.count, .carried = FXL_CARRIED_MAX};
    for (int i = 0; i < of->polygon.count; i++) {
        fxl_point from_eye;
        fxl_subtract(&of->polygon.vertices[i].position, &frustum->eye, &from_eye);
        fxl_normalised_from_eye(frustum, &from_eye, &polygon->vertices[i].position);
        case_carry(of, i, &polygon->vertices[i]);
    }
}

/* Back from the normalised frustum into the view, by its definition. */
static double carried_error(const clipper_case *of, const fxl_varying_vertex *vertex)
{
    double focal = of->lens.focal / 65536.0;
    double x = focal / (of->lens.width / 2.0), y = focal / (of->lens.height / 2.0);
    double largest = exp2(ceil(log2(fmax(1, fmax(x, y)))));
    const fxl_view_point *at = &vertex->position;
    return case_carried_error(of, vertex, (double)at->x * 0x1p-46 * largest / x,
                              (double)at->y * 0x1p-46 * largest / y,
                              (double)at->z * 0x1p-46 * largest);
}

/* Vertices that a plane made. */
static uint64_t count_made(const fxl_varying_polygon *in, const fxl_varying_polygon *out)
{
    uint64_t made = 0;
    for (int i = 0; i < out->count; i++) {
        bool old = false;
        for (int k = 0; k < in->count; k++) {
            const fxl_view_point *a = &out->vertices[i].position, *b = &in->vertices[k].position;
            old |= a->x == b->x && a->y == b->y && a->z == b->z;
        }
        made += !old;
    }
    return made;
}

/* Whether a vertex lies on two planes. */
static bool has_corner(const fxl_normalised *frustum, const fxl_varying_polygon *out)
{
    bool any = false;
    for (int i = 0; i < out->count; i++) {
        int on = 0;
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            on += llabs(fxl_normalised_distance(frustum, plane, &out->vertices[i].position)) < 16;
        }
        any |= on > 1;
    }
    return any;
}

static void measure_in(clipper_tally *tally, const clipper_case *of, bool once, fxl_q18_46 sliver)
{
    static fxl_clip_workspace workspace;
    static fxl_clip_once_workspace once_workspace;
    fxl_varying_polygon polygon;
    const fxl_varying_polygon *result;
    fxl_normalised frustum;
    fxl_normalised_from_camera(&of->camera, &of->lens, &frustum);
    load_normalised(of, &frustum, &polygon);
    workspace.stats = once_workspace.stats = (fxl_clip_stats){sliver, 0, 0};
    fxl_clip_result cut = once ? fxl_clip_once(&polygon, &frustum, &once_workspace, &result)
                               : fxl_clip_normalised(&polygon, &frustum, &workspace, &result);
    if (cut == FXL_CLIP_CUT) {
        uint32_t crossings = (once ? &once_workspace.stats : &workspace.stats)->intersections;
        bool plain = !has_corner(&frustum, result);
        tally->crossings += crossings;
        tally->made += count_made(&polygon, result);
        tally->plain_crossings += plain ? crossings : 0;
        tally->plain_made += plain ? count_made(&polygon, result) : 0;
    }
    tally->refused += cut == FXL_CLIP_CAPACITY;

    ref_half_space planes[REF_PLANE_COUNT];
    ref_lens lens = bridge_lens(&of->lens);
    ref_volume_from_lens(&lens, planes);
    outline expected, got;
    bool parallel;
    case_expected(of, planes, &expected, &parallel);
    if (cut == FXL_CLIP_CUT) {
        fxl_screen_point points[FXL_POLYGON_CAPACITY];
        for (int i = 0; i < result->count; i++) {
            tally->verdicts += fxl_normalised_project(&frustum, &result->vertices[i].position,
                                                      &points[i]) != FXL_OK;
            tally->carried = fmax(tally->carried, carried_error(of, &result->vertices[i]));
        }
        got = outline_of_screen(points, result->count);
        case_compare(tally, &got, &expected, parallel);
    } else if (cut != FXL_CLIP_INSIDE) {
        case_compare(tally, NULL, &expected, parallel);
    }
}

void measure_normalised(clipper_tally *tally, const clipper_case *of)
{
    measure_in(tally, of, false, 0);
}

void measure_once(clipper_tally *tally, const clipper_case *of)
{
    if (of->convex) { /* it goes by edges, and promises nothing of others */
        measure_in(tally, of, true, 0);
    }
}

void measure_once_triangle(clipper_tally *tally, const clipper_case *of)
{
    clipper_case triangle = *of;
    triangle.polygon.count = 3;
    triangle.polygon.vertices[1] = of->polygon.vertices[of->polygon.count / 3];
    triangle.polygon.vertices[2] = of->polygon.vertices[of->polygon.count * 2 / 3];
    measure_in(tally, &triangle, true, 0);
}

void measure_sliver(clipper_tally *tally, const clipper_case *of)
{
    measure_in(tally, of, false, (fxl_q18_46)1 << (46 - 8));
}
