/* SPDX-License-Identifier: MIT */
/* Frames with surfaces are the same, bit for bit, on every core and by every kernel: hashes on
 * record. The tests against the definitions in double allow what the rounding of textures allows;
 * this one allows nothing. Where a change of the library is to change pixels, those tests say
 * whether the new ones are right, and this one prints the new hashes. */
#include "quad_scene.h"

enum {
    FACES = 40, /* of each kind */
    LEVELS = 4,
    BLENDED = 4
};

static uint8_t texels[256 + 64 + 16 + 4 + 1 + 8], colours[16], ramp[256 * LEVELS],
    table[256 * BLENDED];
static fxl_light light;

void setUp(void)
{
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(i * 37 + i / 16);
    }
    for (uint32_t i = 0; i < sizeof colours; i++) {
        colours[i] = (uint8_t)(100 + i);
    }
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)(i + 29 * (i / 256));
    }
    for (uint32_t i = 0; i < sizeof table; i++) {
        table[i] = (uint8_t)(i * 11 + i / 256);
    }
}

/* A texture of a size, a number of levels and flags of its own. */
static void make_texture(quad_scene *quad, uint32_t number)
{
    const bool of_4_bits = number % 3 == 2;
    const uint8_t log_width = (uint8_t)unit_between(of_4_bits, 4),
                  log_height = (uint8_t)unit_between(0, 4);
    const uint8_t longer = log_width > log_height ? log_width : log_height;
    quad->texture = (fxl_texture){.texels = texels,
                                  .colours = of_4_bits ? colours : NULL,
                                  .log_width = log_width,
                                  .log_height = log_height,
                                  .format = of_4_bits ? FXL_TEXTURE_4 : FXL_TEXTURE_8,
                                  .flags = (uint8_t)unit_between(0, 3),
                                  .levels = (uint8_t)unit_between(1, longer + 1)};
    if (quad->texture.flags & FXL_TEXTURE_KEYED) {
        quad->texture.key = of_4_bits ? colours[3] : texels[2];
    }
    quad->set.texture_count = 1;
    quad->surface.texture = 1;
    for (int k = 0; k < 3; k++) { /* from a texel for many pixels to many texels a pixel */
        quad->mapped_corners[k].texel.u = quad->mapped_corners[k].texel.u >> number % 7;
        quad->mapped_corners[k].texel.v = quad->mapped_corners[k].texel.v >> number % 5;
    }
}

/* place light: hashes of frames */
static void make_light(quad_scene *quad)
{
    const fxl_point origin = {0, 0, 0};
    fxl_light_settings of = exact_light_any(ramp, &origin);
    of.levels = LEVELS;
    quad_light(quad, &light, &of);
}

/* What a kind of faces has. */
enum {
    TEXTURE = 1,
    LIGHT = 2,
    STIPPLE = 4,
    BLEND = 8,
    TURN = 16
};

static uint32_t hash_of(uint8_t division, uint32_t with)
{
    uint32_t hash = 0;
    for (uint32_t i = 0; i < FACES; i++) {
        quad_scene *quad = quad_make((with & TURN) != 0);
        quad->surface.division = division;
        quad->surface.flags = (uint8_t)((with & LIGHT ? FXL_SURFACE_LIT : 0) |
                                        (with & BLEND ? FXL_SURFACE_BLEND : 0));
        quad->surface.opacity = (uint8_t)(with & STIPPLE ? unit_between(1, 15) : 16);
        quad->set.blend = with & BLEND ? table : NULL;
        quad->set.blend_first = with & BLEND ? 100 : 0;
        quad->set.blend_count = with & BLEND ? BLENDED : 0;
        if (with & TEXTURE) {
            make_texture(quad, i);
        }
        quad_begin(quad);
        if (with & LIGHT) {
            make_light(quad);
        }
        quad_draw(quad);
        hash = 31u * hash + unit_crc32(quad->frame, sizeof quad->frame);
    }
    return hash;
}

void test_pixels_are_those_on_record(void)
{
    static const unit_hash record[] = {
        {FXL_DIVIDE_16, TEXTURE, 0xC7C992FC},
        {FXL_DIVIDE_8, TEXTURE, 0x8FB46C4C},
        {FXL_DIVIDE_1, TEXTURE, 0xA70718E4},
        {FXL_AFFINE, TEXTURE, 0xEFBFB1C3},
        {FXL_DIVIDE_16, LIGHT, 0x21669327},
        {FXL_DIVIDE_1, LIGHT, 0xFD7856B5},
        {FXL_AFFINE, LIGHT, 0xB0C3CD9D},
        {FXL_DIVIDE_16, TEXTURE | LIGHT, 0xE6BEFFB5},
        {FXL_DIVIDE_8, TEXTURE | LIGHT | TURN, 0xE2751D8D},
        {FXL_DIVIDE_1, TEXTURE | LIGHT, 0x320FE7E5},
        {FXL_AFFINE, TEXTURE | LIGHT, 0x4A646C16},
        {FXL_DIVIDE_16, TEXTURE | STIPPLE, 0x1CC3538A},
        {FXL_DIVIDE_8, TEXTURE | LIGHT | BLEND, 0xF3E9090B},
        {FXL_DIVIDE_16, STIPPLE | BLEND, 0x3B45E975},
    };
    unit_expect_hashes(record, sizeof record / sizeof record[0], hash_of);
}
