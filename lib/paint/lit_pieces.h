/* SPDX-License-Identifier: MIT */
/* A face split by beams into pieces. Two pieces that share an edge have the same vertices, bit
 * for bit, along it. Not part of the public interface. */
#ifndef FXL_LIT_PIECES_H
#define FXL_LIT_PIECES_H

#include "fixel/scene.h"

typedef struct {
    uint16_t last; /* the last corner; the first one follows it */
    uint16_t count;
    bool is_lit;
} fxl_lit_piece;

/* The pieces of a face. The tables lie in memory of the caller. */
typedef struct {
    fxl_point *points; /* point of each corner */
    uint16_t *next;    /* the next corner around the piece */
    fxl_lit_piece *pieces;
    uint32_t corner_capacity, piece_capacity;
    uint32_t corner_count, piece_count;
} fxl_lit_pieces;

/* Return how many corners and pieces suffice for one face that fits (fxl_beams_fit). Require
 * beams that fit a face of 3 vertices. */
uint32_t fxl_lit_corners_needed(const fxl_beam *beams, uint32_t beam_count);
uint32_t fxl_lit_pieces_needed(const fxl_beam *beams, uint32_t beam_count);

/* Splits a polygon of the world by each beam in turn. is_lit of a piece says that it lies in a
 * beam whose light reaches its face. Returns false where memory is short. With as much memory as
 * needed, only rounding can cause that: it makes outlines slightly concave. */
bool fxl_lit_split(fxl_lit_pieces *to, const fxl_beam *beams, uint32_t beam_count,
                   const fxl_direction *normal, const fxl_point *points, uint32_t count);

/* Copies the corners of a piece, in order, to points: at most FXL_POLYGON_CAPACITY. Returns
 * false where it has more. */
bool fxl_lit_outline(const fxl_lit_pieces *of, const fxl_lit_piece *piece, fxl_point *points);

#endif
