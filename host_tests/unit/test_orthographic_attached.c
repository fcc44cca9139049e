/* SPDX-License-Identifier: MIT */
/* Billboards and surfaces with an orthographic lens, pixel by pixel against their definitions in double. */
#include <math.h>

#include "mapped_quad.h"
#include "tiny_frames.h"

enum {
    WIDTH = 64,
    HEIGHT = 48,
    BACKGROUND = 255
};

static uint8_t frame[WIDTH * HEIGHT];
static fxl_renderer renderer;
static FXL_ALIGN_8 uint8_t memory[40000];

static double along(const fxl_direction *axis, const fxl_point *a, const fxl_point *b)
{
    return ((double)axis->x * (a->x - b->x) + (double)axis->y * (a->y - b->y) +
            (double)axis->z * (a->z - b->z)) /
           (FXL_Q2_30_ONE * 65536.0);
}

/* Each pixel of a frame in which the sprite of instance 1 alone is drawn. Returns how many of it. */
static uint32_t expect_sprite(const board_scene *scene, double scale)
{
    const fxl_camera *camera = &renderer.frame.view.camera;
    const fxl_point *centre = &scene->tiny->instances[1].centre;
    const double x = WIDTH / 2.0 + scale * along(&camera->axes.right, centre, &camera->position);
    const double y = HEIGHT / 2.0 - scale * along(&camera->axes.up, centre, &camera->position);
    const fxl_billboard *board = &scene->board;
    const double unit = scale / 65536, left = x - board->anchor_x * unit,
                 right = x + (board->width - board->anchor_x) * unit,
                 bottom = y + board->anchor_y * unit,
                 top = y - (board->height - board->anchor_y) * unit;
    uint32_t shown = 0;
    for (int row = 0; row < HEIGHT; row++) {
        for (int column = 0; column < WIDTH; column++) {
            const int u = exact_sprite_texel(column + 0.5, left, right, BOARD_SPRITE_WIDTH);
            const int v = exact_sprite_texel(row + 0.5, top, bottom, BOARD_SPRITE_HEIGHT);
            if (u == -2 || v == -2) {
                continue;
            }
            const bool is_there = u >= 0 && v >= 0;
            TEST_ASSERT_EQUAL(is_there ? scene->texels[v * BOARD_SPRITE_WIDTH + u] : BACKGROUND,
                              frame[row * WIDTH + column]);
            shown += is_there;
        }
    }
    return shown;
}

/* orthographic 2.8a */
void test_a_billboard_has_one_size_at_every_depth(void)
{
    static board_scene scene;
    fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    config.background = BACKGROUND;
    for (int round = 0; round < UNIT_REPEAT / 200 + 8; round++) {
        const fxl_q16_16 scale = unit_between(Q16(2), Q16(12));
        fxl_pose pose = unit_pose();
        board_scene_make(&scene);
        scene.tiny->scene.instances = &scene.tiny->instances[1];
        scene.tiny->scene.instance_count = 1;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&scene.tiny->scene, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene.tiny->scene, &config, memory,
                                                    sizeof memory));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, scale));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&renderer, &scene.billboards, &scene.set,
                                                        FXL_SPRITES_OF(fxl_palette)));
        /* The centre is straight ahead, at any depth, then the eye goes aside. */
        fxl_camera camera;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
        const double back = unit_between(1, 60), aside = unit_between(-200, 200) / 100.0;
        const fxl_point *centre = &scene.tiny->instances[1].centre;
        const fxl_axes *axes = &camera.axes;
        pose.position.x =
            centre->x + Q16((axes->right.x * aside - axes->forward.x * back) / FXL_Q2_30_ONE);
        pose.position.y =
            centre->y + Q16((axes->right.y * aside - axes->forward.y * back) / FXL_Q2_30_ONE);
        pose.position.z =
            centre->z + Q16((axes->right.z * aside - axes->forward.z * back) / FXL_Q2_30_ONE);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
        TEST_ASSERT_TRUE(expect_sprite(&scene, scale / 65536.0) > 30);
    }
}

