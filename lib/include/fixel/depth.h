/* SPDX-License-Identifier: MIT */
/* A depth buffer: at each pixel the nearest face is seen. docs/extras/depth.md; SPEC.md,
 * section 10.
 */
#ifndef FXL_DEPTH_H
#define FXL_DEPTH_H

#include "fixel/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes of a depth buffer for so many rows of so many pixels, of 16 or 32 bits each, and for what
 * the buffer keeps beside them. */
#define FXL_DEPTH_BYTES(width, rows, bits) \
    (8u + (((uint32_t)(width) * (uint32_t)(rows) * ((bits) / 8u) + 7u) & ~7u))

/* The depth of a renderer, which the caller owns. Members are internal. */
typedef struct {
    fxl_shader shader;
} fxl_depth;

/* The depth d of a pixel is near_z / z, a number from near_z / far_z to 1. The buffer keeps it as a
 * number with as many bits after its highest 1 as there is room for, so its resolution is relative
 * to the distance z: with e the least whole number for which 257/256 far_z <= 2^e near_z, and m the
 * largest for which e 2^m < 65536, two faces whose distances at a pixel differ by more than
 * (1 + 1/32) 2^-m of the distance are told apart; and 32 bits tell faces apart at 2^-(m + 5) of
 * it. To that comes what a face's plane is off: 2^-28 of its size and FXL_PLANARITY_MAX. Where two
 * faces are not told apart, either may be seen; where both have the same code, it is that which
 * fxl_visibility_sorted draws later. */
extern const fxl_visibility fxl_visibility_depth;    /* 16 bits a pixel */
extern const fxl_visibility fxl_visibility_depth_32; /* 32 bits a pixel */

/* Has a renderer draw each face with a depth buffer: method is fxl_visibility_depth or
 * fxl_visibility_depth_32, memory is the buffer's: at least FXL_DEPTH_BYTES of one row, aligned to
 * 8. Bands that it has no room for are drawn in parts, each of which counts in split_bands; the
 * pixels are the same. The renderer keeps both pointers. Any scene is drawn: faces of one colour,
 * lit ones, turned ones, pieces of light beams; and faces with surfaces, if these were set
 * before. Not with a BSP tree, which is a method of its own; billboards come after it
 * (fxl_renderer_set_billboards_by_depth). The depth ends where another visibility method is set. A
 * frame must begin anew. In memory of its own (fxl_workspace_init) each core may draw another band.
 * FXL_E_ARGUMENT: a null pointer; also another method.
 * FXL_E_ALIGNMENT: a pointer is not aligned.
 * FXL_E_ORDER: the renderer was never initialised.
 * FXL_E_CAPACITY: size is too small.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_renderer_set_depth(fxl_renderer *renderer, fxl_depth *depth,
                                  const fxl_visibility *method, void *memory, uint32_t size);

#ifdef __cplusplus
}
#endif

#endif
