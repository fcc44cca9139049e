/* SPDX-License-Identifier: MIT */
#include "judge/dump.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>

#include "frames/input.h"

enum {
    HEAD_SIZE = 16 + 768,
    POSE_AT = 8, /* in a frame: after mark and number */
    PIXELS_AT = 8 + 24,
    COUNTERS_SIZE = 4 * 9 + 4 + 8, /* counters, steps clamped, instructions */
    TAIL_SIZE = 12
};

static uint8_t *frame_at(const judge_dump *dump, uint32_t frame)
{
    return dump->bytes + HEAD_SIZE + frame * dump->frame_size;
}

static size_t pixel_bytes(const judge_dump *dump)
{
    return (size_t)dump->width * (size_t)dump->height * (size_t)(dump->pixel_bits / 8);
}

static const char *check_dump(judge_dump *dump)
{
    const uint8_t *bytes = dump->bytes;
    if (dump->size < HEAD_SIZE || memcmp(bytes, "FXLD", 4) != 0) {
        return "it is not a frame dump (no FXLD at its start)";
    }
    if (ref_u16(bytes + 4) != 3) {
        return "this version of the frame dump is not known";
    }
    dump->width = ref_u16(bytes + 6);
    dump->height = ref_u16(bytes + 8);
    dump->pixel_bits = ref_u16(bytes + 10);
    dump->frame_count = ref_u32(bytes + 12);
    if (dump->pixel_bits != 8 && dump->pixel_bits != 16) {
        return "its pixels have neither 8 bits nor 16";
    }
    if (dump->width < 1 || dump->height < 1 || dump->frame_count < 1) {
        return "it holds no frame";
    }
    dump->frame_size = PIXELS_AT + pixel_bytes(dump) + COUNTERS_SIZE;
    size_t rest = dump->size - HEAD_SIZE;
    if (rest < TAIL_SIZE || (rest - TAIL_SIZE) / dump->frame_size != dump->frame_count ||
        (rest - TAIL_SIZE) % dump->frame_size != 0) {
        return "it is incomplete: its length is not that of the frames it announces";
    }
    const uint8_t *tail = bytes + dump->size - TAIL_SIZE;
    if (memcmp(tail, "FEND", 4) != 0 || ref_u32(tail + 4) != dump->frame_count) {
        return "it is incomplete: its tail is missing";
    }
    if (ref_crc32(0, bytes, dump->size - 4) != ref_u32(tail + 8)) {
        return "its checksum does not match";
    }
    for (uint32_t i = 0; i < dump->frame_count; i++) {
        const uint8_t *frame = frame_at(dump, i);
        if (memcmp(frame, "FRAM", 4) != 0 || ref_u32(frame + 4) != i) {
            return "its frames are not numbered from 0";
        }
    }
    return NULL;
}

const char *judge_dump_open(const char *path, judge_dump *dump)
{
    memset(dump, 0, sizeof *dump);
    dump->bytes = read_file(path, &dump->size);
    const char *wrong = dump->bytes ? check_dump(dump) : "it cannot be read";
    if (wrong) {
        judge_dump_close(dump);
    }
    return wrong;
}

void judge_dump_close(judge_dump *dump)
{
    free(dump->bytes);
    memset(dump, 0, sizeof *dump);
}

ref_pose judge_dump_pose(const judge_dump *dump, uint32_t frame)
{
    return ref_pose_read(frame_at(dump, frame) + POSE_AT);
}

uint16_t judge_dump_pixel(const judge_dump *dump, uint32_t frame, size_t number)
{
    const uint8_t *pixels = frame_at(dump, frame) + PIXELS_AT;
    return dump->pixel_bits == 8 ? pixels[number] : ref_u16(pixels + 2 * number);
}

const uint8_t *judge_dump_palette(const judge_dump *dump)
{
    return dump->bytes + 16;
}

static void put_u32(uint8_t *bytes, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(value >> 8 * i);
    }
}

bool judge_dump_like(const judge_dump *board, int pixel_bits, judge_dump *made)
{
    *made = *board;
    made->pixel_bits = pixel_bits;
    made->frame_size = PIXELS_AT + pixel_bytes(made) + COUNTERS_SIZE;
    made->size = HEAD_SIZE + made->frame_count * made->frame_size + TAIL_SIZE;
    made->bytes = calloc(made->size, 1);
    if (!made->bytes) {
        memset(made, 0, sizeof *made);
        return false;
    }
    memcpy(made->bytes, board->bytes, HEAD_SIZE);
    made->bytes[10] = (uint8_t)pixel_bits;
    for (uint32_t i = 0; i < made->frame_count; i++) {
        memcpy(frame_at(made, i), frame_at(board, i), PIXELS_AT);
    }
    memcpy(made->bytes + made->size - TAIL_SIZE, board->bytes + board->size - TAIL_SIZE, TAIL_SIZE);
    return true;
}

