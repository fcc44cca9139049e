/* SPDX-License-Identifier: MIT */
#include "paint/lit_pieces.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_lit_pieces_needed"
 * property = "any checked beams: at most 9^4 pieces"
 * checks = 17
 */
void prove_lit_pieces_needed(void)
{
    fxl_beam beams[FXL_BEAMS_MAX];
    const uint32_t count = nondet_u32();
    ASSUME(count <= FXL_BEAMS_MAX);
    for (uint32_t i = 0; i < FXL_BEAMS_MAX; i++) {
        ASSUME(beams[i].plane_count >= 1 && beams[i].plane_count <= FXL_BEAM_PLANES_MAX);
    }
    const uint32_t pieces = fxl_lit_pieces_needed(beams, count);
    ASSERT("at most 9^4", pieces >= 1 && pieces <= 6561);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_lit_corners_needed"
 * property = "any checked beams that fit a triangle: it ends, nothing is out of bounds, and there are enough for each face that they fit"
 * checks = 32
 * unwind = 33
 * links = ["lib/scene/beam.c"]
 */
void prove_lit_corners_needed(void)
{
    fxl_beam beams[FXL_BEAMS_MAX];
    const uint32_t count = nondet_u32(), vertices = nondet_u32();
    ASSUME(count <= FXL_BEAMS_MAX);
    for (uint32_t i = 0; i < FXL_BEAMS_MAX; i++) {
        ASSUME(beams[i].plane_count >= 1 && beams[i].plane_count <= FXL_BEAM_PLANES_MAX);
    }
    ASSUME(vertices >= 3 && vertices <= FXL_FACE_VERTICES_MAX && fxl_beams_fit(beams, count, vertices));
    const uint32_t cuts = fxl_lit_pieces_needed(beams, count) - 1;
    ASSERT("enough for each face", fxl_lit_corners_needed(beams, count) >= vertices + CORNERS_ON_PLANES + CORNERS_A_CUT * cuts);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_lit_outline"
 * property = "any piece of a table of 8 corners, whatever its count: nothing is out of bounds"
 * checks = 72
 * unwind = 33
 */
void prove_lit_outline(void)
{
    fxl_point table[8], points[FXL_POLYGON_CAPACITY];
    uint16_t next[8];
    fxl_lit_pieces pieces;
    fxl_lit_piece piece;
    pieces.points = table;
    pieces.next = next;
    ASSUME(piece.last < 8);
    for (uint32_t i = 0; i < 8; i++) {
        ASSUME(next[i] < 8);
    }
    const bool fits = fxl_lit_outline(&pieces, &piece, points);
    ASSERT("refused only above the capacity", fits == (piece.count <= FXL_POLYGON_CAPACITY));
    PROOF_ENDS();
}
