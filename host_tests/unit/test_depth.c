/* SPDX-License-Identifier: MIT */
/* The depth buffer, against the definition in double: a ray through each pixel's centre. */
#include <math.h>

#include "depth_scene.h"
#include "study/clippers.h"

static depth_scene *made;

void setUp(void)
{
    made = depth_scene_make();
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The distance at which a face is seen at a point of the screen; infinite where it is not. *edge:
 * how far the point is from the face's border, in world units. */
static double distance_of(const fxl_face *face, double x, double y, double *edge)
{
    const fxl_axes *axes = &made->renderer.frame.view.camera.axes;
    const fxl_point *eye_point = &made->renderer.frame.view.camera.position;
    const fxl_model *model = &made->scene.models[face - made->scene.faces];
    const double focal = made->renderer.frame.view.lens.focal / 65536.0, one = FXL_Q2_30_ONE;
    const double dx = (x - DEPTH_SCENE_WIDTH / 2.0) / focal,
                 dy = (DEPTH_SCENE_HEIGHT / 2.0 - y) / focal;
    const double way[3] = {(axes->right.x * dx + axes->up.x * dy + axes->forward.x) / one,
                           (axes->right.y * dx + axes->up.y * dy + axes->forward.y) / one,
                           (axes->right.z * dx + axes->up.z * dy + axes->forward.z) / one};
    const double normal[3] = {face->normal.x / one, face->normal.y / one, face->normal.z / one};
    const double length = sqrt(dot(normal, normal));
    double corners[4][3], z, to[3];
    for (int i = 0; i < 4; i++) {
        const fxl_point *v = &made->scene.vertices[model->first_vertex + (uint32_t)i];
        corners[i][0] = (v->x - eye_point->x) / 65536.0;
        corners[i][1] = (v->y - eye_point->y) / 65536.0;
        corners[i][2] = (v->z - eye_point->z) / 65536.0;
    }
    z = dot(normal, corners[0]) / dot(normal, way);
    if (!(z >= made->config.near_z / 65536.0 && z <= made->config.far_z / 65536.0)) {
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
    uint32_t checked = 0, seen[DEPTH_SCENE_QUADS] = {0};
    depth_scene_draw(made, made->frame);
    for (int i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        double nearest = INFINITY, next = INFINITY, edge = INFINITY;
        int found = -1;
        for (int k = 0; k < DEPTH_SCENE_QUADS; k++) {
            const double z = distance_of(&made->scene.faces[k], i % DEPTH_SCENE_WIDTH + 0.5,
                                         i / DEPTH_SCENE_WIDTH + 0.5, &edge);
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
        TEST_ASSERT_EQUAL(found < 0 ? DEPTH_SCENE_BACKGROUND : made->scene.faces[found].material,
                          made->frame[i]);
    }
    TEST_ASSERT_GREATER_THAN(DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT * 99 / 100, checked);
    for (int k = 0; k < DEPTH_SCENE_QUADS; k++) {
        TEST_ASSERT_GREATER_THAN(DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT / 20, seen[k]);
    }
}

/* SPEC 10.1b, 10.2a-b, 10.6a-b */
void test_the_nearest_of_faces_that_intersect_is_seen(void)
{
    depth_scene_start_with(made, &fxl_palette_depth_16);
    check_frame(33.0 / 32 / 4096); /* far is 1024 near: 11 octaves, 12 bits */
}

/* SPEC 10.3f, 10.6b */
void test_32_bits_are_finer(void)
{
    depth_scene_start_with(made, &fxl_palette_depth_32);
    check_frame(1.0 / 4096 / 32);
}

/* What 16 bits cannot tell apart. */
static uint32_t count_different(void)
{
    uint32_t different = 0;
    for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        different += made->frame[i] != made->again[i];
    }
    return different;
}

void test_bands_lists_and_memory_give_the_same_pixels(void)
{
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_check_bands(made, &fxl_palette_depth_16);
    depth_scene_start_with(made, &fxl_palette_depth_32);
    depth_scene_check_bands(made, &fxl_palette_depth_32);
}

void test_every_clipper_gives_the_same_depths(void)
{
    static const fxl_clipper *const clippers[] = {&fxl_clipper_world, &fxl_clipper_triangles,
                                                  &fxl_clipper_near};
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->frame);
    for (uint32_t i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&made->renderer, clippers[i], made->room,
                                                           clippers[i]->workspace_size));
        depth_scene_draw(made, made->again);
        TEST_ASSERT_LESS_THAN(4, count_different()); /* pixels at edges */
    }
}