void judge_dump_put(judge_dump *dump, uint32_t frame, const uint16_t *pixels,
                    const ref_counters *counters)
{
    const size_t area = (size_t)dump->width * (size_t)dump->height;
    uint8_t *to = frame_at(dump, frame) + PIXELS_AT;
    for (size_t i = 0; i < area; i++) {
        *to++ = (uint8_t)pixels[i];
        if (dump->pixel_bits == 16) {
            *to++ = (uint8_t)(pixels[i] >> 8);
        }
    }
    memset(to, 0, COUNTERS_SIZE);
    const uint32_t values[] = {counters->in,         counters->backfacing, counters->outside,
                               counters->degenerate, counters->refused,    counters->drawn,
                               counters->clipped};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        put_u32(to + 4 * i, values[i]);
    }
}

bool judge_dump_save(judge_dump *dump, const char *path)
{
    uint8_t *sum = dump->bytes + dump->size - 4;
    put_u32(sum, ref_crc32(0, dump->bytes, dump->size - 4));
    return judge_save_file(path, dump->bytes, dump->size);
}

bool judge_save_file(const char *path, const void *bytes, size_t size)
{
    static const char suffix[] = ".part";
    char *temporary = malloc(strlen(path) + sizeof suffix);
    if (!temporary) {
        return false;
    }
    strcpy(temporary, path);
    strcat(temporary, suffix);
    FILE *file = fopen(temporary, "wb");
    bool saved = file && fwrite(bytes, 1, size, file) == size;
    saved = file && fclose(file) == 0 && saved;
    saved = saved && rename(temporary, path) == 0;
    if (!saved && file) {
        remove(temporary);
    }
    free(temporary);
    return saved;
}

static bool same_angles(const ref_pose *pose, ref_angle yaw, ref_angle pitch, ref_angle roll)
{
    return pose->yaw == yaw && pose->pitch == pitch && pose->roll == roll;
}

static const char *compare_poses(const ref_scene_image *image, const judge_dump *dump,
                                 uint32_t *frame)
{
    for (*frame = 0; *frame < dump->frame_count; ++*frame) {
        ref_pose pose = judge_dump_pose(dump, *frame);
        const ref_pose *stated = &image->poses[*frame];
        if (!same_angles(&pose, stated->yaw, stated->pitch, stated->roll) ||
            pose.position.x != stated->position.x || pose.position.y != stated->position.y ||
            pose.position.z != stated->position.z) {
            return "its pose is not the one that the scene states";
        }
    }
    return NULL;
}

static double error_units(double exact, int32_t units)
{
    return fabs(exact * REF_ONE - units);
}

static const char *compare_segments(const ref_scene_image *image, const judge_dump *dump,
                                    judge_walk *walk, uint32_t *frame)
{
    ref_player player = ref_player_at(&image->start);
    const ref_path_segment *segment = image->segments;
    uint32_t done = 0; /* frames of this segment */
    for (*frame = 0; *frame < dump->frame_count; ++*frame) {
        while (done == segment->frames) {
            segment++;
            done = 0;
        }
        double pushed = fmin(image->motion_limits.speed_max,
                             fabs(player.speed) + image->motion_limits.acceleration);
        ref_player_step(&player, segment->keys, &image->motion_limits);
        done++;
        walk->max_bound += 0.51 + pushed * REF_ONE * 0x1p-29;

        ref_pose pose = judge_dump_pose(dump, *frame);
        if (!same_angles(&pose, player.yaw, player.pitch, player.roll)) {
            return "its angles are not those that the scene's keys give";
        }
        double error = fmax(error_units(player.position.x, pose.position.x),
                            fmax(error_units(player.position.y, pose.position.y),
                                 error_units(player.position.z, pose.position.z)));
        walk->max_error = fmax(walk->max_error, error);
        walk->frames_beyond_bound += error > walk->max_bound;
    }
    return NULL;
}

const char *judge_walk_compare(const ref_scene_image *image, const judge_dump *dump,
                               judge_walk *walk, uint32_t *frame)
{
    *walk = (judge_walk){.frames = dump->frame_count};
    return image->poses ? compare_poses(image, dump, frame)
                        : compare_segments(image, dump, walk, frame);
}
