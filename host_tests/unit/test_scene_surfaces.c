/* SPDX-License-Identifier: MIT */
/* Surfaces in a scene image: eight sections. */
#include "expect_scene.h"
#include "fixel/surfaces.h"

enum {
    AT_TEXTURES = AT_MORE,
    AT_TEXELS = AT_TEXTURES + SECTION_BYTES,
    AT_SURFACES = AT_TEXELS + SECTION_BYTES,
    AT_MAPPED = AT_SURFACES + SECTION_BYTES,
    AT_MAPPED_CORNERS = AT_MAPPED + SECTION_BYTES,
    AT_MAP = AT_MAPPED_CORNERS + SECTION_BYTES,
    AT_NORMALS = AT_MAP + SECTION_BYTES,
    AT_BLEND = AT_NORMALS + SECTION_BYTES,
    TEXTURES = 2,
    TEXELS = 40, /* 4 x 2 and 2 x 1 of 8 bits; 2 x 4, 2 x 2 and 2 x 1 of 4 bits; 16 colours */
    FACES = 12
};

static fxl_texture textures[TEXTURES];
static fxl_surface_set set;

static const fxl_scene_texture records[TEXTURES] = {
    {.log_width = 2, .log_height = 1, .levels = 2, .flags = FXL_TEXTURE_KEYED, .key = 9},
    {.texels = 16,
     .colours = 24,
     .log_width = 1,
     .log_height = 2,
     .format = FXL_TEXTURE_4,
     .levels = 3,
     .flags = FXL_TEXTURE_CLAMP}};

/* Tiny's image; the first two faces have a surface each. */
static tiny_image *make(void)
{
    static const fxl_surface surfaces[2] = {
        {.texture = 1, .opacity = 16, .flags = FXL_SURFACE_BLEND},
        {.texture = 2, .division = FXL_DIVIDE_1, .opacity = 7, .flags = FXL_SURFACE_LIT}};
    static const fxl_mapped_face faces[2] = {{.corners = {0, 1, 2}},
                                             {.surface = 1, .corners = {3, 4, 5}}};
    static const fxl_corner corners[6] = {{{0, 0}, 1, 0}, {{Q16(4), 0}, 3, 0}, {{0, Q16(-2)}, 0, 0},
                                          {{1, 2}, 6, 0}, {{3, 4}, 7, 0},      {{5, 6}, 5, 0}};
    static const uint16_t map[FACES] = {1, 2};
    static const fxl_direction normal = {0, FXL_Q2_30_ONE, 0};
    uint8_t texels[TEXELS];
    static const uint8_t blend[2][256] = {{5}, {6}}; /* any bytes are a blend table */
    tiny_image *image = tiny_image_make(false);
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(3 * i);
    }
    tiny_set_section(image, SECTION_TEXTURES, records, TEXTURES, sizeof records[0]);
    tiny_set_section(image, SECTION_TEXELS, texels, TEXELS, 1);
    tiny_set_section(image, SECTION_SURFACES, surfaces, 2, sizeof surfaces[0]);
    tiny_set_section(image, SECTION_MAPPED_FACES, faces, 2, sizeof faces[0]);
    tiny_set_section(image, SECTION_CORNERS, corners, 6, sizeof corners[0]);
    tiny_set_section(image, SECTION_FACE_MAP, map, FACES, sizeof map[0]);
    tiny_set_section(image, SECTION_NORMALS_OF_CORNERS, &normal, 1, sizeof normal);
    tiny_set_section(image, SECTION_BLEND_TABLE, blend, 2, sizeof blend[0]);
    tiny_put32(tiny_at(image, AT_BLEND_FIRST), 3);
    tiny_seal(image);
    return image;
}

/* What fxl_scene_open answers. */
static void header_word(fxl_status status, uint32_t offset, uint32_t value)
{
    expect_image_word(status, make(), offset, value);
}

/* What fxl_surfaces_open answers, and what is at fault. */
static void expect_surfaces(fxl_status status, const char *what, tiny_image *image)
{
    fxl_scene_image opened;
    fxl_scene_fault fault = {"nothing", 99};
    fxl_surface_set before;
    memset(&set, 0x5A, sizeof set);
    memset(&before, 0x5A, sizeof before);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL(status, fxl_surfaces_open(&opened, textures, TEXTURES, &set, &fault));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
    if (status != FXL_OK) {
        TEST_ASSERT_EQUAL_MEMORY(&before, &set, sizeof set);
    }
}

static void texture_word(fxl_status status, uint32_t number, uint32_t at, uint32_t value)
{
    tiny_image *image = make();
    tiny_put32(tiny_entry(image, AT_TEXTURES, number, sizeof records[0]) + at, value);
    expect_surfaces(status, status == FXL_OK ? "nothing" : "texture", image);
}

