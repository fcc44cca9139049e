/* SPDX-License-Identifier: MIT */
/* Light and fog, against the definitions in double (docs/extras/light.md). */
#include <math.h>

#include "frame_bands.h"
#include "../../lib/draw/submit.h"
#include "../../lib/paint/light_level.h"
#include "exact_light.h"
#include "tiny.h"
#include "tiny_frames.h"

enum {
    WIDTH = 24,
    HEIGHT = 16,
    BACKGROUND = 255,
    LEVELS = 8
};

static uint8_t frames[3][WIDTH * HEIGHT];
static uint8_t ramp[256 * LEVELS];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static fxl_renderer renderer;
static fxl_light light;

/* Not at the same time: a board has 16 KB. */
static union {
    FXL_ALIGN_8 uint8_t beams[2400];
    fxl_workspace second;
} memory_of;

/* --- brightness and level ---------------------------------------------------------------- */

static fxl_camera any_camera(void)
{
    fxl_pose pose = unit_pose();
    fxl_camera camera;
    pose.position = (fxl_point){unit_between(-Q16(99), Q16(99)), 0, unit_between(-Q16(99), 0)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
    return camera;
}

static double worst;

/* place light: that the library keeps to FXL_LIGHT_ERROR_MAX */
/* The brightness and its level are within the bound of the exact ones. */
static void expect_level(const fxl_light_settings *of, double exact, uint32_t level)
{
    const double bound = FXL_LIGHT_ERROR_MAX / (double)FXL_Q2_30_ONE;
    const double top = of->levels - 1;
    TEST_ASSERT_TRUE(level < of->levels);
    TEST_ASSERT_TRUE(level >= floor((exact - bound) * top + 0.5));
    TEST_ASSERT_TRUE(level <= floor((exact + bound) * top + 0.5));
}

static double exact_of(const fxl_light_settings *of, const fxl_camera *camera,
                       const fxl_lit_place *place)
{
    return exact_brightness(of, camera, exact_point(&place->middle, 1.0 / 131072),
                            exact_direction(&place->normal));
}

/* light 2.2, 2.3, 2.4a-c, 2.5a, accuracy 1.2f */
void test_brightness_is_that_of_the_definition(void)
{
    uint32_t between = 0;
    worst = 0;
    for (uint32_t i = 0; i < UNIT_REPEAT; i++) {
        const fxl_point about = {unit_between(-Q16(50), Q16(50)), unit_between(-Q16(50), Q16(50)),
                                 unit_between(-Q16(50), Q16(50))};
        const fxl_light_settings of = exact_light_any(ramp, &about);
        const fxl_camera camera = any_camera();
        const fxl_lit_place place = {
            unit_direction(),
            {2 * about.x + unit_between(0, 1), 2 * about.y, 2 * about.z + unit_between(0, 1)}};
        const double exact = exact_of(&of, &camera, &place);
        const fxl_q2_30 found = fxl_light_brightness(&of, &camera, &place);
        const double error = fabs(found - exact * FXL_Q2_30_ONE);
        worst = error > worst ? error : worst;
        between += found > 0 && found < FXL_Q2_30_ONE;
        TEST_ASSERT_TRUE(found >= 0 && found <= FXL_Q2_30_ONE);
        TEST_ASSERT_NEAR(exact * FXL_Q2_30_ONE, found, FXL_LIGHT_ERROR_MAX);
        expect_level(&of, exact, fxl_light_level(found, of.levels));
    }
    TEST_ASSERT_TRUE(between > UNIT_REPEAT / 4);
    TEST_ASSERT_TRUE(worst > 2); /* the bound is no wild guess */
}

/* At the ends of the ranges: the farthest corners of the world, the shortest and longest ranges. */
/* light 2.2, 2.3, 2.4a-b */
void test_brightness_at_the_ends_of_the_ranges(void)
{
    const int32_t end = FXL_COORDINATE_MAX;
    for (uint32_t i = 0; i < UNIT_REPEAT / 10; i++) {
        const fxl_point corner = {unit_between(0, 1) ? end : -end, unit_between(0, 1) ? end : -end,
                                  unit_between(0, 1) ? end : -end};
        fxl_light_settings of = exact_light_any(ramp, &corner);
        fxl_camera camera = any_camera();
        for (uint32_t k = 0; k < of.point_count; k++) {
            of.points[k].position = unit_point(end);
            of.points[k].range = unit_between(0, 3) ? end : 1;
        }
        of.fog_far = unit_between(0, 1) ? FXL_FAR_MAX : of.fog_far;
        camera.position = unit_point(end);
        const fxl_lit_place place = {unit_direction(), {2 * corner.x, 2 * corner.y, 2 * corner.z}};
        TEST_ASSERT_NEAR(exact_of(&of, &camera, &place) * FXL_Q2_30_ONE,
                         fxl_light_brightness(&of, &camera, &place), FXL_LIGHT_ERROR_MAX);
    }
}

/* light 2.5b-c */
void test_levels_are_the_nearest(void)
{
    TEST_ASSERT_EQUAL_UINT32(0, fxl_light_level(0, 2));
    TEST_ASSERT_EQUAL_UINT32(0, fxl_light_level(FXL_Q2_30_ONE / 2 - 1, 2));
    TEST_ASSERT_EQUAL_UINT32(1, fxl_light_level(FXL_Q2_30_ONE / 2, 2));
    TEST_ASSERT_EQUAL_UINT32(1, fxl_light_level(FXL_Q2_30_ONE, 2));
    TEST_ASSERT_EQUAL_UINT32(63, fxl_light_level(FXL_Q2_30_ONE, 64));
    TEST_ASSERT_EQUAL_UINT32(62, fxl_light_level(FXL_Q2_30_ONE - FXL_Q2_30_ONE / 100, 64));
}

/* --- frames ------------------------------------------------------------------------------- */

/* Colour c, which is 1..16, at a level. */
static uint8_t at_level(uint32_t colour, uint32_t level)
{
    return (uint8_t)(colour + 20 * level);
}

static tiny_scene *start(void)
{
    const fxl_memory memory = {order, TINY_INSTANCES + 6, NULL, 0, NULL, 0};
    tiny_scene *tiny = tiny_make();
    for (uint32_t level = 0; level < LEVELS; level++) {
        for (uint32_t c = 0; c < 256; c++) {
            ramp[256 * level + c] = at_level(c, level);
        }
    }
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
    return tiny;
}

static void draw(const fxl_pose *pose, uint8_t *frame)
{
    frame_draw_pose(&renderer, pose, frame, HEIGHT, BACKGROUND);
}

/* Hardly within the range of a light, where what is left of it is rounded to 0. */
/* light 2.3 */
void test_the_end_of_a_light_s_range(void)
{
    const fxl_light_settings of = {.ramp = ramp,
                                   .levels = LEVELS,
                                   .point_count = 1,
                                   .points = {{{0, 0, 0}, 73184830, FXL_Q2_30_ONE}}};
    const fxl_camera camera = any_camera();
    /* The squares add up to 23,606 less than the range's, of 2^54. */
    const fxl_lit_place place = {{FXL_Q2_30_ONE, 0, 0}, {-146369659, -17109, -146}};
    TEST_ASSERT_EQUAL_INT32(0, fxl_light_brightness(&of, &camera, &place));
    const fxl_lit_place nearer = {{FXL_Q2_30_ONE, 0, 0}, {-146369659 / 2, -17109, -146}};
    TEST_ASSERT_NEAR(exact_of(&of, &camera, &nearer) * FXL_Q2_30_ONE,
                     fxl_light_brightness(&of, &camera, &nearer), FXL_LIGHT_ERROR_MAX);
}

/* Of the cube's face of a colour 1..6 or 11..16: -x +x -y +y -z +z. */
static exact_vector normal_of(uint32_t colour)
{
    const uint32_t face = (colour - 1) % 10;
    const double sign = face % 2 ? 1 : -1;
    return (exact_vector){face / 2 == 0 ? sign : 0, face / 2 == 1 ? sign : 0,
                          face / 2 == 2 ? sign : 0};
}

/* One cube, convex or sorted: each pixel has the level of its face, by the definition. */
/* light 2.1a, 3.1a */
void test_each_face_has_its_level(void)
{
    uint32_t seen = 0;
    for (int round = 0; round < UNIT_REPEAT / 500; round++) {
        tiny_scene *tiny = start();
        const uint32_t shown = (uint32_t)unit_between(0, 1);
        tiny->instances[0] = tiny->instances[shown];
        tiny->scene.instance_count = 1;
        const fxl_point *centre = &tiny->instances[0].centre;
        fxl_light_settings of = exact_light_any(ramp, centre);
        const fxl_pose pose = {
            {unit_between(-Q16(4), Q16(4)), unit_between(-Q16(3), Q16(3)), centre->z - Q16(5)},
            0,
            0,
            unit_random()};
        of.levels = LEVELS;
        draw(&pose, frames[0]);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &of));
        TEST_ASSERT_EQUAL(FXL_FRAME_NONE, renderer.frame.state);
        draw(&pose, frames[1]);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            if (frames[0][i] == BACKGROUND) {
                TEST_ASSERT_EQUAL(BACKGROUND, frames[1][i]);
                continue;
            }
            const uint32_t colour = frames[0][i];
            const exact_vector normal = normal_of(colour), at = exact_point(centre, 1.0 / 65536);
            const exact_vector middle = {at.x + normal.x, at.y + normal.y, at.z + normal.z};
            const uint32_t level = (frames[1][i] - colour) / 20u;
            TEST_ASSERT_EQUAL(at_level(colour, level), frames[1][i]);
            expect_level(&of, exact_brightness(&of, &renderer.frame.view.camera, middle, normal),
                         level);
            seen += level > 0 && level < LEVELS - 1;
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, NULL, NULL));
        TEST_ASSERT_NULL(renderer.shader);
        draw(&pose, frames[1]);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
    }
    TEST_ASSERT_TRUE(seen > UNIT_REPEAT / 50);
}

