/* SPDX-License-Identifier: MIT */
/* A frame into each target with whatever may be attached: either two things do not go together, and
 * both are named, or the frame is drawn. Takes no input and records nothing. */
#include <stdlib.h>
#include <string.h>

#include "answers.h"
#include "draw.h"
#include "study/study.h"

enum {
    LIGHT = 1,
    OUTLINES = 2,
    BEAMS = 4,
    SETS = 8,
    TREE_ROOM = 1 << 16
};

typedef struct {
    fxl_renderer renderer;
    fxl_light light;
    fxl_lit_surfaces lit;
    fxl_outlines outlines;
    uint8_t ramp[2 * 256];
    uint16_t palette[256];
    void *order, *depth, *tree, *beams, *pixels;
    uint32_t depth_size, tree_size, beams_size;
} attached;

static void attach(attached *to, uint32_t set)
{
    static const fxl_outline_style style = {.line = 1, .keeps_colours = true};
    fxl_renderer *renderer = &to->renderer;
    const fxl_scene *scene = renderer->scene;
    fxl_light_settings settings;
    memset(&settings, 0, sizeof settings);
    settings.ambient = FXL_Q2_30_ONE / 2;
    settings.direction.y = -FXL_Q2_30_ONE;
    settings.levels = 2;
    settings.ramp = to->ramp;
    const fxl_beam_set beams = {scene->beams, scene->beam_count, scene->lit};
    DEMAND(fxl_attach_light(renderer, &to->light, set & LIGHT ? &settings : NULL) == FXL_OK);
    DEMAND(fxl_attach_lit(renderer, set & LIGHT ? &to->lit : NULL) == FXL_OK);
    DEMAND(fxl_attach_outlines(renderer, &to->outlines, set & OUTLINES ? &style : NULL) == FXL_OK);
    if (scene->beam_count > 0) {
        DEMAND(fxl_attach_beams(renderer, set & BEAMS ? &beams : NULL, to->beams, to->beams_size) ==
               FXL_OK);
    }
}

/* place pixel-format: random input */
/* The frame that fxl_render has drawn, as another core would draw it: the same pixels. */
static void draw_as_another(const attached *to)
{
    static fxl_workspace workspace;
    const fxl_renderer *renderer = &to->renderer;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const size_t size = fxl_workspace_size(renderer);
    const size_t bytes = (size_t)lens->width * lens->height * renderer->target->pixel_bits / 8u;
    void *memory = malloc(size + 8), *pixels = malloc(bytes);
    DEMAND(memory != NULL && pixels != NULL);
    const fxl_band band = {.pixels = pixels,
                           .width = lens->width,
                           .stride = lens->width,
                           .rows = lens->height,
                           .palette = renderer->palette};
    DEMAND(fxl_workspace_init(&workspace, renderer, memory, size) == FXL_OK);
    fxl_frame_fill(renderer, &band, renderer->frame.background);
    DEMAND(fxl_frame_draw_with(renderer, &workspace, &band) == FXL_OK);
    DEMAND(memcmp(pixels, to->pixels, bytes) == 0);
    free(memory);
    free(pixels);
}

/* A rectangle of the frame that was drawn has its pixels. */
static void demand_rectangle(attached *to, const fxl_pose *pose)
{
    fxl_renderer *renderer = &to->renderer;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const uint32_t bytes = renderer->target->pixel_bits / 8u;
    fxl_band band = {.width = lens->width,
                     .first_row = lens->height / 3,
                     .palette = bytes == 2 ? to->palette : NULL,
                     .first_column = lens->width / 3};
    band.columns = band.stride = (uint16_t)((lens->width + 1) / 2);
    band.rows = (uint16_t)((lens->height + 1) / 2);
    band.pixels = malloc((size_t)band.columns * band.rows * bytes);
    DEMAND(band.pixels != NULL && fxl_frame_begin(renderer, pose) == FXL_OK);
    fxl_frame_fill(renderer, &band, renderer->frame.background);
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    for (uint32_t row = 0; row < band.rows; row++) {
        const size_t at = (size_t)(band.first_row + row) * lens->width + band.first_column;
        DEMAND(memcmp(band.pixels + row * band.columns * bytes,
                      (const uint8_t *)to->pixels + at * bytes, band.columns * bytes) == 0);
    }
    free(band.pixels);
}

static void draw_set(attached *to, uint32_t set, const fxl_pose *pose)
{
    const char *names[2] = {NULL, NULL};
    fxl_renderer *renderer = &to->renderer;
    attach(to, set);
    const bool conflict = fxl_renderer_conflict(renderer, names);
    DEMAND(conflict == (names[0] != NULL && names[1] != NULL));
    DEMAND(fxl_render(renderer, pose, to->pixels, renderer->frame.view.lens.width) ==
           (conflict ? FXL_E_COMBINATION : FXL_OK));
    DEMAND(conflict == (fxl_render_explain(renderer, pose, to->pixels,
                                           renderer->frame.view.lens.width, NULL) != NULL));
    if (!conflict) {
        draw_all_picks(renderer, set & OUTLINES ? NULL : to->pixels);
        draw_as_another(to);
        demand_rectangle(to, pose);
    }
}

