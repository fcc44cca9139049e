/* SPDX-License-Identifier: MIT */
#include "board_scene.h"

#include "tiny_frames.h"

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
