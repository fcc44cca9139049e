/* SPDX-License-Identifier: MIT */
#include "scene/image_check.c"
#include "scene_tables.h"

#define MOTIONS 3
#define KEYS    4

static fxl_motion motions[MOTIONS];
static fxl_motion_key keys[KEYS];
static fxl_motion_set set;

/* What fxl_motion_check leaves of the motions before the one that it looks at. */
static bool is_plain(uint32_t number)
{
    return motions[number].parent <= number && motions[number].repeats <= 1;
}

static bool has_extents(const fxl_motion *motion)
{
    const int64_t limit = ((int64_t)1 << 30) - 1;
    return motion->extent.x >= 0 && motion->extent.y >= 0 && motion->extent.z >= 0 && motion->radius >= 0 &&
           (int64_t)motion->extent.x + motion->radius <= limit && motion->extent.y <= limit && (int64_t)motion->extent.z + motion->radius <= limit &&
           motion->scale_low >= FXL_SCALE_MIN && motion->scale_low <= FXL_SCALE_MAX && motion->scale_high >= FXL_SCALE_MIN &&
           motion->scale_high <= FXL_SCALE_MAX;
}

static void any_set(void)
{
    ANY_CONTENT(motions);
    ANY_CONTENT(keys);
    ANY_CONTENT(&set);
    set.motions = motions;
    set.keys = keys;
    ASSUME(set.motion_count <= MOTIONS && set.key_count <= KEYS);
}

static uint32_t any_number(void)
{
    const uint32_t number = nondet_u32();
    ASSUME(number < set.motion_count);
    return number;
}

/* [[row]]
 * function = "extents_in_range"
 * property = "any motion: nothing overflows, and one that passes is below 2^30; up to 3 motions and 4 keys"
 * checks = 225
 * unwind = 11
 */
