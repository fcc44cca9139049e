/* SPDX-License-Identifier: MIT */
/* Calls that must be refused: null pointers, too little memory, bands of another screen, calls out of
 * order. There is a sentence about each call that is refused, and none about another. */
#include <string.h>

#include "answers.h"
#include "parts.h"
#include "study/clippers.h"
#include "study/targets.h"

typedef struct {
    fxl_scene scene;
    fxl_config config;
    fxl_renderer renderer;
    uint64_t memory[32], cells[8];
    uint16_t palette[257], pixels[17];
    fxl_pose eye;
    fxl_model model;
    fxl_instance instances[2];
    fxl_placement placement; /* of the second */
} explained;

enum {
    EXPLAINED_WIDTH = 4,
    EXPLAINED_HEIGHT = 4
};

static void demand_init(explained *state, const fxl_scene *scene, const fxl_config *config,
                        void *memory, size_t size)
{
    const fxl_status status = fxl_renderer_init(&state->renderer, scene, config, memory, size);
    const char *said = fxl_renderer_explain(&state->renderer, scene, config, memory, size);
    DEMAND((said == NULL) == (status == FXL_OK));
}

/* With one number of the configuration spoilt, which is then as before. */
static void demand_config(explained *state)
{
    demand_init(state, &state->scene, &state->config, state->memory, sizeof state->memory);
    state->config = fxl_config_default(EXPLAINED_WIDTH, EXPLAINED_HEIGHT);
}

static void explain_arguments(explained *state)
{
    fxl_scene unchecked = state->scene;
    unchecked.draw_list_needed = 0;
    DEMAND(fxl_renderer_explain(NULL, &state->scene, &state->config, state->memory, 8) != NULL);
    demand_init(state, NULL, &state->config, state->memory, sizeof state->memory);
    demand_init(state, &state->scene, NULL, state->memory, sizeof state->memory);
    demand_init(state, &state->scene, &state->config, NULL, sizeof state->memory);
    demand_init(state, &state->scene, &state->config, (uint8_t *)state->memory + 4,
                sizeof state->memory - 8);
    demand_init(state, &unchecked, &state->config, state->memory, sizeof state->memory);
    demand_init(state, &state->scene, &state->config, state->memory, 8);
}

static void explain_lenses(explained *state)
{
    fxl_config *config = &state->config;
    const fxl_angle views[] = {0, FXL_DEGREES(170)};
    const uint16_t sides[] = {0, FXL_SCREEN_MAX + 1};
    for (uint32_t i = 0; i < 2; i++) {
        config->width = sides[i];
        demand_config(state);
        config->height = sides[i];
        demand_config(state);
        config->fov = views[i];
        demand_config(state);
        config->far_z = i == 0 ? -1 : INT32_MAX;
        demand_config(state);
        config->inset = i == 0 ? -1 : INT32_MAX;
        demand_config(state);
    }
    config->near_z = 0;
    demand_config(state);
    config->far_z = config->near_z;
    demand_config(state);
}

static void explain_targets(explained *state)
{
    fxl_config *config = &state->config;
    uint8_t *const cells[] = {NULL, (uint8_t *)state->cells + 4, (uint8_t *)state->cells};
    config->target = NULL;
    demand_config(state);
    for (uint32_t i = 0; i < 3; i++) {
        config->target = &fxl_rgb565;
        config->palette = i == 0 ? NULL : (const uint16_t *)((uintptr_t)state->palette + i - 1);
        demand_config(state);
        config->target = &fxl_palette_depth_16;
        config->depth = cells[i];
        config->depth_size = sizeof state->cells - 8;
        demand_config(state);
    }
    config->target = &fxl_palette_depth_16;
    config->depth = state->cells;
    config->depth_size = 8;
    demand_config(state);
}

static void demand_render(explained *state, const fxl_pose *eye, void *pixels, uint16_t stride)
{
    uint32_t number = UINT32_MAX;
    const fxl_status status = fxl_render(&state->renderer, eye, pixels, stride);
    const char *said = fxl_render_explain(&state->renderer, eye, pixels, stride, &number);
    DEMAND((said == NULL) == (status == FXL_OK));
    DEMAND(number == UINT32_MAX ||
           (number == 1 && fxl_placement_check(&state->placement, &state->instances[1].centre,
                                               state->model.radius) == status));
    DEMAND(status != FXL_E_PLACEMENT || number == 1);
}

