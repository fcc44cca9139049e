/* SPDX-License-Identifier: MIT */
/* Faces with textures, against the definition in double: a ray through each pixel's centre. */
#include <math.h>

#include "frame_bands.h"
#include "study/clippers.h"
#include "mapped_quad.h"
#include "unit.h"

enum {
    WIDTH = 64,
    HEIGHT = 48,
    BACKGROUND = 255
};

static mapped_quad quad;
static fxl_renderer renderer;
static fxl_surfaces surfaces;
static FXL_ALIGN_8 uint8_t memory[1024];
static uint8_t frame[WIDTH * HEIGHT], again[WIDTH * HEIGHT];

void setUp(void)
{
    mapped_quad_make_floor(&quad);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&quad.scene, NULL));
    fxl_config config = mapped_quad_floor_config(WIDTH, HEIGHT);
    config.background = BACKGROUND;
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init(&renderer, &quad.scene, &config, memory, sizeof memory));
}

static const fxl_pose eye = {{0, 0, 0}, 40u << 23, 0u - (12u << 23), 0};

/* place sampling: definition: exact_texel */
/* The texel under a pixel's centre in double, or -1; *edge: how far its coordinates are from where
 * the texel would be another, in texels. */
static int exact_texel(int x, int y, double *edge)
{
    const fxl_camera *camera = &renderer.frame.view.camera;
    const fxl_axes *axes = &camera->axes;
    const double focal = renderer.frame.view.lens.focal / 65536.0, one = FXL_Q2_30_ONE;
    const double dx = (x + 0.5 - WIDTH / 2.0) / focal, dy = (HEIGHT / 2.0 - y - 0.5) / focal;
    const double way[3] = {(axes->right.x * dx + axes->up.x * dy + axes->forward.x) / one,
                           (axes->right.y * dx + axes->up.y * dy + axes->forward.y) / one,
                           (axes->right.z * dx + axes->up.z * dy + axes->forward.z) / one};
    const double depth = -0.5 / way[1];
    const double u = (way[0] * depth + 8) * 32, v = (way[2] * depth + 4) * 32;
    if (way[1] >= 0 || depth < 1 / 16.0 || depth > 64 || u < 0 || u > 512 || v < 0 || v > 640) {
        return -1;
    }
    *edge = fmin(fabs(u / 16 - floor(u / 16 + 0.5)), fabs(v / 16 - floor(v / 16 + 0.5))) * 16;
    return 1 + ((int)(v / 16) & 3) * 4 + ((int)(u / 16) & 3);
}

static void check_frame(double tolerance)
{
    uint32_t textured = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            double edge = 1e9;
            const int texel = exact_texel(x, y, &edge);
            textured += texel >= 0;
            if (texel >= 0 && edge > tolerance) {
                TEST_ASSERT_EQUAL(texel, frame[y * WIDTH + x]);
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(WIDTH * HEIGHT / 3, textured);
}

static fxl_status attach(void)
{
    return fxl_attach_surfaces(&renderer, &surfaces, &quad.set, FXL_SURFACES_OF(fxl_palette));
}

/* SPEC 9.5, 9.2e, 9.2h, surfaces 1.1b */
void test_a_floor_divided_at_each_pixel(void)
{
    quad.surface.division = FXL_DIVIDE_1;
    TEST_ASSERT_EQUAL(FXL_OK, attach());
    check_frame(1.0 / 256);
}

void test_a_floor_divided_every_16_pixels(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, attach());
    check_frame(0.5 + 1.0 / 256);
}

/* Of a level eye a row of the floor is equally far everywhere. */
/* SPEC 9.2k */
void test_rows_of_one_weight_are_exact(void)
{
    static const uint8_t divisions[] = {FXL_DIVIDE_16, FXL_DIVIDE_8};
    for (size_t i = 0; i < sizeof divisions; i++) {
        quad.surface.division = divisions[i];
        TEST_ASSERT_EQUAL(FXL_OK, attach());
        check_frame(1.0 / 256);
    }
}

/* What is counted of a face does not depend on what is on it, nor on how many polygons a clipper
 * makes of it. */