void prove_extents_in_range(void)
{
    any_set();
    ASSERT("below 2^30", !extents_in_range(&motions[0]) || has_extents(&motions[0]));
    ASSERT("its parent before it", !motion_is_plain(&motions[1], 1) || is_plain(1));
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_keys"
 * property = "any keys of a motion: nothing is out of bounds, and those that pass rise from frame 0 on; up to 3 motions and 4 keys"
 * checks = 178
 * unwind = 11
 */
void prove_check_keys(void)
{
    any_set();
    const uint32_t number = any_number(), i = nondet_u32();
    const fxl_motion *motion = &motions[number];
    ASSUME(motion->first_key <= set.key_count && motion->key_count >= 1 && motion->key_count <= set.key_count - motion->first_key);
    ASSUME(i < motion->key_count);
    const fxl_status status = check_keys(&set, motion, &fault);
    ASSERT("in turn, from frame 0 on", status != FXL_OK || i == 0 || keys[motion->first_key + i].frame > keys[motion->first_key + i - 1].frame);
    PROOF_ENDS();
}

/* [[row]]
 * function = "chain_of"
 * property = "any parents that stand before their children: at most nine, the farthest first; up to 3 motions and 4 keys"
 * checks = 76
 * unwind = 11
 */
void prove_chain_of(void)
{
    const fxl_motion *chain[FXL_MOTION_DEPTH_MAX + 1];
    any_set();
    const uint32_t number = any_number();
    for (uint32_t i = 0; i < MOTIONS; i++) {
        ASSUME(i > number || is_plain(i));
    }
    const uint32_t count = chain_of(&set, &motions[number], chain);
    ASSERT("itself last", count == 0 || (count <= FXL_MOTION_DEPTH_MAX + 1 && chain[count - 1] == &motions[number]));
    ASSERT("the farthest parent first", count == 0 || chain[0]->parent == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "reach_of"
 * property = "any scale and length in range: nothing overflows"
 * checks = 4
 * unwind = 11
 * stands_in = { fxl_multiply_s64 = "any_product" }
 */
void prove_reach_of(void)
{
    const fxl_q16_16 scale = nondet_s32();
    const int64_t length = nondet_s64();
    ASSUME(scale >= 0 && scale <= FXL_SCALE_MAX && length >= 0 && length < (int64_t)1 << 31);
    const int64_t reach = reach_of(scale, length);
    ASSERT("at most 2^40", reach >= 0 && reach <= (int64_t)1 << 40);
    PROOF_ENDS();
}

/* For fxl_multiply_s64: any product of factors of at most 2^24 and 2^31, which is at most 2^55. It grows with its factors. */
static int64_t last_a, last_b, last_product;
int64_t any_product(int64_t a, int64_t b)
{
    const int64_t product = nondet_s64();
    ASSUME(a < last_a || b < last_b || product >= last_product);
    last_a = a;
    last_b = b;
    last_product = product;
    ASSERT("factors in their ranges", a >= 0 && a <= FXL_SCALE_MAX && b >= 0 && b < (int64_t)1 << 31);
    ASSUME(product >= 0 && product <= (int64_t)1 << 55);
    return product;
}

uint32_t any_root(uint64_t value)
{
    const uint32_t root = nondet_u32();
    ASSERT("a square below 3 2^60", value >> 60 < 3);
    ASSUME(value >> 60 >= 3 || root <= 0x70000000u);
    return root;
}

/* [[row]]
 * function = "length_of"
 * property = "any place below 2^30: nothing overflows"
 * checks = 45
 * unwind = 11
 * stands_in = { fxl_square_root = "any_root" }
 */
void prove_length_of(void)
{
    int64_t place[3];
    const int64_t limit = ((int64_t)1 << 30) - 1;
    ASSUME(place[0] >= 0 && place[0] <= limit && place[1] >= 0 && place[1] <= limit && place[2] >= 0 && place[2] <= limit);
    const int64_t length = length_of(place);
    ASSERT("1 or more, below 2^31", length >= 1 && length < (int64_t)1 << 31);
    PROOF_ENDS();
}

/* For reach_of and length_of. */
int64_t any_reach(fxl_q16_16 scale, int64_t length)
{
    const int64_t reach = nondet_s64();
    ASSERT("in their ranges", scale >= 0 && scale <= FXL_SCALE_MAX && length >= 0 && length < (int64_t)1 << 31);
    ASSUME(reach >= 0 && reach <= (int64_t)1 << 40);
    return reach;
}

int64_t any_length(const int64_t place[3])
{
    const int64_t length = nondet_s64(), limit = ((int64_t)1 << 30) - 1;
    ASSERT("components below 2^30", place[0] >= 0 && place[0] <= limit && place[1] >= 0 && place[1] <= limit && place[2] >= 0 && place[2] <= limit);
    ASSUME(length >= 1 && length < (int64_t)1 << 31);
    return length;
}

/* [[row]]
 * function = "chain_in_world"
 * property = "any chain of up to nine: nothing overflows"
 * checks = 312
 * unwind = 11
 * stands_in = { fxl_multiply_s64 = "any_product", reach_of = "any_reach", length_of = "any_length" }
 */
void prove_chain_in_world(void)
{
    const fxl_motion *chain[FXL_MOTION_DEPTH_MAX + 1];
    static fxl_motion some[FXL_MOTION_DEPTH_MAX + 1];
    const uint32_t count = nondet_u32();
    const fxl_q16_16 radius = nondet_s32();
    ANY_CONTENT(some);
    ASSUME(count >= 1 && count <= FXL_MOTION_DEPTH_MAX + 1 && radius >= 0 && radius <= FXL_RADIUS_MAX);
    for (uint32_t i = 0; i <= FXL_MOTION_DEPTH_MAX; i++) {
        chain[i] = &some[i];
        ASSUME(has_extents(&some[i]) && some[i].scale_low <= some[i].scale_high); /* each has a key between them */
    }
    (void)chain_in_world(chain, count, radius);
    PROOF_ENDS();
}

/* For extents_in_range, check_keys, chain_of and chain_in_world. */
static unsigned passed;
bool any_extents(const fxl_motion *motion)
{
    (void)motion;
    passed = nondet_bool();
    return passed == 1;
}

fxl_status any_keys(const fxl_motion_set *of, const fxl_motion *motion, fxl_scene_fault *to)
{
    (void)to;
    ASSERT("keys of the table", of == &set && motion->first_key <= set.key_count && motion->key_count <= set.key_count - motion->first_key && passed == 1);
    passed += nondet_bool();
    return passed == 2 ? FXL_OK : FXL_E_RANGE;
}

uint32_t any_chain(const fxl_motion_set *of, const fxl_motion *motion, const fxl_motion *chain[FXL_MOTION_DEPTH_MAX + 1])
{
    const uint32_t count = nondet_u32();
    ASSERT("of the set", of == &set);
    ASSUME(count <= FXL_MOTION_DEPTH_MAX + 1);
    chain[0] = motion;
    return count;
}

bool any_in_world(const fxl_motion *const *chain, uint32_t count, fxl_q16_16 radius)
{
    (void)chain;
    ASSERT("a chain", count >= 1 && count <= FXL_MOTION_DEPTH_MAX + 1 && radius >= 0 && passed == 2);
    return nondet_bool();
}

/* [[row]]
 * function = "check_motion"
 * property = "any motion: one that passes passed all checks, in their order; up to 3 motions and 4 keys"
 * checks = 62
 * unwind = 11
 * stands_in = { extents_in_range = "any_extents", check_keys = "any_keys", chain_of = "any_chain", chain_in_world = "any_in_world" }
 */
void prove_check_motion(void)
{
    any_set();
    const uint32_t number = any_number();
    const fxl_motion *motion = &motions[number];
    const fxl_q16_16 radius = nondet_s32();
    ASSUME(radius >= 0 && motion->first_key <= set.key_count && motion->key_count <= set.key_count - motion->first_key);
    const fxl_status status = check_motion(&set, number, radius, &fault);
    ASSERT("by all checks", status != FXL_OK || passed == 2);
    PROOF_ENDS();
}

/* For check_motion. */
fxl_status any_motion(const fxl_motion_set *of, uint32_t number, fxl_q16_16 radius, fxl_scene_fault *to)
{
    (void)to;
    ASSERT("a motion of the table", of == &set && number < set.motion_count && radius >= 0 && is_plain(number) &&
                                        motions[number].first_key <= set.key_count &&
                                        motions[number].key_count <= set.key_count - motions[number].first_key);
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "fxl_motion_check"
 * property = "any set of up to 3 motions, or null: each motion and key looked at is one of its table"
 * checks = 492
 * unwind = 11
 * stands_in = { check_motion = "any_motion" }
 */
void prove_motion_check(void)
{
    static fxl_placement placement;
    any_checked_scene();
    any_set();
    scene.placements = nondet_bool() ? &placement : NULL;
    ASSUME(scene.placements == NULL || scene.first_turned <= scene.instance_count);
    set.motions = nondet_bool() ? motions : NULL;
    (void)fxl_motion_check(nondet_bool() ? &set : NULL, nondet_bool() ? &scene : NULL, &fault);
    PROOF_ENDS();
}
