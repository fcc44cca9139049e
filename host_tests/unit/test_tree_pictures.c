/* SPDX-License-Identifier: MIT */
/* Billboards and surfaces in the order by tree: a billboard is whole, in the leaf of its centre,
 * and a face that is cut shows the texels of the whole face. */
#include "bsp_scene.h"
#include "frame_bands.h"
#include "mapped_quad.h"
#include "tiny_frames.h"

enum {
    WIDTH = 48,
    HEIGHT = 36,
    PIXELS = WIDTH * HEIGHT,
    BACKGROUND = 250,
    SPRITE = 100,
    MODELS = 3,
    WORDS = 600
};

static const fxl_pose eye = {{Q16(0.25), Q16(0.5), Q16(6)}, 0, 0, 0};

static fxl_renderer renderer;
static fxl_billboards billboards;
static fxl_sprite sprite;
static fxl_billboard board;
static fxl_billboard_set set;
static fxl_model models[MODELS];
static fxl_face faces[13];
static fxl_point vertices[16 + FXL_FACE_VERTICES_MAX];
static uint16_t corners[48 + FXL_FACE_VERTICES_MAX];
static uint16_t model_map[MODELS], colours[256], wide[PIXELS];
static uint8_t texels[4], frame[PIXELS], other[PIXELS], memory[8192];
static uint64_t tree[512];
static bsp_scene *made;

/* Instance 0 is a square across z, of 1.5 units a side, or a sprite of that size. Instance 2 is a
 * cube on another layer. */
void setUp(void)
{
    made = bsp_make();
    tiny_scene *tiny = made->tiny;
    memcpy(faces, tiny->faces, sizeof tiny->faces);
    faces[12] = faces[4]; /* that towards -z */
    faces[12].material = SPRITE;
    memcpy(vertices, tiny->vertices, sizeof tiny->vertices);
    memcpy(corners, tiny->corners, sizeof tiny->corners);
    for (uint16_t i = 0; i < 4; i++) {
        vertices[16 + i] = vertices[fxl_face_indices(corners, &faces[4])[i]];
        vertices[16 + i].z = 0;
        corners[48 + i] = i;
    }
    fxl_face_take_indices(&faces[12], corners, 48);
    memcpy(models, tiny->models, sizeof tiny->models);
    models[2] = models[0];
    models[2].first_vertex = 16;
    models[2].vertex_count = 4;
    models[2].first_face = 12;
    models[2].face_count = 1;
    tiny->scene.vertices = vertices;
    tiny->scene.vertex_count = 20;
    tiny->scene.indices = corners;
    tiny->scene.index_count = 52;
    tiny->scene.faces = faces;
    tiny->scene.face_count = 13;
    tiny->scene.models = models;
    tiny->scene.model_count = MODELS;
    tiny->instances[0].model = 2;
    tiny->instances[2].layer = 1;
    memset(texels, SPRITE, sizeof texels);
    sprite = (fxl_sprite){
        .pixels = texels, .width = 2, .height = 2, .bits = 8, .key = FXL_SPRITE_OPAQUE};
    board = (fxl_billboard){&sprite, Q16(2), Q16(2), Q16(1), Q16(1)};
    memset(model_map, 0, sizeof model_map);
    model_map[2] = 1;
    set = (fxl_billboard_set){&board, 1, model_map};
    for (uint32_t i = 0; i < 256; i++) {
        colours[i] = (uint16_t)(257 * i + 1);
    }
}

/* words: of the display list. The tree has no memory for pieces. */
static void start(const fxl_order *order, bool is_rgb565, bool has_billboards, uint32_t words)
{
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, is_rgb565 ? &fxl_rgb565 : &fxl_palette);
    config.palette = is_rgb565 ? colours : NULL;
    config.background = BACKGROUND;
    config.order = order;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&made->tiny->scene, NULL));
    config.tree = tree;
    config.tree_size =
        order->memory_size != NULL ? (order->memory_size(&made->tiny->scene) + 7u) & ~7u : 0;
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_renderer_init(&renderer, &made->tiny->scene, &config, memory, sizeof memory));
    renderer.frame.display_list.capacity = words;
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_attach_billboards(&renderer, &billboards, has_billboards ? &set : NULL,
                                            is_rgb565 ? FXL_SPRITES_OF(fxl_rgb565)
                                                      : FXL_SPRITES_OF(fxl_palette)));
}

/* A place about the cube of the tree, whose middle is at z = 10. */
static void move_somewhere(void)
{
    made->tiny->instances[0].centre = unit_point(Q16(1.5));
    made->tiny->instances[0].centre.z += Q16(10);
}

/* A face that is drawn whole for lack of memory is in front of what the billboard is in front of,
 * and behind what that is behind. */
