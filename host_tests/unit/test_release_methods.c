/* SPDX-License-Identifier: MIT */
/* Frames whose scene is released, by the methods that need more than their polygons: what they read
 * beside the display list is not the scene's. */
#include "frame_bands.h"
#include "bsp_scene.h"
#include "choices.h"
#include "depth_scene.h"
#include "rgb565_scene.h"

static void expect_depth_unread(depth_scene *made)
{
    fxl_renderer *renderer = &made->renderer;
    const fxl_band band = UNIT_BAND(made->again, DEPTH_SCENE_WIDTH, 0, DEPTH_SCENE_HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_render(renderer, &depth_scene_eye, made->frame, DEPTH_SCENE_WIDTH));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(renderer, &depth_scene_eye));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(renderer));
    renderer->scene = NULL;
    fxl_fill_band(&band, DEPTH_SCENE_BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(renderer, &band));
    TEST_ASSERT_EQUAL_MEMORY(made->frame, made->again, sizeof made->frame);
}

/* A depth buffer, near to far and, because of what is blended, far to near in two passes. */
void test_depth_and_textures_are_drawn_without_the_scene(void)
{
    static uint8_t blend[FXL_BLEND_TABLE_BYTES(31)];
    for (uint32_t blended = 0; blended < 2; blended++) {
        depth_scene *made = depth_scene_make();
        made->face_map[1] = 1;
        if (blended) {
            made->surface.flags = FXL_SURFACE_BLEND;
            made->set.blend = blend;
            made->set.blend_first = 0;
            made->set.blend_count = 31;
        }
        made->is_mapped = true;
        depth_scene_start(made);
        expect_depth_unread(made); /* by surfaces alone */
        depth_scene_start_with(made, &fxl_palette_depth_16);
        expect_depth_unread(made);
    }
}

void test_frames_of_16_bits_are_drawn_without_the_scene(void)
{
    const fxl_band band = {.pixels = (uint8_t *)(void *)walls.again,
                           .width = WIDTH,
                           .stride = WIDTH,
                           .first_row = 0,
                           .rows = HEIGHT,
                           .palette = walls.palette};
    walls_make();
    walls_begin();
    walls_draw(walls.pixels);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&walls.renderer, &walls_eye));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(&walls.renderer));
    walls.renderer.scene = NULL;
    fxl_rgb565.fill(NULL, &band, BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&walls.renderer, &band));
    TEST_ASSERT_EQUAL_MEMORY(walls.pixels, walls.again, sizeof walls.pixels);
}

/* A tree that cuts two cubes. */
void test_a_tree_is_drawn_without_the_scene(void)
{
    static uint8_t frames[2][HEIGHT * WIDTH];
    static uint32_t list[60 * FXL_DISPLAY_LIST_WORDS(8)];
    static fxl_draw_entry order[TINY_INSTANCES + 6];
    static FXL_ALIGN_8 uint8_t room[4096], pieces[4096];
    static fxl_renderer renderer;
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order, TINY_INSTANCES + 6, list, sizeof list / sizeof list[0], NULL,
                               0};
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-6)}, 0, 0u - DEGREES(10), DEGREES(5)};
    bsp_scene *made = bsp_make();
    made->tiny->instances[0].centre.z = Q16(9);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&made->tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init_with(&renderer, &made->tiny->scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_tree, room, sizeof room));
    fxl_bsp_workspace *tree = (fxl_bsp_workspace *)renderer.order_memory;
    tree->pieces = pieces;
    tree->pieces_size = sizeof pieces;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    for (int i = 0; i < 2; i++) {
        frame_draw_bands(&renderer, frames[i], HEIGHT, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(&renderer));
        renderer.scene = NULL;
    }
    TEST_ASSERT_EQUAL(6, renderer.workspace.counters.drawn); /* of two cubes that are in sight */
    TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
}
