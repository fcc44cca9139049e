/* SPDX-License-Identifier: MIT */
/* The claims about orientations: compared with rotations in long double, whose own error is below
 * 2^-30 of the unit. */
#include <math.h>
#include <stdlib.h>

#include "oracle/claim.h"
#include "oracle/angle.h"
#include "unit/exact_placement.h"

static const char *const entry_names[9] = {"x.x", "x.y", "x.z", "y.x", "y.y",
                                           "y.z", "z.x", "z.y", "z.z"};

/* Counts the largest difference of an entry; a refusal where the status is another than FXL_OK. */
static oracle_outcome judge_turn(fxl_status status, const exact_placement *exact,
                                 const fxl_orientation *got, FILE *words, oracle_verdict *verdict)
{
    if (status != FXL_OK) {
        verdict->value = ORACLE_REFUSED;
        return ORACLE_COUNTED;
    }
    for (int i = 0; words && i < 9; i++) {
        oracle_report(words, entry_names[i], (&got->x.x)[i], exact->at[i / 3][i % 3] * EXACT_ONE);
    }
    verdict->value = (double)exact_distance(exact, got);
    return ORACLE_COUNTED;
}

/* --- orientation_angles ------------------------------------------------------ */

static void generate_angles(oracle_random *random, oracle_input *input)
{
    oracle_put_angles(random, 3, input);
}

static oracle_outcome judge_angles(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    const int64_t *n = input->numbers;
    fxl_orientation got;
    if (input->count != 3 || !oracle_are_angles(n, 3)) {
        return ORACLE_UNUSABLE;
    }
    const exact_placement exact = exact_angles((fxl_angle)n[0], (fxl_angle)n[1], (fxl_angle)n[2]);
    const fxl_status status =
        fxl_orientation_from_angles((fxl_angle)n[0], (fxl_angle)n[1], (fxl_angle)n[2], &got);
    return judge_turn(status, &exact, &got, words, verdict);
}

const oracle_claim oracle_orientation_angles = {
    .id = "orientation_angles",
    .unit = "2^-30",
    .numbers = "yaw pitch roll, binary angles",
    .kinds = {"any and special angles"},
    .generate = generate_angles,
    .judge = judge_angles,
};

/* --- orientation_axis -------------------------------------------------------- */

enum {
    VECTOR_MAX = (1 << 30) - 1
};

/* A coordinate of any size, or 0. */
static int64_t any_coordinate(oracle_random *random)
{
    return oracle_below(random, 8) == 0 ? 0 : (int64_t)oracle_signed_spread(random, 1, VECTOR_MAX);
}

static void put_vector(oracle_random *random, oracle_input *input)
{
    const int first = input->count;
    const int64_t *n = input->numbers + first;
    do {
        input->count = first;
        for (int i = 0; i < 3; i++) {
            oracle_put(input, any_coordinate(random));
        }
    } while (n[0] == 0 && n[1] == 0 && n[2] == 0);
}

static bool is_vector(const int64_t *n)
{
    return llabs(n[0]) <= VECTOR_MAX && llabs(n[1]) <= VECTOR_MAX && llabs(n[2]) <= VECTOR_MAX &&
           (n[0] != 0 || n[1] != 0 || n[2] != 0);
}

static fxl_point point_of(const int64_t *n)
{
    return (fxl_point){(int32_t)n[0], (int32_t)n[1], (int32_t)n[2]};
}

static void generate_axis(oracle_random *random, oracle_input *input)
{
    put_vector(random, input);
    oracle_put_angles(random, 1, input);
}

static oracle_outcome judge_axis(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    const int64_t *n = input->numbers;
    fxl_orientation got;
    if (input->count != 4 || !is_vector(n) || !oracle_are_angles(n + 3, 1)) {
        return ORACLE_UNUSABLE;
    }
    const fxl_point axis = point_of(n);
    const exact_placement exact = exact_axis(axis, (fxl_angle)n[3]);
    return judge_turn(fxl_orientation_from_axis(&axis, (fxl_angle)n[3], &got), &exact, &got, words,
                      verdict);
}

