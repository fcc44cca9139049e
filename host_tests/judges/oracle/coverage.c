/* SPDX-License-Identifier: MIT */
/* coverage: compares the pixels that scan covers with exact arithmetic, given the 16.16 outline;
 * on small screens also those of the reference renderer. */
#include <math.h>
#include <string.h>

#include "draw/stages.h"
#include "fixel/all.h"
#include "oracle/cover.h"
#include "oracle/claim.h"
#include "reference/scan.h"

/* --- adversarial outlines ------------------------------------------------------- */

enum {
    ANYWHERE,
    HALVES,
    NEAR_CENTRES,
    ABOUT_SCREEN,
    ROUND,
    THROUGH_CENTRES,
    SQUARE,
    SLIVER,
    ENDS,
    KINDS
};

typedef struct {
    oracle_random *random;
    int width, height;
} outline_maker;

static int64_t limited(int64_t coordinate)
{
    return coordinate < -FXL_SCREEN_COORDINATE_MAX  ? -FXL_SCREEN_COORDINATE_MAX
           : coordinate > FXL_SCREEN_COORDINATE_MAX ? FXL_SCREEN_COORDINATE_MAX
                                                    : coordinate;
}

static int64_t about(oracle_random *random, int size)
{
    return oracle_between(random, -4 * 65536, (size + 4) * 65536);
}

/* place fill-rule: random corners on pixel centres, where ties are */
static int64_t centre(oracle_random *random, int size)
{
    return oracle_between(random, -1, size) * 65536 + 32768;
}

static int64_t end(oracle_random *random, int size)
{
    switch (oracle_below(random, 4)) {
    case 0:
        return FXL_SCREEN_COORDINATE_MAX - oracle_between(random, 0, 2);
    case 1:
        return -FXL_SCREEN_COORDINATE_MAX + oracle_between(random, 0, 2);
    default:
        return about(random, size);
    }
}

static int64_t coordinate(oracle_random *random, int kind, int size)
{
    switch (kind) {
    case ANYWHERE:
        return oracle_between(random, -FXL_SCREEN_COORDINATE_MAX, FXL_SCREEN_COORDINATE_MAX);
    case HALVES:
        return oracle_between(random, -4, 2 * size + 4) * 32768;
    case NEAR_CENTRES:
        return centre(random, size) + oracle_between(random, -1, 1);
    case ENDS:
        return end(random, size);
    default:
        return about(random, size);
    }
}

/* Two points on the line through two centres, an integer number of steps outside them. */
static void through_centres(const outline_maker *maker, oracle_spot *a, oracle_spot *b)
{
    oracle_spot p = {centre(maker->random, maker->width), centre(maker->random, maker->height)};
    oracle_spot q = {centre(maker->random, maker->width), centre(maker->random, maker->height)};
    int64_t back = oracle_between(maker->random, 0, 2), on = oracle_between(maker->random, 1, 3);
    *a = (oracle_spot){p.x - back * (q.x - p.x), p.y - back * (q.y - p.y)};
    *b = (oracle_spot){p.x + on * (q.x - p.x), p.y + on * (q.y - p.y)};
}

static void make_round(const outline_maker *maker, oracle_spot *points, int count)
{
    double x = oracle_uniform(maker->random, 0, maker->width);
    double y = oracle_uniform(maker->random, 0, maker->height);
    double wide = oracle_spread(maker->random, 1e-4, 2.0 * maker->width);
    double high = oracle_spread(maker->random, 1e-4, 2.0 * maker->height);
    double turn = oracle_uniform(maker->random, 0, 6.28);
    for (int i = 0; i < count; i++) {
        double angle = turn + 6.283185307179586 * i / count;
        points[i].x = (int64_t)floor((x + wide * cos(angle)) * 65536 + 0.5);
        points[i].y = (int64_t)floor((y + high * sin(angle)) * 65536 + 0.5);
    }
    /* Points on an edge, rounded, bend it either way. */
    if (oracle_below(maker->random, 2)) {
        for (int i = 1; i + 1 < count; i += 2) {
            points[i].x = (points[i - 1].x + points[i + 1].x) >> 1;
            points[i].y = (points[i - 1].y + points[i + 1].y) >> 1;
        }
    }
}

static void make(const outline_maker *maker, int kind, oracle_spot *points, int count)
{
    oracle_random *random = maker->random;
    if (kind == ROUND) {
        make_round(maker, points, count);
        return;
    }
    for (int i = 0; i < count; i++) {
        points[i].x = coordinate(random, kind, maker->width);
        points[i].y = coordinate(random, kind, maker->height);
        if (kind == THROUGH_CENTRES && i % 2 == 0 && i + 1 < count) {
            through_centres(maker, &points[i], &points[i + 1]);
            i++;
        } else if (kind == SQUARE && i > 0) {
            *(i % 2 ? &points[i].x : &points[i].y) = i % 2 ? points[i - 1].x : points[i - 1].y;
        } else if (kind == SLIVER && i > 1) {
            points[i].x = points[i - 2].x + oracle_between(random, -3, 3);
            points[i].y = points[i - 2].y + oracle_between(random, -3, 3);
        }
    }
}

/* Sets the kind of the input, and appends the count of points and their x y. */
static void put_outline(oracle_random *random, int width, int height, oracle_input *input)
{
    outline_maker maker = {random, width, height};
    oracle_spot points[FXL_POLYGON_CAPACITY];
    int most = oracle_below(random, 4) ? 6 : FXL_POLYGON_CAPACITY;
    int count = (int)oracle_between(random, 3, most);
    input->kind = (int)oracle_below(random, KINDS);
    make(&maker, input->kind, points, count);
    /* Repeated vertices. */
    if (oracle_below(random, 8) == 0) {
        points[count - 1] = points[oracle_below(random, (uint32_t)count)];
    }
    oracle_put(input, count);
    for (int i = 0; i < count; i++) {
        oracle_put(input, limited(points[i].x));
        oracle_put(input, limited(points[i].y));
    }
}

/* --- the claim ------------------------------------------------------------------ */

enum {
    REFERENCE_OFF,
    TWICE,
    OUTSIDE_BAND,
    ORACLE_OFF
};

/* A band's pixels, and how often each was covered. */
static uint8_t covered[FXL_SCREEN_MAX][FXL_SCREEN_MAX];

static void generate(oracle_random *random, oracle_input *input)
{
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
    put_outline(random, width, first + height, input);
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
    .kinds = {"anywhere in range", "on half pixels", "within a unit of centres", "about the screen",
              "round, rounded to slightly concave", "edges through centres",
              "horizontals and verticals", "slivers", "at the ends of the range",
              "all triangles of the grid"},
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
