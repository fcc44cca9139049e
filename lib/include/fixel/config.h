/* SPDX-License-Identifier: MIT */
/* The settings of the build. Each is a macro that the build may define, as in
 * -DFXL_SMALL. None changes a pixel.
 *
 *   FXL_SMALL             defined or not: few bytes of code instead of few instructions
 *   FXL_COMPACT           0 or 1: without what saves few instructions for its bytes; default: 1
 *                         if the compiler makes few bytes (-Os, -Oz), else 0
 *   FXL_POLYGON_CAPACITY  a number, 12..32: the most vertices of a polygon; default 32
 *   FXL_PORTABLE_KERNELS  defined or not: kernels in plain C on every core
 *   FXL_WITHOUT_ASSEMBLY  defined or not: no kernel of a file in assembly; those in place stay
 *   FXL_ASSERT_HOOK       defined or not, for tests: assertions call fxl_assert_failed, which
 *                         the program must define (lib/math/arith.h)
 */
#ifndef FXL_CONFIG_H
#define FXL_CONFIG_H

/* With FXL_SMALL the library omits the second, faster algorithms: all outlines are scanned by
 * active edges, all vertices are projected by a long division, and so on. It takes no kernel in
 * assembly (lib/math/family.h). On a Cortex-M3 with -Os a renderer then takes half of the bytes
 * that it takes with -O2, and 2.7 to 4.4 times the instructions. All results are the same. This
 * is a setting of the library alone: the records are the same, so a program that uses the library
 * need not define it. */
#ifdef FXL_SMALL
#define FXL_IS_SMALL 1
#else
#define FXL_IS_SMALL 0
#endif

/* A compact library, as one that the compiler makes for size (-Os), omits what saves few
 * instructions for its bytes. It keeps the algorithms that are several times faster. A flat frame
 * takes 1.2 times the instructions of -O2, one with textures on an Armv7-M 2.3 to 3.1 times: it
 * paints these in C. There it also scans them by active edges, which takes 2 to 5 % more of a
 * crate's frame. C and assembly read this one switch, and must read it alike: a build that gives
 * its -O to C alone must give both -DFXL_COMPACT=0 or -DFXL_COMPACT=1 (lib/math/family.h refuses
 * assembly that cannot know). */
#if defined FXL_SMALL
#define FXL_IS_COMPACT 1
#elif defined FXL_COMPACT
#define FXL_IS_COMPACT FXL_COMPACT
#elif defined __OPTIMIZE_SIZE__
#define FXL_IS_COMPACT 1
#else
#define FXL_IS_COMPACT 0
#endif

/* The most vertices of a polygon anywhere in the pipeline. It determines the size of a
 * renderer (render.h) and which faces it draws. The library and the program must be
 * built with the same value. If they are not, the linker does not find
 * fxl_renderer_init_with, because its symbol ends in this number. So the value must
 * consist of digits only. */
#ifndef FXL_POLYGON_CAPACITY
#define FXL_POLYGON_CAPACITY 32
#endif

#if FXL_POLYGON_CAPACITY < 12
#error "FXL_POLYGON_CAPACITY is below 12: faces of four vertices, clipped, must fit"
#elif FXL_POLYGON_CAPACITY > 32
#error "FXL_POLYGON_CAPACITY is above 32: faces have 24 vertices at most"
#endif

#endif
