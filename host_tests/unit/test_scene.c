/* SPDX-License-Identifier: MIT */
#include "tiny.h"

enum { VERTEX = 12, CORNER = 2, FACE = 20, MODEL = 20, OBJECT = 16, POSE = 24, STRIDE = 4 };

static void expect_status(fxl_status status, const void *bytes, size_t size)
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
        TEST_ASSERT_EQUAL(status, fxl_scene_open(bytes, size, &opened, NULL));
    }
}

/* Seals what the test has changed, and opens it. */
static void expect(fxl_status status, tiny_image *image)
{
    tiny_seal(image);
    expect_status(status, image->words, image->size);
}

static void expect_word(fxl_status status, uint32_t at, uint32_t value)
{
    tiny_image *image = tiny_image_make(false);
    tiny_put32(tiny_at(image, at), value);
    expect(status, image);
}

static void expect_half(fxl_status status, uint32_t at, uint16_t value)
{
    tiny_image *image = tiny_image_make(false);
    tiny_put16(tiny_at(image, at), value);
    expect(status, image);
}

/* One changed word (or byte) in the first entry but `number` of a table. */
static void expect_entry_word(fxl_status status, uint32_t table, uint32_t number, uint32_t size,
                              uint32_t at, uint32_t value)
{
    tiny_image *image = tiny_image_make(false);
    tiny_put32(tiny_entry(image, table, number, size) + at, value);
    expect(status, image);
}

static void expect_entry_byte(fxl_status status, uint32_t table, uint32_t number, uint32_t size,
                              uint32_t at, uint8_t value)
{
    tiny_image *image = tiny_image_make(false);
    tiny_entry(image, table, number, size)[at] = value;
    expect(status, image);
}

void test_a_good_image_opens(void)
{
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    fxl_scene_fault fault = {"", 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_open(image->words, image->size, &opened, &fault),
                              fault.what);
    TEST_ASSERT_EQUAL_UINT32(16, opened.scene.vertex_count);
    TEST_ASSERT_EQUAL_UINT32(48, opened.scene.corner_count);
    TEST_ASSERT_EQUAL_UINT32(12, opened.scene.face_count);
    TEST_ASSERT_EQUAL_UINT32(2, opened.scene.model_count);
    TEST_ASSERT_EQUAL_UINT32(TINY_OBJECTS, opened.scene.object_count);
    TEST_ASSERT_EQUAL_UINT32(TINY_OBJECTS + 6, opened.scene.order_needed);
    TEST_ASSERT_EQUAL_PTR(tiny_entry(image, AT_OBJECTS, 0, OBJECT), opened.scene.objects);
    TEST_ASSERT_EQUAL_PTR(tiny_entry(image, AT_PALETTE, 0, 3), opened.palette);
    TEST_ASSERT_EQUAL(48, opened.lens.width);
    TEST_ASSERT_EQUAL(32, opened.lens.height);
    TEST_ASSERT_INT32_WITHIN(1, Q16(24), opened.lens.focal);
    TEST_ASSERT_EQUAL(200, opened.background);
    TEST_ASSERT_EQUAL_INT32(Q16(-5), opened.start.pose.position.z);
    TEST_ASSERT_EQUAL_INT32(0, opened.start.speed);
    TEST_ASSERT_EQUAL_UINT32(0, opened.start.clamped);
    TEST_ASSERT_EQUAL_INT32(Q16(2), opened.gait.speed_max);
    TEST_ASSERT_EQUAL_HEX32(DEGREES(3), opened.gait.turn);
    TEST_ASSERT_EQUAL_PTR(tiny_entry(image, AT_PATH, 0, POSE), opened.poses);
    TEST_ASSERT_NULL(opened.strides);
    TEST_ASSERT_EQUAL_UINT32(TINY_POSES, opened.path_count);
    TEST_ASSERT_EQUAL_UINT32(TINY_POSES, opened.frame_count);
}

void test_a_path_of_strides_opens(void)
{
    tiny_image *image = tiny_image_make(true);
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.poses);
    TEST_ASSERT_EQUAL_PTR(tiny_entry(image, AT_PATH, 0, STRIDE), opened.strides);
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

