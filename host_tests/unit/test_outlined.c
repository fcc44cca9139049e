/* SPDX-License-Identifier: MIT */
/* Outlines over filled faces, surfaces and billboards, against the frames without outlines. */
#include "frame_bands.h"
#include "tiny.h"
#include "depth_scene.h"
#include "unit.h"

/* Outlines over filled faces, against the frame without outlines. */

enum {
    WIDTH = 32,
    HEIGHT = 24,
    BACKGROUND = 0,
    LINE = 99
};

static uint8_t outlined[HEIGHT][WIDTH], plain[HEIGHT][WIDTH], bands[HEIGHT][WIDTH];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static fxl_renderer renderer;
static fxl_outline_style style;
static fxl_outlines outlines;
static tiny_scene *tiny;

static uint32_t list[200];

/* A display list of some words, or none. */
static void start(bool has_outlines)
{
    const uint32_t words = unit_random() % 2 ? 0 : unit_random() % 200;
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order, TINY_INSTANCES + 6, list, words, NULL, 0};
    lens.inset = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
    if (has_outlines) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, &outlines, &style));
    }
}

static void draw(uint8_t frame[HEIGHT][WIDTH], uint16_t step)
{
    frame_draw_bands(&renderer, frame[0], step, BACKGROUND);
}

static void draw_pose(bool has_outlines, const fxl_pose *pose, uint8_t frame[HEIGHT][WIDTH])
{
    start(has_outlines);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    draw(frame, HEIGHT);
}

static fxl_pose random_pose(void)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(3));
    pose.position.z -= Q16(4);
    pose.yaw = DEGREES(1) * (fxl_angle)unit_between(-40, 40);
    pose.pitch = DEGREES(1) * (fxl_angle)unit_between(-30, 30);
    return pose;
}

/* Where there is no line, the frame is that of the painter's algorithm; in bands it is the same. */
/* wire 3.4a */
void test_lines_lie_over_the_usual_picture(void)
{
    const uint16_t steps[] = {1, 2, 3, 8, 12};
    uint32_t lines = 0, faces = 0;
    style.line = LINE;
    style.keeps_colours = true;
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = random_pose();
        tiny = tiny_make();
        draw_pose(false, &pose, plain);
        draw_pose(true, &pose, outlined);
        draw(bands, steps[unit_random() % 5]);
        TEST_ASSERT_EQUAL_MEMORY(outlined, bands, sizeof bands);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint8_t pixel = outlined[i / WIDTH][i % WIDTH],
                          usual = plain[i / WIDTH][i % WIDTH];
            lines += pixel == LINE;
            faces += pixel != LINE && pixel != BACKGROUND;
            TEST_ASSERT_TRUE(pixel == LINE || pixel == usual);
        }
    }
    TEST_ASSERT_TRUE(lines > 100 && faces > 100);
}

/* A cube before another leaves nothing of it within its faces and edges. */
/* wire 3.1a, 3.1d */
void test_edges_behind_a_face_are_hidden(void)
{
    const fxl_pose pose = {{0, 0, Q16(-3)}, 0, 0, 0};
    style.line = 1;
    style.fill = 2;
    style.keeps_colours = false;
    tiny = tiny_make();
    tiny->scene.instance_count = 1;
    draw_pose(true, &pose, plain);
    tiny->scene.instance_count = TINY_INSTANCES;
    tiny->instances[1].centre.x = Q16(7); /* half of it is beside the first */
    draw_pose(true, &pose, outlined);
    uint32_t others = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const uint8_t both = outlined[i / WIDTH][i % WIDTH], front = plain[i / WIDTH][i % WIDTH];
        others += both != front;
        TEST_ASSERT_TRUE(front == BACKGROUND || both == front);
    }
    TEST_ASSERT_TRUE(others > 2);
}

/* The front face alone, of 16 pixels a side: its edges are on whole pixels, the lower one below the
 * last row that the face reaches. */
/* wire 3.1b */
void test_a_face_and_its_outline(void)
{
    const fxl_pose pose = {{0, 0, Q16(-3)}, 0, 0, 0};
    tiny = tiny_make();
    tiny->scene.instance_count = 1;
    style.line = 1;
    style.fill = 2;
    draw_pose(true, &pose, outlined);
    for (int32_t row = 0; row < HEIGHT; row++) {
        for (int32_t column = 0; column < WIDTH; column++) {
            const bool within = column >= 8 && column < 24 && row >= 4 && row < 20;
            const bool line = ((column == 8 || column == 24) && row >= 4 && row < 20) ||
                              ((row == 4 || row == 19) && column >= 8 && column < 24);
            TEST_ASSERT_EQUAL_UINT8(line ? 1 : within ? 2 : BACKGROUND, outlined[row][column]);
        }
    }
}

