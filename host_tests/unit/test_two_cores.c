/* SPDX-License-Identifier: MIT */
/* Bands of one frame in two workspaces, with all that may be attached: the pixels are those of one
 * workspace, and drawing in another one writes nothing that the renderer's own reads. */
#include "bsp_scene.h"
#include "frame_bands.h"
#include "mapped_quad.h"

enum {
    WIDTH = 40,
    HEIGHT = 30,
    PIXELS = WIDTH * HEIGHT,
    BACKGROUND = 250,
    LEVELS = 4,
    ROOM = 32768,
    SURFACES = 1,
    LIGHT = 2,
    BEAMS = 4,
    SETS = 8
};

static const fxl_pose eye = {{Q16(0.25), Q16(0.5), Q16(5)}, 0, 0, 0};

static fxl_renderer renderer;
static fxl_workspace second;
static FXL_ALIGN_8 uint8_t memory[8192], room[ROOM], beam_room[8192], before[8192 + 8192 + 4096];
static uint64_t tree[512], cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 16) / 8];
static uint8_t frame[PIXELS], other[PIXELS], texels[64], ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)];
static uint8_t brighter[256];
static fxl_surfaces surfaces;
static fxl_light light;
static fxl_lit_surfaces lit;
static fxl_beam beam;
static bsp_scene *made;

static const fxl_texture texture = {.texels = texels, .log_width = 3, .log_height = 3, .levels = 1};
static const fxl_surface surface = {.texture = 1, .opacity = 16, .flags = FXL_SURFACE_LIT};
static fxl_mapped_face mapped[6]; /* the faces of a cube */
static fxl_corner mapped_corners[6][3];
static const fxl_direction normals[1] = {{0, 0, -FXL_Q2_30_ONE}};
static const uint16_t face_map[12] = {1, 2, 0, 0, 5, 6, 1, 0, 3, 0, 5, 0}; /* of both models */
static const fxl_surface_set surface_set = {.textures = &texture,
                                            .surfaces = &surface,
                                            .faces = mapped,
                                            .face_map = face_map,
                                            .corners = mapped_corners[0],
                                            .normals = normals,
                                            .texture_count = 1,
                                            .surface_count = 1,
                                            .face_count = 6,
                                            .corner_count = 18,
                                            .normal_count = 1};
void setUp(void)
{
    const fxl_point from = {0, Q16(9), Q16(9)};
    const fxl_point window[] = {{Q16(-1), Q16(3), Q16(8)},
                                {Q16(-1), Q16(3), Q16(11)},
                                {Q16(1.5), Q16(3), Q16(11)},
                                {Q16(1.5), Q16(3), Q16(8)}};
    made = bsp_make();
    made->tiny->instances[0].centre = (fxl_point){Q16(-1), Q16(0.25), Q16(9)};
    made->tiny->instances[2].centre = (fxl_point){Q16(1.25), Q16(-0.5), Q16(9.5)};
    for (uint32_t f = 0; f < 6; f++) {
        quad_map_face(&mapped[f], mapped_corners[f], 3 * f, &made->tiny->corners[4 * f], Q16(8));
    }
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(100 + i % 7);
    }
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)(i + 16 * (i / 256));
    }
    for (uint32_t i = 0; i < 256; i++) {
        brighter[i] = (uint8_t)(i + 30);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&from, window, 4, &beam));
}

/* scale: of an orthographic lens; 0: the lens has an eye. */
static void start_with(const fxl_order *order, const fxl_target *target, fxl_q16_16 scale,
                       uint32_t set, uint32_t words)
{
    const bool has_depth = target->depth_bits != 0;
    const fxl_light_settings lamp = {.ambient = FXL_Q2_30_ONE / 2, .ramp = ramp, .levels = LEVELS};
    const fxl_beam_set beams = {&beam, 1, brighter};
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, target);
    config.background = BACKGROUND;
    config.order = order;
    config.tree = tree;
    config.tree_size = sizeof tree;
    config.depth = cells;
    config.depth_size = sizeof cells;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&made->tiny->scene, NULL));
    memset(tree, 0, sizeof tree);
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_renderer_init(&renderer, &made->tiny->scene, &config, memory, sizeof memory));
    if (scale != 0) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, scale));
    }
    renderer.frame.display_list.capacity = words;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&renderer, &surfaces,
                                                  set & SURFACES ? &surface_set : NULL,
                                                  has_depth ? FXL_SURFACES_OF(fxl_palette_depth_16)
                                                            : FXL_SURFACES_OF(fxl_palette)));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, set & LIGHT ? &lamp : NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&renderer, set & LIGHT ? &lit : NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(&renderer, set & BEAMS ? &beams : NULL, beam_room,
                                               sizeof beam_room));
}

static void start(const fxl_order *order, const fxl_target *target, uint32_t set, uint32_t words)
{
    start_with(order, target, 0, set, words);
}

/* What the renderer's own workspace works in. The sides of a tree's nodes are found anew in every
 * band, so they are spoiled here. */
static void keep(uint8_t *to)
{
    if (renderer.order == &fxl_by_tree) {
        *(uint32_t *)(void *)((fxl_bsp_workspace *)renderer.order_memory + 1) = 0x15A5A5A5u;
    }
    memcpy(to, memory, sizeof memory);
    memcpy(to + sizeof memory, beam_room, sizeof beam_room);
    memcpy(to + sizeof memory + sizeof beam_room, tree, sizeof tree);
}

