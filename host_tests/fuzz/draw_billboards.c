/* SPDX-License-Identifier: MIT */
/* Any billboards for the models of a scene. */
#include <string.h>

#include "answers.h"
#include "draw.h"

enum {
    BOARDS = 3,
    TEXELS = 64, /* bytes of a sprite */
    BACKGROUND = 0x11,
    ROWS_MAX = 16
};

typedef struct {
    uint8_t texels[TEXELS];
    fxl_sprite sprites[BOARDS];
    fxl_billboard boards[BOARDS];
    fxl_billboard_set set;
    uint16_t *model_map;
    fxl_model *models;
    fxl_scene scene;
} boards;

/* One in so many. Where the input has ended, none. */
static bool rarely(fuzz_input *in, uint32_t count)
{
    return fuzz_below(in, count) == count - 1;
}

/* A part of a side, or, rarely, any number. */
static fxl_q16_16 any_length(fuzz_input *in, fxl_q16_16 most)
{
    return rarely(in, 16) ? fuzz_any(in) : most / 2 - fuzz_between(in, 0, most / 2);
}

static void make_board(boards *made, uint32_t number, fxl_q16_16 radius, fuzz_input *in)
{
    static const uint8_t bits[] = {1, 4, 8, 2};
    fxl_sprite *sprite = &made->sprites[number];
    fxl_billboard *board = &made->boards[number];
    sprite->pixels = rarely(in, 32) ? NULL : made->texels;
    sprite->bits = bits[rarely(in, 32) ? 3 : fuzz_below(in, 3)];
    sprite->width = (uint16_t)(8 - fuzz_below(in, 9));
    sprite->height = (uint16_t)(8 - fuzz_below(in, 9));
    sprite->key = (uint16_t)fuzz_below(in, 257);
    board->sprite = rarely(in, 32) ? NULL : sprite;
    board->width = any_length(in, radius);
    board->height = any_length(in, radius);
    board->anchor_x = any_length(in, board->width > 0 ? board->width : 1);
    board->anchor_y = any_length(in, board->height > 0 ? board->height : 1);
}

/* A copy of the scene in which some models have one face, and show a billboard. */
static void make_boards(boards *made, const fxl_scene *scene, fuzz_input *in)
{
    const uint32_t count = BOARDS - fuzz_below(in, BOARDS + 1);
    memset(made, 0, sizeof *made);
    for (uint32_t i = 0; i < TEXELS; i++) {
        made->texels[i] = (uint8_t)(i * 37);
    }
    made->scene = *scene;
    made->models = malloc(scene->model_count * sizeof *made->models);
    made->model_map = calloc(scene->model_count, sizeof *made->model_map);
    DEMAND(made->models != NULL && made->model_map != NULL);
    memcpy(made->models, scene->models, scene->model_count * sizeof *made->models);
    made->scene.models = made->models;
    for (uint32_t i = 0; i < count; i++) {
        make_board(made, i, scene->models[0].radius, in);
    }
    for (uint32_t i = 0; i < scene->model_count && i < 16; i++) {
        const uint32_t most = count + rarely(in, 64);
        made->model_map[i] = (uint16_t)(most - fuzz_below(in, count + 1));
        if (made->model_map[i] != 0 && !rarely(in, 32)) {
            made->models[i].face_count = 1;
            made->models[i].kind = FXL_MODEL_CONVEX;
            made->models[i].first_cluster = 0;
        }
    }
    made->set = (fxl_billboard_set){made->boards, count, made->model_map};
}

/* A target, and what paints billboards into it. */
typedef struct {
    const fxl_target *target;
    const fxl_sprite_painter *painter;
} way;

static const way ways[] = {{&fxl_palette, FXL_SPRITES_OF(fxl_palette)},
                           {&fxl_palette_depth_16, FXL_SPRITES_OF(fxl_palette_depth_16)},
                           {&fxl_palette_depth_32, FXL_SPRITES_OF(fxl_palette_depth_32)}};

enum {
    WAYS = sizeof ways / sizeof *ways
};

/* What belongs to a renderer. */
typedef struct {
    fxl_billboards billboards;
    void *cells;
} parts;

