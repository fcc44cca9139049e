/* SPDX-License-Identifier: MIT */
/* Billboards with surfaces and with a depth buffer, and what they do not go with
 * (docs/extras/billboards.md, section 4). */
#include "choices.h"
#include "frame_bands.h"
#include "tiny.h"
#include "tiny_frames.h"
#include "study/targets.h"

enum {
    WIDTH = 32,
    HEIGHT = 24,
    BACKGROUND = 250,
    STAND_IN = 15, /* the colour of the face that a billboard stands for */
    SPRITE_WIDTH = 9,
    SPRITE_HEIGHT = 6,
    LIST_WORDS = 400
};

static uint8_t whole[HEIGHT * WIDTH], other[HEIGHT * WIDTH];
static uint8_t texels[SPRITE_HEIGHT * SPRITE_WIDTH];
static uint32_t list[LIST_WORDS];
static fxl_draw_entry order[TINY_INSTANCES];
static fxl_renderer renderer;
static fxl_billboards billboards;
static fxl_sprite sprite;
static fxl_billboard board;
static uint16_t model_map[2];
static fxl_billboard_set set;
static fxl_surface surface;
static fxl_mapped_face mapped;
static const fxl_corner corners[3] = {{{0, 0}, 0, 0}, {{0, 0}, 1, 0}, {{0, 0}, 2, 0}};
static uint16_t face_map[7];
static uint8_t blend[FXL_BLEND_TABLE_BYTES(8)];
static fxl_surface_set surface_set;
static fxl_surfaces surfaces;
static FXL_ALIGN_8 uint8_t cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 32)];
static tiny_scene *tiny;
static fxl_placement placements[1];

/* Instance 0 shows a sprite of 4 x 3 units; its face is a rectangle of that size across z. Instance
 * 1 is a cube that is turned. */
void setUp(void)
{
    tiny = tiny_make();
    for (uint32_t v = 8; v < 16; v++) {
        tiny->vertices[v] = (fxl_point){v & 4 ? Q16(2) : Q16(-2), v & 2 ? Q16(1.5) : Q16(-1.5), 0};
    }
    tiny->faces[6] = tiny->faces[10]; /* that towards -z */
    tiny->models[1] = (fxl_model){.first_vertex = 8,
                                  .vertex_count = 8,
                                  .first_face = 6,
                                  .face_count = 1,
                                  .kind = FXL_MODEL_CONVEX,
                                  .radius = Q16(2.5)};
    tiny->scene.face_count = 7;
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    tiny->instances[0] = (fxl_instance){{0, 0, 0}, 1, 0, 0};
    tiny->instances[1] = (fxl_instance){{Q16(0.5), Q16(0.25), Q16(0.125)}, 0, 0, 0};
    tiny->scene.instance_count = 2;
    tiny->scene.placements = placements;
    tiny->scene.first_turned = 1;
    tiny->scene.placement_code = &fxl_turned_instances;
    placements[0] = (fxl_placement)FXL_PLACEMENT_NONE;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_angles(DEGREES(40), DEGREES(25), 0,
                                                          &placements[0].orientation));
    tiny_board(&set, &board, model_map, &sprite, texels, SPRITE_WIDTH, SPRITE_HEIGHT);
    surface = (fxl_surface){.opacity = 16};
    mapped = (fxl_mapped_face){.corners = {0, 1, 2}};
    memset(face_map, 0, sizeof face_map);
    surface_set = (fxl_surface_set){.surfaces = &surface,
                                    .faces = &mapped,
                                    .face_map = face_map,
                                    .corners = corners,
                                    .surface_count = 1,
                                    .face_count = 1,
                                    .corner_count = 3};
}

static void start(uint32_t words)
{
    const fxl_memory memory = {order, TINY_INSTANCES, list, words, NULL, 0};
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
}

/* A target, and what draws into it. */
typedef struct {
    const choice *pair;
    const fxl_painter *surfaces;
    const fxl_sprite_painter *sprites;
} way;

#define WAY(pair, target) \
    { \
        &pair, FXL_SURFACES_OF(target), FXL_SPRITES_OF(target) \
    }