/* A part of a face has the level of the whole face. Goes on
 * until a light is found by which the part alone would have another level. */
/* light 2.1b */
void test_a_part_has_the_level_of_the_whole_face(void)
{
    uint32_t apart = 0;
    for (int round = 0; round < UNIT_REPEAT / 50 || (apart == 0 && round < 2000); round++) {
        tiny_scene *tiny = start();
        const uint16_t *whole = fxl_face_indices(tiny->scene.indices, &tiny->faces[3]);
        const fxl_face part = {/* one side of face 3, whose box is another */
                               tiny->faces[3].normal,
                               3,
                               1,
                               {whole[0], whole[1], whole[1]}};
        uint32_t wholes[12] = {0};
        fxl_light_settings of = exact_light_any(ramp, &tiny->instances[0].centre);
        of.levels = LEVELS;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &of));
        const fxl_traversal traversal = {.renderer = &renderer, .workspace = &renderer.workspace};
        const fxl_shader *shader = renderer.shader;
        const uint8_t wanted =
            shader->code->colour(shader, &traversal, &tiny->instances[0], &tiny->faces[3], 1);
        wholes[3] = FXL_WHOLE(4 * 3, 4);
        tiny->faces[3] = part;
        apart += wanted !=
                 shader->code->colour(shader, &traversal, &tiny->instances[0], &tiny->faces[3], 1);
        tiny->scene.wholes = wholes;
        TEST_ASSERT_EQUAL(wanted, shader->code->colour(shader, &traversal, &tiny->instances[0],
                                                       &tiny->faces[3], 1));
    }
    TEST_ASSERT_TRUE(apart > 0);
}

