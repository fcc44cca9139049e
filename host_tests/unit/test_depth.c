/* SPDX-License-Identifier: MIT */
/* The depth buffer, against the definition in double: a ray through each pixel's centre. */
#include <math.h>
#include <string.h>

#include "fixel/all.h"
#include "unity.h"

enum {
    WIDTH = 48,
    HEIGHT = 36,
    BACKGROUND = 255,
    QUADS = 3
};

/* A floor that runs behind the eye, a wall across the view, and a slanted one that meets both: in
 * any order of drawing one of them covers a part of another that is nearer. */
static const fxl_point vertices[] = {
    {-8 * 65536, -32768, 16 * 65536},    {8 * 65536, -32768, 16 * 65536},
    {8 * 65536, -32768, -4 * 65536},     {-8 * 65536, -32768, -4 * 65536},
    {-6 * 65536, -2 * 65536, 4 * 65536}, {-6 * 65536, 2 * 65536, 4 * 65536},
    {6 * 65536, 2 * 65536, 4 * 65536},   {6 * 65536, -2 * 65536, 4 * 65536},
    {-4 * 65536, -3 * 65536, 0},         {-4 * 65536, 3 * 65536, 0},
    {4 * 65536, 3 * 65536, 8 * 65536},   {4 * 65536, -3 * 65536, 8 * 65536}};
static const uint16_t indices[] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
static const fxl_face faces[] = {{{0, FXL_Q2_30_ONE, 0}, 0, 4, 10, 0},
                                 {{0, 0, -FXL_Q2_30_ONE}, 4, 4, 20, 0},
                                 {{759250125, 0, -759250125}, 8, 4, 30, 0}};
static const fxl_model models[] = {
    {.vertex_count = 4, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = 19 * 65536},
    {.first_vertex = 4,
     .vertex_count = 4,
     .first_face = 1,
     .face_count = 1,
     .kind = FXL_MODEL_CONVEX,
     .radius = 8 * 65536},
    {.first_vertex = 8,
     .vertex_count = 4,
     .first_face = 2,
     .face_count = 1,
     .kind = FXL_MODEL_CONVEX,
     .radius = 12 * 65536}};
static const fxl_instance instances[] = {
    {{0, 0, 0}, 0, 0, 0}, {{0, 0, 0}, 1, 0, 0}, {{0, 0, 0}, 2, 0, 0}};

static uint8_t texels[8 * 8];
static fxl_texture texture = {.texels = texels, .log_width = 3, .log_height = 3, .levels = 1};
static fxl_surface surface = {.texture = 1, .opacity = 16};
static fxl_mapped_face mapped[] = {
    {.corners = {0, 1, 2}, .texels = {{0, 8 * 65536}, {0, 0}, {48 * 65536, 0}}}};
static uint16_t face_map[QUADS];
static fxl_surface_set set = {.textures = &texture,
                              .surfaces = &surface,
                              .faces = mapped,
                              .face_map = face_map,
                              .texture_count = 1,
                              .surface_count = 1,
                              .face_count = 1};

static fxl_scene scene;
static fxl_config config;
static fxl_renderer renderer;
static fxl_surfaces surfaces;
static fxl_depth depth;
static FXL_ALIGN_8 uint8_t memory[1024];
static FXL_ALIGN_8 uint8_t cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 16)];
static FXL_ALIGN_8 uint8_t room[8192]; /* of clippers, beams, another workspace */
static uint8_t frame[WIDTH * HEIGHT], again[WIDTH * HEIGHT];

static const fxl_pose eye = {{0, 0, 0}, 6u << 23, 0u - (2u << 23), 1u << 23};

static void start(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory));
}

static void start_with(const fxl_visibility *method)
{
    start();
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_set_depth(&renderer, &depth, method, cells, sizeof cells));
}

void setUp(void)
{
    scene = (fxl_scene){.vertices = vertices,
                        .indices = indices,
                        .faces = faces,
                        .models = models,
                        .instances = instances,
                        .vertex_count = 12,
                        .index_count = 12,
                        .face_count = QUADS,
                        .model_count = QUADS,
                        .instance_count = QUADS};
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(((i >> 2) + (i >> 4)) % 2 == 0 ? 99 : 98);
    }
    texture.flags = 0;
    surface = (fxl_surface){.texture = 1, .opacity = 16};
    memset(face_map, 0, sizeof face_map);
    set.blend = NULL;
    set.blend_first = set.blend_count = 0;
    config = fxl_config_default(WIDTH, HEIGHT);
    config.fov = FXL_ANGLE_QUARTER;
    config.near_z = 4096;
    config.far_z = 64 * 65536;
    config.background = BACKGROUND;
}

