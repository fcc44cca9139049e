/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "clippers/measure.h"

static void load(const clipper_case *of, const fxl_normalised *frustum, fxl_clip_polygon *polygon)
{
    *polygon = (fxl_clip_polygon){.count = of->polygon.count, .carried = FXL_CARRIED_MAX};
    for (int i = 0; i < of->polygon.count; i++) {
        fxl_normalised_point(frustum, &of->polygon.vertices[i].position,
                             &polygon->vertices[i].position);
        case_carry(of, i, &polygon->vertices[i]);
    }
}

/* Back from the normalised frustum into the view, by its definition. */
static double carried_error(const clipper_case *of, const fxl_clip_vertex *vertex)
{
    double focal = of->lens.focal / 65536.0;
    double x = focal / (of->lens.width / 2.0), y = focal / (of->lens.height / 2.0);
    double largest = fmax(1, fmax(x, y));
    const fxl_view_point *at = &vertex->position;
    return case_carried_error(of, vertex, (double)at->x * 0x1p-46 * largest / x,
                              (double)at->y * 0x1p-46 * largest / y,
                              (double)at->z * 0x1p-46 * largest);
}

void measure_normalised(clipper_tally *tally, const clipper_case *of)
{
    static fxl_clip_room room;
    fxl_clip_polygon polygon;
    const fxl_clip_polygon *result;
    fxl_normalised frustum;
    fxl_normalised_from_camera(&of->camera, &of->lens, &frustum);
    load(of, &frustum, &polygon);
    room.account = (fxl_clip_account){0, 0};
    fxl_clip_result cut = fxl_clip_normalised(&polygon, &frustum, &room, &result);
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
        tally->crossings += room.account.intersections;
        got = outline_of_screen(points, result->count);
        case_compare(tally, &got, &expected, parallel);
    } else if (cut != FXL_CLIP_INSIDE) {
        case_compare(tally, NULL, &expected, parallel);
    }
}
