/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "proof.h"

/* For memcpy: both objects have so many bytes. */
static void *any_copy(void *to, const void *from, size_t size)
{
    ASSERT("it reads and writes within", __CPROVER_w_ok(to, size) && __CPROVER_r_ok(from, size));
    return to;
}

/* For the compiler's own, of which the prover knows neither. */
static void *copy_words(void *to, const void *from, size_t size)
{
    for (size_t i = 0; i < size / sizeof(uint32_t); i++) {
        ((uint32_t *)to)[i] = ((const uint32_t *)from)[i];
    }
    return to;
}

#define memcpy                           any_copy
#define __builtin_memcpy                 copy_words
#define __builtin_assume_aligned(to, by) (to)
#include "draw/surface_polygon.c"
#undef memcpy

#define WORDS  128 /* of a list: more than the largest record has */
#define POINTS 8

/* [[row]]
 * function = "fxl_surface_polygon_append"
 * property = "any list of up to 128 words, any polygon: nothing is written beyond the capacity"
 * checks = 296
 * stubs = { memcpy = "asserts that both objects have so many bytes", __builtin_memcpy = "copies words" }
 * unwind = 8
 */
void prove_surface_polygon_append(void)
{
    uint32_t words[WORDS];
    fxl_display_list list;
    fxl_screen_polygon screen;
    fxl_surface_polygon polygon;
    fxl_rows rows;
    list.words = words;
    ASSUME(list.capacity <= WORDS && list.used <= list.capacity && rows.first < rows.end);
    ASSUME(screen.count >= 3 && screen.count <= FXL_POLYGON_CAPACITY && polygon.gradients.count <= FXL_ATTRIBUTES);
    const uint32_t used = list.used;
    const bool appended = fxl_surface_polygon_append(&list, &screen, rows, &polygon);
    ASSERT("within the capacity", list.used <= list.capacity && (appended ? list.used > used : list.used == used));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_surface_polygon_read"
 * property = "any record of up to 8 points: nothing is read beyond its longest form"
 * checks = 152
 * stubs = { __builtin_memcpy = "copies words" }
 * unwind = 8
 */
void prove_surface_polygon_read(void)
{
    struct {
        uint32_t head;
        uint32_t words[2 * POINTS + FIRST_WORDS + SURFACE_WORDS + UNIT_WORDS + GRADIENT_WORDS * (2 + FXL_ATTRIBUTES)];
    } record;
    fxl_surface_polygon polygon;
    const fxl_screen_polygon *screen = (const fxl_screen_polygon *)(const void *)&record;
    ASSUME(fxl_surface_polygon_points(screen) <= POINTS);
    const uint32_t count = fxl_surface_polygon_read(screen, &polygon);
    ASSERT("the record's points", count == fxl_surface_polygon_points(screen));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/surface_polygon.h:fxl_corners_are_on_screen"
 * property = "exactly where no corner is beside the screen, for all lenses, and nothing overflows"
 * checks = 49
 * unwind = 4
 */
void prove_corners_are_on_screen(void)
{
    fxl_screen_corners corners;
    fxl_lens lens;
    ASSUME(lens.width >= 1 && lens.width <= FXL_SCREEN_MAX && lens.height >= 1 && lens.height <= FXL_SCREEN_MAX);
    const uint32_t i = nondet_u32();
    ASSUME(i < 3);
    const fxl_screen_point point = corners.points[i];
    const bool is_on = point.x >= 0 && point.y >= 0 && point.x <= lens.width << 16 && point.y <= lens.height << 16;
    corners.points[0] = corners.points[1] = corners.points[2];
    corners.points[i] = point;
    const fxl_screen_point other = corners.points[(i + 1) % 3];
    const bool others = other.x >= 0 && other.y >= 0 && other.x <= lens.width << 16 && other.y <= lens.height << 16;
    ASSERT("all or not", fxl_corners_are_on_screen(&corners, &lens) == (is_on && others));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/surface_polygon.h:fxl_surface_is_blended"
 * property = "exactly where it blends or adds, for all flags"
 * checks = 7
 */
void prove_surface_is_blended(void)
{
    fxl_surface surface;
    surface.flags = nondet_u8();
    const bool mixes = (surface.flags & FXL_SURFACE_BLEND) != 0 || (surface.flags & FXL_SURFACE_ADD) != 0;
    ASSERT("blends or adds", fxl_surface_is_blended(&surface) == mixes);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/surface_polygon.h:fxl_is_of_other_pass"
 * property = "of two passes exactly one has a surface, and where there is one pass it has all, for all flags"
 * checks = 15
 */
void prove_is_of_other_pass(void)
{
    fxl_depth_head opaque, blended, all;
    fxl_surface surface;
    surface.flags = nondet_u8();
    opaque.pass = FXL_DEPTH_OPAQUE;
    blended.pass = FXL_DEPTH_BLENDED;
    all.pass = FXL_DEPTH_ALL;
    ASSERT("opaque ones first", fxl_is_of_other_pass(&opaque, &surface) == fxl_surface_is_blended(&surface));
    ASSERT("then the others", fxl_is_of_other_pass(&blended, &surface) != fxl_surface_is_blended(&surface));
    ASSERT("all at once", !fxl_is_of_other_pass(&all, &surface));
    PROOF_ENDS();
}
