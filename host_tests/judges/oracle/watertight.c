/* SPDX-License-Identifier: MIT */
/* watertight: splits a polygon by chords into pieces that share whole edges, and takes each
 * piece through the whole pipeline on its own. Compares with the exact outlines of the pieces:
 *   gap     a pixel that no piece draws. The winding numbers of the exact outlines about its centre
 *           do not add up to 0, and the centre is farther than the claim on outlines allows from
 *           every edge that has no neighbour.
 *   double  a pixel that two pieces draw, where fewer than two of the exact outlines have its
 *           centre. Pieces that overlap in exact arithmetic (not quite flat, seen from the side)
 *           may draw a pixel twice. */
#include <string.h>

#include "oracle/clip.h"
#include "oracle/cover.h"
#include "oracle/polygons.h"

enum {
    GAPS,
    DOUBLES,
    FOLDED,
    OVERLAPS,
    CUT_PIECES,
    WITH_PIXELS
};

enum {
    SIDE_MAX = 256,
    VERTICES_MAX = 12,
    SCREENS_MAX = 40 * VERTICES_MAX, /* of a clipper that gives triangles */
    FAN = 0,
    STRIP = 1,
    CHORD = 2 /* CHORD + n: the chord from vertex 0 to vertex CHORD + n */
};

typedef struct {
    int count;
    double bound; /* how far an edge without a neighbour may be off, in 1/65536 pixel */
    fxl_polygon polygons[FXL_FACE_VERTICES_MAX];
    /* For the edge from each vertex: whether another piece shares it. */
    uint8_t shared[FXL_FACE_VERTICES_MAX][FXL_FACE_VERTICES_MAX];
    int screen_count;
    fxl_screen_polygon screens[SCREENS_MAX];        /* as the library projects them */
    oracle_outline outlines[FXL_FACE_VERTICES_MAX]; /* the exact outlines */
} partition;

/* How often each pixel was drawn, and how many exact outlines hold its centre. */
static uint8_t drawn[FXL_SCREEN_MAX][FXL_SCREEN_MAX], exact[FXL_SCREEN_MAX][FXL_SCREEN_MAX];

static void generate(oracle_random *random, oracle_input *input)
{
    do {
        input->count = 0;
        oracle_polygon_generate(random, SIDE_MAX, VERTICES_MAX, input);
    } while (input->numbers[ORACLE_SETUP_NUMBERS] < 4);
    int64_t count = input->numbers[ORACLE_SETUP_NUMBERS];
    int64_t split = oracle_between(random, 0, 2);
    oracle_put(input, split < 2 ? split : CHORD + oracle_between(random, 0, count - 4));
}

/* Makes the piece whose vertices are those of the whole polygon with these numbers, in ascending
 * order. */
static void add_piece(const fxl_polygon *whole, const int *corners, int count, partition *pieces)
{
    fxl_polygon *piece = &pieces->polygons[pieces->count];
    *piece = (fxl_polygon){.colour = 1, .count = (uint8_t)count};
    for (int i = 0; i < count; i++) {
        int next = corners[(i + 1) % count];
        piece->vertices[i] = whole->vertices[corners[i]];
        pieces->shared[pieces->count][i] = next != (corners[i] + 1) % whole->count;
    }
    pieces->count++;
}

static void sort3(int corners[3])
{
    for (int i = 0; i < 3; i++) {
        for (int j = i + 1; j < 3; j++) {
            if (corners[i] > corners[j]) {
                int swap = corners[i];
                corners[i] = corners[j];
                corners[j] = swap;
            }
        }
    }
}

static void split(const fxl_polygon *whole, int how, partition *pieces)
{
    int count = whole->count;
    pieces->count = 0;
    if (how >= CHORD) {
        int corners[FXL_FACE_VERTICES_MAX], end = how, part = 0;
        for (int i = 0; i <= end; i++) {
            corners[part++] = i;
        }
        add_piece(whole, corners, part, pieces);
        part = 0;
        for (int i = end; i <= count; i++) {
            corners[part++] = i % count;
        }
        add_piece(whole, corners, part, pieces);
        return;
    }
    int low = 0, high = count - 1;
    for (int i = 1; i + 1 < count; i++) {
        int corners[3] = {0, i, i + 1};
        if (how == STRIP) {
            int forward = i % 2;
            corners[0] = low;
            corners[1] = high;
            corners[2] = forward ? ++low : --high;
            sort3(corners);
        }
        add_piece(whole, corners, 3, pieces);
    }
}

/* Draws a piece. Returns 0 where the library refuses it. */
static int draw(fxl_view *view, const fxl_polygon *polygon, partition *pieces,
                oracle_verdict *verdict)
{
    fxl_scan scan;
    fxl_span span;
    int count;
    fxl_screen_polygon *screen = &pieces->screens[pieces->screen_count];
    fxl_clip_result result =
        oracle_clipper_take(view, polygon, screen, SCREENS_MAX - pieces->screen_count, &count);
    verdict->extras[CUT_PIECES] += result == FXL_CLIP_CUT;
    pieces->screen_count += count;
    const fxl_band band = {
        .width = view->lens.width, .stride = view->lens.width, .rows = view->lens.height};
    for (; count > 0; count--, screen++) {
        if (fxl_scan_begin(screen, &band, &scan) != FXL_OK) {
            return 0;
        }
        while (fxl_scan_next(&scan, &span)) {
            for (int x = span.x0; x < span.x1; x++) {
                drawn[span.y][x]++;
            }
        }
    }
    return result != FXL_CLIP_CAPACITY && result != FXL_CLIP_RANGE;
}

