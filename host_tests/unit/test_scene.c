/* SPDX-License-Identifier: MIT */
/* Opening a scene image: envelope, header and tables. What the tables hold is
 * tested in test_scene_contents.c, the lens in test_scene_lens.c. */
#include "expect_scene.h"

/* formats 1.1i-k, 1.1o, 1.1r, 1.1t-v, 1.2j-p */
void test_a_good_image_opens(void)
{
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    fxl_scene_fault fault = {"", 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_open(image->words, image->size, &opened, &fault),
                              fault.what);
    TEST_ASSERT_EQUAL_UINT32(16, opened.scene.vertex_count);
    TEST_ASSERT_EQUAL_UINT32(48, opened.scene.index_count);
    TEST_ASSERT_EQUAL_UINT32(12, opened.scene.face_count);
    TEST_ASSERT_EQUAL_UINT32(2, opened.scene.model_count);
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES, opened.scene.instance_count);
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES + 6, opened.scene.draw_list_needed);
    TEST_ASSERT_EQUAL_PTR(tiny_entry(image, AT_INSTANCES, 0, INSTANCE), opened.scene.instances);
    TEST_ASSERT_EQUAL_PTR(tiny_entry(image, AT_PALETTE, 0, 3), opened.palette);
    TEST_ASSERT_EQUAL(48, opened.lens.width);
    TEST_ASSERT_EQUAL(32, opened.lens.height);
    TEST_ASSERT_INT32_WITHIN(1, Q16(24), opened.lens.focal);
    TEST_ASSERT_EQUAL(200, opened.background);
    TEST_ASSERT_EQUAL_INT32(Q16(-5), opened.start.pose.position.z);
    TEST_ASSERT_EQUAL_INT32(0, opened.start.speed);
    TEST_ASSERT_EQUAL_UINT32(0, opened.start.clamped);
    TEST_ASSERT_EQUAL_INT32(Q16(2), opened.motion_limits.speed_max);
    TEST_ASSERT_EQUAL_HEX32(DEGREES(3), opened.motion_limits.turn);
    TEST_ASSERT_EQUAL_PTR(tiny_entry(image, AT_PATH, 0, POSE), opened.poses);
    TEST_ASSERT_NULL(opened.segments);
    TEST_ASSERT_EQUAL_UINT32(TINY_POSES, opened.path_count);
    TEST_ASSERT_EQUAL_UINT32(TINY_POSES, opened.frame_count);
}

/* formats 1.1v, 1.2q */
void test_a_path_of_strides_opens(void)
{
    tiny_image *image = tiny_image_make(true);
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.poses);
    TEST_ASSERT_EQUAL_PTR(tiny_entry(image, AT_PATH, 0, STRIDE), opened.segments);
    TEST_ASSERT_EQUAL_UINT32(TINY_STRIDES, opened.path_count);
    TEST_ASSERT_EQUAL_UINT32(7, opened.frame_count);
}

void test_memory_may_be_larger_than_the_image(void)
{
    tiny_image *image = tiny_image_make(false);
    expect_status(FXL_OK, image->words, sizeof image->words);
}

void test_null_is_refused(void)
{
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    expect_status(FXL_E_ARGUMENT, NULL, image->size);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_open(image->words, image->size, NULL, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_check(NULL, NULL));
    (void)opened;
}

/* formats 1.5a */
void test_misaligned_memory_is_refused(void)
{
    static uint32_t workspace[TINY_WORDS + 1];
    tiny_image *image = tiny_image_make(false);
    for (uint32_t shift = 1; shift < 4; shift++) {
        memcpy((uint8_t *)workspace + shift, image->words, image->size);
        expect_status(FXL_E_ALIGNMENT, (uint8_t *)workspace + shift, image->size);
    }
}

void test_every_truncation_is_refused(void)
{
    tiny_image *image = tiny_image_make(false);
    for (uint32_t size = 0; size < image->size; size++) {
        expect_status(FXL_E_SIZE, image->words, size);
    }
}

