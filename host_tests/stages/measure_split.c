/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "../../lib/paint/lit_pieces.h"
#include "reference/light.h"
#include "reference/split.h"
#include "stages/bridge.h"
#include "stages/measure.h"

enum {
    FROM_PLANE
};

_Static_assert((int)SPLIT_FRONT == (int)REF_SPLIT_FRONT && (int)SPLIT_BACK == (int)REF_SPLIT_BACK &&
                   (int)SPLIT_BOTH == (int)REF_SPLIT_BOTH &&
                   (int)SPLIT_CAPACITY == (int)REF_SPLIT_CAPACITY,
               "outcomes of splitting");

const stages_tally stages_split_tally = {
    .stage = "split",
    .unit = "1/65536 world unit",
    .measure = "splitting in the world: largest coordinate difference of a point of either "
               "part from the reference's, both given the same piece and plane; max_from_plane is "
               "the largest distance of a new point from the exact plane",
    .bound = "0; 0.87 from the plane",
    .extra_names = {"max_from_plane"},
};

static ref_piece piece_of(const split_piece *piece)
{
    ref_piece result = {.count = (int)piece->count};
    for (uint32_t i = 0; i < piece->count; i++) {
        const fxl_point *p = &piece->points[i];
        result.points[i] = (ref_lattice_point){p->x, p->y, p->z};
    }
    return result;
}

static int is_of(const ref_piece *piece, const ref_lattice_point *point)
{
    for (int i = 0; i < piece->count; i++) {
        const ref_lattice_point *p = &piece->points[i];
        if (p->x == point->x && p->y == point->y && p->z == point->z) {
            return 1;
        }
    }
    return 0;
}

/* Compares outlines as cycles: which point comes first is not specified. */
static double difference(const ref_piece *a, const ref_piece *b, int shift)
{
    double largest = 0;
    for (int i = 0; i < a->count; i++) {
        const ref_lattice_point *p = &a->points[i], *q = &b->points[(i + shift) % b->count];
        largest = fmax(largest, fmax(fabs((double)p->x - q->x),
                                     fmax(fabs((double)p->y - q->y), fabs((double)p->z - q->z))));
    }
    return largest;
}

static void compare(stages_tally *tally, const ref_piece *in, const ref_plane *plane,
                    const split_piece *fixed, const ref_piece *exact)
{
    const ref_piece part = piece_of(fixed);
    if (part.count != exact->count) {
        tally->mismatched++;
        return;
    }
    double least = difference(&part, exact, 0), from_plane = 0;
    for (int shift = 1; shift < part.count; shift++) {
        least = fmin(least, difference(&part, exact, shift));
    }
    for (int i = 0; i < part.count; i++) {
        if (!is_of(in, &part.points[i])) {
            from_plane = fmax(from_plane,
                              REF_ONE * (double)fabsl(ref_split_distance(plane, &part.points[i])));
        }
    }
    stages_count(tally, least, least <= 0 && from_plane <= 0.87);
    stages_extra(tally, FROM_PLANE, from_plane);
}

void stages_measure_split(stages_tally *tally, const fxl_plane *plane, const split_piece *piece)
{
    split_piece front, back;
    ref_piece exact_front, exact_back;
    const ref_piece in = piece_of(piece);
    const ref_plane exact_plane = bridge_plane(plane);
    split_result result = split_by(piece, plane, &front, &back);
    ref_split_result exact_result = ref_split_piece(&in, &exact_plane, &exact_front, &exact_back);
    tally->mismatched += (int)result != (int)exact_result;
    if (result == SPLIT_BOTH && exact_result == REF_SPLIT_BOTH) {
        compare(tally, &in, &exact_plane, &front, &exact_front);
        compare(tally, &in, &exact_plane, &back, &exact_back);
    }
}

/* --- by beams ------------------------------------------------------------------------------------ */

enum {
    CORNERS = 512,
    PIECES = 128,
    BEAMS = 2
};

const stages_tally stages_light_tally = {
    .stage = "light",
    .unit = "1/65536 world unit",
    .measure = "faces split by beams: largest coordinate difference of a vertex of a piece "
               "from the reference's, both given the same face and beams; another number of "
               "pieces or vertices, or one that is lit in one of both alone, is a mismatch",
    .bound = "0",
};

