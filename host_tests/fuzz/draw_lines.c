/* SPDX-License-Identifier: MIT */
/* Lines over any scene, with an eye and without one, and a world over it that is drawn by the boxes
 * of what changed. What is attached, and what changes, is chosen by the bytes that are left of the
 * input, of which none is taken; nothing is recorded. */
#include <string.h>

#include "answers.h"
#include "parts.h"

enum {
    LINES = 8, /* of a model */
    LIST = 2048,
    MORE = 3, /* places beyond the scene's instances */
    CHANGES = 24,
    PLACES = 2 * (MADE_INSTANCES + MORE),
    SPANS = 1 << 16
};

/* --- chance ----------------------------------------------------------------------------------- */

static uint64_t state;

static void mix(const void *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        state = (state ^ ((const uint8_t *)bytes)[i]) * 1099511628211u;
    }
}

static uint32_t any(uint32_t count)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return count > 0 ? (uint32_t)(state >> 33) % count : 0;
}

static bool one_in(uint32_t count)
{
    return any(count) == 0;
}

/* --- lines ------------------------------------------------------------------------------------ */

typedef struct {
    fxl_line lines[LINES * MADE_MODELS];
    uint32_t map[MADE_MODELS + 1];
    fxl_line_set set;
    fxl_lines attached;
} some_lines;

/* An edge on one face or two, a free line, or a point. */
static fxl_line any_line(const fxl_scene *scene, const fxl_model *model)
{
    fxl_line line = {.from = (uint16_t)any(model->vertex_count),
                     .to = (uint16_t)any(model->vertex_count),
                     .colour = (uint8_t)any(256),
                     .width = (uint8_t)(1 + any(one_in(2) ? 2 : FXL_LINE_WIDTH_MAX))};
    if (model->face_count > 0 && !one_in(3)) {
        const uint32_t number = any(model->face_count);
        const fxl_face *face = &scene->faces[model->first_face + number];
        const uint16_t *corners = fxl_face_indices(scene->indices, face);
        const uint32_t k = any(face->count);
        line.from = corners[k];
        line.to = corners[(k + 1) % face->count];
        line.faces[any(2)] = (uint16_t)(number + 1);
        if (one_in(2)) {
            line.faces[any(2)] = (uint16_t)(any(model->face_count) + 1);
        }
    }
    if (one_in(5)) {
        line.to = line.from;
    }
    return line;
}

static void make_lines(some_lines *made, const fxl_scene *scene)
{
    uint32_t count = 0;
    memset(made, 0, sizeof *made);
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const fxl_model *model = &scene->models[i];
        made->map[i] = count;
        for (uint32_t k = any(8) == 0 ? LINES : 2; k < LINES && model->vertex_count > 0; k++) {
            made->lines[count++] = any_line(scene, model);
        }
    }
    made->map[scene->model_count] = count;
    made->set = (fxl_line_set){made->lines, count, made->map};
}

