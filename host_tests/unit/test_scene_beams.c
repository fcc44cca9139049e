/* SPDX-License-Identifier: MIT */
/* Beams in a scene image: a section of beams, and one of 256 lit colours. */
#include "expect_scene.h"

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
static tiny_image *make(void)
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
    tiny_image *image = make();
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
    expect_image_word(status, make(), offset, value);
}

static void beam_half(fxl_status status, uint32_t offset, uint16_t value)
{
    expect_image_half(status, make(), offset, value);
}

/* beams 1.1 */
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
        tiny_image *image = make();
        fxl_scene_image opened;
        fxl_scene_fault fault = {"nothing", 99};
        tiny_set_section(image, kinds[i], NULL, 0, 0);
        tiny_seal(image);
        TEST_ASSERT_EQUAL(FXL_E_COUNT,
                          fxl_scene_open(image->words, image->size, &opened, &fault));
        TEST_ASSERT_EQUAL_STRING(names[i], fault.what);
    }
}

/* beams 1.1 */
void test_what_a_beam_holds(void)
{
    const uint32_t at = tiny_get(make(), AT_BEAMS);
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
/* beams 4.3 */
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
