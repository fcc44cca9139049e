/* SPDX-License-Identifier: MIT */
/* A scene with surfaces in frames of 16 bits a pixel: whole, in bands and in another workspace. */
#include <string.h>

#include "demand.h"
#include "draw.h"
#include "fixel/rgb565.h"
#include "record.h"

enum {
    TEXTURES = 3,
    SURFACES = 4,
    GUARD = 0xA5A5
};

/* The set with textures and surfaces that only such frames have. */
typedef struct {
    fxl_texture textures[TEXTURES];
    fxl_surface surfaces[SURFACES];
    uint16_t *texels[TEXTURES];
    fxl_surface_set set;
} set_565;

static uint16_t *block(size_t count)
{
    uint16_t *made = malloc(2 * (count > 0 ? count : 1));
    DEMAND(made != NULL);
    for (size_t i = 0; i < count; i++) {
        made[i] = (uint16_t)(i * 40503u);
    }
    return made;
}

static size_t texel_count(const fxl_texture *texture)
{
    size_t texels = 0;
    for (uint32_t i = 0; i < texture->levels; i++) {
        const uint32_t wide = texture->log_width > i ? texture->log_width - i : 0;
        const uint32_t high = texture->log_height > i ? texture->log_height - i : 0;
        texels += (size_t)1 << (wide + high);
    }
    return texels;
}

static void make_set(set_565 *made, const fxl_surface_set *from, fuzz_input *in)
{
    DEMAND(from->texture_count == TEXTURES && from->surface_count == SURFACES);
    memcpy(made->textures, from->textures, sizeof made->textures);
    memcpy(made->surfaces, from->surfaces, sizeof made->surfaces);
    made->set = *from;
    made->set.textures = made->textures;
    made->set.surfaces = made->surfaces;
    for (uint32_t i = 0; i < TEXTURES; i++) {
        fxl_texture *texture = &made->textures[i];
        made->texels[i] = block(texel_count(texture));
        if (fuzz_below(in, 4)) {
            texture->format = FXL_TEXTURE_565;
            texture->texels = (const uint8_t *)(const void *)made->texels[i];
            texture->colours = NULL;
            texture->key = 0;
            texture->key_565 = made->texels[i][0];
        }
    }
    for (uint32_t i = 0; i < SURFACES; i++) {
        if (fuzz_below(in, 2)) {
            made->surfaces[i].flags =
                (uint8_t)((made->surfaces[i].flags & FXL_SURFACE_LIT) | FXL_SURFACE_ADD);
        }
    }
}

