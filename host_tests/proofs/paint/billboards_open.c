/* SPDX-License-Identifier: MIT */
#include "paint/billboard.c"
#include "scene/scene_tables.h"

#define PIXELS  4096
#define ENTRIES 2

static uint8_t pixels[PIXELS];
static fxl_scene_billboard from[ENTRIES];
static fxl_sprite sprites[ENTRIES];
static fxl_billboard boards[ENTRIES];
static uint16_t model_map[MODELS];
static fxl_scene_image image;
static fxl_billboard_set set;

/* A sprite's pixels and colours lie in those of the image. */
static bool lies_in_pixels(const fxl_sprite *sprite)
{
    return sprite->pixels >= pixels && sprite->pixels <= pixels + PIXELS && (sprite->bits == 1 || sprite->bits == 4 || sprite->bits == 8) &&
           (sprite->bits == 8) == (sprite->colours == NULL) &&
           (sprite->colours == NULL || (sprite->colours >= pixels && sprite->colours + (1u << sprite->bits) <= pixels + PIXELS));
}

/* [[row]]
 * function = "make_sprite"
 * property = "any billboard of an image: the pixels and colours of one that passes lie in those of the image"
 * checks = 297
 */
void prove_make_sprite(void)
{
    fxl_scene_billboard one;
    fxl_sprite sprite;
    const fxl_scene_billboards table = {.pixels = pixels, .pixel_bytes = nondet_u32()};
    ASSUME(table.pixel_bytes <= PIXELS);
    const fxl_status status = make_sprite(&one, &table, &sprite);
    ASSERT("in the image", status != FXL_OK || lies_in_pixels(&sprite));
    ASSERT("with all its rows", status != FXL_OK ||
                                    (uint64_t)one.pixels + fxl_multiply_u32((uint32_t)fxl_sprite_row_bytes(&sprite), sprite.height) <= table.pixel_bytes);
    PROOF_ENDS();
}

/* For make_sprite and fxl_billboards_check. */
fxl_status any_sprite(const fxl_scene_billboard *one, const fxl_scene_billboards *table, fxl_sprite *to)
{
    const bool good = nondet_bool();
    ASSERT("of the table", one >= from && one < from + ENTRIES && table == &image.billboards);
    ASSERT("into the caller's", to == &sprites[one - from]);
    to->pixels = pixels + nondet_u32() % (PIXELS + 1);
    to->bits = nondet_u8();
    to->colours = nondet_bool() ? NULL : pixels + nondet_u32() % (PIXELS - 15);
    ASSUME(!good || lies_in_pixels(to));
    return good ? FXL_OK : FXL_E_OFFSET;
}

static bool passed;
fxl_status any_set(const fxl_billboard_set *found, const fxl_scene *of, fxl_scene_fault *to)
{
    const uint32_t i = nondet_u32() % ENTRIES;
    (void)to;
    ASSERT("of the image", of == &image.scene && found->billboards == boards && found->model_map == model_map);
    ASSERT("each has its sprite", i >= found->count || boards[i].sprite == &sprites[i]);
    passed = nondet_bool();
    return passed ? FXL_OK : FXL_E_COUNT;
}

/* [[row]]
 * function = "fxl_billboards_open"
 * property = "any image of up to 2 billboards: each has its sprite, a set is opened after its check, and refused, it stays"
 * checks = 330
 * stands_in = { make_sprite = "any_sprite", fxl_billboards_check = "any_set" }
 */
void prove_billboards_open(void)
{
    const uint32_t capacity = nondet_u32();
    const fxl_billboard *before = set.billboards;
    ANY_CONTENT(&image);
    ANY_CONTENT(from);
    image.billboards.billboards = from;
    image.billboards.pixels = pixels;
    image.billboards.model_map = nondet_bool() ? model_map : NULL;
    ASSUME(image.billboards.count <= ENTRIES && image.billboards.pixel_bytes <= PIXELS && capacity <= ENTRIES);
    const fxl_status status = fxl_billboards_open(nondet_bool() ? &image : NULL, nondet_bool() ? sprites : NULL, nondet_bool() ? boards : NULL, capacity,
                                                  nondet_bool() ? &set : NULL, &fault);
    ASSERT("opened after its check, with its tables", status != FXL_OK || (passed && set.billboards == boards && set.count <= capacity));
    ASSERT("refused, it stays", status == FXL_OK || set.billboards == before);
    PROOF_ENDS();
}

