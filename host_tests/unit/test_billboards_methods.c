/* SPDX-License-Identifier: MIT */
/* Billboards with surfaces and with a depth buffer, and the methods that they do not go with
 * (docs/extras/billboards.md, section 4). */
#include "frame_bands.h"
#include "tiny.h"
#include "tiny_board.h"
#include "tiny_frames.h"
#include "study/methods.h"

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
static fxl_order_entry order[TINY_INSTANCES];
static fxl_renderer renderer;
static fxl_billboards billboards;
static fxl_sprite sprite;
static fxl_billboard board;
static uint16_t model_map[2];
static fxl_billboard_set set;
static fxl_surface surface;
static fxl_mapped_face mapped;
static uint16_t face_map[7];
static uint8_t blend[FXL_BLEND_TABLE_BYTES(8)];
static fxl_surface_set surface_set;
static fxl_surfaces surfaces;
static fxl_depth depth;
static FXL_ALIGN_8 uint8_t cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 32)];
static tiny_scene *tiny;
static fxl_turn turns[1];

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
    tiny->scene.turns = turns;
    tiny->scene.first_turned = 1;
    tiny->scene.turn_code = &fxl_turned_instances;
    turns[0] = (fxl_turn)FXL_TURN_NONE;
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_orientation_from_angles(DEGREES(40), DEGREES(25), 0, &turns[0].orientation));
    tiny_board(&set, &board, model_map, &sprite, texels, SPRITE_WIDTH, SPRITE_HEIGHT);
    surface = (fxl_surface){.opacity = 16};
    mapped = (fxl_mapped_face){.corners = {0, 1, 2}};
    memset(face_map, 0, sizeof face_map);
    surface_set = (fxl_surface_set){.surfaces = &surface,
                                    .faces = &mapped,
                                    .face_map = face_map,
                                    .surface_count = 1,
                                    .face_count = 1};
}

void tearDown(void)
{
}

static void start(uint32_t words)
{
    const fxl_memory memory = {order, TINY_INSTANCES, list, words, NULL, 0};
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
}

/* A method; null: fxl_visibility_sorted. */
static void choose(const fxl_visibility *method, bool with_surfaces)
{
    if (with_surfaces) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_surfaces(&renderer, &surfaces, &surface_set));
    }
    if (method != NULL) {
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_renderer_set_depth(&renderer, &depth, method, cells, sizeof cells));
    }
}