/* bsp 3.8a-b, billboards 4.2d */
void test_a_billboard_is_in_the_leaf_of_its_centre(void)
{
    uint32_t before = 0, behind = 0;
    for (int round = 0; round < UNIT_REPEAT / 100 + 8; round++) {
        const uint32_t movers = (uint32_t)round % 2; /* beside the billboard */
        move_somewhere();
        made->tiny->instances[2].layer = movers == 0;
        start(&fxl_by_tree, false, true, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
        TEST_ASSERT_EQUAL_UINT32(movers, ((fxl_bsp_workspace *)renderer.order_memory)->unsplit);
        start(&fxl_by_tree, false, false, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, other, WIDTH));
        for (int i = 0; i < PIXELS; i++) {
            before += frame[i] == SPRITE;
            behind += frame[i] > 10 && frame[i] <= 16;
            if (frame[i] != other[i]) {
                TEST_ASSERT_TRUE(frame_has_near(other, WIDTH, HEIGHT, i, frame[i]));
            }
        }
    }
    TEST_ASSERT_TRUE(before > 1000 && behind > 1000);
}

/* A billboard that stands on its centre is in the leaf of its middle, as if that were its centre;
 * turned instances have a scale. */
/* bsp 3.8c */
void test_the_middle_of_a_billboard_is_above_its_centre(void)
{
    static fxl_placement scaled[1];
    scaled[0] = (fxl_placement)FXL_PLACEMENT_NONE;
    scaled[0].scale = FXL_UNITS(2);
    for (int round = 0; round < UNIT_REPEAT / 100 + 8; round++) {
        fxl_instance *instances = made->tiny->instances;
        move_somewhere();
        const fxl_instance last = instances[2];
        models[2].radius = Q16(2.25);
        start(&fxl_by_tree, false, true, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
        board.anchor_y = 0;
        instances[0].centre.y -= Q16(1);
        start(&fxl_by_tree, false, true, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, other, WIDTH));
        TEST_ASSERT_EQUAL_MEMORY(frame, other, sizeof frame);
        board.width = board.height = Q16(1);
        board.anchor_x = Q16(0.5);
        instances[2] = instances[0]; /* the last instances have placements */
        instances[0] = last;
        made->tiny->scene.placements = scaled;
        made->tiny->scene.placement_code = &fxl_turned_instances;
        made->tiny->scene.first_turned = 2;
        start(&fxl_by_tree, false, true, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, other, WIDTH));
        TEST_ASSERT_EQUAL_MEMORY(frame, other, sizeof frame);
        made->tiny->scene.placements = NULL;
        made->tiny->scene.placement_code = NULL;
        made->tiny->scene.first_turned = 0;
        setUp();
    }
}

/* Bands, display lists of any size, RGB565, and every face counted once. */
void test_deliveries_of_billboards_by_tree(void)
{
    for (int round = 0; round < UNIT_REPEAT / 200 + 4; round++) {
        move_somewhere();
        start(&fxl_by_tree, true, true, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, wide, WIDTH));
        start(&fxl_by_tree, false, true, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
        const fxl_counters whole = renderer.workspace.counters;
        for (uint32_t i = 0; i < PIXELS; i++) {
            TEST_ASSERT_EQUAL_HEX16(colours[frame[i]], wide[i]);
        }
        TEST_ASSERT_EQUAL_UINT32(6 + 6 + 1, whole.in);
        for (uint32_t words = 0; words <= 60; words += 12) {
            start(&fxl_by_tree, false, true, words);
            frame_draw_pose(&renderer, &eye, other, 1 + unit_random() % HEIGHT, BACKGROUND);
            TEST_ASSERT_EQUAL_MEMORY(frame, other, sizeof frame);
            TEST_ASSERT_EQUAL_UINT32(whole.in, renderer.workspace.counters.in);
            TEST_ASSERT_EQUAL_UINT32(whole.drawn, renderer.workspace.counters.drawn);
        }
    }
}

/* Where the scene has no tree, it is drawn by distance. */
void test_billboards_by_a_tree_that_the_scene_has_not(void)
{
    made->tiny->scene.bsp_nodes = NULL;
    made->tiny->scene.bsp_node_count = 0;
    made->tiny->scene.bsp_instance = 0;
    made->tiny->instances[0].centre = (fxl_point){0, 0, Q16(8.5)};
    start(&fxl_by_distance, false, true, WORDS);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    start(&fxl_by_tree, false, true, WORDS);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, other, WIDTH));
    TEST_ASSERT_EQUAL_MEMORY(frame, other, sizeof frame);
    TEST_ASSERT_EQUAL_UINT8(SPRITE, frame[HEIGHT / 2 * WIDTH + WIDTH / 2]);
}

/* --- surfaces ----------------------------------------------------------------------------------
 */

