/* SPDX-License-Identifier: MIT */
/* Among a tree, in reach of a beam, and with clippers that work from points of the world, a turned
 * instance is drawn as a model of the rounded points would be. */
#include "bsp_scene.h"
#include "choices.h"
#include "clippers_list.h"
#include "frame_bands.h"
#include "scene/placement_code.h"
#include "placements.h"
#include "view/placement.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    BACKGROUND = 200,
    WORDS = 400,
    ORDER = TINY_INSTANCES + 6,
    TURNED = 2, /* the instance that is turned */
    METHODS = 3
};

static FXL_ALIGN_8 fxl_clipper_workspace clipper_room;
static uint64_t bsp_room[64], pieces[768], light_room[600];
static uint8_t frames[2][WIDTH * HEIGHT], lit[256];
static uint32_t list[WORDS];
static fxl_draw_entry order[ORDER];
static fxl_renderer renderer;
static fxl_placement placement;

/* The scene with a model of the rounded points in place of the placement. */
static struct {
    fxl_point vertices[24];
    uint16_t indices[72];
    fxl_face faces[18];
    fxl_model models[3];
    fxl_instance instances[TINY_INSTANCES];
    fxl_scene scene;
} baked;

static const fxl_point window[] = {{Q16(-0.6), Q16(5), Q16(-0.7)},
                                   {Q16(0.5), Q16(5), Q16(-0.8)},
                                   {Q16(0.7), Q16(5), Q16(0.4)},
                                   {Q16(-0.4), Q16(5), Q16(0.6)}};
static fxl_beam beam;

static void bake(const tiny_scene *tiny)
{
    const fxl_model *model = &tiny->models[0];
    const fxl_point nowhere = {0, 0, 0};
    memcpy(baked.vertices, tiny->vertices, sizeof tiny->vertices);
    memcpy(baked.indices, tiny->corners, sizeof tiny->corners);
    memcpy(baked.indices + 48, tiny->corners, 24 * sizeof *baked.indices);
    memcpy(baked.faces, tiny->faces, sizeof tiny->faces);
    memcpy(baked.models, tiny->models, sizeof tiny->models);
    memcpy(baked.instances, tiny->instances, sizeof tiny->instances);
    for (uint32_t i = 0; i < 8; i++) {
        fxl_placement_point(&placement, &nowhere, &tiny->vertices[i], &baked.vertices[16 + i]);
    }
    for (uint32_t i = 0; i < 6; i++) {
        baked.faces[12 + i] = tiny->faces[i];
        baked.faces[12 + i].first_index += 48;
        fxl_placement_direction(&placement, &tiny->faces[i].normal, &baked.faces[12 + i].normal);
    }
    baked.models[2] = *model;
    baked.models[2].first_vertex = 16;
    baked.models[2].first_face = 12;
    baked.models[2].radius = fxl_placement_radius(&placement, model->radius);
    baked.instances[TURNED].model = 2;
    baked.scene = tiny->scene;
    baked.scene.vertices = baked.vertices;
    baked.scene.indices = baked.indices;
    baked.scene.faces = baked.faces;
    baked.scene.models = baked.models;
    baked.scene.instances = baked.instances;
    baked.scene.vertex_count = 24;
    baked.scene.index_count = 72;
    baked.scene.face_count = 18;
    baked.scene.model_count = 3;
    baked.scene.placements = NULL;
}

/* Method 0 sorts; 1 has a tree; 2 has no memory for the pieces of its tree. */
static void draw(fxl_scene *scene, const fxl_clipper *clipper, int method, bool is_lit,
                 const fxl_pose *pose, uint32_t rows, uint8_t *frame)
{
    fxl_scene_fault fault = {"", 0};
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order, ORDER, list, (uint32_t)unit_between(0, WORDS), NULL, 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check_all(scene, &fault), fault.what);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, &clipper_room,
                                                       clipper->workspace_size));
    if (method > 0) {
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_tree, bsp_room, sizeof bsp_room));
        fxl_bsp_workspace *workspace = renderer.order_memory;
        workspace->pieces = method == 1 ? pieces : NULL;
        workspace->pieces_size = method == 1 ? sizeof pieces : 0;
    }
    if (is_lit) {
        const fxl_beam_set beams = {&beam, 1, lit};
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_attach_beams(&renderer, &beams, light_room, sizeof light_room));
    }
    frame_draw_pose(&renderer, pose, frame, rows, BACKGROUND);
}

