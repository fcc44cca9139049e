/* SPDX-License-Identifier: MIT */
#include "game/player.c"

#include "proof.h"

/* [[row]]
 * function = "key_sign"
 * property = "1 for the plus key alone, -1 for the minus key alone, else 0: any keys"
 * checks = 2
 */
void prove_key_sign(void)
{
    const uint32_t keys = nondet_u32(), plus = nondet_u32(), minus = nondet_u32();
    const bool up = (keys & plus) != 0, down = (keys & minus) != 0;
    ASSERT("as the keys say", key_sign(keys, plus, minus) == (up == down ? 0 : up ? 1 : -1));
    PROOF_ENDS();
}

/* [[row]]
 * function = "turned"
 * property = "any angle and turn: by the turn in the sense of the sign, modulo a turn"
 * checks = 3
 */
void prove_turned(void)
{
    const uint32_t angle = nondet_u32(), turn = nondet_u32();
    ASSERT("forward", turned(angle, 1, turn) - turn == angle);
    ASSERT("back", turned(angle, -1, turn) + turn == angle);
    ASSERT("not at all", turned(angle, 0, turn) == angle);
    PROOF_ENDS();
}

/* [[row]]
 * function = "held_within"
 * property = "any value and limit: the nearest value within it, and held exactly where that is another"
 * checks = 13
 */
void prove_held_within(void)
{
    const int64_t value = nondet_s64();
    const fxl_q16_16 limit = nondet_s32();
    const bool before = nondet_bool();
    bool held = before;
    ASSUME(limit >= 0);
    const fxl_q16_16 found = held_within(value, limit, &held);
    ASSERT("the nearest", found == (value > limit ? limit : value < -(int64_t)limit ? -limit : value));
    ASSERT("told, and never taken back", held == (before || found != value));
    PROOF_ENDS();
}

/* [[row]]
 * function = "slow_down"
 * property = "any speed and friction of their ranges: nearer to 0 by the friction, and not beyond it"
 * checks = 7
 */
void prove_slow_down(void)
{
    const fxl_q16_16 speed = nondet_s32(), friction = nondet_s32();
    ASSUME(WITHIN(speed, FXL_MOTION_MAX) && friction >= 0 && friction <= FXL_MOTION_MAX);
    const int64_t size = speed < 0 ? -speed : speed, left = size > friction ? size - friction : 0;
    ASSERT("by the friction", slow_down(speed, friction) == (speed < 0 ? -left : left));
    PROOF_ENDS();
}
