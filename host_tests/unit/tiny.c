/* SPDX-License-Identifier: MIT */
#include "tiny.h"

static tiny_scene tiny;
static tiny_image image;

/* Corners of vertex number 4 x + 2 y + z, clockwise from outside. */
static const uint16_t cube_corners[24] = {1, 3, 2, 0, 4, 6, 7, 5, 0, 4, 5, 1,
                                          2, 3, 7, 6, 0, 2, 6, 4, 5, 7, 3, 1};

static void make_cube(uint32_t model, uint8_t kind, uint8_t colour)
{
    for (uint32_t v = 0; v < 8; v++) {
        tiny.vertices[8 * model + v] = (fxl_point){
            v & 4 ? Q16(1) : Q16(-1), v & 2 ? Q16(1) : Q16(-1), v & 1 ? Q16(1) : Q16(-1)};
    }
    memcpy(tiny.corners + 24 * model, cube_corners, sizeof cube_corners);
    for (uint32_t f = 0; f < 6; f++) {
        fxl_q2_30 out = f % 2 ? FXL_Q2_30_ONE : -FXL_Q2_30_ONE;
        tiny.faces[6 * model + f] =
            (fxl_face){.normal = {f / 2 == 0 ? out : 0, f / 2 == 1 ? out : 0, f / 2 == 2 ? out : 0},
                       .first_index = 24 * model + 4 * f,
                       .count = 4,
                       .material = (uint8_t)(colour + f)};
    }
    tiny.models[model] = (fxl_model){8 * model, 8, 6 * model, 6, kind, 0, 0, TINY_RADIUS, 0};
}

/* A face of the cube lies a unit from the middle, and its box is about that. */
static void make_keys(void)
{
    for (uint32_t f = 0; f < 6; f++) {
        int32_t twice = f % 2 ? Q16(2) : Q16(-2);
        uint64_t height = (uint64_t)Q16(1) << 30;
        tiny.keys[f] =
            (fxl_face_bounds){(uint32_t)height, (uint32_t)(height >> 32), f / 2 == 0 ? twice : 0,
                              f / 2 == 1 ? twice : 0, f / 2 == 2 ? twice : 0};
    }
}

tiny_scene *tiny_make(void)
{
    memset(&tiny, 0, sizeof tiny);
    make_cube(0, FXL_MODEL_CONVEX, 1);
    make_cube(1, FXL_MODEL_SORTED, 11);
    make_keys();
    tiny.instances[0] = (fxl_instance){{0, 0, 0}, 0, 0, 0};
    tiny.instances[1] = (fxl_instance){{0, 0, Q16(10)}, 1, 0, 0};
    tiny.instances[2] = (fxl_instance){{Q16(5), Q16(1), Q16(12)}, 0, 0, 0};
    tiny.scene = (fxl_scene){tiny.vertices,
                             tiny.corners,
                             tiny.faces,
                             tiny.models,
                             tiny.instances,
                             16,
                             48,
                             12,
                             2,
                             TINY_INSTANCES,
                             0,
                             tiny.keys,
                             6,
                             NULL,
                             0,
                             0,
                             NULL,
                             0,
                             NULL,
                             NULL,
                             0,
                             NULL,
                             NULL,
                             0,
                             NULL,
                             0};
    return &tiny;
}

uint8_t *tiny_at(tiny_image *of, uint32_t offset)
{
    return (uint8_t *)of->words + offset;
}

