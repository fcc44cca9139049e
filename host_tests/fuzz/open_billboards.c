/* SPDX-License-Identifier: MIT */
/* Billboards of a scene image: what fxl_billboards_open takes must be drawable. */
#include <string.h>

#include "demand.h"
#include "draw.h"
#include "record.h"

enum {
    FACES = 4096,
    BACKGROUND = 0x11
};

/* A row of a frame, without a display list. */
static void draw_row(const fxl_scene_image *opened, const fxl_billboard_set *set,
                     const fxl_pose *pose)
{
    const fxl_lens *lens = &opened->lens;
    const uint32_t entries = opened->scene.draw_list_needed;
    fxl_renderer *renderer = malloc(sizeof *renderer);
    uint8_t *pixels = malloc(lens->width);
    const fxl_memory memory = {malloc(entries * sizeof(fxl_draw_entry)), entries, NULL, 0, NULL, 0};
    const fxl_band band = {.pixels = pixels,
                           .width = lens->width,
                           .stride = lens->width,
                           .first_row = (uint16_t)(lens->height / 2),
                           .rows = 1};
    fxl_billboards billboards;
    DEMAND(renderer != NULL && pixels != NULL && memory.draw_list != NULL);
    DEMAND(fxl_renderer_init_with(renderer, &opened->scene, lens, &memory) == FXL_OK);
    DEMAND(fxl_attach_billboards(renderer, &billboards, set, FXL_SPRITES_OF(fxl_palette)) ==
           FXL_OK);
    fxl_fill_band(&band, BACKGROUND);
    if (fxl_frame_begin(renderer, pose) == FXL_OK) {
        DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    }
    record_band(&band);
    free(memory.draw_list);
    free(pixels);
    free(renderer);
}

/* All bytes of its sprites are in the image, where the sanitizers watch. */
static uint32_t sum_sprites(const fxl_sprite *sprites, uint32_t count)
{
    uint32_t sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        const fxl_sprite *sprite = &sprites[i];
        const size_t bytes = ((size_t)sprite->width * sprite->bits + 7) / 8 * sprite->height;
        for (size_t k = 0; k < bytes && bytes < 1u << 16; k++) {
            sum += sprite->pixels[k];
        }
        for (uint32_t k = 0; sprite->colours != NULL && k < 1u << sprite->bits; k++) {
            sum += sprite->colours[k];
        }
    }
    return sum;
}

void open_billboards(const fxl_scene_image *opened, const fxl_pose *pose)
{
    const uint32_t count = opened->billboards.count;
    fxl_sprite *sprites = malloc(count * sizeof *sprites + 1);
    fxl_billboard *boards = malloc(count * sizeof *boards + 1);
    fxl_billboard_set set, untouched;
    fxl_scene_fault fault = {NULL, 0};
    volatile uint32_t sum = 0;
    DEMAND(sprites != NULL && boards != NULL);
    memset(&set, 0x5A, sizeof set);
    memcpy(&untouched, &set, sizeof set);
    const fxl_status status = fxl_billboards_open(opened, sprites, boards, count, &set, &fault);
    DEMAND((status == FXL_OK) == (fault.what == NULL));
    DEMAND((status == FXL_E_ARGUMENT) == (opened->billboards.model_map == NULL));
    DEMAND(fxl_billboards_open(NULL, sprites, boards, count, &set, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_billboards_open(opened, NULL, boards, count, &set, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_billboards_open(opened, sprites, NULL, count, &set, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_billboards_open(opened, sprites, boards, count, NULL, NULL) == FXL_E_ARGUMENT);
    if (status == FXL_OK) {
        sum = sum_sprites(sprites, count);
        record_number(sum);
        if (draw_model_view(&opened->scene) <= FACES) {
            draw_row(opened, &set, pose);
        }
    } else {
        DEMAND(memcmp(&set, &untouched, sizeof set) == 0);
    }
    if (count > 0) {
        DEMAND(fxl_billboards_open(opened, sprites, boards, count - 1, &set, NULL) ==
               FXL_E_CAPACITY);
    }
    free(boards);
    free(sprites);
    (void)sum;
}
