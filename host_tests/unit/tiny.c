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
                       .count = 4,
                       .material = (uint8_t)(colour + f)};
        fxl_face_take_indices(&tiny.faces[6 * model + f], tiny.corners, 24 * model + 4 * f);
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
                             0,
                             NULL};
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

/* Of an entry of the table of sections: where its section lies, and where the next one does. */
static uint32_t section_begin(tiny_image *of, uint32_t number)
{
    return tiny_get(of, AT_PALETTE + SECTION_BYTES * number);
}

static uint32_t section_end(tiny_image *of, uint32_t number, uint32_t count)
{
    return number + 1 < count ? section_begin(of, number + 1) : of->size;
}

/* Puts the entry of a section, and its bytes, padded to four, at the end of the image. */
static void put_section(tiny_image *of, uint32_t number, uint32_t kind, const void *bytes,
                        uint32_t size, uint32_t count)
{
    const uint32_t entry = HEADER_SIZE + SECTION_BYTES * number, padded = (size + 3) / 4 * 4;
    TEST_ASSERT_TRUE(of->size + padded <= sizeof of->words);
    tiny_put16(tiny_at(of, entry), (uint16_t)kind);
    tiny_put16(tiny_at(of, entry + 2), kind != SECTION_FACE_BOUNDS);
    tiny_put32(tiny_at(of, entry + 4), of->size);
    tiny_put32(tiny_at(of, entry + 8), count);
    memset(tiny_at(of, of->size), 0, padded);
    memcpy(tiny_at(of, of->size), bytes, size);
    of->size += padded;
}

static uint32_t kind_at(tiny_image *of, uint32_t number)
{
    return tiny_get(of, HEADER_SIZE + SECTION_BYTES * number) & 0xFFFFu;
}

void tiny_set_section(tiny_image *of, uint16_t kind, const void *entries, uint32_t count,
                      uint32_t entry_size)
{
    static tiny_image from;
    from = *of;
    const uint32_t before = tiny_get(&from, AT_VERSION) >> 16;
    uint32_t total = count != 0, number = 0;
    bool is_put = count == 0;
    for (uint32_t i = 0; i < before; i++) {
        total += kind_at(&from, i) != kind;
    }
    of->size = HEADER_SIZE + SECTION_BYTES * total;
    for (uint32_t i = 0; i <= before; i++) {
        const uint32_t old = i < before ? kind_at(&from, i) : UINT32_MAX;
        if (!is_put && old >= kind) {
            put_section(of, number++, kind, entries, count * entry_size, count);
            is_put = true;
        }
        if (i < before && old != kind) {
            const uint32_t begin = section_begin(&from, i);
            put_section(of, number++, old, tiny_at(&from, begin),
                        section_end(&from, i, before) - begin,
                        tiny_get(&from, AT_PALETTE + SECTION_BYTES * i + 4));
        }
    }
    tiny_put16(tiny_at(of, AT_SECTION_COUNT), (uint16_t)total);
    tiny_put32(tiny_at(of, AT_SIZE), of->size);
}

static void put_header(bool strides)
{
    memcpy(tiny_at(&image, AT_MAGIC), "FXLS", 4);
    tiny_put16(tiny_at(&image, AT_VERSION), IMAGE_VERSION);
    tiny_put16(tiny_at(&image, AT_WIDTH), 48);
    tiny_put16(tiny_at(&image, AT_HEIGHT), 32);
    tiny_put32(tiny_at(&image, AT_FOV), FXL_ANGLE_QUARTER);
    tiny_put32(tiny_at(&image, AT_NEAR), (uint32_t)Q16(0.0625));
    tiny_put32(tiny_at(&image, AT_FAR), (uint32_t)Q16(1000));
    tiny_put32(tiny_at(&image, AT_INSET), 4);
    *tiny_at(&image, AT_BACKGROUND) = 200;
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
    tiny_set_section(&image, SECTION_PALETTE, palette, 256, 3);
    tiny_set_section(&image, SECTION_VERTICES, from->vertices, 16, sizeof from->vertices[0]);
    tiny_set_section(&image, SECTION_INDICES, from->corners, 48, sizeof from->corners[0]);
    tiny_set_section(&image, SECTION_FACES, from->faces, 12, sizeof from->faces[0]);
    tiny_set_section(&image, SECTION_MODELS, from->models, 2, sizeof from->models[0]);
    tiny_set_section(&image, SECTION_INSTANCES, from->instances, TINY_INSTANCES,
                     sizeof from->instances[0]);
    if (strides) {
        tiny_set_section(&image, SECTION_SEGMENTS, walk, TINY_STRIDES, sizeof walk[0]);
    } else {
        tiny_set_section(&image, SECTION_POSES, poses, TINY_POSES, sizeof poses[0]);
    }
    tiny_set_section(&image, SECTION_FACE_BOUNDS, from->keys, 6, sizeof from->keys[0]);
    tiny_seal(&image);
    return &image;
}

static cluster_scene clustered;

cluster_scene *cluster_make(void)
{
    /* Half of sqrt(2), rounded up; cutoffs a little above the least that there are: 0 and 1/2. */
    const fxl_q2_30 diagonal = 759250125;
    clustered.tiny = tiny_make();
    /* sqrt(2) = 92681.9 / 65536 and sqrt(3) = 113511.7 / 65536. */
    clustered.clusters[0] = (fxl_cluster){.centre = {Q16(-1), 0, 0},
                                          .radius = 92682,
                                          .axis = {-FXL_Q2_30_ONE, 0, 0},
                                          .cutoff = 16,
                                          .apex = {Q16(-1), 0, 0},
                                          .face_count = 1};
    clustered.clusters[1] = (fxl_cluster){.radius = 113512,
                                          .axis = {diagonal, -diagonal, 0},
                                          .cutoff = 0x80000010u,
                                          .apex = {Q16(1), Q16(-1), 0},
                                          .face_count = 2};
    clustered.clusters[2] = (fxl_cluster){.radius = 113512, .face_count = 3};
    clustered.tiny->models[1].first_cluster = 1;
    clustered.tiny->scene.clusters = clustered.clusters;
    clustered.tiny->scene.cluster_count = CLUSTERS;
    return &clustered;
}

void cluster_count(const cluster_scene *scene, const cluster_definition *definition,
                   const fxl_view *view, uint32_t *outside, uint32_t *backfacing)
{
    uint32_t number = 6;
    *outside = *backfacing = 0;
    for (int c = 0; c < CLUSTERS; c++) {
        const fxl_cluster *cluster = &scene->clusters[c];
        const bool out = definition->is_outside(scene, view, cluster);
        for (uint32_t i = 0; i < cluster->face_count; i++, number++) {
            const fxl_face *face = &scene->tiny->faces[number];
            *outside += out;
            *backfacing += !out && !definition->is_front(scene, view, face);
        }
    }
}
