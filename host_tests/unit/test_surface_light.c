/* SPDX-License-Identifier: MIT */
/* Faces that are lit at their corners, against the definitions in double; and the ramps of light.
 */
#include <math.h>

#include "../../lib/paint/light_level.h"
#include "quad_scene.h"

enum {
    LEVELS = 16,
    ROUNDS = UNIT_REPEAT / 200
};

static uint8_t ramp[256 * LEVELS];
static fxl_light light;
static double worst;
static uint32_t compared, differing;

void setUp(void)
{
    for (uint32_t level = 0; level < LEVELS; level++) {
        for (uint32_t c = 0; c < 256; c++) {
            ramp[256 * level + c] = (uint8_t)(16 * level + (c & 15));
        }
    }
    worst = 0;
    compared = differing = 0;
    memset(&light, 0, sizeof light);
}

/* place light: pictures of lit surfaces */
/* Light with its sources about the face. */
static fxl_light_settings any_settings(void)
{
    const fxl_point origin = {0, 0, 0};
    fxl_light_settings of = exact_light_any(ramp, &origin);
    of.levels = LEVELS;
    if (of.fog_far != 0) {
        of.fog_near = unit_between(0, Q16(4));
        of.fog_far = of.fog_near + unit_between(Q16(1), Q16(24));
    }
    for (uint32_t i = 0; i < of.point_count; i++) {
        of.points[i].range = unit_between(Q16(5), Q16(60));
        of.points[i].position = unit_point(Q16(20));
        of.points[i].strength = FXL_Q2_30_ONE / 2;
    }
    return of;
}

/* The exact levels of the corners, and a half. */
static void find_levels(const quad_scene *quad, const fxl_light_settings *of, double levels[3])
{
    for (int i = 0; i < 3; i++) {
        levels[i] = exact_brightness(of, &quad->renderer.frame.view.camera, quad->corners[i],
                                     quad->lit[i]) *
                        (LEVELS - 1) +
                    0.5;
    }
}

static double held(double level)
{
    return level < 0.5 ? 0.5 : level > LEVELS - 0.5 ? LEVELS - 0.5 : level;
}

/* Every pixel of the frame that the face covers: its level is within tolerance of the exact one.
 * Pixels near the horizon, where the weight is small, and faces seen from far aside are the
 * bound's, not this test's. */
static void check_levels(const quad_scene *quad, const fxl_light_settings *of, double tolerance)
{
    double levels[3], weight;
    find_levels(quad, of, levels);
    for (int y = 0; y < QUAD_HEIGHT; y++) {
        for (int x = 0; x < QUAD_WIDTH; x++) {
            const uint8_t shown = quad->frame[y * QUAD_WIDTH + x];
            const double exact = held(quad_value(quad, x, y, levels, &weight));
            if (shown == QUAD_BACKGROUND || weight < 0.02) {
                continue;
            }
            const double level = shown >> 4;
            const double off = fmax(level - exact, exact - level - 1);
            TEST_ASSERT_TRUE(off <= tolerance);
            worst = fmax(worst, off);
            compared++;
            differing += off > 0;
        }
    }
}

/* A pick finds the light of corners anew, behind a shader of its own, and answers what is shown. */
static void expect_picks(quad_scene *quad)
{
    for (int i = 0; i < 3; i++) {
        const uint16_t x = (uint16_t)unit_between(0, QUAD_WIDTH - 1);
        const uint16_t y = (uint16_t)unit_between(0, QUAD_HEIGHT - 1);
        const bool is_shown = quad->frame[y * QUAD_WIDTH + x] != QUAD_BACKGROUND;
        fxl_picked picked;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pick_face(&quad->renderer, x, y, &picked));
        TEST_ASSERT_EQUAL_UINT16(is_shown ? 0 : FXL_PICK_NONE, picked.instance);
    }
}

static void draw_random_faces(bool turned, uint8_t division, double tolerance)
{
    for (uint32_t i = 0; i < ROUNDS; i++) {
        const fxl_light_settings of = any_settings();
        quad_scene *quad = quad_make(turned);
        quad->surface.flags = FXL_SURFACE_LIT;
        quad->surface.division = division;
        quad_begin(quad);
        quad_light(quad, &light, &of);
        quad_draw(quad);
        check_levels(quad, &of, tolerance);
        expect_picks(quad);
    }
    TEST_ASSERT_GREATER_THAN(50 * ROUNDS, compared);
}

/* At each pixel the level is the exact one, but for a 1/256 of a level. */
/* surfaces 5.2a, 5.2c, 5.3b, SPEC 9.7a-b, accuracy 3.1q */
void test_levels_divided_at_each_pixel(void)
{
    draw_random_faces(false, FXL_DIVIDE_1, 1.0 / 256);
    TEST_ASSERT_TRUE(differing < compared / 1000);
}

