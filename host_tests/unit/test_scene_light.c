/* SPDX-License-Identifier: MIT */
/* Sections of light, of beams and of lit colours: used in place, and checked. */
#include "expect_scene.h"

/* Light in a scene image: sections of light, of point lights and of the ramp. */

enum {
    AT_LIGHT = AT_MORE,
    AT_POINTS = AT_LIGHT + SECTION_BYTES,
    AT_RAMP = AT_POINTS + SECTION_BYTES,
    LIGHT = 28,
    POINT = 20,
    LEVEL = 256,
    LEVELS = 2
};

/* Tiny's image with two point lights and fog. */
static tiny_image *make(void)
{
    static const fxl_light_base base = {
        FXL_Q2_30_ONE / 4, FXL_Q2_30_ONE / 2, {0, -FXL_Q2_30_ONE, 0}, Q16(5), Q16(20)};
    static const fxl_point_light points[2] = {{{0, Q16(3), 0}, Q16(9), FXL_Q2_30_ONE},
                                              {{Q16(7), 0, Q16(-8)}, 1, 0}};
    static const uint8_t ramp[LEVELS][LEVEL] = {{255, 1, 128}, {2}}; /* any bytes are a ramp */
    tiny_image *image = tiny_image_make(false);
    tiny_set_section(image, SECTION_LIGHT, &base, 1, LIGHT);
    tiny_set_section(image, SECTION_POINT_LIGHTS, points, 2, POINT);
    tiny_set_section(image, SECTION_RAMP, ramp, LEVELS, LEVEL);
    tiny_seal(image);
    return image;
}

static void light_word(fxl_status status, uint32_t offset, uint32_t value)
{
    expect_image_word(status, make(), offset, value);
}

static void entry_word(fxl_status status, uint32_t table, uint32_t at, uint32_t value)
{
    expect_image_entry_word(status, make(), table, at, value);
}

/* place light: a new setting: the setting out of an image */
/* The settings are those of the image, to the last member. */
/* formats 1.1f, 1.2z-ab, 1.11c */
void test_light_is_used_in_place(void)
{
    tiny_image *image = make();
    fxl_scene_image opened;
    fxl_light_settings settings;
    memset(&settings, 0x5A, sizeof settings);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.scene.placements);
    TEST_ASSERT_NULL(opened.scene.beams);
    fxl_light_settings_of(&opened.light, &settings);
    TEST_ASSERT_EQUAL_INT32(FXL_Q2_30_ONE / 4, settings.ambient);
    TEST_ASSERT_EQUAL_INT32(FXL_Q2_30_ONE / 2, settings.strength);
    TEST_ASSERT_EQUAL_INT32(-FXL_Q2_30_ONE, settings.direction.y);
    TEST_ASSERT_EQUAL_INT32(Q16(5), settings.fog_near);
    TEST_ASSERT_EQUAL_INT32(Q16(20), settings.fog_far);
    TEST_ASSERT_EQUAL_UINT32(2, settings.point_count);
    TEST_ASSERT_EQUAL_INT32(Q16(3), settings.points[0].position.y);
    TEST_ASSERT_EQUAL_INT32(Q16(-8), settings.points[1].position.z);
    TEST_ASSERT_EQUAL_INT32(1, settings.points[1].range);
    TEST_ASSERT_EQUAL_INT32(0, settings.points[2].range);
    TEST_ASSERT_EQUAL_UINT32(LEVELS, settings.levels);
    TEST_ASSERT_EQUAL_PTR(tiny_at(image, tiny_get(image, AT_RAMP)), settings.ramp);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_light_check(&settings, NULL));
    image = tiny_image_make(false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.light.base);
}

void test_an_image_with_one_point_light(void)
{
    tiny_image *image = make();
    fxl_scene_image opened;
    static const fxl_point_light one = {{0, Q16(3), 0}, Q16(9), FXL_Q2_30_ONE};
    tiny_set_section(image, SECTION_POINT_LIGHTS, &one, 1, POINT);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_PTR(tiny_at(image, tiny_get(image, AT_POINTS)), opened.light.points);
    TEST_ASSERT_EQUAL_UINT32(1, opened.light.point_count);
}

void test_an_image_may_have_no_point_lights(void)
{
    tiny_image *image = make();
    fxl_scene_image opened;
    tiny_set_section(image, SECTION_POINT_LIGHTS, NULL, 0, 0);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.light.points);
    TEST_ASSERT_EQUAL_UINT32(0, opened.light.point_count);
}

static void without(uint16_t kind, const char *what)
{
    tiny_image *image = make();
    fxl_scene_image opened;
    fxl_scene_fault fault = {"nothing", 99};
    tiny_set_section(image, kind, NULL, 0, 0);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
}

void test_light_and_ramp_go_together(void)
{
    without(SECTION_LIGHT, "light table");
    without(SECTION_RAMP, "ramp");
}

