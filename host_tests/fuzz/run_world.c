/* SPDX-License-Identifier: MIT */
/* A world over any scene, changed in any way and drawn between changes, in any light; and that light,
 * for any renderer. */
#include <string.h>

#include "answers.h"
#include "parts.h"
#include "input.h"

static fxl_q2_30 any_fraction(fuzz_input *in)
{
    return fuzz_below(in, 16) ? fuzz_between(in, 0, FXL_Q2_30_ONE) : fuzz_any(in);
}

/* place light: a new setting: random settings */
static fxl_light_settings any_settings(fuzz_input *in)
{
    fxl_light_settings made;
    fxl_camera camera;
    const fxl_pose pose = fuzz_pose(in);
    DEMAND(fxl_camera_from_pose(&pose, &camera) == FXL_OK);
    memset(&made, 0, sizeof made);
    made.ambient = any_fraction(in);
    made.strength = fuzz_below(in, 2) ? any_fraction(in) : 0;
    made.direction = camera.axes.forward;
    if (fuzz_below(in, 16) == 0) {
        made.direction.y = fuzz_any(in);
    }
    made.point_count = fuzz_below(in, FXL_LIGHT_POINTS_MAX + 2);
    for (uint32_t i = 0; i < made.point_count && i < FXL_LIGHT_POINTS_MAX; i++) {
        made.points[i].position = fuzz_point(in, FXL_COORDINATE_MAX);
        made.points[i].range =
            fuzz_below(in, 16) ? fuzz_between(in, 1, FXL_COORDINATE_MAX) : fuzz_any(in);
        made.points[i].strength = any_fraction(in);
    }
    if (fuzz_below(in, 2)) {
        made.fog_near = fuzz_below(in, 8) ? fuzz_between(in, 0, 20 * 65536) : fuzz_any(in);
        made.fog_far = fuzz_below(in, 8) ? fuzz_between(in, 20 * 65536, FXL_FAR_MAX) : fuzz_any(in);
    }
    made.levels = fuzz_below(in, 8) ? 2 + fuzz_below(in, 5) : fuzz_below(in, 70);
    return made;
}

/* Level 0 of colour c is black's entry; the top level is c. */
static void demand_ramp(const fxl_light_settings *settings, uint8_t *ramp, fuzz_input *in)
{
    static const uint8_t black[3] = {0, 0, 0};
    static uint8_t palette[768];
    for (int i = 3; i < 768; i++) {
        palette[i] = (uint8_t)fuzz_bits(in, i < 30 ? 1 : 0);
    }
    const fxl_status status = fxl_light_make_ramp(palette, black, settings->levels, ramp);
    DEMAND((status == FXL_OK) ==
           (settings->levels >= FXL_LIGHT_LEVELS_MIN && settings->levels <= FXL_LIGHT_LEVELS_MAX));
    record_bytes(ramp, status == FXL_OK ? FXL_LIGHT_RAMP_BYTES(settings->levels) : 0);
    for (uint32_t i = 0; status == FXL_OK && i < 256; i++) {
        DEMAND(ramp[i] == 0 && ramp[256 * (settings->levels - 1) + i] == i);
    }
    DEMAND(fxl_light_make_ramp(NULL, black, 4, ramp) == FXL_E_ARGUMENT);
    DEMAND(fxl_light_make_ramp(palette, NULL, 4, ramp) == FXL_E_ARGUMENT);
    DEMAND(fxl_light_make_ramp(palette, black, 4, NULL) == FXL_E_ARGUMENT);
}

/* Of any ramp, its colours: those of the input before are gone. */
static uint8_t *fresh_ramp(void)
{
    static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(FXL_LIGHT_LEVELS_MAX)];
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)(i * 37 + (i >> 8));
    }
    return ramp;
}

void fuzz_set_light(fxl_renderer *renderer, fxl_light *light, fuzz_input *in)
{
    uint8_t *const ramp = fresh_ramp();
    static fxl_renderer none;
    fxl_light_settings settings = any_settings(in);
    const fxl_light before = *light;
    const fxl_shader *const shader = renderer->shader;
    DEMAND(fxl_attach_light(renderer, light, &settings) == FXL_E_ARGUMENT);
    settings.ramp = ramp;
    if (fuzz_below(in, 4) == 0) {
        demand_ramp(&settings, ramp, in);
    }
    DEMAND(fxl_attach_light(NULL, light, &settings) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_light(renderer, NULL, &settings) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_light(&none, light, &settings) == FXL_E_ORDER);
    if (fxl_attach_light(renderer, light, &settings) != FXL_OK) {
        DEMAND(memcmp(&before, light, sizeof before) == 0 && renderer->shader == shader);
        DEMAND(fxl_attach_light(renderer, NULL, NULL) == FXL_OK);
    }
}