/* Sets of lines that are refused. */
static void misuse_lines(fxl_renderer *renderer, some_lines *made)
{
    static fxl_renderer none;
    const fxl_scene *scene = renderer->scene;
    fxl_lines *lines = &made->attached;
    fxl_line_set set = made->set;
    uint32_t map[MADE_MODELS + 1];
    DEMAND(fxl_attach_lines(NULL, lines, &set) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_lines(&none, lines, &set) == FXL_E_ORDER);
    DEMAND(fxl_attach_lines(renderer, NULL, &set) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_lines(renderer, (fxl_lines *)(void *)((uint8_t *)lines + 4), &set) ==
           FXL_E_ALIGNMENT);
    DEMAND(fxl_attach_lines(renderer, NULL, NULL) == FXL_OK);
    DEMAND(fxl_lines_check(NULL, scene, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_lines_check(&set, NULL, NULL) == FXL_E_ARGUMENT);
    set.line_map = NULL;
    DEMAND(fxl_lines_check(&set, scene, NULL) == FXL_E_ARGUMENT);
    set.line_map = (const uint32_t *)(const void *)((const uint8_t *)made->map + 2);
    DEMAND(fxl_lines_check(&set, scene, NULL) == FXL_E_ALIGNMENT);
    set = made->set;
    set.lines = (const fxl_line *)(const void *)((const uint8_t *)made->lines + 1);
    DEMAND(fxl_lines_check(&set, scene, NULL) == FXL_E_ALIGNMENT);
    set = made->set;
    set.count = FXL_SCENE_FACES_MAX + 1;
    DEMAND(fxl_lines_check(&set, scene, NULL) == FXL_E_COUNT);
    set.count = made->set.count + 1;
    DEMAND(fxl_lines_check(&set, scene, NULL) == FXL_E_COUNT);
    set.lines = NULL;
    DEMAND(fxl_lines_check(&set, scene, NULL) == FXL_E_ARGUMENT);
    set = made->set;
    memcpy(map, made->map, sizeof map);
    set.line_map = map;
    map[0] = 1;
    DEMAND(fxl_lines_check(&set, scene, NULL) == FXL_E_COUNT);
    map[0] = 0;
    if (scene->model_count > 1) {
        map[1] = set.count + 1;
        DEMAND(fxl_lines_check(&set, scene, NULL) == FXL_E_COUNT);
        map[1] = set.count;
        map[2] = scene->model_count > 2 && set.count > 0 ? set.count - 1 : set.count;
        const fxl_status status = fxl_lines_check(&set, scene, NULL);
        DEMAND(map[2] == set.count || status != FXL_OK);
    }
    if (set.count > 0) {
        fxl_line *line = &made->lines[any(set.count)];
        const fxl_line kept = *line;
        line->reserved = 1;
        DEMAND(fxl_lines_check(&made->set, scene, NULL) == FXL_E_RESERVED);
        *line = kept;
        line->width = (uint8_t)(one_in(2) ? 0 : FXL_LINE_WIDTH_MAX + 1);
        DEMAND(fxl_lines_check(&made->set, scene, NULL) == FXL_E_RANGE);
        *line = kept;
        uint16_t *const members[] = {&line->from, &line->to, &line->faces[0], &line->faces[1]};
        *members[any(4)] = UINT16_MAX;
        DEMAND(fxl_lines_check(&made->set, scene, NULL) == FXL_E_INDEX);
        *line = kept;
    }
    DEMAND(fxl_lines_check(&made->set, scene, NULL) == FXL_OK);
}

/* --- lines of the world ----------------------------------------------------------------------- */

static fxl_q16_16 clamped(int64_t x)
{
    return (fxl_q16_16)(x > FXL_COORDINATE_MAX    ? FXL_COORDINATE_MAX
                        : x < -FXL_COORDINATE_MAX ? -FXL_COORDINATE_MAX
                                                  : x);
}

/* A point before the eye, mostly, so far away and beside it. */
static fxl_point any_point(const fxl_view *view)
{
    const fxl_axes *axes = &view->camera.axes;
    const fxl_point *eye = &view->camera.position;
    const int64_t away = (int64_t)any(1u << (8 + any(16))) - (one_in(5) ? 65536 : 0);
    const int64_t x = away * ((int32_t)any(401) - 200) / 100,
                  y = away * ((int32_t)any(401) - 200) / 100, z = away + view->lens.near_z;
    const int64_t one = FXL_Q2_30_ONE;
    const fxl_point point = {
        clamped(eye->x + (x * axes->right.x + y * axes->up.x + z * axes->forward.x) / one),
        clamped(eye->y + (x * axes->right.y + y * axes->up.y + z * axes->forward.y) / one),
        clamped(eye->z + (x * axes->right.z + y * axes->up.z + z * axes->forward.z) / one)};
    return point;
}

static void draw_world_lines(fxl_renderer *renderer, const fxl_band *band, bool has_eye)
{
    const fxl_view *view = &renderer->frame.view;
    fxl_world_line line;
    for (uint32_t i = 0; i < 24; i++) {
        line = (fxl_world_line){any_point(view), any_point(view), (uint8_t)any(256),
                                (uint8_t)(1 + any(FXL_LINE_WIDTH_MAX))};
        if (one_in(5)) {
            line.to = line.from;
        }
        DEMAND(fxl_frame_draw_line(renderer, NULL, &line, band) ==
               (has_eye ? FXL_OK : FXL_E_COMBINATION));
    }
    if (has_eye) {
        fxl_band other = *band;
        if (band->palette != NULL) {
            other.pixels++;
            DEMAND(fxl_frame_draw_line(renderer, NULL, &line, &other) == FXL_E_ALIGNMENT);
            other.pixels--;
            other.palette = NULL;
            DEMAND(fxl_frame_draw_line(renderer, NULL, &line, &other) == FXL_E_ORDER);
        }
        DEMAND(fxl_frame_draw_line(NULL, NULL, &line, band) == FXL_E_ARGUMENT);
        DEMAND(fxl_frame_draw_line(renderer, NULL, NULL, band) == FXL_E_ARGUMENT);
        DEMAND(fxl_frame_draw_line(renderer, NULL, &line, NULL) == FXL_E_ARGUMENT);
        other.pixels = NULL;
        DEMAND(fxl_frame_draw_line(renderer, NULL, &line, &other) == FXL_E_ARGUMENT);
        other = *band;
        other.width++;
        DEMAND(fxl_frame_draw_line(renderer, NULL, &line, &other) == FXL_E_RANGE);
        other = *band;
        other.rows++;
        DEMAND(fxl_frame_draw_line(renderer, NULL, &line, &other) == FXL_E_RANGE);
        line.width = (uint8_t)(one_in(2) ? 0 : FXL_LINE_WIDTH_MAX + 1);
        DEMAND(fxl_frame_draw_line(renderer, NULL, &line, band) == FXL_E_RANGE);
        line.width = 1;
        fxl_q16_16 *const ends[] = {&line.from.x, &line.from.y, &line.from.z,
                                    &line.to.x,   &line.to.y,   &line.to.z};
        *ends[any(6)] = FXL_COORDINATE_MAX + 1;
        DEMAND(fxl_frame_draw_line(renderer, NULL, &line, band) == FXL_E_RANGE);
    }
}

/* --- frames ----------------------------------------------------------------------------------- */

typedef struct {
    fxl_renderer renderer;
    some_lines lines;
    draw_parts parts;
    fxl_outlines outlines;
    const fxl_target *target;
    void *order, *depth, *tree, *beams, *list;
    uint16_t palette[256];
    uint32_t depth_size, tree_size, beams_size;
} some_frame;

/* Pixels of the frame: whole, and in bands with a list; the same. No frame, where things do not go
 * together. */
static void draw_frame(some_frame *of, const fxl_pose *pose, bool has_eye)
{
    fxl_renderer *renderer = &of->renderer;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const uint32_t bytes = of->target->pixel_bits / 8u;
    const size_t size = (size_t)lens->width * lens->height * bytes;
    fxl_band band = draw_band(lens, draw_memory(size), 0, lens->height);
    uint8_t *parts = draw_memory(size);
    const char *names[2];
    band.palette = bytes == 2 ? of->palette : NULL;
    renderer->frame.display_list.capacity = 0;
    const fxl_status status = fxl_frame_begin(renderer, pose);
    DEMAND(status == FXL_OK || fxl_renderer_conflict(renderer, names));
    if (status == FXL_OK) {
        fxl_frame_fill(renderer, &band, DRAW_BACKGROUND);
        DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
        renderer->frame.display_list.words = of->list;
        renderer->frame.display_list.capacity = one_in(2) ? LIST : any(200);
        DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
        const uint32_t step = 1 + any(lens->height);
        for (uint32_t row = 0, rows; row < lens->height; row += rows) {
            rows = step < lens->height - row ? step : lens->height - row;
            fxl_band part = draw_band(lens, parts + row * lens->width * bytes, row, rows);
            part.palette = band.palette;
            fxl_frame_fill(renderer, &part, DRAW_BACKGROUND);
            DEMAND(fxl_frame_draw(renderer, &part) == FXL_OK);
        }
        DEMAND(memcmp(parts, band.pixels, size) == 0);
        DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
        fxl_frame_fill(renderer, &band, DRAW_BACKGROUND);
        DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
        draw_world_lines(renderer, &band, has_eye);
    }
    free(parts);
    free(band.pixels);
}

static void attach_surfaces(some_frame *of, const fxl_surface_set *set)
{
    static const struct {
        const fxl_target *target;
        const fxl_painter *painter;
    } painters[] = {{&fxl_palette, FXL_SURFACES_OF(fxl_palette)},
                    {&fxl_palette_depth_16, FXL_SURFACES_OF(fxl_palette_depth_16)},
                    {&fxl_palette_depth_32, FXL_SURFACES_OF(fxl_palette_depth_32)},
                    {&fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565)},
                    {&fxl_rgb565_depth_16, FXL_SURFACES_OF(fxl_rgb565_depth_16)},
                    {&fxl_rgb565_depth_32, FXL_SURFACES_OF(fxl_rgb565_depth_32)}};
    for (uint32_t i = 0; set != NULL && i < sizeof painters / sizeof *painters; i++) {
        if (painters[i].target == of->target &&
            fxl_surfaces_check(set, of->renderer.scene, of->target->pixel_bits, NULL) == FXL_OK) {
            DEMAND(fxl_attach_surfaces(&of->renderer, &of->parts.surfaces, set,
                                       painters[i].painter) == FXL_OK);
        }
    }
}

