/* SPDX-License-Identifier: MIT */
/* Textured faces: a quad that covers the screen, by its pixels and what a row, a segment and the
 * face cost; and workload W4, a whole frame without the clear. */
#include "kernels.h"

#include "../../host_tests/unit/mapped_quad.h"
#include "draw/stages.h"
#include "fixel/all.h"
#include "paint/paint_polygon.h"

enum {
    LOG_SIZE = 6,
    LEVELS = 16,
    KEY = 6,             /* of the colours 1 to 16 */
    TEXELS = 512 * 65536 /* of the quad, 16.16 */
};

static mapped_quad floor_scene;
static uint8_t ramp[256 * LEVELS];
FXL_ALIGN_8 uint8_t kernel_screen[SURFACE_WIDTH * SURFACE_HEIGHT];
static const fxl_band screen = {.pixels = kernel_screen,
                                .width = SURFACE_WIDTH,
                                .stride = SURFACE_WIDTH,
                                .first_row = 0,
                                .rows = SURFACE_HEIGHT};
static fxl_scan scan;

/* --- a quad --------------------------------------------------------------------------------- */

static const fxl_screen_point whole[] = {{0, 0},
                                         {SURFACE_WIDTH * 65536, 0},
                                         {SURFACE_WIDTH * 65536, SURFACE_HEIGHT * 65536},
                                         {0, SURFACE_HEIGHT * 65536}};
/* The depths of the upper left, the upper right and the lower right corner, in units. */
static const uint8_t straight[] = {4, 4, 4}, tilted[] = {8, 6, 4};

/* A quad over the whole screen of the view: 90 degrees wide. */
static void quad(const kernel_inputs *in, const uint8_t depths[3], bool lit, uint8_t flags)
{
    static const int8_t sides[3][2] = {{-1, 1}, {1, 1}, {1, -1}};
    static fxl_gradient_corners face = {
        .values = {{0, TEXELS, TEXELS},
                   {0, 0, TEXELS * 3 / 4},
                   {32768, LEVELS * 65536 / 2, LEVELS * 65536 - 1}}};
    fxl_gradients gradients;
    for (uint32_t i = 0; i < 3; i++) {
        fxl_view_point *corner = &face.corners[i];
        corner->z = (int64_t)depths[i] << 46;
        corner->x = corner->z * sides[i][0];
        corner->y = corner->z * sides[i][1] / 4 * 3;
    }
    face.count = lit ? 3 : 2;
    fxl_gradients_find(&face, &in->view, &gradients);
    const fxl_paint paint = {.gradients = &gradients,
                             .level = {.texels = floor_scene.texels,
                                       .columns_less_1 = (1u << LOG_SIZE) - 1u,
                                       .rows_less_1 = (1u << LOG_SIZE) - 1u,
                                       .log_width = LOG_SIZE,
                                       .flags = flags,
                                       .key = KEY},
                             .ramp = lit ? ramp : NULL,
                             .levels_less_1 = LEVELS - 1,
                             .opacity = 16};
    fxl_segment_face segments;
    const bool found = fxl_segments_find(&paint, &segments);
    if (found && !lit) {
        fxl_paint_plain_polygon(&paint, &segments, whole, 4, &screen, 1, &scan, fxl_paint_rows,
                                fxl_paint_pixels);
    } else {
        fxl_paint_polygon(&paint, found ? &segments : NULL, whole, 4, &screen, 1, &scan,
                          fxl_paint_simply, NULL);
    }
}

static void affine(const kernel_inputs *in)
{
    quad(in, straight, false, 0);
}

static void perspective(const kernel_inputs *in)
{
    quad(in, tilted, false, 0);
}

static void lit(const kernel_inputs *in)
{
    quad(in, tilted, true, 0);
}

/* One texel of 16 is a hole. */
static void keyed(const kernel_inputs *in)
{
    quad(in, tilted, false, FXL_TEXTURE_KEYED);
}

static void keyed_lit(const kernel_inputs *in)
{
    quad(in, tilted, true, FXL_TEXTURE_KEYED);
}

/* --- W4 ------------------------------------------------------------------------------------- */

static fxl_renderer renderer;
static fxl_surfaces surfaces;
static FXL_ALIGN_8 uint8_t memory[1024];

static void w4(const kernel_inputs *in)
{
    static const fxl_pose eye = {{0, 0, 0}, 40u << 23, 0u - (12u << 23), 0};
    (void)in;
    fxl_frame_begin(&renderer, &eye);
    fxl_frame_draw(&renderer, &screen);
}

bool kernel_surfaces_prepare(void)
{
    mapped_quad_make_floor(&floor_scene);
    const fxl_config config = mapped_quad_floor_config(SURFACE_WIDTH, SURFACE_HEIGHT);
    return fxl_scene_check(&floor_scene.scene, NULL) == FXL_OK &&
           fxl_renderer_init(&renderer, &floor_scene.scene, &config, memory, sizeof memory) ==
               FXL_OK &&
           fxl_attach_surfaces(&renderer, &surfaces, &floor_scene.set,
                               FXL_SURFACES_OF(fxl_palette)) == FXL_OK;
}

#define PIXELS (SURFACE_WIDTH * SURFACE_HEIGHT)

const bench_kernel surface_list[] = {
    {"texture-affine", affine, PIXELS},
    {"texture-perspective", perspective, PIXELS},
    {"texture-lit", lit, PIXELS},
    {"texture-keyed", keyed, PIXELS},
    {"texture-keyed-lit", keyed_lit, PIXELS},
    {"texture-w4", w4, 1},
    {NULL, NULL, 0},
};
