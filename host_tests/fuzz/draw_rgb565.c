/* SPDX-License-Identifier: MIT */
/* A scene with surfaces in frames of 16 bits a pixel: whole, in bands and in another workspace; and the same with a
 * depth buffer. */
#include <string.h>

#include "answers.h"
#include "fixel/crc.h"
#include "parts.h"

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
    fxl_corner *corners;
    fxl_surface_set set;
} set_565;

static uint16_t *block(size_t count)
{
    uint16_t *made = draw_memory(2 * count);
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

/* Surfaces without a texture have colours at their corners: the lower bits of their texture
 * coordinates. */
static void make_colours(set_565 *made, const fxl_surface_set *from)
{
    const size_t bytes = from->corner_count * sizeof *made->corners;
    made->corners = draw_memory(bytes);
    memcpy(made->corners, from->corners, bytes);
    made->set.corners = made->corners;
    for (uint32_t i = 0; i < SURFACES; i++) {
        if (made->surfaces[i].texture == 0) {
            made->surfaces[i].flags = (uint8_t)(made->surfaces[i].flags | FXL_SURFACE_COLOURS);
        }
    }
    for (uint32_t i = 0; i < from->face_count; i++) {
        const fxl_mapped_face *face = &from->faces[i];
        /* The check looks at the records that faces have alone. */
        const bool has_colours =
            face->surface < SURFACES && made->surfaces[face->surface].flags & FXL_SURFACE_COLOURS;
        for (int k = 0; has_colours && k < 3; k++) {
            const uint32_t at = made->surfaces[face->surface].first_corner + face->corners[k];
            if (at < from->corner_count) {
                made->corners[at].texel.u &= 0xFFFFFF;
                made->corners[at].texel.v = 0;
            }
        }
    }
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
        if (made->surfaces[i].flags & FXL_SURFACE_BLEND) {
            made->surfaces[i].sixteenths = made->surfaces[i].opacity;
        }
    }
    make_colours(made, from);
}

/* What is refused leaves the renderer as it is. */
static void misuse(fxl_renderer *renderer, const set_565 *made, const uint16_t *palette)
{
    const fxl_painter *painter = FXL_SURFACES_OF(fxl_rgb565);
    const fxl_scene *scene = renderer->scene;
    uint16_t *pixels = block(1);
    fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_band band = draw_band(&renderer->frame.view.lens, pixels, 0, 1);
    fxl_texture texture = made->textures[0];
    fxl_surface surface = made->surfaces[0];
    fxl_surface_set set = made->set;
    band.stride = 0;
    band.palette = palette;
    DEMAND(fxl_attach_surfaces(renderer, NULL, &set, painter) == FXL_E_ARGUMENT);
    DEMAND(fxl_render(NULL, &pose, pixels, 1) == FXL_E_ARGUMENT);
    DEMAND(fxl_render(renderer, NULL, pixels, band.width) == FXL_E_ARGUMENT);
    DEMAND(fxl_render(renderer, &pose, pixels, 0) == FXL_E_RANGE);
    renderer->frame.display_list.capacity = 0;
    DEMAND(fxl_frame_begin(renderer, &pose) == FXL_OK);
    DEMAND(fxl_frame_draw(renderer, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_E_RANGE);
    band.stride = band.width;
    band.pixels += 1;
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_E_ALIGNMENT);
    band.palette = NULL;
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_E_ORDER);
    pose.position.x = INT32_MAX;
    DEMAND(fxl_render(renderer, &pose, pixels, UINT16_MAX / 2) == FXL_E_RANGE);
    set.textures = &texture;
    set.texture_count = 1;
    texture.texels = texture.texels != NULL ? texture.texels + 1 : NULL;
    DEMAND((fxl_surfaces_check(&set, scene, 16, NULL) == FXL_E_ALIGNMENT) ==
           (texture.format == FXL_TEXTURE_565));
    set = made->set;
    set.surfaces = &surface;
    surface.flags = FXL_SURFACE_ADD | FXL_SURFACE_BLEND;
    DEMAND(fxl_surfaces_check(&set, scene, 16, NULL) != FXL_OK);
    surface.flags = FXL_SURFACE_BLEND;
    surface.sixteenths = 17;
    DEMAND(fxl_surfaces_check(&set, scene, 16, NULL) != FXL_OK);
    free(pixels);
}

static void fill(const fxl_band *band, uint16_t colour)
{
    uint16_t *row = (uint16_t *)(void *)band->pixels;
    for (uint32_t y = 0; y < band->rows; y++, row += band->stride) {
        for (uint32_t x = 0; x < band->width; x++) {
            row[x] = colour;
        }
    }
}