static void attach_any(some_frame *of, const fxl_surface_set *set)
{
    static uint8_t ramp[2 * 256];
    static const fxl_outline_style style = {.line = 1, .keeps_colours = true};
    static const fxl_q2_30 sines[] = {-FXL_Q2_30_ONE / 4, 0, FXL_Q2_30_ONE / 8, FXL_Q2_30_ONE / 2};
    static const uint8_t colours[] = {1, 2, 3, 4, 5};
    static const fxl_horizon sky = {sines, colours, 4};
    fxl_renderer *renderer = &of->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_beam_set beams = {scene->beams, scene->beam_count, scene->lit};
    fxl_light_settings settings;
    memset(&settings, 0, sizeof settings);
    settings.ambient = FXL_Q2_30_ONE / 2;
    settings.strength = FXL_Q2_30_ONE / 3;
    settings.direction.y = -FXL_Q2_30_ONE;
    settings.levels = 2;
    settings.ramp = ramp;
    attach_surfaces(of, set);
    if (set != NULL || one_in(3)) {
        DEMAND(fxl_attach_light(renderer, &of->parts.light, &settings) == FXL_OK);
        DEMAND(one_in(3) || fxl_attach_lit(renderer, &of->parts.lit) == FXL_OK);
    }
    if (one_in(5)) {
        DEMAND(fxl_attach_outlines(renderer, &of->outlines, &style) == FXL_OK);
    }
    if (one_in(4)) {
        DEMAND(fxl_attach_horizon(renderer, &sky) == FXL_OK);
    }
    if (scene->beam_count > 0 && one_in(3)) {
        DEMAND(fxl_attach_beams(renderer, &beams, of->beams, of->beams_size) == FXL_OK);
    }
}