static void texture_byte(fxl_status status, uint32_t number, uint32_t at, uint8_t value)
{
    tiny_image *image = make();
    tiny_entry(image, AT_TEXTURES, number, sizeof records[0])[at] = value;
    expect_surfaces(status, status == FXL_OK ? "nothing" : "texture", image);
}

/* Every member of the set is that of the image. */
/* formats 1.12, 1.2ac-aj */
void test_surfaces_are_used_in_place(void)
{
    tiny_image *image = make();
    const uint8_t *texels = tiny_at(image, tiny_get(image, AT_TEXELS));
    expect_surfaces(FXL_OK, "nothing", image);
    TEST_ASSERT_EQUAL_PTR(textures, set.textures);
    TEST_ASSERT_EQUAL_UINT32(TEXTURES, set.texture_count);
    TEST_ASSERT_EQUAL_PTR(texels, textures[0].texels);
    TEST_ASSERT_NULL(textures[0].colours);
    TEST_ASSERT_EQUAL_UINT8(2, textures[0].log_width);
    TEST_ASSERT_EQUAL_UINT8(1, textures[0].log_height);
    TEST_ASSERT_EQUAL_UINT8(FXL_TEXTURE_8, textures[0].format);
    TEST_ASSERT_EQUAL_UINT8(FXL_TEXTURE_KEYED, textures[0].flags);
    TEST_ASSERT_EQUAL_UINT8(9, textures[0].key);
    TEST_ASSERT_EQUAL_UINT8(2, textures[0].levels);
    TEST_ASSERT_EQUAL_PTR(texels + 16, textures[1].texels);
    TEST_ASSERT_EQUAL_PTR(texels + 24, textures[1].colours);
    TEST_ASSERT_EQUAL_UINT8(FXL_TEXTURE_4, textures[1].format);
    TEST_ASSERT_EQUAL_UINT32(2, set.surface_count);
    TEST_ASSERT_EQUAL_UINT8(7, set.surfaces[1].opacity);
    TEST_ASSERT_EQUAL_UINT32(2, set.face_count);
    TEST_ASSERT_EQUAL_UINT16(5, set.faces[1].corners[2]);
    TEST_ASSERT_EQUAL_UINT32(6, set.corner_count);
    TEST_ASSERT_EQUAL_INT32(Q16(-2), set.corners[2].texel.v);
    TEST_ASSERT_EQUAL_UINT16(2, set.face_map[1]);
    TEST_ASSERT_EQUAL_UINT32(1, set.normal_count);
    TEST_ASSERT_EQUAL_INT32(FXL_Q2_30_ONE, set.normals[0].y);
    TEST_ASSERT_EQUAL_PTR(tiny_at(image, tiny_get(image, AT_BLEND)), set.blend);
    TEST_ASSERT_EQUAL_UINT32(3, set.blend_first);
    TEST_ASSERT_EQUAL_UINT32(2, set.blend_count);
}

void test_one_colour_may_be_blended(void)
{
    tiny_image *image = make();
    static const uint8_t blend[256] = {7};
    tiny_set_section(image, SECTION_BLEND_TABLE, blend, 1, sizeof blend);
    expect_surfaces(FXL_OK, "nothing", image);
    TEST_ASSERT_EQUAL_PTR(tiny_at(image, tiny_get(image, AT_BLEND)), set.blend);
    TEST_ASSERT_EQUAL_UINT32(1, set.blend_count);
}

void test_an_image_may_have_no_surfaces(void)
{
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.surfaces.face_map);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_surfaces_open(&opened, textures, TEXTURES, &set, NULL));
}

void test_an_image_with_surfaces_may_have_no_light_placements_or_beams(void)
{
    tiny_image *image = make();
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.light.base);
    TEST_ASSERT_NULL(opened.scene.placements);
    TEST_ASSERT_NULL(opened.scene.beams);
}

void test_memory_for_textures_is_checked(void)
{
    tiny_image *image = make();
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    const struct {
        fxl_status status;
        fxl_texture *textures;
        uint32_t capacity;
        const char *what;
    } cases[] = {
        {FXL_E_CAPACITY, textures, TEXTURES - 1, "texture table"},
        {FXL_E_ALIGNMENT, (fxl_texture *)((uintptr_t)textures + 1), TEXTURES - 1, "texture table"},
        {FXL_E_ARGUMENT, NULL, TEXTURES, "surfaces"},
    };
    for (uint32_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fxl_scene_fault fault = {"nothing", 99};
        TEST_ASSERT_EQUAL(cases[i].status, fxl_surfaces_open(&opened, cases[i].textures,
                                                             cases[i].capacity, &set, &fault));
        TEST_ASSERT_EQUAL_STRING(cases[i].what, fault.what);
        TEST_ASSERT_EQUAL_UINT32(0, fault.index);
    }
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_surfaces_open(&opened, textures, TEXTURES, NULL, NULL));
    opened.surfaces.texture_count = 0; /* then it needs no memory for them, but a surface has one */
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_surfaces_open(&opened, NULL, 0, &set, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_surfaces_open(NULL, textures, TEXTURES, &set, NULL));
}

