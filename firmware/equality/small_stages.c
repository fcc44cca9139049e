/* SPDX-License-Identifier: MIT */
/* What -Os puts in the place of stages: both sides get the same input, and must
 * answer the same. */
#include "small_stages.h"

#include "equality.h"
#include "fixel/angle.h"
#include "fixel/clip_view.h"
#include "fixel/order.h"
#include "fixel/scan.h"
#include "fixel/sphere.h"
#include "fixel/view.h"
#include "sides.h"
#include "sine.h"

#define ENTRIES 24u

static int32_t within(int32_t limit)
{
    return (int32_t)(any_32() % (2u * (uint32_t)limit + 1u)) - limit;
}

static void compare_sines(fxl_angle angle)
{
    equality_case(fxl_sin_q31(angle) == portable_sin_q31(angle) &&
                  fxl_cos_q31(angle) == portable_cos_q31(angle) &&
                  fxl_sin(angle) == portable_sin(angle) && fxl_cos(angle) == portable_cos(angle));
}

void test_sines(uint32_t rounds)
{
    /* About each eighth of a turn, and about powers of two. */
    for (uint32_t eighth = 0; eighth < 8; eighth++) {
        for (uint32_t i = 0; i < BOUNDARY_32_COUNT; i++) {
            compare_sines((eighth << 29) + boundary_32(i));
            compare_sines((eighth << 29) - boundary_32(i));
        }
    }
    for (uint32_t i = 0; i < rounds; i++) {
        compare_sines(any_32());
    }
}

/* --- a view ------------------------------------------------------------------- */

static fxl_view view;

static bool same_direction(const fxl_direction *a, const fxl_direction *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

static fxl_angle any_angle(void)
{
    uint32_t angle = any_32();
    return (any_32() & 0x70u) == 0 ? (angle & 0xE0000000u) + (any_32() >> 30) : angle;
}

static void any_pose(fxl_pose *pose)
{
    pose->position = (fxl_point){within(FXL_COORDINATE_MAX), within(FXL_COORDINATE_MAX),
                                 within(FXL_COORDINATE_MAX)};
    pose->yaw = any_angle();
    pose->pitch = any_angle();
    pose->roll = any_angle();
}

void test_camera(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds; i++) {
        fxl_pose pose;
        fxl_camera core = {0}, portable = {0};
        any_pose(&pose);
        if ((any_32() & 0xF00u) == 0) {
            pose.position.y += within(FXL_COORDINATE_MAX);
        }
        bool same =
            fxl_camera_from_pose(&pose, &core) == portable_camera_from_pose(&pose, &portable);
        equality_case(same && same_direction(&core.right, &portable.right) &&
                      same_direction(&core.up, &portable.up) &&
                      same_direction(&core.forward, &portable.forward));
    }
}

static void any_view(void)
{
    fxl_pose pose;
    fxl_lens lens;
    any_pose(&pose);
    fxl_angle fov = FXL_FOV_MIN + any_32() % (FXL_FOV_MAX - FXL_FOV_MIN + 1u);
    fxl_lens_from_fov((uint16_t)(1u + any_32() % 1024u), (uint16_t)(1u + any_32() % 1024u), fov,
                      FXL_NEAR_MIN << (any_32() >> 9 & 7u), FXL_FAR_MAX >> (any_32() >> 9 & 7u), 4,
                      &lens);
    fxl_view_set_lens(&view, &lens);
    fxl_view_set_pose(&view, &pose);
}

void test_sphere(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds; i++) {
        if (i % 32u == 0) {
            any_view();
        }
        int32_t limit = FXL_COORDINATE_MAX >> (any_32() >> 8 & 15u);
        const fxl_point centre = {within(limit), within(limit), within(limit)};
        fxl_q16_16 radius = (fxl_q16_16)(any_32() % (FXL_RADIUS_MAX + 1u)) >> (any_32() >> 9 & 15u);
        equality_case(fxl_sphere_planes(&view.camera, &view.view_frustum, &centre, radius) ==
                      portable_sphere_planes(&view.camera, &view.view_frustum, &centre, radius));
    }
}

/* --- a polygon of the view ------------------------------------------------------ */

/* Below 2^61. */
static int64_t any_side(void)
{
    return (int64_t)any_64() >> (3 + (any_32() >> 5 & 31u));
}

static bool same_polygon(const fxl_view_polygon *a, const fxl_view_polygon *b)
{
    bool same = a->count == b->count && a->colour == b->colour;
    for (uint32_t i = 0; same && i < a->count; i++) {
        const fxl_view_vertex *of_a = &a->vertices[i], *of_b = &b->vertices[i];
        same = of_a->position.x == of_b->position.x && of_a->position.y == of_b->position.y &&
               of_a->position.z == of_b->position.z &&
               (!a->textured || (of_a->u == of_b->u && of_a->v == of_b->v));
    }
    return same;
}

