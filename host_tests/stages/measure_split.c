/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "reference/split.h"
#include "stages/bridge.h"
#include "stages/measure.h"

enum {
    FROM_PLANE
};

_Static_assert((int)FXL_SPLIT_FRONT == (int)REF_SPLIT_FRONT &&
                   (int)FXL_SPLIT_BACK == (int)REF_SPLIT_BACK &&
                   (int)FXL_SPLIT_BOTH == (int)REF_SPLIT_BOTH &&
                   (int)FXL_SPLIT_CAPACITY == (int)REF_SPLIT_CAPACITY,
               "outcomes of splitting");

stages_tally stages_split_tally(const char *input)
{
    return (stages_tally){
        .stage = "split",
        .input = input,
        .unit = "1/65536 world unit",
        .measure =
            "splitting in the world: largest coordinate difference of a point of either "
            "part from the reference's, both given the same piece and plane; max_from_plane is "
            "the largest distance of a new point from the exact plane",
        .bound = "0; 0.87 from the plane",
        .extra_names = {"max_from_plane"},
    };
}

static ref_piece piece_of(const fxl_piece *piece)
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
                    const fxl_piece *fixed, const ref_piece *exact)
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

void stages_measure_split(stages_tally *tally, const fxl_plane *plane, const fxl_piece *piece)
{
    fxl_piece front, back;
    ref_piece exact_front, exact_back;
    const ref_piece in = piece_of(piece);
    const ref_plane exact_plane = bridge_plane(plane);
    fxl_split_result result = fxl_split_piece(piece, plane, &front, &back);
    ref_split_result exact_result = ref_split_piece(&in, &exact_plane, &exact_front, &exact_back);
    tally->mismatched += (int)result != (int)exact_result;
    if (result == FXL_SPLIT_BOTH && exact_result == REF_SPLIT_BOTH) {
        compare(tally, &in, &exact_plane, &front, &exact_front);
        compare(tally, &in, &exact_plane, &back, &exact_back);
    }
}