enum {
    PIXELS = 1024,
    MORE = 4, /* places beyond the scene's instances */
    PLACES = MADE_INSTANCES + 2 * MORE,
    PLACEMENTS = MADE_INSTANCES + MORE,
    LIST = 256,
    STEPS = 120
};

typedef struct {
    fxl_world world;
    fxl_instance instances[PLACES];
    fxl_placement placements[PLACEMENTS];
    fxl_world_slot slots[PLACES];
    uint8_t colours[2 * 256];
    fxl_handle handles[PLACES];
} any_world;

static fxl_placement any_placement(fuzz_input *in)
{
    fxl_camera camera;
    fxl_placement placement;
    fxl_pose pose = fuzz_pose(in);
    DEMAND(fxl_camera_from_pose(&pose, &camera) == FXL_OK);
    placement.orientation.x = camera.axes.right;
    placement.orientation.y = camera.axes.up;
    placement.orientation.z = camera.axes.forward;
    if (fuzz_below(in, 8) == 0) {
        fxl_direction *rows = &placement.orientation.x;
        fxl_direction *const row = &rows[fuzz_below(in, 3)];
        row->x = fuzz_any(in);
    }
    placement.scale = fuzz_below(in, 4) ? fuzz_between(in, 256, 4 * 65536) : fuzz_any(in);
    return placement;
}

static fxl_instance any_instance(fuzz_input *in)
{
    fxl_instance instance;
    memset(&instance, 0, sizeof instance);
    instance.centre = fuzz_point(in, FXL_COORDINATE_MAX);
    instance.model = (uint16_t)fuzz_below(in, MADE_MODELS + 1);
    instance.layer = (uint8_t)fuzz_below(in, 3);
    instance.recolour = fuzz_below(in, 16) == 0;
    return instance;
}

/* One change, by a handle that was given at some time. */
static fxl_status change(any_world *of, fuzz_input *in)
{
    fxl_handle *handle = &of->handles[fuzz_below(in, PLACES)];
    const fxl_instance instance = any_instance(in);
    const uint32_t what = fuzz_below(in, 10);
    const fxl_placement placement = any_placement(in);
    const fxl_placement *const or_none = fuzz_below(in, 2) ? &placement : NULL;
    switch (what) {
    case 0:
        return fxl_world_remove(&of->world, *handle);
    case 1:
        return fxl_world_hide(&of->world, *handle);
    case 2:
        return fxl_world_show(&of->world, *handle);
    case 3:
        return fxl_world_move(&of->world, *handle, &instance.centre);
    case 4:
        return fxl_world_set_placement(&of->world, *handle, or_none);
    case 5:
        return fxl_world_set_model(&of->world, *handle, instance.model);
    case 6:
        return fxl_world_set_layer(&of->world, *handle, instance.layer);
    case 7:
        return fxl_world_recolour(&of->world, *handle, fuzz_below(in, 4));
    default:
        return fxl_world_spawn(&of->world, &instance, or_none, handle);
    }
}

/* What is refused changes nothing but the count. */
static void demand_change(any_world *of, fuzz_input *in)
{
    static any_world before;
    before = *of;
    const fxl_status status = change(of, in);
    record_number(status);
    if (status != FXL_OK) {
        before.world.refused_calls += 1;
        DEMAND(memcmp(&before, of, sizeof before) == 0);
    }
    const fxl_scene *scene = &of->world.scene;
    DEMAND(scene->instances >= of->instances &&
           scene->instances + scene->instance_count <= of->instances + PLACES);
    for (int i = 0; i < PLACES; i++) {
        const fxl_instance *found = fxl_world_instance(&of->world, of->handles[i]);
        const bool in_scene =
            found >= scene->instances && found < scene->instances + scene->instance_count;
        DEMAND(found == NULL || in_scene == fxl_world_is_shown(&of->world, of->handles[i]));
        if (in_scene) {
            const fxl_handle handle =
                fxl_world_handle_at(&of->world, (uint32_t)(found - scene->instances));
            DEMAND(memcmp(&handle, &of->handles[i], sizeof handle) == 0);
        }
        DEMAND(found != NULL || fxl_world_placement(&of->world, of->handles[i]) == NULL);
    }
}

