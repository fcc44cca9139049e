/* SPDX-License-Identifier: MIT */
/* matrix_entry and sine_cosine: compared with sines in long double, whose own error is below
 * 2^-30 of the unit. */
#include <math.h>
#include <stdlib.h>

#include "fixel/all.h"
#include "oracle/claim.h"

#define UNIT      1073741824.0L
#define TWO_PI    6.28318530717958647692528676655900577L
#define HALF_TURN UINT32_C(0x80000000)
#define QUARTER   UINT32_C(0x40000000)

/* Folded to an eighth of a turn in integers, so exact at quarter turns. */
static long double sine(uint32_t angle)
{
    if (angle > HALF_TURN) {
        return -sine(0u - angle);
    }
    if (angle > QUARTER) {
        angle = HALF_TURN - angle;
    }
    if (angle <= QUARTER / 2) {
        return sinl(TWO_PI * ldexpl(angle, -32));
    }
    return cosl(TWO_PI * ldexpl(QUARTER - angle, -32));
}

static long double cosine(uint32_t angle)
{
    return sine(angle + QUARTER);
}

/* Any angle, or one within a few units of a multiple of a sixteenth of a turn. */
static uint32_t any_angle(oracle_random *random)
{
    uint32_t any = (uint32_t)oracle_random_next(random);
    switch (oracle_below(random, 4)) {
    case 0:
        return any & 0xF0000000u;
    case 1:
        return (any & 0xF0000000u) + (uint32_t)oracle_signed_spread(random, 1, 1 << 24);
    default:
        return any;
    }
}

static int is_angle(int64_t number)
{
    return number >= 0 && number <= UINT32_MAX;
}

static void report(FILE *words, const char *name, int32_t got, long double exact)
{
    if (words) {
        fprintf(words, "%-10s library %11d, exact %19.6Lf, off by %9.6Lf\n", name, got, exact,
                got - exact);
    }
}

/* --- matrix_entry ------------------------------------------------------------ */

static void generate_matrix(oracle_random *random, uint64_t index, oracle_input *input)
{
    (void)index;
    for (int i = 0; i < 3; i++) {
        oracle_put(input, any_angle(random));
    }
}

static oracle_outcome judge_matrix(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    const int64_t *n = input->numbers;
    if (input->count != 3 || !is_angle(n[0]) || !is_angle(n[1]) || !is_angle(n[2])) {
        return ORACLE_UNUSABLE;
    }
    fxl_pose pose = {.yaw = (uint32_t)n[0], .pitch = (uint32_t)n[1], .roll = (uint32_t)n[2]};
    fxl_camera camera;
    if (fxl_camera_from_pose(&pose, &camera) != FXL_OK) {
        verdict->value = ORACLE_REFUSED;
        return ORACLE_COUNTED;
    }
    long double sy = sine(pose.yaw), cy = cosine(pose.yaw);
    long double sp = sine(pose.pitch), cp = cosine(pose.pitch);
    long double sr = sine(pose.roll), cr = cosine(pose.roll);
    const struct {
        const char *name;
        int32_t got;
        long double exact;
    } entries[9] = {
        {"right.x", camera.axes.right.x, cr * cy - sr * sp * sy},
        {"right.y", camera.axes.right.y, sr * cp},
        {"right.z", camera.axes.right.z, -cr * sy - sr * sp * cy},
        {"up.x", camera.axes.up.x, -sr * cy - cr * sp * sy},
        {"up.y", camera.axes.up.y, cr * cp},
        {"up.z", camera.axes.up.z, sr * sy - cr * sp * cy},
        {"forward.x", camera.axes.forward.x, cp * sy},
        {"forward.y", camera.axes.forward.y, sp},
        {"forward.z", camera.axes.forward.z, cp * cy},
    };
    for (int i = 0; i < 9; i++) {
        long double exact = entries[i].exact * UNIT;
        report(words, entries[i].name, entries[i].got, exact);
        verdict->value = fmax(verdict->value, (double)fabsl(entries[i].got - exact));
    }
    return ORACLE_COUNTED;
}

const oracle_claim oracle_matrix_entry = {
    .id = "matrix_entry",
    .unit = "2^-30",
    .numbers = "yaw pitch roll, binary angles",
    .kinds = {"any and special angles"},
    .generate = generate_matrix,
    .judge = judge_matrix,
};

/* --- sine_cosine ------------------------------------------------------------- */

/* A step that visits every angle once in 2^32 samples, evenly spread at all times. One sample in
 * eight is near a multiple of 2^27. */
static void generate_sine(oracle_random *random, uint64_t index, oracle_input *input)
{
    uint32_t first = (uint32_t)(random->state >> 32);
    oracle_random near = {random->state ^ index * UINT64_C(0x9E3779B97F4A7C15)};
    uint32_t angle = first + (uint32_t)index * UINT32_C(0x9E3779B1);
    input->kind = index % 8 == 0;
    if (input->kind) {
        angle = (oracle_below(&near, 32) << 27) + oracle_below(&near, 8192) - 4096;
    }
    oracle_put(input, angle);
}

static oracle_outcome judge_sine(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    if (input->count != 1 || !is_angle(input->numbers[0])) {
        return ORACLE_UNUSABLE;
    }
    uint32_t angle = (uint32_t)input->numbers[0];
    long double s = sine(angle) * UNIT, c = cosine(angle) * UNIT;
    int32_t got_s = fxl_sin(angle), got_c = fxl_cos(angle);
    report(words, "sine", got_s, s);
    report(words, "cosine", got_c, c);
    verdict->value = (double)fmaxl(fabsl(got_s - s), fabsl(got_c - c));
    return ORACLE_COUNTED;
}

const oracle_claim oracle_sine_cosine = {
    .id = "sine_cosine",
    .unit = "2^-30",
    .numbers = "a binary angle",
    .kinds = {"strided over the turn", "near multiples of 1/32 turn"},
    .generate = generate_sine,
    .judge = judge_sine,
};