static fxl_status add(const fxl_visibility *method)
{
    return method != NULL ? fxl_renderer_set_billboards_by_depth(&renderer, &billboards, &set)
                          : fxl_renderer_set_billboards(&renderer, &billboards, &set);
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
static void expect_depth_of_stand_in(const fxl_visibility *method)
{
    uint32_t shown = 0, hidden = 0;
    for (uint32_t i = 0; i < UNIT_REPEAT / 200 + 4; i++) {
        const fxl_pose pose = {{unit_between(-Q16(1), Q16(1)), unit_between(-Q16(1), Q16(1)),
                                -Q16(3) - unit_between(0, Q16(3))},
                               0,
                               0,
                               0};
        start(i % 2 * LIST_WORDS);
        choose(method, i % 3 == 0);
        draw(other, &pose, HEIGHT);
        TEST_ASSERT_EQUAL(FXL_OK, add(method));
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

void test_a_billboard_has_the_depth_of_its_instance(void)
{
    expect_depth_of_stand_in(&fxl_visibility_depth);
    expect_depth_of_stand_in(&fxl_visibility_depth_32);
}

/* With a blended surface depth goes far to near, and in two passes. */
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
    choose(NULL, true);
    TEST_ASSERT_EQUAL(FXL_OK, add(NULL));
    draw(whole, &pose, HEIGHT);
    TEST_ASSERT_TRUE(is_sprite(whole[HEIGHT / 2 * WIDTH + WIDTH / 2]));
    start(0);
    choose(&fxl_visibility_depth, true);
    TEST_ASSERT_EQUAL(FXL_OK, add(&fxl_visibility_depth));
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
    static const fxl_visibility *const methods[] = {NULL, &fxl_visibility_depth,
                                                    &fxl_visibility_depth_32};
    uint32_t shown = 0;
    tiny->instances[0].centre.z = Q16(9);
    for (uint32_t i = 0; i < UNIT_REPEAT / 200 + 4; i++) {
        fxl_pose pose = unit_pose();
        pose.position = unit_point(Q16(6));
        pose.position.z += i % 2 ? Q16(17) : -Q16(8);
        pose.yaw = (i % 2 ? DEGREES(180) : 0) + DEGREES(1) * (fxl_angle)unit_between(-20, 20);
        pose.pitch = DEGREES(1) * (fxl_angle)unit_between(-20, 20);
        sprite.key = (uint16_t)(100 + unit_random() % sizeof texels);
        turns[0].scale = unit_between(Q16(0.5), Q16(1.5));
        start(0);
        TEST_ASSERT_EQUAL(FXL_OK, add(NULL));
        draw(whole, &pose, HEIGHT);
        for (uint32_t k = 0; k < WIDTH * HEIGHT; k++) {
            shown += is_sprite(whole[k]);
        }
        for (uint32_t k = 0; k < 6; k++) {
            start(unit_random() % LIST_WORDS);
            choose(methods[k % 3], k >= 3);
            TEST_ASSERT_EQUAL(FXL_OK, add(methods[k % 3]));
            draw(other, &pose, 6);
            TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        }
    }
    TEST_ASSERT_TRUE(shown > 100);
}

/* A frame whose scene is released draws its billboards without the scene. */
void test_a_released_frame_draws_its_billboards(void)
{
    static const fxl_visibility *const methods[] = {NULL, &fxl_visibility_depth};
    const fxl_pose pose = {{0, 0, -Q16(5)}, 0, 0, 0};
    for (uint32_t i = 0; i < 4; i++) {
        const fxl_band band = {.pixels = other, .width = WIDTH, .stride = WIDTH, .first_row = 0,
                               .rows = HEIGHT};
        start(LIST_WORDS);
        choose(methods[i / 2], i % 2);
        TEST_ASSERT_EQUAL(FXL_OK, add(methods[i / 2]));
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
    static const fxl_visibility *const methods[] = {NULL, &fxl_visibility_depth,
                                                    &fxl_visibility_depth_32};
    static fxl_renderer moved;
    const fxl_pose pose = {{0, 0, Q16(-6)}, 0, 0, 0};
    const fxl_band band = {.pixels = other, .width = WIDTH, .stride = WIDTH, .first_row = 0,
                           .rows = HEIGHT};
    for (uint32_t i = 0; i < 6; i++) {
        start(i % 2 * LIST_WORDS);
        choose(methods[i % 3], true);
        TEST_ASSERT_EQUAL(FXL_OK, add(methods[i % 3]));
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
void test_billboards_are_taken_away(void)
{
    static const fxl_visibility *const methods[] = {NULL, &fxl_visibility_depth};
    const fxl_pose pose = {{0, 0, Q16(-6)}, 0, 0, 0};
    for (uint32_t i = 0; i < 2; i++) {
        start(LIST_WORDS);
        choose(methods[i], true);
        const fxl_order *before = renderer.order;
        void *const memory = renderer.workspace.target_memory;
        draw(whole, &pose, HEIGHT);
        TEST_ASSERT_EQUAL(FXL_OK, add(methods[i]));
        TEST_ASSERT_EQUAL(FXL_OK, add(methods[i])); /* twice is once */
        TEST_ASSERT_EQUAL_PTR(memory, renderer.workspace.target_memory);
        draw(other, &pose, HEIGHT);
        TEST_ASSERT_TRUE(memcmp(whole, other, sizeof whole) != 0);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_billboards(&renderer, NULL, NULL));
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

static void expect_no_method(const fxl_visibility *method)
{
    start(0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_visibility(&renderer, method, cells, sizeof cells));
    expect_refused(FXL_E_ORDER, fxl_renderer_set_billboards(&renderer, &billboards, &set));
    expect_refused(FXL_E_ORDER, fxl_renderer_set_billboards_by_depth(&renderer, &billboards, &set));
    TEST_ASSERT_TRUE(method->target == renderer.target && method->order == renderer.order);
}

static bool no_submit(const fxl_traversal *on)
{
    (void)on;
    return true;
}

void test_other_methods_take_no_billboards(void)
{
    expect_no_method(&fxl_visibility_spans);
    expect_no_method(&fxl_visibility_box);
    fxl_visibility own = fxl_visibility_sorted; /* another order, over what was drawn before */
    static const fxl_order none = {.submit = no_submit};
    own.order = &none;
    expect_no_method(&own);
    start(0);
    choose(&fxl_visibility_depth, false);
    expect_refused(FXL_E_ORDER, fxl_renderer_set_billboards(&renderer, &billboards, &set));
    TEST_ASSERT_TRUE(fxl_visibility_depth.target == renderer.target && fxl_visibility_depth.order == renderer.order);
    start(0);
    expect_refused(FXL_E_ORDER, fxl_renderer_set_billboards_by_depth(&renderer, &billboards, &set));
    choose(NULL, true);
    expect_refused(FXL_E_ORDER, fxl_renderer_set_billboards_by_depth(&renderer, &billboards, &set));
    TEST_ASSERT_TRUE(fxl_visibility_surfaces.target == renderer.target && fxl_visibility_surfaces.order == renderer.order);
}

/* A call that takes billboards away where there are none, on a frame that has begun. */
static void expect_nothing_to_take(void)
{
    static fxl_renderer before;
    const fxl_pose pose = {{0, 0, -Q16(5)}, 0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    before = renderer;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_billboards(&renderer, NULL, NULL));
    TEST_ASSERT_EQUAL_MEMORY(&before, &renderer, sizeof before);
}

static void expect_removal_keeps(const fxl_visibility *method)
{
    start(0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_visibility(&renderer, method, cells, sizeof cells));
    expect_nothing_to_take();
}

/* The second removal of two, and a removal from a method that draws none. */
void test_a_removal_where_there_are_none_changes_nothing(void)
{
    expect_removal_keeps(&fxl_visibility_sorted);
    expect_removal_keeps(&fxl_visibility_spans);
    expect_removal_keeps(&fxl_visibility_box);
    expect_removal_keeps(&fxl_visibility_outlined);
    fxl_visibility own = fxl_visibility_sorted;
    expect_removal_keeps(&own);
    for (int with_surfaces = 0; with_surfaces < 2; with_surfaces++) {
        const fxl_visibility *const methods[] = {NULL, &fxl_visibility_depth,
                                                 &fxl_visibility_depth_32};
        for (uint32_t i = 0; i < 3; i++) {
            start(0);
            choose(methods[i], with_surfaces != 0);
            expect_nothing_to_take();
            const fxl_order *const before = renderer.order;
            TEST_ASSERT_EQUAL(FXL_OK, add(methods[i]));
            TEST_ASSERT_TRUE(before != renderer.order);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_billboards(&renderer, NULL, NULL));
            TEST_ASSERT_EQUAL_PTR(before, renderer.order);
            expect_nothing_to_take();
        }
    }
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order, TINY_INSTANCES, list, 0, NULL, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_bare(&renderer, &tiny->scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_billboards(&renderer, NULL, NULL));
    TEST_ASSERT_TRUE(renderer.target == NULL && renderer.order == NULL);
    memset(&renderer, 0, sizeof renderer);
    expect_refused(FXL_E_ORDER, fxl_renderer_set_billboards(&renderer, NULL, NULL));
}

/* The faces of every model are looked at, with the number that they have in the scene. */
void test_surfaces_of_the_last_model_are_checked(void)
{
    fxl_scene_fault fault;
    const fxl_model *last = &tiny->scene.models[tiny->scene.model_count - 1];
    TEST_ASSERT_TRUE(tiny->scene.model_count > 1 && last->first_face < sizeof face_map / 2);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_surfaces_check(&surface_set, &tiny->scene, &fault));
    face_map[last->first_face] = 2;
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_surfaces_check(&surface_set, &tiny->scene, &fault));
    TEST_ASSERT_EQUAL_STRING("face", fault.what);
    TEST_ASSERT_EQUAL_UINT32(last->first_face, fault.index);
}

void test_wrong_arguments_with_depth(void)
{
    start(0);
    choose(&fxl_visibility_depth, false);
    expect_refused(FXL_E_ARGUMENT, fxl_renderer_set_billboards_by_depth(&renderer, NULL, &set));
    expect_refused(FXL_E_ARGUMENT,
                   fxl_renderer_set_billboards_by_depth(&renderer, &billboards, NULL));
    fxl_billboards *const odd = (fxl_billboards *)(void *)((uint8_t *)&billboards + 1);
    expect_refused(FXL_E_ALIGNMENT, fxl_renderer_set_billboards_by_depth(&renderer, odd, &set));
    sprite.bits = 3;
    expect_refused(FXL_E_RANGE, fxl_renderer_set_billboards_by_depth(&renderer, &billboards, &set));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_renderer_set_billboards_by_depth(NULL, &billboards, &set));
    memset(&renderer, 0, sizeof renderer);
    expect_refused(FXL_E_ORDER, fxl_renderer_set_billboards_by_depth(&renderer, &billboards, &set));
}