static void demand_band(explained *state, const fxl_band *band)
{
    const fxl_status status = fxl_frame_draw(&state->renderer, band);
    DEMAND((fxl_frame_explain(&state->renderer, band) == NULL) == (status == FXL_OK));
}

static void explain_bands(explained *state)
{
    const bool is_wide = state->renderer.palette != NULL;
    const fxl_band whole = {.pixels = (uint8_t *)state->pixels,
                            .width = EXPLAINED_WIDTH,
                            .stride = EXPLAINED_WIDTH,
                            .rows = EXPLAINED_HEIGHT,
                            .palette = state->renderer.palette};
    fxl_band bands[10];
    for (uint32_t i = 0; i < 10; i++) {
        bands[i] = whole;
    }
    bands[1].pixels = NULL;
    bands[2].palette = is_wide ? NULL : state->palette;
    bands[3].width = EXPLAINED_WIDTH + 1;
    bands[4].stride = EXPLAINED_WIDTH - 1;
    bands[5].rows = 0;
    bands[6].first_row = 1;
    bands[7].first_column = 1;
    bands[7].columns = EXPLAINED_WIDTH;
    bands[8].first_column = 1;
    bands[8].columns = EXPLAINED_WIDTH - 1;
    bands[9].pixels = (uint8_t *)state->pixels + 1;
    demand_band(state, NULL);
    for (uint32_t i = 0; i < 10; i++) {
        demand_band(state, &bands[i]);
    }
}

static void explain_frames(explained *state, const fxl_target *target)
{
    fxl_pose far_away = state->eye;
    far_away.position.x = INT32_MAX;
    state->config.target = target;
    state->config.palette = state->palette;
    demand_config(state);
    explain_bands(state); /* without a frame */
    demand_render(state, NULL, state->pixels, EXPLAINED_WIDTH);
    demand_render(state, &far_away, state->pixels, EXPLAINED_WIDTH);
    demand_render(state, &state->eye, NULL, EXPLAINED_WIDTH);
    demand_render(state, &state->eye, state->pixels, EXPLAINED_WIDTH - 1);
    demand_render(state, &state->eye, (uint8_t *)state->pixels + 1, EXPLAINED_WIDTH);
    demand_render(state, &state->eye, state->pixels, EXPLAINED_WIDTH);
    DEMAND(fxl_frame_begin(&state->renderer, &state->eye) == FXL_OK);
    explain_bands(state);
}

static void explain_placements(explained *state)
{
    static const fxl_point vertex = {0, 0, 0};
    const fxl_placement none = FXL_PLACEMENT_NONE;
    const fxl_q16_16 scales[] = {FXL_SCALE_MIN - 1, FXL_SCALE_MAX + 1, FXL_SCALE_MAX};
    const fxl_q16_16 places[] = {FXL_UNITS(8191), FXL_UNITS(3), FXL_UNITS(-3)};
    state->model.radius = FXL_UNITS(1);
    state->scene.vertices = &vertex;
    state->scene.vertex_count = 1;
    state->scene.models = &state->model;
    state->scene.model_count = 1;
    state->scene.instances = state->instances;
    state->scene.instance_count = state->scene.draw_list_needed = 2;
    state->scene.placements = &state->placement;
    state->scene.first_turned = 1;
    state->scene.placement_code = &fxl_turned_instances;
    state->config.target = &fxl_palette;
    state->config.palette = NULL;
    demand_config(state);
    for (uint32_t i = 0; i < 3; i++) {
        state->instances[1].centre.z = places[i];
        state->placement = none;
        demand_render(state, &state->eye, state->pixels, EXPLAINED_WIDTH);
        state->placement.orientation.x.x = 0;
        demand_render(state, &state->eye, state->pixels, EXPLAINED_WIDTH);
        state->placement.scale = scales[i];
        demand_render(state, &state->eye, state->pixels, EXPLAINED_WIDTH);
    }
}