/* formats 1.11, 1.2z-ab */
void test_tables_of_light_are_checked(void)
{
    light_word(FXL_E_COUNT, AT_LIGHT + 4, 0);
    light_word(FXL_E_COUNT, AT_LIGHT + 4, 2);
    light_word(FXL_E_OFFSET, AT_LIGHT, 4);
    light_word(FXL_E_COUNT, AT_POINTS + 4, 0);
    light_word(FXL_E_COUNT, AT_POINTS + 4, FXL_LIGHT_POINTS_MAX + 1);
    light_word(FXL_E_ALIGNMENT, AT_POINTS, 250);
    light_word(FXL_E_COUNT, AT_RAMP + 4, 0);
    light_word(FXL_E_SIZE, AT_RAMP + 4, 1); /* the image does not end with it */
    light_word(FXL_E_COUNT, AT_RAMP + 4, FXL_LIGHT_LEVELS_MAX + 1);
    light_word(FXL_E_OFFSET, AT_RAMP, 0x7FFFFFF0u);
}

/* formats 1.11b */
void test_numbers_of_light_are_checked(void)
{
    entry_word(FXL_E_RANGE, AT_LIGHT, 0, FXL_Q2_30_ONE + 1);
    entry_word(FXL_E_RANGE, AT_LIGHT, 4, 0xFFFFFFFFu);
    entry_word(FXL_E_NORMAL, AT_LIGHT, 12, (uint32_t)-FXL_Q2_30_ONE / 2);
    entry_word(FXL_E_RANGE, AT_LIGHT, 24, (uint32_t)Q16(5));
    entry_word(FXL_E_RANGE, AT_LIGHT, 24, (uint32_t)FXL_FAR_MAX + 1);
    entry_word(FXL_OK, AT_LIGHT, 24, (uint32_t)Q16(5) + 1);
    entry_word(FXL_E_RANGE, AT_POINTS, POINT + 12, 0);
    entry_word(FXL_E_RANGE, AT_POINTS, POINT + 16, 0xFFFFFFFFu);
    entry_word(FXL_E_RANGE, AT_POINTS, POINT, FXL_COORDINATE_MAX + 1);
}

/* What is at fault has its name. */
void test_the_fault_names_the_point_light(void)
{
    tiny_image *image = make();
    fxl_scene_image opened;
    fxl_scene_fault fault = {"nothing", 99};
    tiny_put32(tiny_at(image, tiny_get(image, AT_POINTS) + POINT + 12), 0);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING("point light", fault.what);
    TEST_ASSERT_EQUAL_UINT32(1, fault.index);
    image = make();
    tiny_put32(tiny_at(image, tiny_get(image, AT_LIGHT)), 0xFFFFFFFFu);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING("light", fault.what);
}

/* Beams in a scene image: a section of beams, and one of 256 lit colours. */

enum {
    AT_BEAMS = AT_MORE,
    AT_LIT = AT_MORE + SECTION_BYTES,
    BEAM = 176
};

static const fxl_point window[] = {{Q16(-1), Q16(5), Q16(-1)},
                                   {Q16(1), Q16(5), Q16(-1)},
                                   {Q16(1), Q16(5), Q16(1)},
                                   {Q16(-1), Q16(5), Q16(1)}};
static const fxl_point lamp = {0, Q16(9), 0};

/* Tiny's image with a beam. */
static tiny_image *make_beams(void)
{
    uint8_t lit[256];
    fxl_beam beam;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beam));
    for (uint32_t i = 0; i < sizeof lit; i++) {
        lit[i] = (uint8_t)(255 - i);
    }
    tiny_image *image = tiny_image_make(false);
    tiny_set_section(image, SECTION_BEAMS, &beam, 1, BEAM);
    tiny_set_section(image, SECTION_LIT_COLOURS, lit, 1, sizeof lit);
    tiny_seal(image);
    return image;
}