enum {
    TEXEL = 200, /* and more */
    LEVELS = 4,
    PIECES = 4096
};

static uint8_t texture_texels[6][16 * 16], ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)];
static fxl_texture textures[6];
static fxl_surface surface[6];
static fxl_mapped_face mapped[6];
static fxl_corner mapped_corners[6][3];
static fxl_direction normals[1];
static uint16_t face_map[13];
static fxl_surface_set surface_set;
static fxl_surfaces surfaces;
static fxl_light light;
static fxl_lit_surfaces lit;
static fxl_placement placements[1];
static uint64_t room[PIECES / 8];

/* Each face of model 0 has a texture of its own, of 8 colours, and light of the same. */
static void map_faces(bool is_lit)
{
    memset(face_map, 0, sizeof face_map);
    for (uint32_t f = 0; f < 6; f++) {
        for (uint32_t i = 0; i < 256; i++) {
            texture_texels[f][i] = (uint8_t)(TEXEL + 8 * f + (i + i / 16 * 5) % 8);
        }
        textures[f] = (fxl_texture){
            .texels = texture_texels[f], .log_width = 4, .log_height = 4, .levels = 1};
        surface[f] = (fxl_surface){
            .texture = (uint16_t)(f + 1), .opacity = 16, .flags = is_lit ? FXL_SURFACE_LIT : 0};
        quad_map_face(&mapped[f], mapped_corners[f], 3 * f, &made->tiny->corners[4 * f], Q16(16));
        mapped[f].surface = (uint16_t)f;
        face_map[f] = (uint16_t)(f + 1);
    }
    normals[0] = (fxl_direction){0, 0, -FXL_Q2_30_ONE};
    surface_set = (fxl_surface_set){.textures = textures,
                                    .surfaces = surface,
                                    .faces = mapped,
                                    .face_map = face_map,
                                    .corners = mapped_corners[0],
                                    .normals = normals,
                                    .texture_count = 6,
                                    .surface_count = 6,
                                    .face_count = 6,
                                    .corner_count = 18,
                                    .normal_count = 1};
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)((i & 0xF8u) | ((i + i / 256 * 3) & 7u));
    }
}

/* Which face's texture a pixel shows; 0: none. */
static uint32_t face_at(uint8_t pixel)
{
    return pixel >= TEXEL && pixel < BACKGROUND ? pixel / 8u : 0;
}

/* An instance is a cube of model 0 that the tree cuts: instance 0, or, turned, instance 2. The
 * other one of the two is far away. */
static void make_mover(bool is_turned)
{
    tiny_scene *tiny = made->tiny;
    fxl_instance *mover = &tiny->instances[is_turned ? 2 : 0];
    tiny->instances[0] = tiny->instances[2] = (fxl_instance){{0, 0, Q16(200)}, 0, 0, 0};
    mover->centre = unit_point(Q16(1.5));
    mover->centre.z += Q16(10);
    tiny->scene.placements = is_turned ? placements : NULL;
    tiny->scene.placement_code = is_turned ? &fxl_turned_instances : NULL;
    tiny->scene.first_turned = is_turned ? 2 : 0;
    placements[0] = (fxl_placement)FXL_PLACEMENT_NONE;
    if (is_turned) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_angles(DEGREES(20), DEGREES(35), DEGREES(10),
                                                              &placements[0].orientation));
    }
}

static void attach_mapped(bool is_rgb565, bool is_lit)
{
    const fxl_light_settings lamp = {
        .ambient = FXL_Q2_30_ONE / 4,
        .point_count = 1,
        .points = {{{Q16(2), Q16(1), Q16(7)}, Q16(6), FXL_Q2_30_ONE / 2}},
        .ramp = ramp,
        .levels = LEVELS};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&renderer, &surfaces, &surface_set,
                                                  is_rgb565 ? FXL_SURFACES_OF(fxl_rgb565)
                                                            : FXL_SURFACES_OF(fxl_palette)));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, is_lit ? &lamp : NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&renderer, is_lit ? &lit : NULL));
}

static void start_mapped(bool is_rgb565, uint32_t pieces, bool is_lit, uint32_t words)
{
    start(&fxl_by_tree, is_rgb565, false, words);
    ((fxl_bsp_workspace *)renderer.order_memory)->pieces = room;
    ((fxl_bsp_workspace *)renderer.order_memory)->pieces_size = pieces;
    attach_mapped(is_rgb565, is_lit);
}

/* Where two frames show the same face, they show the same texel. Returns how many pixels do. */
static uint32_t expect_same_texels(void)
{
    uint32_t shown = 0;
    for (uint32_t i = 0; i < PIXELS; i++) {
        if (face_at(frame[i]) != 0 && face_at(frame[i]) == face_at(other[i])) {
            TEST_ASSERT_EQUAL_UINT8(frame[i], other[i]);
            shown++;
        }
    }
    return shown;
}