/* surfaces 5.3c */
void test_levels_divided_every_16_pixels(void)
{
    draw_random_faces(false, FXL_DIVIDE_16, 0.5 + 1.0 / 256);
    TEST_ASSERT_TRUE(worst > 1.0 / 256); /* they are linear in between */
}

/* Corners and normals of an instance that has a placement; its corners are rounded in the world. */
/* SPEC 9.7b-c, surfaces 5.1a-c */
void test_levels_of_turned_faces(void)
{
    draw_random_faces(true, FXL_DIVIDE_1, 1.0 / 128);
}

/* The texel and the level of one pixel, at once: the ramp's colours have both. */
/* SPEC 9.6f, surfaces 5.2d */
void test_light_goes_over_textures(void)
{
    static uint8_t texels[64];
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)((i >> 4 & 1) * 2 + (i >> 1 & 1));
    }
    for (uint32_t i = 0; i < ROUNDS; i++) {
        const fxl_light_settings of = any_settings();
        quad_scene *quad = quad_make(false);
        double u[3], v[3], weight;
        quad->texture =
            (fxl_texture){.texels = texels, .log_width = 3, .log_height = 3, .levels = 1};
        quad->set.texture_count = 1;
        quad->surface.texture = 1;
        quad->surface.flags = FXL_SURFACE_LIT;
        quad->surface.division = FXL_DIVIDE_1;
        for (int k = 0; k < 3; k++) {
            u[k] = quad->mapped_corners[k].texel.u / 65536.0;
            v[k] = quad->mapped_corners[k].texel.v / 65536.0;
        }
        quad_begin(quad);
        quad_light(quad, &light, &of);
        quad_draw(quad);
        check_levels(quad, &of, 1.0 / 256);
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            const double at_u = quad_value(quad, p % QUAD_WIDTH, p / QUAD_WIDTH, u, &weight);
            const double at_v = quad_value(quad, p % QUAD_WIDTH, p / QUAD_WIDTH, v, &weight);
            const double off_u = fabs(at_u / 2 - floor(at_u / 2 + 0.5)) * 2;
            const double off_v = fabs(at_v / 2 - floor(at_v / 2 + 0.5)) * 2;
            if (quad->frame[p] != QUAD_BACKGROUND && weight > 0.02 && off_u > 0.02 &&
                off_v > 0.02) {
                TEST_ASSERT_EQUAL(((int)floor(at_v / 2) & 1) * 2 + ((int)floor(at_u / 2) & 1),
                                  quad->frame[p] & 15);
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(50 * ROUNDS, compared);
}

/* Light that is the same at all corners makes of each texel what its level of the ramp says, in
 * every pixel, whatever the division and the kernel; but FXL_DIVIDE_1 and patterns of pixels have a
 * kernel for unlit texels alone: of those, the pixels and the level. */
/* surfaces 5.2 */
void test_even_light_is_one_level(void)
{
    static uint8_t texels[1024], unlit[QUAD_WIDTH * QUAD_HEIGHT];
    uint32_t drawn = 0;
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(i * 7u % 13u);
    }
    for (uint32_t i = 0; i < ROUNDS; i++) {
        const fxl_light_settings of = {
            .ramp = ramp, .levels = LEVELS, .ambient = (fxl_q2_30)(unit_random() >> 2)};
        const uint32_t level = (uint32_t)(of.ambient / (double)FXL_Q2_30_ONE * (LEVELS - 1) + 0.5);
        quad_scene *quad = quad_make(i % 2 != 0);
        quad->texture = (fxl_texture){
            .texels = texels, .log_width = (uint8_t)(3 + i / 2 % 3), .log_height = 5, .levels = 1};
        quad->set.texture_count = 1;
        quad->surface.texture = 1;
        static const uint8_t divisions[] = {FXL_DIVIDE_16, FXL_DIVIDE_8, FXL_AFFINE};
        quad->surface.division = divisions[i % 3];
        quad->surface.opacity = (uint8_t)(i % 8 == 0 ? 11 : 16);
        quad_begin(quad);
        quad_draw(quad);
        memcpy(unlit, quad->frame, sizeof unlit);
        quad->surface.flags = FXL_SURFACE_LIT;
        quad_light(quad, &light, &of);
        quad_draw(quad);
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            const uint8_t texel = quad->surface.opacity < 16 ? quad->frame[p] & 15 : unlit[p];
            TEST_ASSERT_EQUAL(unlit[p] == QUAD_BACKGROUND ? QUAD_BACKGROUND
                                                          : ramp[256 * level + texel],
                              quad->frame[p]);
            drawn += unlit[p] != QUAD_BACKGROUND;
        }
    }
    TEST_ASSERT_GREATER_THAN(50 * ROUNDS, drawn);
}

