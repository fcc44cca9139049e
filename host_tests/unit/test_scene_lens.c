/* SPDX-License-Identifier: MIT */
/* The lens of an image: its members, a scale, a centre that is moved. */
#include "expect_scene.h"

static tiny_image *image_with_centre(fxl_q16_16 x, fxl_q16_16 y)
{
    const fxl_image_centre centre = {x, y};
    tiny_image *image = tiny_image_make(false);
    tiny_put32(tiny_at(image, AT_INSET), 0);
    tiny_set_section(image, SECTION_LENS_CENTRE, &centre, 1, sizeof centre);
    tiny_seal(image);
    return image;
}

/* An inset does not go with a scale. */
void test_a_lens_with_a_scale(void)
{
    const struct {
        fxl_q16_16 scale;
        uint32_t inset;
        bool has_centre;
        fxl_status status;
    } cases[] = {{FXL_ORTHOGRAPHIC_SCALE_MIN, 0, false, FXL_OK},
                 {FXL_ORTHOGRAPHIC_SCALE_MAX, 0, false, FXL_OK},
                 {FXL_ORTHOGRAPHIC_SCALE_MIN - 1, 0, false, FXL_E_RANGE},
                 {FXL_ORTHOGRAPHIC_SCALE_MAX + 1, 0, false, FXL_E_RANGE},
                 {Q16(3), 1, false, FXL_E_RANGE},
                 {Q16(3), 1, true, FXL_E_RANGE},
                 {Q16(3), 0, true, FXL_OK}};
    for (uint32_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const fxl_image_scale scale = {cases[i].scale};
        tiny_image *image =
            cases[i].has_centre ? image_with_centre(Q16(-10), Q16(40)) : tiny_image_make(false);
        fxl_scene_image opened;
        fxl_scene_fault fault;
        tiny_put32(tiny_at(image, AT_INSET), cases[i].inset);
        tiny_set_section(image, SECTION_LENS_SCALE, &scale, 1, sizeof scale);
        tiny_seal(image);
        TEST_ASSERT_EQUAL(cases[i].status,
                          fxl_scene_open(image->words, image->size, &opened, &fault));
        if (cases[i].status == FXL_OK) {
            TEST_ASSERT_EQUAL_INT32(cases[i].scale, opened.scale);
            TEST_ASSERT_EQUAL(cases[i].has_centre, opened.lens.centre_x == Q16(-10));
        } else {
            TEST_ASSERT_EQUAL_STRING("lens", fault.what);
        }
    }
    tiny_image *image = tiny_image_make(false);
    const fxl_image_scale scale = {Q16(3)};
    fxl_scene_image opened;
    tiny_put32(tiny_at(image, AT_NEAR), 0);
    tiny_set_section(image, SECTION_LENS_SCALE, &scale, 1, sizeof scale);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_scene_open(image->words, image->size, &opened, NULL));
}

/* formats 1.2an */
void test_a_lens_with_a_moved_centre(void)
{
    tiny_image *image = image_with_centre(Q16(-10), Q16(40));
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_INT32(Q16(-10), opened.lens.centre_x);
    TEST_ASSERT_EQUAL_INT32(Q16(40), opened.lens.centre_y);
    TEST_ASSERT_TRUE(fxl_lens_is_valid(&opened.lens));
    TEST_ASSERT_NOT_NULL(opened.lens.off_centre);
    image = tiny_image_make(false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_INT32(Q16(24), opened.lens.centre_x);
    TEST_ASSERT_NULL(opened.lens.off_centre);
}

/* formats 1.2ax */
void test_a_wrong_centre_is_refused(void)
{
    expect_opening(FXL_E_RANGE, image_with_centre(Q16(24 + 72) + 1, 0));
    expect_opening(FXL_E_RANGE, image_with_centre(0, Q16(16 - 48) - 1));
    expect_opening(FXL_E_RESERVED, image_with_centre(Q16(24), Q16(16)));
    tiny_image *image = image_with_centre(0, 0);
    tiny_put32(tiny_at(image, AT_INSET), 1);
    tiny_seal(image);
    expect_opening(FXL_E_RANGE, image);
    image = image_with_centre(0, 0);
    tiny_put32(tiny_at(image, AT_SIZE), image->size - 4); /* it ends within the centre */
    expect_opening(FXL_E_OFFSET, image);
    image = image_with_centre(0, 0);
    tiny_put32(tiny_at(image, AT_MORE + 4), 2);
    expect_opening(FXL_E_COUNT, image);
}

/* formats 1.1i-n */
void test_lens(void)
{
    expect_half(FXL_E_RANGE, AT_WIDTH, 0);
    expect_half(FXL_E_RANGE, AT_HEIGHT, FXL_SCREEN_MAX + 1);
    expect_word(FXL_E_RANGE, AT_FOV, FXL_FOV_MIN - 1);
    expect_word(FXL_E_RANGE, AT_FOV, FXL_FOV_MAX + 1);
    expect_word(FXL_E_RANGE, AT_NEAR, 255);
    expect_word(FXL_E_RANGE, AT_FAR, 0x7FFFFFFFu);
    expect_word(FXL_E_RANGE, AT_FAR, (uint32_t)Q16(0.0625));
    expect_word(FXL_E_RANGE, AT_INSET, 0xFFFFFFFFu);
}