/* The lens of a part of the screen is off-centre: its picture is a part of the whole one. */
/* SPEC 10.1a-b */
void test_an_off_centre_lens_shows_the_same_depths(void)
{
    enum {
        LEFT = 6,
        TOP = 4,
        PART_WIDTH = 36,
        PART_HEIGHT = 20
    };
    fxl_lens lens;
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->frame);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_of_part(&made->renderer.frame.view.lens, LEFT, TOP,
                                               PART_WIDTH, PART_HEIGHT, &lens));
    fxl_memory tables = {
        (fxl_draw_entry *)(void *)made->memory, made->scene.draw_list_needed, NULL, 0, NULL, 0};
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init_with(&made->renderer, &made->scene, &lens, &tables));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_choose(&made->renderer, &made->config));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &depth_scene_eye));
    const fxl_band band = {.pixels = made->again,
                           .width = PART_WIDTH,
                           .stride = DEPTH_SCENE_WIDTH,
                           .first_row = 0,
                           .rows = PART_HEIGHT};
    fxl_fill_band(&band, DEPTH_SCENE_BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&made->renderer, &band));
    uint32_t different = 0;
    for (uint32_t y = 0; y < PART_HEIGHT; y++) {
        for (uint32_t x = 0; x < PART_WIDTH; x++) {
            different += made->again[y * DEPTH_SCENE_WIDTH + x] !=
                         made->frame[(y + TOP) * DEPTH_SCENE_WIDTH + x + LEFT];
        }
    }
    TEST_ASSERT_LESS_THAN(3, different);
}

/* The same faces as instances of one that turns, by the default clipper and by one that takes
 * points of the world: then the shader gets pieces. */
/* SPEC 10.1a */
void test_turned_instances_have_depth(void)
{
    static const fxl_placement placements[DEPTH_SCENE_QUADS] = {
        FXL_PLACEMENT_NONE, FXL_PLACEMENT_NONE, FXL_PLACEMENT_NONE};
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->again);
    made->scene.placements = placements;
    made->scene.placement_code = &fxl_turned_instances;
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->frame);
    TEST_ASSERT_EQUAL_MEMORY(made->frame, made->again, sizeof made->frame);
    TEST_ASSERT_EQUAL(0, made->renderer.workspace.counters.rounded);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_set_clipper(&made->renderer, &fxl_clipper_world, NULL, 0));
    depth_scene_draw(made, made->again);
    TEST_ASSERT_EQUAL(DEPTH_SCENE_QUADS, made->renderer.workspace.counters.rounded);
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
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->frame);
    const fxl_point lamp = {0, 8 * 65536, 3 * 65536};
    const fxl_point outline[] = {{-2 * 65536, 0, 65536},
                                 {-2 * 65536, 0, 6 * 65536},
                                 {2 * 65536, 0, 6 * 65536},
                                 {2 * 65536, 0, 65536}};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, outline, 4, &beam));
    const fxl_beam_set beams = {&beam, 1, lit};
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_attach_beams(&made->renderer, &beams, made->room, sizeof made->room));
    depth_scene_draw(made, made->again);
    uint32_t bright = 0;
    for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        bright += made->again[i] == made->frame[i] + 1;
        TEST_ASSERT_TRUE(made->again[i] == made->frame[i] || made->again[i] == made->frame[i] + 1);
    }
    TEST_ASSERT_GREATER_THAN(20, bright);
}

