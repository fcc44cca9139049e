/* SPDX-License-Identifier: MIT */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "designs/exact.h"
#include "designs/stage.h"

const designs_design *const designs_all[DESIGNS_COUNT] = {&designs_naive, &designs_fixel,
                                                          &designs_float32};
const char *const designs_stage_names[DESIGNS_STAGES] = {
    "matrix", "vertex",          "clip",           "fill", "texel", "texel_16", "texel_8", "affine",
    "light",  "depth_buffer_16", "depth_buffer_32"};
const char *const designs_stage_units[DESIGNS_STAGES] = {"2^-30",
                                                         "1/65536 pixel",
                                                         "1/65536 pixel",
                                                         "pixels",
                                                         "texels",
                                                         "texels",
                                                         "texels",
                                                         "texels",
                                                         "levels",
                                                         "1/65536 of the distance",
                                                         "1/65536 of the distance"};
const char *const designs_stage_measures[DESIGNS_STAGES] = {
    "largest error of the nine entries of the camera's matrix, given the angles",
    "larger error in x and y of an unclipped vertex on the screen, given its 16.16 "
    "coordinates, the camera's position and matrix, and the focal length",
    "distance on the screen of a clipped vertex from the exact image of its edge, given the same",
    "pixels of an outline that are wrongly in or out, given its 16.16 vertices on the screen",
    "how far the exact coordinate is from the texel that a pixel shows, around a texture of 128 "
    "texels, given the corners, their coordinates and the camera's matrix; divided at each pixel",
    "the same, divided every 16 pixels; Fixel divides more often where half a texel could be lost",
    "the same, divided every 8 pixels; Fixel divides more often where half a texel could be lost",
    "the same without perspective, given the corners' 16.16 points on the screen",
    "how far the exact level is from the level of light of 64 that a pixel shows, with a sun, a "
    "lamp "
    "and fog at the corners, divided at each pixel",
    "how much farther the shown one of two faces is than the other, with a depth buffer of 16 bits",
    "the same with 32 bits",
};

static uint8_t exact_pixels[FXL_SCREEN_MAX * FXL_SCREEN_MAX];
static uint8_t design_pixels[FXL_SCREEN_MAX * FXL_SCREEN_MAX];

static double matrix_error(const double entries[9], const double exact[9])
{
    double largest = 0;
    for (int i = 0; i < 9; i++) {
        largest = fmax(largest, fabs(entries[i] - exact[i]));
    }
    return largest;
}

static size_t area_of(const designs_input *input)
{
    return (size_t)input->lens.width * input->lens.height;
}

static int count_differing(const designs_input *input)
{
    int differing = 0;
    for (size_t i = 0; i < area_of(input); i++) {
        differing += exact_pixels[i] != design_pixels[i];
    }
    return differing;
}

static void measure_matrix(const designs_input *input, double errors[DESIGNS_COUNT])
{
    double exact[9], entries[9];
    exact_matrix(&input->pose, exact);
    for (int i = 0; i < DESIGNS_COUNT; i++) {
        designs_all[i]->matrix(&input->pose, entries);
        errors[i] = matrix_error(entries, exact);
    }
}

static void measure_fill(const designs_input *input, double errors[DESIGNS_COUNT])
{
    designs_bitmap exact = {exact_pixels, input->lens.width, input->lens.height};
    designs_bitmap found = {design_pixels, input->lens.width, input->lens.height};
    exact_fill(&input->outline, &exact);
    for (int i = 0; i < DESIGNS_COUNT; i++) {
        memset(design_pixels, 0, area_of(input));
        designs_all[i]->fill(&input->outline, &found);
        errors[i] = count_differing(input);
    }
}

void designs_errors(enum designs_stage stage, const designs_input *input,
                    double errors[DESIGNS_COUNT])
{
    if (stage == DESIGNS_MATRIX) {
        measure_matrix(input, errors);
        return;
    }
    if (stage == DESIGNS_FILL) {
        measure_fill(input, errors);
        return;
    }
    if (stage >= DESIGNS_TEXEL) {
        designs_surface_errors(stage, input, errors);
        return;
    }
    for (int i = 0; i < DESIGNS_COUNT; i++) {
        if (stage == DESIGNS_VERTEX) {
            designs_screen screen = designs_all[i]->vertex(input);
            errors[i] = exact_vertex_error(input, &screen);
        } else {
            designs_screen screen = designs_all[i]->clip(input);
            errors[i] = exact_edge_distance(input, &screen);
        }
    }
}