/* An instance that is turned and scaled: its faces' normals and middles are, too. */
/* light 2.1c */
void test_light_follows_placements(void)
{
    for (int round = 0; round < UNIT_REPEAT / 50; round++) {
        tiny_scene *tiny = start();
        fxl_camera turned = any_camera();
        const fxl_orientation orientation = {turned.axes.right, turned.axes.up,
                                             turned.axes.forward};
        const fxl_placement placement = {orientation, unit_between(256, 64 * 65536)};
        tiny->scene.placements = &placement;
        tiny->scene.first_turned = 2;
        tiny->scene.placement_code = &fxl_turned_instances;
        const fxl_instance *instance = &tiny->instances[2];
        fxl_light_settings of = exact_light_any(ramp, &instance->centre);
        of.levels = LEVELS;
        for (uint32_t i = 0; i < of.point_count; i++) { /* not where half a unit matters */
            of.points[i].range = Q16(1000);
            of.points[i].position.y += Q16(500);
        }
        of.fog_near = of.fog_far = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &of));
        const fxl_traversal traversal = {.renderer = &renderer, .workspace = &renderer.workspace};
        for (uint32_t number = 0; number < 6; number++) {
            const exact_vector n = normal_of(number + 1),
                               at = exact_point(&instance->centre, 1.0 / 65536);
            const exact_vector rows[3] = {exact_direction(&orientation.x),
                                          exact_direction(&orientation.y),
                                          exact_direction(&orientation.z)};
            const double scale = placement.scale / 65536.0;
            const exact_vector normal = {exact_dot(rows[0], n), exact_dot(rows[1], n),
                                         exact_dot(rows[2], n)};
            const exact_vector middle = {at.x + scale * normal.x, at.y + scale * normal.y,
                                         at.z + scale * normal.z};
            const uint8_t found = renderer.shader->code->colour(renderer.shader, &traversal,
                                                                instance, &tiny->faces[number], 1);
            expect_level(&of, exact_brightness(&of, &renderer.frame.view.camera, middle, normal),
                         (found - 1u) / 20u);
        }
    }
}

