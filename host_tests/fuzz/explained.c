/* SPDX-License-Identifier: MIT */
/* Sentences about refused calls: there is one about each call that is refused, and none about
 * another. */
#include <string.h>

#include "demand.h"
#include "stages.h"

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

/* place pixel-format: random input */
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

void fuzz_explained(const fxl_scene *scene)
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