static const way ways[] = {WAY(choice_sorted, fxl_palette),
                           WAY(choice_depth_16, fxl_palette_depth_16),
                           WAY(choice_depth_32, fxl_palette_depth_32)};

static void choose(const way *into, bool with_surfaces)
{
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, into->pair, cells, sizeof cells));
    if (with_surfaces) {
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_attach_surfaces(&renderer, &surfaces, &surface_set, into->surfaces));
    }
}

static fxl_status add(const way *into)
{
    return fxl_attach_billboards(&renderer, &billboards, &set, into->sprites);
}

static void draw(uint8_t *frame, const fxl_pose *pose, uint16_t step)
{
    frame_draw_pose(&renderer, pose, frame, step, BACKGROUND);
}

static bool is_sprite(uint8_t pixel)
{
    return pixel >= 100 && pixel < BACKGROUND;
}

/* --- the depth -------------------------------------------------------------------------------- */

/* A billboard that a cube intersects is seen where its stand-in, a face across the line of sight,
 * is seen. */
static void expect_depth_of_stand_in(const way *into)
{
    uint32_t shown = 0, hidden = 0;
    for (uint32_t i = 0; i < UNIT_REPEAT / 200 + 4; i++) {
        const fxl_pose pose = {{unit_between(-Q16(1), Q16(1)), unit_between(-Q16(1), Q16(1)),
                                -Q16(3) - unit_between(0, Q16(3))},
                               0,
                               0,
                               0};
        start(i % 2 * LIST_WORDS);
        choose(into, i % 3 == 0);
        draw(other, &pose, HEIGHT);
        TEST_ASSERT_EQUAL(FXL_OK, add(into));
        draw(whole, &pose, (uint16_t)(i % 4 == 0 ? 3 : HEIGHT));
        for (uint32_t k = 0; k < WIDTH * HEIGHT; k++) {
            TEST_ASSERT_EQUAL(other[k] == STAND_IN, is_sprite(whole[k]));
            shown += other[k] == STAND_IN;
            hidden += other[k] <= 6;
            if (other[k] != STAND_IN) {
                TEST_ASSERT_EQUAL(other[k], whole[k]);
            }
        }
    }
    TEST_ASSERT_TRUE(shown > 100 && hidden > 20);
}

/* billboards 4.2c */
void test_a_billboard_has_the_depth_of_its_instance(void)
{
    expect_depth_of_stand_in(&ways[1]);
    expect_depth_of_stand_in(&ways[2]);
}

/* With a blended surface depth goes far to near, and in two passes. */
/* billboards 4.2 */
void test_depth_with_blended_surfaces(void)
{
    surface.flags = FXL_SURFACE_BLEND;
    for (uint32_t i = 0; i < sizeof blend; i++) {
        blend[i] = (uint8_t)(i ^ 1); /* what is beneath, but for its last bit */
    }
    surface_set.blend = blend;
    surface_set.blend_count = 8;
    tiny->instances[1].centre.z = Q16(-5); /* the cube: before the sprite */
    const fxl_pose pose = {{0, 0, Q16(-11)}, 0, 0, 0};
    for (uint32_t i = 0; i < 6; i++) {
        face_map[i] = 1;
    }
    start(LIST_WORDS);
    choose(&ways[0], true);
    TEST_ASSERT_EQUAL(FXL_OK, add(&ways[0]));
    draw(whole, &pose, HEIGHT);
    TEST_ASSERT_TRUE(is_sprite(whole[HEIGHT / 2 * WIDTH + WIDTH / 2]));
    start(0);
    choose(&ways[1], true);
    TEST_ASSERT_EQUAL(FXL_OK, add(&ways[1]));
    draw(other, &pose, 8);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    /* Its middle is behind the sprite, its front before it. */
    tiny->instances[1].centre = (fxl_point){0, 0, Q16(0.25)};
    draw(other, &pose, 8);
    tiny->scene.instance_count = 1;
    draw(whole, &pose, 8);
    TEST_ASSERT_TRUE(is_sprite(whole[HEIGHT / 2 * WIDTH + WIDTH / 2]));
    TEST_ASSERT_EQUAL(whole[HEIGHT / 2 * WIDTH + WIDTH / 2] ^ 1,
                      other[HEIGHT / 2 * WIDTH + WIDTH / 2]);
}