static void choose(attached *to, const fxl_order *order, const fxl_target *target)
{
    fxl_config config = fxl_config_for(1, 1, target);
    config.order = order;
    config.palette = to->palette;
    config.depth = to->depth;
    config.depth_size = to->depth_size;
    config.tree = to->tree;
    config.tree_size = to->tree_size;
    DEMAND(fxl_renderer_choose(&to->renderer, &config) == FXL_OK);
}

/* What fxl_renderer_choose refuses, of a renderer without attachments. */
static void misuse(attached *to)
{
    static fxl_renderer none;
    fxl_renderer *renderer = &to->renderer;
    const char *names[2];
    fxl_config config = fxl_config_for(1, 1, &fxl_rgb565_depth_16);
    DEMAND(fxl_renderer_choose(NULL, &config) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_choose(&none, &config) == FXL_E_ORDER);
    DEMAND(fxl_renderer_choose(renderer, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ARGUMENT);
    config.palette = (const uint16_t *)(const void *)((uint8_t *)to->palette + 1);
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ALIGNMENT);
    config.palette = to->palette;
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_CAPACITY);
    config.depth = (uint8_t *)to->depth + 4;
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ALIGNMENT);
    config.depth = NULL;
    config.depth_size = to->depth_size;
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ARGUMENT);
    config.target = NULL;
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ARGUMENT);
    DEMAND(!fxl_renderer_conflict(NULL, names) && !fxl_renderer_conflict(renderer, NULL));
    DEMAND(!fxl_renderer_conflict(renderer, names));
    DEMAND(fxl_attach_outlines(NULL, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_outlines(&none, NULL, NULL) == FXL_E_ORDER);
    const fxl_outline_style style = {.line = 1};
    DEMAND(fxl_attach_outlines(renderer, NULL, &style) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_outlines(renderer, (fxl_outlines *)(void *)((uint8_t *)&to->outlines + 4),
                               &style) == FXL_E_ALIGNMENT);
    DEMAND(fxl_attach_light(NULL, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_lit(NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_beams(NULL, NULL, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_surfaces(NULL, NULL, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_billboards(NULL, NULL, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_surfaces(renderer, NULL, NULL, NULL) == FXL_OK);
    DEMAND(fxl_attach_billboards(renderer, NULL, NULL, NULL) == FXL_OK);
}

static void open(attached *made, const fxl_scene *scene, const fxl_lens *lens)
{
    memset(made, 0, sizeof *made);
    for (uint32_t i = 0; i < 256; i++) {
        made->palette[i] = (uint16_t)(i * 0x0101u);
    }
    const uint32_t area = (uint32_t)lens->width * lens->height;
    made->order = malloc(scene->draw_list_needed * sizeof(fxl_draw_entry));
    made->depth_size = FXL_DEPTH_BYTES(lens->width, lens->height, 32);
    const uint32_t spans = FXL_SPAN_BUFFER_BYTES_LEAST(lens->width, lens->height);
    made->depth_size = made->depth_size < spans ? spans : made->depth_size;
    made->tree_size = TREE_ROOM + (scene->bsp_nodes ? fxl_by_tree.memory_size(scene) : 0);
    made->beams_size =
        scene->beam_count > 0 ? fxl_beam_light_workspace_size(scene->beams, scene->beam_count) : 8;
    made->depth = malloc(made->depth_size);
    made->tree = malloc(made->tree_size);
    made->beams = malloc(made->beams_size);
    made->pixels = malloc(2 * (size_t)area);
    DEMAND(made->order && made->depth && made->tree && made->beams && made->pixels);
}

void draw_attached(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose)
{
    static const fxl_target *const targets[] = {&fxl_palette, &fxl_palette_depth_16, &fxl_rgb565,
                                                &fxl_rgb565_depth_32, &fxl_palette_spans};
    static attached made;
    open(&made, scene, lens);
    const fxl_memory memory = {made.order, scene->draw_list_needed, NULL, 0, NULL, 0};
    DEMAND(fxl_renderer_init_with(&made.renderer, scene, lens, &memory) == FXL_OK);
    misuse(&made);
    for (uint32_t i = 0; i < sizeof targets / sizeof *targets; i++) {
        for (uint32_t set = 0; set < SETS; set++) {
            DEMAND(fxl_renderer_init_with(&made.renderer, scene, lens, &memory) == FXL_OK);
            choose(&made, NULL, targets[i]);
            draw_set(&made, set, pose);
        }
        if (scene->bsp_nodes) {
            DEMAND(fxl_renderer_init_with(&made.renderer, scene, lens, &memory) == FXL_OK);
            choose(&made, &fxl_by_tree, targets[i]);
            draw_set(&made, OUTLINES * (i & 1u), pose);
        }
    }
    free(made.order);
    free(made.depth);
    free(made.tree);
    free(made.beams);
    free(made.pixels);
}