void test_clip(uint32_t rounds)
{
    static fxl_view_polygon in;
    static fxl_clip_view_work core, portable;
    for (uint32_t i = 0; i < rounds; i++) {
        if (i % 32u == 0) {
            any_view();
        }
        const unsigned shift = any_32() >> 8 & 7u;
        in.count = (uint8_t)(3u + (any_32() >> 6) % ((any_32() & 0x300u) == 0 ? 30u : 3u));
        in.textured = (any_32() & 4u) != 0;
        for (uint32_t v = 0; v < in.count; v++) {
            in.vertices[v].position =
                (fxl_view_point){any_side() >> shift, any_side() >> shift, any_side() >> shift};
            in.vertices[v].u = (fxl_q16_16)any_32();
            in.vertices[v].v = (fxl_q16_16)any_32();
        }
        const fxl_planes planes = (fxl_planes)(any_32() >> 7 & FXL_PLANES_ALL);
        const fxl_view_polygon *by_core, *by_portable;
        bool same =
            fxl_clip_view_to_planes(&in, &view.view_frustum, planes, &core, &by_core) ==
            portable_clip_view_to_planes(&in, &view.view_frustum, planes, &portable, &by_portable);
        equality_case(same && (by_core == NULL) == (by_portable == NULL) &&
                      (by_core == NULL || same_polygon(by_core, by_portable)));
    }
}

/* --- the order of faces --------------------------------------------------------- */

void test_order(uint32_t rounds)
{
    static fxl_order_entry core[ENTRIES], portable[ENTRIES];
    for (uint32_t i = 0; i < rounds; i++) {
        const uint32_t count = 1u + (any_32() >> 7) % ENTRIES;
        const bool few = (any_32() & 0x300u) == 0;
        bool same = true;
        for (uint32_t place = 0; place < count; place++) {
            uint64_t distance = few ? any_32() >> 29 : any_64() >> (any_32() >> 9 & 31u);
            core[place] = portable[place] = fxl_order_entry_of(distance, (uint16_t)place, 0);
        }
        fxl_order_sort_faces(core, count);
        portable_order_sort_faces(portable, count);
        for (uint32_t place = 0; place < count; place++) {
            same &= core[place].face == portable[place].face;
        }
        equality_case(same);
    }
}

/* --- spans ------------------------------------------------------------------------ */

/* One case a span, and one for the end. */
static void compare_spans(const fxl_screen_point *points, uint32_t count, const fxl_band *band)
{
    static fxl_scan core, portable;
    fxl_scan_outline(points, count, band, &core);
    portable_scan_outline(points, count, band, &portable);
    for (;;) {
        fxl_span by_core, by_portable;
        bool more = fxl_scan_next(&core, &by_core);
        if (portable_scan_next(&portable, &by_portable) != more) {
            equality_case(false);
            return;
        }
        if (!more) {
            break;
        }
        equality_case(by_core.y == by_portable.y && by_core.x0 == by_portable.x0 &&
                      by_core.x1 == by_portable.x1);
    }
    equality_case(core.outline_first == portable.outline_first &&
                  core.outline_end == portable.outline_end);
}

/* Anywhere, near the band, or on a centre of it or beside one. */
static fxl_q16_16 any_place(uint32_t extent)
{
    const uint32_t choice = any_32() >> 9 & 7u;
    if (choice == 0) {
        return within(FXL_SCREEN_COORDINATE_MAX);
    }
    int32_t place = (int32_t)(any_32() % ((extent + 8u) << 16)) - (4 << 16);
    return choice < 4 ? (int32_t)((uint32_t)place & 0xFFFF0000u) + 0x8000 + (int32_t)choice - 2
                      : place;
}

/* In cases, which are spans: rounds of them at least. */
void test_outlines(uint32_t rounds)
{
    const uint32_t end = equality_cases() + rounds;
    while (equality_cases() < end) {
        fxl_screen_point points[8];
        const uint32_t tall = (any_32() & 15u) == 0 ? FXL_SCREEN_MAX : 40u;
        const uint32_t count = 3u + (any_32() >> 11) % 6u;
        fxl_band band = {0};
        band.width = (uint16_t)(1u + (any_32() >> 7) % tall);
        band.first_row = (uint16_t)((any_32() >> 8 & 1u) * (any_32() >> 9) % tall);
        band.rows = (uint16_t)(1u + (any_32() >> 6) % (FXL_SCREEN_MAX - band.first_row));
        for (uint32_t i = 0; i < count; i++) {
            points[i] = (fxl_screen_point){any_place(band.width), any_place(tall)};
        }
        compare_spans(points, count, &band);
    }
}
