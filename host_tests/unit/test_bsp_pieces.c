/* SPDX-License-Identifier: MIT */
/* The pieces of an object that a tree has cut have every vertex of their neighbours: their edges
 * cancel, bit for bit, and one outline is left. */
#include "../../lib/order/bsp_pieces.h"
#include "bsp_scene.h"
#include "choices.h"

enum {
    WIDTH = 64,
    HEIGHT = 48,
    EDGES = 250,
    LIST = 100 * FXL_DISPLAY_LIST_WORDS(5),
    PIECES = 6144
};

typedef struct {
    fxl_point from, to;
} edge;

static edge edges[EDGES];
static uint32_t edge_count, piece_count;
static uint64_t workspace[64], pieces[PIECES / 8];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static fxl_renderer renderer;
static uint32_t list[LIST]; /* holds all: each piece comes once */

static bool same(const fxl_point *a, const fxl_point *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

/* Takes an edge in, or its other owner's out. */
static void add_edge(const fxl_point *from, const fxl_point *to)
{
    for (uint32_t i = 0; i < edge_count; i++) {
        if (same(&edges[i].from, to) && same(&edges[i].to, from)) {
            edges[i] = edges[--edge_count];
            return;
        }
    }
    if (!same(from, to)) {
        TEST_ASSERT_TRUE(edge_count < EDGES);
        edges[edge_count].from = *from;
        edges[edge_count++].to = *to;
    }
}

/* A clipper that looks at pieces: they have vertices of their own, not the scene's. */
static fxl_clip_result take_edges(const fxl_model_view *model_view, const fxl_face *face,
                                  fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    const fxl_point *scene = renderer.scene->vertices;
    if (model_view->vertices != scene && model_view->vertices != scene + 8) {
        for (uint32_t i = 0; i < face->count; i++) {
            add_edge(&model_view->vertices[i], &model_view->vertices[(i + 1u) % face->count]);
        }
        piece_count++;
    }
    return fxl_clipper_view.clip(model_view, face, work, screen);
}

/* How many edges there are on the way round from the first. */
static uint32_t way_round(void)
{
    fxl_point at = edges[0].to;
    uint32_t length = 1;
    while (!same(&at, &edges[0].from) && length <= edge_count) {
        uint32_t i = 0;
        while (i < edge_count && !same(&edges[i].from, &at)) {
            i++;
        }
        TEST_ASSERT_TRUE(i < edge_count);
        at = edges[i].to;
        length++;
    }
    return length;
}

/* A cube turned any way, through the tree's. */
static bsp_scene *make_scene(void)
{
    bsp_scene *made = bsp_make();
    /* In this order, on every compiler. */
    const fxl_angle yaw = unit_random(), pitch = unit_random(), roll = unit_random();
    bsp_tilt(made, yaw, pitch, roll);
    made->tiny->instances[0].centre =
        (fxl_point){unit_between(-Q16(1.5), Q16(1.5)), unit_between(-Q16(1.5), Q16(1.5)),
                    unit_between(Q16(8.5), Q16(11.5))};
    made->tiny->instances[2].centre = (fxl_point){0, 0, -Q16(100)};
    return made;
}

/* bsp 3.3, 3.4a-b */
void test_pieces_share_every_vertex(void)
{
    static const fxl_clipper watching = {.clip = take_edges};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order, TINY_INSTANCES + 6, list, LIST, NULL, 0};
    uint32_t cut = 0;
    for (uint32_t round = 0; round < UNIT_REPEAT / 50; round++) {
        const fxl_pose pose = {
            {unit_between(-Q16(3), Q16(3)), unit_between(-Q16(3), Q16(3)), unit_between(0, Q16(2))},
            0,
            0,
            0};
        fxl_scene *scene = &make_scene()->tiny->scene;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(scene, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, scene, &lens, &memory));
        TEST_ASSERT_EQUAL(FXL_OK,
                          choice_take(&renderer, &choice_tree, workspace, sizeof workspace));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &watching, NULL, 0));
        fxl_bsp_workspace *tree = renderer.order_memory;
        tree->pieces = pieces;
        tree->pieces_size = sizeof pieces;
        edge_count = piece_count = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        TEST_ASSERT_TRUE(renderer.frame.display_list.used > 0 &&
                         renderer.frame.resume.instances == renderer.frame.visible_count);
        TEST_ASSERT_EQUAL_UINT32(0, tree->unsplit);
        TEST_ASSERT_TRUE(edge_count >= 4);
        TEST_ASSERT_EQUAL_UINT32(edge_count, way_round());
        cut += piece_count > 3;
    }
    TEST_ASSERT_TRUE(cut > UNIT_REPEAT / 200);
}