const oracle_claim oracle_orientation_axis = {
    .id = "orientation_axis",
    .unit = "2^-30",
    .numbers = "axis x y z, a binary angle",
    .kinds = {"axes of any length"},
    .generate = generate_axis,
    .judge = judge_axis,
};

/* --- orientation_look_at ----------------------------------------------------- */

static void generate_look(oracle_random *random, oracle_input *input)
{
    input->kind = (int)(input->index % 2);
    put_vector(random, input);
    const int64_t *from = input->numbers;
    if (input->kind == 0) {
        put_vector(random, input);
        return;
    }
    for (int i = 0; i < 3; i++) { /* a few units beside the direction, or opposite */
        const int64_t beside = from[i] + oracle_between(random, -3, 3);
        oracle_put(input, beside > VECTOR_MAX    ? VECTOR_MAX
                          : beside < -VECTOR_MAX ? -VECTOR_MAX
                                                 : beside);
    }
}

/* Whether two vectors are parallel, exactly: their products are below 2^60. */
static bool are_parallel(const int64_t *a, const int64_t *b)
{
    return a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2] && a[0] * b[1] == a[1] * b[0];
}

static oracle_outcome judge_look(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    const int64_t *n = input->numbers;
    fxl_orientation got;
    if (input->count != 6 || !oracle_are_words(n, 6)) {
        return ORACLE_UNUSABLE;
    }
    if (!is_vector(n) || !is_vector(n + 3) || are_parallel(n, n + 3)) {
        return ORACLE_SKIPPED;
    }
    const fxl_point direction = point_of(n), up = point_of(n + 3);
    const exact_placement exact = exact_look(direction, up);
    return judge_turn(fxl_orientation_look_at(&direction, &up, &got), &exact, &got, words, verdict);
}

const oracle_claim oracle_orientation_look_at = {
    .id = "orientation_look_at",
    .unit = "2^-30",
    .numbers = "direction x y z, up x y z",
    .kinds = {"any two vectors", "up a few units beside the direction"},
    .generate = generate_look,
    .judge = judge_look,
};

/* --- orientation_product ----------------------------------------------------- */

/* Orientations as the library makes them; of the second kind, each entry is off by up to 1 more. */
static void generate_product(oracle_random *random, oracle_input *input)
{
    input->kind = (int)(input->index % 2);
    for (int k = 0; k < 2; k++) {
        fxl_orientation made;
        (void)fxl_orientation_from_angles(oracle_any_angle(random), oracle_any_angle(random),
                                          oracle_any_angle(random), &made);
        for (int i = 0; i < 9; i++) {
            const int64_t off = input->kind ? oracle_between(random, -1, 1) : 0;
            oracle_put(input, (&made.x.x)[i] + off);
        }
    }
}

static bool orientation_of(const int64_t *n, fxl_placement *placement)
{
    const fxl_point centre = {0, 0, 0};
    for (int i = 0; i < 9; i++) {
        (&placement->orientation.x.x)[i] = (int32_t)n[i];
    }
    placement->scale = FXL_Q16_16_ONE;
    return fxl_placement_check(placement, &centre, 0) == FXL_OK;
}

static oracle_outcome judge_product(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    const int64_t *n = input->numbers;
    fxl_placement a, b;
    fxl_orientation got;
    if (input->count != 18 || !oracle_are_words(n, 18)) {
        return ORACLE_UNUSABLE;
    }
    if (!orientation_of(n, &a) || !orientation_of(n + 9, &b)) {
        return ORACLE_SKIPPED;
    }
    const exact_placement exact = exact_nearest_to_product(&a.orientation, &b.orientation);
    return judge_turn(fxl_orientation_multiply(&a.orientation, &b.orientation, &got), &exact, &got,
                      words, verdict);
}

const oracle_claim oracle_orientation_product = {
    .id = "orientation_product",
    .unit = "2^-30",
    .numbers = "nine entries of the second turn, nine of the first, row by row, 2.30",
    .kinds = {"orientations as they are made", "rows within the tolerance"},
    .generate = generate_product,
    .judge = judge_product,
};

/* --- orientation_quaternion and quaternion ------------------------------------ */

