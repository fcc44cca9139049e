/* SPDX-License-Identifier: MIT */
/* Light in a scene image: sections of light, of point lights and of the ramp. */
#include "expect_scene.h"

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
    static const uint8_t ramp[LEVELS][LEVEL] = {{1}, {2}}; /* any bytes are a ramp */
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
/* formats 1.11 */
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

/* formats 1.11 */
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

/* formats 1.11 */
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