/* Numbers of items and of vertices are below FXL_ITEM_NONE, which stands for none. An object of
 * which one face is seen, and which no plane cuts, is one item of four vertices. */
void test_numbers_of_pieces_are_below_that_of_none(void)
{
#ifndef UNIT_ON_TARGET
    static fxl_bsp_vertex memory[FXL_ITEM_NONE + 1];
    fxl_bsp_item items[2];
    const fxl_scene *scene = &bsp_make()->tiny->scene;
    const fxl_instance instance = {.model = 0, .centre = {0, 0, Q16(20)}};
    const fxl_point eye = {0, 0, 0};
    for (uint32_t last = FXL_ITEM_NONE - 2; last <= FXL_ITEM_NONE; last++) {
        for (int which = 0; which < 4; which++) {
            const int of_items = which & 1, is_roomy = which >> 1; /* else the memory ends there */
            const fxl_bsp_parts parts = {.items = items,
                                         .vertices = memory + FXL_ITEM_NONE + 1,
                                         .movers = of_items ? last : 0};
            fxl_bsp_cutter cutter = {.scene = scene,
                                     .parts = &parts,
                                     .capacity = sizeof memory + (is_roomy ? sizeof items : 0),
                                     .vertex_count = of_items ? 0 : last - 3};
            TEST_ASSERT_EQUAL(last < FXL_ITEM_NONE, fxl_bsp_cut(&cutter, &instance, &eye, 0));
            TEST_ASSERT_EQUAL_UINT32(last < FXL_ITEM_NONE, cutter.item_count);
        }
    }
#endif
}

/* A cap in the plane of node 0, and a side below it that shares an edge. Node 1 cuts the side
 * alone, and the cap gets the intersection: if it has room for one vertex more. */
void test_a_neighbour_without_room_for_a_vertex_ends_the_cut(void)
{
    enum {
        MOST = FXL_FACE_VERTICES_MAX
    };
    fxl_point vertices[MOST + 2] = {{Q16(1), 0, -Q16(2)}, {-Q16(1), 0, -Q16(2)}};
    uint16_t indices[MOST + 4];
    for (int32_t k = 0; k < MOST; k++) {
        indices[k] = (uint16_t)k;
        if (k >= 2) { /* a parabola */
            const int32_t x = 2 * k - MOST - 1;
            vertices[k] = (fxl_point){x * Q16(1), 0, Q16(50) - x * x * Q16(0.0625)};
        }
    }
    vertices[MOST] = (fxl_point){-Q16(1), -Q16(2), -Q16(2)};
    vertices[MOST + 1] = (fxl_point){Q16(1), -Q16(2), -Q16(2)};
    fxl_bsp_node nodes[2] = {
        {.normal = {0, FXL_Q2_30_ONE, 0}, .front = FXL_BSP_NONE, .back = 1, .parent = FXL_BSP_NONE},
        {.normal = {FXL_Q2_30_ONE, 0, 0}, .front = FXL_BSP_NONE, .back = FXL_BSP_NONE}};
    const fxl_instance instance = {.model = 0};
    const fxl_point eye = {0, Q16(10), -Q16(10)};
    for (uint8_t count = MOST - 1; count <= MOST; count++) {
        const uint16_t side[4] = {0, 1, MOST, MOST + 1};
        memcpy(indices + count, side, sizeof side);
        const fxl_face faces[2] = {{.normal = {0, FXL_Q2_30_ONE, 0}, .count = count},
                                   {{0, 0, -FXL_Q2_30_ONE}, 4, 0, FXL_INDICES_AT(0, count)}};
        const fxl_model model = {.vertex_count = MOST + 2, .face_count = 2};
        const fxl_scene scene = {.vertices = vertices,
                                 .indices = indices,
                                 .faces = faces,
                                 .models = &model,
                                 .instances = &instance,
                                 .bsp_nodes = nodes};
        fxl_bsp_item items[4];
        fxl_bsp_vertex memory[64];
        const fxl_bsp_parts parts = {.items = items, .vertices = memory + 64};
        fxl_bsp_cutter cutter = {
            .scene = &scene, .parts = &parts, .capacity = sizeof items + sizeof memory};
        TEST_ASSERT_EQUAL(count < MOST, fxl_bsp_cut(&cutter, &instance, &eye, 0));
        TEST_ASSERT_EQUAL_UINT32(count < MOST ? 3 : 0, cutter.item_count);
        TEST_ASSERT_EQUAL_UINT32(MOST, count < MOST ? items[0].count : MOST);
    }
}
