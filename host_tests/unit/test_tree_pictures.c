/* SPDX-License-Identifier: MIT */
/* Billboards in the order by tree: each is whole, in the leaf of its centre. */
#include "bsp_scene.h"
#include "frame_bands.h"
#include "tiny_board.h"

enum {
    WIDTH = 48,
    HEIGHT = 36,
    PIXELS = WIDTH * HEIGHT,
    BACKGROUND = 250,
    SPRITE = 100,
    MODELS = 3,
    WORDS = 600
};

static const fxl_pose eye = {{Q16(0.25), Q16(0.5), Q16(6)}, 0, 0, 0};

static fxl_renderer renderer;
static fxl_billboards billboards;
static fxl_sprite sprite;
static fxl_billboard board;
static fxl_billboard_set set;
static fxl_model models[MODELS];
static fxl_face faces[13];
static fxl_point vertices[20];
static uint16_t corners[52];
static uint16_t model_map[MODELS], colours[256], wide[PIXELS];
static uint8_t texels[4], frame[PIXELS], other[PIXELS], memory[8192];
static uint64_t tree[512];
static bsp_scene *made;

/* Instance 0 is a square across z, of 1.5 units a side, or a sprite of that size. Instance 2 is a
 * cube on another layer. */
void setUp(void)
{
    made = bsp_make();
    tiny_scene *tiny = made->tiny;
    memcpy(faces, tiny->faces, sizeof tiny->faces);
    faces[12] = faces[4]; /* that towards -z */
    faces[12].material = SPRITE;
    faces[12].first_index = 48;
    memcpy(vertices, tiny->vertices, sizeof tiny->vertices);
    memcpy(corners, tiny->corners, sizeof tiny->corners);
    for (uint16_t i = 0; i < 4; i++) {
        vertices[16 + i] = vertices[corners[faces[4].first_index + i]];
        vertices[16 + i].z = 0;
        corners[48 + i] = i;
    }
    memcpy(models, tiny->models, sizeof tiny->models);
    models[2] = models[0];
    models[2].first_vertex = 16;
    models[2].vertex_count = 4;
    models[2].first_face = 12;
    models[2].face_count = 1;
    tiny->scene.vertices = vertices;
    tiny->scene.vertex_count = 20;
    tiny->scene.indices = corners;
    tiny->scene.index_count = 52;
    tiny->scene.faces = faces;
    tiny->scene.face_count = 13;
    tiny->scene.models = models;
    tiny->scene.model_count = MODELS;
    tiny->instances[0].model = 2;
    tiny->instances[2].layer = 1;
    memset(texels, SPRITE, sizeof texels);
    sprite = (fxl_sprite){
        .pixels = texels, .width = 2, .height = 2, .bits = 8, .key = FXL_SPRITE_OPAQUE};
    board = (fxl_billboard){&sprite, Q16(2), Q16(2), Q16(1), Q16(1)};
    memset(model_map, 0, sizeof model_map);
    model_map[2] = 1;
    set = (fxl_billboard_set){&board, 1, model_map};
    for (uint32_t i = 0; i < 256; i++) {
        colours[i] = (uint16_t)(257 * i + 1);
    }
}

void tearDown(void)
{
}

/* words: of the display list. The tree has no memory for pieces. */
static void start(const fxl_order *order, bool is_rgb565, bool has_billboards, uint32_t words)
{
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, is_rgb565 ? &fxl_rgb565 : &fxl_palette);
    config.palette = is_rgb565 ? colours : NULL;
    config.background = BACKGROUND;
    config.order = order;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&made->tiny->scene, NULL));
    config.tree = tree;
    config.tree_size = order->memory_size != NULL
                           ? (order->memory_size(&made->tiny->scene) + 7u) & ~7u
                           : 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &made->tiny->scene, &config, memory,
                                                sizeof memory));
    renderer.frame.display_list.capacity = words;
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_attach_billboards(&renderer, &billboards, has_billboards ? &set : NULL,
                                            is_rgb565 ? FXL_SPRITES_OF(fxl_rgb565)
                                                      : FXL_SPRITES_OF(fxl_palette)));
}

/* A place about the cube of the tree, whose middle is at z = 10. */
static void move_somewhere(void)
{
    made->tiny->instances[0].centre = unit_point(Q16(1.5));
    made->tiny->instances[0].centre.z += Q16(10);
}

/* A face that is drawn whole for lack of memory is in front of what the billboard is in front of,
 * and behind what that is behind. */
void test_a_billboard_is_in_the_leaf_of_its_centre(void)
{
    uint32_t before = 0, behind = 0;
    for (int round = 0; round < UNIT_REPEAT / 100 + 8; round++) {
        move_somewhere();
        start(&fxl_by_tree, false, true, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
        TEST_ASSERT_EQUAL_UINT32(0, ((fxl_bsp_workspace *)renderer.order_memory)->unsplit);
        start(&fxl_by_tree, false, false, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, other, WIDTH));
        for (int i = 0; i < PIXELS; i++) {
            before += frame[i] == SPRITE;
            behind += frame[i] > 10 && frame[i] <= 16;
            if (frame[i] != other[i]) {
                TEST_ASSERT_TRUE(frame_has_near(other, WIDTH, HEIGHT, i, frame[i]));
            }
        }
    }
    TEST_ASSERT_TRUE(before > 1000 && behind > 1000);
}

/* Bands, display lists of any size, RGB565, and every face counted once. */
void test_deliveries_of_billboards_by_tree(void)
{
    for (int round = 0; round < UNIT_REPEAT / 200 + 4; round++) {
        move_somewhere();
        start(&fxl_by_tree, true, true, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, wide, WIDTH));
        start(&fxl_by_tree, false, true, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
        const fxl_counters whole = renderer.workspace.counters;
        for (uint32_t i = 0; i < PIXELS; i++) {
            TEST_ASSERT_EQUAL_HEX16(colours[frame[i]], wide[i]);
        }
        TEST_ASSERT_EQUAL_UINT32(6 + 6 + 1, whole.in);
        for (uint32_t words = 0; words <= 60; words += 12) {
            start(&fxl_by_tree, false, true, words);
            frame_draw_pose(&renderer, &eye, other, 1 + unit_random() % HEIGHT, BACKGROUND);
            TEST_ASSERT_EQUAL_MEMORY(frame, other, sizeof frame);
            TEST_ASSERT_EQUAL_UINT32(whole.in, renderer.workspace.counters.in);
            TEST_ASSERT_EQUAL_UINT32(whole.drawn, renderer.workspace.counters.drawn);
        }
    }
}

/* Where the scene has no tree, it is drawn by distance. */
void test_billboards_by_a_tree_that_the_scene_has_not(void)
{
    made->tiny->scene.bsp_nodes = NULL;
    made->tiny->scene.bsp_node_count = 0;
    made->tiny->scene.bsp_instance = 0;
    made->tiny->instances[0].centre = (fxl_point){0, 0, Q16(8.5)};
    start(&fxl_by_distance, false, true, WORDS);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    start(&fxl_by_tree, false, true, WORDS);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, other, WIDTH));
    TEST_ASSERT_EQUAL_MEMORY(frame, other, sizeof frame);
    TEST_ASSERT_EQUAL_UINT8(SPRITE, frame[HEIGHT / 2 * WIDTH + WIDTH / 2]);
}