void test_a_beam_is_used_in_place(void)
{
    tiny_image *image = make_beams();
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_UINT32(1, opened.scene.beam_count);
    TEST_ASSERT_EQUAL(5, opened.scene.beams[0].plane_count);
    TEST_ASSERT_EQUAL_INT32(lamp.y, opened.scene.beams[0].from[1]);
    TEST_ASSERT_EQUAL_HEX8(250, opened.scene.lit[5]);
    image = tiny_image_make(false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_UINT32(0, opened.scene.beam_count);
    TEST_ASSERT_NULL(opened.scene.beams);
    TEST_ASSERT_NULL(opened.scene.lit);
}

static void beam_word(fxl_status status, uint32_t offset, uint32_t value)
{
    expect_image_word(status, make_beams(), offset, value);
}

static void beam_half(fxl_status status, uint32_t offset, uint16_t value)
{
    expect_image_half(status, make_beams(), offset, value);
}

/* beams 1.1c, formats 1.2t-u */
void test_the_sections_of_beams(void)
{
    beam_word(FXL_E_COUNT, AT_BEAMS + 4, 0);
    beam_word(FXL_E_COUNT, AT_BEAMS + 4, FXL_BEAMS_MAX + 1);
    beam_word(FXL_E_OFFSET, AT_BEAMS, HEADER_SIZE);
    beam_word(FXL_E_OFFSET, AT_BEAMS, 0xFFFFFFFCu);
    beam_word(FXL_E_ALIGNMENT, AT_BEAMS, 2001);
    beam_word(FXL_E_COUNT, AT_LIT + 4, 2);
    beam_word(FXL_E_OFFSET, AT_LIT, 0);
    beam_word(FXL_E_OFFSET, AT_LIT, 0xFFFFFF00u);
}

void test_beams_and_lit_colours_go_together(void)
{
    static const uint16_t kinds[] = {SECTION_BEAMS, SECTION_LIT_COLOURS};
    static const char *const names[] = {"beam table", "lit table"};
    for (int i = 0; i < 2; i++) {
        tiny_image *image = make_beams();
        fxl_scene_image opened;
        fxl_scene_fault fault = {"nothing", 99};
        tiny_set_section(image, kinds[i], NULL, 0, 0);
        tiny_seal(image);
        TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_open(image->words, image->size, &opened, &fault));
        TEST_ASSERT_EQUAL_STRING(names[i], fault.what);
    }
}

/* beams 1.1d */
void test_what_a_beam_holds(void)
{
    const uint32_t at = tiny_get(make_beams(), AT_BEAMS);
    beam_word(FXL_E_RANGE, at + 4, (uint32_t)FXL_COORDINATE_MAX + 1);
    beam_half(FXL_E_RESERVED, at + 14, 1);
    beam_half(FXL_E_RESERVED, at + 12, 5 << 8 | 2); /* planes, kind */
    beam_half(FXL_E_NORMAL, at + 12, 5 << 8 | FXL_BEAM_DIRECTION);
    beam_half(FXL_E_COUNT, at + 12, 0);
    beam_half(FXL_E_COUNT, at + 12, 9 << 8);
    beam_half(FXL_E_NORMAL, at + 12, 6 << 8); /* a plane without a normal */
    beam_half(FXL_E_RESERVED, at + 12, 4 << 8);
    beam_word(FXL_E_NORMAL, at + 16, 0x12345678u);
    beam_word(FXL_E_RANGE, at + 32, 0x40000000u);
}

/* Beams that leave room for triangles alone: a face of four corners is refused wherever it is. */
/* beams 4.3c */
void test_every_face_must_fit_the_beams(void)
{
    static const uint8_t lit[256];
    static fxl_beam beams[2];
    fxl_scene_fault fault;
    beams[1].plane_count = (uint8_t)((FXL_FACE_VERTICES_MAX - 3) / 3); /* each adds two vertices */
    beams[0].plane_count = (uint8_t)(FXL_FACE_VERTICES_MAX - 3 - 2 * beams[1].plane_count);
    TEST_ASSERT_TRUE(beams[0].plane_count <= FXL_BEAM_PLANES_MAX);
    for (uint32_t i = 0; i < FXL_BEAM_PLANES_MAX; i++) {
        for (uint32_t b = 0; b < 2; b++) {
            beams[b].planes[i].normal.x = i < beams[b].plane_count ? FXL_Q2_30_ONE : 0;
        }
    }
    for (uint32_t larger = 0; larger <= 12; larger++) {
        tiny_scene *tiny = tiny_make();
        for (uint32_t i = 0; i < 12; i++) {
            tiny->faces[i].count = i == larger ? 4 : 3;
            fxl_face_take_indices(&tiny->faces[i], tiny->corners, 4 * i);
        }
        tiny->scene.beams = beams;
        tiny->scene.lit = lit;
        tiny->scene.beam_count = 2;
        fault.index = 99;
        TEST_ASSERT_EQUAL(larger < 12 ? FXL_E_CAPACITY : FXL_OK,
                          fxl_scene_check_all(&tiny->scene, &fault));
        TEST_ASSERT_TRUE(larger == 12 || fault.index == larger);
    }
}

/* Four corners and five planes fit; a table may say so of more beams than do. */
void test_faces_must_fit_the_beams(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault;
    static const uint8_t lit[256];
    fxl_beam beams[3];
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beams[i]));
    }
    tiny->scene.beams = beams;
    tiny->scene.lit = lit;
    tiny->scene.beam_count = 2;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_STRING("beam table", fault.what);
    tiny->scene.beam_count = 3;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_scene_check_all(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_STRING("face", fault.what);
    tiny->scene.beam_count = FXL_BEAMS_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_check_all(&tiny->scene, &fault));
    tiny->scene.beam_count = 1;
    tiny->scene.lit = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_check_all(&tiny->scene, &fault));
}