static void start(some_frame *of, const fxl_scene *scene, const fxl_lens *lens,
                  const fxl_order *order)
{
    const fxl_memory memory = {of->order, scene->draw_list_needed, NULL, 0, NULL, 0};
    fxl_config config = fxl_config_for(1, 1, of->target);
    config.order = order;
    config.palette = of->palette;
    config.depth = of->depth;
    config.depth_size = of->depth_size;
    config.tree = of->tree;
    config.tree_size = of->tree_size;
    DEMAND(fxl_renderer_init_with(&of->renderer, scene, lens, &memory) == FXL_OK);
    DEMAND(fxl_renderer_choose(&of->renderer, &config) == FXL_OK);
}

/* The most pixels a world unit, 1/16 .. 4096, of which most show some of the scene. */
static fxl_q16_16 any_scale(void)
{
    return (fxl_q16_16)(FXL_ORTHOGRAPHIC_SCALE_MIN + any(1u << (10 + any(17))));
}

static void open(some_frame *of, const fxl_scene *scene, const fxl_lens *lens)
{
    memset(of, 0, sizeof *of);
    of->depth_size = FXL_DEPTH_BYTES(lens->width, lens->height, 32) + SPANS;
    of->tree_size = SPANS + (scene->bsp_nodes ? fxl_by_tree.memory_size(scene) : 0);
    of->beams_size =
        scene->beam_count > 0 ? fxl_beam_light_workspace_size(scene->beams, scene->beam_count) : 8;
    of->order = draw_memory((scene->draw_list_needed + 2 * PLACES) * sizeof(fxl_draw_entry));
    of->depth = draw_memory(of->depth_size);
    of->tree = draw_memory(of->tree_size);
    of->beams = draw_memory(of->beams_size);
    of->list = draw_memory(4 * LIST);
}