void tearDown(void)
{
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The distance at which a face is seen at a point of the screen; infinite where it is not. *edge:
 * how far the point is from the face's border, in world units. */
static double distance_of(const fxl_face *face, double x, double y, double *edge)
{
    const fxl_axes *axes = &renderer.frame.view.camera.axes;
    const fxl_point *eye_point = &renderer.frame.view.camera.position;
    const fxl_model *model = &models[face - faces];
    const double focal = renderer.frame.view.lens.focal / 65536.0, one = FXL_Q2_30_ONE;
    const double dx = (x - WIDTH / 2.0) / focal, dy = (HEIGHT / 2.0 - y) / focal;
    const double way[3] = {(axes->right.x * dx + axes->up.x * dy + axes->forward.x) / one,
                           (axes->right.y * dx + axes->up.y * dy + axes->forward.y) / one,
                           (axes->right.z * dx + axes->up.z * dy + axes->forward.z) / one};
    const double normal[3] = {face->normal.x / one, face->normal.y / one, face->normal.z / one};
    const double length = sqrt(dot(normal, normal));
    double corners[4][3], z, to[3];
    for (int i = 0; i < 4; i++) {
        const fxl_point *v = &vertices[model->first_vertex + (uint32_t)i];
        corners[i][0] = (v->x - eye_point->x) / 65536.0;
        corners[i][1] = (v->y - eye_point->y) / 65536.0;
        corners[i][2] = (v->z - eye_point->z) / 65536.0;
    }
    z = dot(normal, corners[0]) / dot(normal, way);
    if (!(z >= config.near_z / 65536.0 && z <= config.far_z / 65536.0)) {
        return INFINITY;
    }
    for (int k = 0; k < 3; k++) {
        to[k] = z * way[k];
    }
    for (int i = 0; i < 4; i++) {
        const double *a = corners[i], *b = corners[(i + 1) % 4];
        const double side[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const double from[3] = {to[0] - a[0], to[1] - a[1], to[2] - a[2]};
        const double in[3] = {side[1] * normal[2] - side[2] * normal[1],
                              side[2] * normal[0] - side[0] * normal[2],
                              side[0] * normal[1] - side[1] * normal[0]};
        const double inside = -dot(in, from) / (sqrt(dot(side, side)) * length);
        *edge = fmin(*edge, fabs(inside));
        if (inside < 0) {
            return INFINITY;
        }
    }
    return z;
}

/* Draws the frame, and compares every pixel that is farther than a little from an edge and where
 * the nearest face is nearer than the next by more than the resolution. */
static void check_frame(double resolution)
{
    uint32_t checked = 0, seen[QUADS] = {0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double nearest = INFINITY, next = INFINITY, edge = INFINITY;
        int found = -1;
        for (int k = 0; k < QUADS; k++) {
            const double z = distance_of(&faces[k], i % WIDTH + 0.5, i / WIDTH + 0.5, &edge);
            next = fmin(next, fmax(z, nearest));
            if (z < nearest) {
                nearest = z;
                found = k;
            }
        }
        if (edge < 1e-3 || (next - nearest) <= resolution * nearest) {
            continue;
        }
        checked++;
        if (found >= 0) {
            seen[found]++;
        }
        TEST_ASSERT_EQUAL(found < 0 ? BACKGROUND : faces[found].material, frame[i]);
    }
    TEST_ASSERT_GREATER_THAN(WIDTH * HEIGHT * 99 / 100, checked);
    for (int k = 0; k < QUADS; k++) {
        TEST_ASSERT_GREATER_THAN(WIDTH * HEIGHT / 20, seen[k]);
    }
}

void test_the_nearest_of_faces_that_intersect_is_seen(void)
{
    start_with(&fxl_visibility_depth);
    check_frame(33.0 / 32 / 4096); /* far is 1024 near: 11 octaves, 12 bits */
}

void test_32_bits_are_finer(void)
{
    start_with(&fxl_visibility_depth_32);
    check_frame(1.0 / 4096 / 32);
}

/* What 16 bits cannot tell apart. */
static uint32_t count_different(void)
{
    uint32_t different = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        different += frame[i] != again[i];
    }
    return different;
}

static void draw_in_bands(uint16_t rows, uint32_t list_words)
{
    renderer.frame.display_list.capacity = list_words;
    memset(again, 0, sizeof again);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    for (uint16_t row = 0; row < HEIGHT; row = (uint16_t)(row + rows)) {
        const fxl_band band = {again + row * WIDTH, WIDTH, WIDTH, row, rows};
        fxl_fill_band(&band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
    }
    TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
}

static void check_bands(const fxl_visibility *method)
{
    static const uint32_t sizes[] = {FXL_DEPTH_BYTES(WIDTH, 1, 32), FXL_DEPTH_BYTES(WIDTH, 5, 16),
                                     sizeof cells};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    for (uint32_t i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_renderer_set_depth(&renderer, &depth, method, cells, sizes[i]));
        for (uint32_t words = 0; words <= 128; words += 32) {
            draw_in_bands(4, words);
            draw_in_bands(HEIGHT, words);
            const bool whole =
                sizes[i] >= FXL_DEPTH_BYTES(WIDTH, HEIGHT, 16) && method == &fxl_visibility_depth;
            TEST_ASSERT_EQUAL(whole, renderer.workspace.counters.split_bands == 0);
        }
    }
}

void test_bands_lists_and_memory_give_the_same_pixels(void)
{
    start_with(&fxl_visibility_depth);
    check_bands(&fxl_visibility_depth);
    start_with(&fxl_visibility_depth_32);
    check_bands(&fxl_visibility_depth_32);
}

void test_every_clipper_gives_the_same_depths(void)
{
    static const fxl_clipper *const clippers[] = {&fxl_clipper_world, &fxl_clipper_triangles,
                                                  &fxl_clipper_near};
    start_with(&fxl_visibility_depth);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    for (uint32_t i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clippers[i], room,
                                                           clippers[i]->workspace_size));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
        TEST_ASSERT_LESS_THAN(4, count_different()); /* pixels at edges */
    }
}

