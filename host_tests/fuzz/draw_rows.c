/* SPDX-License-Identifier: MIT */
/* The first rows of a frame, whole and in bands: by the scene's tree, as a wireframe, and with billboards
 * for some models. */
#include <string.h>

#include "answers.h"
#include "parts.h"
#include "study/clippers.h"
#include "study/targets.h"

enum {
    ROWS_MAX = 16,
    PIECES_MAX = 8192,
    BOARDS = 3,
    TEXELS = 64 /* bytes of a sprite */
};

static uint32_t rows_of(const fxl_lens *lens)
{
    return lens->height < ROWS_MAX ? lens->height : ROWS_MAX;
}

/* --- by a tree ---------------------------------------------------------------- */

/* A frame drawn by a tree, with blocks that end where they should. */
typedef struct {
    fxl_renderer renderer;
    void *order, *list, *tree, *depth, *clip, *light;
    uint8_t *pixels;
    uint32_t rows, unsplit;
} drawing;

/* The triangles, which give a face several polygons, or the default; and the scene's beams. */
static void set_others(drawing *made, const fxl_scene *scene, bool triangles)
{
    if (triangles) {
        const fxl_clipper *clipper = &fxl_clipper_triangles;
        made->clip = draw_memory(clipper->workspace_size);
        DEMAND(fxl_renderer_set_clipper(&made->renderer, clipper, made->clip,
                                        clipper->workspace_size) == FXL_OK);
    }
    made->light = draw_beams(&made->renderer);
    if (made->light != NULL) {
        const fxl_beam_set set = {scene->beams, scene->beam_count, scene->lit};
        const uint32_t size = fxl_beam_light_workspace_size(scene->beams, scene->beam_count);
        DEMAND(fxl_attach_beams(&made->renderer, &set, made->light, size - 1) == FXL_E_CAPACITY);
    }
    made->renderer.workspace.counters.refused_calls = 0;
}

/* The order by tree, with so many bytes for pieces, and a target with the least memory. */
static void choose(drawing *made, const fxl_target *target, uint32_t pieces)
{
    fxl_renderer *renderer = &made->renderer;
    const uint32_t least = fxl_by_tree.memory_size(renderer->scene);
    const uint32_t size = pieces > 0 ? ((least + 7u) & ~7u) + pieces : least;
    fxl_config config = fxl_config_for(1, 1, target);
    config.order = &fxl_by_tree;
    config.tree_size = size;
    config.depth_size =
        target->memory_size != NULL ? target->memory_size(&renderer->frame.view.lens) : 0;
    config.tree = made->tree = draw_memory(config.tree_size);
    config.depth = made->depth = draw_memory(config.depth_size);
    if (least > 0) {
        config.tree_size = least - 1;
        DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_CAPACITY);
        config.tree_size = size;
    }
    if (config.depth_size > 0) {
        config.depth_size -= 1;
        DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_CAPACITY);
        config.depth_size += 1;
    }
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_OK);
}

static void open_drawing(drawing *made, const fxl_scene *scene, const fxl_lens *lens,
                         const fxl_target *target, uint32_t pieces, bool triangles)
{
    made->order = draw_memory(scene->draw_list_needed * sizeof(fxl_draw_entry));
    made->list = draw_memory(1);
    const fxl_memory memory = {made->order, scene->draw_list_needed, made->list, 0, NULL, 0};
    DEMAND(fxl_renderer_init_with(&made->renderer, scene, lens, &memory) == FXL_OK);
    made->clip = NULL;
    choose(made, target, pieces);
    set_others(made, scene, triangles);
    made->rows = rows_of(lens);
    made->pixels = draw_memory((size_t)made->rows * lens->width);
}

static void give_list(drawing *made, uint32_t words)
{
    free(made->list);
    made->list = draw_memory(4 * (size_t)words);
    made->renderer.frame.display_list.words = made->list;
    made->renderer.frame.display_list.capacity = words;
}

static void draw_by_tree(drawing *made, const fxl_pose *pose, uint32_t step)
{
    DEMAND(fxl_frame_begin(&made->renderer, pose) == FXL_OK);
    draw_bands(&made->renderer, made->pixels, made->rows, step);
    if (made->renderer.scene->bsp_nodes != NULL) {
        const fxl_bsp_workspace *tree = made->tree;
        DEMAND(tree->used <= tree->pieces_size);
        made->unsplit = tree->unsplit;
        record_number(tree->used);
    }
    record_bytes(made->pixels, (size_t)made->rows * made->renderer.frame.view.lens.width);
    record_bytes(&made->renderer.workspace.counters, sizeof made->renderer.workspace.counters);
}

static void close_drawing(drawing *made)
{
    free(made->order);
    free(made->list);
    free(made->tree);
    free(made->depth);
    free(made->clip);
    free(made->light);
    free(made->pixels);
}

