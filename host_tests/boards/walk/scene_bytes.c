/* SPDX-License-Identifier: MIT */
#include "scene_bytes.h"

#include <string.h>

#define HEADER   92u
#define ENTRY    12u /* of the table of sections */
#define SECTIONS 7u
#define UNIT     65536

/* Kinds of sections. The path is poses or segments. */
enum {
    PALETTE = 1,
    VERTICES,
    INDICES,
    FACES,
    MODELS,
    INSTANCES,
    POSES,
    SEGMENTS
};

static uint8_t *bytes(scene_bytes *scene)
{
    return (uint8_t *)scene->words;
}

static void put16(scene_bytes *scene, uint32_t at, uint32_t value)
{
    bytes(scene)[at] = (uint8_t)value;
    bytes(scene)[at + 1] = (uint8_t)(value >> 8);
}

static void put32(scene_bytes *scene, uint32_t at, uint32_t value)
{
    put16(scene, at, value);
    put16(scene, at + 2, value >> 16);
}

static void put_point(scene_bytes *scene, uint32_t at, int32_t x, int32_t y, int32_t z)
{
    put32(scene, at, (uint32_t)x);
    put32(scene, at + 4, (uint32_t)y);
    put32(scene, at + 8, (uint32_t)z);
}

/* A section at the end of what is there, and its entry. Requires the kinds in turn. */
static uint32_t add_table(scene_bytes *scene, uint32_t kind, uint32_t count, uint32_t entry)
{
    const uint32_t at = scene->size;
    const uint32_t number = kind == SEGMENTS ? POSES - 1u : kind - 1u;

    put32(scene, HEADER + ENTRY * number, kind | 1u << 16); /* it is needed */
    put32(scene, HEADER + ENTRY * number + 4, at);
    put32(scene, HEADER + ENTRY * number + 8, count);
    scene->size += (count * entry + 3u) & ~3u;
    return at;
}

static uint32_t crc32(const uint8_t *data, uint32_t size)
{
    uint32_t crc = ~0u;
    uint32_t i, bit;

    for (i = 0; i < size; i++) {
        crc ^= data[i];
        for (bit = 0; bit < 8; bit++) {
            crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
        }
    }
    return ~crc;
}

static void put_pose(scene_bytes *scene, uint32_t at, const fxl_pose *pose)
{
    put_point(scene, at, pose->position.x, pose->position.y, pose->position.z);
    put32(scene, at + 12, pose->yaw);
    put32(scene, at + 16, pose->pitch);
    put32(scene, at + 20, pose->roll);
}

/* One model: a square of 2 by 2 units that faces -z. */
static void put_model(scene_bytes *scene)
{
    static const int32_t corners[4][2] = {
        {-UNIT, UNIT}, {UNIT, UNIT}, {UNIT, -UNIT}, {-UNIT, -UNIT}};
    uint32_t at, i;

    at = add_table(scene, PALETTE, 256, 3);
    for (i = 0; i < 768; i++) {
        bytes(scene)[at + i] = (uint8_t)i;
    }
    at = add_table(scene, VERTICES, 4, 12);
    for (i = 0; i < 4; i++) {
        put_point(scene, at + 12 * i, corners[i][0], corners[i][1], 0);
    }
    at = add_table(scene, INDICES, 4, 2);
    for (i = 0; i < 4; i++) {
        put16(scene, at + 2 * i, i);
    }
    at = add_table(scene, FACES, 1, 20);
    put_point(scene, at, 0, 0, -FXL_Q2_30_ONE);
    bytes(scene)[at + 12] = 4;
    bytes(scene)[at + 13] = SCENE_COLOUR; /* its first index is 0, and the number of that too */
    at = add_table(scene, MODELS, 1, 28);
    put32(scene, at + 4, 4);
    put32(scene, at + 12, 1);
    put32(scene, at + 20, 2 * UNIT);
}

static void put_path(scene_bytes *scene, const fxl_pose *poses, const fxl_path_segment *strides,
                     uint32_t count)
{
    uint32_t frames = count;
    uint32_t at, i;

    if (poses != NULL) {
        at = add_table(scene, POSES, count, 24);
        for (i = 0; i < count; i++) {
            put_pose(scene, at + 24 * i, &poses[i]);
        }
    } else {
        frames = 0;
        at = add_table(scene, SEGMENTS, count, 4);
        for (i = 0; i < count; i++) {
            put16(scene, at + 4 * i, strides[i].keys);
            put16(scene, at + 4 * i + 2, strides[i].frames);
            frames += strides[i].frames;
        }
    }
    put32(scene, 80, frames);
}

void scene_bytes_make(scene_bytes *scene, uint32_t instances, const fxl_pose *poses,
                      const fxl_path_segment *strides, uint32_t count)
{
    uint32_t at, i;

    memset(scene, 0, sizeof *scene);
    scene->size = HEADER + ENTRY * SECTIONS;
    memcpy(scene->words, "FXLS", 4);
    put16(scene, 4, 9);
    put16(scene, 6, SECTIONS);
    put16(scene, 16, SCENE_WIDTH);
    put16(scene, 18, SCENE_HEIGHT);
    put32(scene, 20, FXL_ANGLE_QUARTER);
    put_point(scene, 24, UNIT / 4, 100 * UNIT, 4);
    bytes(scene)[36] = SCENE_BACKGROUND;
    put_point(scene, 40, 0, 0, UNIT / 2);
    put_point(scene, 64, UNIT / 4, UNIT / 16, UNIT);
    put32(scene, 76, FXL_ANGLE_QUARTER / 16);
    put_model(scene);
    at = add_table(scene, INSTANCES, instances, 16);
    for (i = 0; i < instances; i++) {
        put_point(scene, at + 16 * i, 0, 0, (4 + (int32_t)i) * UNIT);
    }
    put_path(scene, poses, strides, count);
    put32(scene, 8, scene->size);
    put32(scene, 12, crc32(bytes(scene) + 16, scene->size - 16));
}
