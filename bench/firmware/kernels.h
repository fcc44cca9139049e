/* SPDX-License-Identifier: MIT */
/* The list of kernels: a new one is a function and a line. */
#ifndef BENCH_KERNELS_H
#define BENCH_KERNELS_H

#include "draw/stages.h"
#include "fixel/all.h"

/* The inputs: the same pseudo-random values on every core, in the ranges that the stages of a frame
 * have. */
#define KERNEL_COUNT 64u  /* of each kind of input, a power of two */
#define KERNEL_ROW   320u /* pixels of a row */

typedef struct {
    fxl_view view; /* 320x240, 90 degrees */
    fxl_vertex_cache cache;
    fxl_model_view placed; /* an instance about the origin, of the points below */
    fxl_angle angles[KERNEL_COUNT];
    uint64_t wide[KERNEL_COUNT];            /* all 64 bits */
    int64_t numerators[KERNEL_COUNT];       /* as project divides: below 2^59 */
    int64_t depths[KERNEL_COUNT];           /* 2^30 to 2^31 */
    uint32_t heights[KERNEL_COUNT];         /* of edges, up to 60 rows */
    int32_t dividends[KERNEL_COUNT];        /* up to as many columns */
    fxl_point points[KERNEL_COUNT];         /* within 8 units of the origin */
    fxl_view_point seen[KERNEL_COUNT];      /* on the screen, 2 to 10 units away */
    fxl_view_polygon inside[KERNEL_COUNT];  /* quads on the screen */
    fxl_view_polygon across[KERNEL_COUNT];  /* quads that the left plane cuts */
    fxl_screen_polygon quads[KERNEL_COUNT]; /* on the screen, 20 to 60 rows high */
    FXL_ALIGN_8 uint8_t noise[KERNEL_ROW];  /* pixels, none of the colour of its neighbour */
    FXL_ALIGN_8 uint8_t run[KERNEL_ROW];    /* pixels of one colour */
} kernel_inputs;

void kernel_inputs_make(kernel_inputs *inputs);

typedef struct {
    const char *name;
    void (*run)(const kernel_inputs *inputs);
    uint32_t units; /* units of one run: the figure is divided by it */
} bench_kernel;

/* Each ends with a name that is null. */
extern const bench_kernel kernel_list[]; /* of the library */
extern const bench_kernel limit_list[];  /* bare work, to compare with */
extern const bench_kernel surface_list[];
extern const bench_kernel depth_list[];

#define SURFACE_WIDTH  320u
#define SURFACE_HEIGHT 240u

/* What kernels with frames draw into, one after another. */
extern uint8_t kernel_screen[SURFACE_WIDTH * SURFACE_HEIGHT];

/* Before the lists are run. False: the library refused the workload. */
bool kernel_surfaces_prepare(void);
bool kernel_depth_prepare(void);

#endif