/* The places of the instances that may be moved. Two handles may be of one. */
static void find_places(any_world *of, fxl_point *at, bool *may_move)
{
    for (uint32_t i = 0; i < PLACES; i++) {
        const fxl_instance *found = fxl_world_instance(&of->world, of->handles[i]);
        may_move[i] = false;
        if (found != NULL) {
            at[i] = found->centre;
            may_move[i] = fxl_world_move(&of->world, of->handles[i], &at[i]) == FXL_OK;
        }
    }
}

static void move_all(any_world *of, const fxl_point *at, const bool *may_move, fxl_q16_16 step)
{
    for (uint32_t i = 0; i < PLACES; i++) {
        if (may_move[i]) {
            const fxl_point centre = {at[i].x, at[i].y + step, at[i].z};
            (void)fxl_world_move(&of->world, of->handles[i], &centre);
        }
    }
}

/* Draws the frame of a pose whole, and what changed over the frame before it: both are the same. */
static void demand_boxes(fxl_changed *changed, fxl_renderer *renderer, const fxl_pose *pose,
                         uint8_t *built)
{
    static uint8_t pixels[PIXELS];
    const fxl_lens *lens = &renderer->frame.view.lens;
    const fxl_band band = draw_band(lens, pixels, 0, lens->height);
    DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
    DEMAND(fxl_changed_find(changed, renderer) == FXL_OK);
    fxl_fill_band(&band, DRAW_BACKGROUND);
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    draw_changed_boxes(renderer, changed, built, DRAW_BACKGROUND);
    DEMAND(memcmp(pixels, built, (size_t)lens->width * lens->height) == 0);
    DEMAND(fxl_frame_end(renderer) == FXL_OK);
}

/* A picture that is built up from boxes while the instances move. It leaves the world as it was. */
static void demand_changes(any_world *of, fxl_renderer *renderer, const fxl_pose *pose)
{
    static uint64_t kept[FXL_CHANGED_MEMORY(PLACES, PLACEMENTS, 0, 0)];
    static uint8_t built[PIXELS];
    static fxl_point at[PLACES];
    static bool may_move[PLACES];
    fxl_changed changed;
    DEMAND(fxl_changed_init(&changed, kept, sizeof kept) == FXL_OK);
    find_places(of, at, may_move);
    for (int i = 0; i < 3; i++) {
        demand_boxes(&changed, renderer, pose, built);
        DEMAND(i != 0 || changed.whole);
        move_all(of, at, may_move, i == 0 ? 4000 : 0);
    }
    DEMAND(changed.count <= FXL_CHANGED_BOXES_MAX);
}

static void demand_frame(any_world *of, fxl_renderer *renderer, fuzz_input *in)
{
    static uint8_t pixels[PIXELS];
    const fxl_lens *lens = &renderer->frame.view.lens;
    const fxl_band band = draw_band(lens, pixels, 0, lens->height);
    const fxl_pose pose = fuzz_pose(in);
    memset(pixels, 0, sizeof pixels); /* else a record depends on the input before */
    DEMAND(fxl_frame_begin(renderer, &pose) == FXL_OK);
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    DEMAND(fxl_frame_end(renderer) == FXL_OK);
    DEMAND(renderer->workspace.counters.in == draw_model_view(renderer->scene));
    record_band(&band);
    record_bytes(&renderer->workspace.counters, sizeof renderer->workspace.counters);
    demand_changes(of, renderer, &pose);
}

/* A frame that is released stays as it is, whatever changes. */
static void demand_release(any_world *of, fxl_renderer *renderer, fuzz_input *in)
{
    static uint8_t pixels[2][PIXELS];
    const fxl_lens *lens = &renderer->frame.view.lens;
    for (int i = 0; i < 2; i++) {
        const fxl_band band = draw_band(lens, pixels[i], 0, lens->height);
        memset(pixels[i], 0, sizeof pixels[i]);
        DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
        if (i == 0 && fxl_frame_release_scene(renderer) != FXL_OK) {
            return;
        }
        demand_change(of, in);
    }
    DEMAND(memcmp(pixels[0], pixels[1], sizeof pixels[0]) == 0);
}