static bool is_in_sight(void)
{
    for (uint32_t i = 0; i < renderer.frame.visible_count; i++) {
        if (renderer.frame.draw_list[i].index == TURNED) {
            return true;
        }
    }
    return false;
}

/* The tree's cube at z = 10, or about the origin where the beam is. */
static tiny_scene *make(void)
{
    const fxl_point lamp = {Q16(0.3), Q16(90), Q16(-3)};
    tiny_scene *tiny = bsp_make()->tiny;
    for (int i = 0; i < 256; i++) {
        lit[i] = (uint8_t)(i + 100);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beam));
    placement = placements_any();
    placement.scale = unit_between(Q16(0.25), Q16(3));
    tiny->instances[TURNED].centre = unit_point(Q16(3));
    tiny->instances[TURNED].centre.z += Q16(10) * unit_between(0, 1);
    tiny->scene.placements = &placement;
    tiny->scene.first_turned = TURNED;
    tiny->scene.placement_code = &fxl_turned_instances;
    bake(tiny);
    return tiny;
}

static fxl_pose any_pose(void)
{
    fxl_pose pose = {unit_point(Q16(3)), unit_random(), unit_random(), unit_random()};
    pose.position.z += Q16(5) * unit_between(0, 2);
    return pose;
}

/* SPEC 8.5 */
void test_rounded_instances_are_those_of_a_baked_model(void)
{
    uint32_t rounded = 0, exact = 0, drawn = 0, spilled = 0;
    for (int round = 0; round < UNIT_REPEAT / 50; round++) {
        tiny_scene *tiny = make();
        const fxl_pose pose = any_pose();
        const int method = unit_between(0, METHODS - 1);
        const bool is_lit = unit_between(0, 1);
        const int which = unit_between(0, CLIPPERS + 1);
        const fxl_clipper *clipper = which < CLIPPERS    ? clippers[which]
                                     : which == CLIPPERS ? &fxl_clipper_view
                                                         : &fxl_clipper_world;
        draw(&baked.scene, clipper, method, is_lit, &pose, HEIGHT, frames[0]);
        fxl_counters expected = renderer.workspace.counters;
        const bool is_reached = is_lit && fxl_beam_reaches(&beam, &baked.instances[TURNED].centre,
                                                           baked.models[2].radius);
        draw(&tiny->scene, clipper, method, is_lit, &pose, (uint32_t)unit_between(1, HEIGHT),
             frames[1]);
        fxl_counters counters = renderer.workspace.counters;
        spilled += counters.spilled > 0;
        const bool is_rounded = method > 0 || is_reached || clipper->by_points != NULL;
        TEST_ASSERT_EQUAL_UINT16(is_rounded && is_in_sight(), counters.rounded);
        if (is_rounded) {
            TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
            expected.spilled = counters.spilled = counters.rounded = 0;
            TEST_ASSERT_EQUAL_MEMORY(&expected, &counters, sizeof counters);
            rounded++;
        } else {
            exact++;
        }
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            drawn += frames[1][i] != BACKGROUND;
        }
    }
    TEST_ASSERT_TRUE(rounded > UNIT_REPEAT / 100 && exact > UNIT_REPEAT / 1000);
    TEST_ASSERT_TRUE(drawn > UNIT_REPEAT && spilled > UNIT_REPEAT / 1000);
}

/* A tree is over an instance that stands still. */
void test_the_instance_of_a_tree_is_not_turned(void)
{
    static fxl_placement placements[TINY_INSTANCES];
    tiny_scene *tiny = make();
    fxl_scene_fault fault = {"", 0};
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        placements[i] = (fxl_placement)FXL_PLACEMENT_NONE;
    }
    tiny->scene.placements = placements;
    tiny->scene.first_turned = 1;
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_scene_check_all(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_STRING("BSP tree", fault.what);
    tiny->scene.first_turned = 2;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, &fault));
}
