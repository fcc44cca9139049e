/* SPDX-License-Identifier: MIT */
#include "kernels.h"

#include "math/arith.h"
#include "raster/edge_divide.h"

#define EACH(i) for (uint32_t i = 0; i < KERNEL_COUNT; i++)

/* Results are stored here, so no compiler removes the work. */
static union {
    uint64_t wide[KERNEL_COUNT];
    int64_t quotients[KERNEL_COUNT];
    fxl_q2_30 sines[KERNEL_COUNT];
    uint32_t codes[KERNEL_COUNT];
    fxl_view_point seen[KERNEL_COUNT];
    fxl_screen_point screen[KERNEL_COUNT];
    fxl_view_frustum frustums[KERNEL_COUNT];
    fxl_cached_vertex vertices[KERNEL_COUNT];
    struct {
        int32_t whole;
        uint32_t fraction;
    } divided[KERNEL_COUNT];
    struct {
        fxl_view_polygon out;
        fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
    } clip;
    fxl_scan scan;
} results;

static FXL_ALIGN_8 uint8_t pixels[KERNEL_COUNT * 320u];
static const fxl_band rows = {
    .pixels = pixels, .width = 320, .stride = 320, .first_row = 0, .rows = KERNEL_COUNT};
static const fxl_band screen = {.pixels = pixels,
                                .width = 320,
                                .stride = 320,
                                .first_row = 0,
                                .rows = 240}; /* scanned, never filled */

static __attribute__((noinline)) void nothing(const fxl_point *point, fxl_view_point *seen)
{
    __asm__ volatile("" ::"r"(point), "r"(seen));
}

static void call(const kernel_inputs *in)
{
    EACH(i)
    {
        nothing(&in->points[i], &results.seen[i]);
    }
}

static void multiply(const kernel_inputs *in)
{
    EACH(i)
    {
        results.wide[i] = fxl_multiply_high(in->wide[i], in->wide[i ^ 1u]);
    }
}

static void divide(const kernel_inputs *in)
{
    EACH(i)
    {
        results.quotients[i] = fxl_divide_round(in->numerators[i], (uint32_t)in->depths[i]);
    }
}

/* An edge's height, and a number that it divides. */
static void reciprocal(const kernel_inputs *in)
{
    EACH(i)
    {
        fxl_edge_divider divider = fxl_edge_divider_of(in->heights[i]);
        fxl_edge_divide(&divider, in->dividends[i], &results.divided[i].whole,
                        &results.divided[i].fraction);
    }
}

static void sine(const kernel_inputs *in)
{
    EACH(i)
    {
        results.sines[i] = fxl_sin(in->angles[i]);
    }
}

/* Two roots each. */
static void root(const kernel_inputs *in)
{
    EACH(i)
    {
        fxl_view_frustum_from_lens(&in->view.lens, &results.frustums[i]);
    }
}

static void transform(const kernel_inputs *in)
{
    EACH(i)
    {
        fxl_transform_point(&in->view.camera, &in->points[i], &results.seen[i]);
    }
}

/* Which of the six planes a vertex lies outside of. */
static void outcode(const kernel_inputs *in)
{
    EACH(i)
    {
        results.codes[i] = fxl_outcode(&in->view.view_frustum, FXL_PLANES_ALL, &in->seen[i]);
    }
}

/* Transforms a vertex of an instance into the cache: all that clip and project need. */
static void transform_outcode(const kernel_inputs *in)
{
    EACH(i)
    {
        fxl_transform_vertex(&in->placed, i, &results.vertices[i]);
    }
}

static void project(const kernel_inputs *in)
{
    EACH(i)
    {
        fxl_project_inside(&in->view.projection, &in->seen[i], &results.screen[i]);
    }
}

/* A quad and a plane that cuts two of its edges. */
static void clip(const kernel_inputs *in)
{
    EACH(i)
    {
        fxl_clip_view_to_plane(&in->across[i], &in->view.view_frustum, FXL_PLANE_LEFT,
                               &results.clip.out, results.clip.distances);
    }
}

/* A quad and a plane that it lies inside of. */
static void clip_inside(const kernel_inputs *in)
{
    EACH(i)
    {
        fxl_clip_view_to_plane(&in->inside[i], &in->view.view_frustum, FXL_PLANE_LEFT,
                               &results.clip.out, results.clip.distances);
    }
}

static void edge(const kernel_inputs *in)
{
    EACH(i)
    {
        fxl_scan_begin(&in->quads[i], &screen, &results.scan);
    }
}

/* Spans of one length, at the eight alignments of the beginning of a row. */
#define SPAN(length) \
    static void span_##length(const kernel_inputs *in) \
    { \
        (void)in; \
        EACH(i) \
        { \
            int16_t x = (int16_t)(length == 320 ? 0 : i & 7u); \
            fxl_span span = {(int16_t)i, x, (int16_t)(x + length)}; \
            fxl_fill_span(&rows, &span, 1); \
        } \
    }
SPAN(1)
SPAN(2)
SPAN(4)
SPAN(8)
SPAN(16)
SPAN(32)
SPAN(64)
SPAN(128)
SPAN(320)

/* A row of pixels to colours. */
static void to_16(const uint8_t *row)
{
    static const uint16_t table[FXL_PALETTE_COLOURS];
    EACH(i)
    {
        fxl_row_to_16(row, KERNEL_ROW, table, (uint16_t *)(void *)pixels);
    }
}

static void rgb565_noise(const kernel_inputs *in)
{
    to_16(in->noise);
}

static void rgb565_run(const kernel_inputs *in)
{
    to_16(in->run);
}

const bench_kernel kernel_list[] = {
    {"call", call, KERNEL_COUNT},
    {"multiply", multiply, KERNEL_COUNT},
    {"divide", divide, KERNEL_COUNT},
    {"reciprocal", reciprocal, KERNEL_COUNT},
    {"sine", sine, KERNEL_COUNT},
    {"root", root, 2u * KERNEL_COUNT},
    {"transform", transform, KERNEL_COUNT},
    {"outcode", outcode, KERNEL_COUNT},
    {"transform-outcode", transform_outcode, KERNEL_COUNT},
    {"project", project, KERNEL_COUNT},
    {"clip", clip, KERNEL_COUNT},
    {"clip-inside", clip_inside, KERNEL_COUNT},
    {"edge-setup", edge, 4u * KERNEL_COUNT},
    {"span-1", span_1, KERNEL_COUNT},
    {"span-2", span_2, KERNEL_COUNT},
    {"span-4", span_4, KERNEL_COUNT},
    {"span-8", span_8, KERNEL_COUNT},
    {"span-16", span_16, KERNEL_COUNT},
    {"span-32", span_32, KERNEL_COUNT},
    {"span-64", span_64, KERNEL_COUNT},
    {"span-128", span_128, KERNEL_COUNT},
    {"span-320", span_320, KERNEL_COUNT},
    {"rgb565-noise", rgb565_noise, KERNEL_ROW *KERNEL_COUNT},
    {"rgb565-run", rgb565_run, KERNEL_ROW *KERNEL_COUNT},
    {NULL, NULL, 0},
};
