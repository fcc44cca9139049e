/* SPDX-License-Identifier: MIT */
/* A line and a plane, the plane through three vertices, a rectangle, and the pieces of a triangle. */
#include <math.h>

#include "clippers/measure.h"
#include "reference/clip.h"
#include "reference/frustum.h"
#include "study/rectangle.h"
#include "study/triangle.h"

static void note(clipper_tally *tally, double error)
{
    tally->cut++;
    tally->outline = fmax(tally->outline, error);
    tally->at_all = fmax(tally->at_all, error);
    tally->beyond += error > tally->claimed;
}

static ref_volume_vertex vertex_of(const fxl_view_point *at)
{
    return (ref_volume_vertex){at->x, at->y, at->z, {0}};
}

static double apart(fxl_q18_46 got, ref_wide wanted)
{
    return fabs((double)(got - wanted));
}

/* The plane of the lens's frustum: one of six. The line through two vertices of the polygon meets
 * it between them or beyond. All in units of 2^-46, which is exact. */
void measure_line_and_plane(clipper_tally *tally, const clipper_case *of)
{
    fxl_volume volume;
    fxl_view_point from, to;
    fxl_line_meeting at;
    ref_wide t = 0;
    volume_of(&of->lens, FXL_PLANES_ALL, &volume);
    const fxl_half_space *plane = &volume.planes[(unsigned)of->polygon.vertices[0].u % 6];
    fxl_transform_point(&of->camera, &of->polygon.vertices[0].position, &from);
    fxl_transform_point(&of->camera, &of->polygon.vertices[1].position, &to);
    const ref_half_space same = {plane->normal.x, plane->normal.y, plane->normal.z,
                                 (ref_wide)plane->offset * FXL_Q2_30_ONE};
    const ref_volume_vertex a = vertex_of(&from), b = vertex_of(&to);
    const fxl_line_relation relation = fxl_line_meet_plane(&from, &to, plane, &at);
    const ref_line_relation wanted = ref_line_meet_plane(&a, &b, &same, &t);
    const bool meets = relation == FXL_LINE_MEETS || relation == FXL_LINE_MEETS_FAR;
    tally->verdicts += meets != (wanted == REF_LINE_MEETS);
    tally->verdicts += (relation == FXL_LINE_LIES_IN) != (wanted == REF_LINE_LIES_IN);
    if (relation == FXL_LINE_MEETS && wanted == REF_LINE_MEETS) {
        const ref_volume_vertex point = ref_volume_between(&a, &b, t);
        note(tally, fmax(apart(at.point.x, point.x),
                         fmax(apart(at.point.y, point.y), apart(at.point.z, point.z))));
        tally->verdicts += fabs((double)(at.parameter - t * 0x1p32)) > 1;
        tally->crossings += t < 0 || t > 1; /* beyond the ends */
    }
}

void measure_plane_from_points(clipper_tally *tally, const clipper_case *of)
{
    fxl_plane plane;
    ref_plane expected;
    ref_point points[3];
    for (int i = 0; i < 3; i++) {
        points[i] = bridge_point(&of->polygon.vertices[i].position);
    }
    const fxl_status status =
        fxl_plane_from_points(&of->polygon.vertices[0].position, &of->polygon.vertices[1].position,
                              &of->polygon.vertices[2].position, &plane);
    const bool made = ref_plane_from_points(&points[0], &points[1], &points[2], &expected);
    tally->verdicts += made != (status == FXL_OK);
    if (made && status == FXL_OK) {
        note(tally, fmax(fabs(plane.normal.x - expected.normal.x * 0x1p30),
                         fmax(fabs(plane.normal.y - expected.normal.y * 0x1p30),
                              fabs(plane.normal.z - expected.normal.z * 0x1p30))));
    }
}

/* The polygon as a map, from above; a world unit is a quarter of a pixel. */
static fxl_screen_polygon map_of(const clipper_case *of)
{
    fxl_screen_polygon map = {.count = of->polygon.count};
    for (int i = 0; i < map.count; i++) {
        const fxl_point *at = &of->polygon.vertices[i].position;
        map.points[i] = (fxl_screen_point){at->x / 4, at->z / 4};
    }
    return map;
}

/* The rectangle's corners are the middles between two pairs of vertices. */
static fxl_rectangle rectangle_about(const fxl_screen_polygon *map)
{
    const fxl_screen_point *p = map->points;
    const int32_t x0 = (p[0].x + p[1].x) / 2, y0 = (p[0].y + p[1].y) / 2;
    const int32_t x1 = (p[1].x + p[2].x) / 2 + 1, y1 = (p[1].y + p[2].y) / 2 + 1;
    return (fxl_rectangle){x0 < x1 ? x0 : x1, y0 < y1 ? y0 : y1, x0 < x1 ? x1 : x0,
                           y0 < y1 ? y1 : y0};
}

static outline outline_of(const ref_screen_polygon *polygon)
{
    outline made = {.count = polygon->count};
    for (int i = 0; i < made.count; i++) {
        made.x[i] = polygon->points[i].x;
        made.y[i] = polygon->points[i].y;
    }
    return made;
}

/* Where an edge meets a border at a small angle, the vertex moves along the border: so it is how
 * far a vertex lies beyond the twin's edges that has a bound, and the area. */
void measure_rectangle(clipper_tally *tally, const clipper_case *of)
{
    static fxl_rectangle_work work;
    const fxl_screen_polygon map = map_of(of);
    const fxl_rectangle to = rectangle_about(&map);
    const fxl_screen_polygon *result;
    const fxl_clip_result cut = fxl_clip_to_rectangle(&map, &to, &work, &result);
    const ref_screen_polygon in = bridge_screen_polygon(&map);
    const ref_rectangle same = {to.left / REF_ONE, to.top / REF_ONE, to.right / REF_ONE,
                                to.bottom / REF_ONE};
    ref_screen_polygon expected;
    outline wanted = {0}, got;
    tally->refused += cut == FXL_CLIP_CAPACITY;
    if (!of->convex || cut == FXL_CLIP_INSIDE) {
        return;
    }
    if (ref_clip_to_rectangle(&in, &same, &expected)) {
        wanted = outline_of(&expected);
    }
    if (cut == FXL_CLIP_CUT) {
        got = outline_of_screen(result->points, result->count);
    }
    if (cut != FXL_CLIP_CUT || wanted.count < 3) {
        case_compare(tally, cut == FXL_CLIP_CUT ? &got : NULL, &wanted, false);
        return;
    }
    double worst = 0;
    for (int i = 0; i < got.count; i++) {
        worst = fmax(worst, outline_beyond(&wanted, got.x[i], got.y[i]));
    }
    const double slack = (outline_length(&wanted) + 1) * tally->claimed / REF_ONE;
    tally->verdicts += fabs(outline_area(&wanted) - outline_area(&got)) > slack;
    note(tally, worst);
}

/* --- pieces of a triangle ------------------------------------------------------------------------ */

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
    volume_of(&of->lens, 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR, &volume);
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