void test_misaligned_memory_is_refused(void)
{
    static uint32_t room[1025];
    tiny_image *image = tiny_image_make(false);
    for (uint32_t shift = 1; shift < 4; shift++) {
        memcpy((uint8_t *)room + shift, image->words, image->size);
        expect_status(FXL_E_ALIGNMENT, (uint8_t *)room + shift, image->size);
    }
}

void test_every_truncation_is_refused(void)
{
    tiny_image *image = tiny_image_make(false);
    for (uint32_t size = 0; size < image->size; size++) {
        expect_status(FXL_E_SIZE, image->words, size);
    }
}

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

void test_head(void)
{
    expect_word(FXL_E_MAGIC, AT_MAGIC, 0x4C584653u);
    expect_word(FXL_E_MAGIC, AT_MAGIC, 0xFFFFFFFFu);
    expect_half(FXL_E_VERSION, AT_VERSION, 0);
    expect_half(FXL_E_VERSION, AT_VERSION, 2);
    expect_half(FXL_E_SIZE, AT_HEADER_SIZE, 156);
    expect_half(FXL_E_SIZE, AT_HEADER_SIZE, 164);
}

void test_size_of_the_image(void)
{
    tiny_image *image = tiny_image_make(false);
    uint32_t size = image->size;
    expect_word(FXL_E_SIZE, AT_SIZE, size + 4);
    expect_word(FXL_E_SIZE, AT_SIZE, 0);
    expect_word(FXL_E_SIZE, AT_SIZE, HEADER_SIZE - 4);
    expect_word(FXL_E_SIZE, AT_SIZE, 16 * 1024 * 1024 + 4);
    expect_word(FXL_E_SIZE, AT_SIZE, 0xFFFFFFFCu);
    expect_word(FXL_E_SIZE, AT_SIZE, size - 1);
    expect_word(FXL_E_OFFSET, AT_SIZE, size - 4);
}

void test_the_checksum_comes_before_the_contents(void)
{
    tiny_image *image = tiny_image_make(false);
    tiny_put32(tiny_at(image, AT_NEAR), 0);
    expect_status(FXL_E_CRC, image->words, image->size);
    expect(FXL_E_RANGE, image);
}

void test_reserved_fields_and_kinds(void)
{
    expect_half(FXL_E_RESERVED, AT_RESERVED_HALF, 1);
    for (uint32_t at = 0; at < 20; at += 4) {
        expect_word(FXL_E_RESERVED, AT_RESERVED + at, 0x01000000u);
    }
    tiny_image *image = tiny_image_make(false);
    *tiny_at(image, AT_PATH_KIND) = 2;
    expect(FXL_E_RESERVED, image);
    expect_entry_byte(FXL_E_RESERVED, AT_FACES, 3, FACE, 18, 1);
    expect_entry_byte(FXL_E_RESERVED, AT_FACES, 3, FACE, 19, 1);
    expect_entry_byte(FXL_E_RESERVED, AT_MODELS, 1, MODEL, 16, 2);
    expect_entry_byte(FXL_E_RESERVED, AT_MODELS, 1, MODEL, 17, 1);
    expect_entry_byte(FXL_E_RESERVED, AT_MODELS, 1, MODEL, 19, 1);
    expect_entry_byte(FXL_E_RESERVED, AT_OBJECTS, 2, OBJECT, 15, 1);
}

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

void test_start_and_gait(void)
{
    for (uint32_t axis = 0; axis < 12; axis += 4) {
        expect_word(FXL_E_RANGE, AT_START + axis, (uint32_t)FXL_COORDINATE_MAX + 1);
        expect_word(FXL_E_RANGE, AT_START + axis, 0x80000000u);
        expect_word(FXL_E_RANGE, AT_GAIT + axis, (uint32_t)FXL_GAIT_MAX + 1);
        expect_word(FXL_E_RANGE, AT_GAIT + axis, 0xFFFFFFFFu);
    }
    expect_word(FXL_E_RANGE, AT_GAIT + 12, FXL_ANGLE_QUARTER + 1);
    expect_word(FXL_OK, AT_START + 12, 0xFFFFFFFFu);
}