/* formats 1.1h, 1.5a */
void test_every_flipped_bit_is_refused(void)
{
    tiny_image *image = tiny_image_make(false);
    for (uint32_t bit = 0; bit < image->size * 8; bit++) {
        uint8_t *byte = tiny_at(image, bit / 8);
        fxl_scene_image opened;
        *byte = (uint8_t)(*byte ^ 1u << bit % 8);
        fxl_status status = fxl_scene_open(image->words, image->size, &opened, NULL);
        TEST_ASSERT_TRUE(status != FXL_OK);
        if (bit >= 12 * 8) {
            TEST_ASSERT_EQUAL(FXL_E_CRC, status);
        }
        *byte = (uint8_t)(*byte ^ 1u << bit % 8);
    }
    expect_status(FXL_OK, image->words, image->size);
}

/* A sealed image with wrong contents must end in a status, never a fault: the
 * sanitizers watch over the host's run. */
void test_any_contents_end_in_a_status(void)
{
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        tiny_image *image = tiny_image_make(i % 2 != 0);
        fxl_scene_image opened;
        for (uint32_t change = unit_random() % 3 + 1; change > 0; change--) {
            uint32_t at = 16 + unit_random() % (image->size - 16);
            if (unit_random() % 2) {
                at = 16 + unit_random() % (HEADER_SIZE - 16);
            }
            *tiny_at(image, at) = (uint8_t)unit_random();
        }
        tiny_seal(image);
        fxl_status status = fxl_scene_open(image->words, image->size, &opened, NULL);
        TEST_ASSERT_TRUE(status < FXL_STATUS_COUNT);
    }
}

/* formats 1.1b-f */
void test_head(void)
{
    expect_word(FXL_E_MAGIC, AT_MAGIC, 0x4C584653u);
    expect_word(FXL_E_MAGIC, AT_MAGIC, 0xFFFFFFFFu);
    expect_half(FXL_E_VERSION, AT_VERSION, 0);
    for (uint16_t older = 1; older < IMAGE_VERSION; older++) {
        expect_half(FXL_E_VERSION, AT_VERSION, older);
    }
    expect_half(FXL_E_VERSION, AT_VERSION, IMAGE_VERSION + 1);
    TEST_ASSERT_EQUAL_STRING("the scene image is of another version, or needs a section of another "
                             "version: build it again",
                             fxl_status_text(FXL_E_VERSION));
    expect_half(FXL_E_OFFSET, AT_SECTION_COUNT, TINY_SECTIONS + 1);
    expect_half(FXL_E_OFFSET, AT_SECTION_COUNT, TINY_SECTIONS - 1);
    expect_half(FXL_E_SIZE, AT_SECTION_COUNT, 0);
    expect_half(FXL_E_SIZE, AT_SECTION_COUNT, 0xFFFF);
}

/* formats 1.1g */
void test_size_of_the_image(void)
{
    tiny_image *image = tiny_image_make(false);
    uint32_t size = image->size;
    expect_word(FXL_E_SIZE, AT_SIZE, size + 4);
    expect_word(FXL_E_SIZE, AT_SIZE, 0);
    expect_word(FXL_E_SIZE, AT_SIZE, HEADER_SIZE - 4);
    expect_word(FXL_E_SIZE, AT_SIZE, AT_MORE - 8);   /* it ends within the table of sections */
    expect_word(FXL_E_OFFSET, AT_SIZE, AT_MORE - 4); /* it has no sections */
    expect_word(FXL_E_SIZE, AT_SIZE, 16 * 1024 * 1024 + 4);
    expect_word(FXL_E_SIZE, AT_SIZE, 0xFFFFFFFCu);
    expect_word(FXL_E_SIZE, AT_SIZE, size - 1);
    expect_word(FXL_E_OFFSET, AT_SIZE, size - 4);
}

