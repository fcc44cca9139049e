/* SPDX-License-Identifier: MIT */
/* Balls of small triangles that are lit, coloured at their corners, or have a texture: in bands they
 * are those of one band, whatever the display list holds, and wherever rows of faces are kept. */
#include "fixel/all.h"
#include "unit.h"

enum {
    WIDTH = 40,
    HEIGHT = 32,
    PIXELS = WIDTH * HEIGHT,
    SIDES = 10,
    RINGS = 7, /* of triangles, the ends included */
    VERTICES = SIDES * (RINGS - 1) + 2,
    FACES = 2 * SIDES * (RINGS - 1),
    BALLS = 3,
    LEVELS = 8,
    BACKGROUND = 77,
    WORDS = 300
};

static fxl_point vertices[VERTICES];
static fxl_direction normals[VERTICES];
static fxl_face faces[FACES];
static uint16_t indices[3 * FACES], face_map[FACES];
static fxl_mapped_face mapped[FACES];
static fxl_corner corners[VERTICES];
static fxl_model model;
static fxl_instance instances[BALLS];
static fxl_scene scene;
static uint8_t texels[64], ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)];
static const fxl_texture texture = {
    .texels = texels, .log_width = 3, .log_height = 3, .levels = 1};
static fxl_surface surface;
static fxl_surface_set set;
static fxl_renderer renderer;
static fxl_surfaces surfaces;
static fxl_light light;
static fxl_lit_surfaces lit;
static uint64_t memory[700], cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 32) / 8];
static uint16_t colours[256], whole[PIXELS], again[PIXELS];

static void make_triangle(uint32_t number, uint32_t a, uint32_t b, uint32_t c)
{
    const uint16_t of[3] = {(uint16_t)a, (uint16_t)b, (uint16_t)c};
    fxl_plane plane;
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_plane_from_points(&vertices[a], &vertices[b], &vertices[c], &plane));
    memcpy(&indices[3 * number], of, sizeof of);
    faces[number] = (fxl_face){.normal = plane.normal, .count = 3, .material = 20};
    fxl_face_take_indices(&faces[number], indices, 3 * number);
    mapped[number] = (fxl_mapped_face){.corners = {of[0], of[1], of[2]}};
    face_map[number] = (uint16_t)(number + 1);
}

static void make_vertex(uint32_t number, fxl_angle across, fxl_angle down)
{
    const int64_t ring = fxl_sin(down);
    fxl_direction *normal = &normals[number];
    *normal = (fxl_direction){(fxl_q2_30)(ring * fxl_cos(across) >> 30), fxl_cos(down),
                              (fxl_q2_30)(ring * fxl_sin(across) >> 30)};
    vertices[number] = (fxl_point){normal->x >> 14, normal->y >> 14, normal->z >> 14};
}

static void make_ball(void)
{
    const uint32_t south = VERTICES - 1;
    uint32_t face = 0;
    make_vertex(0, 0, 0);
    make_vertex(south, 0, DEGREES(180));
    for (uint32_t i = 0; i < VERTICES - 2; i++) {
        make_vertex(1 + i, (fxl_angle)((uint64_t)(i % SIDES) * 0x100000000u / SIDES),
                    (fxl_angle)((uint64_t)(i / SIDES + 1) * 0x80000000u / RINGS));
    }
    for (uint32_t i = 0; i < SIDES; i++) {
        const uint32_t next = (i + 1) % SIDES, last = south - SIDES;
        make_triangle(face++, 0, 1 + next, 1 + i);
        make_triangle(face++, south, last + i, last + next);
        for (uint32_t a = 1; a + SIDES < south; a += SIDES) {
            make_triangle(face++, a + i, a + next, a + SIDES + i);
            make_triangle(face++, a + next, a + SIDES + next, a + SIDES + i);
        }
    }
    TEST_ASSERT_EQUAL_UINT32(FACES, face);
}

/* What a round draws: by its bits. */
static bool is_sorted, is_lit, is_coloured, is_mapped;

static void make_scene(uint32_t round)
{
    is_sorted = (round & 1u) != 0;
    is_mapped = (round & 2u) != 0;
    is_coloured = !is_mapped && (round & 4u) != 0;
    is_lit = (!is_mapped && !is_coloured) || (round & 8u) != 0;
    make_ball();
    for (uint32_t i = 0; i < VERTICES; i++) {
        corners[i] = (fxl_corner){{unit_between(0, Q16(12)), unit_between(0, Q16(12))},
                                  (uint16_t)i,
                                  (uint16_t)(is_lit ? i : 0)};
        if (is_coloured) {
            corners[i].texel.u = FXL_CORNER_COLOUR(unit_between(0, 255), unit_between(0, 255),
                                                 unit_between(0, 255));
            corners[i].texel.v = 0;
        }
    }
    surface = (fxl_surface){
        .texture = (uint16_t)is_mapped,
        .opacity = 16,
        .flags = (uint8_t)((is_lit ? FXL_SURFACE_LIT : 0) |
                           (is_coloured ? FXL_SURFACE_COLOURS : 0))};
    model = (fxl_model){.vertex_count = VERTICES,
                        .face_count = FACES,
                        .kind = is_sorted ? FXL_MODEL_SORTED : FXL_MODEL_CONVEX,
                        .radius = Q16(2)};
    for (uint32_t i = 0; i < BALLS; i++) {
        instances[i] = (fxl_instance){
            {unit_between(-Q16(2), Q16(2)), unit_between(-Q16(2), Q16(2)), Q16(3 + i)}, 0, 0, 0};
    }
    scene = (fxl_scene){.vertices = vertices,
                        .indices = indices,
                        .faces = faces,
                        .models = &model,
                        .instances = instances,
                        .vertex_count = VERTICES,
                        .index_count = 3 * FACES,
                        .face_count = FACES,
                        .model_count = 1,
                        .instance_count = BALLS};
    set = (fxl_surface_set){.textures = &texture,
                            .texture_count = 1,
                            .surfaces = &surface,
                            .faces = mapped,
                            .face_map = face_map,
                            .corners = corners,
                            .normals = normals,
                            .surface_count = 1,
                            .face_count = FACES,
                            .corner_count = VERTICES,
                            .normal_count = VERTICES};
}

