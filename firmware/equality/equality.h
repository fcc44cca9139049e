/* SPDX-License-Identifier: MIT */
/* Compares the kernels of a core with the portable ones, on that core. */
#ifndef EQUALITY_H
#define EQUALITY_H

#include <stdbool.h>
#include <stdint.h>

#include "draw/stages.h"

/* A kernel's test: all its boundary inputs, then `rounds` random ones. */
typedef struct {
    const char *name;
    void (*run)(uint32_t rounds);
} equality_test;

/* The list ends with a name that is null. */
extern const equality_test equality_tests[];

/* All tests in their order, and of which library: the one of -DFXL_SMALL, the other one, BOTH, one that
 * has outlines with depth, or one that has kernels of smooth outlines. */
#define EQUALITY_TESTS(TEST) \
    TEST("multiply", test_products, LARGE)                      \
    TEST("multiply-short", test_short_products, LARGE)          \
    TEST("multiply-wide", test_wide_products, LARGE)            \
    TEST("multiply-high", test_high_products, SMALL)            \
    TEST("leading-zeros", test_leading_zeros, LARGE)            \
    TEST("divide", test_divide, LARGE)                          \
    TEST("divide-half", test_divide_half, LARGE)                \
    TEST("divide-wide", test_divide_wide, BOTH)                 \
    TEST("fraction", test_fraction, BOTH)                       \
    TEST("edge-divide", test_edge_divide, LARGE)                \
    TEST("look-at", test_look_at, BOTH)                         \
    TEST("project", test_project, BOTH)                         \
    TEST("order", test_order, SMALL)                            \
    TEST("outlines", test_outlines, SMALL)                      \
    TEST("facing", test_facing, LARGE)                          \
    TEST("sphere", test_sphere, LARGE)                          \
    TEST("front-faces", test_front_faces, LARGE)                \
    TEST("clip-by-view", test_clip_by_view, LARGE)              \
    TEST("intersect", test_intersect, LARGE)                    \
    TEST("placement-rows", test_placement_rows, LARGE)          \
    TEST("chains", test_chains, LARGE)                          \
    TEST("fill", test_fill, BOTH)                               \
    TEST("fill-rgb565", test_fill_rgb565, BOTH)                 \
    TEST("draw-outline", test_draw_outline, BOTH)               \
    TEST("draw-outline-rgb565", test_draw_outline_rgb565, BOTH) \
    TEST("row-to-16", test_row_to_16, BOTH)                     \
    TEST("texture-rows", test_texture_rows, LARGE)              \
    TEST("divided-rows", test_divided_rows, LARGE)              \
    TEST("colour-runs", test_colour_runs, LARGE)                \
    TEST("lit-texels", test_lit_texels, LARGE)                  \
    TEST("light-corners", test_light_corners, LARGE)            \
    TEST("depth-planes", test_depth_planes, LARGE)              \
    TEST("depth-rows", test_depth_rows, LARGE)                  \
    TEST("depth-outlines", test_depth_outlines, OUTLINES)       \
    TEST("depth-faces", test_depth_faces, SMOOTH)               \
    TEST("smooth-outlines", test_smooth_outlines, SMOOTH)       \
    TEST("smooth-words", test_smooth_words, WORDS)              \
    TEST("colour-outlines", test_colour_outlines, SMOOTH)       \
    TEST("texel-outlines", test_texel_outlines, SMOOTH)         \
    TEST("smooth-planes", test_smooth_planes, SMOOTH)           \
    TEST("colour-planes", test_colour_planes, SMOOTH)           \
    TEST("depth-runs", test_depth_runs, SMOOTH)

#define EQUALITY_TEST(name, test, library) void test(uint32_t rounds);
EQUALITY_TESTS(EQUALITY_TEST)
#undef EQUALITY_TEST

/* Counts one input, and whether both sides gave the same result. */
void equality_case(bool same);

/* Returns whether two memories of whole words hold the same. */
bool equality_same_words(const void *a, const void *b, uint32_t bytes);

/* Returns the number of inputs in this test. */
uint32_t equality_cases(void);

/* Begins the random inputs of a shard, which no other has. */
void any_of_shard(uint32_t shard);

/* Returns random bits; the same in every run of a shard. */
uint32_t any_32(void);
uint64_t any_64(void);

/* Returns a number of 0 to 64 bits; every length is equally likely. */
uint64_t any_length(void);

/* Takes the inset from a quarter of the lenses, and moves their centre anywhere in its range. */
void any_centre(fxl_lens *lens);

/* Returns number i of BOUNDARY_32_COUNT near powers of two, where kernels tend to fail. */
uint32_t boundary_32(uint32_t i);
#define BOUNDARY_32_COUNT (3u * 32u + 1u)

#endif
