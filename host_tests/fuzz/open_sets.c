/* SPDX-License-Identifier: MIT */
/* Surfaces, billboards and the horizon of a scene image, if it has some: opened in memory of their own
 * size, all their texels read, and some rows drawn with them. */
#include <string.h>

#include "answers.h"
#include "parts.h"
#include "fixel/horizon.h"
#include "fixel/surfaces.h"

enum {
    BILLBOARD_FACES = 4096, /* of a scene that is drawn with billboards */
    SURFACE_FACES = 512,    /* with surfaces */
    ROWS = 48
};

/* A row of a frame, without a display list. */
static void draw_row(const fxl_scene_image *opened, const fxl_billboard_set *set,
                     const fxl_pose *pose)
{
    const fxl_lens *lens = &opened->lens;
    const uint32_t entries = opened->scene.draw_list_needed;
    fxl_renderer *renderer = draw_memory(sizeof *renderer);
    uint8_t *pixels = draw_memory(lens->width);
    const fxl_memory memory = {
        draw_memory(entries * sizeof(fxl_draw_entry)), entries, NULL, 0, NULL, 0};
    const fxl_band band = draw_band(lens, pixels, lens->height / 2, 1);
    fxl_billboards billboards;
    DEMAND(fxl_renderer_init_with(renderer, &opened->scene, lens, &memory) == FXL_OK);
    DEMAND(fxl_attach_billboards(renderer, &billboards, set, FXL_SPRITES_OF(fxl_palette)) ==
           FXL_OK);
    fxl_fill_band(&band, DRAW_BACKGROUND);
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
    fxl_sprite *sprites = draw_memory(count * sizeof *sprites);
    fxl_billboard *boards = draw_memory(count * sizeof *boards);
    fxl_billboard_set set, untouched;
    fxl_scene_fault fault = {NULL, 0};
    volatile uint32_t sum = 0;
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
        if (draw_model_view(&opened->scene) <= BILLBOARD_FACES) {
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

/* The bytes of all levels; one after another they lie in the image. */
static uint32_t sum_texels(const fxl_texture *texture)
{
    const uint32_t least = texture->format == FXL_TEXTURE_4 ? 1 : 0;
    const uint32_t doubles = texture->format == FXL_TEXTURE_565 ? 1 : 0;
    const uint8_t *texel = texture->texels;
    uint32_t sum = 0;
    for (uint32_t i = 0; i < texture->levels; i++) {
        const uint32_t wide = texture->log_width > i + least ? texture->log_width - i : least;
        const uint32_t high = texture->log_height > i ? texture->log_height - i : 0;
        for (uint32_t k = 0; k < 1u << (wide + high + doubles) >> least; k++) {
            sum += *texel++;
        }
    }
    for (uint32_t i = 0; texture->colours != NULL && i < 16; i++) {
        sum += texture->colours[i];
    }
    return sum;
}

static const uint16_t palette[256] = {0xFFFF, 0x1234};

/* In frames of a palette, in RGB565, or in that with a depth buffer; in the image's light, if it has one. */
static void draw_rows(const fxl_scene_image *opened, const fxl_surface_set *set,
                      const fxl_pose *pose, const fxl_target *target, const fxl_painter *painter)
{
    const bool is_wide = target != &fxl_palette;
    const fxl_scene *scene = &opened->scene;
    fxl_draw_entry *order = draw_memory(scene->draw_list_needed * sizeof *order);
    fxl_renderer *renderer = draw_memory(sizeof *renderer);
    uint16_t *pixels = draw_memory((size_t)opened->lens.width * ROWS * sizeof *pixels);
    const fxl_memory memory = {.draw_list = order, .draw_list_capacity = scene->draw_list_needed};
    const uint16_t rows = opened->lens.height < ROWS ? opened->lens.height : ROWS;
    fxl_band band = draw_band(&opened->lens, pixels, (opened->lens.height - rows) / 2u, rows);
    fxl_surfaces surfaces;
    fxl_light light;
    fxl_lit_surfaces lit;
    fxl_config config = fxl_config_for(1, 1, target);
    config.palette = is_wide ? palette : NULL;
    config.depth_size = FXL_DEPTH_BYTES(opened->lens.width, rows, 16u);
    config.depth = draw_memory(config.depth_size);
    band.palette = is_wide ? palette : NULL;
    DEMAND(fxl_renderer_init_with(renderer, scene, &opened->lens, &memory) == FXL_OK);
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_OK);
    DEMAND(fxl_attach_surfaces(renderer, &surfaces, set, painter) == FXL_OK);
    if (opened->light.base != NULL) {
        fxl_light_settings settings;
        fxl_light_settings_of(&opened->light, &settings);
        DEMAND(fxl_attach_light(renderer, &light, &settings) == FXL_OK);
        DEMAND(fxl_attach_lit(renderer, &lit) == FXL_OK);
    }
    fxl_frame_fill(renderer, &band, 0);
    if (fxl_frame_begin(renderer, pose) == FXL_OK) {
        DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    }
    if (is_wide) {
        record_bytes(pixels, (size_t)opened->lens.width * rows * sizeof *pixels);
    } else {
        record_band(&band);
    }
    free(config.depth);
    free(pixels);
    free(renderer);
    free(order);
}

void open_surfaces(const fxl_scene_image *opened, const fxl_pose *pose)
{
    const uint32_t count = opened->surfaces.texture_count;
    fxl_texture *textures = draw_memory(count * sizeof *textures);
    fxl_surface_set set, untouched;
    fxl_scene_fault fault = {NULL, 0};
    volatile uint32_t sum = 0;
    memset(&set, 0x5A, sizeof set);
    memcpy(&untouched, &set, sizeof set);
    const fxl_status status = fxl_surfaces_open(opened, textures, count, &set, &fault);
    DEMAND((status == FXL_OK) == (fault.what == NULL));
    if (status == FXL_OK) {
        for (uint32_t i = 0; i < count; i++) {
            sum += sum_texels(&textures[i]);
        }
        record_number(sum);
        if (draw_model_view(&opened->scene) <= SURFACE_FACES) {
            if (fxl_surfaces_check(&set, &opened->scene, 8, NULL) == FXL_OK) {
                draw_rows(opened, &set, pose, &fxl_palette, FXL_SURFACES_OF(fxl_palette));
            }
            if (fxl_surfaces_check(&set, &opened->scene, 16, NULL) == FXL_OK) {
                draw_rows(opened, &set, pose, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565));
                draw_rows(opened, &set, pose, &fxl_rgb565_depth_16,
                          FXL_SURFACES_OF(fxl_rgb565_depth_16));
            }
        }
    } else {
        DEMAND(memcmp(&set, &untouched, sizeof set) == 0);
    }
    if (count > 0) {
        DEMAND(fxl_surfaces_open(opened, textures, count - 1, &set, NULL) != FXL_OK);
    }
    free(textures);
    (void)sum;
}

