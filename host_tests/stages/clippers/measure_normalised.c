/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "clippers/measure.h"
#include "study/clip_once.h"

static void load(const clipper_case *of, const fxl_normalised *frustum,
                 fxl_varying_polygon *polygon)
{
    *polygon = (fxl_varying_polygon){.count = of->polygon.count, .carried = FXL_CARRIED_MAX};
    for (int i = 0; i < of->polygon.count; i++) {
        fxl_normalised_point(frustum, &of->polygon.vertices[i].position,
                             &polygon->vertices[i].position);
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

static void measure(clipper_tally *tally, const clipper_case *of, bool once, fxl_q18_46 sliver)
{
    static fxl_clip_workspace workspace;
    static fxl_clip_once_workspace once_workspace;
    fxl_varying_polygon polygon;
    const fxl_varying_polygon *result;
    fxl_normalised frustum;
    fxl_normalised_from_camera(&of->camera, &of->lens, &frustum);
    load(of, &frustum, &polygon);
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
    measure(tally, of, false, 0);
}

void measure_once(clipper_tally *tally, const clipper_case *of)
{
    if (of->convex) { /* it goes by edges, and promises nothing of others */
        measure(tally, of, true, 0);
    }
}

void measure_once_triangle(clipper_tally *tally, const clipper_case *of)
{
    clipper_case triangle = *of;
    triangle.polygon.count = 3;
    triangle.polygon.vertices[1] = of->polygon.vertices[of->polygon.count / 3];
    triangle.polygon.vertices[2] = of->polygon.vertices[of->polygon.count * 2 / 3];
    measure(tally, &triangle, true, 0);
}

void measure_sliver(clipper_tally *tally, const clipper_case *of)
{
    measure(tally, of, false, (fxl_q18_46)1 << (46 - 8));
}
