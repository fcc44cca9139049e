/* SPDX-License-Identifier: MIT */
/* A face split by beams: pieces that share their vertices' bits along every edge between
 * two of them. Not part of the public interface. */
#ifndef FXL_LIT_PIECES_H
#define FXL_LIT_PIECES_H

#include "fixel/extra/beams/beam.h"

typedef struct {
    uint16_t last; /* the corner before the first */
    uint16_t count;
    bool is_lit;
} fxl_lit_piece;

/* In memory of the caller's. */
typedef struct {
    fxl_point *points; /* of the corners */
    uint16_t *next;    /* of each corner, round its piece */
    fxl_lit_piece *pieces;
    uint32_t corner_capacity, piece_capacity;
    uint32_t corner_count, piece_count;
} fxl_lit_pieces;

/* Corners and pieces that one face may need that fits (fxl_beams_fit). Requires beams that fit
 * with a face of some vertices. */
uint32_t fxl_lit_corners_needed(const fxl_beam *beams, uint32_t beam_count);
uint32_t fxl_lit_pieces_needed(const fxl_beam *beams, uint32_t beam_count);

/* Splits a polygon of the world by each beam in turn. is_lit says whether light reaches a
 * piece that lies in a beam. False where there is no room: rounding alone, which makes
 * outlines slightly concave, can bring that about where there is as much as needed. */
bool fxl_lit_split(fxl_lit_pieces *to, const fxl_beam *beams, uint32_t beam_count,
                   const fxl_direction *normal, const fxl_point *points, uint32_t count);

/* The corners of a piece in turn, at most FXL_POLYGON_CAPACITY of them; false where it has
 * more. */
bool fxl_lit_outline(const fxl_lit_pieces *of, const fxl_lit_piece *piece, fxl_point *points);

#endif
