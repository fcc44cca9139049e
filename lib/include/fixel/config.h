/* SPDX-License-Identifier: MIT */
/* The settings of the build. Each is a macro that the build may define, as in
 * -DFXL_SMALL; none changes a pixel.
 *
 *   FXL_SMALL             few bytes of code instead of few instructions: defined or not
 *   FXL_POLYGON_CAPACITY  vertices of a polygon: a number, 12..32, 32 where it is not set
 *   FXL_ASSERT_HOOK       assertions call fxl_assert_failed, which the program then has:
 *                         for tests; defined or not (lib/src/arith.h)
 */
#ifndef FXL_CONFIG_H
#define FXL_CONFIG_H

/* With FXL_SMALL the library leaves out each second, quicker way to a result: outlines are
 * scanned by their crossings alone, vertices are projected by a long division alone, and so
 * on. No kernel in assembly is taken (lib/lib.mk). On a Cortex-M3 with -Os a renderer then
 * takes half of the bytes that it takes with -O2, and four to ten times the instructions. The
 * bits are the same. It is a setting of the library alone: records are the same, and a program that
 * uses the library need not define it. */
#ifdef FXL_SMALL
#define FXL_IS_SMALL 1
#else
#define FXL_IS_SMALL 0
#endif

/* Vertices of a polygon anywhere in the pipeline. It decides how large a renderer is
 * (render.h) and which faces it draws. The library and what uses it must be
 * built with the same: where they are not, fxl_renderer_init is not found by
 * the linker, for its symbol ends in this number. Nothing but digits, therefore. */
#ifndef FXL_POLYGON_CAPACITY
#define FXL_POLYGON_CAPACITY 32
#endif

_Static_assert(FXL_POLYGON_CAPACITY >= 12, "faces of four vertices, clipped, must fit");
_Static_assert(FXL_POLYGON_CAPACITY <= 32, "SPEC.md, chapter 3: faces have 24 vertices at most");

#endif