static void expect_kept(void)
{
    TEST_ASSERT_EQUAL_MEMORY(before, memory, sizeof memory);
    TEST_ASSERT_EQUAL_MEMORY(before + sizeof memory, beam_room, sizeof beam_room);
    TEST_ASSERT_EQUAL_MEMORY(before + sizeof memory + sizeof beam_room, tree, sizeof tree);
}

/* Bands of 7 rows, every second one in the second workspace. */
static void draw_in_two(void)
{
    const size_t size = fxl_workspace_size(&renderer);
    TEST_ASSERT_TRUE(size > 0 && size + 4000 <= sizeof room);
    memset(room, 0xA5, sizeof room);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, room, size + 4000));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    for (uint32_t row = 0, number = 0; row < HEIGHT; row += 7, number++) {
        const uint32_t rows = HEIGHT - row < 7 ? HEIGHT - row : 7;
        if (number % 2 == 0) {
            keep(before);
            frame_draw_band(&renderer, &second, other, row, rows, BACKGROUND);
            expect_kept();
        } else {
            frame_draw_band(&renderer, &renderer.workspace, other, row, rows, BACKGROUND);
        }
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0xA5, room + size + 4000, sizeof room - size - 4000);
}

/* Surfaces and beams. */
static void expect_split_refused(void)
{
    const char *names[2];
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_frame_begin(&renderer, &eye));
    TEST_ASSERT_TRUE(fxl_renderer_conflict(&renderer, names));
    TEST_ASSERT_EQUAL_STRING("an orthographic lens", names[0]);
    TEST_ASSERT_EQUAL_STRING("surfaces and beams", names[1]);
    const char *sentence = fxl_render_explain(&renderer, &eye, frame, WIDTH, NULL);
    TEST_ASSERT_NOT_NULL(strstr(sentence, names[0]));
    TEST_ASSERT_NOT_NULL(strstr(sentence, names[1]));
}

static void expect_the_frame(const fxl_order *order, const fxl_target *target, fxl_q16_16 scale)
{
    static const uint32_t lists[] = {0, 30, 120, 1200};
    uint32_t whole = 0, sets = 0, shown = 0;
    for (uint32_t set = 0; set < SETS; set++) {
        start_with(order, target, scale, set, 0);
        if (scale != 0 && (set & (SURFACES | BEAMS)) == (SURFACES | BEAMS)) {
            expect_split_refused();
            continue;
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
        for (uint32_t i = 0; i < PIXELS; i++) {
            shown += frame[i] != BACKGROUND;
        }
        sets++;
        for (uint32_t i = 0; i < sizeof lists / sizeof *lists; i++) {
            start_with(order, target, scale, set, lists[i]);
            draw_in_two();
            whole += renderer.frame.resume.instances == renderer.frame.visible_count;
            TEST_ASSERT_EQUAL_MEMORY(frame, other, sizeof frame);
        }
    }
    TEST_ASSERT_TRUE(shown > sets * PIXELS / 10);
    TEST_ASSERT_TRUE(whole >= sets && whole <= 3 * sets); /* other lists had no room for all */
}

static void expect_the_frame_of_one(const fxl_order *order, const fxl_target *target)
{
    expect_the_frame(order, target, 0);
}

/* surfaces 6.3, rgb565 3.6a */
void test_by_distance(void)
{
    expect_the_frame_of_one(&fxl_by_distance, &fxl_palette);
}

/* surfaces 6.3 */
void test_by_distance_with_a_depth_buffer(void)
{
    expect_the_frame_of_one(&fxl_by_distance, &fxl_palette_depth_16);
}

/* orthographic 1.3a, 1.3b */
void test_with_an_orthographic_lens(void)
{
    expect_the_frame(&fxl_by_distance, &fxl_palette, Q16(5));
    expect_the_frame(&fxl_by_distance, &fxl_palette_depth_16, Q16(5));
}

void test_by_a_tree(void)
{
    expect_the_frame_of_one(&fxl_by_tree, &fxl_palette);
    TEST_ASSERT_TRUE(((const fxl_bsp_workspace *)renderer.order_memory)->used > 0);
}

/* A workspace that has no room for the beams is refused, also where they were changed since. */
void test_beams_are_attached_before_a_workspace_is_set_up(void)
{
    const fxl_beam_set beams = {&beam, 1, brighter};
    const fxl_band band = {.pixels = other, .width = WIDTH, .stride = WIDTH, .rows = HEIGHT};
    start(&fxl_by_distance, &fxl_palette, 0, 0);
    const size_t without = fxl_workspace_size(&renderer);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, room, sizeof room));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(&renderer, &beams, beam_room, sizeof beam_room));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw_with(&renderer, &second, &band));
    const size_t with = fxl_workspace_size(&renderer);
    TEST_ASSERT_TRUE(with > without);
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_workspace_init(&second, &renderer, room, with - 1));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, room, with));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_with(&renderer, &second, &band));
}

/* Other beams in the same memory, which need more of a workspace. */
/* surfaces 6.3 */
void test_beams_that_have_grown_are_refused(void)
{
    const fxl_beam two[2] = {beam, beam};
    const fxl_band band = {.pixels = other, .width = WIDTH, .stride = WIDTH, .rows = HEIGHT};
    const fxl_status statuses[] = {FXL_OK, FXL_OK, FXL_E_ORDER};
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_beam_set beams = {two, i < 2 ? 1 : 2, brighter};
        start(&fxl_by_distance, &fxl_palette, 0, 0);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(&renderer, &beams, beam_room, sizeof beam_room));
        if (i == 0) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, room, sizeof room));
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
        TEST_ASSERT_EQUAL(statuses[i], fxl_frame_draw_with(&renderer, &second, &band));
    }
}
