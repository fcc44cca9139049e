/* SPDX-License-Identifier: MIT */
/* Polygons of the world split by planes: by one, and by those of a BSP. */
#ifndef REF_SPLIT_H
#define REF_SPLIT_H

#include "reference/scene.h"

/* Splitting polygons of the world by planes (docs/extras/clippers.md, section 9), in double. */

typedef struct {
    int count;
    ref_lattice_point points[REF_POLYGON_CAPACITY];
} ref_piece;

typedef enum {
    REF_SPLIT_FRONT,   /* nothing is behind the plane */
    REF_SPLIT_BACK,    /* nothing is in front, something is behind */
    REF_SPLIT_BOTH,    /* front and back hold the parts */
    REF_SPLIT_CAPACITY /* a part has more than REF_POLYGON_CAPACITY points: refused */
} ref_split_result;

/* Returns the point of the edge where the distance is 0, in units of 1/65536: rounded to the
 * nearest, halves away from the end in front. */
ref_lattice_point ref_split_edge(const ref_lattice_point *front, const ref_lattice_point *behind,
                                 long double front_distance, long double behind_distance);

/* Returns how far a point lies in front of a plane. Exact where the plane is the library's
 * integers. */
long double ref_split_distance(const ref_plane *plane, const ref_lattice_point *point);

ref_split_result ref_split_piece(const ref_piece *in, const ref_plane *plane, ref_piece *front,
                                 ref_piece *back);

/* Inserts a point into every edge of a piece between two ends, in either direction. Returns false
 * where the piece would have more than `most` points; it may then have got some. */
bool ref_piece_insert(ref_piece *piece, const ref_lattice_point ends[2],
                      const ref_lattice_point *point, int most);

/* The BSP (docs/extras/bsp.md), exact in 128 bits, and instances that are cut to its leaves. */

bool ref_bsp_is_front(const ref_scene *scene, const ref_bsp_node *node,
                      const ref_lattice_point *point);

/* A piece of a face: at a node, or in the leaf on one side of a node. */
typedef struct {
    uint32_t instance, face, node;
    bool in_leaf, behind;
    ref_piece shape;
} ref_bsp_piece;

typedef struct {
    ref_bsp_piece *pieces;
    size_t count, capacity;
} ref_bsp_pieces;

typedef enum {
    REF_BSP_CUT,
    REF_BSP_WHOLE, /* a piece would have more vertices than a face may have: no piece is kept */
    REF_BSP_MEMORY /* memory is short */
} ref_bsp_result;

/* Appends a piece. Returns false where memory is short. */
bool ref_bsp_append(ref_bsp_pieces *to, const ref_bsp_piece *piece);

/* Appends an instance's faces that face the eye as pieces at the root. Returns false where
 * memory is short. */
bool ref_bsp_faces(const ref_scene *scene, uint32_t instance, const ref_lattice_point *eye,
                   ref_bsp_pieces *pieces);

/* Appends the pieces of those faces of an instance that face the eye, each in its leaf. */
ref_bsp_result ref_bsp_cut(const ref_scene *scene, uint32_t instance, const ref_lattice_point *eye,
                           ref_bsp_pieces *pieces);

#endif
