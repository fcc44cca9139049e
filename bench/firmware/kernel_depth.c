/* SPDX-License-Identifier: MIT */
/* Frames with a depth buffer of the whole screen: a quad that covers it, seen at an angle, of one
 * colour and textured; and one of a few pixels, which leaves the clearing of the buffer. */
#include "kernels.h"

#include "../../host_tests/unit/mapped_quad.h"

static mapped_quad wall;

typedef struct {
    fxl_renderer renderer;
    FXL_ALIGN_8 uint8_t memory[1024];
} workload;

static workload flat, textured;
static fxl_surfaces surfaces;
static FXL_ALIGN_8 uint8_t cells[FXL_DEPTH_BYTES(SURFACE_WIDTH, SURFACE_HEIGHT, 16)];

#define CLEARS 4u /* of a frame with a small face, so that its beginning counts less */

static void draw(workload *of, uint32_t times)
{
    const fxl_pose eye = {{0, 0, -10 * 65536}, FXL_DEGREES(15), FXL_DEGREES(10), 0};
    const fxl_band band = {.pixels = kernel_screen,
                           .width = SURFACE_WIDTH,
                           .stride = SURFACE_WIDTH,
                           .first_row = 0,
                           .rows = SURFACE_HEIGHT};
    (void)fxl_frame_begin(&of->renderer, &eye);
    for (uint32_t i = 0; i < times; i++) {
        (void)fxl_frame_draw(&of->renderer, &band);
    }
}

/* half: of a side. */
static void size_wall(int32_t half)
{
    for (uint32_t i = 0; i < 4; i++) {
        const bool is_right = i > 1, is_above = i == 1 || i == 2;
        wall.vertices[i] = (fxl_point){is_right ? half : -half, is_above ? half : -half, 0};
    }
}

static void run_flat(const kernel_inputs *in)
{
    (void)in;
    draw(&flat, 1);
}

static void run_textured(const kernel_inputs *in)
{
    (void)in;
    draw(&textured, 1);
}

static void run_clear(const kernel_inputs *in)
{
    (void)in;
    size_wall(65536 / 8);
    draw(&flat, CLEARS);
    size_wall(40 * 65536);
}

static bool prepare(workload *of, bool has_surfaces)
{
    fxl_config config = fxl_config_for(SURFACE_WIDTH, SURFACE_HEIGHT, &fxl_palette_depth_16);
    config.depth = cells;
    config.depth_size = sizeof cells;
    return fxl_renderer_init(&of->renderer, &wall.scene, &config, of->memory, sizeof of->memory) ==
               FXL_OK &&
           (!has_surfaces || fxl_attach_surfaces(&of->renderer, &surfaces, &wall.set,
                                                 FXL_SURFACES_OF(fxl_palette_depth_16)) == FXL_OK);
}

bool kernel_depth_prepare(void)
{
    size_wall(40 * 65536);
    wall.mapped_corners[0].texel.v = wall.mapped_corners[2].texel.u = 640 * 65536;
    for (uint32_t i = 0; i < sizeof wall.texels; i++) {
        wall.texels[i] = (uint8_t)i;
    }
    mapped_quad_make(&wall, (fxl_direction){0, 0, -FXL_Q2_30_ONE}, 57 * 65536);
    return fxl_scene_check(&wall.scene, NULL) == FXL_OK && prepare(&flat, false) &&
           prepare(&textured, true);
}

#define PIXELS (SURFACE_WIDTH * SURFACE_HEIGHT)

const bench_kernel depth_list[] = {
    {"depth-flat", run_flat, PIXELS},
    {"depth-texture", run_textured, PIXELS},
    {"depth-clear", run_clear, CLEARS *PIXELS},
    {NULL, NULL, 0},
};
