/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "answers.h"

/* FNV-1a of 64 bits. */
static const uint64_t basis = 0xCBF29CE484222325u, prime = 0x100000001B3u;
static uint64_t hash = 0xCBF29CE484222325u;

void record_bytes(const void *bytes, size_t size)
{
    const uint8_t *at = bytes;
    for (size_t i = 0; i < size; i++) {
        hash = (hash ^ at[i]) * prime;
    }
}

void record_number(int64_t number)
{
    record_bytes(&number, sizeof number);
}

void record_text(const char *text)
{
    record_bytes(text, text != NULL ? strlen(text) + 1 : 0);
}

void record_band(const fxl_band *band)
{
    for (uint32_t row = 0; row < band->rows; row++) {
        record_bytes(band->pixels + (size_t)row * band->stride, band->width);
    }
}

void record_points(const fxl_screen_polygon *polygon)
{
    record_number(polygon->count);
    record_bytes(polygon->points, polygon->count * sizeof polygon->points[0]);
}

void record_varying(const fxl_varying_polygon *polygon)
{
    record_number(polygon != NULL ? polygon->count : 0);
    for (uint32_t i = 0; polygon != NULL && i < polygon->count; i++) {
        const fxl_varying_vertex *vertex = &polygon->vertices[i];
        record_bytes(&vertex->position, sizeof vertex->position);
        record_bytes(vertex->carried, polygon->carried * sizeof vertex->carried[0]);
    }
}

uint64_t record_end(void)
{
    const uint64_t all = hash;
    hash = basis;
    return all;
}

/* --- single stages ------------------------------------------------------------ */

__extension__ typedef __int128 wide;

/* What a cut in the view may leave outside a plane, in units of 2^-46: three
 * units of its own, and less than two more for each of the planes after. */
#define VIEW_SLACK 16

/* How far an outline may pass the screen's edge, in 1/65536 pixel: projection's
 * rounding, and two units of 2^-30 in the direction of a plane's normal, which
 * turn the edge by focal (1 + tan^2) of that: much on a screen 1 wide and 1024
 * high, whose tangent is in the thousands, and next to nothing elsewhere. */
static int32_t screen_slack(fxl_q16_16 focal, int32_t half)
{
    int64_t turned = ((int64_t)focal * focal + (int64_t)half * half) / focal;
    return (int32_t)(2 + (turned >> 29));
}

/* The components of an off-centre lens's planes are shorter, and rounded twice. */
static void judge_on_screen(const fxl_view *view, fxl_q16_16 focal, uint16_t extent,
                            int32_t coordinate)
{
    int32_t slack = screen_slack(focal, extent * 32768);
    slack *= view->lens.off_centre != NULL ? 2 : 1;
    DEMAND(coordinate >= -slack && coordinate <= extent * 65536 + slack);
}

static bool has_result(fxl_clip_result cut)
{
    return cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT;
}

static void judge_shape(fxl_clip_result cut, const fxl_view_polygon *result)
{
    DEMAND(has_result(cut) == (result != NULL));
    DEMAND(result == NULL || (result->count >= 3 && result->count <= FXL_POLYGON_CAPACITY));
}

fxl_planes judge_outcode(const fxl_view_frustum *frustum, const fxl_view_point *point,
                         uint32_t some)
{
    fxl_planes outside = 0;
    for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
        bool is_outside = fxl_view_distance(frustum, plane, point) < 0;
        outside = (fxl_planes)(outside | (unsigned)is_outside << plane);
    }
    DEMAND(fxl_outcode(frustum, FXL_PLANES_ALL, point) == outside);
    DEMAND(fxl_outcode(frustum, (fxl_planes)some, point) == (outside & some));
    return outside;
}

void judge_view_clip(fxl_clip_result cut, const fxl_view_polygon *result, const fxl_view *view)
{
    judge_shape(cut, result);
    if (result == NULL) {
        return;
    }
    const fxl_lens lens = fxl_view_drawn_lens(view);
    for (uint32_t i = 0; i < result->count; i++) {
        const fxl_view_point *point = &result->vertices[i].position;
        fxl_screen_point screen;
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            DEMAND(fxl_view_distance(&view->view_frustum, plane, point) >= -VIEW_SLACK);
        }
        fxl_status status = fxl_project_point(&lens, point, &screen);
        DEMAND(status == FXL_OK);
        judge_projection(&lens, point, status, &screen);
        judge_on_screen(view, lens.focal, lens.width, screen.x);
        judge_on_screen(view, lens.focal, lens.height, screen.y);
    }
}

void judge_screen(fxl_clip_result cut, const fxl_screen_polygon *screen)
{
    if (!has_result(cut)) {
        return;
    }
    DEMAND(screen->count >= 3 && screen->count <= FXL_POLYGON_CAPACITY);
    for (uint32_t i = 0; i < screen->count; i++) {
        DEMAND(screen->points[i].x >= -FXL_SCREEN_COORDINATE_MAX);
        DEMAND(screen->points[i].x <= FXL_SCREEN_COORDINATE_MAX);
        DEMAND(screen->points[i].y >= -FXL_SCREEN_COORDINATE_MAX);
        DEMAND(screen->points[i].y <= FXL_SCREEN_COORDINATE_MAX);
    }
}

