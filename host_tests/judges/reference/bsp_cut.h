/* SPDX-License-Identifier: MIT */
/* The BSP (docs/extras/bsp.md), exact in 128 bits, and instances that are cut to its leaves. */
#ifndef REF_BSP_CUT_H
#define REF_BSP_CUT_H

#include "reference/split.h"
#include "reference/scene.h"

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