/* An image with every fault: each check hides those behind it, until its fault is mended. */
/* formats 1.5a */
void test_checks_come_in_their_order(void)
{
    tiny_image *image = tiny_image_make(false);
    const struct {
        uint32_t at, flipped;
        fxl_status status;
    } faults[] = {{AT_MAGIC, 1, FXL_E_MAGIC},
                  {AT_VERSION, 1, FXL_E_VERSION},
                  {AT_SIZE, 0x80000000u, FXL_E_SIZE},
                  {AT_CRC, 1, FXL_E_CRC},
                  {HEADER_SIZE, 0x01000000u, FXL_E_RESERVED},
                  {HEADER_SIZE + SECTION_BYTES + 4, 4, FXL_E_OFFSET},
                  {AT_NEAR, tiny_get(image, AT_NEAR), FXL_E_RANGE},
                  {tiny_get(image, AT_FACES), 0x3FFFFFFF, FXL_E_NORMAL},
                  {tiny_get(image, AT_KEYS), 1, FXL_E_FACE_BOUNDS}};
    const size_t count = sizeof faults / sizeof faults[0];
    for (size_t i = 0; i < count; i++) {
        tiny_put32(tiny_at(image, faults[i].at),
                   tiny_get(image, faults[i].at) ^ faults[i].flipped);
    }
    for (size_t i = 0; i < count; i++) {
        expect_status(faults[i].status, image->words, image->size);
        tiny_put32(tiny_at(image, faults[i].at),
                   tiny_get(image, faults[i].at) ^ faults[i].flipped);
        if (faults[i].at >= AT_CRC) {
            tiny_seal(image);
        }
    }
    expect_status(FXL_OK, image->words, image->size);
}

/* formats 1.1w-x */
void test_reserved_fields_and_kinds(void)
{
    expect_word(FXL_E_RESERVED, AT_BSP_INSTANCE, 1); /* there is no tree */
    expect_word(FXL_E_RESERVED, AT_BLEND_FIRST, 1);  /* nor a blend table */
    expect_entry_byte(FXL_E_RESERVED, AT_MODELS, 1, MODEL, 16, 2);
    expect_entry_byte(FXL_E_RESERVED, AT_MODELS, 1, MODEL, 17, 1);
    expect_entry_byte(FXL_E_RESERVED, AT_MODELS, 1, MODEL, 19, 1);
    expect_entry_byte(FXL_E_RESERVED, AT_INSTANCES, 2, INSTANCE, 15, 1);
}

/* formats 1.1p-q */
void test_the_target_that_an_image_asks_for(void)
{
    for (uint32_t wanted = 0; wanted < 256; wanted++) {
        tiny_image *image = tiny_image_make(false);
        fxl_scene_image opened = {.depth_bits = 77};
        *tiny_at(image, AT_TARGET) = (uint8_t)wanted;
        tiny_at(image, AT_TARGET)[1] = 0x34;
        tiny_at(image, AT_TARGET)[2] = 0x12;
        tiny_seal(image);
        const bool is_known = wanted < 16 && (wanted & 3) != 3;
        TEST_ASSERT_EQUAL(is_known ? FXL_OK : FXL_E_RESERVED,
                          fxl_scene_open(image->words, image->size, &opened, NULL));
        TEST_ASSERT_EQUAL_UINT8(is_known ? 16 * (wanted & 3) : 77, opened.depth_bits);
        if (is_known) {
            TEST_ASSERT_EQUAL_UINT8(wanted & 4 ? 16 : 8, opened.pixel_bits);
            TEST_ASSERT_EQUAL((wanted & 8) != 0, opened.by_distance);
            TEST_ASSERT_EQUAL_HEX16(0x1234, opened.light.dark);
        }
    }
}

/* formats 1.1r-u */
void test_start_and_gait(void)
{
    for (uint32_t axis = 0; axis < 12; axis += 4) {
        expect_word(FXL_E_RANGE, AT_START + axis, (uint32_t)FXL_COORDINATE_MAX + 1);
        expect_word(FXL_E_RANGE, AT_START + axis, 0x80000000u);
        expect_word(FXL_E_RANGE, AT_MOTION_LIMITS + axis, (uint32_t)FXL_MOTION_MAX + 1);
        expect_word(FXL_E_RANGE, AT_MOTION_LIMITS + axis, 0xFFFFFFFFu);
    }
    expect_word(FXL_E_RANGE, AT_MOTION_LIMITS + 12, FXL_ANGLE_QUARTER + 1);
    expect_word(FXL_OK, AT_START + 12, 0xFFFFFFFFu);
}

void test_offsets_of_every_table(void)
{
    uint32_t size = tiny_image_make(false)->size;
    for (uint32_t table = AT_PALETTE; table <= AT_KEYS; table += SECTION_BYTES) {
        uint32_t offset = tiny_get(tiny_image_make(false), table);
        expect_word(FXL_E_OFFSET, table, size);
        expect_word(FXL_E_OFFSET, table, 0xFFFFFFFCu);
        expect_word(FXL_E_OFFSET, table, 0x80000000u);
        expect_word(FXL_E_OFFSET, table, 0);
        expect_word(FXL_E_OFFSET, table, offset - 4);
        expect_word(FXL_E_OFFSET, table, offset + 4);
        expect_word(FXL_E_ALIGNMENT, table, offset + 1);
        expect_word(FXL_E_ALIGNMENT, table, offset + 2);
    }
}

