/* SPDX-License-Identifier: MIT */
/* Billboards in a scene image: sections of billboards, of the map and of the sprites' pixels. */
#include "expect_scene.h"
#include "fixel/billboards.h"

enum {
    AT_BOARDS = AT_KEYS, /* the image has no face bounds */
    AT_MAP = AT_BOARDS + SECTION_BYTES,
    AT_PIXELS = AT_MAP + SECTION_BYTES,
    BOARDS = 3,
    PIXELS = 64
};

static fxl_sprite sprites[BOARDS];
static fxl_billboard boards[BOARDS];
static fxl_billboard_set set;

/* 5 x 4 pixels of 8 bits, 7 x 3 of 4, 9 x 2 of 1. */
static const fxl_scene_billboard records[BOARDS] = {{.pixel_width = 5,
                                                     .pixel_height = 4,
                                                     .key = 256,
                                                     .bits = 8,
                                                     .width = Q16(1),
                                                     .height = Q16(0.5),
                                                     .anchor_x = Q16(0.5)},
                                                    {.pixels = 20,
                                                     .colours = 32,
                                                     .pixel_width = 7,
                                                     .pixel_height = 3,
                                                     .key = 2,
                                                     .bits = 4,
                                                     .width = Q16(0.75),
                                                     .height = Q16(1.5),
                                                     .anchor_x = Q16(0.25),
                                                     .anchor_y = Q16(1)},
                                                    {.pixels = 60,
                                                     .colours = 62,
                                                     .pixel_width = 9,
                                                     .pixel_height = 1,
                                                     .bits = 1,
                                                     .width = 1,
                                                     .height = 1}};

/* Tiny's image, whose second model has one face and shows the second billboard. */
static tiny_image *make(void)
{
    static const uint16_t map[2] = {0, 2};
    uint8_t pixels[PIXELS];
    tiny_image *image = tiny_image_make(false);
    for (uint32_t i = 0; i < sizeof pixels; i++) {
        pixels[i] = (uint8_t)(5 * i);
    }
    tiny_set_section(image, SECTION_FACES, tiny_make()->faces, 7, FACE);
    tiny_set_section(image, SECTION_FACE_BOUNDS, NULL, 0, 0);
    tiny_set_section(image, SECTION_BILLBOARDS, records, BOARDS, sizeof records[0]);
    tiny_set_section(image, SECTION_BILLBOARD_MAP, map, 2, sizeof map[0]);
    tiny_set_section(image, SECTION_SPRITE_PIXELS, pixels, PIXELS, 1);
    uint8_t *model = tiny_entry(image, AT_MODELS, 1, MODEL);
    tiny_put32(model + 12, 1);
    model[16] = FXL_MODEL_CONVEX;
    tiny_seal(image);
    return image;
}

/* What fxl_scene_open answers. */
static void header_word(fxl_status status, uint32_t offset, uint32_t value)
{
    expect_image_word(status, make(), offset, value);
}

/* What fxl_billboards_open answers, and what is at fault. */
static void expect_boards(fxl_status status, const char *what, uint32_t index, tiny_image *image)
{
    fxl_scene_image opened;
    fxl_scene_fault fault = {"nothing", 99};
    fxl_billboard_set before;
    memset(&set, 0x5A, sizeof set);
    memset(&before, 0x5A, sizeof before);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL(status, fxl_billboards_open(&opened, sprites, boards, BOARDS, &set, &fault));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
    TEST_ASSERT_EQUAL_UINT32(index, fault.index);
    if (status != FXL_OK) {
        TEST_ASSERT_EQUAL_MEMORY(&before, &set, sizeof set);
    }
}

static void board_word(fxl_status status, uint32_t number, uint32_t at, uint32_t value)
{
    tiny_image *image = make();
    tiny_put32(tiny_entry(image, AT_BOARDS, number, sizeof records[0]) + at, value);
    expect_boards(status, status == FXL_OK ? "nothing" : "billboard",
                  status == FXL_OK ? 99 : number, image);
}

static void board_byte(fxl_status status, uint32_t number, uint32_t at, uint8_t value)
{
    tiny_image *image = make();
    tiny_entry(image, AT_BOARDS, number, sizeof records[0])[at] = value;
    expect_boards(status, "billboard", number, image);
}

/* formats 1.13, 1.2ak-am, billboards 5.1b */
void test_billboards_are_used_in_place(void)
{
    tiny_image *image = make();
    const uint8_t *pixels = tiny_at(image, tiny_get(image, AT_PIXELS));
    expect_boards(FXL_OK, "nothing", 99, image);
    TEST_ASSERT_EQUAL_PTR(boards, set.billboards);
    TEST_ASSERT_EQUAL_UINT32(BOARDS, set.count);
    TEST_ASSERT_EQUAL_PTR(tiny_at(image, tiny_get(image, AT_MAP)), set.model_map);
    TEST_ASSERT_EQUAL_PTR(&sprites[1], boards[1].sprite);
    TEST_ASSERT_EQUAL_INT32(Q16(0.75), boards[1].width);
    TEST_ASSERT_EQUAL_INT32(Q16(1.5), boards[1].height);
    TEST_ASSERT_EQUAL_INT32(Q16(0.25), boards[1].anchor_x);
    TEST_ASSERT_EQUAL_INT32(Q16(1), boards[1].anchor_y);
    TEST_ASSERT_EQUAL_PTR(pixels, sprites[0].pixels);
    TEST_ASSERT_NULL(sprites[0].colours);
    TEST_ASSERT_EQUAL_UINT16(FXL_SPRITE_OPAQUE, sprites[0].key);
    TEST_ASSERT_EQUAL_PTR(pixels + 20, sprites[1].pixels);
    TEST_ASSERT_EQUAL_PTR(pixels + 32, sprites[1].colours);
    TEST_ASSERT_EQUAL_UINT16(7, sprites[1].width);
    TEST_ASSERT_EQUAL_UINT16(3, sprites[1].height);
    TEST_ASSERT_EQUAL_UINT8(4, sprites[1].bits);
    TEST_ASSERT_EQUAL_UINT16(2, sprites[1].key);
    TEST_ASSERT_EQUAL_PTR(pixels + 62, sprites[2].colours);
}