/* What does not depend on bands, list or the direction of the walk. */
static void demand_same(const drawing *a, const drawing *b)
{
    const fxl_counters *one = &a->renderer.workspace.counters,
                       *other = &b->renderer.workspace.counters;
    DEMAND(memcmp(a->pixels, b->pixels, (size_t)a->rows * a->renderer.frame.view.lens.width) == 0);
    DEMAND(one->in == other->in && one->backfacing == other->backfacing &&
           one->outside == other->outside && one->degenerate == other->degenerate &&
           one->refused == other->refused && one->drawn == other->drawn &&
           one->clipped == other->clipped && a->unsplit == b->unsplit);
    DEMAND(draw_accounted(one));
}

void draw_by_bsp(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose, fuzz_input *in)
{
    drawing whole = {0}, bands = {0}, spans = {0};
    const uint32_t pieces = fuzz_below(in, 2) ? PIECES_MAX : fuzz_below(in, PIECES_MAX);
    const bool triangles = fuzz_below(in, 4) == 0;
    open_drawing(&whole, scene, lens, &fxl_palette, pieces, triangles);
    draw_by_tree(&whole, pose, whole.rows);
    DEMAND(whole.renderer.workspace.counters.in == draw_model_view(scene));
    open_drawing(&bands, scene, lens, &fxl_palette, pieces, triangles);
    give_list(&bands, fuzz_below(in, 200));
    draw_by_tree(&bands, pose, 1 + fuzz_below(in, bands.rows));
    demand_same(&whole, &bands);
    open_drawing(&spans, scene, lens, &fxl_palette_spans, pieces, triangles);
    give_list(&spans, fuzz_below(in, 200));
    draw_by_tree(&spans, pose, 1 + fuzz_below(in, spans.rows));
    demand_same(&whole, &spans);
    close_drawing(&whole);
    close_drawing(&bands);
    close_drawing(&spans);
}

/* --- a wireframe -------------------------------------------------------------- */

/* The first rows in bands of so many; the caller frees them. */
static uint8_t *draw_wires(fxl_wire *wire, const fxl_lens *lens, uint32_t rows, uint32_t step)
{
    uint8_t *pixels = draw_memory((size_t)rows * lens->width);
    for (uint32_t row = 0, count; row < rows; row += count) {
        count = step < rows - row ? step : rows - row;
        const fxl_band band = draw_band(lens, pixels + (size_t)row * lens->width, row, count);
        fxl_fill_band(&band, DRAW_BACKGROUND);
        DEMAND(fxl_wire_draw(wire, &band) == FXL_OK);
    }
    return pixels;
}

void draw_wireframe(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                    fuzz_input *in)
{
    const uint32_t rows = rows_of(lens);
    fxl_wire_clipper clipper = fuzz_below(in, 2) ? fxl_line_by_planes : fxl_line_by_codes;
    fxl_wire wire;
    DEMAND(fxl_wire_init(&wire, scene, lens, clipper) == FXL_OK);
    DEMAND(fxl_wire_begin(&wire, pose) == FXL_OK);
    uint8_t *whole = draw_wires(&wire, lens, rows, rows);
    const fxl_wire_counters counters = wire.counters;
    DEMAND(counters.in == (uint64_t)counters.outside + counters.refused + counters.drawn);
    DEMAND(counters.refused == 0 && counters.clipped <= counters.drawn);
    uint8_t *bands = draw_wires(&wire, lens, rows, 1 + fuzz_below(in, rows));
    DEMAND(memcmp(whole, bands, (size_t)rows * lens->width) == 0);
    DEMAND(memcmp(&counters, &wire.counters, sizeof counters) == 0);
    record_bytes(whole, (size_t)rows * lens->width);
    record_bytes(&counters, sizeof counters);
    free(whole);
    free(bands);
}

/* --- with billboards ---------------------------------------------------------- */

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
    made->models = draw_memory(scene->model_count * sizeof *made->models);
    made->model_map = calloc(scene->model_count, sizeof *made->model_map);
    DEMAND(made->model_map != NULL);
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
    fxl_renderer *renderer = draw_memory(sizeof *renderer);
    const uint32_t entries = made->scene.draw_list_needed;
    const fxl_memory memory = {draw_memory(entries * sizeof(fxl_draw_entry)), entries, draw_memory(words * 4), words, NULL, 0};
    DEMAND(fxl_renderer_init_with(renderer, &made->scene, lens, &memory) == FXL_OK);
    own->cells = draw_memory(size);
    DEMAND(draw_choose(renderer, by->target, own->cells, size) == FXL_OK);
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

static void draw_both(const boards *made, const way *by, const fxl_lens *lens, const fxl_pose *pose,
                      fuzz_input *in)
{
    const uint32_t rows = rows_of(lens);
    const size_t size = (size_t)rows * lens->width;
    uint8_t *whole = draw_memory(2 * size);
    parts one, other;
    fxl_renderer *first = start(made, &one, by, lens, pose, 0);
    draw_bands(first, whole, rows, rows);
    draw_all_picks(first, NULL);
    fxl_counters counters = first->workspace.counters;
    DEMAND(draw_accounted(&counters));
    fxl_renderer *second = start(made, &other, by, lens, pose, fuzz_below(in, 200));
    draw_bands(second, whole + size, rows, 1 + fuzz_below(in, rows));
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
