/* SPDX-License-Identifier: MIT */
#include "expect_scene.h"

/* Whether an image has one of them: a fault there has no number. */
static bool is_one(const char *what)
{
    static const char *const ones[] = {"table", " map",       "image",
                                       "lens",  "start pose", "motion limits"};
    for (size_t i = 0; i < sizeof ones / sizeof ones[0]; i++) {
        if (strstr(what, ones[i]) != NULL) {
            return true;
        }
    }
    return false;
}

void expect_status(fxl_status status, const void *bytes, size_t size)
{
    fxl_scene_image opened, before;
    fxl_scene_fault fault = {"untouched", 12345};
    memset(&opened, 0x5A, sizeof opened);
    memcpy(&before, &opened, sizeof before);
    fxl_status actual = fxl_scene_open(bytes, size, &opened, &fault);
    TEST_ASSERT_EQUAL_STRING(fxl_status_text(status), fxl_status_text(actual));
    if (status == FXL_OK) {
        TEST_ASSERT_EQUAL_STRING("untouched", fault.what);
    } else {
        TEST_ASSERT_EQUAL_MEMORY(&before, &opened, sizeof before);
        TEST_ASSERT_NOT_NULL(fault.what);
        TEST_ASSERT_TRUE(strcmp(fault.what, "untouched") != 0);
        TEST_ASSERT_TRUE(is_one(fault.what) ? fault.index == 0 : fault.index != 12345);
        TEST_ASSERT_EQUAL(status, fxl_scene_open(bytes, size, &opened, NULL));
    }
}

void expect_opening(fxl_status status, tiny_image *image)
{
    tiny_seal(image);
    expect_status(status, image->words, image->size);
}

void expect_image_word(fxl_status status, tiny_image *image, uint32_t at, uint32_t value)
{
    tiny_put32(tiny_at(image, at), value);
    expect_opening(status, image);
}

void expect_image_half(fxl_status status, tiny_image *image, uint32_t at, uint16_t value)
{
    tiny_put16(tiny_at(image, at), value);
    expect_opening(status, image);
}

void expect_image_entry_word(fxl_status status, tiny_image *image, uint32_t table, uint32_t at,
                             uint32_t value)
{
    expect_image_word(status, image, tiny_get(image, table) + at, value);
}

void expect_word(fxl_status status, uint32_t at, uint32_t value)
{
    expect_image_word(status, tiny_image_make(false), at, value);
}

void expect_half(fxl_status status, uint32_t at, uint16_t value)
{
    expect_image_half(status, tiny_image_make(false), at, value);
}

void expect_entry_word(fxl_status status, uint32_t table, uint32_t number, uint32_t size,
                       uint32_t at, uint32_t value)
{
    tiny_image *image = tiny_image_make(false);
    tiny_put32(tiny_entry(image, table, number, size) + at, value);
    expect_opening(status, image);
}

void expect_entry_byte(fxl_status status, uint32_t table, uint32_t number, uint32_t size,
                       uint32_t at, uint8_t value)
{
    tiny_image *image = tiny_image_make(false);
    tiny_entry(image, table, number, size)[at] = value;
    expect_opening(status, image);
}