void test_tables_of_surfaces_are_checked(void)
{
    header_word(FXL_E_COUNT, AT_SURFACES + 4, 0);
    header_word(FXL_E_COUNT, AT_SURFACES + 4, 65536);
    header_word(FXL_E_COUNT, AT_MAPPED + 4, 0);
    header_word(FXL_E_OFFSET, AT_TEXTURES, 4);
    header_word(FXL_E_ALIGNMENT, AT_TEXELS, 2);
    header_word(FXL_E_OFFSET, AT_NORMALS, 0x7FFFFFF0u);
    header_word(FXL_E_COUNT, AT_BLEND + 4, 257);
    tiny_image *image = make();
    static const uint16_t map[FACES] = {1};
    tiny_set_section(image, SECTION_FACE_MAP, map, FACES - 1, sizeof map[0]);
    expect_opening(FXL_E_COUNT, image);
    image = make();
    tiny_set_section(image, SECTION_BLEND_TABLE, NULL, 0, 0); /* it has a first colour */
    expect_opening(FXL_E_RESERVED, image);
}

/* One section of surfaces asks for four of them. */
void test_sections_of_surfaces_go_together(void)
{
    static const uint16_t needed[] = {SECTION_SURFACES, SECTION_MAPPED_FACES, SECTION_CORNERS,
                                      SECTION_FACE_MAP};
    for (int i = 0; i < 4; i++) {
        tiny_image *image = make();
        tiny_set_section(image, needed[i], NULL, 0, 0);
        expect_opening(FXL_E_COUNT, image);
    }
    for (uint16_t kind = SECTION_TEXTURES; kind <= SECTION_BLEND_TABLE; kind++) {
        static const uint32_t bytes[64];
        tiny_image *image = tiny_image_make(false);
        const uint32_t size = kind == SECTION_BLEND_TABLE ? 256 : 48;
        tiny_set_section(image, kind, bytes, 1, size);
        if (size == 48) { /* whole entries of any of the others */
            tiny_put32(tiny_at(image, AT_MORE + 4), kind == SECTION_TEXTURES       ? 3
                                                    : kind == SECTION_TEXELS       ? 48
                                                    : kind == SECTION_MAPPED_FACES ? 6
                                                    : kind == SECTION_FACE_MAP     ? 24
                                                                                   : 4);
        }
        expect_opening(FXL_E_COUNT, image);
    }
}

/* formats 1.12b, 1.12f */
void test_textures_lie_within_their_texels(void)
{
    texture_word(FXL_OK, 1, 0, 0); /* they are those of the first */
    texture_word(FXL_OK, 1, 4, 0);
    texture_word(FXL_OK, 0, 0, TEXELS - 10);
    texture_word(FXL_E_OFFSET, 0, 0, TEXELS - 9);
    texture_word(FXL_E_OFFSET, 0, 0, 0xFFFFFFFFu);
    texture_word(FXL_OK, 1, 0, TEXELS - 7);
    texture_word(FXL_E_OFFSET, 1, 0, TEXELS - 6);
    texture_word(FXL_OK, 1, 4, TEXELS - 16);
    texture_word(FXL_E_OFFSET, 1, 4, TEXELS - 15);
    texture_word(FXL_E_RESERVED, 0, 4, 1);
    texture_byte(FXL_E_OFFSET, 0, 8, 5);
    texture_byte(FXL_E_RANGE, 0, 8, 9);
    texture_byte(FXL_E_OFFSET, 0, 9, 8);
    texture_byte(FXL_E_RANGE, 0, 9, 9);
    texture_byte(FXL_E_RANGE, 0, 13, 0);
    texture_byte(FXL_E_RANGE, 0, 13, 10);
}