/* A face that is cut to the leaves shows each pixel as the whole face does, bit for bit: turned or
 * not, lit or not. */
/* surfaces 1.2e, 6.1d */
void test_a_cut_moves_no_texel(void)
{
    uint32_t shown = 0, by_distance = 0, cut = 0;
    for (uint32_t round = 0; round < UNIT_REPEAT / 100 + 8u; round++) {
        const bool is_turned = round % 2 != 0, is_lit = round % 4 >= 2;
        map_faces(is_lit);
        make_mover(is_turned);
        for (uint32_t pieces = 0; pieces <= PIECES; pieces += PIECES) {
            start_mapped(false, pieces, is_lit, WORDS);
            TEST_ASSERT_EQUAL(FXL_OK,
                              fxl_render(&renderer, &eye, pieces == 0 ? frame : other, WIDTH));
        }
        const fxl_bsp_workspace *workspace = (const fxl_bsp_workspace *)renderer.order_memory;
        TEST_ASSERT_EQUAL_UINT32(0, workspace->unsplit);
        cut += workspace->used;
        shown += expect_same_texels();
        /* Not drawn in pieces, nor from points that are rounded in the world. */
        start(&fxl_by_distance, false, false, WORDS);
        attach_mapped(false, is_lit);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, other, WIDTH));
        by_distance += expect_same_texels();
    }
    TEST_ASSERT_TRUE(shown > 2000 && by_distance > 2000 && cut > 0);
}

/* A frame in RGB565, in bands of so many rows. */
static void draw_wide(uint16_t *to, uint32_t rows)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    for (uint32_t row = 0; row < HEIGHT; row += rows) {
        const uint32_t left = HEIGHT - row;
        const fxl_band band = {.pixels = (uint8_t *)(to + row * WIDTH),
                               .width = WIDTH,
                               .stride = WIDTH,
                               .first_row = (uint16_t)row,
                               .rows = (uint16_t)(left < rows ? left : rows),
                               .palette = colours};
        fxl_rgb565.fill(NULL, &band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
    }
}

/* Bands and lists of any size show the same, in a palette and in RGB565. */
/* surfaces 6.1c */
void test_deliveries_of_surfaces_by_tree(void)
{
    static uint16_t wide_again[PIXELS];
    for (uint32_t round = 0; round < UNIT_REPEAT / 500 + 4u; round++) {
        map_faces(false);
        make_mover(round % 2 != 0);
        start_mapped(true, PIECES, false, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, wide, WIDTH));
        start_mapped(false, PIECES, false, WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
        for (uint32_t words = 0; words <= 200; words += 40) {
            const uint32_t rows = 1 + unit_random() % HEIGHT;
            start_mapped(true, PIECES, false, words);
            draw_wide(wide_again, rows);
            TEST_ASSERT_EQUAL_MEMORY(wide, wide_again, sizeof wide);
            start_mapped(false, PIECES, false, words);
            frame_draw_pose(&renderer, &eye, other, rows, BACKGROUND);
            TEST_ASSERT_EQUAL_MEMORY(frame, other, sizeof frame);
        }
    }
}

/* Instance 0 is a regular polygon across z, clockwise from its right corner, of 1 unit. */
static void make_polygon(uint32_t count)
{
    faces[12].count = (uint8_t)count;
    for (uint32_t i = 0; i < count; i++) {
        const fxl_angle angle = (fxl_angle)(((uint64_t)i << 32) / count);
        vertices[16 + i] = (fxl_point){fxl_cos(angle) >> 14, -(fxl_sin(angle) >> 14), 0};
        corners[48 + i] = (uint16_t)i;
    }
    models[2].vertex_count = count;
    made->tiny->scene.vertex_count = 16 + count;
    made->tiny->scene.index_count = 48 + count;
}

/* The plane x = 1 cuts the left corner off, so that what is left has a corner more. */
/* bsp 3.7a */
void test_a_piece_of_too_many_corners_is_not_cut(void)
{
    for (uint32_t less = 0; less < 2; less++) {
        const uint32_t count =
            FXL_FACE_VERTICES_MAX - 2 * less; /* even: its left corner is alone */
        make_polygon(count);
        made->tiny->instances[0].centre = (fxl_point){Q16(1) + Q16(0.999), 0, Q16(10)};
        start(&fxl_by_tree, false, false, WORDS);
        fxl_bsp_workspace *workspace = (fxl_bsp_workspace *)renderer.order_memory;
        workspace->pieces = room;
        workspace->pieces_size = sizeof room;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
        TEST_ASSERT_EQUAL_UINT32(1 - less, workspace->unsplit);
        TEST_ASSERT_NOT_NULL(memchr(frame, SPRITE, sizeof frame));
    }
}