static void set_texture(uint32_t face)
{
    face_map[face] = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_surfaces(&renderer, &surfaces, &set));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_depth(&renderer, &depth, &fxl_visibility_depth,
                                                     cells, sizeof cells));
}

/* Pixels of the texture of face `face` are where the flat frame has its colour; a texel of the key
 * lets through what is behind. */
static void check_textured(uint32_t face, bool keyed)
{
    uint32_t drawn[2] = {0, 0};
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const bool texel = again[i] == 98 || again[i] == 99;
        if (frame[i] != faces[face].material) {
            TEST_ASSERT_EQUAL(frame[i], again[i]);
        } else if (!keyed) {
            TEST_ASSERT_TRUE(texel);
        } else {
            TEST_ASSERT_NOT_EQUAL(99, again[i]);
            TEST_ASSERT_NOT_EQUAL(faces[face].material, again[i]);
        }
        drawn[0] += texel;
        drawn[1] += frame[i] == faces[face].material && !texel;
    }
    TEST_ASSERT_GREATER_THAN(50, drawn[0]);
    TEST_ASSERT_EQUAL(keyed, drawn[1] > 50);
}

void test_textures_are_seen_where_they_are_nearest(void)
{
    static uint8_t plain[WIDTH * HEIGHT]; /* without a key */
    for (uint32_t face = 0; face < QUADS; face++) {
        memset(face_map, 0, sizeof face_map);
        texture.flags = 0;
        start_with(&fxl_visibility_depth);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
        set_texture(face);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
        check_textured(face, false);
        memcpy(plain, again, sizeof plain);
        texture.flags = FXL_TEXTURE_KEYED;
        texture.key = 99;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
        check_textured(face, true);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            TEST_ASSERT_EQUAL(plain[i] == 98, again[i] == 98);
        }
        memcpy(frame, again, sizeof frame);
        check_bands(&fxl_visibility_depth);
    }
}

void test_a_stippled_surface_keeps_depth_where_it_is_drawn(void)
{
    start_with(&fxl_visibility_depth);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    set_texture(1);
    surface.opacity = 8;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
    uint32_t drawn = 0, through = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const bool texel = again[i] == 98 || again[i] == 99;
        drawn += texel;
        through += frame[i] == faces[1].material && !texel;
        TEST_ASSERT_TRUE(frame[i] == faces[1].material || !texel);
    }
    TEST_ASSERT_INT_WITHIN(WIDTH * HEIGHT / 50, drawn, through);
    TEST_ASSERT_GREATER_THAN(100, drawn);
}