/* A beam's lit colours are those of the colours that the light gives. */
/* light 5.1b */
void test_light_goes_with_beams(void)
{
    uint8_t *const room = memory_of.beams;
    static uint8_t lit[256];
    const fxl_pose pose = {{0, Q16(1), Q16(-4)}, 0, 0, 0};
    const fxl_direction way = {0, 0, FXL_Q2_30_ONE};
    const fxl_point window[4] = {{-Q16(0.75), -Q16(0.75), -Q16(3)},
                                 {-Q16(0.75), Q16(0.75), -Q16(3)},
                                 {Q16(0.75), Q16(0.75), -Q16(3)},
                                 {Q16(0.75), -Q16(0.75), -Q16(3)}};
    fxl_beam beam;
    const fxl_beam_set beams = {&beam, 1, lit};
    const fxl_light_settings of = {
        .ambient = FXL_Q2_30_ONE / 2, .ramp = ramp, .levels = 3 /* level 1 */};
    uint32_t changed = 0, plain = 0;
    for (int i = 0; i < 256; i++) {
        lit[i] = (uint8_t)(i + 100);
    }
    (void)start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_direction(&way, window, 4, &beam));
    TEST_ASSERT_TRUE(fxl_beam_light_workspace_size(&beam, 1) <= sizeof memory_of.beams);
    for (int light_first = 0; light_first < 2; light_first++) {
        (void)start();
        if (light_first) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &of));
        }
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_attach_beams(&renderer, &beams, room, sizeof memory_of.beams));
        draw(&pose, frames[light_first ? 1 : 0]);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &of));
        draw(&pose, frames[2]);
        if (light_first) {
            TEST_ASSERT_EQUAL_MEMORY(frames[1], frames[2], sizeof frames[2]);
        }
    }
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        if (frames[0][i] == BACKGROUND) {
            TEST_ASSERT_EQUAL(BACKGROUND, frames[2][i]);
        } else {
            TEST_ASSERT_EQUAL(frames[0][i] + 20, frames[2][i]);
            changed += frames[0][i] > 100;
            plain += frames[0][i] < 100;
        }
    }
    TEST_ASSERT_TRUE(changed > 3 && plain > 3);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(&renderer, NULL, NULL, 0));
    TEST_ASSERT_TRUE(renderer.shader == &light.shader && light.shader.next == NULL);
}

/* Bands that two workspaces draw in turn, as two cores do: the light belongs to both. */
static fxl_light_settings shared_settings(void)
{
    return (fxl_light_settings){.ambient = FXL_Q2_30_ONE / 4,
                                .points = {{{Q16(3), Q16(4), Q16(2)}, Q16(30), FXL_Q2_30_ONE}},
                                .point_count = 1,
                                .ramp = ramp,
                                .levels = LEVELS};
}

/* Rows in turn by two workspaces. */
static void draw_by_two(fxl_workspace *second, void *frame, const uint16_t *palette)
{
    const uint32_t bytes = palette != NULL ? 2 : 1;
    for (uint16_t row = 0; row < HEIGHT; row++) {
        const fxl_band band = {.pixels = (uint8_t *)frame + row * WIDTH * bytes,
                               .width = WIDTH,
                               .stride = WIDTH,
                               .first_row = row,
                               .rows = 1,
                               .palette = palette};
        fxl_frame_fill(&renderer, &band, BACKGROUND);
        TEST_ASSERT_EQUAL(
            FXL_OK, fxl_frame_draw_with(&renderer, row % 2 ? second : &renderer.workspace, &band));
    }
}

/* light 5.2c */
void test_cores_share_the_light_in_rgb565(void)
{
    static FXL_ALIGN_8 uint8_t room[6 * sizeof(fxl_draw_entry) + 8];
    static uint16_t palette[256], one[WIDTH * HEIGHT], other[WIDTH * HEIGHT];
    const fxl_pose pose = {{0, Q16(1), Q16(-4)}, 0, 0, 0};
    const fxl_light_settings of = shared_settings();
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, &fxl_rgb565);
    uint32_t changed = 0;
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(0xFFFFu - 37u * i);
    }
    (void)start();
    config.palette = palette;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_choose(&renderer, &config));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    draw_by_two(&renderer.workspace, other, palette); /* without light */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &of));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    draw_by_two(&renderer.workspace, one, palette);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        changed += one[i] != other[i];
    }
    TEST_ASSERT_GREATER_THAN(20, changed);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&memory_of.second, &renderer, room, sizeof room));
    draw_by_two(&memory_of.second, other, palette);
    TEST_ASSERT_EQUAL_MEMORY(one, other, sizeof one);
}