/* --- surfaces -------------------------------------------------------------------------------- */

/* The texel of the floor under a pixel's centre, or -1; *edge: how far that is from another one, in
 * texels. The floor is 16 x 20 units, half a unit below the origin; a texel is a square of half a unit. */
static int exact_floor(const fxl_pose *pose, double scale, int x, int y, double *edge)
{
    const fxl_axes *axes = &renderer.frame.view.camera.axes;
    const double one = FXL_Q2_30_ONE, right = (x + 0.5 - WIDTH / 2.0) / scale,
                 up = (HEIGHT / 2.0 - y - 0.5) / scale;
    const double from[3] = {
        pose->position.x / 65536.0 + (axes->right.x * right + axes->up.x * up) / one,
        pose->position.y / 65536.0 + (axes->right.y * right + axes->up.y * up) / one,
        pose->position.z / 65536.0 + (axes->right.z * right + axes->up.z * up) / one};
    const double depth = (-0.5 - from[1]) / (axes->forward.y / one);
    const double u = (from[0] + depth * axes->forward.x / one + 8) * 32;
    const double v = (from[2] + depth * axes->forward.z / one + 4) * 32;
    *edge = fmin(fabs(u / 16 - floor(u / 16 + 0.5)), fabs(v / 16 - floor(v / 16 + 0.5))) * 16;
    if (depth < 1 / 16.0 || depth > 64 || u < 0 || u > 512 || v < 0 || v > 640) {
        return -1;
    }
    return 1 + ((int)(v / 16) & 3) * 4 + ((int)(u / 16) & 3);
}

/* orthographic 2.10a, 2.10b */
void test_texels_are_affine_on_the_screen(void)
{
    static mapped_quad quad;
    static fxl_surfaces surfaces;
    uint32_t textured = 0;
    for (int round = 0; round < UNIT_REPEAT / 400 + 8; round++) {
        const fxl_q16_16 scale = unit_between(Q16(2), Q16(8));
        const bool is_deep = round % 2 != 0;
        fxl_config config = mapped_quad_floor_config(WIDTH, HEIGHT);
        static FXL_ALIGN_8 uint8_t depths[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 16)];
        if (is_deep) {
            config = fxl_config_for(WIDTH, HEIGHT, &fxl_palette_depth_16);
            config.near_z = 4096;
            config.far_z = Q16(64);
            config.depth = depths;
            config.depth_size = sizeof depths;
        }
        config.background = BACKGROUND;
        const fxl_pose pose = {{unit_between(-Q16(4), Q16(4)), unit_between(Q16(1), Q16(4)), 0},
                               (fxl_angle)unit_random(),
                               0u - (uint32_t)unit_between(DEGREES(20), DEGREES(80)),
                               unit_random()};
        mapped_quad_make_floor(&quad);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&quad.scene, NULL));
        TEST_ASSERT_EQUAL(
            FXL_OK, fxl_renderer_init(&renderer, &quad.scene, &config, memory, sizeof memory));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, scale));
        TEST_ASSERT_EQUAL(FXL_OK, is_deep
                                      ? fxl_attach_surfaces(&renderer, &surfaces, &quad.set,
                                                            FXL_SURFACES_OF(fxl_palette_depth_16))
                                      : fxl_attach_surfaces(&renderer, &surfaces, &quad.set,
                                                            FXL_SURFACES_OF(fxl_palette)));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            double edge;
            const int texel = exact_floor(&pose, scale / 65536.0, i % WIDTH, i / WIDTH, &edge);
            textured += texel >= 0;
            if (edge > 0.25) {
                TEST_ASSERT_EQUAL(texel < 0 ? BACKGROUND : texel, frame[i]);
            }
        }
    }
    TEST_ASSERT_TRUE(textured > WIDTH * HEIGHT);
}