/* What check_billboard leaves of a billboard's sides. */
static bool has_sides(const fxl_billboard *board)
{
    return board->width >= 1 && board->width <= FXL_BILLBOARD_SIDE_MAX && board->anchor_x >= 0 && board->anchor_x <= board->width &&
           board->height >= 1 && board->height <= FXL_BILLBOARD_SIDE_MAX && board->anchor_y >= 0 && board->anchor_y <= board->height;
}

/* [[row]]
 * function = "check_billboard"
 * property = "any billboard: one that passes has a sprite with pixels, and sides in their range"
 * checks = 128
 */
void prove_check_billboard(void)
{
    fxl_sprite sprite;
    fxl_billboard board;
    sprite.pixels = nondet_bool() ? pixels : NULL;
    board.sprite = nondet_bool() ? &sprite : NULL;
    const fxl_status status = check_billboard(&board);
    ASSERT("sides in their range", status != FXL_OK || has_sides(&board));
    ASSERT("a sprite with pixels", status != FXL_OK || (board.sprite != NULL && sprite.pixels != NULL && sprite.width >= 1 && sprite.height >= 1));
    PROOF_ENDS();
}

/* [[row]]
 * function = "square_beyond"
 * property = "any side and anchor: below 2^58"
 * checks = 3
 */
void prove_square_beyond(void)
{
    const fxl_q16_16 side = nondet_s32(), anchor = nondet_s32();
    ASSUME(side >= 1 && side <= FXL_BILLBOARD_SIDE_MAX && anchor >= 0 && anchor <= side);
    ASSERT("below 2^58", square_beyond(side, anchor) < (uint64_t)1 << 58);
    PROOF_ENDS();
}

/* For square_beyond, check_billboard and check_model. */
uint64_t any_square(fxl_q16_16 side, fxl_q16_16 anchor)
{
    const uint64_t square = nondet_u64();
    ASSERT("a side and its anchor", side >= 1 && side <= FXL_BILLBOARD_SIDE_MAX && anchor >= 0 && anchor <= side);
    ASSUME(square < (uint64_t)1 << 58);
    return square;
}

/* [[row]]
 * id = "check_model of a billboard"
 * function = "check_model"
 * property = "any model of a checked scene and any checked billboard: one that passes is convex and has one face; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 389
 * unwind = 8
 * stands_in = { square_beyond = "any_square" }
 */
void prove_check_model(void)
{
    any_checked_scene();
    ANY_CONTENT(boards);
    ASSUME(has_sides(&boards[0]));
    const fxl_status status = check_model(&models[0], &boards[0]);
    ASSERT("a convex model of one face", status != FXL_OK || (models[0].kind == FXL_MODEL_CONVEX && models[0].face_count == 1));
    PROOF_ENDS();
}

static bool checked[ENTRIES];
fxl_status any_billboard(const fxl_billboard *board)
{
    const bool good = nondet_bool();
    ASSERT("of the table", board >= boards && board < boards + set.count);
    ASSUME(!good || has_sides(board));
    checked[board - boards] = good;
    return good ? FXL_OK : FXL_E_RANGE;
}

fxl_status any_model(const fxl_model *model, const fxl_billboard *board)
{
    ASSERT("a model of the scene", model >= models && model < models + scene.model_count);
    ASSERT("a checked billboard", board >= boards && board < boards + set.count && checked[board - boards] && has_sides(board));
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "fxl_billboards_check"
 * property = "any set of up to 2 billboards of a checked scene: nothing is out of bounds, and each model has a checked billboard of the table, or none"
 * checks = 543
 * unwind = 8
 * stands_in = { check_billboard = "any_billboard", check_model = "any_model" }
 */
void prove_billboards_check(void)
{
    any_checked_scene();
    ANY_CONTENT(boards);
    ANY_CONTENT(model_map);
    set.billboards = nondet_bool() ? boards : NULL;
    set.model_map = nondet_bool() ? model_map : NULL;
    set.count = nondet_u32();
    ASSUME(set.count <= ENTRIES);
    const uint32_t i = nondet_u32();
    ASSUME(i < scene.model_count);
    const fxl_status status = fxl_billboards_check(nondet_bool() ? &set : NULL, nondet_bool() ? &scene : NULL, &fault);
    ASSERT("each model's billboard is one of the table, or none", status != FXL_OK || model_map[i] <= set.count);
    PROOF_ENDS();
}