/* formats 1.2j-p, 1.2r */
void test_counts_of_every_table(void)
{
    static const struct {
        uint32_t table, most;
    } tables[] = {{AT_PALETTE, 256},   {AT_VERTICES, 1000000}, {AT_CORNERS, 4000000},
                  {AT_FACES, 1000000}, {AT_MODELS, 65535},     {AT_INSTANCES, 65535},
                  {AT_PATH, 1000000},  {AT_KEYS, 1000000}};
    for (uint32_t i = 0; i < sizeof tables / sizeof tables[0]; i++) {
        expect_word(FXL_E_COUNT, tables[i].table + 4, 0);
        expect_word(FXL_E_COUNT, tables[i].table + 4, tables[i].most + 1);
        expect_word(FXL_E_COUNT, tables[i].table + 4, 0xFFFFFFFFu);
        if (tables[i].table != AT_PALETTE) {
            expect_word(FXL_E_OFFSET, tables[i].table + 4, tables[i].most);
        }
    }
    static const uint8_t palette[255][3];
    tiny_image *image = tiny_image_make(false);
    tiny_set_section(image, SECTION_PALETTE, palette, 255, sizeof palette[0]);
    expect_opening(FXL_E_COUNT, image);
}

/* Face 3 is a part of one whose indices begin at a number; of all others nothing is said. */
/* formats 1.2ao, 1.2av, 1.5a */
void test_whole_faces(void)
{
    static const struct {
        uint32_t whole;
        fxl_status status;
    } cases[] = {{FXL_WHOLE(8, 4), FXL_OK},        {FXL_WHOLE(24, 24), FXL_OK},
                 {FXL_WHOLE(25, 24), FXL_E_INDEX}, {FXL_WHOLE(49, 3), FXL_E_INDEX},
                 {FXL_WHOLE(8, 2), FXL_E_COUNT},   {FXL_WHOLE(8, 25), FXL_E_COUNT},
                 {FXL_WHOLE(8, 0), FXL_E_COUNT},   {0xFFFFFFE4u, FXL_E_INDEX}};
    for (uint32_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        uint32_t wholes[12] = {0};
        tiny_image *image = tiny_image_make(false);
        wholes[3] = cases[i].whole;
        tiny_set_section(image, SECTION_WHOLE_FACES, wholes, 12, sizeof wholes[0]);
        expect_opening(cases[i].status, image);
        tiny_set_section(image, SECTION_WHOLE_FACES, wholes, 11, sizeof wholes[0]);
        expect_opening(FXL_E_COUNT, image);
    }
}

/* The last table ends where the image does: one entry more reaches outside. */
void test_one_entry_too_many_reaches_outside(void)
{
    expect_word(FXL_E_OFFSET, AT_KEYS + 4, 7);
}

/* Of the sections' entries: kinds rise, none comes twice, and each says whether it is needed. */
/* formats 1.2a-b */
void test_entries_of_the_table_of_sections(void)
{
    for (uint32_t i = 0; i < TINY_SECTIONS; i++) {
        const uint32_t at = HEADER_SIZE + SECTION_BYTES * i;
        const uint32_t kind = tiny_get(tiny_image_make(false), at);
        expect_word(FXL_E_OFFSET, at, kind & ~0xFFFFu); /* kind 0 */
        expect_word(FXL_E_RESERVED, at, kind ^ 0x10000u);
        expect_word(FXL_E_RESERVED, at, (kind & 0xFFFFu) | 0x20000u);
        expect_word(FXL_E_RESERVED, at, kind | 0x01000000u);
        if (i > 0) {
            expect_word(FXL_E_OFFSET, at, tiny_get(tiny_image_make(false), at - SECTION_BYTES));
        }
    }
}