/* Without a light a lit surface has its colour; taken away, it has it again. */
/* combinations 1.4, surfaces 5.5 */
void test_light_is_taken_and_left(void)
{
    fxl_light_settings of = {.ramp = ramp, .levels = LEVELS};
    quad_scene *quad = quad_make(false);
    quad->surface.flags = FXL_SURFACE_LIT;
    quad->pose = (fxl_pose){.position = {0, 0, 0}};
    for (int i = 0; i < 4; i++) { /* a wall before the eye */
        quad->vertices[i] =
            (fxl_point){i % 3 ? Q16(20) : Q16(-20), i < 2 ? Q16(20) : Q16(-20), Q16(5)};
        quad->normals[i] = (fxl_direction){0, 0, -FXL_Q2_30_ONE};
    }
    quad->face.normal = quad->normals[0];
    quad->model.radius = Q16(30);
    quad_begin(quad);
    quad_draw(quad);
    TEST_ASSERT_EACH_EQUAL_UINT8(QUAD_COLOUR, quad->frame, sizeof quad->frame);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&quad->renderer, &quad->corner_light));
    TEST_ASSERT_EQUAL(FXL_FRAME_NONE, quad->renderer.frame.state);
    quad_draw(quad); /* there is no light to take */
    TEST_ASSERT_EACH_EQUAL_UINT8(QUAD_COLOUR, quad->frame, sizeof quad->frame);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&quad->renderer, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&quad->renderer, &light, &of));
    quad_draw(quad); /* the renderer's light is for flat faces */
    TEST_ASSERT_EACH_EQUAL_UINT8(QUAD_COLOUR, quad->frame, sizeof quad->frame);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&quad->renderer, &quad->corner_light));
    quad_draw(quad);
    TEST_ASSERT_EACH_EQUAL_UINT8(ramp[QUAD_COLOUR], quad->frame, sizeof quad->frame);
    of.ambient = FXL_Q2_30_ONE; /* the same settings light both */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&quad->renderer, &light, &of));
    quad_draw(quad);
    TEST_ASSERT_EACH_EQUAL_UINT8(ramp[256 * (LEVELS - 1) + QUAD_COLOUR], quad->frame,
                                 sizeof quad->frame);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&quad->renderer, NULL));
    quad_draw(quad);
    TEST_ASSERT_EACH_EQUAL_UINT8(QUAD_COLOUR, quad->frame, sizeof quad->frame);
    TEST_ASSERT_EQUAL(0, quad->renderer.workspace.counters.refused_calls);
}

/* accuracy 1.2g, surfaces 5.3a */
void test_the_light_of_a_corner_is_rounded_once(void)
{
    double largest = 0;
    for (uint32_t i = 0; i < UNIT_REPEAT; i++) {
        const fxl_q2_30 brightness = (fxl_q2_30)(unit_random() % (FXL_Q2_30_ONE + 1u));
        const uint32_t levels_less_1 = 1 + unit_random() % 63;
        const double exact = ((double)brightness / FXL_Q2_30_ONE * levels_less_1 + 0.5) * 65536;
        const double off = fabs(fxl_light_corner_level(brightness, levels_less_1) - exact);
        TEST_ASSERT_TRUE(off <= 0.6);
        largest = fmax(largest, off);
    }
    TEST_ASSERT_TRUE(largest > 0.4);
}

/* A palette of greys has each level of each grey; of two equal entries the first is taken. */
/* light 3.2a */
void test_a_ramp_of_greys_is_exact(void)
{
    static uint8_t palette[768], made[256 * 5];
    const uint8_t dark[3] = {7, 7, 7};
    for (int i = 0; i < 256; i++) {
        memset(&palette[3 * i], i == 200 ? 7 : i, 3);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_light_make_ramp(palette, dark, 5, made));
    for (int level = 0; level < 5; level++) {
        for (int i = 0; i < 256; i++) {
            const double colour = 7 + (palette[3 * i] - 7) * level / 4.0;
            const int wanted = (int)floor(colour + 0.5);
            /* 199 and 201 are as far from 200, and 199 comes first. */
            TEST_ASSERT_EQUAL(level == 4 ? i : wanted == 200 ? 199 : wanted, made[256 * level + i]);
        }
    }
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_light_make_ramp(NULL, dark, 5, made));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_light_make_ramp(palette, NULL, 5, made));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_light_make_ramp(palette, dark, 5, NULL));
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_light_make_ramp(palette, dark, 1, made));
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_light_make_ramp(palette, dark, 65, made));
}
