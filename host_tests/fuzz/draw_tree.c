/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "answers.h"
#include "draw.h"
#include "study/clippers.h"
#include "study/targets.h"

enum {
    BACKGROUND = 0x11,
    ROWS_MAX = 16,
    PIECES_MAX = 8192
};

/* A frame drawn by a tree, with blocks that end where they should. */
typedef struct {
    fxl_renderer renderer;
    void *order, *list, *tree, *depth, *clip, *light;
    uint8_t *pixels;
    uint32_t rows, unsplit;
} drawing;

static void *block(size_t size)
{
    void *made = malloc(size > 0 ? size : 1);
    DEMAND(made != NULL);
    memset(made, 0x5A, size);
    return made;
}

/* The triangles, which give a face several polygons, or the default; and the scene's beams. */
static void set_others(drawing *made, const fxl_scene *scene, bool triangles)
{
    if (triangles) {
        const fxl_clipper *clipper = &fxl_clipper_triangles;
        made->clip = block(clipper->workspace_size);
        DEMAND(fxl_renderer_set_clipper(&made->renderer, clipper, made->clip,
                                        clipper->workspace_size) == FXL_OK);
    }
    if (scene->beam_count > 0) {
        const fxl_beam_set set = {scene->beams, scene->beam_count, scene->lit};
        const uint32_t size = fxl_beam_light_workspace_size(scene->beams, scene->beam_count);
        made->light = block(size);
        DEMAND(fxl_attach_beams(&made->renderer, &set, made->light, size - 1) == FXL_E_CAPACITY);
        DEMAND(fxl_attach_beams(&made->renderer, &set, made->light, size) == FXL_OK);
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
    config.tree = made->tree = block(config.tree_size);
    config.depth = made->depth = block(config.depth_size);
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
    made->order = block(scene->draw_list_needed * sizeof(fxl_draw_entry));
    made->list = block(1);
    const fxl_memory memory = {made->order, scene->draw_list_needed, made->list, 0, NULL, 0};
    DEMAND(fxl_renderer_init_with(&made->renderer, scene, lens, &memory) == FXL_OK);
    made->clip = made->light = NULL;
    choose(made, target, pieces);
    set_others(made, scene, triangles);
    made->rows = lens->height < ROWS_MAX ? lens->height : ROWS_MAX;
    made->pixels = block((size_t)made->rows * lens->width);
}

static void give_list(drawing *made, uint32_t words)
{
    free(made->list);
    made->list = block(4 * (size_t)words);
    made->renderer.frame.display_list.words = made->list;
    made->renderer.frame.display_list.capacity = words;
}

static void draw(drawing *made, const fxl_pose *pose, uint32_t step)
{
    const uint16_t width = made->renderer.frame.view.lens.width;
    DEMAND(fxl_frame_begin(&made->renderer, pose) == FXL_OK);
    for (uint32_t row = 0, rows; row < made->rows; row += rows) {
        rows = step < made->rows - row ? step : made->rows - row;
        fxl_band band = {.pixels = made->pixels + (size_t)row * width,
                         .width = width,
                         .stride = width,
                         .first_row = (uint16_t)row,
                         .rows = (uint16_t)rows};
        fxl_fill_band(&band, BACKGROUND);
        DEMAND(fxl_frame_draw(&made->renderer, &band) == FXL_OK);
    }
    if (made->renderer.scene->bsp_nodes != NULL) {
        const fxl_bsp_workspace *tree = made->tree;
        DEMAND(tree->used <= tree->pieces_size);
        made->unsplit = tree->unsplit;
        record_number(tree->used);
    }
    record_bytes(made->pixels, (size_t)made->rows * width);
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
    DEMAND(one->in ==
           (uint64_t)one->backfacing + one->outside + one->degenerate + one->refused + one->drawn);
}

void draw_by_bsp(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose, fuzz_input *in)
{
    drawing whole = {0}, bands = {0}, spans = {0};
    const uint32_t pieces = fuzz_below(in, 2) ? PIECES_MAX : fuzz_below(in, PIECES_MAX);
    const bool triangles = fuzz_below(in, 4) == 0;
    open_drawing(&whole, scene, lens, &fxl_palette, pieces, triangles);
    draw(&whole, pose, whole.rows);
    DEMAND(whole.renderer.workspace.counters.in == draw_model_view(scene));
    open_drawing(&bands, scene, lens, &fxl_palette, pieces, triangles);
    give_list(&bands, fuzz_below(in, 200));
    draw(&bands, pose, 1 + fuzz_below(in, bands.rows));
    demand_same(&whole, &bands);
    open_drawing(&spans, scene, lens, &fxl_palette_spans, pieces, triangles);
    give_list(&spans, fuzz_below(in, 200));
    draw(&spans, pose, 1 + fuzz_below(in, spans.rows));
    demand_same(&whole, &spans);
    close_drawing(&whole);
    close_drawing(&bands);
    close_drawing(&spans);
}