/* --- all methods ------------------------------------------------------------------------------ */

/* Of instances that are far apart each method draws the same frame, also through the holes of a
 * sprite. */
void test_every_method_draws_the_same(void)
{
    uint32_t shown = 0;
    tiny->instances[0].centre.z = Q16(9);
    for (uint32_t i = 0; i < UNIT_REPEAT / 200 + 4; i++) {
        fxl_pose pose = unit_pose();
        pose.position = unit_point(Q16(6));
        pose.position.z += i % 2 ? Q16(17) : -Q16(8);
        pose.yaw = (i % 2 ? DEGREES(180) : 0) + DEGREES(1) * (fxl_angle)unit_between(-20, 20);
        pose.pitch = DEGREES(1) * (fxl_angle)unit_between(-20, 20);
        sprite.key = (uint16_t)(100 + unit_random() % sizeof texels);
        placements[0].scale = unit_between(Q16(0.5), Q16(1.5));
        start(0);
        TEST_ASSERT_EQUAL(FXL_OK, add(&ways[0]));
        draw(whole, &pose, HEIGHT);
        for (uint32_t k = 0; k < WIDTH * HEIGHT; k++) {
            shown += is_sprite(whole[k]);
        }
        for (uint32_t k = 0; k < 6; k++) {
            start(unit_random() % LIST_WORDS);
            choose(&ways[k % 3], k >= 3);
            TEST_ASSERT_EQUAL(FXL_OK, add(&ways[k % 3]));
            draw(other, &pose, 6);
            TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        }
    }
    TEST_ASSERT_TRUE(shown > 100);
}

/* A frame whose scene is released draws its billboards without the scene. */
void test_a_released_frame_draws_its_billboards(void)
{
    const fxl_pose pose = {{0, 0, -Q16(5)}, 0, 0, 0};
    for (uint32_t i = 0; i < 4; i++) {
        const fxl_band band = UNIT_BAND(other, WIDTH, 0, HEIGHT);
        start(LIST_WORDS);
        choose(&ways[i / 2], i % 2);
        TEST_ASSERT_EQUAL(FXL_OK, add(&ways[i / 2]));
        draw(whole, &pose, HEIGHT);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(&renderer));
        renderer.scene = NULL;
        fxl_fill_band(&band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    }
}

/* With surfaces, depth and billboards a renderer may be moved too. */
void test_a_moved_renderer_draws_the_same(void)
{
    static fxl_renderer moved;
    const fxl_pose pose = {{0, 0, Q16(-6)}, 0, 0, 0};
    const fxl_band band = UNIT_BAND(other, WIDTH, 0, HEIGHT);
    for (uint32_t i = 0; i < 6; i++) {
        start(i % 2 * LIST_WORDS);
        choose(&ways[i % 3], true);
        TEST_ASSERT_EQUAL(FXL_OK, add(&ways[i % 3]));
        draw(whole, &pose, HEIGHT);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        moved = renderer;
        memset(&renderer, 0x5A, sizeof renderer);
        fxl_fill_band(&band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&moved, &band));
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &renderer, sizeof renderer);
    }
}

/* Taken away, the method and its memory are as before. */
/* combinations 1.4, billboards 4.2g */
void test_billboards_are_taken_away(void)
{
    const fxl_pose pose = {{0, 0, Q16(-6)}, 0, 0, 0};
    for (uint32_t i = 0; i < 2; i++) {
        start(LIST_WORDS);
        choose(&ways[i], true);
        const fxl_order *before = renderer.order;
        void *const memory = renderer.workspace.target_memory;
        draw(whole, &pose, HEIGHT);
        TEST_ASSERT_EQUAL(FXL_OK, add(&ways[i]));
        TEST_ASSERT_EQUAL(FXL_OK, add(&ways[i])); /* twice is once */
        TEST_ASSERT_EQUAL_PTR(memory, renderer.workspace.target_memory);
        draw(other, &pose, HEIGHT);
        TEST_ASSERT_TRUE(memcmp(whole, other, sizeof whole) != 0);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&renderer, NULL, NULL, NULL));
        TEST_ASSERT_EQUAL_PTR(before, renderer.order);
        TEST_ASSERT_EQUAL_PTR(memory, renderer.workspace.target_memory);
        draw(other, &pose, HEIGHT);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    }
}