static ref_beam beam_of(const fxl_beam *beam)
{
    ref_beam result = {.from = {beam->from[0], beam->from[1], beam->from[2]},
                       .kind = beam->kind,
                       .plane_count = beam->plane_count};
    for (uint32_t i = 0; i < beam->plane_count; i++) {
        const fxl_plane plane = fxl_beam_plane_at(beam, i);
        result.planes[i] = bridge_plane(&plane);
    }
    return result;
}

static double distance(const fxl_point *a, const ref_lattice_point *b)
{
    return fmax(fabs((double)a->x - b->x),
                fmax(fabs((double)a->y - b->y), fabs((double)a->z - b->z)));
}

/* Compares outlines as cycles: which vertex comes first is not specified. */
static double lit_difference(const fxl_point *points, const ref_piece *piece)
{
    double least = HUGE_VAL;
    for (int shift = 0; shift < piece->count; shift++) {
        double largest = 0;
        for (int i = 0; i < piece->count; i++) {
            largest =
                fmax(largest, distance(&points[i], &piece->points[(i + shift) % piece->count]));
        }
        least = fmin(least, largest);
    }
    return least;
}

static void compare_lit(stages_tally *tally, const fxl_lit_pieces *made,
                        const ref_lit_pieces *exact)
{
    if ((int)made->piece_count != exact->count) {
        tally->mismatched++;
        return;
    }
    for (uint32_t i = 0; i < made->piece_count; i++) {
        const fxl_lit_piece *piece = &made->pieces[i];
        const ref_lit_piece *wanted = &exact->pieces[i];
        fxl_point outline[FXL_POLYGON_CAPACITY];
        if (!fxl_lit_outline(made, piece, outline) || piece->count != wanted->shape.count ||
            piece->is_lit != wanted->lit) {
            tally->mismatched++;
            continue;
        }
        const double found = lit_difference(outline, &wanted->shape);
        stages_count(tally, found, found <= 0);
    }
}

/* Mostly integers times a step: then vertices and edges often lie in planes. */
static fxl_point any_point(stages_random *random, int32_t step, int32_t top)
{
    fxl_point point = {((int32_t)stages_random_below(random, 13) - 6) * step,
                       ((int32_t)stages_random_below(random, 13) - 6) * step,
                       (top - (int32_t)stages_random_below(random, 4)) * step};
    return point;
}

void stages_measure_light(stages_tally *tally, stages_random *random)
{
    static fxl_point points[CORNERS];
    static uint16_t next[CORNERS];
    static fxl_lit_piece table[PIECES];
    static ref_lit_pieces exact;
    fxl_lit_pieces made = {points, next, table, CORNERS, PIECES, 0, 0};
    const int32_t step = stages_random_below(random, 2) ? 65536 : 65536 * 31 + 12345;
    const uint32_t count = 1 + stages_random_below(random, BEAMS);
    fxl_beam beams[BEAMS];
    ref_beam exact_beams[BEAMS];
    for (uint32_t b = 0; b < count; b++) {
        const fxl_point light = any_point(random, step, 12);
        const fxl_point window[] = {any_point(random, step, 6), any_point(random, step, 6),
                                    any_point(random, step, 6)};
        if (fxl_beam_from_point(&light, window, 3, &beams[b]) != FXL_OK) {
            return;
        }
        exact_beams[b] = beam_of(&beams[b]);
    }
    const fxl_point face[] = {any_point(random, step, 0), any_point(random, step, 0),
                              any_point(random, step, 0)};
    const fxl_direction normal = {0, 0,
                                  stages_random_below(random, 2) ? FXL_Q2_30_ONE : -FXL_Q2_30_ONE};
    const int32_t exact_normal[] = {normal.x, normal.y, normal.z};
    const ref_scene scene = {.beams = exact_beams, .beam_count = count};
    ref_piece whole = {.count = 3};
    for (int i = 0; i < 3; i++) {
        whole.points[i] = (ref_lattice_point){face[i].x, face[i].y, face[i].z};
    }
    const bool split = fxl_lit_split(&made, beams, count, &normal, face, 3);
    if (split != ref_beam_light_split(&scene, &whole, exact_normal, &exact) || !split) {
        tally->mismatched++;
        return;
    }
    compare_lit(tally, &made, &exact);
}
