/* SPDX-License-Identifier: MIT */
/* Workspaces of other cores. A frame that has begun, drawn in another one: the same pixels. And calls
 * that set up one renderer and two workspaces, in any sequence, in memory that ends where it should: a
 * workspace that was set up for other settings is refused; one that is taken draws the pixels of the
 * renderer's own. The sequences record nothing. */
#include <string.h>

#include "answers.h"
#include "parts.h"
#include "study/clippers.h"
#include "study/span_buffer.h"
#include "study/targets.h"

static void misuse(fxl_workspace *workspace, const fxl_renderer *renderer, uint8_t *memory,
                   size_t least)
{
    static const fxl_renderer none;
    const size_t size = least + 64;
    DEMAND(fxl_workspace_size(NULL) == 0 && fxl_workspace_size(&none) == 0);
    DEMAND(fxl_workspace_init(NULL, renderer, memory, size) == FXL_E_ARGUMENT);
    DEMAND(fxl_workspace_init(workspace, NULL, memory, size) == FXL_E_ARGUMENT);
    DEMAND(fxl_workspace_init(workspace, renderer, NULL, size) == FXL_E_ARGUMENT);
    DEMAND(fxl_workspace_init(workspace, renderer, memory + 4, size) == FXL_E_ALIGNMENT);
    DEMAND(fxl_workspace_init(workspace, &none, memory, size) == FXL_E_ORDER);
    DEMAND(least == 0 ||
           fxl_workspace_init(workspace, renderer, memory, least - 1) == FXL_E_CAPACITY);
}

void draw_in_another(const fxl_renderer *renderer, const uint8_t *whole, uint8_t background,
                     fuzz_input *in)
{
    static fxl_workspace workspace;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const size_t least = fxl_workspace_size(renderer), size = least + fuzz_below(in, 4096);
    const size_t pixels = (size_t)lens->width * lens->height;
    uint8_t *memory = draw_memory(size + 64), *again = draw_memory(pixels);
    misuse(&workspace, renderer, memory, least);
    DEMAND(fxl_workspace_init(&workspace, renderer, memory, size) == FXL_OK);
    const uint16_t cut = (uint16_t)fuzz_below(in, lens->height);
    const fxl_band bands[] = {
        draw_band(lens, again, 0, cut),
        draw_band(lens, again + (size_t)cut * lens->width, cut, lens->height - cut),
    };
    for (uint32_t i = cut == 0 ? 1 : 0; i < 2; i++) {
        fxl_fill_band(&bands[i], background);
        DEMAND(fxl_frame_draw_with(renderer, &workspace, &bands[i]) == FXL_OK);
    }
    DEMAND(memcmp(whole, again, pixels) == 0);
    free(memory);
    free(again);
}

enum {
    STEPS = 40,
    WORKSPACES = 2,
    SCENES = 2,
    LENSES = 3,
    POSES = 2,
    LIT = 1,
    BEAMS = 2,
    OUTLINES = 4,
    LIGHT = 8,
    ATTACHED = 16
};

const fxl_target *const draw_targets[DRAW_TARGETS] = {&fxl_palette, &fxl_palette_depth_16, &fxl_rgb565,
                                                      &fxl_rgb565_depth_32, &fxl_palette_spans};
static const fxl_clipper *const clippers[] = {&fxl_clipper_view, &fxl_clipper_once,
                                              &fxl_clipper_half_spaces};

/* What a workspace is for. It has no padding. */
typedef struct {
    const fxl_target *target;
    const fxl_order *order;
    const fxl_clipper *clipper;
    uint32_t scene, lens, centre, attached;
} settings;

typedef struct {
    fxl_workspace workspace;
    void *memory;
    settings of;
    uint32_t changes; /* UINT32_MAX: it was not set up */
} other_core;

typedef struct {
    fxl_renderer renderer;
    settings now;
    uint32_t changes, random;
    fxl_scene scenes[SCENES], scene; /* a program may open both in one record */
    fxl_lens lenses[LENSES];
    fxl_pose poses[POSES];
    other_core cores[WORKSPACES];
    fxl_light light;
    fxl_lit_surfaces lit;
    fxl_outlines outlines;
    fxl_clipper_workspace clipper_memory;
    uint8_t ramp[2 * 256];
    uint16_t palette[256];
    void *order, *list, *depth, *tree, *beams;
} sequence;

/* The bytes of the input may be used up: then each sequence is another one all the same. */
static uint32_t below(sequence *of, uint32_t count)
{
    of->random ^= of->random << 13;
    of->random ^= of->random >> 17;
    of->random ^= of->random << 5;
    return of->random % count;
}

static void *again(void **memory, size_t size)
{
    free(*memory);
    return *memory = draw_memory(size);
}