/* What the library says of refused calls with a scene of no objects, whatever the input. */
static void demand_explained(const fxl_scene *scene)
{
    static explained state;
    memset(&state, 0, sizeof state);
    state.scene = *scene;
    state.config = fxl_config_default(EXPLAINED_WIDTH, EXPLAINED_HEIGHT);
    demand_render(&state, &state.eye, state.pixels, EXPLAINED_WIDTH); /* never initialised */
    DEMAND(fxl_render_explain(NULL, &state.eye, state.pixels, EXPLAINED_WIDTH, NULL) != NULL);
    DEMAND(fxl_frame_explain(NULL, NULL) != NULL);
    explain_arguments(&state);
    explain_lenses(&state);
    explain_targets(&state);
    explain_frames(&state, &fxl_palette);
    explain_frames(&state, &fxl_rgb565);
    explain_placements(&state);
}

enum {
    PIXELS = 4096
};

static void misuse_init(fxl_renderer *renderer, const fxl_scene *scene, const fxl_lens *lens,
                        fxl_draw_entry *order)
{
    static fxl_renderer untouched;
    const fxl_memory memory = {order, 2, NULL, 0, NULL, 0}, no_order = {NULL, 2, NULL, 0, NULL, 0},
                     no_list = {order, 2, NULL, 1, NULL, 0},
                     no_cache = {order, 2, NULL, 0, NULL, 1},
                     too_little = {order, 1, NULL, 0, NULL, 0};
    static const fxl_lens no_lens;
    const fxl_scene unchecked = {0};
    fxl_memory misplaced = memory;
    misplaced.draw_list = (fxl_draw_entry *)(void *)((uint8_t *)order + 2);
    *renderer = untouched;
    DEMAND(fxl_renderer_init_with(NULL, scene, lens, &memory) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init_with(renderer, NULL, lens, &memory) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init_with(renderer, scene, NULL, &memory) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init_with(renderer, scene, lens, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init_with(renderer, scene, lens, &no_order) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init_with(renderer, scene, lens, &no_list) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init_with(renderer, scene, lens, &no_cache) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init_with(renderer, scene, lens, &too_little) == FXL_E_CAPACITY);
    DEMAND(fxl_renderer_init_with(renderer, scene, lens, &misplaced) == FXL_E_ALIGNMENT);
    DEMAND(fxl_renderer_init_with(renderer, scene, &no_lens, &memory) == FXL_E_RANGE);
    DEMAND(fxl_renderer_init_with(renderer, &unchecked, lens, &memory) == FXL_E_ORDER);
    DEMAND(memcmp(renderer, &untouched, sizeof untouched) == 0);
    DEMAND(fxl_renderer_init_with(renderer, scene, lens, &memory) == FXL_OK);
}

/* A band of the lens's screen with one number spoilt, or none. */
static fxl_band any_band(const fxl_lens *lens, uint8_t *pixels, fuzz_input *in)
{
    fxl_band band = draw_band(lens, pixels, 0, lens->height);
    uint16_t *const numbers[] = {&band.width, &band.stride, &band.first_row, &band.rows};
    uint32_t which = fuzz_below(in, 8);
    if (which < sizeof numbers / sizeof numbers[0]) {
        *numbers[which] = (uint16_t)fuzz_any(in);
    }
    return band;
}

/* The renderer's scene has no objects, so that a legal band is not drawn into. */
static void misuse_frame(fxl_renderer *renderer, const fxl_band *band, fuzz_input *in)
{
    fxl_pose pose = fuzz_pose(in);
    fxl_band nowhere = *band, other_pixels = *band;
    static const uint16_t palette[256];
    nowhere.pixels = NULL;
    other_pixels.palette = renderer->palette == NULL ? palette : NULL;
    DEMAND(fxl_frame_begin(NULL, &pose) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_begin(renderer, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_draw(NULL, band) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_draw(renderer, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_draw(renderer, &nowhere) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_draw(renderer, band) == FXL_E_ORDER);
    DEMAND(fxl_frame_begin(renderer, &pose) == FXL_OK);
    const fxl_lens *lens = &renderer->frame.view.lens;
    bool legal = band->width == lens->width && band->stride >= band->width && band->rows >= 1 &&
                 band->first_row + band->rows <= lens->height;
    DEMAND(fxl_frame_draw(renderer, band) == (legal ? FXL_OK : FXL_E_RANGE));
    DEMAND(fxl_frame_draw(renderer, &other_pixels) == FXL_E_ORDER);
    DEMAND(renderer->workspace.counters.refused_calls == (legal ? 5u : 6u));
    pose.position.y = fuzz_any(in);
    fxl_status status = fxl_frame_begin(renderer, &pose);
    DEMAND(status == FXL_OK || status == FXL_E_RANGE);
}

static void misuse_scan(const fxl_band *band)
{
    fxl_scan scan;
    fxl_span span;
    const fxl_screen_polygon polygon = {0, 3, FXL_POLYGON_FLAT, 0, {{0, 0}}};
    bool legal = band->width >= 1 && band->width <= FXL_SCREEN_MAX && band->rows >= 1 &&
                 band->first_row + band->rows <= FXL_SCREEN_MAX;
    DEMAND(fxl_scan_begin(&polygon, band, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_scan_begin(NULL, band, &scan) == FXL_E_ARGUMENT && !fxl_scan_next(&scan, &span));
    DEMAND(fxl_scan_begin(&polygon, NULL, &scan) == FXL_E_ARGUMENT);
    DEMAND(fxl_scan_begin(&polygon, band, &scan) == (legal ? FXL_OK : FXL_E_RANGE));
    DEMAND(!fxl_scan_next(&scan, &span));
}

static void misuse_scene(void)
{
    static const fxl_point vertices[3];
    static const uint16_t corners[3];
    static const fxl_face faces[1];
    static const fxl_model models[1];
    static const fxl_instance instances[1];
    const fxl_scene whole = SCENE_OF(vertices, corners, faces, models, instances);
    fxl_scene_fault fault = {NULL, 0};
    for (int missing = 0; missing < 5; missing++) {
        fxl_scene scene = whole;
        scene.vertices = missing == 0 ? NULL : vertices;
        scene.indices = missing == 1 ? NULL : corners;
        scene.faces = missing == 2 ? NULL : faces;
        scene.models = missing == 3 ? NULL : models;
        scene.instances = missing == 4 ? NULL : instances;
        DEMAND(fxl_scene_check(&scene, &fault) == FXL_E_ARGUMENT && fault.what != NULL);
    }
    DEMAND(fxl_scene_check(NULL, &fault) == FXL_E_ARGUMENT);
    DEMAND(fxl_scene_open(NULL, 0, NULL, NULL) == FXL_E_ARGUMENT);
}

/* A clipper, a target and beams that the renderer must refuse; it keeps what it has. */
static void misuse_setters(fxl_renderer *renderer)
{
    static uint64_t room[8];
    static const fxl_beam beams[FXL_BEAMS_MAX + 1];
    static const uint8_t lit[256];
    const fxl_beam_set one = {beams, 1, lit}, no_beams = {NULL, 1, lit},
                       no_colours = {beams, 1, NULL}, none = {beams, 0, lit},
                       too_many = {beams, FXL_BEAMS_MAX + 1, lit};
    uint8_t *const crooked = (uint8_t *)room + 4;
    const fxl_renderer before = *renderer;
    DEMAND(fxl_renderer_set_clipper(NULL, &fxl_clipper_view, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_set_clipper(renderer, NULL, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_set_clipper(renderer, &fxl_clipper_once, NULL, 64) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_set_clipper(renderer, &fxl_clipper_once, crooked, 60) == FXL_E_ALIGNMENT);
    DEMAND(fxl_renderer_set_clipper(renderer, &fxl_clipper_once, room, 64) == FXL_E_CAPACITY);
    DEMAND(draw_choose(NULL, &fxl_palette, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(draw_choose(renderer, NULL, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(draw_choose(renderer, &fxl_palette_spans, NULL, UINT32_MAX) == FXL_E_ARGUMENT);
    DEMAND(draw_choose(renderer, &fxl_palette_spans, room, 8) == FXL_E_CAPACITY);
    DEMAND(fxl_renderer_set_centre(NULL, 0, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_set_centre(renderer, INT32_MAX, 0) == FXL_E_RANGE);
    DEMAND(fxl_renderer_set_centre(renderer, before.frame.view.lens.centre_x,
                                   before.frame.view.lens.centre_y) == FXL_OK);
    DEMAND(fxl_attach_beams(NULL, &one, room, 64) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_beams(renderer, &no_beams, room, 64) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_beams(renderer, &no_colours, room, 64) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_beams(renderer, &one, NULL, 64) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_beams(renderer, &one, crooked, 60) == FXL_E_ALIGNMENT);
    DEMAND(fxl_attach_beams(renderer, &one, room, 64) == FXL_E_COUNT);
    DEMAND(fxl_attach_beams(renderer, &too_many, room, 64) == FXL_E_COUNT);
    DEMAND(fxl_attach_beams(renderer, &none, room, 64) == FXL_E_COUNT);
    DEMAND(before.clipper == renderer->clipper && before.target == renderer->target &&
           before.order == renderer->order && before.shader == renderer->shader);
    DEMAND(fxl_attach_beams(renderer, NULL, NULL, 0) == FXL_OK);
}

static void misuse_wire(const fxl_scene *scene, const fxl_lens *lens, const fxl_band *band)
{
    static fxl_wire wire;
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0}, far_away = {{INT32_MAX, 0, 0}, 0, 0, 0};
    fxl_band nowhere = *band;
    nowhere.pixels = NULL;
    DEMAND(fxl_wire_init(NULL, scene, lens, fxl_line_by_planes) == FXL_E_ARGUMENT);
    DEMAND(fxl_wire_init(&wire, NULL, lens, fxl_line_by_planes) == FXL_E_ARGUMENT);
    DEMAND(fxl_wire_init(&wire, scene, NULL, fxl_line_by_planes) == FXL_E_ARGUMENT);
    DEMAND(fxl_wire_init(&wire, scene, lens, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_wire_init(&wire, scene, lens, fxl_line_by_planes) == FXL_OK);
    DEMAND(fxl_wire_draw(&wire, band) == FXL_E_ORDER);
    DEMAND(fxl_wire_begin(NULL, &pose) == FXL_E_ARGUMENT);
    DEMAND(fxl_wire_begin(&wire, &far_away) == FXL_E_RANGE);
    DEMAND(fxl_wire_begin(&wire, &pose) == FXL_OK);
    DEMAND(fxl_wire_draw(NULL, band) == FXL_E_ARGUMENT);
    DEMAND(fxl_wire_draw(&wire, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_wire_draw(&wire, &nowhere) == FXL_E_ARGUMENT);
    bool legal = band->width == lens->width && band->stride >= band->width && band->rows >= 1 &&
                 band->first_row + band->rows <= lens->height;
    DEMAND(fxl_wire_draw(&wire, band) == (legal ? FXL_OK : FXL_E_RANGE));
}

void fuzz_misuse(fuzz_input *in)
{
    static fxl_renderer renderer;
    uint8_t pixels[1] = {0x5A};
    fxl_draw_entry order[2];
    fxl_scene empty = {0};
    fxl_camera camera;
    fxl_player viewer = {0};
    fxl_motion_limits motion_limits = {0};
    fxl_pose pose = {0};
    fxl_lens lens = fuzz_lens(in, PIXELS);
    fxl_band band = any_band(&lens, pixels, in);
    empty.draw_list_needed = 2;
    misuse_init(&renderer, &empty, &lens, order);
    misuse_frame(&renderer, &band, in);
    misuse_scan(&band);
    misuse_scene();
    misuse_setters(&renderer);
    misuse_wire(&empty, &lens, &band);
    demand_explained(&empty);
    DEMAND(fxl_camera_from_pose(NULL, &camera) == FXL_E_ARGUMENT);
    DEMAND(fxl_camera_from_pose(&pose, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_player_step(NULL, 0, &motion_limits, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_player_step(&viewer, 0, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_lens_from_fov(1, 1, FXL_FOV_MIN, 256, 257, 0, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_lens_set_centre(NULL, 0, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_lens_of_part(NULL, 0, 0, 1, 1, &lens) == FXL_E_ARGUMENT);
    DEMAND(fxl_lens_of_part(&lens, 0, 0, 1, 1, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_lens_from_window(1, -1, 1, -1, 1, 256, 512, NULL) == FXL_E_ARGUMENT);
    DEMAND(pixels[0] == 0x5A);
}
