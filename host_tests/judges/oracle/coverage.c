/* SPDX-License-Identifier: MIT */
/* coverage: compares the pixels that scan covers with exact arithmetic, given the 16.16 outline;
 * on small screens also those of the reference renderer. */
#include <string.h>

#include "draw/stages.h"
#include "fixel/all.h"
#include "oracle/claim.h"
#include "oracle/cover.h"
#include "oracle/grid.h"
#include "oracle/outlines.h"
#include "reference/scan.h"

enum {
    REFERENCE_OFF,
    TWICE,
    OUTSIDE_BAND,
    ORACLE_OFF
};

/* A band's pixels, and how often each was covered. */
static uint8_t covered[FXL_SCREEN_MAX][FXL_SCREEN_MAX];

static void generate(oracle_random *random, uint64_t index, oracle_input *input)
{
    (void)index;
    static const int sizes[] = {1, 4, 16, 16, 32, 32, 64, 320};
    int width = sizes[oracle_below(random, 8)], height = sizes[oracle_below(random, 8)];
    if (oracle_below(random, 64) == 0) {
        width = height = FXL_SCREEN_MAX;
    }
    int first = 0;
    if (oracle_below(random, 2)) {
        first = (int)oracle_below(random, (uint32_t)height);
        height -= first;
        height = 1 + (int)oracle_below(random, (uint32_t)height);
    }
    oracle_put(input, width);
    oracle_put(input, first);
    oracle_put(input, height);
    oracle_outline_generate(random, width, first + height, input);
}

static int in_range(const oracle_input *input)
{
    const int64_t *n = input->numbers;
    if (input->count < 4 || n[0] < 1 || n[0] > FXL_SCREEN_MAX || n[1] < 0 || n[2] < 1 ||
        n[1] + n[2] > FXL_SCREEN_MAX || n[3] < 3 || n[3] > FXL_POLYGON_CAPACITY ||
        input->count != 4 + 2 * n[3]) {
        return 0;
    }
    for (int i = 4; i < input->count; i++) {
        if (n[i] < -FXL_SCREEN_COORDINATE_MAX || n[i] > FXL_SCREEN_COORDINATE_MAX) {
            return 0;
        }
    }
    return 1;
}

/* Marks the library's spans. Returns 0 where it refuses the outline. */
static int draw(const fxl_screen_polygon *polygon, const fxl_band *band, oracle_verdict *verdict)
{
    fxl_scan scan;
    fxl_span span;
    if (fxl_scan_begin(polygon, band, &scan) != FXL_OK) {
        return 0;
    }
    while (fxl_scan_next(&scan, &span)) {
        int row = span.y - band->first_row;
        if (row < 0 || row >= band->rows || span.x0 < 0 || span.x0 >= span.x1 ||
            span.x1 > band->width) {
            verdict->extras[OUTSIDE_BAND]++;
            continue;
        }
        for (int x = span.x0; x < span.x1; x++) {
            covered[row][x]++;
        }
    }
    return 1;
}

static uint64_t compare_row(const uint8_t *got, const uint8_t *exact, int width, int y, FILE *words,
                            oracle_verdict *verdict)
{
    uint64_t off = 0;
    if (memcmp(got, exact, (size_t)width) == 0) {
        return 0;
    }
    for (int x = 0; x < width; x++) {
        verdict->extras[TWICE] += got[x] > 1;
        off += got[x] != exact[x];
        if (words && got[x] != exact[x]) {
            fprintf(words, "pixel (%d, %d): library %d times, exactly %d\n", x, y, got[x],
                    exact[x]);
        }
    }
    return off;
}

/* place fill-rule: what the two claims count */
/* Tests the reference renderer, and the oracle's own rows, pixel by pixel. */
static void judge_others(const oracle_spot *points, int count, const uint8_t *exact, int width,
                         int y, oracle_verdict *verdict)
{
    ref_screen_polygon polygon = {.colour = 1, .count = count};
    for (int i = 0; i < count; i++) {
        polygon.points[i] =
            (ref_screen_point){(double)points[i].x / 65536, (double)points[i].y / 65536};
    }
    for (int x = 0; x < width; x++) {
        verdict->extras[REFERENCE_OFF] +=
            ref_scan_covers(&polygon, x + 0.5, y + 0.5) != (exact[x] != 0);
        verdict->extras[ORACLE_OFF] +=
            (oracle_winding(points, count, 0, x, y) != 0) != (exact[x] != 0);
    }
}