/* Calls that are refused, and that change nothing; billboards that go and come again. */
static void attach(fxl_renderer *renderer, parts *own, const way *by, const fxl_billboard_set *set)
{
    fxl_billboards *const off = (fxl_billboards *)(void *)((uint8_t *)&own->billboards + 4);
    fxl_billboards *const billboards = &own->billboards;
    static fxl_renderer none;
    const fxl_order *plain = renderer->order;
    DEMAND(fxl_attach_billboards(NULL, billboards, set, by->painter) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_billboards(renderer, NULL, set, by->painter) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_billboards(renderer, billboards, set, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_billboards(renderer, off, set, by->painter) == FXL_E_ALIGNMENT);
    DEMAND(fxl_attach_billboards(&none, billboards, set, by->painter) == FXL_E_ORDER);
    DEMAND(fxl_attach_billboards(renderer, billboards, set, by->painter) == FXL_OK);
    DEMAND(draw_choose(renderer, by->target, own->cells, UINT32_MAX) == FXL_E_ORDER);
    DEMAND(fxl_attach_billboards(renderer, NULL, NULL, NULL) == FXL_OK);
    DEMAND(renderer->order == plain && renderer->billboards == NULL);
    DEMAND(fxl_attach_billboards(renderer, billboards, set, by->painter) == FXL_OK);
    DEMAND(fxl_attach_billboards(renderer, billboards, set, by->painter) == FXL_OK);
}

/* What paints into another target is refused when a frame begins. */
static void misuse_painter(fxl_renderer *renderer, parts *own, const way *by, const fxl_pose *pose,
                           const fxl_billboard_set *set)
{
    const char *names[2];
    const way *other = by == ways ? &ways[1] : ways;
    DEMAND(fxl_attach_billboards(renderer, &own->billboards, set, other->painter) == FXL_OK);
    DEMAND(fxl_renderer_conflict(renderer, names));
    DEMAND(fxl_frame_begin(renderer, pose) == FXL_E_COMBINATION);
    DEMAND(fxl_attach_billboards(renderer, &own->billboards, set, by->painter) == FXL_OK);
}

static fxl_renderer *start(const boards *made, parts *own, const way *by, const fxl_lens *lens,
                           const fxl_pose *pose, uint32_t words)
{
    const uint32_t size = FXL_DEPTH_BYTES(lens->width, 3, 32);
    fxl_renderer *renderer = malloc(sizeof *renderer);
    const uint32_t entries = made->scene.draw_list_needed;
    fxl_memory memory = {
        malloc(entries * sizeof(fxl_draw_entry)), entries, malloc(words * 4 + 4), words, NULL, 0};
    DEMAND(renderer != NULL && memory.draw_list != NULL && memory.display_list != NULL);
    DEMAND(fxl_renderer_init_with(renderer, &made->scene, lens, &memory) == FXL_OK);
    own->cells = malloc(size);
    DEMAND(own->cells != NULL && draw_choose(renderer, by->target, own->cells, size) == FXL_OK);
    attach(renderer, own, by, &made->set);
    misuse_painter(renderer, own, by, pose, &made->set);
    renderer->workspace.counters.refused_calls = 0;
    DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
    return renderer;
}

static void end(fxl_renderer *renderer, parts *own)
{
    free(own->cells);
    free(renderer->frame.draw_list);
    free(renderer->frame.display_list.words);
    free(renderer);
}

static void draw(fxl_renderer *renderer, uint8_t *pixels, uint32_t rows, uint32_t step)
{
    const uint16_t width = renderer->frame.view.lens.width;
    for (uint32_t row = 0, count; row < rows; row += count) {
        count = step < rows - row ? step : rows - row;
        const fxl_band band = {.pixels = pixels + (size_t)row * width,
                               .width = width,
                               .stride = width,
                               .first_row = (uint16_t)row,
                               .rows = (uint16_t)count};
        fxl_fill_band(&band, BACKGROUND);
        DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    }
}

static void draw_both(const boards *made, const way *by, const fxl_lens *lens, const fxl_pose *pose,
                      fuzz_input *in)
{
    const uint32_t rows = lens->height < ROWS_MAX ? lens->height : ROWS_MAX;
    const size_t size = (size_t)rows * lens->width;
    uint8_t *whole = malloc(2 * size);
    parts one, other;
    DEMAND(whole != NULL);
    fxl_renderer *first = start(made, &one, by, lens, pose, 0);
    draw(first, whole, rows, rows);
    draw_all_picks(first, NULL);
    fxl_counters counters = first->workspace.counters;
    DEMAND(counters.in == (uint64_t)counters.backfacing + counters.outside + counters.degenerate +
                              counters.refused + counters.drawn);
    fxl_renderer *second = start(made, &other, by, lens, pose, fuzz_below(in, 200));
    draw(second, whole + size, rows, 1 + fuzz_below(in, rows));
    DEMAND(memcmp(whole, whole + size, size) == 0);
    counters.spilled = second->workspace.counters.spilled;
    counters.split_bands = second->workspace.counters.split_bands;
    DEMAND(memcmp(&counters, &second->workspace.counters, sizeof counters) == 0);
    record_bytes(whole, size);
    record_bytes(&first->workspace.counters, sizeof counters);
    record_bytes(&second->workspace.counters, sizeof counters);
    end(first, &one);
    end(second, &other);
    free(whole);
}

void draw_billboards(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                     fuzz_input *in)
{
    boards made;
    fxl_scene_fault fault = {NULL, 0};
    make_boards(&made, scene, in);
    const fxl_status status = fxl_billboards_check(&made.set, &made.scene, &fault);
    DEMAND((status == FXL_OK) == (fault.what == NULL));
    DEMAND(fxl_billboards_check(NULL, scene, NULL) == FXL_E_ARGUMENT);
    if (status == FXL_OK) {
        draw_both(&made, &ways[fuzz_below(in, WAYS)], lens, pose, in);
    }
    free(made.models);
    free(made.model_map);
}