void test_offsets_of_every_table(void)
{
    uint32_t size = tiny_image_make(false)->size;
    for (uint32_t table = AT_PALETTE; table <= AT_PATH; table += 8) {
        uint32_t offset = tiny_get(tiny_image_make(false), table);
        expect_word(FXL_E_OFFSET, table, size);
        expect_word(FXL_E_OFFSET, table, 0xFFFFFFFCu);
        expect_word(FXL_E_OFFSET, table, 0x80000000u);
        expect_word(FXL_E_OFFSET, table, 0);
        expect_word(FXL_E_OFFSET, table, HEADER_SIZE - 4);
        expect_word(FXL_E_ALIGNMENT, table, offset + 1);
        expect_word(FXL_E_ALIGNMENT, table, offset + 2);
    }
}

void test_counts_of_every_table(void)
{
    static const struct {
        uint32_t table, least, most;
    } tables[] = {{AT_PALETTE, 256, 256},     {AT_VERTICES, 3, 1000000}, {AT_CORNERS, 3, 4000000},
                  {AT_FACES, 1, 1000000},     {AT_MODELS, 1, 65535},     {AT_OBJECTS, 1, 65535},
                  {AT_PATH, 1, 1000000}};
    for (uint32_t i = 0; i < 7; i++) {
        expect_word(FXL_E_COUNT, tables[i].table + 4, tables[i].least - 1);
        expect_word(FXL_E_COUNT, tables[i].table + 4, tables[i].most + 1);
        expect_word(FXL_E_COUNT, tables[i].table + 4, 0xFFFFFFFFu);
        if (tables[i].table != AT_PALETTE) {
            expect_word(FXL_E_OFFSET, tables[i].table + 4, tables[i].most);
        }
    }
}

/* The last table ends where the image does: one entry more reaches outside. */
void test_one_entry_too_many_reaches_outside(void)
{
    expect_word(FXL_E_OFFSET, AT_PATH + 4, TINY_POSES + 1);
}

void test_face_contents(void)
{
    expect_entry_byte(FXL_E_COUNT, AT_FACES, 5, FACE, 16, 2);
    expect_entry_byte(FXL_E_COUNT, AT_FACES, 5, FACE, 16, 25);
    expect_entry_word(FXL_E_INDEX, AT_FACES, 5, FACE, 12, 45);
    expect_entry_word(FXL_E_INDEX, AT_FACES, 5, FACE, 12, 0xFFFFFFFFu);
    expect_entry_word(FXL_E_INDEX, AT_FACES, 5, FACE, 12, 0xFFFFFFFDu);
}

void test_corner_contents(void)
{
    tiny_image *image = tiny_image_make(false);
    tiny_put16(tiny_entry(image, AT_CORNERS, 13, CORNER), 8);
    expect(FXL_E_INDEX, image);
    image = tiny_image_make(false);
    tiny_put16(tiny_entry(image, AT_CORNERS, 47, CORNER), 65535);
    expect(FXL_E_INDEX, image);
}

void test_model_contents(void)
{
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 0, 9);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 0, 0xFFFFFFFCu);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 4, 9);
    expect_entry_word(FXL_E_COUNT, AT_MODELS, 1, MODEL, 4, 2);
    expect_entry_word(FXL_E_COUNT, AT_MODELS, 1, MODEL, 4, 65536);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 8, 7);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 8, 0xFFFFFFFCu);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 12, 7);
    expect_entry_word(FXL_E_COUNT, AT_MODELS, 1, MODEL, 12, 0);
    expect_entry_word(FXL_E_COUNT, AT_MODELS, 1, MODEL, 12, 65536);
}