/* A scene of one triangle. */
static void make_least(fxl_scene *scene)
{
    static const fxl_point vertices[3] = {{0, 0, 0}, {65536, 0, 0}, {0, 65536, 0}};
    static const uint16_t corners[3] = {0, 1, 2};
    static const fxl_face faces[] = {{{0, 0, -FXL_Q2_30_ONE}, 3, 1, {0, 1, 2}}};
    static const fxl_instance instances[1];
    static const fxl_model models[] = {{0, 3, 0, 1, FXL_MODEL_SORTED, 0, 0, 2 * 65536, 0}};
    *scene = SCENE_OF(vertices, corners, faces, models, instances);
    DEMAND(fxl_scene_check_all(scene, NULL) == FXL_OK);
}

static void choose(sequence *of)
{
    const fxl_lens *lens = &of->lenses[of->now.lens];
    const uint32_t wide = FXL_DEPTH_BYTES(lens->width, lens->height, 32);
    const uint32_t spans = FXL_SPAN_BUFFER_BYTES_LEAST(lens->width, lens->height);
    const fxl_target *target = draw_targets[below(of, DRAW_TARGETS)];
    const bool stays = of->now.target != NULL && below(of, 2);
    fxl_config config = fxl_config_for(1, 1, stays ? of->now.target : target);
    config.palette = of->palette;
    config.depth_size = wide > spans ? wide : spans;
    config.depth = again(&of->depth, config.depth_size);
    if (of->scene.bsp_nodes != NULL && below(of, 2)) {
        config.order = &fxl_by_tree;
        config.tree_size = fxl_by_tree.memory_size(&of->scene) + 4096;
        config.tree = again(&of->tree, config.tree_size);
    }
    DEMAND(fxl_renderer_choose(&of->renderer, &config) == FXL_OK);
    of->now.target = config.target;
    of->now.order = of->renderer.order;
    of->changes++;
}

static void initialise(sequence *of)
{
    if (below(of, 3) > 0) {
        of->now.scene = below(of, SCENES);
        of->now.lens = below(of, LENSES);
    }
    of->now.centre = of->now.attached = 0;
    of->now.clipper = &fxl_clipper_view;
    of->scene = of->scenes[of->now.scene];
    const uint32_t entries = of->scene.draw_list_needed, words = below(of, 2) * 4000;
    const fxl_memory memory = {
        (fxl_draw_entry *)again(&of->order, entries * sizeof(fxl_draw_entry)), entries,
        (uint32_t *)again(&of->list, words * sizeof(uint32_t)), words, NULL, 0};
    memset(&of->renderer, 0x5A, sizeof of->renderer);
    DEMAND(fxl_renderer_init_with(&of->renderer, &of->scene, &of->lenses[of->now.lens], &memory) ==
           FXL_OK);
    choose(of);
}

static void attach(sequence *of, uint32_t what)
{
    static const fxl_outline_style style = {.line = 1, .keeps_colours = true};
    fxl_renderer *renderer = &of->renderer;
    const fxl_scene *scene = &of->scene;
    const bool is_there = (of->now.attached & what) == 0;
    const fxl_light_settings lamp = {.ambient = FXL_Q2_30_ONE / 2,
                                         .direction = {0, -FXL_Q2_30_ONE, 0},
                                         .levels = 2,
                                         .ramp = of->ramp};
    fxl_status status = FXL_OK;
    if (what == BEAMS && scene->beam_count > 0) {
        const fxl_beam_set set = {scene->beams, scene->beam_count, scene->lit};
        const uint32_t size = fxl_beam_light_workspace_size(set.beams, set.count);
        status = fxl_attach_beams(renderer, is_there ? &set : NULL,
                                  is_there ? again(&of->beams, size) : NULL, size);
    } else if (what == LIGHT) {
        status = fxl_attach_light(renderer, &of->light, is_there ? &lamp : NULL);
    } else if (what == LIT) {
        status = fxl_attach_lit(renderer, is_there ? &of->lit : NULL);
    } else if (what == OUTLINES) {
        status = fxl_attach_outlines(renderer, &of->outlines, is_there ? &style : NULL);
    } else {
        return;
    }
    DEMAND(status == FXL_OK);
    of->now.attached ^= what;
    of->changes++;
}

static void set_clipper(sequence *of)
{
    const fxl_clipper *clipper = clippers[below(of, sizeof clippers / sizeof *clippers)];
    DEMAND(fxl_renderer_set_clipper(&of->renderer, clipper, &of->clipper_memory,
                                    sizeof of->clipper_memory) == FXL_OK);
    of->now.clipper = clipper;
    of->changes++;
}

