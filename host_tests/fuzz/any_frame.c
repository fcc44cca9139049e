/* SPDX-License-Identifier: MIT */
#include "any_frame.h"

#include <stdlib.h>

#include "study/study.h"

enum {
    TREE_ROOM = 1 << 16
};

static uint64_t state;

static void mix(const void *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        state = (state ^ ((const uint8_t *)bytes)[i]) * 1099511628211u;
    }
}

void chance_begin(const fxl_lens *lens, const fxl_pose *pose, const fuzz_input *in)
{
    state = 14695981039346656037u;
    mix(pose, sizeof *pose);
    mix(&lens->focal, sizeof lens->focal);
    mix(in->at, in->left);
}

uint32_t any(uint32_t count)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return count > 0 ? (uint32_t)(state >> 33) % count : 0;
}

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

void make_lines(some_lines *made, const fxl_scene *scene)
{
    uint32_t count = 0;
    memset(made, 0, sizeof *made);
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const fxl_model *model = &scene->models[i];
        made->map[i] = count;
        for (uint32_t k = any(8) == 0 ? MODEL_LINES : 2; k < MODEL_LINES && model->vertex_count > 0; k++) {
            made->lines[count++] = any_line(scene, model);
        }
    }
    made->map[scene->model_count] = count;
    made->set = (fxl_line_set){made->lines, count, made->map};
}

static fxl_q16_16 clamped(int64_t x)
{
    return (fxl_q16_16)(x > FXL_COORDINATE_MAX    ? FXL_COORDINATE_MAX
                        : x < -FXL_COORDINATE_MAX ? -FXL_COORDINATE_MAX
                                                  : x);
}

fxl_point any_point(const fxl_view *view)
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

fxl_q16_16 any_scale(void)
{
    return (fxl_q16_16)(FXL_ORTHOGRAPHIC_SCALE_MIN + any(1u << (10 + any(17))));
}

/* --- memory of a frame ------------------------------------------------------------------------ */

void draw_open_room(draw_room *room, const fxl_scene *scene, const fxl_lens *lens, uint32_t more)
{
    const uint32_t spans = FXL_SPAN_BUFFER_BYTES_LEAST(lens->width, lens->height);
    memset(room, 0, sizeof *room);
    for (uint32_t i = 0; i < 256; i++) {
        room->palette[i] = (uint16_t)(i * 0x0101u);
    }
    room->entries = scene->draw_list_needed + more;
    room->depth_size = FXL_DEPTH_BYTES(lens->width, lens->height, 32);
    room->depth_size = room->depth_size < spans ? spans : room->depth_size;
    room->tree_size = TREE_ROOM + (scene->bsp_nodes ? fxl_by_tree.memory_size(scene) : 0);
    room->beams_size =
        scene->beam_count > 0 ? fxl_beam_light_workspace_size(scene->beams, scene->beam_count) : 8;
    room->order = draw_memory(room->entries * sizeof(fxl_draw_entry));
    room->depth = draw_memory(room->depth_size);
    room->tree = draw_memory(room->tree_size);
    room->beams = draw_memory(room->beams_size);
}

void draw_close_room(draw_room *room)
{
    free(room->order);
    free(room->depth);
    free(room->tree);
    free(room->beams);
}

void draw_init(fxl_renderer *renderer, const draw_room *room, const fxl_scene *scene,
               const fxl_lens *lens)
{
    const fxl_memory memory = {room->order, scene->draw_list_needed, NULL, 0, NULL, 0};
    DEMAND(scene->draw_list_needed <= room->entries);
    DEMAND(fxl_renderer_init_with(renderer, scene, lens, &memory) == FXL_OK);
}

void draw_choose_in(fxl_renderer *renderer, const draw_room *room, const fxl_order *order,
                    const fxl_target *target)
{
    fxl_config config = fxl_config_for(1, 1, target);
    config.order = order;
    config.palette = room->palette;
    config.depth = room->depth;
    config.depth_size = room->depth_size;
    config.tree = room->tree;
    config.tree_size = room->tree_size;
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_OK);
}

/* --- what is attached ------------------------------------------------------------------------- */

void attach_light(fxl_renderer *renderer, fxl_light *light, bool is_there)
{
    static const uint8_t ramp[2 * 256];
    fxl_light_settings settings;
    memset(&settings, 0, sizeof settings);
    settings.ambient = FXL_Q2_30_ONE / 2;
    settings.strength = FXL_Q2_30_ONE / 3;
    settings.direction.y = -FXL_Q2_30_ONE;
    settings.levels = 2;
    settings.ramp = ramp;
    DEMAND(fxl_attach_light(renderer, light, is_there ? &settings : NULL) == FXL_OK);
}

void attach_outlines(fxl_renderer *renderer, fxl_outlines *outlines, bool is_there)
{
    static const fxl_outline_style style = {
        .line = 1, .keeps_colours = true, .code = &fxl_outlines_by_depth};
    DEMAND(fxl_attach_outlines(renderer, outlines, is_there ? &style : NULL) == FXL_OK);
}

void attach_horizon(fxl_renderer *renderer, bool is_there)
{
    static const fxl_q2_30 sines[] = {-FXL_Q2_30_ONE / 4, 0, FXL_Q2_30_ONE / 8, FXL_Q2_30_ONE / 2};
    static const uint8_t colours[] = {1, 2, 3, 4, 5};
    static const fxl_horizon sky = {sines, colours, 4};
    DEMAND(fxl_attach_horizon(renderer, is_there ? &sky : NULL) == FXL_OK);
}

void attach_beams(fxl_renderer *renderer, const draw_room *room, bool is_there)
{
    const fxl_scene *scene = renderer->scene;
    const fxl_beam_set beams = {scene->beams, scene->beam_count, scene->lit};
    if (scene->beam_count > 0) {
        DEMAND(fxl_attach_beams(renderer, is_there ? &beams : NULL, room->beams,
                                room->beams_size) == FXL_OK);
    }
}
