/* SPDX-License-Identifier: MIT */
/* Billboards that are refused: wrong tables, and null pointers. */
#include "tiny_frames.h"

static board_scene scene;

void setUp(void)
{
    board_scene_make(&scene);
}

static void expect_refusal(fxl_status status, const char *what, uint32_t index)
{
    fxl_scene_fault fault = {"nothing", 99};
    TEST_ASSERT_EQUAL(status, fxl_billboards_check(&scene.set, &scene.tiny->scene, &fault));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
    TEST_ASSERT_EQUAL_UINT32(index, fault.index);
    const uint32_t refused = scene.renderer.workspace.counters.refused_calls;
    const fxl_order *was = scene.renderer.order;
    TEST_ASSERT_EQUAL(status, board_scene_attach(&scene));
    TEST_ASSERT_EQUAL_UINT32(refused + 1, scene.renderer.workspace.counters.refused_calls);
    TEST_ASSERT_EQUAL_PTR(was, scene.renderer.order);
    setUp();
}

/* combinations 1.1a-b, billboards 1.2f */
void test_a_wrong_billboard_is_refused(void)
{
    board_scene_start(&scene, 0);
    scene.sprite.width = scene.sprite.height = 1; /* the least */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_billboards_check(&scene.set, &scene.tiny->scene, NULL));
    setUp();
    const unit_field fields[] = {
        {UNIT_FIELD(scene.sprite.bits, 2), FXL_E_RANGE, "billboard", 0},
        {UNIT_FIELD(scene.sprite.width, 0), FXL_E_RANGE, "billboard", 0},
        {UNIT_FIELD(scene.sprite.height, 0), FXL_E_RANGE, "billboard", 0},
        {UNIT_FIELD(scene.sprite.pixels, 0), FXL_E_ARGUMENT, "billboard", 0},
        {UNIT_FIELD(scene.board.sprite, 0), FXL_E_ARGUMENT, "billboard", 0},
        {UNIT_FIELD(scene.board.width, 0), FXL_E_RANGE, "billboard", 0},
        {UNIT_FIELD(scene.board.height, FXL_BILLBOARD_SIDE_MAX + 1), FXL_E_RANGE, "billboard", 0},
        {UNIT_FIELD(scene.board.anchor_x, -1), FXL_E_RANGE, "billboard", 0},
        {UNIT_FIELD(scene.board.anchor_y, scene.board.height + 1), FXL_E_RANGE, "billboard", 0},
        {UNIT_FIELD(scene.set.billboards, 0), FXL_E_ARGUMENT, "billboard table", 0},
        {UNIT_FIELD(scene.set.model_map, 0), FXL_E_ARGUMENT, "billboard table", 0},
        {UNIT_FIELD(scene.set.count, 65536), FXL_E_COUNT, "billboard table", 0},
        {UNIT_FIELD(scene.model_map[1], 2), FXL_E_INDEX, "model", 1},
        {UNIT_FIELD(scene.model_map[0], 1), FXL_E_COUNT, "model", 0}, /* a cube */
        {UNIT_FIELD(scene.tiny->models[1].kind, FXL_MODEL_SORTED), FXL_E_COUNT, "model", 1},
        /* Of corners at (2, 1.5). */
        {UNIT_FIELD(scene.tiny->models[1].radius, Q16(2.5) - 1), FXL_E_RADIUS, "model", 1},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect_refusal);
    scene.tiny->models[1].radius = Q16(2.5);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_billboards_check(&scene.set, &scene.tiny->scene, NULL));
    scene.board.anchor_x -= 1;
    scene.tiny->models[1].radius = Q16(2.5);
    expect_refusal(FXL_E_RADIUS, "model", 1);
    scene.tiny->models[1].radius = FXL_RADIUS_MAX; /* the largest, and anchors in its corners */
    scene.board =
        (fxl_billboard){&scene.sprite, FXL_BILLBOARD_SIDE_MAX, 1, FXL_BILLBOARD_SIDE_MAX, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_billboards_check(&scene.set, &scene.tiny->scene, NULL));
    scene.board =
        (fxl_billboard){&scene.sprite, 1, FXL_BILLBOARD_SIDE_MAX, 0, FXL_BILLBOARD_SIDE_MAX};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_billboards_check(&scene.set, &scene.tiny->scene, NULL));
}

void test_tables_off_their_alignment_are_refused(void)
{
    board_scene_start(&scene, 0);
    scene.set.billboards =
        (const fxl_billboard *)(const void *)((const uint8_t *)scene.set.billboards + 2);
    expect_refusal(FXL_E_ALIGNMENT, "billboard table", 0);
    scene.set.model_map =
        (const uint16_t *)(const void *)((const uint8_t *)scene.set.model_map + 1);
    expect_refusal(FXL_E_ALIGNMENT, "billboard table", 0);
    scene.board.sprite = (const fxl_sprite *)(const void *)((const uint8_t *)&scene.sprite + 2);
    expect_refusal(FXL_E_ALIGNMENT, "billboard", 0);
}

void test_null_pointers_are_refused(void)
{
    board_scene_start(&scene, 0);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_billboards(NULL, &scene.billboards, &scene.set,
                                                            FXL_SPRITES_OF(fxl_palette)));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_billboards(&scene.renderer, NULL, &scene.set,
                                                            FXL_SPRITES_OF(fxl_palette)));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_billboards_check(NULL, &scene.tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_billboards_check(&scene.set, NULL, NULL));
    TEST_ASSERT_TRUE(scene.renderer.target == &fxl_palette &&
                     scene.renderer.order != &fxl_by_distance);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&scene.renderer, NULL, NULL, NULL));
    TEST_ASSERT_TRUE(scene.renderer.target == &fxl_palette &&
                     scene.renderer.order == &fxl_by_distance);
    memset(&scene.renderer, 0, sizeof scene.renderer);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, board_scene_attach(&scene));
}
