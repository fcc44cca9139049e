/* SPDX-License-Identifier: MIT */
#include "game/setup.c"
#include "proof.h"

static fxl_scene scene;
static fxl_config config;
static fxl_target target;
static fxl_order order;
static fxl_setup_plan plan;
static uint64_t block[64];

/* No tree of a scene and no set of beams needs more. */
enum { MOST_OF_A_PART = 1 << 24 };

uint32_t any_order_size(const fxl_scene *of)
{
    ASSERT("of the plan's scene", of == &scene);
    const uint32_t size = nondet_u32();
    ASSUME(size <= MOST_OF_A_PART);
    return size;
}

uint32_t any_beam_size(const fxl_beam *beams, uint32_t count)
{
    (void)beams, (void)count;
    const uint32_t size = nondet_u32();
    ASSUME(size <= MOST_OF_A_PART);
    return size;
}

fxl_status any_begin_motions(fxl_motion_player *player, const fxl_motion_set *set, fxl_scene *of, const fxl_motion_memory *memory)
{
    (void)player, (void)set, (void)of, (void)memory;
    return FXL_OK;
}

/* A plan of a checked scene. */
static void make_any(void)
{
    ANY_CONTENT(&scene);
    ANY_CONTENT(&config);
    ANY_CONTENT(&target);
    ANY_CONTENT(&order);
    ANY_CONTENT(&plan);
    plan.scene = nondet_bool() ? NULL : &scene;
    plan.config = nondet_bool() ? NULL : &config;
    plan.order = nondet_bool() ? NULL : &order;
    plan.init_renderer = nondet_bool() ? NULL : fxl_renderer_init;
    plan.begin_motions = nondet_bool() ? NULL : any_begin_motions;
    plan.beam_memory_size = nondet_bool() ? NULL : any_beam_size;
    config.target = nondet_bool() ? NULL : &target;
    order.memory_size = nondet_bool() ? NULL : any_order_size;
    ASSUME(scene.instance_count <= FXL_SCENE_INSTANCES_MAX && scene.first_turned <= scene.instance_count);
    ASSUME(scene.draw_list_needed <= 2 * FXL_SCENE_INSTANCES_MAX && plan.pieces_size <= MOST_OF_A_PART);
    ASSUME(target.depth_bits == 0 || target.depth_bits == 16 || target.depth_bits == 32);
}

/* [[row]]
 * function = "fxl_setup_divide"
 * property = "any plan of a checked scene with up to 2^24 bytes for each of tree, pieces and beams, and null pointers: no size wraps, each share is aligned and holds its records; refused, none is written"
 * checks = 274
 */
void prove_setup_divide(void)
{
    fxl_setup setup;
    fxl_setup_shares shares;
    make_any();
    const uint32_t before = shares.before_renderer, after = shares.renderer;
    const size_t at = nondet_size();
    ASSUME(at <= 8);
    const fxl_status status = fxl_setup_divide(nondet_bool() ? NULL : &setup, nondet_bool() ? NULL : &plan, nondet_u16(),
                                               nondet_bool() ? NULL : (const uint8_t *)block + at, &shares);
    if (status == FXL_OK) {
        const uint64_t sum = (uint64_t)shares.motions + shares.beams + shares.tree + shares.depth;
        ASSERT("the sum of the shares, which does not wrap", shares.before_renderer == sum && sum + shares.renderer < UINT32_MAX);
        ASSERT("instances first", shares.instances <= shares.motions);
        ASSERT("all begin where records may", ((shares.instances | shares.motions | shares.beams | shares.tree | shares.depth | shares.renderer) & 7u) == 0);
        ASSERT("room for all entries", shares.renderer >= (uint64_t)scene.draw_list_needed * sizeof(fxl_draw_entry) || plan.has_tables);
        ASSERT("copies of all that moves", plan.begin_motions == NULL ||
                                               (shares.instances >= (uint64_t)scene.instance_count * sizeof(fxl_instance) &&
                                                shares.motions - shares.instances >= (uint64_t)(scene.instance_count - scene.first_turned) * sizeof(fxl_placement)));
        ASSERT("aligned", (at & 7u) == 0);
    } else {
        ASSERT("refused, no share is written", shares.before_renderer == before && shares.renderer == after);
    }
    PROOF_ENDS();
}

static fxl_setup_shares divided;

/* What the row of fxl_setup_divide shows. */
fxl_status any_divide(const fxl_setup *setup, const fxl_setup_plan *of, uint16_t rows, const void *memory, fxl_setup_shares *shares)
{
    (void)rows;
    if (setup == NULL || of == NULL || memory == NULL) {
        return FXL_E_ARGUMENT;
    }
    ANY_CONTENT(&divided);
    const uint64_t sum = (uint64_t)divided.motions + divided.beams + divided.tree + divided.depth;
    ASSUME(divided.before_renderer == sum && sum + divided.renderer < UINT32_MAX && divided.instances <= divided.motions);
    *shares = divided;
    return FXL_OK;
}

fxl_status fxl_renderer_init(fxl_renderer *renderer, const fxl_scene *of, const fxl_config *with, void *memory, size_t memory_size)
{
    const size_t before = (size_t)((const uint8_t *)memory - (const uint8_t *)block);
    (void)renderer, (void)of;
    ASSERT("after all other shares, with room for its entries", before == divided.before_renderer && memory_size >= divided.renderer);
    ASSERT("to the end of the memory", memory_size <= sizeof block && before + memory_size <= sizeof block);
    ASSERT("the depth's before it", (const uint8_t *)with->depth + with->depth_size == (const uint8_t *)memory);
    ASSERT("the tree's before that", (const uint8_t *)with->tree + with->tree_size == (const uint8_t *)with->depth);
    return nondet_bool() ? FXL_OK : FXL_E_CAPACITY;
}

/* [[row]]
 * function = "fxl_setup_init"
 * property = "any shares, memory of up to 512 bytes, and null pointers: no share lies outside it; set up whole, or what is missing is told"
 * checks = 476
 * stands_in = { fxl_setup_divide = "any_divide" }
 * stubs = { fxl_renderer_init = "any status" }
 */
/* A plan of a scene with no more than a renderer, a tree and a depth buffer. */
void prove_setup_init(void)
{
    static const fxl_setup_plan nothing;
    static fxl_setup setup;
    const size_t size = nondet_size();
    ASSUME(size <= sizeof block);
    plan = nothing;
    plan.scene = &scene;
    plan.config = &config;
    plan.init_renderer = fxl_renderer_init;
    setup.plan = NULL;
    setup.memory_missing = 0;
    const fxl_status status = fxl_setup_init(nondet_bool() ? NULL : &setup, nondet_bool() ? NULL : &plan, nondet_u16(), nondet_bool() ? NULL : block, size);
    ASSERT("set up whole, or not at all", (status == FXL_OK) == (setup.plan == &plan) && (status != FXL_OK || setup.step == FXL_SETUP_DONE));
    ASSERT("so many bytes are missing", setup.memory_missing == 0 ||
                                            (status == FXL_E_CAPACITY && setup.memory_missing + size == (size_t)divided.before_renderer + divided.renderer));
    PROOF_ENDS();
}