static const char *const number_names[4] = {"w", "x", "y", "z"};

/* Of any norm, with zeros and the ends of the range among the numbers. */
static void generate_quaternion(oracle_random *random, oracle_input *input)
{
    const int64_t *n = input->numbers;
    do {
        input->count = 0;
        for (int i = 0; i < 4; i++) {
            oracle_put(input,
                       oracle_below(random, 16) == 0 ? FXL_Q2_30_ONE : any_coordinate(random));
        }
    } while (n[0] == 0 && n[1] == 0 && n[2] == 0 && n[3] == 0);
}

static oracle_outcome judge_quaternion(const oracle_input *input, FILE *words,
                                       oracle_verdict *verdict)
{
    const int64_t *n = input->numbers;
    fxl_orientation got;
    if (input->count != 4 || !oracle_are_words(n, 4)) {
        return ORACLE_UNUSABLE;
    }
    const fxl_quaternion q = {(int32_t)n[0], (int32_t)n[1], (int32_t)n[2], (int32_t)n[3]};
    const exact_quaternion given = {{n[0], n[1], n[2], n[3]}};
    const exact_placement exact = exact_turn_of(&given);
    return judge_turn(fxl_orientation_from_quaternion(&q, &got), &exact, &got, words, verdict);
}

const oracle_claim oracle_orientation_quaternion = {
    .id = "orientation_quaternion",
    .unit = "2^-30",
    .numbers = "w x y z",
    .kinds = {"quaternions of any norm"},
    .generate = generate_quaternion,
    .judge = judge_quaternion,
};

/* Orientations as the library makes them of quaternions and of angles, half of them near half turns, where w is near 0;
 * of the second kind, each entry is off by up to 1 more. */
static void generate_rows(oracle_random *random, oracle_input *input)
{
    fxl_orientation made;
    input->kind = (int)(input->index % 2);
    if (oracle_below(random, 2)) {
        const int64_t near = (int64_t)oracle_signed_spread(random, 1, 1 << 20);
        const fxl_quaternion q = {(int32_t)near, (int32_t)any_coordinate(random),
                                  (int32_t)any_coordinate(random), FXL_Q2_30_ONE};
        (void)fxl_orientation_from_quaternion(&q, &made);
    } else {
        (void)fxl_orientation_from_angles(oracle_any_angle(random), oracle_any_angle(random),
                                          oracle_any_angle(random), &made);
    }
    for (int i = 0; i < 9; i++) {
        oracle_put(input, (&made.x.x)[i] + (input->kind ? oracle_between(random, -1, 1) : 0));
    }
}

static oracle_outcome judge_back(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    const fxl_orientation none = FXL_ORIENTATION_NONE;
    fxl_placement given;
    fxl_quaternion q;
    if (input->count != 9 || !oracle_are_words(input->numbers, 9)) {
        return ORACLE_UNUSABLE;
    }
    if (!orientation_of(input->numbers, &given)) {
        return ORACLE_SKIPPED;
    }
    if (fxl_orientation_to_quaternion(&given.orientation, &q) != FXL_OK || q.w < 0) {
        verdict->value = ORACLE_REFUSED;
        return ORACLE_COUNTED;
    }
    const exact_placement nearest = exact_nearest_to_product(&none, &given.orientation);
    const exact_quaternion got = {{q.w, q.x, q.y, q.z}},
                           wanted = exact_quaternion_of(&nearest, &got);
    const exact_placement turn = exact_turn_of(&wanted);
    for (int i = 0; i < 9; i++) { /* far from it, there is none */
        if (!(fabsl(turn.at[i / 3][i % 3] - nearest.at[i / 3][i % 3]) < 1e-12L)) {
            verdict->value = ORACLE_REFUSED;
        }
    }
    for (int i = 0; i < 4; i++) {
        const long double exact = wanted.at[i] * EXACT_ONE;
        if (words) {
            oracle_report(words, number_names[i], (int32_t)got.at[i], exact);
        }
        verdict->value = fmax(verdict->value, (double)fabsl(got.at[i] - exact));
    }
    return ORACLE_COUNTED;
}