/* So near that the face fills the screen: there is no edge within it. */
/* wire 3.2a */
void test_sides_of_the_screen_are_no_edges(void)
{
    const fxl_pose pose = {{0, 0, Q16(-1.5)}, 0, 0, 0};
    tiny = tiny_make();
    style.line = 1;
    style.fill = 2;
    draw_pose(true, &pose, outlined);
    TEST_ASSERT_EACH_EQUAL_UINT8(2, outlined, sizeof outlined);
}

/* The top of a cube from just above it: the near plane cuts it 5.12 pixels below the middle, so that
 * four pixels below is the last row that it reaches. */
/* wire 3.2b */
void test_the_cut_of_the_near_plane_is_an_edge(void)
{
    const fxl_pose pose = {{0, Q16(1.02), 0}, 0, 0, 0};
    const int32_t row = HEIGHT / 2 + 4;
    tiny = tiny_make();
    tiny->scene.instance_count = 1;
    style.line = 1;
    style.fill = 2;
    draw_pose(true, &pose, outlined);
    TEST_ASSERT_EACH_EQUAL_UINT8(2, outlined[row - 1], WIDTH);
    TEST_ASSERT_EACH_EQUAL_UINT8(1, outlined[row], WIDTH);
    TEST_ASSERT_EACH_EQUAL_UINT8(BACKGROUND, outlined[row + 1], WIDTH);
}

void test_another_workspace_takes_the_style(void)
{
    static uint64_t memory[32];
    static fxl_workspace workspace;
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-4)}, 0, 0, 0};
    const fxl_band band = UNIT_BAND(bands[0], WIDTH, 0, HEIGHT);
    tiny = tiny_make();
    style.line = LINE;
    style.keeps_colours = true;
    draw_pose(true, &pose, outlined);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&workspace, &renderer, memory, sizeof memory));
    fxl_fill_band(&band, BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_with(&renderer, &workspace, &band));
    TEST_ASSERT_EQUAL_MEMORY(outlined, bands, sizeof bands);
}

/* Before there is a target, there is none to take the place of. */
void test_outlines_before_a_target(void)
{
    tiny = tiny_make();
    start(false);
    renderer.target = NULL; /* as fxl_renderer_init_bare leaves it */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, &outlines, &style));
    TEST_ASSERT_NULL(renderer.target);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, &outlines, NULL));
    TEST_ASSERT_NULL(renderer.target);
}

/* Outlines over surfaces and billboards, in a palette and in RGB565: against the frames without
 * outlines, and those of outlines alone. */

enum {
    PIXELS = DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT,
    PICTURE_LINE = 77,
    SURFACES = 1,
    BILLBOARDS = 2,
    OUTLINES = 4
};

static const fxl_instance instances[] = {
    {{0, 0, 0}, 0, 0, 0}, {{0, 0, 98304}, 1, 0, 0}, {{-16384, 29491, 81920}, 2, 0, 0}};
static const uint8_t sprite_pixels[] = {41, 42, 43, 44};
static const fxl_sprite sprite = {
    .pixels = sprite_pixels, .width = 2, .height = 2, .bits = 8, .key = FXL_SPRITE_OPAQUE};
static const fxl_billboard board = {&sprite, 32768, 32768, 16384, 16384};
static const uint16_t model_map[DEPTH_SCENE_QUADS] = {0, 0, 1};
static const fxl_billboard_set board_set = {&board, 1, model_map};
static const fxl_outline_style picture_style = {.line = PICTURE_LINE, .keeps_colours = true};

static depth_scene *made;
static uint16_t colours[256], pixels[PIXELS];
static uint8_t all[PIXELS], without[PIXELS], lines[PIXELS];
static fxl_billboards billboards;

void setUp(void)
{
    made = depth_scene_make();
    made->scene.instances = instances;
    made->face_map[1] = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    for (uint32_t i = 0; i < 256; i++) {
        colours[i] = (uint16_t)(i * 257 + 1);
    }
}