void test_an_image_may_have_no_billboards(void)
{
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.billboards.model_map);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_billboards_open(&opened, sprites, boards, BOARDS, &set, NULL));
}

void test_null_pointers_and_too_few_records(void)
{
    tiny_image *image = make();
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.surfaces.face_map);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_billboards_open(NULL, sprites, boards, BOARDS, &set, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_billboards_open(&opened, NULL, boards, BOARDS, &set, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_billboards_open(&opened, sprites, NULL, BOARDS, &set, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_billboards_open(&opened, sprites, boards, BOARDS, NULL, NULL));
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY,
                      fxl_billboards_open(&opened, sprites, boards, BOARDS - 1, &set, NULL));
    fxl_sprite *const odd_sprites = (fxl_sprite *)(void *)((uint8_t *)sprites + 2);
    fxl_billboard *const odd_boards = (fxl_billboard *)(void *)((uint8_t *)boards + 2);
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT,
                      fxl_billboards_open(&opened, odd_sprites, boards, BOARDS - 1, &set, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT,
                      fxl_billboards_open(&opened, sprites, odd_boards, BOARDS - 1, &set, NULL));
}

void test_the_sections_of_billboards(void)
{
    static const uint16_t kinds[] = {SECTION_BILLBOARDS, SECTION_BILLBOARD_MAP,
                                     SECTION_SPRITE_PIXELS};
    static const uint16_t map[3] = {0, 2, 0};
    header_word(FXL_OK, AT_INSET, 0);
    header_word(FXL_E_COUNT, AT_BOARDS + 4, 0);
    header_word(FXL_E_COUNT, AT_BOARDS + 4, 65536);
    header_word(FXL_E_OFFSET, AT_BOARDS, 316);
    header_word(FXL_E_ALIGNMENT, AT_BOARDS, 322);
    header_word(FXL_E_COUNT, AT_MAP + 4, 0);
    header_word(FXL_E_COUNT, AT_PIXELS + 4, 0);
    header_word(FXL_E_OFFSET, AT_PIXELS + 4, PIXELS + 4);
    for (int i = 0; i < 3; i++) {
        tiny_image *image = make();
        tiny_set_section(image, kinds[i], NULL, 0, 0);
        expect_opening(FXL_E_COUNT, image);
    }
    for (uint32_t count = 1; count <= 3; count++) { /* an entry for each model */
        tiny_image *image = make();
        tiny_set_section(image, SECTION_BILLBOARD_MAP, map, count, sizeof map[0]);
        expect_opening(count == 2 ? FXL_OK : FXL_E_COUNT, image);
    }
}

/* formats 1.13d, billboards 1.2c-f */
void test_a_billboard_out_of_range(void)
{
    board_word(FXL_OK, 0, 0, PIXELS - 20);
    board_word(FXL_E_OFFSET, 0, 0, PIXELS - 19);
    board_word(FXL_E_OFFSET, 0, 0, UINT32_MAX);
    board_word(FXL_E_RESERVED, 0, 4, 1);
    board_word(FXL_OK, 1, 4, PIXELS - 16);
    board_word(FXL_E_OFFSET, 1, 4, PIXELS - 15);
    board_word(FXL_E_OFFSET, 2, 4, PIXELS - 1);
    board_word(FXL_E_OFFSET, 0, 8, 65535u << 16 | 65535u); /* its bytes are nearly 2^32 */
    board_word(FXL_E_RANGE, 0, 8, 5);                      /* no row */
    board_byte(FXL_E_RANGE, 0, 14, 2);
    board_byte(FXL_E_RANGE, 1, 13, 2); /* a key above 256 */
    board_byte(FXL_E_RESERVED, 1, 15, 1);
    board_word(FXL_E_RANGE, 1, 16, 0);
    board_word(FXL_E_RANGE, 1, 20, (uint32_t)FXL_BILLBOARD_SIDE_MAX + 1);
    board_word(FXL_E_RANGE, 1, 24, Q16(0.75) + 1);
}

/* billboards 1.1b-c, formats 1.13c */
void test_models_that_do_not_fit(void)
{
    tiny_image *image = make();
    tiny_put16(tiny_entry(image, AT_MAP, 1, 2), 4);
    expect_boards(FXL_E_INDEX, "model", 1, image);
    image = make();
    tiny_put16(tiny_entry(image, AT_MAP, 0, 2), 1); /* a cube */
    expect_boards(FXL_E_COUNT, "model", 0, image);
    image = make();
    tiny_put32(tiny_entry(image, AT_BOARDS, 1, sizeof records[0]) + 20, Q16(3));
    expect_boards(FXL_E_RADIUS, "model", 1, image);
}
