/* SPDX-License-Identifier: MIT */
/* Frames of 16 bits a pixel are the same, bit for bit, on every core: hashes on record, as in
 * test_surface_hashes.c. */
#include "rgb565_scene.h"

enum {
    ROUNDS = 12, /* of each kind */
    LEVELS = 9
};

static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)];

/* What a kind of frames has. */
enum {
    LIT = 1,
    BLEND = 2,
    ADD = 4,
    STIPPLE = 8,
    INDICES = 16,
    KEY = 32
};

static void make_wall(uint8_t division, uint32_t with)
{
    walls_make();
    walls_make_texture(with & INDICES ? FXL_TEXTURE_8 : FXL_TEXTURE_565);
    walls.texture.flags = (uint8_t)(unit_between(0, 1) | (with & KEY ? FXL_TEXTURE_KEYED : 0));
    if (with & KEY) {
        walls.texture.key = with & INDICES ? walls.texels[7] : 0;
        walls.texture.key_565 = with & INDICES ? 0 : walls.texels_565[7];
    }
    for (int k = 0; k < 3; k++) {
        walls.mapped_corners[0][k].texel.u += unit_between(-Q16(30), Q16(30));
        walls.mapped_corners[0][k].texel.v += unit_between(-Q16(30), Q16(30));
    }
    walls.surface[0].division = division;
    walls.surface[0].opacity = (uint8_t)(with & STIPPLE ? unit_between(1, 15) : 16);
    walls.surface[0].flags = with & LIT ? FXL_SURFACE_LIT : 0;
    walls.surface[1].flags = (uint8_t)(with & BLEND ? FXL_SURFACE_BLEND
                                       : with & ADD ? FXL_SURFACE_ADD
                                                    : 0);
    walls.face_map[1] = 2;
    walls.mapped_corners[0][1].normal = 1;
}

static uint32_t hash_of(uint8_t division, uint32_t with)
{
    uint32_t hash = 0;
    for (uint32_t i = 0; i < ROUNDS; i++) {
        const fxl_light_settings settings = {
            .ambient = FXL_Q2_30_ONE / 8,
            .point_count = 1,
            .ramp = ramp,
            .levels = LEVELS,
            .points = {{{unit_between(-Q16(3), Q16(3)), Q16(1), Q16(4)}, Q16(7), FXL_Q2_30_ONE}}};
        make_wall(division, with);
        walls_begin();
        if (with & LIT) {
            walls_light(&settings);
        }
        walls_draw(walls.pixels);
        for (uint32_t p = 0; p < WIDTH * HEIGHT; p++) { /* in one order of bytes */
            const uint8_t bytes[2] = {(uint8_t)walls.pixels[p], (uint8_t)(walls.pixels[p] >> 8)};
            hash = 31u * hash + 257u * bytes[1] + bytes[0];
        }
    }
    return hash;
}

void test_pixels_are_those_on_record(void)
{
    static const unit_hash record[] = {
        {FXL_DIVIDE_16, 0, 0x2DC2A35C},
        {FXL_DIVIDE_8, ADD, 0x6EABC728},
        {FXL_DIVIDE_1, BLEND, 0xB864ED7E},
        {FXL_AFFINE, LIT, 0x4BFC3E6C},
        {FXL_DIVIDE_16, LIT | ADD, 0xD2F77E96},
        {FXL_DIVIDE_16, STIPPLE | BLEND, 0x0EF53314},
        {FXL_DIVIDE_8, LIT | STIPPLE, 0x48AA5070},
        {FXL_DIVIDE_16, INDICES, 0x4730298B},
        {FXL_DIVIDE_1, INDICES | LIT, 0x511408A8},
        {FXL_DIVIDE_16, INDICES | KEY, 0x97000324},
        {FXL_DIVIDE_8, KEY, 0x5B9A2B5A},
        {FXL_DIVIDE_16, KEY | LIT, 0x54D4FF37},
    };
    unit_expect_hashes(record, sizeof record / sizeof record[0], hash_of);
}