void test_surfaces_are_counted_as_flat_faces(void)
{
    static const fxl_clipper *const clippers[] = {&fxl_clipper_view, &fxl_clipper_triangles};
    static fxl_clipper_workspace work;
    for (int i = 0; i < 2; i++) {
        setUp();
        renderer.frame.display_list.capacity = 0; /* it may be too short for surfaces */
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clippers[i], i ? &work : NULL,
                                                           i ? sizeof work : 0));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
        const fxl_counters flat = renderer.workspace.counters;
        TEST_ASSERT_TRUE(flat.drawn > 0 && flat.clipped > 0);
        TEST_ASSERT_EQUAL(FXL_OK, attach());
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
        TEST_ASSERT_EQUAL_MEMORY(&flat, &renderer.workspace.counters, sizeof flat);
    }
    /* Of a fan some triangles are cut and others are not. */
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        fxl_pose near = eye;
        near.position.x += unit_between(Q16(-6), Q16(6));
        near.position.y += unit_between(0, Q16(3));
        near.position.z += unit_between(Q16(-6), Q16(6));
        near.yaw = unit_random();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&renderer, NULL, NULL, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &near, frame, WIDTH));
        const fxl_counters flat = renderer.workspace.counters;
        TEST_ASSERT_EQUAL(FXL_OK, attach());
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &near, again, WIDTH));
        TEST_ASSERT_EQUAL_MEMORY(&flat, &renderer.workspace.counters, sizeof flat);
    }
}

/* surfaces 2.2d */
void test_bands_and_lists_give_the_same_pixels(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, attach());
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    for (uint32_t words = 0; words < 2; words++) {
        renderer.frame.display_list.capacity = words * 64;
        frame_draw_pose(&renderer, &eye, again, 3, BACKGROUND);
        TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
        TEST_ASSERT_EQUAL(words != 0, renderer.frame.display_list.used != 0);
    }
}

/* A ground that ends so far away that its last row of pixels is the horizon, where the weight is 0: what
 * clamps shows the farthest row of texels there, from its first texel to its last. */
void test_a_ground_that_reaches_the_horizon(void)
{
    const int32_t far_z = Q16(8000);
    fxl_config config = mapped_quad_floor_config(WIDTH, HEIGHT - 1); /* a row is in the middle */
    config.far_z = FXL_FAR_MAX;
    config.background = BACKGROUND;
    for (uint32_t i = 0; i < 4; i++) {
        quad.vertices[i] =
            (fxl_point){i == 1 || i == 2 ? far_z : -far_z, -2, i < 2 ? far_z : 65536};
    }
    for (uint32_t i = 0; i < 3; i++) {
        quad.mapped_corners[i].texel = (fxl_texel){i > 0 ? Q16(64) : 0, i < 2 ? Q16(64) : 0};
    }
    quad.model.radius = Q16(12000);
    quad.surface.division = FXL_DIVIDE_1;
    quad.texture.flags = FXL_TEXTURE_CLAMP;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&quad.scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init(&renderer, &quad.scene, &config, memory, sizeof memory));
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_attach_surfaces(&renderer, &surfaces, &quad.set, FXL_SURFACES_OF(fxl_palette)));
    const fxl_pose ahead = {{0, 0, 0}, 0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &ahead, frame, WIDTH));
    for (uint32_t i = 0; i < WIDTH * (HEIGHT - 1); i++) {
        const uint32_t column = i % WIDTH;
        if (i / WIDTH != HEIGHT / 2 - 1) {
            TEST_ASSERT_EQUAL(BACKGROUND, frame[i]);
        } else if (column < WIDTH / 2) {
            TEST_ASSERT_EQUAL(quad.texels[64 * 63], frame[i]);
        } else {
            TEST_ASSERT_TRUE(frame[i] >= frame[i - 1] && frame[i] <= quad.texels[64 * 63 + 63]);
        }
    }
    TEST_ASSERT_EQUAL(quad.texels[64 * 63 + 63], frame[HEIGHT / 2 * WIDTH - 1]);
}