static void close(some_frame *of)
{
    free(of->order);
    free(of->depth);
    free(of->tree);
    free(of->beams);
    free(of->list);
}

static void draw_target(some_frame *of, const fxl_scene *scene, const fxl_lens *lens,
                        const fxl_pose *pose, const fxl_surface_set *set)
{
    for (uint32_t round = 0; round < 4; round++) {
        const bool has_eye = round < 2;
        start(of, scene, lens, round % 2 && scene->bsp_nodes && one_in(2) ? &fxl_by_tree : NULL);
        if (!has_eye) {
            DEMAND(fxl_renderer_set_orthographic(&of->renderer, 0) == FXL_E_RANGE);
            DEMAND(fxl_renderer_set_orthographic(&of->renderer, any_scale()) == FXL_OK);
        }
        make_lines(&of->lines, scene);
        misuse_lines(&of->renderer, &of->lines);
        if (has_eye || one_in(8)) {
            DEMAND(fxl_attach_lines(&of->renderer, &of->lines.attached, &of->lines.set) == FXL_OK);
        }
        attach_any(of, round == 0 ? NULL : set);
        draw_frame(of, pose, has_eye);
        if (one_in(2)) {
            DEMAND(fxl_attach_lines(&of->renderer, NULL, NULL) == FXL_OK);
        }
    }
}

/* --- what changed ----------------------------------------------------------------------------- */

typedef struct {
    fxl_world world;
    fxl_instance instances[2 * PLACES];
    fxl_placement placements[PLACES];
    fxl_world_slot slots[2 * PLACES];
    uint8_t colours[2 * 256];
    fxl_world_colours recoloured;
} some_world;

static fxl_placement any_turn(void)
{
    fxl_camera camera;
    const fxl_pose pose = {.yaw = (fxl_angle)any(65536)};
    DEMAND(fxl_camera_from_pose(&pose, &camera) == FXL_OK);
    const fxl_placement placement = {{camera.axes.right, camera.axes.up, camera.axes.forward},
                                     (fxl_q16_16)(32768 + any(65536))};
    return placement;
}

static fxl_instance any_instance(const fxl_scene *scene, const fxl_view *view)
{
    const fxl_instance instance = {any_point(view), (uint16_t)any(scene->model_count),
                                   (uint8_t)any(3), 0};
    return instance;
}

static void change(some_world *of, const fxl_view *view)
{
    fxl_world *world = &of->world;
    const fxl_instance made = any_instance(&world->scene, view);
    const fxl_placement placement = any_turn();
    fxl_handle handle = world->scene.instance_count > 0
                            ? fxl_world_handle_at(world, any(world->scene.instance_count))
                            : fxl_world_handle(any(2 * PLACES));
    const fxl_instance *found = fxl_world_instance(world, handle);
    fxl_point centre = found != NULL ? found->centre : made.centre;
    fxl_q16_16 *const sides[] = {&centre.x, &centre.y, &centre.z};
    switch (any(12)) {
    case 0:
        (void)fxl_world_remove(world, handle);
        break;
    case 1:
        (void)fxl_world_hide(world, handle);
        break;
    case 2:
        (void)fxl_world_show(world, fxl_world_handle(any(2 * PLACES)));
        break;
    case 3:
        (void)fxl_world_move(world, handle, &made.centre);
        break;
    case 4:
        (void)fxl_world_set_placement(world, handle, one_in(4) ? NULL : &placement);
        break;
    case 5:
        (void)fxl_world_set_model(world, handle, made.model);
        break;
    case 6:
        (void)fxl_world_set_layer(world, handle, made.layer);
        break;
    case 7:
        (void)fxl_world_recolour(world, handle, any(3));
        break;
    case 8:
    case 9:
        (void)fxl_world_spawn(world, &made, one_in(2) ? &placement : NULL, &handle);
        break;
    default:
        *sides[any(3)] += (fxl_q16_16)any(65536) - 32768;
        (void)fxl_world_move(world, handle, &centre);
        break;
    }
}

