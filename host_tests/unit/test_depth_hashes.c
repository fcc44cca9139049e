/* SPDX-License-Identifier: MIT */
/* Frames by depth buffers are the same, bit for bit, on every core: hashes on record, as in
 * test_surface_hashes.c. */
#include "depth_scene.h"
#include "unit.h"

enum {
    FRAMES = 25 /* of each kind */
};

/* What a kind of frames has. */
enum {
    CODES_32 = 1,
    TEXTURE = 2,
    STIPPLE = 4,
    FAR = 8, /* a far plane at 2,000 units, and an eye that may be far away */
    EARLY = 16
};

static fxl_pose any_eye(uint32_t with)
{
    fxl_pose eye = depth_scene_eye;
    const fxl_point aside = unit_point(with & FAR ? Q16(40) : Q16(1));
    eye.position.x += aside.x;
    eye.position.y += aside.y / 2;
    eye.position.z -= with & FAR && aside.z < 0 ? -aside.z : aside.z / 2;
    eye.yaw += (uint32_t)unit_between(-(1 << 27), 1 << 27);
    eye.pitch += (uint32_t)unit_between(-(1 << 26), 1 << 26);
    eye.roll = unit_random();
    return eye;
}

static uint32_t hash_of(uint8_t division, uint32_t with)
{
    const fxl_target *target = with & CODES_32 ? &fxl_palette_depth_32 : &fxl_palette_depth_16;
    uint32_t hash = 0;
    (void)division; /* each frame has one of its own */
    for (uint32_t i = 0; i < FRAMES; i++) {
        depth_scene *made = depth_scene_make();
        if (with & FAR) {
            made->config.far_z = Q16(2000);
        } else if (with & EARLY) {
            made->config.near_z = unit_between(Q16(0.05), Q16(1));
        }
        made->texture.flags = (uint8_t)unit_between(0, 3);
        made->surface.opacity = (uint8_t)(with & STIPPLE ? unit_between(1, 15) : 16);
        made->surface.division = (uint8_t)(i % 4);
        if (with & TEXTURE) {
            made->face_map[i % DEPTH_SCENE_QUADS] = 1;
            made->is_mapped = true;
        }
        depth_scene_start_with(made, target);
        const fxl_pose eye = any_eye(with);
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_render(&made->renderer, &eye, made->frame, DEPTH_SCENE_WIDTH));
        hash = 31u * hash + unit_crc32(made->frame, sizeof made->frame);
    }
    return hash;
}

void test_pixels_are_those_on_record(void)
{
    static const unit_hash record[] = {
        {0, 0, 0x42F06E3C},
        {0, CODES_32, 0x2FD86CBD},
        {0, FAR, 0x90909417},
        {0, CODES_32 | FAR, 0x0A773FFB},
        {0, EARLY, 0x2188224F},
        {0, TEXTURE, 0x60C04359},
        {0, CODES_32 | TEXTURE | EARLY, 0x0A39EFB1},
        {0, TEXTURE | STIPPLE, 0xB5E0E5CB},
        {0, CODES_32 | TEXTURE | STIPPLE | FAR, 0xDCE4474C},
    };
    unit_expect_hashes(record, sizeof record / sizeof record[0], hash_of);
}