/* Calls without a world, or without what they need. */
static void misuse_world(fxl_world *world, fxl_renderer *renderer)
{
    const fxl_handle handle = fxl_world_handle(0);
    const fxl_point centre = {0, 0, 0};
    const fxl_instance instance = {{0, 0, 0}, 0, 0, 0};
    fxl_handle made;
    const uint32_t refused = world->refused_calls;
    DEMAND(fxl_world_spawn(NULL, &instance, NULL, &made) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_spawn(world, NULL, NULL, &made) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_spawn(world, &instance, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_remove(NULL, handle) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_hide(NULL, handle) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_show(NULL, handle) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_move(NULL, handle, &centre) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_move(world, handle, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_set_placement(NULL, handle, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_set_model(NULL, handle, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_set_layer(NULL, handle, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_recolour(NULL, handle, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_attach(NULL, renderer) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_attach(world, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_detach(NULL, renderer) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_detach(world, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_set_colours(NULL, renderer, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_end(NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_frame_release_scene(NULL) == FXL_E_ARGUMENT);
    const fxl_handle none[] = {fxl_world_handle_at(NULL, 0),
                               fxl_world_handle_at(world, world->scene.instance_count),
                               fxl_world_handle_at(world, FXL_PICK_NONE)};
    for (int i = 0; i < 3; i++) {
        DEMAND(fxl_world_instance(world, none[i]) == NULL);
    }
    DEMAND(world->refused_calls == refused + 5);
}

static void play(any_world *of, const fxl_lens *lens, fuzz_input *in)
{
    static fxl_renderer renderer;
    static fxl_world_colours colours;
    static fxl_draw_entry order[PLACES + MADE_FACES];
    static uint32_t list[LIST];
    static fxl_light light;
    const fxl_memory memory = {order, PLACES + MADE_FACES, list, fuzz_below(in, LIST), NULL, 0};
    DEMAND(fxl_renderer_init_with(&renderer, &of->world.scene, lens, &memory) == FXL_OK);
    DEMAND(fxl_world_set_colours(&of->world, &renderer, &colours) == FXL_E_INDEX);
    DEMAND(fxl_world_attach(&of->world, &renderer) == FXL_OK);
    if (fuzz_below(in, 2)) {
        DEMAND(fxl_world_set_colours(&of->world, &renderer, &colours) == FXL_OK);
    }
    for (int i = 0; i < STEPS && in->left > 0; i++) {
        const uint32_t what = fuzz_below(in, 8);
        if (what == 0) {
            if (fuzz_below(in, 4) == 0) {
                fuzz_set_light(&renderer, &light, in);
            }
            demand_frame(of, &renderer, in);
        } else if (what == 1) {
            const fxl_pose pose = fuzz_pose(in);
            DEMAND(fxl_frame_begin(&renderer, &pose) == FXL_OK);
            DEMAND(change(of, in) != FXL_OK);
            demand_release(of, &renderer, in);
            DEMAND(fxl_frame_end(&renderer) == FXL_OK);
        } else {
            demand_change(of, in);
        }
    }
    demand_frame(of, &renderer, in);
    DEMAND(fxl_world_detach(&of->world, &renderer) == FXL_OK);
    DEMAND(fxl_world_detach(&of->world, &renderer) == FXL_E_INDEX);
    misuse_world(&of->world, &renderer);
}

/* Squares that are seen from both sides: of a convex model, and of a sorted one that may have a
 * tree. */
static fxl_scene squares(bool with_tree)
{
    enum {
        SIDE = 65536
    };
    static const fxl_point vertices[8] = {{-SIDE, -SIDE, 0}, {-SIDE, SIDE, 0},  {SIDE, SIDE, 0},
                                          {SIDE, -SIDE, 0},  {-SIDE, -SIDE, 0}, {-SIDE, SIDE, 0},
                                          {SIDE, SIDE, 0},   {SIDE, -SIDE, 0}};
    static const uint16_t indices[8] = {0, 1, 2, 3, 3, 2, 1, 0};
    static const fxl_face faces[4] = {{{0, 0, -FXL_Q2_30_ONE}, 4, 1, FXL_INDICES_AT(0, 0)},
                                      {{0, 0, FXL_Q2_30_ONE}, 4, 2, FXL_INDICES_AT(3, 4)},
                                      {{0, 0, -FXL_Q2_30_ONE}, 4, 3, FXL_INDICES_AT(0, 0)},
                                      {{0, 0, FXL_Q2_30_ONE}, 4, 4, FXL_INDICES_AT(3, 4)}};
    static const fxl_model models[2] = {{0, 4, 0, 2, FXL_MODEL_CONVEX, 0, 0, 2 * SIDE, 0},
                                        {4, 4, 2, 2, FXL_MODEL_SORTED, 0, 0, 2 * SIDE, 0}};
    static const fxl_instance instances[3] = {
        {{0, 0, 5 * SIDE}, 0, 0, 0}, {{0, 0, 7 * SIDE}, 1, 0, 0}, {{SIDE, 0, 6 * SIDE}, 0, 1, 0}};
    static const fxl_bsp_node node = {{0, 0, FXL_Q2_30_ONE},
                                      0,
                                      0,
                                      FXL_BSP_NONE,
                                      FXL_BSP_NONE,
                                      FXL_BSP_NONE,
                                      0,
                                      2,
                                      0,
                                      {0, 0, 0},
                                      2 * SIDE};
    fxl_scene scene = SCENE_OF(vertices, indices, faces, models, instances);
    if (with_tree) {
        scene.bsp_nodes = &node;
        scene.bsp_node_count = 1;
        scene.bsp_instance = 1;
    }
    return scene;
}

/* Memory that is refused. */
static void misuse_init(const fxl_scene *scene, const fxl_world_memory *sound)
{
    static fxl_world world;
    fxl_world_memory memory = *sound;
    DEMAND(fxl_world_init(NULL, scene, &memory) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_init(&world, NULL, &memory) == FXL_E_ARGUMENT);
    DEMAND(fxl_world_init(&world, scene, NULL) == FXL_E_ARGUMENT);
    memory.instances = NULL;
    DEMAND(fxl_world_init(&world, scene, &memory) == FXL_E_ARGUMENT);
    memory = *sound;
    memory.slots = NULL;
    DEMAND(fxl_world_init(&world, scene, &memory) == FXL_E_ARGUMENT);
    memory.slots = (fxl_world_slot *)((uintptr_t)sound->slots + 2);
    DEMAND(fxl_world_init(&world, scene, &memory) == FXL_E_ALIGNMENT);
    memory = *sound;
    memory.turned_capacity = 1;
    memory.placements = NULL;
    DEMAND(fxl_world_init(&world, scene, &memory) == FXL_E_ARGUMENT);
    memory.placements = (fxl_placement *)((uintptr_t)sound->placements + 2);
    DEMAND(fxl_world_init(&world, scene, &memory) == FXL_E_ALIGNMENT);
    memory.placements = sound->placements;
    memory.placement_code = NULL;
    DEMAND(fxl_world_init(&world, scene, &memory) == FXL_E_ARGUMENT);
    memory = *sound;
    memory.colours = NULL;
    DEMAND(fxl_world_init(&world, scene, &memory) == FXL_E_ARGUMENT);
    memory = *sound;
    memory.colour_count = UINT8_MAX + 1;
    DEMAND(fxl_world_init(&world, scene, &memory) == FXL_E_COUNT);
    memory.colour_count = 2;
    memory.capacity = FXL_SCENE_INSTANCES_MAX + 1;
    DEMAND(fxl_world_init(&world, scene, &memory) == FXL_E_COUNT);
}

/* The scene is the fuzzer's, or, if it is not in order, one of the two above. */
void fuzz_world(fuzz_input *in)
{
    static any_world of;
    const fxl_lens lens = fuzz_lens(in, PIXELS);
    const uint32_t more = fuzz_below(in, 8), turned = fuzz_below(in, MORE + 1);
    const uint32_t which = fuzz_below(in, 4);
    made_scene *made = make_scene(in);
    fxl_scene scene = made->scene;
    memset(&of, 0, sizeof of);
    for (int i = 0; i < 512; i++) {
        of.colours[i] = (uint8_t)(i * 7);
    }
    for (uint32_t i = 0; i < PLACES; i++) {
        of.handles[i] = fxl_world_handle(i);
    }
    scene.draw_list_needed = 0;
    fxl_world_memory memory = {of.instances, of.slots, of.placements,        1, turned,
                               of.colours,   2,        &fxl_turned_instances};
    DEMAND(fxl_world_init(&of.world, &scene, &memory) == FXL_E_ORDER);
    memory.instances = (fxl_instance *)((uintptr_t)of.instances + 1 + more % 3);
    DEMAND(fxl_world_init(&of.world, &scene, &memory) == FXL_E_ALIGNMENT);
    memory.instances = of.instances;
    if (which < 2 || fxl_scene_check_all(&scene, NULL) != FXL_OK) {
        scene = squares(which == 0);
        DEMAND(fxl_scene_check_all(&scene, NULL) == FXL_OK);
    }
    memory.capacity = more > MORE ? more - MORE - 1 : scene.instance_count + more;
    misuse_init(&scene, &memory);
    const fxl_status status = fxl_world_init(&of.world, &scene, &memory);
    DEMAND(status == FXL_OK || status == FXL_E_COUNT || status == FXL_E_CAPACITY);
    if (status == FXL_OK) {
        play(&of, &lens, in);
    }
    free_scene(made);
}