/* Glass: face 2 shows what is beneath it in another colour, whatever is drawn first. */
void test_a_blended_surface_is_seen_over_what_is_behind_it(void)
{
    static uint8_t beneath[WIDTH * HEIGHT], table[FXL_BLEND_TABLE_BYTES(1)];
    for (uint32_t i = 0; i < sizeof table; i++) {
        table[i] = (uint8_t)(i ^ 0x80);
    }
    start_with(&fxl_visibility_depth);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    memset(texels, 99, sizeof texels);
    texture.flags = FXL_TEXTURE_KEYED;
    texture.key = 99;
    set_texture(2);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, beneath, WIDTH));
    surface.texture = 0;
    surface.flags = FXL_SURFACE_BLEND;
    set.blend = table;
    set.blend_first = faces[2].material;
    set.blend_count = 1;
    set_texture(2);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
    uint32_t seen_through = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const bool is_glass = frame[i] == faces[2].material;
        seen_through += is_glass && beneath[i] != BACKGROUND;
        TEST_ASSERT_EQUAL(is_glass ? table[beneath[i]] : frame[i], again[i]);
    }
    TEST_ASSERT_GREATER_THAN(100, seen_through);
    memcpy(frame, again, sizeof frame);
    check_bands(&fxl_visibility_depth);
}

/* The lens of a part of the screen is off-centre: its picture is a part of the whole one. */
void test_an_off_centre_lens_shows_the_same_depths(void)
{
    enum {
        LEFT = 6,
        TOP = 4,
        PART_WIDTH = 36,
        PART_HEIGHT = 20
    };
    fxl_lens lens;
    start_with(&fxl_visibility_depth);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_of_part(&renderer.frame.view.lens, LEFT, TOP, PART_WIDTH,
                                               PART_HEIGHT, &lens));
    fxl_memory tables = {(fxl_order_entry *)(void *)memory, scene.order_needed, NULL, 0, NULL, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &scene, &lens, &tables));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_depth(&renderer, &depth, &fxl_visibility_depth,
                                                     cells, sizeof cells));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    const fxl_band band = {again, PART_WIDTH, WIDTH, 0, PART_HEIGHT};
    fxl_fill_band(&band, BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
    uint32_t different = 0;
    for (uint32_t y = 0; y < PART_HEIGHT; y++) {
        for (uint32_t x = 0; x < PART_WIDTH; x++) {
            different += again[y * WIDTH + x] != frame[(y + TOP) * WIDTH + x + LEFT];
        }
    }
    TEST_ASSERT_LESS_THAN(3, different);
}

/* The same faces as instances of one that turns, by the default clipper and by one that takes
 * points of the world: then the shader gets pieces. */
void test_turned_instances_have_depth(void)
{
    static const fxl_turn turns[QUADS] = {FXL_TURN_NONE, FXL_TURN_NONE, FXL_TURN_NONE};
    start_with(&fxl_visibility_depth);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
    scene.turns = turns;
    scene.turn_code = &fxl_turned_instances;
    start_with(&fxl_visibility_depth);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
    TEST_ASSERT_EQUAL(0, renderer.workspace.counters.rounded);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fxl_clipper_world, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
    TEST_ASSERT_EQUAL(QUADS, renderer.workspace.counters.rounded);
    TEST_ASSERT_LESS_THAN(4, count_different());
}

/* A light of all colours' ramp that makes each face another: the colour is the light's, the depth
 * the face's. */
void test_pieces_of_light_beams_have_depth(void)
{
    static uint8_t lit[256];
    fxl_beam beam;
    for (uint32_t i = 0; i < sizeof lit; i++) {
        lit[i] = (uint8_t)(i + 1);
    }
    start_with(&fxl_visibility_depth);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    const fxl_point lamp = {0, 8 * 65536, 3 * 65536};
    const fxl_point outline[] = {{-2 * 65536, 0, 65536},
                                 {-2 * 65536, 0, 6 * 65536},
                                 {2 * 65536, 0, 6 * 65536},
                                 {2 * 65536, 0, 65536}};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, outline, 4, &beam));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_beams(&renderer, &beam, 1, lit, room, sizeof room));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
    uint32_t bright = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        bright += again[i] == frame[i] + 1;
        TEST_ASSERT_TRUE(again[i] == frame[i] || again[i] == frame[i] + 1);
    }
    TEST_ASSERT_GREATER_THAN(20, bright);
}