/* Bands of so many rows, by another workspace if there is one, in rows with guards between them. */
static void draw_guarded(fxl_renderer *renderer, fxl_workspace *workspace, uint16_t *pixels,
                         uint32_t step)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    const uint16_t stride = (uint16_t)(lens->width + 1);
    for (uint32_t row = 0, rows; row < lens->height; row += rows) {
        rows = step < lens->height - row ? step : lens->height - row;
        uint16_t *first = pixels + (size_t)row * stride;
        fxl_band band = draw_band(lens, first, row, rows);
        band.stride = stride;
        band.palette = renderer->palette;
        fill(&band, 0x1234);
        DEMAND((workspace != NULL ? fxl_frame_draw_with(renderer, workspace, &band)
                                  : fxl_frame_draw(renderer, &band)) == FXL_OK);
        for (uint32_t i = 0; i < rows; i++) {
            DEMAND(first[i * stride + lens->width] == GUARD);
        }
        uint32_t crc = FXL_CRC_START;
        DEMAND(fxl_band_crc(&crc, &band) == FXL_OK);
        DEMAND(fxl_band_crc(NULL, &band) == FXL_E_ARGUMENT);
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
    void *list = draw_memory(4 * (size_t)words), *memory = draw_memory(least);
    fxl_band frame = draw_band(lens, whole, 0, lens->height);
    frame.stride = (uint16_t)(lens->width + 1);
    frame.palette = renderer->palette;
    renderer->frame.display_list.capacity = 0;
    DEMAND(fxl_frame_begin(renderer, &pose) == FXL_OK);
    draw_guarded(renderer, NULL, whole, lens->height);
    renderer->frame.display_list.words = list;
    renderer->frame.display_list.capacity = words;
    DEMAND(fxl_frame_begin(renderer, &pose) == FXL_OK);
    draw_guarded(renderer, NULL, bands, 1 + fuzz_below(in, lens->height));
    DEMAND(memcmp(whole, bands, 2 * count) == 0);
    DEMAND(fxl_workspace_init(&workspace, renderer, memory, least) == FXL_OK);
    draw_guarded(renderer, &workspace, other, 1 + fuzz_below(in, lens->height));
    DEMAND(memcmp(whole, other, 2 * count) == 0);
    fxl_swap_rgb565(&frame);
    fxl_swap_rgb565(&frame);
    DEMAND(memcmp(whole, bands, 2 * count) == 0);
    draw_all_picks(renderer, NULL);
    DEMAND(fxl_render(renderer, &pose, bands, frame.stride) == FXL_OK);
    record_bytes(whole, 2 * count);
    record_bytes(bands, 2 * count);
    record_bytes(&renderer->workspace.counters, sizeof renderer->workspace.counters);
    free(whole);
    free(bands);
    free(other);
    free(list);
    free(memory);
}

/* Chooses the target, after calls that are refused. */
static void choose(fxl_renderer *renderer, const uint16_t *palette)
{
    fxl_config config = fxl_config_for(1, 1, &fxl_rgb565);
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ARGUMENT);
    config.palette = (const uint16_t *)(const void *)((const uint8_t *)palette + 1);
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ALIGNMENT);
    config.palette = palette;
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_OK);
}

/* The same frames with a depth buffer. */
static void draw_twice_by_depth(fxl_renderer *renderer, draw_parts *parts,
                                const fxl_surface_set *set, bool is_lit, const uint16_t *palette,
                                fuzz_input *in)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    fxl_config config = fxl_config_for(1, 1, &fxl_rgb565_depth_16);
    config.palette = palette;
    config.depth_size = FXL_DEPTH_BYTES(lens->width, lens->height, 16u);
    config.depth = draw_memory(config.depth_size);
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_OK);
    draw_attach(renderer, parts, set, FXL_SURFACES_OF(fxl_rgb565_depth_16), is_lit);
    draw_twice(renderer, in);
    draw_detach(renderer);
    free(config.depth);
}

void draw_rgb565(fxl_renderer *renderer, draw_parts *parts, const fxl_surface_set *from,
                 fuzz_input *in)
{
    set_565 made;
    uint16_t *palette = block(256);
    make_set(&made, from, in);
    choose(renderer, palette);
    parts->light.settings.dark = (uint16_t)fuzz_bits(in, 2);
    const bool is_lit = fuzz_below(in, 4) != 0;
    draw_attach(renderer, parts, &made.set, FXL_SURFACES_OF(fxl_rgb565), is_lit);
    misuse(renderer, &made, palette);
    fuzz_input same = *in;
    draw_twice(renderer, in);
    draw_detach(renderer);
    draw_twice_by_depth(renderer, parts, &made.set, is_lit, palette, &same);
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    draw_lines(renderer->scene, &renderer->frame.view.lens, &pose, &made.set, in);
    for (uint32_t i = 0; i < TEXTURES; i++) {
        free(made.texels[i]);
    }
    free(made.corners);
    free(palette);
}