/* Two walls in one plane, front to back, and far to near as with glass: the order decides. */
/* SPEC 10.4c */
void test_of_faces_in_one_plane_that_is_seen_which_is_drawn_later(void)
{
    static const fxl_face walls[] = {{{0, 0, -FXL_Q2_30_ONE}, 4, 10, FXL_INDICES_AT(0, 0)},
                                     {{0, 0, -FXL_Q2_30_ONE}, 4, 20, FXL_INDICES_AT(0, 4)}};
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
    made->scene.vertices = corners;
    made->scene.vertex_count = 8;
    made->scene.faces = walls;
    made->scene.face_count = made->scene.model_count = made->scene.instance_count = 2;
    made->scene.models = two;
    made->scene.instances = both;
    made->scene.index_count = 8;
    depth_scene_start(made);
    depth_scene_draw(made, made->frame);
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->again);
    TEST_ASSERT_EQUAL_MEMORY(made->frame, made->again, sizeof made->frame);
    made->surface = (fxl_surface){.flags = FXL_SURFACE_BLEND, .opacity = 16};
    made->set.blend = table;
    made->set.blend_count = 1;
    made->is_mapped = true;
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->again);
    TEST_ASSERT_EQUAL_MEMORY(made->frame, made->again, sizeof made->frame);
}

/* Pixels that show the nearer of two faces of a sorted model, which has the smaller number and lies
 * within the other one. */
static uint32_t count_of_nearer(void)
{
    uint32_t nearer = 0, others = 0;
    for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        nearer += made->frame[i] == 10;
        others += made->frame[i] == 20;
    }
    TEST_ASSERT_GREATER_THAN(100, others);
    return nearer;
}

/* The same where pixels have 16 bits: colour i is i there. */
static void draw_wide(const fxl_target *target)
{
    static uint16_t palette[256], wide[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT];
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)i;
    }
    made->config.palette = palette;
    depth_scene_start_with(made, target);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_render(&made->renderer, &depth_scene_eye, wide, DEPTH_SCENE_WIDTH));
    for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        made->frame[i] = (uint8_t)wide[i];
    }
}

/* The two faces share a corner, so that their codes are equal. Sorted by distance the nearer one is
 * seen; by number the other one hides it: at once, by a list, in bands, turned, at each target. */
/* SPEC 6.3d, 6.4b, 10.4a, 10.4c */
void test_of_equal_codes_of_a_sorted_model_that_of_the_greater_number_is_seen(void)
{
    static const fxl_point corners[] = {{-131072, -131072, 262144}, {-131072, 131072, 262144},
                                        {131072, 131072, 262144},   {131072, -131072, 262144},
                                        {-131072, 196608, 262144},  {655360, 196608, 262144},
                                        {655360, -131072, 262144}};
    static const uint16_t indices[] = {0, 1, 2, 3, 0, 4, 5, 6};
    static const fxl_face walls[] = {{{0, 0, -FXL_Q2_30_ONE}, 4, 10, FXL_INDICES_AT(0, 0)},
                                     {{0, 0, -FXL_Q2_30_ONE}, 4, 20, FXL_INDICES_AT(0, 4)}};
    static const fxl_model model = {
        .vertex_count = 7, .face_count = 2, .kind = FXL_MODEL_SORTED, .radius = 12 * 65536};
    static const fxl_instance instance = {{0, 0, 0}, 0, 0, 0};
    static const fxl_placement placement = FXL_PLACEMENT_NONE;
    static const fxl_cluster_code *const codes[] = {NULL, &fxl_clusters};
    static const fxl_target *const targets[] = {&fxl_palette_depth_16, &fxl_palette_depth_32};
    static const uint8_t table[FXL_BLEND_TABLE_BYTES(1)];
    made->scene.vertices = corners;
    made->scene.vertex_count = 7;
    made->scene.indices = indices;
    made->scene.index_count = 8;
    made->scene.faces = walls;
    made->scene.face_count = 2;
    made->scene.models = &model;
    made->scene.instances = &instance;
    made->scene.model_count = made->scene.instance_count = 1;
    depth_scene_start(made);
    depth_scene_draw(made, made->frame);
    TEST_ASSERT_GREATER_THAN(100, count_of_nearer());
    for (uint32_t i = 0; i < 8; i++) {
        made->scene.cluster_code = codes[i / 2 % 2];
        made->scene.placements = i < 4 ? NULL : &placement;
        made->scene.placement_code = i < 4 ? NULL : &fxl_turned_instances;
        depth_scene_start_with(made, targets[i % 2]);
        depth_scene_check_bands(made, targets[i % 2]);
        TEST_ASSERT_EQUAL(0, count_of_nearer());
    }
    draw_wide(&fxl_rgb565_depth_16);
    TEST_ASSERT_EQUAL(0, count_of_nearer());
    draw_wide(&fxl_rgb565_depth_32);
    TEST_ASSERT_EQUAL(0, count_of_nearer());
    made->surface = (fxl_surface){.flags = FXL_SURFACE_BLEND, .opacity = 16};
    made->set.blend = table;
    made->set.blend_count = 1;
    made->is_mapped = true;
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->frame);
    TEST_ASSERT_GREATER_THAN(100, count_of_nearer());
}