/* Tells whether the centre is so near an edge without a neighbour that no result is certain. */
static int near_rim(const partition *pieces, int x, int y)
{
    oracle_spot centre = {(2 * (int64_t)x + 1) << 47, (2 * (int64_t)y + 1) << 47};
    for (int piece = 0; piece < pieces->count; piece++) {
        const oracle_outline *outline = &pieces->outlines[piece];
        for (int i = 0; i < outline->count; i++) {
            int origin = outline->origins[i];
            int inner = origin >= 0 && pieces->shared[piece][origin];
            if (!inner &&
                oracle_from_segment(&centre, &outline->spots[i],
                                    &outline->spots[(i + 1) % outline->count]) <= pieces->bound) {
                return 1;
            }
        }
    }
    return 0;
}

/* place fill-rule: what the two claims count */
/* The sum over all pieces is the winding number of the outline around them. It is 0 where a
 * folded piece covers another. */
static int exact_winding(const partition *pieces, int x, int y)
{
    int winding = 0;
    for (int piece = 0; piece < pieces->count; piece++) {
        const oracle_outline *outline = &pieces->outlines[piece];
        winding += oracle_winding(outline->spots, outline->count, ORACLE_SPOT_BITS, x, y);
    }
    return winding;
}

/* Tells whether pieces wind about the centre in opposite directions. Rounding has then reversed
 * a piece that is thinner than a unit, and by the non-zero rule the piece still covers a centre
 * that lies on it. The claim excepts that. */
static int folded(const partition *pieces, int x, int y)
{
    int signs = 0;
    for (int piece = 0; piece < pieces->screen_count; piece++) {
        const fxl_screen_polygon *screen = &pieces->screens[piece];
        oracle_spot spots[FXL_POLYGON_CAPACITY];
        for (int i = 0; i < screen->count; i++) {
            spots[i] = (oracle_spot){screen->points[i].x, screen->points[i].y};
        }
        int winding = oracle_winding(spots, screen->count, 0, x, y);
        signs |= winding > 0 ? 1 : winding < 0 ? 2 : 0;
    }
    return signs == 3;
}

static void judge_pixel(const partition *pieces, int x, int y, FILE *words, oracle_verdict *verdict)
{
    int gap = exact[y][x] > 0 && drawn[y][x] == 0 && exact_winding(pieces, x, y) != 0 &&
              !near_rim(pieces, x, y);
    int twice = drawn[y][x] > 1 && exact[y][x] < 2;
    verdict->extras[GAPS] += (uint64_t)gap;
    verdict->extras[DOUBLES] += (uint64_t)twice;
    verdict->extras[FOLDED] += twice && folded(pieces, x, y);
    verdict->extras[OVERLAPS] += drawn[y][x] > 1 && !twice;
    if (words && (gap || twice)) {
        fprintf(words, "pixel (%d, %d): %s, drawn %d times, exactly in %d of the outlines\n", x, y,
                gap ? "a gap" : "drawn twice", drawn[y][x], exact[y][x]);
    }
}

static oracle_outcome judge(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    static partition pieces;
    oracle_setup setup;
    fxl_polygon polygon;
    if (!oracle_polygon_read(input, 1, &setup, &polygon)) {
        return ORACLE_UNUSABLE;
    }
    int64_t how = input->numbers[input->count - 1];
    if (polygon.count < 4 || how < 0 || how > polygon.count - 2) {
        return ORACLE_UNUSABLE;
    }
    if (how >= CHORD && oracle_clipper_wants_triangles()) {
        return ORACLE_SKIPPED;
    }
    split(&polygon, (int)how, &pieces);
    pieces.bound = oracle_clipper_bound(&setup.view.lens);
    const oracle_space space = oracle_clipper_space(&setup.view);
    const fxl_lens *lens = &setup.view.lens;
    for (int y = 0; y < lens->height; y++) {
        memset(drawn[y], 0, lens->width);
        memset(exact[y], 0, lens->width);
    }
    int in_sight = 0, refused = 0;
    pieces.screen_count = 0;
    for (int i = 0; i < pieces.count; i++) {
        oracle_outline *outline = &pieces.outlines[i];
        oracle_clip(&space, &pieces.polygons[i], outline);
        in_sight += outline->count > 0;
        refused += !draw(&setup.view, &pieces.polygons[i], &pieces, verdict);
        for (int y = 0; y < lens->height && outline->count > 0; y++) {
            oracle_cover_row(outline->spots, outline->count, ORACLE_SPOT_BITS, y, lens->width,
                             exact[y]);
        }
    }
    if (in_sight < 2 && !refused) {
        return ORACLE_SKIPPED;
    }
    for (int y = 0; y < lens->height; y++) {
        for (int x = 0; x < lens->width; x++) {
            if (drawn[y][x] != 1 || exact[y][x] != 1) {
                judge_pixel(&pieces, x, y, words, verdict);
            }
            verdict->extras[WITH_PIXELS] |= drawn[y][x] != 0;
        }
    }
    uint64_t unexcused = verdict->extras[GAPS] + verdict->extras[DOUBLES] - verdict->extras[FOLDED];
    verdict->value = refused ? ORACLE_REFUSED : (double)unexcused;
    return ORACLE_COUNTED;
}

const oracle_claim oracle_watertight = {
    .id = "watertight",
    .unit = "pixels, gaps and drawn twice",
    .numbers = ORACLE_SETUP_TEXT
    ", count of vertices, x y z of each, split: 0 fan, 1 strip, n > 1 chord from vertex 0 to n",
    .kinds = {ORACLE_POLYGON_KINDS},
    .extras = {"gaps", "doubles", "folded", "overlaps_allowed", "cut_pieces", "with_pixels"},
    .generate = generate,
    .judge = judge,
};
