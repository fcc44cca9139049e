/* SPDX-License-Identifier: MIT */
/* Both sides scan the same outline. The trapezoids, and the state of the scan between them, must
 * be equal. */

#include "equality.h"
#include "sides.h"

static bool same_edge(const fxl_edge *a, const fxl_edge *b)
{
    return a->x == b->x && a->fraction == b->fraction && a->step == b->step &&
           a->step_fraction == b->step_fraction;
}

static bool same_scan(const fxl_scan *a, const fxl_scan *b)
{
    bool same = a->end_row == b->end_row && a->trapezoid.first_row == b->trapezoid.first_row &&
                a->trapezoid.end_row == b->trapezoid.end_row;
    for (uint32_t side = 0; side < 2; side++) {
        same &= a->chains[side].vertex == b->chains[side].vertex &&
                a->chains[side].end_row == b->chains[side].end_row &&
                same_edge(&a->trapezoid.edges[side], &b->trapezoid.edges[side]);
    }
    return same;
}

/* The same pixels of a core that has no chains: the spans of active edges, a case each, and one for
 * the end. */
static bool compare_spans(const fxl_screen_point *points, uint32_t count, const fxl_band *band)
{
    static fxl_scan core, portable;
    fxl_span by_core, by_portable;
    fxl_scan_outline(points, count, band, &core);
    portable_scan_outline(points, count, band, &portable);
    if (!portable.by_chains) {
        return false;
    }
    while (portable_scan_next(&portable, &by_portable)) {
        equality_case(fxl_scan_next(&core, &by_core) && by_core.y == by_portable.y &&
                      by_core.x0 == by_portable.x0 && by_core.x1 == by_portable.x1);
    }
    equality_case(!fxl_scan_next(&core, &by_core));
    return true;
}

/* Counts one case for each trapezoid, and one for the end. Returns false where the outline has
 * more than two chains. */
static bool compare(const fxl_screen_point *points, uint32_t count, const fxl_band *band)
{
    static fxl_scan core, portable;
    if (!FXL_SCANS_BY_CHAINS) {
        return compare_spans(points, count, band);
    }
    fxl_scan_outline(points, count, band, &core);
    fxl_scan_outline(points, count, band, &portable);
    if (!core.by_chains) {
        return false;
    }
    for (uint32_t trapezoids = 0; trapezoids < 2000; trapezoids++) {
        const fxl_trapezoid *by_core = fxl_scan_next_trapezoid(&core);
        const fxl_trapezoid *by_portable = portable_scan_next_trapezoid(&portable);
        equality_case((by_core == NULL) == (by_portable == NULL) && same_scan(&core, &portable));
        if (by_core == NULL || by_portable == NULL) {
            return true;
        }
    }
    equality_case(false);
    return true;
}

/* Within the sides: any, or at an end; on a centre or beside one every other time. */
static fxl_q16_16 any_place(uint32_t from, uint32_t end)
{
    uint32_t choice = any_32() >> 9 & 7u;
    if (choice < 2) {
        return (fxl_q16_16)(choice == 0 ? from : end);
    }
    int32_t place = (int32_t)(from + (any_32() >> 4) % (end - from + 1u));
    if (choice < 5) {
        place = (int32_t)(((uint32_t)place & 0xFFFF0000u) + 0x8000u) + (int32_t)choice - 3;
    }
    return place < (int32_t)from || place > (int32_t)end ? (fxl_q16_16)end : place;
}

static void any_band(fxl_band *band, uint32_t tall)
{
    band->width = (uint16_t)(1u + (any_32() >> 7) % FXL_SCREEN_MAX);
    band->first_row = (uint16_t)((any_32() >> 8 & 1u) * (any_32() >> 9) % tall);
    band->rows = (uint16_t)(1u + (any_32() >> 6) % (FXL_SCREEN_MAX - band->first_row));
}

static void any_outline(uint32_t tall)
{
    fxl_band band = {0};
    fxl_screen_point points[5];
    uint32_t count = 3u + (any_32() >> 11) % 3u;
    int32_t top = (int32_t)(any_32() >> 6 & 1u) * -(int32_t)((any_32() >> 8) % (tall << 15));
    any_band(&band, tall);
    for (uint32_t i = 0; i < count; i++) {
        points[i].x = any_place(0, (uint32_t)band.width << 16);
        points[i].y = top + any_place(0, tall << 16);
    }
    compare(points, count, &band);
}

void test_chains(uint32_t rounds)
{
    /* Edges of every height up to the greatest, straight and across, from every
     * band that begins on a power of two. */
    for (uint32_t rows = 1; rows <= 1022; rows++) {
        for (uint32_t first = 0; first < 1024; first = first == 0 ? 1 : 2 * first) {
            const fxl_band band = {.pixels = NULL, .width = FXL_SCREEN_MAX,
                                   .stride = FXL_SCREEN_MAX, .first_row = (uint16_t)first,
                                   .rows = (uint16_t)(FXL_SCREEN_MAX - first)};
            const int32_t end = (int32_t)(rows << 16) - (int32_t)(any_32() >> 17),
                          width = 1024 << 16;
            const fxl_screen_point points[] = {
                {0, 0}, {width, (int32_t)(any_32() & 1u) * end}, {width, end}, {0, end}};
            equality_case(compare(points, 4, &band));
        }
    }
    for (uint32_t i = 0; i < rounds; i++) {
        any_outline((any_32() & 7u) == 0 ? 1000u : 1u + (any_32() >> 9) % 60u);
    }
}