/* formats 1.2 */
/* A path is poses or segments, and not both. */
void test_an_image_has_one_path(void)
{
    const fxl_path_segment stride = {FXL_KEY_FORWARD, 2};
    tiny_image *image = tiny_image_make(false);
    tiny_set_section(image, SECTION_SEGMENTS, &stride, 1, sizeof stride);
    expect_opening(FXL_E_COUNT, image);
    tiny_set_section(image, SECTION_POSES, NULL, 0, 0);
    expect_opening(FXL_OK, image);
    tiny_set_section(image, SECTION_SEGMENTS, NULL, 0, 0);
    expect_opening(FXL_E_COUNT, image);
}

/* formats 1.1v, 1.4b */
void test_a_path_has_a_million_frames_at_most(void)
{
    for (uint32_t more = 0; more < 2; more++) {
        fxl_path_segment stretches[17];
        tiny_image *image = tiny_image_make(false);
        for (uint32_t i = 0; i < 17; i++) {
            stretches[i] = (fxl_path_segment){FXL_KEY_FORWARD, 60000};
        }
        stretches[16].frames = (uint16_t)(40000 + more);
        tiny_set_section(image, SECTION_POSES, NULL, 0, 0);
        tiny_set_section(image, SECTION_SEGMENTS, stretches, 17, sizeof stretches[0]);
        image->words[80 / 4] = FXL_SCENE_PATH_MAX + more;
        expect_opening(more == 0 ? FXL_OK : FXL_E_COUNT, image);
    }
}

/* The bytes that rounding adds behind a section are 0. */
/* formats 1.2d */
void test_padding_is_zero(void)
{
    tiny_image *image = tiny_image_make(false);
    uint16_t corners[49];
    memcpy(corners, tiny_entry(image, AT_CORNERS, 0, CORNER), 48 * CORNER);
    corners[48] = 0; /* of no face */
    tiny_set_section(image, SECTION_INDICES, corners, 49, sizeof corners[0]);
    expect_opening(FXL_OK, image);
    for (uint32_t byte = 0; byte < 2; byte++) {
        tiny_set_section(image, SECTION_INDICES, corners, 49, sizeof corners[0]);
        tiny_entry(image, AT_CORNERS, 49, CORNER)[byte] = 1;
        expect_opening(FXL_E_RESERVED, image);
    }
}

/* A section of a later version: passed over if it is not needed, whatever its length. */
/* formats 1.2e-f, 1.2h */
void test_a_section_that_is_not_known(void)
{
    static const uint32_t bytes[3] = {1, 2, 3};
    for (uint32_t count = 1; count <= 3; count++) {
        tiny_image *image = tiny_image_make(false);
        fxl_scene_image opened;
        fxl_scene_fault fault = {"nothing", 99};
        tiny_set_section(image, SECTION_KINDS, bytes, count, sizeof bytes[0]);
        tiny_put16(tiny_at(image, AT_MORE - 2), 0); /* not needed */
        expect_opening(FXL_OK, image);
        tiny_set_section(image, SECTION_KINDS + 1, bytes, count, sizeof bytes[0]);
        tiny_put16(tiny_at(image, AT_MORE - 2), 0);
        tiny_seal(image);
        TEST_ASSERT_EQUAL(FXL_E_VERSION,
                          fxl_scene_open(image->words, image->size, &opened, &fault));
        TEST_ASSERT_EQUAL_STRING("section", fault.what);
        TEST_ASSERT_EQUAL_UINT32(TINY_SECTIONS + 1, fault.index);
        tiny_put16(tiny_at(image, AT_MORE + SECTION_BYTES - 2), 0);
        expect_opening(FXL_OK, image);
        /* It may begin later than where the section before it does, and not earlier. */
        tiny_put32(tiny_at(image, AT_MORE + SECTION_BYTES), image->size);
        expect_opening(FXL_OK, image);
        tiny_put32(tiny_at(image, AT_MORE + SECTION_BYTES), image->size + 4);
        expect_opening(FXL_E_OFFSET, image);
        tiny_put32(tiny_at(image, AT_MORE + SECTION_BYTES), tiny_get(image, AT_MORE) - 4);
        expect_opening(FXL_E_OFFSET, image);
        tiny_put32(tiny_at(image, AT_MORE + SECTION_BYTES), tiny_get(image, AT_MORE) + 2);
        expect_opening(FXL_E_ALIGNMENT, image);
    }
}