/* What is refused leaves the renderer as it is. */
static void misuse(fxl_renderer *renderer, fxl_surfaces *surfaces, const set_565 *made)
{
    static fxl_renderer none;
    static fxl_rgb565_frame frame;
    const fxl_scene *scene = renderer->scene;
    uint16_t *pixels = block(1);
    fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_band_565 band = {.pixels = pixels, .width = 1, .stride = 1, .first_row = 0, .rows = 1};
    fxl_texture texture = made->textures[0];
    fxl_surface surface = made->surfaces[0];
    fxl_surface_set set = made->set;
    DEMAND(fxl_renderer_set_rgb565(NULL, &frame, pixels, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_set_rgb565(renderer, NULL, pixels, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_set_rgb565(renderer, &frame, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_set_rgb565(&none, &frame, pixels, 0) == FXL_E_ORDER);
    DEMAND(fxl_renderer_set_surfaces_rgb565(NULL, surfaces, &set) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_set_surfaces_rgb565(&none, surfaces, &set) == FXL_E_ORDER);
    DEMAND(fxl_renderer_set_surfaces_rgb565(renderer, NULL, &set) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_draw_rgb565_with(renderer, NULL, &band) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_draw_rgb565(renderer, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_draw_rgb565(&none, &band) == FXL_E_ORDER);
    DEMAND(fxl_render_rgb565(NULL, &pose, pixels, 1) == FXL_E_ARGUMENT);
    DEMAND(fxl_render_rgb565(renderer, NULL, pixels, 1) == FXL_E_ARGUMENT);
    DEMAND(fxl_render_rgb565(renderer, &pose, pixels, 0) == FXL_E_RANGE);
    pose.position.x = INT32_MAX;
    DEMAND(fxl_render_rgb565(renderer, &pose, pixels, UINT16_MAX / 2) == FXL_E_RANGE);
    band.stride = UINT16_MAX;
    DEMAND(fxl_frame_draw_rgb565(renderer, &band) == FXL_E_RANGE);
    band.pixels = (uint16_t *)(uintptr_t)((uintptr_t)pixels + 1);
    DEMAND(fxl_frame_draw_rgb565(renderer, &band) == FXL_E_ALIGNMENT);
    set.textures = &texture;
    set.texture_count = 1;
    texture.texels = texture.texels != NULL ? texture.texels + 1 : NULL;
    DEMAND((fxl_surfaces_check_rgb565(&set, scene, NULL) == FXL_E_ALIGNMENT) ==
           (texture.format == FXL_TEXTURE_565));
    set = made->set;
    set.surfaces = &surface;
    surface.flags = FXL_SURFACE_ADD | FXL_SURFACE_BLEND;
    DEMAND(fxl_surfaces_check_rgb565(&set, scene, NULL) != FXL_OK);
    free(pixels);
}

/* Bands of so many rows, by another workspace if there is one, in rows with guards between them. */
static void draw_bands(fxl_renderer *renderer, fxl_workspace *workspace, uint16_t *pixels,
                       uint32_t step)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    const uint16_t stride = (uint16_t)(lens->width + 1);
    for (uint32_t row = 0, rows; row < lens->height; row += rows) {
        rows = step < lens->height - row ? step : lens->height - row;
        const fxl_band_565 band = {.pixels = pixels + (size_t)row * stride, .width = lens->width,
                                   .stride = stride, .first_row = (uint16_t)row,
                                   .rows = (uint16_t)rows};
        fxl_fill_rgb565(&band, 0x1234);
        DEMAND((workspace != NULL ? fxl_frame_draw_rgb565_with(renderer, workspace, &band)
                                  : fxl_frame_draw_rgb565(renderer, &band)) == FXL_OK);
        for (uint32_t i = 0; i < rows; i++) {
            DEMAND(band.pixels[i * stride + lens->width] == GUARD);
        }
    }
}

static uint16_t *guarded(size_t count)
{
    uint16_t *made = block(count);
    for (size_t i = 0; i < count; i++) {
        made[i] = GUARD;
    }
    return made;
}

static void draw_twice(fxl_renderer *renderer, fuzz_input *in)
{
    static fxl_workspace workspace;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const fxl_pose pose = fuzz_pose(in);
    const size_t count = (size_t)(lens->width + 1) * lens->height;
    const uint32_t words = fuzz_below(in, 2) ? 4096 : fuzz_below(in, 200);
    const size_t least = fxl_workspace_size(renderer);
    uint16_t *whole = guarded(count), *bands = guarded(count), *other = guarded(count);
    uint16_t *list = block(2 * (size_t)words), *memory = block(least / 2 + 4);
    fxl_band_565 frame = {.pixels = whole, .width = lens->width,
                          .stride = (uint16_t)(lens->width + 1), .first_row = 0,
                          .rows = lens->height};
    renderer->frame.display_list.capacity = 0;
    DEMAND(fxl_frame_begin(renderer, &pose) == FXL_OK);
    draw_bands(renderer, NULL, whole, lens->height);
    renderer->frame.display_list.words = (uint32_t *)(void *)list;
    renderer->frame.display_list.capacity = words;
    DEMAND(fxl_frame_begin(renderer, &pose) == FXL_OK);
    draw_bands(renderer, NULL, bands, 1 + fuzz_below(in, lens->height));
    DEMAND(memcmp(whole, bands, 2 * count) == 0);
    DEMAND(fxl_workspace_init(&workspace, renderer, memory, least) == FXL_OK);
    draw_bands(renderer, &workspace, other, 1 + fuzz_below(in, lens->height));
    DEMAND(memcmp(whole, other, 2 * count) == 0);
    fxl_swap_rgb565(&frame);
    fxl_swap_rgb565(&frame);
    DEMAND(memcmp(whole, bands, 2 * count) == 0);
    DEMAND(fxl_render_rgb565(renderer, &pose, bands, frame.stride) == FXL_OK);
    record_bytes(whole, 2 * count);
    record_bytes(bands, 2 * count);
    record_bytes(&renderer->workspace.counters, sizeof renderer->workspace.counters);
    free(whole);
    free(bands);
    free(other);
    free(list);
    free(memory);
}

void draw_rgb565(fxl_renderer *renderer, const fxl_surface_set *from, const fxl_light *light,
                 fuzz_input *in)
{
    static fxl_rgb565_frame frame;
    fxl_surfaces surfaces;
    set_565 made;
    uint16_t *palette = block(256);
    make_set(&made, from, in);
    DEMAND(fxl_renderer_set_surfaces_rgb565(renderer, &surfaces, &made.set) == FXL_E_ORDER);
    DEMAND(fxl_renderer_set_rgb565(renderer, &frame, palette, (uint16_t)fuzz_bits(in, 2)) ==
           FXL_OK);
    DEMAND(fxl_renderer_set_surfaces_rgb565(renderer, &surfaces, &made.set) == FXL_OK);
    misuse(renderer, &surfaces, &made);
    if (fuzz_below(in, 4)) {
        DEMAND(fxl_renderer_light_surfaces(renderer, light) == FXL_OK);
    }
    draw_twice(renderer, in);
    DEMAND(fxl_renderer_set_surfaces(renderer, NULL, NULL) == FXL_OK);
    for (uint32_t i = 0; i < TEXTURES; i++) {
        free(made.texels[i]);
    }
    free(palette);
}