void test_object_contents(void)
{
    tiny_image *image = tiny_image_make(false);
    tiny_put16(tiny_entry(image, AT_OBJECTS, 2, OBJECT) + 12, 2);
    expect(FXL_E_INDEX, image);
    for (uint32_t axis = 0; axis < 12; axis += 4) {
        uint32_t end = (uint32_t)FXL_COORDINATE_MAX;
        expect_entry_word(FXL_E_RANGE, AT_OBJECTS, 1, OBJECT, axis, end + 1);
        expect_entry_word(FXL_E_RANGE, AT_OBJECTS, 1, OBJECT, axis, 0x80000000u);
        /* The centre in range, a vertex a unit outside, and just inside. */
        expect_entry_word(FXL_E_RANGE, AT_OBJECTS, 1, OBJECT, axis, end - (uint32_t)Q16(1) + 1);
        expect_entry_word(FXL_OK, AT_OBJECTS, 1, OBJECT, axis, end - (uint32_t)Q16(1));
        expect_entry_word(FXL_E_RANGE, AT_OBJECTS, 1, OBJECT, axis, 0u - end + (uint32_t)Q16(1) - 1);
        expect_entry_word(FXL_OK, AT_OBJECTS, 1, OBJECT, axis, 0u - end + (uint32_t)Q16(1));
    }
}

void test_vertices_far_out_do_not_wrap(void)
{
    expect_entry_word(FXL_E_RANGE, AT_VERTICES, 3, VERTEX, 4, 0x7FFFFFFFu);
    expect_entry_word(FXL_E_RANGE, AT_VERTICES, 3, VERTEX, 4, 0x80000000u);
}

void test_normals(void)
{
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 0, 0);
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 0, 0x7FFFFFFFu);
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 0, 0x80000000u);
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 8, 0x80000000u);
    /* (2^30 + 2)^2 - 2^60 = 2^32 + 4: a little too long; 2^30 + 1 will do. */
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 0, (1u << 30) + 2);
    expect_entry_word(FXL_OK, AT_FACES, 1, FACE, 0, (1u << 30) + 1);
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 0, (1u << 30) - 3);
    expect_entry_word(FXL_OK, AT_FACES, 1, FACE, 0, (1u << 30) - 2);
}

/* Vertex 5 of model 0 belongs to a face +x: off its plane by 4 units at most. */
void test_planarity(void)
{
    uint32_t x = (uint32_t)Q16(1);
    expect_entry_word(FXL_OK, AT_VERTICES, 5, VERTEX, 0, x + 4);
    expect_entry_word(FXL_OK, AT_VERTICES, 5, VERTEX, 0, x - 4);
    expect_entry_word(FXL_E_PLANARITY, AT_VERTICES, 5, VERTEX, 0, x + 5);
    expect_entry_word(FXL_E_PLANARITY, AT_VERTICES, 5, VERTEX, 0, x - 5);
}

void test_path_of_poses(void)
{
    uint32_t end = (uint32_t)FXL_COORDINATE_MAX;
    expect_entry_word(FXL_E_RANGE, AT_PATH, 1, POSE, 8, end + 1);
    expect_entry_word(FXL_E_RANGE, AT_PATH, 1, POSE, 0, 0u - end - 1);
    expect_entry_word(FXL_OK, AT_PATH, 1, POSE, 4, end);
    expect_entry_word(FXL_OK, AT_PATH, 1, POSE, 12, 0xFFFFFFFFu);
    expect_word(FXL_E_COUNT, AT_FRAMES, TINY_POSES + 1);
    expect_word(FXL_E_COUNT, AT_FRAMES, 0);
    expect_word(FXL_E_COUNT, AT_FRAMES, 1000001);
}

void test_path_of_strides(void)
{
    tiny_image *image = tiny_image_make(true);
    tiny_put16(tiny_entry(image, AT_PATH, 1, STRIDE), 0x100);
    expect(FXL_E_RESERVED, image);
    image = tiny_image_make(true);
    tiny_put16(tiny_entry(image, AT_PATH, 1, STRIDE) + 2, 0);
    expect(FXL_E_COUNT, image);
    image = tiny_image_make(true);
    tiny_put32(tiny_at(image, AT_FRAMES), 6);
    expect(FXL_E_COUNT, image);
}