/* light 5.2c */
void test_cores_share_the_light(void)
{
    static FXL_ALIGN_8 uint8_t room[6 * sizeof(fxl_draw_entry) + 8];
    fxl_workspace *const second = &memory_of.second;
    const fxl_pose pose = {{0, Q16(1), Q16(-4)}, 0, 0, 0};
    const fxl_light_settings of = shared_settings();
    (void)start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &of));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(second, &renderer, room, sizeof room));
    draw(&pose, frames[0]);
    draw_by_two(second, frames[1], NULL);
    TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
}

/* --- settings ---------------------------------------------------------------------- */

static void expect_refused(fxl_status status, const fxl_light_settings *of)
{
    const fxl_light before = light;
    const uint32_t refused = renderer.workspace.counters.refused_calls;
    const fxl_shader *const shader = renderer.shader;
    TEST_ASSERT_EQUAL(status, fxl_attach_light(&renderer, &light, of));
    TEST_ASSERT_EQUAL_MEMORY(&before, &light, sizeof light);
    TEST_ASSERT_TRUE(renderer.shader == shader);
    TEST_ASSERT_EQUAL_UINT32(refused + 1, renderer.workspace.counters.refused_calls);
}

/* formats 1.11b */
void test_settings_out_of_range_are_refused(void)
{
    static const fxl_renderer none;
    const fxl_point origin = {0, 0, 0};
    (void)start();
    fxl_light_settings right;
    do {
        right = exact_light_any(ramp, &origin);
    } while (right.point_count < 2 || right.strength == 0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &right));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_light(NULL, &light, &right));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_light(&renderer, NULL, &right));
    fxl_scene_fault fault = {"nothing", 99};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_light_check(NULL, &fault));
    TEST_ASSERT_EQUAL_STRING("light", fault.what);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_light_check(NULL, NULL));
#define REFUSED(status, change) \
    do { \
        fxl_light_settings of = right; \
        change; \
        expect_refused(status, &of); \
    } while (0)
    REFUSED(FXL_E_ARGUMENT, of.ramp = NULL);
    REFUSED(FXL_E_COUNT, of.point_count = FXL_LIGHT_POINTS_MAX + 1);
    REFUSED(FXL_E_COUNT, of.levels = 1);
    REFUSED(FXL_E_COUNT, of.levels = FXL_LIGHT_LEVELS_MAX + 1);
    REFUSED(FXL_E_NORMAL, of.direction.x = of.direction.y = of.direction.z = 0);
    REFUSED(FXL_E_RANGE, of.ambient = -1);
    REFUSED(FXL_E_RANGE, of.ambient = FXL_Q2_30_ONE + 1);
    REFUSED(FXL_E_RANGE, of.strength = FXL_Q2_30_ONE + 1);
    REFUSED(FXL_E_RANGE, of.points[1].range = 0);
    REFUSED(FXL_E_RANGE, of.points[1].range = FXL_COORDINATE_MAX + 1);
    REFUSED(FXL_E_RANGE, of.points[1].strength = -1);
    REFUSED(FXL_E_RANGE, of.points[1].position.z = FXL_COORDINATE_MAX + 1);
    REFUSED(FXL_E_RANGE, of.fog_near = of.fog_far = 65536);
    REFUSED(FXL_E_RANGE, of.fog_near = -1; of.fog_far = 65536);
    REFUSED(FXL_E_RANGE, of.fog_near = 0; of.fog_far = FXL_FAR_MAX + 1);
#undef REFUSED
    fxl_light_settings from_the_eye = right; /* fog that begins at the eye */
    from_the_eye.fog_near = 0;
    from_the_eye.fog_far = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_light_check(&from_the_eye, NULL));
    renderer = none;
    expect_refused(FXL_E_ORDER, &right);
}

/* Before a renderer has a target, light is for a palette. */
void test_light_comes_before_the_target(void)
{
    const fxl_point origin = {0, 0, 0};
    const fxl_light_settings right = exact_light_any(ramp, &origin);
    (void)start();
    renderer.target = NULL; /* as fxl_renderer_init_bare leaves it */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &right));
    const fxl_shader_code *const code = light.shader.code;
    renderer.target = &fxl_palette;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &right));
    TEST_ASSERT_EQUAL_PTR(code, light.shader.code);
}