static oracle_outcome judge(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    if (!in_range(input)) {
        return ORACLE_UNUSABLE;
    }
    const int64_t *n = input->numbers;
    int width = (int)n[0], first = (int)n[1], rows = (int)n[2], count = (int)n[3];
    oracle_spot points[FXL_POLYGON_CAPACITY];
    fxl_screen_polygon polygon = {.colour = 1, .count = (uint8_t)count};
    for (int i = 0; i < count; i++) {
        points[i] = (oracle_spot){n[4 + 2 * i], n[5 + 2 * i]};
        polygon.points[i] = (fxl_screen_point){(int32_t)points[i].x, (int32_t)points[i].y};
    }
    fxl_band band = {.width = (uint16_t)width,
                     .stride = (uint16_t)width,
                     .first_row = (uint16_t)first,
                     .rows = (uint16_t)rows};
    for (int row = 0; row < rows; row++) {
        memset(covered[row], 0, (size_t)width);
    }
    if (!draw(&polygon, &band, verdict)) {
        verdict->value = ORACLE_REFUSED;
        return ORACLE_COUNTED;
    }
    uint64_t off = 0;
    for (int row = 0; row < rows; row++) {
        uint8_t exact[FXL_SCREEN_MAX] = {0};
        oracle_cover_row(points, count, 0, first + row, width, exact);
        off += compare_row(covered[row], exact, width, first + row, words, verdict);
        if (width <= 16 && rows <= 16) {
            judge_others(points, count, exact, width, first + row, verdict);
        }
    }
    verdict->value = (double)(off + verdict->extras[OUTSIDE_BAND]);
    return ORACLE_COUNTED;
}

const oracle_claim oracle_coverage = {
    .id = "coverage",
    .unit = "pixels",
    .numbers = "band's width, first row and rows, count of points, x y of each in 1/65536 pixel",
    .kinds = {ORACLE_OUTLINE_KINDS, "all triangles of the grid"},
    .extras = {"twin_off", "twice", "outside_band", "oracle_off"},
    .generate = generate,
    .judge = judge,
};

/* --- all triangles of 4 x 4 pixels -------------------------------------------- */

enum {
    GRID_PIXELS = 4,
    GRID_STEPS = 4 * GRID_PIXELS + 1,
    GRID_POINTS = GRID_STEPS * GRID_STEPS,
    GRID_KIND = 9
};

static void judge_triangle(const int corners[3], oracle_tally *tally)
{
    oracle_input input = {
        .kind = GRID_KIND, .count = 10, .numbers = {GRID_PIXELS, 0, GRID_PIXELS, 3}};
    oracle_spot points[3];
    fxl_screen_polygon polygon = {.colour = 1, .count = 3};
    for (int i = 0; i < 3; i++) {
        int32_t x = corners[i] % GRID_STEPS * 16384, y = corners[i] / GRID_STEPS * 16384;
        input.numbers[4 + 2 * i] = x;
        input.numbers[5 + 2 * i] = y;
        points[i] = (oracle_spot){x, y};
        polygon.points[i] = (fxl_screen_point){x, y};
    }
    const fxl_band band = {.width = GRID_PIXELS, .stride = GRID_PIXELS, .rows = GRID_PIXELS};
    oracle_verdict verdict = {0};
    for (int y = 0; y < GRID_PIXELS; y++) {
        memset(covered[y], 0, GRID_PIXELS);
    }
    int drawn = draw(&polygon, &band, &verdict);
    for (int y = 0; y < GRID_PIXELS; y++) {
        uint8_t exact[GRID_PIXELS] = {0};
        oracle_cover_row(points, 3, 0, y, GRID_PIXELS, exact);
        verdict.value += (double)compare_row(covered[y], exact, GRID_PIXELS, y, NULL, &verdict);
    }
    verdict.value += (double)verdict.extras[OUTSIDE_BAND];
    if (!drawn) {
        verdict.value = ORACLE_REFUSED;
    }
    oracle_tally_count(tally, &input, &verdict);
}

void oracle_grid(uint64_t shard, uint64_t shards, oracle_tally *tally)
{
    for (int a = 0; a < GRID_POINTS; a++) {
        if ((uint64_t)a % shards != shard) {
            continue;
        }
        for (int b = a; b < GRID_POINTS; b++) {
            for (int c = b; c < GRID_POINTS; c++) {
                judge_triangle((int[3]){a, b, c}, tally);
                judge_triangle((int[3]){a, c, b}, tally);
            }
        }
    }
}