/* |value z - focal side| within 1/2 + 2^-31 |value| of z, and the slack of the
 * product's own rounding: everything times 2^31, below 2^124. */
static void judge_quotient(fxl_q16_16 focal, fxl_q18_46 side, fxl_q18_46 z, int32_t value)
{
    wide difference = (wide)value * z - (wide)focal * side;
    wide magnitude = value < 0 ? -(wide)value : value;
    wide bound = (((wide)1 << 30) + magnitude + 4) * z;
    difference = (difference < 0 ? -difference : difference) * ((wide)1 << 31);
    DEMAND(difference <= bound);
}

/* Whether the exact coordinate centre + sign focal side / z is out of the
 * screen's range, or within a unit of its end. */
static bool is_off_range(int64_t centre, int sign, fxl_q16_16 focal, fxl_q18_46 side, fxl_q18_46 z)
{
    wide scaled = centre * (wide)z + sign * (wide)focal * side;
    wide limit = (wide)(FXL_SCREEN_COORDINATE_MAX - 1) * z;
    return scaled > limit || scaled < -limit;
}

void judge_projection(const fxl_lens *lens, const fxl_view_point *view, fxl_status status,
                      const fxl_screen_point *screen)
{
    int32_t centre_x = lens->width * 32768, centre_y = lens->height * 32768;
    if (status != FXL_OK) {
        DEMAND(status == FXL_E_RANGE);
        DEMAND(view->z < FXL_PROJECT_DEPTH_MIN ||
               is_off_range(centre_x, 1, lens->focal, view->x, view->z) ||
               is_off_range(centre_y, -1, lens->focal, view->y, view->z));
        return;
    }
    DEMAND(view->z >= FXL_PROJECT_DEPTH_MIN);
    DEMAND(screen->x >= -FXL_SCREEN_COORDINATE_MAX && screen->x <= FXL_SCREEN_COORDINATE_MAX);
    DEMAND(screen->y >= -FXL_SCREEN_COORDINATE_MAX && screen->y <= FXL_SCREEN_COORDINATE_MAX);
    judge_quotient(lens->focal, view->x, view->z, screen->x - centre_x);
    judge_quotient(lens->focal, view->y, view->z, centre_y - screen->y);
}

static wide exact_dot(const fxl_direction *direction, wide x, wide y, wide z)
{
    return direction->x * x + direction->y * y + direction->z * z;
}

void judge_transform(const fxl_camera *camera, const fxl_point *point, const fxl_view_point *view)
{
    wide x = (wide)point->x - camera->position.x;
    wide y = (wide)point->y - camera->position.y;
    wide z = (wide)point->z - camera->position.z;
    DEMAND(view->x == exact_dot(&camera->axes.right, x, y, z));
    DEMAND(view->y == exact_dot(&camera->axes.up, x, y, z));
    DEMAND(view->z == exact_dot(&camera->axes.forward, x, y, z));
}

void judge_plane_distance(const fxl_plane *plane, const fxl_point *point, fxl_q18_46 distance)
{
    DEMAND(distance == exact_dot(&plane->normal, point->x, point->y, point->z) - plane->distance);
}

/* place fill-rule: definition: edge_winding */
/* +1, 0 or -1: what the edge a -> b adds to the winding number about a centre.
 * SPEC.md, section 5, in products below 2^60. */
static int edge_winding(const fxl_screen_point *a, const fxl_screen_point *b, int64_t cx,
                        int64_t cy)
{
    bool down = a->y <= cy && cy < b->y;
    bool up = b->y <= cy && cy < a->y;
    if (!down && !up) {
        return 0;
    }
    int64_t height = (int64_t)b->y - a->y;
    int64_t left = ((int64_t)b->x - a->x) * (cy - a->y) - (cx - a->x) * height;
    /* The edge's x is a.x + dx (cy - a.y) / height: at or left of the centre? */
    bool counts = down ? left <= 0 : left >= 0;
    return counts ? (down ? 1 : -1) : 0;
}

void judge_coverage(const fxl_screen_polygon *polygon, const fxl_band *band)
{
    for (int32_t row = 0; row < band->rows; row++) {
        for (int32_t x = 0; x < band->width; x++) {
            int winding = 0;
            int64_t cx = (int64_t)x * 65536 + 32768;
            int64_t cy = ((int64_t)band->first_row + row) * 65536 + 32768;
            for (uint32_t i = 0; i < polygon->count; i++) {
                uint32_t next = i + 1 == polygon->count ? 0 : i + 1;
                winding += edge_winding(&polygon->points[i], &polygon->points[next], cx, cy);
            }
            DEMAND(band->pixels[row * band->stride + x] == (winding != 0));
        }
    }
}
