/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "../../lib/paint/lit_pieces.h"
#include "reference/beam_light.h"
#include "stages/bridge.h"
#include "stages/measure.h"

enum {
    CORNERS = 512,
    PIECES = 128,
    BEAMS = 2
};

stages_tally stages_light_tally(const char *input)
{
    return (stages_tally){
        .stage = "light",
        .input = input,
        .unit = "1/65536 world unit",
        .measure = "faces split by beams: largest coordinate difference of a vertex of a piece "
                   "from the reference's, both given the same face and beams; another number of "
                   "pieces or vertices, or one that is lit in one of both alone, is a mismatch",
        .bound = "0",
    };
}

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
static double difference(const fxl_point *points, const ref_piece *piece)
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

static void compare(stages_tally *tally, const fxl_lit_pieces *made, const ref_lit_pieces *exact)
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
        const double found = difference(outline, &wanted->shape);
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
    compare(tally, &made, &exact);
}