const oracle_claim oracle_quaternion = {
    .id = "quaternion",
    .unit = "2^-30",
    .numbers = "nine entries of the orientation, row by row, 2.30",
    .kinds = {"orientations as they are made", "rows within the tolerance"},
    .generate = generate_rows,
    .judge = judge_back,
};

/* --- orientation_parents ----------------------------------------------------- */

enum {
    DEPTH = 8,
    LINK = 7, /* numbers of a place: centre, angles, scale */
    REACH = 20 * 65536
};

static void put_place(oracle_random *random, int64_t reach, double least, double most,
                      oracle_input *input)
{
    for (int i = 0; i < 3; i++) {
        oracle_put(input, oracle_between(random, -reach, reach));
    }
    oracle_put_angles(random, 3, input);
    oracle_put(input, oracle_below(random, 4) == 0
                          ? FXL_Q16_16_ONE
                          : (int64_t)oracle_spread(random, least * 65536, most * 65536));
}

static void generate_parents(oracle_random *random, oracle_input *input)
{
    const int depth = 1 + (int)(input->index % DEPTH);
    put_place(random, 50 * REACH, 0.5, 2, input);
    for (int i = 0; i < depth; i++) {
        put_place(random, REACH, 0.7, 1.4, input);
    }
}

static bool place_of(const int64_t *n, fxl_point *centre, fxl_placement *placement)
{
    if (!is_vector((int64_t[]){n[0] | 1, n[1], n[2]}) || !oracle_are_angles(n + 3, 3) ||
        n[6] < FXL_SCALE_MIN || n[6] > FXL_SCALE_MAX) {
        return false;
    }
    *centre = point_of(n);
    placement->scale = (fxl_q16_16)n[6];
    return fxl_orientation_from_angles((fxl_angle)n[3], (fxl_angle)n[4], (fxl_angle)n[5],
                                       &placement->orientation) == FXL_OK;
}

/* The share of its bound that an error takes. */
static long double share(long double error, long double bound)
{
    return fabsl(error) / bound;
}

static oracle_outcome judge_parents(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    const int64_t *n = input->numbers;
    const int depth = input->count / LINK - 1;
    fxl_point centre, local;
    fxl_placement placement, child;
    exact_bounds bounds = {0, 0, 0};
    if (input->count % LINK != 0 || depth < 1 || depth > DEPTH ||
        !place_of(n, &centre, &placement)) {
        return ORACLE_UNUSABLE;
    }
    exact_place exact = exact_place_of(&centre, &placement);
    for (int i = 1; i <= depth; i++) {
        if (!place_of(n + i * LINK, &local, &child)) {
            return ORACLE_UNUSABLE;
        }
        const exact_place step = exact_place_of(&local, &child);
        bounds = exact_bounds_of_child(&bounds, &exact, &step);
        exact = exact_attached(&exact, &step);
        if (fxl_placement_attach(&centre, &placement, &local, &child, &centre, &placement) !=
            FXL_OK) {
            verdict->value = ORACLE_REFUSED;
            return ORACLE_COUNTED;
        }
    }
    const long double shares[] = {
        share(exact.centre[0] - centre.x, bounds.centre),
        share(exact.centre[1] - centre.y, bounds.centre),
        share(exact.centre[2] - centre.z, bounds.centre),
        share(exact.scale * 65536 - placement.scale, bounds.scale),
        share(exact_distance(&exact.turn, &placement.orientation), bounds.turn)};
    static const char *const names[] = {"centre.x", "centre.y", "centre.z", "scale", "an entry"};
    for (int i = 0; i < 5; i++) {
        if (words) {
            fprintf(words, "%-10s %9.6Lf of its bound at depth %d\n", names[i], shares[i], depth);
        }
        verdict->value = fmax(verdict->value, (double)shares[i]);
    }
    return ORACLE_COUNTED;
}

const oracle_claim oracle_orientation_parents = {
    .id = "orientation_parents",
    .unit = "of its bound",
    .numbers = "of the first parent and of each child: centre x y z, yaw pitch roll, scale",
    .kinds = {"chains of one to eight parents"},
    .generate = generate_parents,
    .judge = judge_parents,
};