/* Something of the frame, not of the world, changes; or nothing. */
static void change_frame(fxl_renderer *renderer, fxl_pose *pose)
{
    fxl_q16_16 *const sides[] = {&pose->position.x, &pose->position.y, &pose->position.z};
    switch (any(12)) {
    case 0:
        *sides[any(3)] ^= 1;
        break;
    case 1:
        pose->yaw = (fxl_angle)(pose->yaw ^ 64);
        break;
    case 2:
        pose->pitch = 0;
        break;
    case 3:
        renderer->frame.background ^= 1;
        break;
    case 4:
        (void)fxl_renderer_set_centre(renderer, renderer->frame.view.lens.centre_x + 65536,
                                      renderer->frame.view.lens.centre_y);
        break;
    case 5:
        (void)fxl_renderer_set_centre(renderer, renderer->frame.view.lens.centre_x,
                                      renderer->frame.view.lens.centre_y + 65536);
        break;
    default:
        break;
    }
}

/* Adds boxes that the program drew over, and a model; what is refused changes nothing. */
static void add_boxes(fxl_changed *changed, const fxl_renderer *renderer)
{
    static const fxl_renderer none;
    const fxl_lens *lens = &renderer->frame.view.lens;
    fxl_screen_box box = {(uint16_t)any(lens->width), 1, (uint16_t)any(lens->height), 1};
    fxl_changed before = *changed, empty;
    uint64_t memory[1];
    DEMAND(fxl_changed_init(NULL, memory, 8) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_init(&empty, NULL, 8) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_init(&empty, (uint8_t *)memory + 4, 4) == FXL_E_ALIGNMENT);
    DEMAND(fxl_changed_init(&empty, memory, 8) == FXL_OK);
    DEMAND(fxl_changed_find(&empty, &none) == FXL_E_ORDER);
    DEMAND(renderer->scene->instance_count == 0 ||
           fxl_changed_find(&empty, renderer) == FXL_E_CAPACITY);
    DEMAND(renderer->scene->instance_count == 0 || fxl_changed_add(&empty, &box) == FXL_E_ORDER);
    DEMAND(renderer->scene->instance_count == 0 || fxl_changed_widen(&empty, 1, 1) == FXL_E_ORDER);
    empty.memory = NULL;
    DEMAND(fxl_changed_find(&empty, renderer) == FXL_E_ORDER);
    DEMAND(fxl_changed_find(NULL, renderer) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_find(changed, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_add(NULL, &box) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_add(changed, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_widen(NULL, 1, 1) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_widen(changed, 3, 1) == FXL_E_RANGE);
    DEMAND(fxl_changed_widen(changed, 16, 1) == FXL_E_RANGE);
    DEMAND(fxl_changed_widen(changed, 1, 0) == FXL_E_RANGE);
    DEMAND(fxl_changed_widen(changed, 1, 16) == FXL_E_RANGE);
    DEMAND(fxl_changed_widen(changed, 1, 6) == FXL_E_RANGE);
    DEMAND(fxl_changed_add_model(NULL, renderer, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_add_model(changed, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_changed_add_model(changed, &none, 0) == FXL_E_ORDER);
    DEMAND(fxl_changed_add_model(changed, renderer, UINT32_MAX) == FXL_E_INDEX);
    fxl_screen_box wrong[] = {box, box, box, box};
    wrong[0].columns = 0;
    wrong[1].rows = 0;
    wrong[2].columns = (uint16_t)(lens->width + 1);
    wrong[3].rows = (uint16_t)(lens->height + 1);
    DEMAND(fxl_changed_add(changed, &wrong[any(4)]) == FXL_E_RANGE);
    DEMAND(memcmp(&before, changed, sizeof before) == 0);
    if (one_in(2)) {
        box.columns = (uint16_t)(1 + any(lens->width - box.first_column));
        box.rows = (uint16_t)(1 + any(lens->height - box.first_row));
        DEMAND(fxl_changed_add(changed, &box) == FXL_OK);
    }
    if (one_in(3)) {
        DEMAND(fxl_changed_add_model(changed, renderer, any(renderer->scene->model_count)) ==
               FXL_OK);
    }
    if (one_in(2)) {
        DEMAND(fxl_changed_widen(changed, one_in(4) ? 0 : 1u << any(4), 1u << any(4)) == FXL_OK);
    }
}

/* The frame, whole; and over the frame before it, in the boxes. */
static void demand_boxes(some_frame *of, fxl_changed *changed, const fxl_pose *pose, uint8_t *built,
                         uint8_t *pixels)
{
    fxl_renderer *renderer = &of->renderer;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const fxl_band band = draw_band(lens, pixels, 0, lens->height);
    const uint8_t background = renderer->frame.background;
    if (fxl_frame_begin(renderer, pose) != FXL_OK) {
        return;
    }
    DEMAND(fxl_changed_find(changed, renderer) == FXL_OK);
    add_boxes(changed, renderer);
    fxl_frame_fill(renderer, &band, background);
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    for (uint32_t i = 0; i < changed->count; i++) {
        const fxl_screen_box *box = &changed->boxes[i];
        fxl_band part =
            draw_band(lens, built + (size_t)box->first_row * lens->width + box->first_column,
                      box->first_row, box->rows);
        part.first_column = box->first_column;
        part.columns = box->columns;
        fxl_frame_fill(renderer, &part, background);
        DEMAND(fxl_frame_draw(renderer, &part) == FXL_OK);
    }
    DEMAND(memcmp(pixels, built, (size_t)lens->width * lens->height) == 0);
    if (one_in(8) && fxl_frame_release_scene(renderer) == FXL_OK) {
        DEMAND(fxl_changed_find(changed, renderer) == FXL_E_ORDER);
        DEMAND(fxl_changed_add_model(changed, renderer, 0) == FXL_E_ORDER);
    }
    DEMAND(fxl_frame_end(renderer) == FXL_OK);
}

/* A sprite for each model, or for some, and what may change of it. */
typedef struct {
    fxl_sprite sprite;
    fxl_billboard billboard;
    uint16_t map[MADE_MODELS];
    fxl_billboard_set set;
    fxl_billboards attached;
} some_billboards;

static const uint8_t texels[2][16] = {{1, 0, 2, 3}, {3, 2, 1}};

/* As large as the radii of the models allow; none, where one allows none. */
static bool attach_billboards(fxl_renderer *renderer, some_billboards *made)
{
    memset(made, 0, sizeof *made);
    made->sprite = (fxl_sprite){.pixels = texels[0], .width = 4, .height = 4, .bits = 8};
    made->billboard.sprite = &made->sprite;
    for (uint32_t i = 0; i < MADE_MODELS; i++) {
        made->map[i] = (uint16_t)any(2);
    }
    made->set =
        (fxl_billboard_set){.billboards = &made->billboard, .model_map = made->map, .count = 1};
    for (fxl_q16_16 side = 1 << 24; side > 0; side /= 2) {
        made->billboard.width = made->billboard.height = side;
        made->billboard.anchor_x = made->billboard.anchor_y = side / 2;
        if (fxl_attach_billboards(renderer, &made->attached, &made->set,
                                  FXL_SPRITES_OF(fxl_palette)) == FXL_OK) {
            return true;
        }
    }
    return false;
}

/* A change that the check allows. */
static void change_billboards(const fxl_renderer *renderer, some_billboards *made)
{
    const some_billboards before = *made;
    switch (any(9)) {
    case 0:
        made->sprite.pixels = texels[any(2)];
        break;
    case 1:
        made->sprite.width = (uint16_t)(made->sprite.width ^ 6u);
        break;
    case 2:
        made->sprite.height = (uint16_t)(made->sprite.height ^ 6u);
        break;
    case 3:
        made->billboard.width ^= 1;
        break;
    case 4:
        made->billboard.height ^= 1;
        break;
    case 5:
        made->billboard.anchor_x ^= 1;
        break;
    case 6:
        made->billboard.anchor_y ^= 1;
        break;
    default:
        made->map[any(MADE_MODELS)] ^= 1u;
        break;
    }
    if (fxl_billboards_check(&made->set, renderer->scene, NULL) != FXL_OK) {
        *made = before;
    }
}

static void draw_changes(some_frame *of, const fxl_scene *scene, const fxl_lens *lens,
                         const fxl_pose *first, uint32_t kind)
{
    static uint64_t kept[FXL_CHANGED_MEMORY(2 * PLACES, PLACES, MADE_MODELS, 4)];
    static some_world placed;
    static some_billboards billboards;
    const size_t size = (size_t)lens->width * lens->height;
    uint8_t *built = draw_memory(size), *pixels = draw_memory(size);
    fxl_pose pose = *first;
    fxl_changed changed;
    memset(&placed, 0, sizeof placed);
    for (uint32_t i = 0; i < sizeof placed.colours; i++) {
        placed.colours[i] = (uint8_t)(i * 7);
    }
    const fxl_world_memory memory = {placed.instances,
                                     placed.slots,
                                     placed.placements,
                                     scene->instance_count + MORE,
                                     MADE_INSTANCES + MORE,
                                     placed.colours,
                                     2,
                                     &fxl_turned_instances};
    if (fxl_world_init(&placed.world, scene, &memory) == FXL_OK) {
        of->target = kind % 2 ? &fxl_palette_depth_16 : &fxl_palette;
        const fxl_order *tree = scene->bsp_nodes != NULL && kind % 4 == 0 ? &fxl_by_tree : NULL;
        void *order = of->order;
        of->order =
            draw_memory((placed.world.scene.draw_list_needed + PLACES) * sizeof(fxl_draw_entry));
        start(of, &placed.world.scene, lens, tree);
        if (kind == 3) {
            DEMAND(fxl_renderer_set_orthographic(&of->renderer, any_scale()) == FXL_OK);
        }
        DEMAND(fxl_world_attach(&placed.world, &of->renderer) == FXL_OK);
        if (kind == 1) {
            make_lines(&of->lines, scene);
            DEMAND(fxl_attach_lines(&of->renderer, &of->lines.attached, &of->lines.set) == FXL_OK);
        }
        const bool has_billboards = kind == 2 && attach_billboards(&of->renderer, &billboards);
        DEMAND(fxl_changed_init(&changed, kept, sizeof kept) == FXL_OK);
        for (uint32_t i = 0; i < CHANGES; i++) {
            demand_boxes(of, &changed, &pose, built, pixels);
            for (uint32_t k = any(3); k > 0; k--) {
                change(&placed, &of->renderer.frame.view);
            }
            if (has_billboards && one_in(2)) {
                change_billboards(&of->renderer, &billboards);
            }
            if (one_in(3)) {
                change_frame(&of->renderer, &pose);
            }
        }
        free(of->order);
        of->order = order;
    }
    free(built);
    free(pixels);
}

void draw_lines(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                const fxl_surface_set *set, const fuzz_input *in)
{
    static some_frame frame;
    state = 14695981039346656037u;
    mix(pose, sizeof *pose);
    mix(&lens->focal, sizeof lens->focal);
    mix(in->at, in->left);
    open(&frame, scene, lens);
    for (uint32_t i = 0; i < DRAW_TARGETS; i++) {
        frame.target = draw_targets[i];
        draw_target(&frame, scene, lens, pose, set);
    }
    for (uint32_t kind = 0; kind < 4 && set == NULL && scene->model_count <= MADE_MODELS; kind++) {
        draw_changes(&frame, scene, lens, pose, kind);
    }
    close(&frame);
}