static void explain_view(enum designs_stage stage, const designs_input *input)
{
    const fxl_lens *lens = &input->lens;
    printf("screen %u x %u pixels, focal length %.6f pixels, near plane %.6f\n", lens->width,
           lens->height, lens->focal / 65536.0, lens->near_z / 65536.0);
    for (int i = 0; i < (stage == DESIGNS_CLIP ? 2 : 1); i++) {
        const fxl_point *point = &input->points[i];
        fxl_view_point view = exact_view_point(input, i);
        printf("vertex (%.6f, %.6f, %.6f) in the world, (%.9f, %.9f, %.9f) in the view\n",
               point->x / 65536.0, point->y / 65536.0, point->z / 65536.0, (double)view.x * 0x1p-46,
               (double)view.y * 0x1p-46, (double)view.z * 0x1p-46);
    }
}

static void explain_screen(enum designs_stage stage, const designs_input *input)
{
    double errors[DESIGNS_COUNT];
    designs_errors(stage, input, errors);
    if (stage == DESIGNS_VERTEX) {
        fxl_view_point view = exact_view_point(input, 0);
        designs_screen screen = exact_screen(input, &view);
        printf("%-8s x %16.9f  y %16.9f pixels\n", "exact", screen.x / 65536, screen.y / 65536);
    }
    for (int i = 0; i < DESIGNS_COUNT; i++) {
        designs_screen screen =
            stage == DESIGNS_VERTEX ? designs_all[i]->vertex(input) : designs_all[i]->clip(input);
        printf("%-8s x %16.9f  y %16.9f pixels, off by %.6g/65536 pixel\n", designs_all[i]->name,
               screen.x / 65536, screen.y / 65536, errors[i]);
    }
}

void designs_explain(enum designs_stage stage, const designs_input *input)
{
    static const char *const planes[FXL_PLANE_COUNT] = {
        [FXL_PLANE_LEFT] = "left", [FXL_PLANE_RIGHT] = "right", [FXL_PLANE_BOTTOM] = "bottom",
        [FXL_PLANE_TOP] = "top",   [FXL_PLANE_NEAR] = "near",   [FXL_PLANE_FAR] = "far"};
    double errors[DESIGNS_COUNT];
    printf("%s: %s\n", designs_stage_names[stage], designs_stage_measures[stage]);
    if (stage == DESIGNS_VERTEX || stage == DESIGNS_CLIP) {
        explain_view(stage, input);
        if (stage == DESIGNS_CLIP) {
            printf("clipped to the %s plane\n", planes[input->plane]);
        }
        explain_screen(stage, input);
        return;
    }
    designs_errors(stage, input, errors);
    for (int i = 0; i < DESIGNS_COUNT; i++) {
        printf("%-8s off by %.6g %s\n", designs_all[i]->name, errors[i],
               stage == DESIGNS_MATRIX ? "units of 2^-30" : designs_stage_units[stage]);
    }
}

static void set_near(designs_plan *plan, double value)
{
    plan->near = (designs_range){value, value};
}

static void set_depth(designs_plan *plan, double value)
{
    plan->near = (designs_range){1.0 / 256, 1.0 / 256};
    plan->depth = (designs_range){value, 1.25 * value};
}

static void set_fov(designs_plan *plan, double value)
{
    plan->depth = (designs_range){1, 256};
    plan->fov = (designs_range){value, value};
}

static void set_reach(designs_plan *plan, double value)
{
    plan->depth = (designs_range){0.25, 1};
    plan->fov = (designs_range){90, 90};
    plan->eye = value;
    plan->reach = value;
}

/* Near the eye and with the eye near the origin, so that the clip shows and not
 * the rest. */