/* Two walls in one plane, front to back, and far to near as with glass: the order decides. */
void test_of_faces_in_one_plane_that_is_seen_which_is_drawn_later(void)
{
    static const fxl_face walls[] = {{{0, 0, -FXL_Q2_30_ONE}, 0, 4, 10, 0},
                                     {{0, 0, -FXL_Q2_30_ONE}, 4, 4, 20, 0}};
    static const fxl_point corners[] = {{-393216, -131072, 262144}, {-393216, 131072, 262144},
                                        {393216, 131072, 262144},   {393216, -131072, 262144},
                                        {-393216, -131072, 262144}, {-393216, 131072, 262144},
                                        {393216, 131072, 262144},   {393216, -131072, 262144}};
    static const fxl_model two[] = {
        {.vertex_count = 4, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = 8 * 65536},
        {.first_vertex = 4,
         .vertex_count = 4,
         .first_face = 1,
         .face_count = 1,
         .kind = FXL_MODEL_CONVEX,
         .radius = 8 * 65536}};
    static const fxl_instance both[] = {{{0, 0, 0}, 0, 0, 0}, {{65536, 0, 0}, 1, 0, 0}};
    static const uint8_t table[FXL_BLEND_TABLE_BYTES(1)];
    scene.vertices = corners;
    scene.vertex_count = 8;
    scene.faces = walls;
    scene.face_count = scene.model_count = scene.instance_count = 2;
    scene.models = two;
    scene.instances = both;
    scene.index_count = 8;
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    start_with(&fxl_visibility_depth);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
    TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
    surface = (fxl_surface){.flags = FXL_SURFACE_BLEND, .opacity = 16};
    set.blend = table;
    set.blend_count = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_surfaces(&renderer, &surfaces, &set));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_depth(&renderer, &depth, &fxl_visibility_depth,
                                                     cells, sizeof cells));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
    TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
}

/* Another core's workspace, with a depth buffer of its own. */
void test_two_workspaces_draw_halves_of_a_frame(void)
{
    fxl_workspace other;
    start_with(&fxl_visibility_depth);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&other, &renderer, room, sizeof room));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    for (uint16_t half = 0; half < 2; half++) {
        const uint16_t row = (uint16_t)(half * HEIGHT / 2);
        const fxl_band band = {again + row * WIDTH, WIDTH, WIDTH, row, HEIGHT / 2};
        fxl_fill_band(&band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, half ? fxl_frame_draw_with(&renderer, &other, &band)
                                       : fxl_frame_draw(&renderer, &band));
    }
    TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
}

/* Once another method is set, faces are drawn as ever. */
void test_another_method_ends_the_depth(void)
{
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_depth(&renderer, &depth, &fxl_visibility_depth,
                                                     cells, sizeof cells));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
    TEST_ASSERT_GREATER_THAN(50, count_different());
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_set_visibility(&renderer, &fxl_visibility_sorted, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
    TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
}

/* Set as any other method, without its shader, it draws what a span buffer does. */
void test_without_its_record_it_hides_by_order(void)
{
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_renderer_set_visibility(&renderer, &fxl_visibility_depth, cells, sizeof cells));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, again, WIDTH));
    TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
    draw_in_bands(6, 0);
}

void test_what_is_refused(void)
{
    start();
    const fxl_visibility *const method = &fxl_visibility_depth;
    fxl_renderer none;
    memset(&none, 0, sizeof none);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_renderer_set_depth(NULL, &depth, method, cells, sizeof cells));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_renderer_set_depth(&renderer, NULL, method, cells, sizeof cells));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_renderer_set_depth(&renderer, &depth, NULL, cells, sizeof cells));
    TEST_ASSERT_EQUAL(
        FXL_E_ARGUMENT,
        fxl_renderer_set_depth(&renderer, &depth, &fxl_visibility_sorted, cells, sizeof cells));
    TEST_ASSERT_EQUAL(
        FXL_E_ARGUMENT,
        fxl_renderer_set_depth(&renderer, &depth, &fxl_visibility_surfaces, cells, sizeof cells));
    TEST_ASSERT_EQUAL(FXL_E_ORDER,
                      fxl_renderer_set_depth(&none, &depth, method, cells, sizeof cells));
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT,
                      fxl_renderer_set_depth(&renderer, &depth, method, cells + 2, 1000));
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_renderer_set_depth(&renderer, &depth, method, cells,
                                                             FXL_DEPTH_BYTES(WIDTH, 1, 16) - 1));
    TEST_ASSERT_EQUAL(6, renderer.workspace.counters.refused_calls);
    TEST_ASSERT_EQUAL_PTR(&fxl_visibility_sorted, renderer.visibility);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_depth(&renderer, &depth, method, cells,
                                                     FXL_DEPTH_BYTES(WIDTH, 1, 16)));
}
