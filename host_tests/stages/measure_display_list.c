/* SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "reference/order.h"
#include "reference/scan.h"
#include "stages/bridge.h"
#include "stages/measure.h"

stages_tally stages_list_tally(const char *input)
{
    return (stages_tally){
        .stage = "list",
        .input = input,
        .unit = "rows",
        .measure = "rows that a polygon is kept for, too many or too few, given the same 16.16 "
                   "outline; and polygons that a list of any size gives back for a band, in order",
        .bound = "0",
    };
}

/* Compares one polygon's rows on both sides. */
static fxl_rows measure_rows(stages_tally *tally, const fxl_screen_polygon *polygon,
                             ref_drawn *drawn, uint16_t height)
{
    fxl_rows rows = fxl_scan_rows(polygon, height);
    drawn->polygon = bridge_screen_polygon(polygon);
    drawn->rows = ref_scan_rows(&drawn->polygon, height);
    int none = rows.first == rows.end && drawn->rows.first == drawn->rows.end;
    int wrong = none ? 0 : abs(rows.first - drawn->rows.first) + abs(rows.end - drawn->rows.end);
    stages_count(tally, wrong, wrong == 0);
    return rows;
}

static int same(const fxl_screen_polygon *record, const ref_drawn *drawn)
{
    int equal = record->count == drawn->polygon.count && record->colour == drawn->polygon.colour;
    for (int i = 0; equal && i < record->count; i++) {
        equal = record->points[i].x / REF_ONE == drawn->polygon.points[i].x &&
                record->points[i].y / REF_ONE == drawn->polygon.points[i].y;
    }
    return equal;
}

/* Tells whether both lists return the same polygons for the wanted rows. */
static int plays_alike(const fxl_display_list *list, const ref_display_list *twin, fxl_rows wanted)
{
    ref_rows rows = {wanted.first, wanted.end};
    const fxl_screen_polygon *record;
    uint32_t place = 0;
    size_t twin_place = 0;
    while ((record = fxl_display_list_next(list, wanted, &place)) != NULL) {
        const ref_drawn *drawn = ref_display_list_next(twin, rows, &twin_place);
        if (!drawn || !same(record, drawn)) {
            return 0;
        }
    }
    return ref_display_list_next(twin, rows, &twin_place) == NULL;
}

void stages_measure_list(stages_tally *tally, const fxl_screen_polygon *polygons, uint32_t count,
                         uint16_t height, uint32_t words, fxl_rows wanted)
{
    fxl_display_list list = {malloc(words * sizeof(uint32_t) + 1), words, 0};
    ref_display_list twin = {0};
    uint32_t left = words; /* SPEC.md, section 7: two words and two for each point */
    int sound = list.words != NULL, fits = 1;
    for (uint32_t i = 0; i < count && sound && fits; i++) {
        ref_drawn drawn = {0};
        fxl_rows rows = measure_rows(tally, &polygons[i], &drawn, height);
        if (drawn.rows.first == drawn.rows.end) {
            continue;
        }
        uint32_t needed = 2 + 2 * (uint32_t)drawn.polygon.count;
        fits = needed <= left;
        left -= fits ? needed : 0;
        sound = fxl_display_list_append(&list, &polygons[i], rows) == fits &&
                (!fits || ref_display_list_append(&twin, &drawn));
    }
    tally->mismatched += !sound || !plays_alike(&list, &twin, wanted);
    ref_display_list_close(&twin);
    free(list.words);
}