void test_a_scene_as_tables(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault = {"untouched", 9};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_UINT32(TINY_OBJECTS + 6, tiny->scene.order_needed);
    TEST_ASSERT_EQUAL_STRING("untouched", fault.what);
    tiny->scene.order_needed = 77;
    tiny->corners[30] = 8;
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_UINT32(77, tiny->scene.order_needed);
    TEST_ASSERT_TRUE(strcmp(fault.what, "untouched") != 0);
    tiny = tiny_make();
    tiny->scene.faces = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_check(&tiny->scene, NULL));
    tiny = tiny_make();
    tiny->scene.object_count = 0;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_check(&tiny->scene, NULL));
}

void test_the_fault_names_the_element(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault;
    tiny->faces[7].count = 2;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_UINT32(7, fault.index);
    tiny = tiny_make();
    tiny->objects[2].model = 9;
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_UINT32(2, fault.index);
}

static void expect_order_needed(uint8_t kind0, uint8_t kind1, uint32_t faces1, uint32_t expected)
{
    tiny_scene *tiny = tiny_make();
    tiny->models[0].kind = kind0;
    tiny->models[1].kind = kind1;
    tiny->models[1].face_count = faces1;
    tiny->scene.face_count = 6 + faces1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL_UINT32(expected, tiny->scene.order_needed);
}

void test_order_needs_the_objects_and_the_largest_sorted_model(void)
{
    expect_order_needed(FXL_MODEL_CONVEX, FXL_MODEL_CONVEX, 6, TINY_OBJECTS);
    expect_order_needed(FXL_MODEL_CONVEX, FXL_MODEL_SORTED, 4, TINY_OBJECTS + 4);
    expect_order_needed(FXL_MODEL_SORTED, FXL_MODEL_CONVEX, 4, TINY_OBJECTS + 6);
    expect_order_needed(FXL_MODEL_SORTED, FXL_MODEL_SORTED, 4, TINY_OBJECTS + 6);
}

/* Models take the vertices and the faces in turn, none twice, none left out. */
void test_models_share_nothing_and_leave_nothing_out(void)
{
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 0, 0);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 8, 0);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 12, 5);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 0, MODEL, 12, 5);
}

/* Objects times vertices is what a loader has to look at: 65535 x 61 is within
 * the limit, 65535 x 62 is not. */
void test_too_many_placed_vertices_are_refused(void)
{
    static fxl_object many[FXL_SCENE_OBJECTS_MAX];
    static fxl_point vertices[62 + 8];
    for (uint32_t extra = 61; extra <= 62; extra++) {
        tiny_scene *tiny = tiny_make();
        memset(vertices, 0, sizeof vertices);
        memcpy(vertices, tiny->vertices, 8 * sizeof vertices[0]);
        memcpy(vertices + extra, tiny->vertices + 8, 8 * sizeof vertices[0]);
        tiny->models[0].vertex_count = extra;
        tiny->models[1].first_vertex = extra;
        tiny->scene.vertices = vertices;
        tiny->scene.vertex_count = extra + 8;
        tiny->scene.objects = many;
        tiny->scene.object_count = FXL_SCENE_OBJECTS_MAX;
        TEST_ASSERT_EQUAL(extra == 61 ? FXL_OK : FXL_E_COUNT,
                          fxl_scene_check(&tiny->scene, NULL));
    }
}

void test_every_status_has_its_own_sentence(void)
{
    for (int i = 0; i < FXL_STATUS_COUNT; i++) {
        const char *text = fxl_status_text((fxl_status)i);
        TEST_ASSERT_NOT_NULL(text);
        TEST_ASSERT_TRUE(strlen(text) > 5 || i == FXL_OK);
        for (int other = 0; other < i; other++) {
            TEST_ASSERT_TRUE(strcmp(text, fxl_status_text((fxl_status)other)) != 0);
        }
    }
    TEST_ASSERT_NOT_NULL(fxl_status_text(FXL_STATUS_COUNT));
}
