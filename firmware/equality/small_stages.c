/* SPDX-License-Identifier: MIT */
/* Stages that have a different path with FXL_SMALL. Both sides get the same input, and must give
 * the same result. */
#include "raster/scan.h"
#include "view/order.h"

#include "equality.h"
#include "sides.h"

#define ENTRIES 24u

static int32_t within(int32_t limit)
{
    return (int32_t)(any_32() % (2u * (uint32_t)limit + 1u)) - limit;
}

/* --- the order of faces --------------------------------------------------------- */

void test_order(uint32_t rounds)
{
    static fxl_draw_entry core[ENTRIES], portable[ENTRIES];
    static fxl_sort_work work;
    for (uint32_t i = 0; i < rounds; i++) {
        const uint32_t count = 1u + (any_32() >> 7) % ENTRIES;
        const bool few = (any_32() & 0x300u) == 0;
        bool same = true;
        for (uint32_t place = 0; place < count; place++) {
            uint64_t distance = few ? any_32() >> 29 : any_64() >> (any_32() >> 9 & 31u);
            core[place] = portable[place] = fxl_draw_entry_of(distance, (uint16_t)place, 0);
        }
        fxl_sort_faces(core, count, &work);
        portable_sort_faces(portable, count, &work);
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

/* place fill-rule: random corners within a unit of a centre */
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

/* The number of cases, which are spans; at least as many as rounds. */
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