uint32_t tiny_get(tiny_image *of, uint32_t offset)
{
    const uint8_t *at = tiny_at(of, offset);
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

void tiny_put16(uint8_t *at, uint16_t value)
{
    at[0] = (uint8_t)value;
    at[1] = (uint8_t)(value >> 8);
}

void tiny_put32(uint8_t *at, uint32_t value)
{
    tiny_put16(at, (uint16_t)value);
    tiny_put16(at + 2, (uint16_t)(value >> 16));
}

uint8_t *tiny_entry(tiny_image *of, uint32_t table, uint32_t number, uint32_t entry_size)
{
    return tiny_at(of, tiny_get(of, table) + number * entry_size);
}

void tiny_seal(tiny_image *of)
{
    uint32_t size = tiny_get(of, AT_SIZE);
    if (size > sizeof of->words || size < 16) {
        size = of->size;
    }
    tiny_put32(tiny_at(of, AT_CRC), unit_crc32(tiny_at(of, 16), size - 16));
}

/* Appends a table, padded to four bytes, and names it in the header. */
static void add_table(uint32_t field, const void *table, uint32_t bytes, uint32_t count)
{
    TEST_ASSERT_TRUE(image.size + bytes + 4 <= sizeof image.words);
    memcpy(tiny_at(&image, image.size), table, bytes);
    tiny_put32(tiny_at(&image, field), image.size);
    tiny_put32(tiny_at(&image, field + 4), count);
    image.size += (bytes + 3) / 4 * 4;
}

static void put_header(bool strides)
{
    memcpy(tiny_at(&image, AT_MAGIC), "FXLS", 4);
    tiny_put16(tiny_at(&image, AT_VERSION), 2);
    tiny_put16(tiny_at(&image, AT_HEADER_SIZE), HEADER_SIZE);
    tiny_put16(tiny_at(&image, AT_WIDTH), 48);
    tiny_put16(tiny_at(&image, AT_HEIGHT), 32);
    tiny_put32(tiny_at(&image, AT_FOV), FXL_ANGLE_QUARTER);
    tiny_put32(tiny_at(&image, AT_NEAR), (uint32_t)Q16(0.0625));
    tiny_put32(tiny_at(&image, AT_FAR), (uint32_t)Q16(1000));
    tiny_put32(tiny_at(&image, AT_INSET), 4);
    *tiny_at(&image, AT_BACKGROUND) = 200;
    *tiny_at(&image, AT_PATH_KIND) = strides;
    tiny_put32(tiny_at(&image, AT_START + 8), (uint32_t)Q16(-5));
    tiny_put32(tiny_at(&image, AT_MOTION_LIMITS), (uint32_t)Q16(0.5));
    tiny_put32(tiny_at(&image, AT_MOTION_LIMITS + 4), (uint32_t)Q16(0.25));
    tiny_put32(tiny_at(&image, AT_MOTION_LIMITS + 8), (uint32_t)Q16(2));
    tiny_put32(tiny_at(&image, AT_MOTION_LIMITS + 12), DEGREES(3));
    tiny_put32(tiny_at(&image, AT_FRAMES), strides ? 7 : TINY_POSES);
}

/* The structures are the layout (scene.h), on a little-endian machine. */
tiny_image *tiny_image_make(bool strides)
{
    static const fxl_pose poses[TINY_POSES] = {{{0, 0, Q16(-5)}, 0, 0, 0},
                                               {{0, Q16(1), Q16(-4)}, DEGREES(5), 0, 0}};
    static const fxl_path_segment walk[TINY_STRIDES] = {{FXL_KEY_FORWARD, 3}, {FXL_KEY_RIGHT, 4}};
    uint8_t palette[768];
    tiny_scene *from = tiny_make();
    for (uint32_t i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(i * 7);
    }
    memset(&image, 0, sizeof image);
    image.size = HEADER_SIZE;
    put_header(strides);
    add_table(AT_PALETTE, palette, sizeof palette, 256);
    add_table(AT_VERTICES, from->vertices, sizeof from->vertices, 16);
    add_table(AT_CORNERS, from->corners, sizeof from->corners, 48);
    add_table(AT_FACES, from->faces, sizeof from->faces, 12);
    add_table(AT_MODELS, from->models, sizeof from->models, 2);
    add_table(AT_INSTANCES, from->instances, sizeof from->instances, TINY_INSTANCES);
    if (strides) {
        add_table(AT_PATH, walk, sizeof walk, TINY_STRIDES);
    } else {
        add_table(AT_PATH, poses, sizeof poses, TINY_POSES);
    }
    add_table(AT_KEYS, from->keys, sizeof from->keys, 6);
    tiny_put32(tiny_at(&image, AT_SIZE), image.size);
    tiny_seal(&image);
    return &image;
}

tiny_image *tiny_image_widen(uint16_t version, uint32_t header_size)
{
    static const uint32_t tables[] = {AT_PALETTE, AT_VERTICES,  AT_CORNERS, AT_FACES,
                                      AT_MODELS,  AT_INSTANCES, AT_PATH,    AT_KEYS};
    const uint32_t more = header_size - HEADER_SIZE;
    tiny_image *of = tiny_image_make(false);
    TEST_ASSERT_TRUE(of->size + more <= sizeof of->words);
    memmove(tiny_at(of, header_size), tiny_at(of, HEADER_SIZE), of->size - HEADER_SIZE);
    memset(tiny_at(of, HEADER_SIZE), 0, more);
    for (size_t i = 0; i < sizeof tables / sizeof tables[0]; i++) {
        tiny_put32(tiny_at(of, tables[i]), tiny_get(of, tables[i]) + more);
    }
    of->size += more;
    tiny_put32(tiny_at(of, AT_SIZE), of->size);
    tiny_put16(tiny_at(of, AT_VERSION), version);
    tiny_put16(tiny_at(of, AT_HEADER_SIZE), (uint16_t)header_size);
    return of;
}

void tiny_add_table(tiny_image *of, uint32_t field, const void *entries, uint32_t count,
                    uint32_t entry_size)
{
    TEST_ASSERT_TRUE(of->size + count * entry_size <= sizeof of->words);
    tiny_put32(tiny_at(of, field), of->size);
    tiny_put32(tiny_at(of, field + 4), count);
    memcpy(tiny_at(of, of->size), entries, (size_t)count * entry_size);
    of->size += count * entry_size;
    tiny_put32(tiny_at(of, AT_SIZE), of->size);
}