/* Another core's workspace, with a depth buffer of its own. */
void test_two_workspaces_draw_halves_of_a_frame(void)
{
    fxl_workspace other;
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->frame);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_workspace_init(&other, &made->renderer, made->room, sizeof made->room));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &depth_scene_eye));
    for (uint16_t half = 0; half < 2; half++) {
        const uint16_t row = (uint16_t)(half * DEPTH_SCENE_HEIGHT / 2);
        const fxl_band band = {.pixels = made->again + row * DEPTH_SCENE_WIDTH,
                               .width = DEPTH_SCENE_WIDTH,
                               .stride = DEPTH_SCENE_WIDTH,
                               .first_row = row,
                               .rows = DEPTH_SCENE_HEIGHT / 2};
        fxl_fill_band(&band, DEPTH_SCENE_BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, half ? fxl_frame_draw_with(&made->renderer, &other, &band)
                                       : fxl_frame_draw(&made->renderer, &band));
    }
    TEST_ASSERT_EQUAL_MEMORY(made->frame, made->again, sizeof made->frame);
}

/* A buffer of one row is the least. */
void test_what_is_refused(void)
{
    const uint32_t least = FXL_DEPTH_BYTES(DEPTH_SCENE_WIDTH, 1, 16);
    depth_scene_start(made);
    fxl_config config = made->config;
    config.target = &fxl_palette_depth_16;
    config.depth_size = least;
    config.depth = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_choose(&made->renderer, &config));
    config.depth = made->cells + 2;
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_renderer_choose(&made->renderer, &config));
    config.depth = made->cells;
    config.depth_size = least - 1;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_renderer_choose(&made->renderer, &config));
    TEST_ASSERT_EQUAL(3, made->renderer.workspace.counters.refused_calls);
    TEST_ASSERT_EQUAL_PTR(&fxl_palette, made->renderer.target);
    config.depth_size = least;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_choose(&made->renderer, &config));
    TEST_ASSERT_EQUAL_PTR(&fxl_palette_depth_16, made->renderer.target);
}

/* As many parts as it can count, and one more. */
void test_the_count_of_parts_ends(void)
{
    depth_scene_start(made);
    fxl_config config = made->config;
    const fxl_band band = UNIT_BAND(made->frame, DEPTH_SCENE_WIDTH, 0, DEPTH_SCENE_HEIGHT);
    config.target = &fxl_palette_depth_16;
    config.depth = made->cells;
    config.depth_size = FXL_DEPTH_BYTES(DEPTH_SCENE_WIDTH, 1, 16);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_choose(&made->renderer, &config));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &depth_scene_eye));
    made->renderer.workspace.counters.split_bands = UINT16_MAX - 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&made->renderer, &band));
    TEST_ASSERT_EQUAL_UINT32(UINT16_MAX, made->renderer.workspace.counters.split_bands);
}