/* --- what is refused -------------------------------------------------------------------------- */

static void expect_refused(fxl_status status, fxl_status answer)
{
    TEST_ASSERT_EQUAL(status, answer);
    TEST_ASSERT_EQUAL_UINT32(1, renderer.workspace.counters.refused_calls);
    renderer.workspace.counters.refused_calls = 0;
}

/* Begins no frame. */
static void expect_conflict(const char *with)
{
    const fxl_pose pose = {{0, 0, -Q16(5)}, 0, 0, 0};
    const char *names[2];
    expect_refused(FXL_E_COMBINATION, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_TRUE(fxl_renderer_conflict(&renderer, names));
    TEST_ASSERT_EQUAL_STRING(with, names[0]);
    TEST_ASSERT_EQUAL_STRING("billboards", names[1]);
}

void test_what_billboards_do_not_go_with(void)
{
    static const struct {
        const choice *pair;
        const char *name;
    } others[] = {{&choice_spans, "a target of the study"}, {&choice_box, "a target of the study"}};
    for (uint32_t i = 0; i < 2; i++) {
        start(0);
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, others[i].pair, cells, sizeof cells));
        TEST_ASSERT_EQUAL(FXL_OK, add(&ways[0]));
        expect_conflict(others[i].name);
    }
}

/* The second removal of two, and a removal where there were none: a frame that has begun stays. */
void test_a_removal_where_there_are_none_changes_nothing(void)
{
    const fxl_pose pose = {{0, 0, -Q16(5)}, 0, 0, 0};
    for (uint32_t i = 0; i < 6; i++) {
        start(0);
        choose(&ways[i % 3], i >= 3);
        const fxl_order *const before = renderer.order;
        for (uint32_t removals = 0; removals < 2; removals++) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&renderer, NULL, NULL, NULL));
            TEST_ASSERT_EQUAL(FXL_FRAME_BEGUN, renderer.frame.state);
            TEST_ASSERT_EQUAL_PTR(before, renderer.order);
            TEST_ASSERT_EQUAL(FXL_OK, add(&ways[i % 3]));
            TEST_ASSERT_EQUAL(FXL_FRAME_NONE, renderer.frame.state);
            TEST_ASSERT_TRUE(before != renderer.order);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&renderer, NULL, NULL, NULL));
        }
    }
}

/* The faces of every model are looked at, with the number that they have in the scene. */
void test_surfaces_of_the_last_model_are_checked(void)
{
    fxl_scene_fault fault;
    const fxl_model *last = &tiny->scene.models[tiny->scene.model_count - 1];
    TEST_ASSERT_TRUE(tiny->scene.model_count > 1 && last->first_face < sizeof face_map / 2);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_surfaces_check(&surface_set, &tiny->scene, 8, &fault));
    face_map[last->first_face] = 2;
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_surfaces_check(&surface_set, &tiny->scene, 8, &fault));
    TEST_ASSERT_EQUAL_STRING("face", fault.what);
    TEST_ASSERT_EQUAL_UINT32(last->first_face, fault.index);
}

void test_wrong_arguments_with_depth(void)
{
    const fxl_sprite_painter *const sprites = ways[1].sprites;
    start(0);
    choose(&ways[1], false);
    expect_refused(FXL_E_ARGUMENT, fxl_attach_billboards(&renderer, NULL, &set, sprites));
    expect_refused(FXL_E_ARGUMENT, fxl_attach_billboards(&renderer, &billboards, &set, NULL));
    fxl_billboards *const odd = (fxl_billboards *)(void *)((uint8_t *)&billboards + 1);
    expect_refused(FXL_E_ALIGNMENT, fxl_attach_billboards(&renderer, odd, &set, sprites));
    sprite.bits = 3;
    expect_refused(FXL_E_RANGE, fxl_attach_billboards(&renderer, &billboards, &set, sprites));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_billboards(NULL, &billboards, &set, sprites));
    memset(&renderer, 0, sizeof renderer);
    expect_refused(FXL_E_ORDER, fxl_attach_billboards(&renderer, &billboards, &set, sprites));
}