static void start(const fxl_target *target, const fxl_painter *painter)
{
    static const fxl_light_settings lamp = {.direction = {0, 0, FXL_Q2_30_ONE},
                                            .strength = FXL_Q2_30_ONE / 2,
                                            .ambient = FXL_Q2_30_ONE / 4,
                                            .ramp = ramp,
                                            .levels = LEVELS};
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, target);
    config.palette = colours;
    config.depth = cells;
    config.depth_size = sizeof cells;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&renderer, &surfaces, &set, painter));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &lamp));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&renderer, &lit));
}

static void draw_at(uint16_t *frame, uint32_t stride, uint32_t words, uint32_t rows)
{
    const fxl_pose eye = {{0, 0, 0}, 0, 0, 0};
    renderer.frame.display_list.capacity = words;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    for (uint32_t row = 0; row < HEIGHT; row += rows) {
        const fxl_band band = {.pixels = (uint8_t *)(frame + row * stride),
                               .width = WIDTH,
                               .stride = (uint16_t)stride,
                               .first_row = (uint16_t)row,
                               .rows = (uint16_t)(row + rows <= HEIGHT ? rows : HEIGHT - row),
                               .palette = colours};
        fxl_frame_fill(&renderer, &band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
    }
}

static void draw(uint16_t *frame, uint32_t words, uint32_t rows, fxl_counters *counters)
{
    draw_at(frame, WIDTH, words, rows);
    *counters = renderer.workspace.counters;
    counters->spilled = counters->split_bands = 0;
}

void setUp(void)
{
    for (uint32_t i = 0; i < 256; i++) {
        colours[i] = (uint16_t)(i * 31153u);
    }
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)unit_between(0, 255);
    }
}

void test_balls_in_bands_are_those_of_one_band(void)
{
    uint32_t drawn = 0;
    for (uint32_t round = 0; round < UNIT_REPEAT / 500 + 32; round++) {
        fxl_counters expected, found;
        make_scene(round);
        start(&fxl_rgb565_depth_16, FXL_SURFACES_OF(fxl_rgb565_depth_16));
        const uint32_t most = renderer.frame.display_list.capacity;
        draw(whole, 0, HEIGHT, &expected);
        drawn += expected.drawn;
        for (uint32_t i = 0; i < 4; i++) {
            const uint32_t words = i == 0 ? 0 : (uint32_t)unit_between(1, i == 1 ? 60 : WORDS);
            memset(again, 0, sizeof again);
            draw(again, words < most ? words : most, (uint32_t)unit_between(1, 9), &found);
            TEST_ASSERT_EQUAL_HEX16_ARRAY(whole, again, PIXELS);
            TEST_ASSERT_EQUAL_MEMORY(&expected, &found, sizeof found);
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(2000, drawn);
}

/* Where rows begin apart, or at a pixel that is no pair's first. Nothing beside the rows is touched. */
void test_balls_in_a_wider_frame_are_those_of_a_frame(void)
{
    enum {
        STRIDE = WIDTH + 7
    };
    static _Alignas(uint32_t) uint16_t wider[1 + HEIGHT * STRIDE + 1];
    for (uint32_t round = 0; round < 96; round++) {
        const uint32_t stride = round < 64 ? STRIDE : WIDTH, first = round >= 32;
        fxl_counters counters;
        make_scene(round);
        start(&fxl_rgb565_depth_16, FXL_SURFACES_OF(fxl_rgb565_depth_16));
        const uint32_t most = renderer.frame.display_list.capacity;
        draw(whole, 0, HEIGHT, &counters);
        memset(wider, 0xA5, sizeof wider);
        draw_at(wider + first, stride, (round & 16u) != 0 ? most : 0,
                (uint32_t)unit_between(1, HEIGHT));
        for (uint32_t i = 0; i < sizeof wider / sizeof wider[0]; i++) {
            const uint32_t x = (i - first) % stride, y = (i - first) / stride;
            const bool is_beside = i < first || x >= WIDTH || y >= HEIGHT;
            TEST_ASSERT_EQUAL_HEX16(is_beside ? 0xA5A5 : whole[y * WIDTH + x], wider[i]);
        }
    }
}

/* A depth buffer of 32 bits has no kernels for them. */
void test_colours_that_are_mixed_are_those_of_another_depth(void)
{
    for (uint32_t round = 0; round < 64; round++) {
        fxl_counters counters;
        make_scene(4u + (round & 1u) * 8u);
        const bool is_added = (round & 2u) != 0;
        surface.flags |= (uint8_t)(is_added ? FXL_SURFACE_ADD : FXL_SURFACE_BLEND);
        surface.sixteenths = (uint8_t)(is_added ? 0 : unit_between(1, 15));
        surface.division = (uint8_t)((round & 4u) != 0 ? FXL_DIVIDE_1 : FXL_DIVIDE_16);
        scene.instance_count = 1;
        start(&fxl_rgb565_depth_32, FXL_SURFACES_OF(fxl_rgb565_depth_32));
        draw(whole, 0, HEIGHT, &counters);
        start(&fxl_rgb565_depth_16, FXL_SURFACES_OF(fxl_rgb565_depth_16));
        draw(again, 0, HEIGHT, &counters);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(whole, again, PIXELS);
    }
}
