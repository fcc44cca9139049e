/* SPDX-License-Identifier: MIT */
/* Formulas of equations.smt2 beside the functions that they were written from, on inputs that a generator draws. */
#include "game/quaternion.c"

#include "enumeration.h"
#include "formula.h"

/* The way back is not run here. */
fxl_status fxl_orientation_multiply(const fxl_orientation *a, const fxl_orientation *b, fxl_orientation *product)
{
    (void)a, (void)b, (void)product;
    abort();
}

/* [[row]]
 * id = "over_norm beside its formula"
 * function = "over_norm"
 * property = "30 rounds and the rounding of the formula give the quotient, of a million parts and norms"
 * checks = 1000000
 * formula = "over_norm exact"
 * links = ["lib/math/arith.c"]
 */
void enumerate_norm(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const wide N = (wide)up_to(((uint64_t)1 << 62) - 1) + 1,
                   part = (wide)up_to((uint64_t)N);
        const int32_t found = over_norm((int64_t)part, (int64_t)N);
        wide D = part, q = 0, r = part, P = 0;
        for (int round = 0; round < 30; round++) {
            HOLDS(part, norm_state);
            const wide next_q = norm_next_q, next_r = norm_next_r;
            D *= 2, q = next_q, r = next_r, P = q * N;
        }
        HOLDS(part, norm_state && over_norm(-(int64_t)part, (int64_t)N) == -found);
        TRY(part, found == norm_rounded);
    }
}

/* [[row]]
 * id = "fxl_orientation_from_quaternion beside its formula"
 * function = "fxl_orientation_from_quaternion"
 * property = "the entries are the formula's parts over its norm, of a million quaternions"
 * checks = 1000000
 * formula = "fxl_orientation_from_quaternion parts"
 * links = ["lib/math/arith.c"]
 */
void enumerate_parts(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const wide w = between(FXL_Q2_30_ONE),
                   x = between(FXL_Q2_30_ONE);
        const wide y = between(FXL_Q2_30_ONE),
                   z = between(FXL_Q2_30_ONE);
        const fxl_quaternion q = {(int32_t)w, (int32_t)x, (int32_t)y, (int32_t)z};
        const int64_t norm = (int64_t)parts_norm;
        fxl_orientation made;
        if (fxl_orientation_from_quaternion(&q, &made) != FXL_OK) {
            TRY(w, norm == 0);
            continue;
        }
        TRY(w, parts_given && made.x.x == over_norm((int64_t)parts_diagonal, norm) &&
                   made.x.y == over_norm((int64_t)parts_less, norm) &&
                   made.y.x == over_norm((int64_t)parts_more, norm));
    }
}
