/* SPDX-License-Identifier: MIT */
/* Frames with a depth buffer of the whole screen: a quad that covers it, seen at an angle, of one
 * colour and textured; and none, which leaves the clearing of the buffer. */
#include "kernel_depth.h"

#include "fixel/extra/depth.h"
#include "fixel/extra/surfaces.h"
#include "kernel_surfaces.h"

static const fxl_point corners[] = {{-40 * 65536, -40 * 65536, 0},
                                    {-40 * 65536, 40 * 65536, 0},
                                    {40 * 65536, 40 * 65536, 0},
                                    {40 * 65536, -40 * 65536, 0}};
static const uint16_t indices[] = {0, 1, 2, 3};
static const fxl_face faces[] = {{{0, 0, -FXL_Q2_30_ONE}, 0, 4, 200, 0}};
static const fxl_model models[] = {
    {.vertex_count = 4, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = 57 * 65536}};
static const fxl_instance instances[] = {{{0, 0, 0}, 0, 0, 0}};
static fxl_scene scene = {.vertices = corners,
                          .indices = indices,
                          .faces = faces,
                          .models = models,
                          .instances = instances,
                          .vertex_count = 4,
                          .index_count = 4,
                          .face_count = 1,
                          .model_count = 1,
                          .instance_count = 1};

static uint8_t texels[64 * 64];
static const fxl_texture texture = {.texels = texels, .log_width = 6, .log_height = 6, .levels = 1};
static const fxl_surface surface = {.texture = 1, .opacity = 16};
static const fxl_mapped_face mapped[] = {
    {.corners = {0, 1, 2}, .texels = {{0, 640 * 65536}, {0, 0}, {640 * 65536, 0}}}};
static const uint16_t face_map[] = {1};
static const fxl_surface_set set = {.textures = &texture,
                                    .surfaces = &surface,
                                    .faces = mapped,
                                    .face_map = face_map,
                                    .texture_count = 1,
                                    .surface_count = 1,
                                    .face_count = 1};

typedef struct {
    fxl_renderer renderer;
    fxl_depth depth;
    FXL_ALIGN_8 uint8_t memory[1024];
} workload;

static workload flat, textured;
static fxl_surfaces surfaces;
static FXL_ALIGN_8 uint8_t cells[FXL_DEPTH_BYTES(SURFACE_WIDTH, SURFACE_HEIGHT, 16)];

#define CLEARS 4u /* of a frame without a face, so that its beginning counts less */

static void draw(workload *of, fxl_angle yaw, uint32_t times)
{
    const fxl_pose eye = {{0, 0, -10 * 65536}, yaw, FXL_DEGREES(10), 0};
    const fxl_band band = {kernel_screen, SURFACE_WIDTH, SURFACE_WIDTH, 0, SURFACE_HEIGHT};
    (void)fxl_frame_begin(&of->renderer, &eye);
    for (uint32_t i = 0; i < times; i++) {
        (void)fxl_frame_draw(&of->renderer, &band);
    }
}

static void run_flat(const kernel_inputs *in)
{
    (void)in;
    draw(&flat, FXL_DEGREES(15), 1);
}

static void run_textured(const kernel_inputs *in)
{
    (void)in;
    draw(&textured, FXL_DEGREES(15), 1);
}

static void run_clear(const kernel_inputs *in)
{
    (void)in;
    draw(&flat, FXL_DEGREES(180), CLEARS);
}

static bool prepare(workload *of, bool has_surfaces)
{
    const fxl_config config = fxl_config_default(SURFACE_WIDTH, SURFACE_HEIGHT);
    return fxl_renderer_init(&of->renderer, &scene, &config, of->memory, sizeof of->memory) ==
               FXL_OK &&
           (!has_surfaces || fxl_renderer_set_surfaces(&of->renderer, &surfaces, &set) == FXL_OK) &&
           fxl_renderer_set_depth(&of->renderer, &of->depth, &fxl_visibility_depth, cells,
                                  sizeof cells) == FXL_OK;
}

bool kernel_depth_prepare(void)
{
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)i;
    }
    return fxl_scene_check(&scene, NULL) == FXL_OK && prepare(&flat, false) &&
           prepare(&textured, true);
}

#define PIXELS (SURFACE_WIDTH * SURFACE_HEIGHT)

const bench_kernel depth_list[] = {
    {"depth-flat", run_flat, PIXELS},
    {"depth-texture", run_textured, PIXELS},
    {"depth-clear", run_clear, CLEARS *PIXELS},
    {NULL, NULL, 0},
};