/* Of the rest one case each: fxl_surfaces_check has tests of its own. */
/* formats 1.12f */
void test_what_a_texture_says_is_checked(void)
{
    texture_byte(FXL_E_RANGE, 1, 8, 0);
    texture_byte(FXL_E_RESERVED, 0, 10, 2);
    texture_byte(FXL_E_RESERVED, 0, 11, 4);
    texture_byte(FXL_E_RESERVED, 0, 14, 1);
    texture_byte(FXL_E_RANGE, 0, 13, 4);
    for (uint8_t more = 0; more < 2; more++) { /* all levels there are, and one more */
        tiny_image *image = make();
        uint8_t *record = tiny_entry(image, AT_TEXTURES, 0, sizeof records[0]);
        record[8] = FXL_TEXTURE_LOG_MAX;
        record[13] = (uint8_t)(FXL_TEXTURE_LOG_MAX + 1u + more);
        expect_surfaces(more == 0 ? FXL_E_OFFSET : FXL_E_RANGE, "texture", image);
    }
}

/* The image asks for RGB565, or for a palette; its first texture has texels of RGB565, which begin
 * at a place. */
static void expect_565(fxl_status status, uint8_t target, uint32_t place, uint8_t key)
{
    tiny_image *image = make();
    fxl_scene_texture record = records[0];
    record.texels = place;
    record.format = FXL_TEXTURE_565;
    record.key = key;
    record.key_565 = 0x4321;
    memcpy(tiny_entry(image, AT_TEXTURES, 0, sizeof record), &record, sizeof record);
    *tiny_at(image, AT_TARGET) = target;
    expect_surfaces(status, status == FXL_OK ? "nothing" : "texture", image);
}

/* 4 x 2 and 2 x 1 texels take 20 bytes. */
/* formats 1.12g */
void test_an_image_that_asks_for_rgb565_may_have_its_texels(void)
{
    expect_565(FXL_OK, 4, TEXELS - 20, 0);
    TEST_ASSERT_EQUAL_UINT8(FXL_TEXTURE_565, textures[0].format);
    TEST_ASSERT_EQUAL_UINT16(0x4321, textures[0].key_565);
    expect_565(FXL_OK, 6, 0, 0);
    expect_565(FXL_E_RESERVED, 0, 0, 0);
    expect_565(FXL_E_RESERVED, 4, 0, 1);
    expect_565(FXL_E_ALIGNMENT, 4, 1, 0);
    expect_565(FXL_E_OFFSET, 4, TEXELS - 18, 0);
}

/* A blended one needs no table there. */
void test_an_image_that_asks_for_rgb565_may_add_colours(void)
{
    for (uint8_t target = 0; target <= 4; target += 4) {
        tiny_image *image = make();
        *tiny_at(image, AT_TARGET) = target;
        tiny_entry(image, AT_SURFACES, 0, sizeof(fxl_surface))[3] = FXL_SURFACE_ADD;
        expect_surfaces(target == 4 ? FXL_OK : FXL_E_RESERVED, target == 4 ? "nothing" : "surface",
                        image);
    }
    tiny_image *image = make();
    *tiny_at(image, AT_TARGET) = 4;
    tiny_entry(image, AT_SURFACES, 0, sizeof(fxl_surface))[3] = FXL_SURFACE_ADD | FXL_SURFACE_BLEND;
    expect_surfaces(FXL_E_RESERVED, "surface", image);
    image = make();
    *tiny_at(image, AT_TARGET) = 4;
    tiny_set_section(image, SECTION_BLEND_TABLE, NULL, 0, 0);
    tiny_put32(tiny_at(image, AT_BLEND_FIRST), 0);
    expect_surfaces(FXL_OK, "nothing", image);
}

void test_the_rest_is_checked(void)
{
    tiny_image *image = make();
    tiny_entry(image, AT_SURFACES, 0, sizeof(fxl_surface))[4] = 17;
    expect_surfaces(FXL_E_RANGE, "surface", image);
    image = make();
    tiny_put16(tiny_entry(image, AT_MAPPED, 1, sizeof(fxl_mapped_face)) + 6, 6);
    expect_surfaces(FXL_E_INDEX, "mapped face", image);
    image = make();
    tiny_put16(tiny_entry(image, AT_MAPPED_CORNERS, 4, sizeof(fxl_corner)) + 10, 1);
    expect_surfaces(FXL_E_INDEX, "mapped face", image);
    image = make();
    tiny_put16(tiny_entry(image, AT_MAP, 2, 2), 3);
    expect_surfaces(FXL_E_INDEX, "face", image);
    image = make();
    tiny_put32(tiny_at(image, AT_BLEND_FIRST), 255);
    expect_surfaces(FXL_E_COUNT, "surfaces", image);
    image = make();
    tiny_set_section(image, SECTION_BLEND_TABLE, NULL, 0, 0);
    tiny_put32(tiny_at(image, AT_BLEND_FIRST), 0);
    expect_surfaces(FXL_E_ARGUMENT, "surface", image);
}
