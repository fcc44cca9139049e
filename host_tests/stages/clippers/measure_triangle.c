/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "clippers/measure.h"
#include "study/triangle.h"

/* What rides along is the corner's place in the world: seen from the eye it is where
 * the corner is on the screen, but for its own rounding, which near the eye is many
 * pixels. In units of that. */
static double carried_error(const clipper_case *of, const fxl_screen_corner *corner)
{
    fxl_point place = {corner->carried[0], corner->carried[1], corner->carried[2]};
    fxl_point into[3] = {place, place, place};
    clipper_case alone = *of;
    alone.polygon.count = 3;
    for (int i = 0; i < 3; i++) {
        alone.polygon.vertices[i].position = into[i];
    }
    ref_volume_polygon seen = case_seen(&alone);
    double focal = of->lens.focal / 65536.0;
    outline at =
        outline_of_volume(&seen, of->lens.width / 2.0, of->lens.height / 2.0, focal, focal);
    double away = (double)hypotl(at.x[0] * 65536 - corner->at.x, at.y[0] * 65536 - corner->at.y);
    double depth = (double)corner->depth * 0x1p-46;
    return fmax(0, away - 2) / (focal / depth * hypot(1, of->lens.width / focal));
}

/* Near and far with the inset, the borders of the screen without. */
static void expected_of(const clipper_case *of, outline *expected, bool *parallel)
{
    ref_half_space planes[REF_PLANE_COUNT];
    ref_lens lens = bridge_lens(&of->lens);
    ref_volume_from_lens(&lens, planes);
    for (int i = REF_PLANE_LEFT; i < REF_PLANE_COUNT; i++) {
        planes[i].d = 0;
    }
    case_expected(of, planes, expected, parallel);
}

typedef struct {
    double out, area; /* how far out a piece reaches; all of them */
    double missed[OUTLINE_MAX];
} pieces;

static void add_piece(pieces *all, const outline *piece, const outline *expected)
{
    for (int i = 0; i < 3 && expected->count >= 3; i++) {
        all->out = fmax(all->out, outline_beyond(expected, piece->x[i], piece->y[i]));
    }
    for (int i = 0; i < expected->count; i++) {
        all->missed[i] =
            fmin(all->missed[i], outline_beyond(piece, expected->x[i], expected->y[i]));
    }
    all->area += outline_area(piece);
}

static void count(clipper_tally *tally, const pieces *all, const outline *expected, bool parallel)
{
    double worst = all->out;
    for (int i = 0; i < expected->count; i++) {
        worst = fmax(worst, isinf(all->missed[i]) ? 0 : all->missed[i]);
    }
    double area = expected->count >= 3 ? outline_area(expected) : 0;
    double slack = (outline_length(expected) + 1) * tally->claimed / 65536;
    tally->verdicts += fabs(area - all->area) > slack;
    tally->cut++;
    tally->at_all = fmax(tally->at_all, worst);
    tally->beyond += worst > tally->claimed;
    tally->parallel += worst > tally->claimed && parallel;
    tally->outline = parallel ? tally->outline : fmax(tally->outline, worst);
}

void measure_triangle(clipper_tally *tally, const clipper_case *of)
{
    static fxl_triangle_workspace workspace;
    clipper_case one = *of;
    fxl_clip_triangle triangle;
    fxl_volume volume;
    outline expected;
    bool parallel;
    pieces all = {0, 0, {0}};
    one.polygon.count = 3;
    one.polygon.vertices[1] = of->polygon.vertices[of->polygon.count / 3];
    one.polygon.vertices[2] = of->polygon.vertices[of->polygon.count * 2 / 3];
    for (int i = 0; i < 3; i++) {
        fxl_transform_point(&of->camera, &one.polygon.vertices[i].position,
                            &triangle.corners[i].position);
        case_carry(&one, i, &triangle.corners[i]);
    }
    fxl_volume_from_lens(&of->lens, 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR, &volume);
    expected_of(&one, &expected, &parallel);
    for (int i = 0; i < OUTLINE_MAX; i++) {
        all.missed[i] = INFINITY;
    }
    workspace.stats = (fxl_clip_stats){0, 0, 0};
    workspace.screen_sliver = 0;
    fxl_clip_result cut = fxl_triangle_begin(&triangle, FXL_CARRIED_MAX, &volume, &workspace);
    tally->refused += cut == FXL_CLIP_CAPACITY;
    if (cut != FXL_CLIP_CUT && cut != FXL_CLIP_INSIDE) {
        case_compare(tally, NULL, &expected, parallel);
        return;
    }
    fxl_status status;
    const fxl_screen_triangle *piece;
    while ((piece = fxl_triangle_next(&volume, &of->lens, &workspace, &status)) != NULL) {
        fxl_screen_point points[3];
        for (int i = 0; i < 3; i++) {
            points[i] = piece->corners[i].at;
            tally->verdicts += points[i].x < 0 || points[i].x > of->lens.width * 65536 ||
                               points[i].y < 0 || points[i].y > of->lens.height * 65536;
            tally->carried = fmax(tally->carried, carried_error(of, &piece->corners[i]));
        }
        outline flat = outline_of_screen(points, 3);
        add_piece(&all, &flat, &expected);
        tally->made++;
    }
    tally->verdicts += status != FXL_OK;
    tally->crossings += workspace.stats.intersections;
    count(tally, &all, &expected, parallel);
}
