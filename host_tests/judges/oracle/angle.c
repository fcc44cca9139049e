/* SPDX-License-Identifier: MIT */
/* matrix_entry and sine_cosine: compared with sines in long double, whose own error is below
 * 2^-30 of the unit. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/stages.h"
#include "fixel/all.h"
#include "oracle/claim.h"
#include "oracle/angle.h"

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

uint32_t oracle_any_angle(oracle_random *random)
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

bool oracle_are_angles(const int64_t *numbers, int count)
{
    while (count > 0 && numbers[count - 1] >= 0 && numbers[count - 1] <= UINT32_MAX) {
        count--;
    }
    return count == 0;
}

bool oracle_are_words(const int64_t *numbers, int count)
{
    while (count > 0 && numbers[count - 1] >= INT32_MIN && numbers[count - 1] <= INT32_MAX) {
        count--;
    }
    return count == 0;
}

void oracle_put_angles(oracle_random *random, int count, oracle_input *input)
{
    for (int i = 0; i < count; i++) {
        oracle_put(input, oracle_any_angle(random));
    }
}

void oracle_report(FILE *words, const char *name, int32_t got, long double exact)
{
    if (words) {
        fprintf(words, "%-10s library %11d, exact %19.6Lf, off by %9.6Lf\n", name, got, exact,
                got - exact);
    }
}

/* --- matrix_entry ------------------------------------------------------------ */

static void generate_matrix(oracle_random *random, oracle_input *input)
{
    oracle_put_angles(random, 3, input);
}

static const char *const entry_names[9] = {"right.x", "right.y",   "right.z",   "up.x",     "up.y",
                                           "up.z",    "forward.x", "forward.y", "forward.z"};

/* The exact rows of a camera: right, up, forward. */
static void exact_rows(const int64_t angles[3], long double rows[9])
{
    const uint32_t yaw = (uint32_t)angles[0], pitch = (uint32_t)angles[1],
                   roll = (uint32_t)angles[2];
    const long double sy = sine(yaw), cy = cosine(yaw), sp = sine(pitch), cp = cosine(pitch);
    const long double sr = sine(roll), cr = cosine(roll);
    const long double exact[9] = {cr * cy - sr * sp * sy,
                                  sr * cp,
                                  -cr * sy - sr * sp * cy,
                                  -sr * cy - cr * sp * sy,
                                  cr * cp,
                                  sr * sy - cr * sp * cy,
                                  cp * sy,
                                  sp,
                                  cp * cy};
    memcpy(rows, exact, sizeof exact);
}

static bool camera_of(const int64_t angles[3], fxl_camera *camera)
{
    const fxl_pose pose = {
        .yaw = (uint32_t)angles[0], .pitch = (uint32_t)angles[1], .roll = (uint32_t)angles[2]};
    return fxl_camera_from_pose(&pose, camera) == FXL_OK;
}

/* Compares nine entries with their exact values, in units of 2^-30. */
static void judge_entries(const fxl_axes *axes, const long double exact[9], FILE *words,
                          oracle_verdict *verdict)
{
    const int32_t *got = &axes->right.x;
    for (int i = 0; i < 9; i++) {
        const long double in_units = exact[i] * UNIT;
        oracle_report(words, entry_names[i], got[i], in_units);
        verdict->value = fmax(verdict->value, (double)fabsl(got[i] - in_units));
    }
}

static oracle_outcome judge_matrix(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    const int64_t *n = input->numbers;
    if (input->count != 3 || !oracle_are_angles(n, 3)) {
        return ORACLE_UNUSABLE;
    }
    fxl_camera camera;
    long double exact[9];
    if (!camera_of(n, &camera)) {
        verdict->value = ORACLE_REFUSED;
        return ORACLE_COUNTED;
    }
    exact_rows(n, exact);
    judge_entries(&camera.axes, exact, words, verdict);
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

/* --- matrix_entry_instance --------------------------------------------------- */

static void generate_instance(oracle_random *random, oracle_input *input)
{
    oracle_put_angles(random, 6, input);
    oracle_put(input, oracle_below(random, 4) == 0
                          ? FXL_Q16_16_ONE
                          : (int64_t)oracle_spread(random, FXL_SCALE_MIN, FXL_SCALE_MAX));
}

/* An instance that is turned as a camera of the angles is: its orientation is the transpose of that
 * camera's rows, each entry rounded to the nearest. The exact product is that of both exact
 * rotations and the scale, as the library keeps it: divided by 2^shift. */
static oracle_outcome judge_instance(const oracle_input *input, FILE *words,
                                     oracle_verdict *verdict)
{
    const int64_t *n = input->numbers;
    if (input->count != 7 || !oracle_are_angles(n, 6) || n[6] < FXL_SCALE_MIN ||
        n[6] > FXL_SCALE_MAX) {
        return ORACLE_UNUSABLE;
    }
    fxl_placement placement = {.scale = (int32_t)n[6]};
    fxl_camera camera;
    fxl_axes matrix;
    const fxl_point centre = {0, 0, 0};
    long double view[9], object[9], exact[9] = {0};
    exact_rows(n, view);
    exact_rows(n + 3, object);
    for (int i = 0; i < 9; i++) {
        (&placement.orientation.x.x)[i] = (int32_t)floorl(object[i % 3 * 3 + i / 3] * UNIT + 0.5L);
    }
    if (!camera_of(n, &camera) || fxl_placement_check(&placement, &centre, 0) != FXL_OK) {
        verdict->value = ORACLE_REFUSED;
        return ORACLE_COUNTED;
    }
    const unsigned shift = fxl_placement_matrix(&placement, &camera.axes, &matrix);
    for (int i = 0; i < 27; i++) { /* view times the transpose of the object's rows */
        exact[i / 3] += view[i / 9 * 3 + i % 3] * object[i / 3 % 3 * 3 + i % 3] *
                        ldexpl(placement.scale, -16 - (int)shift);
    }
    judge_entries(&matrix, exact, words, verdict);
    return ORACLE_COUNTED;
}

const oracle_claim oracle_matrix_entry_instance = {
    .id = "matrix_entry_instance",
    .unit = "2^-30",
    .numbers = "yaw pitch roll of the camera, of the instance, binary angles; scale, 16.16",
    .kinds = {"any and special angles"},
    .generate = generate_instance,
    .judge = judge_instance,
};

/* place claim: a claim in the file of its stage: how a sample is drawn and judged */
/* --- sine_cosine ------------------------------------------------------------- */

/* A step that visits every angle once in 2^32 samples, evenly spread at all times. One sample in
 * eight is near a multiple of 2^27. */
static void generate_sine(oracle_random *random, oracle_input *input)
{
    uint32_t first = (uint32_t)(random->state >> 32);
    oracle_random near = {random->state ^ input->index * UINT64_C(0x9E3779B97F4A7C15)};
    uint32_t angle = first + (uint32_t)input->index * UINT32_C(0x9E3779B1);
    input->kind = input->index % 8 == 0;
    if (input->kind) {
        angle = (oracle_below(&near, 32) << 27) + oracle_below(&near, 8192) - 4096;
    }
    oracle_put(input, angle);
}

static oracle_outcome judge_sine(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    if (input->count != 1 || !oracle_are_angles(input->numbers, 1)) {
        return ORACLE_UNUSABLE;
    }
    uint32_t angle = (uint32_t)input->numbers[0];
    long double s = sine(angle) * UNIT, c = cosine(angle) * UNIT;
    int32_t got_s = fxl_sin(angle), got_c = fxl_cos(angle);
    oracle_report(words, "sine", got_s, s);
    oracle_report(words, "cosine", got_c, c);
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