/* Rows that are filled together are those that are filled one by one. */
static void fill_rows(const fxl_renderer *renderer, const fxl_lens *lens, uint16_t rows)
{
    const size_t bytes = (size_t)lens->width * rows;
    uint8_t *together = draw_memory(bytes), *single = draw_memory(lens->width);
    const uint32_t first = (lens->height - rows) / 2u;
    const fxl_band band = draw_band(lens, together, first, rows);
    fxl_frame_fill(renderer, &band, 0);
    for (uint32_t i = 0; i < rows; i++) {
        const fxl_band one = draw_band(lens, single, first + i, 1);
        fxl_frame_fill(renderer, &one, 0);
        DEMAND(memcmp(single, together + i * lens->width, lens->width) == 0);
    }
    record_band(&band);
    free(single);
    free(together);
}

void open_horizon(const fxl_scene_image *opened, const fxl_pose *pose)
{
    const fxl_lens *lens = &opened->lens;
    const fxl_horizon *horizon = &opened->horizon;
    volatile uint32_t sum = 0;
    if (horizon->sines == NULL) {
        return;
    }
    for (uint32_t i = 0; i < horizon->count; i++) {
        sum += (uint32_t)horizon->sines[i] + horizon->colours[i];
    }
    record_number(sum + horizon->colours[horizon->count]);
    const fxl_status status = fxl_horizon_check(horizon);
    record_number(status);
    if (status == FXL_OK && draw_model_view(&opened->scene) <= BILLBOARD_FACES) {
        const uint32_t entries = opened->scene.draw_list_needed;
        fxl_renderer *renderer = draw_memory(sizeof *renderer);
        const fxl_memory memory = {
            draw_memory(entries * sizeof(fxl_draw_entry)), entries, NULL, 0, NULL, 0};
        DEMAND(fxl_renderer_init_with(renderer, &opened->scene, lens, &memory) == FXL_OK);
        DEMAND(fxl_attach_horizon(renderer, horizon) == FXL_OK);
        if (fxl_frame_begin(renderer, pose) == FXL_OK) {
            fill_rows(renderer, lens, lens->height < ROWS ? lens->height : ROWS);
        }
        free(memory.draw_list);
        free(renderer);
    }
}