static void start_picture(bool is_rgb565, uint32_t set)
{
    fxl_renderer *shown = &made->renderer;
    fxl_config config = made->config;
    config.target = is_rgb565 ? &fxl_rgb565 : &fxl_palette;
    config.palette = is_rgb565 ? colours : NULL;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(shown, &made->scene, &config, made->memory,
                                                sizeof made->memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(shown, &outlines,
                                                  set & OUTLINES ? &picture_style : NULL));
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_attach_surfaces(shown, &made->surfaces, set & SURFACES ? &made->set : NULL,
                                    is_rgb565 ? FXL_SURFACES_OF(fxl_rgb565)
                                              : FXL_SURFACES_OF(fxl_palette)));
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_attach_billboards(shown, &billboards, set & BILLBOARDS ? &board_set : NULL,
                                      is_rgb565 ? FXL_SPRITES_OF(fxl_rgb565)
                                                : FXL_SPRITES_OF(fxl_palette)));
}

static void draw_picture(uint32_t set, uint8_t *to)
{
    start_picture(false, set);
    depth_scene_draw(made, to);
}

static uint32_t count_of(const uint8_t *frame, uint8_t from, uint8_t to)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < PIXELS; i++) {
        count += frame[i] >= from && frame[i] <= to;
    }
    return count;
}

/* Where there is no line, the picture is the one without outlines. Lines are where they are without
 * surfaces. */
/* wire 3.1b */
void test_surfaces_have_the_lines_of_flat_faces(void)
{
    draw_picture(OUTLINES | SURFACES, all);
    draw_picture(SURFACES, without);
    draw_picture(OUTLINES, lines);
    TEST_ASSERT_TRUE(count_of(all, PICTURE_LINE, PICTURE_LINE) * 20 > PIXELS);
    TEST_ASSERT_TRUE(count_of(all, 98, 99) * 20 > PIXELS);
    for (uint32_t i = 0; i < PIXELS; i++) {
        TEST_ASSERT_EQUAL_UINT8(lines[i] == PICTURE_LINE ? PICTURE_LINE : without[i], all[i]);
    }
}

/* A billboard hides the lines behind it, and has none. */
/* wire 3.1c, billboards 4.2e */
void test_a_billboard_is_drawn_in_its_turn(void)
{
    uint32_t hidden = 0;
    draw_picture(OUTLINES | SURFACES | BILLBOARDS, all);
    draw_picture(SURFACES | BILLBOARDS, without);
    made->scene.instance_count = DEPTH_SCENE_QUADS - 1; /* less the billboard's */
    draw_picture(OUTLINES | SURFACES, lines);
    TEST_ASSERT_TRUE(count_of(all, 41, 44) * 20 > PIXELS);
    for (uint32_t i = 0; i < PIXELS; i++) {
        const bool is_sprite = without[i] >= 41 && without[i] <= 44;
        hidden += is_sprite && lines[i] == PICTURE_LINE && all[i] != PICTURE_LINE;
        TEST_ASSERT_TRUE(all[i] == without[i] || (all[i] == PICTURE_LINE && lines[i] == PICTURE_LINE));
    }
    TEST_ASSERT_TRUE(hidden > 0);
}

/* A line has the colour of the picture_style through the palette, and is where it is in bytes. */
/* wire 3.4b */
void test_lines_in_rgb565(void)
{
    for (uint32_t set = 0; set < OUTLINES; set++) {
        draw_picture(set | OUTLINES, all);
        start_picture(true, set | OUTLINES);
        memset(pixels, 0, sizeof pixels);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&made->renderer, &depth_scene_eye, pixels, DEPTH_SCENE_WIDTH));
        for (uint32_t i = 0; i < PIXELS; i++) {
            TEST_ASSERT_EQUAL_HEX16(colours[all[i]], pixels[i]);
        }
    }
}

/* Bands and display lists of any size, and another core's workspace. */
/* wire 3.3c */
void test_deliveries(void)
{
    static uint64_t memory[64];
    fxl_workspace workspace;
    for (uint32_t words = 0; words <= 128; words += 32) {
        start_picture(false, OUTLINES | SURFACES | BILLBOARDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&made->renderer, &depth_scene_eye, made->frame,
                                             DEPTH_SCENE_WIDTH));
        depth_scene_draw_in_bands(made, 4, words);
        depth_scene_draw_in_bands(made, DEPTH_SCENE_HEIGHT, words);
        const fxl_band band = {.pixels = all, .width = DEPTH_SCENE_WIDTH, .stride = DEPTH_SCENE_WIDTH, .rows = DEPTH_SCENE_HEIGHT};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&workspace, &made->renderer, memory,
                                                     sizeof memory));
        fxl_fill_band(&band, DEPTH_SCENE_BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_with(&made->renderer, &workspace, &band));
        TEST_ASSERT_EQUAL_MEMORY(made->frame, all, sizeof all);
    }
}
