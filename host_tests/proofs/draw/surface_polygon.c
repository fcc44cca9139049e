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
 * checks = 292
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
 * checks = 148
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