static void set_centre(sequence *of)
{
    const fxl_lens *lens = &of->lenses[of->now.lens];
    const uint32_t moved = below(of, 3);
    const fxl_q16_16 x = lens->width * 32768 + (fxl_q16_16)moved * 16384;
    if (fxl_renderer_set_centre(&of->renderer, x, lens->height * 32768) == FXL_OK) {
        of->now.centre = moved;
        of->changes++;
    }
}

static void set_up(sequence *of, other_core *core)
{
    const size_t size = fxl_workspace_size(&of->renderer) + below(of, 2) * below(of, 2048);
    free(core->memory);
    core->memory = draw_memory(size);
    memset(&core->workspace, 0x5A, sizeof core->workspace);
    DEMAND(fxl_workspace_init(&core->workspace, &of->renderer, core->memory, size) == FXL_OK);
    core->of = of->now;
    core->changes = of->changes;
}

/* The frame in another core's workspace, or a refusal. What was changed and changed back may be
 * taken. So may a scene in the record of another one, once it was released: it is not read then. */
static void draw_in(sequence *of, other_core *core, const fxl_band *band, const uint8_t *expected,
                    size_t bytes)
{
    settings now = of->now;
    if (of->renderer.frame.state == FXL_FRAME_RELEASED) {
        now.scene = core->of.scene;
    }
    fxl_frame_fill(&of->renderer, band, 1);
    const fxl_status status = fxl_frame_draw_with(&of->renderer, &core->workspace, band);
    DEMAND(status == FXL_OK || status == FXL_E_ORDER);
    DEMAND(status == FXL_OK || core->changes != of->changes);
    DEMAND(status == FXL_E_ORDER || memcmp(&core->of, &now, sizeof now) == 0);
    DEMAND(status == FXL_E_ORDER || memcmp(band->pixels, expected, bytes) == 0);
}

static void draw(sequence *of)
{
    const fxl_lens *lens = &of->lenses[of->now.lens];
    fxl_renderer *renderer = &of->renderer;
    if (fxl_frame_begin(renderer, &of->poses[below(of, POSES)]) != FXL_OK) {
        return; /* two things do not go together */
    }
    const size_t bytes = (size_t)lens->width * lens->height * of->now.target->pixel_bits / 8u;
    uint8_t *expected = draw_memory(bytes), *pixels = draw_memory(bytes);
    fxl_band band = draw_band(lens, expected, 0, lens->height);
    band.palette = renderer->palette;
    fxl_frame_fill(renderer, &band, 1);
    if (below(of, 4) == 0) {
        (void)fxl_frame_release_scene(renderer);
    }
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    band.pixels = pixels;
    for (uint32_t i = 0; i < WORKSPACES; i++) {
        draw_in(of, &of->cores[i], &band, expected, bytes);
    }
    free(expected);
    free(pixels);
}

static void step(sequence *of)
{
    switch (below(of, 12)) {
    case 0:
    case 1:
        initialise(of);
        break;
    case 2:
        if (of->now.attached == 0) {
            choose(of);
        }
        break;
    case 3:
    case 4:
        attach(of, 1u << below(of, 4));
        break;
    case 5:
        set_clipper(of);
        break;
    case 6:
        set_centre(of);
        break;
    case 7:
    case 8:
        set_up(of, &of->cores[below(of, WORKSPACES)]);
        break;
    default:
        draw(of);
        break;
    }
}

void draw_sequences(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                    fuzz_input *in)
{
    FXL_STATIC_ASSERT(ATTACHED == 1 << 4, "step attaches each");
    static sequence of;
    memset(&of, 0, sizeof of);
    of.random = 1u + (uint32_t)fuzz_bits(in, 4) + lens->width * 65537u + lens->height +
                (uint32_t)pose->position.x + pose->yaw;
    of.random += of.random == 0;
    of.scenes[0] = *scene;
    make_least(&of.scenes[1]);
    of.lenses[0] = *lens;
    DEMAND(fxl_lens_from_fov(9, 31, FXL_DEGREES(60), 16384, FXL_UNITS(64), 0, &of.lenses[1]) == FXL_OK);
    DEMAND(fxl_lens_from_fov(9, 31, FXL_DEGREES(80), 16384, FXL_UNITS(64), 0, &of.lenses[2]) == FXL_OK);
    of.poses[0] = of.poses[1] = *pose;
    of.poses[1].yaw += FXL_DEGREES(20);
    for (uint32_t i = 0; i < WORKSPACES; i++) {
        of.cores[i].changes = UINT32_MAX;
    }
    initialise(&of);
    for (uint32_t i = 0; i < STEPS; i++) {
        step(&of);
    }
    free(of.order);
    free(of.list);
    free(of.depth);
    free(of.tree);
    free(of.beams);
    for (uint32_t i = 0; i < WORKSPACES; i++) {
        free(of.cores[i].memory);
    }
}