static void set_near_crossing(designs_plan *plan)
{
    plan->depth = (designs_range){1, 4};
    plan->near = (designs_range){0.25, 1};
    plan->fov = (designs_range){90, 90};
    plan->eye = 16;
}

static void set_edge(designs_plan *plan, double value)
{
    set_near_crossing(plan);
    plan->edge = (designs_range){value / 2, value / 2};
}

static void set_angle(designs_plan *plan, double value)
{
    set_near_crossing(plan);
    plan->angle = (designs_range){value, value};
}

/* Small faces not far from the origin, so that what is swept shows and not the rest. */
static void set_near_surface(designs_plan *plan)
{
    plan->near = (designs_range){1.0 / 16, 1.0 / 16};
    plan->depth = (designs_range){1, 16};
    plan->fov = (designs_range){60, 60};
    plan->eye = 256;
    plan->face = 2;
    plan->texels = (designs_range){256, 256};
}

static void set_texel_depth(designs_plan *plan, double value)
{
    set_near_surface(plan);
    plan->depth = (designs_range){value, 1.25 * value};
}

static void set_texels(designs_plan *plan, double value)
{
    set_near_surface(plan);
    plan->texels = (designs_range){value, value};
}

static void set_face(designs_plan *plan, double value)
{
    set_near_surface(plan);
    plan->face = value;
}

/* Near and far planes as of a room or a street. */
static void set_distance(designs_plan *plan, double value)
{
    set_near_surface(plan);
    plan->near = (designs_range){0.25, 0.25};
    plan->far = 2048;
    plan->depth = (designs_range){value, 1.25 * value};
}

const designs_sweep designs_sweeps[DESIGNS_SWEEPS] = {
    {"near",
     "near plane (world units)",
     DESIGNS_VERTEX,
     9,
     {1.0 / 256, 1.0 / 64, 1.0 / 16, 1.0 / 4, 1, 4, 16, 64, 256},
     set_near},
    {"depth",
     "depth of the vertex (world units)",
     DESIGNS_VERTEX,
     12,
     {1.0 / 256, 1.0 / 64, 1.0 / 16, 1.0 / 4, 1, 4, 16, 64, 256, 1024, 4096, 8192},
     set_depth},
    {"fov",
     "field of view (degrees)",
     DESIGNS_VERTEX,
     9,
     {10, 20, 40, 60, 80, 100, 120, 140, 150},
     set_fov},
    {"coordinates",
     "size of the coordinates (world units)",
     DESIGNS_VERTEX,
     8,
     {1, 4, 16, 64, 256, 1024, 4096, 8191},
     set_reach},
    {"edge_length",
     "length of the clipped edge (world units)",
     DESIGNS_CLIP,
     8,
     {0.25, 1, 4, 16, 64, 256, 1024, 8192},
     set_edge},
    {"plane_angle",
     "angle between edge and clip plane (degrees)",
     DESIGNS_CLIP,
     9,
     {0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 90},
     set_angle},
    {"texel_depth",
     "depth of the pixel (world units)",
     DESIGNS_TEXEL,
     8,
     {0.25, 1, 4, 16, 64, 256, 1024, 4096},
     set_texel_depth},
    {"texel_size",
     "largest texture coordinate (texels)",
     DESIGNS_TEXEL,
     8,
     {1, 4, 16, 64, 256, 1024, 4096, 16383},
     set_texels},
    {"texel_face",
     "longest edge of a face (depths of the pixel)",
     DESIGNS_TEXEL_16,
     8,
     {0.25, 0.5, 1, 2, 4, 8, 16, 32},
     set_face},
    {"light_depth",
     "depth of the pixel (world units)",
     DESIGNS_LIGHT,
     8,
     {0.25, 1, 4, 16, 64, 256, 1024, 4096},
     set_texel_depth},
    {"distance_16",
     "distance of the faces (world units)",
     DESIGNS_DEPTH_16,
     8,
     {0.3125, 1, 4, 16, 64, 256, 512, 1024},
     set_distance},
    {"distance_32",
     "distance of the faces (world units)",
     DESIGNS_DEPTH_32,
     8,
     {0.3125, 1, 4, 16, 64, 256, 512, 1024},
     set_distance},
};
