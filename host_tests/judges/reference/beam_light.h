/* SPDX-License-Identifier: MIT */
/* Light beams (docs/extras/beams.md), in double. Points are integers, as the specification says. */
#ifndef REF_BEAM_LIGHT_H
#define REF_BEAM_LIGHT_H

#include "reference/scene.h"
#include "reference/split.h"

enum {
    REF_LIT_PIECES_MAX = 256
};

typedef struct {
    ref_piece shape;
    bool lit;
} ref_lit_piece;

typedef struct {
    int count;
    ref_lit_piece pieces[REF_LIT_PIECES_MAX];
} ref_lit_pieces;

/* Tells whether any part of a sphere may lie in a beam of the scene. */
bool ref_beam_light_reaches(const ref_scene *scene, const ref_lattice_point *centre,
                            int32_t radius);

/* Splits a polygon of the world, with this normal (2.30), by the beams of the scene. Returns
 * false where there would be more pieces, or larger ones, than the records hold. */
bool ref_beam_light_split(const ref_scene *scene, const ref_piece *polygon, const int32_t *normal,
                          ref_lit_pieces *to);

#endif
