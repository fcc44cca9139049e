/* SPDX-License-Identifier: MIT */
#include "tiny_frames.h"

void tiny_start(fxl_renderer *renderer, tiny_scene *tiny, uint16_t width, uint16_t height,
                const fxl_memory *memory)
{
    const fxl_lens lens = unit_lens(width, height);
    fxl_scene_fault fault = {"", 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check(&tiny->scene, &fault), fault.what);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(renderer, &tiny->scene, &lens, memory));
}

void tiny_place_from(tiny_scene *tiny, fxl_placement placements[TINY_INSTANCES], uint32_t first)
{
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        placements[i] = (fxl_placement)FXL_PLACEMENT_NONE;
    }
    if (first < TINY_INSTANCES) {
        tiny->scene.placements = placements;
        tiny->scene.first_turned = first;
        tiny->scene.placement_code = &fxl_turned_instances;
    }
}

/* Turned so far to the side at the most, and 30 degrees up or down. */
static void turn_ahead(fxl_pose *pose, int32_t degrees)
{
    pose->yaw = DEGREES(1) * (fxl_angle)unit_between(-degrees, degrees);
    pose->pitch = DEGREES(1) * (fxl_angle)unit_between(-30, 30);
}

fxl_pose tiny_pose_between(void)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(3));
    pose.position.z += Q16(5) * unit_between(0, 2);
    return pose;
}

fxl_pose tiny_pose_about(void)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(3));
    pose.position.z += Q16(5) * unit_between(-1, 1);
    turn_ahead(&pose, 60);
    return pose;
}

fxl_pose tiny_pose_before(void)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(3));
    pose.position.z = unit_between(Q16(-6), Q16(4));
    turn_ahead(&pose, 40);
    return pose;
}

void board_scene_make(board_scene *scene)
{
    tiny_scene *tiny = tiny_make();
    tiny->models[1].kind = FXL_MODEL_CONVEX;
    tiny->models[1].face_count = 1;
    tiny->models[1].radius = Q16(9);
    tiny->scene.face_count = 7;
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    scene->tiny = tiny;
    tiny_board(&scene->set, &scene->board, scene->model_map, &scene->sprite, scene->texels,
               BOARD_SPRITE_WIDTH, BOARD_SPRITE_HEIGHT);
}

fxl_status board_scene_attach(board_scene *scene)
{
    return fxl_attach_billboards(&scene->renderer, &scene->billboards, &scene->set,
                                 FXL_SPRITES_OF(fxl_palette));
}

void board_scene_start(board_scene *scene, uint32_t words)
{
    const fxl_memory memory = {scene->order, TINY_INSTANCES, scene->list, words, NULL, 0};
    tiny_start(&scene->renderer, scene->tiny, BOARD_SCENE_WIDTH, BOARD_SCENE_HEIGHT, &memory);
    TEST_ASSERT_EQUAL(FXL_OK, board_scene_attach(scene));
}
