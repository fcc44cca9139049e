/* SPDX-License-Identifier: MIT */
/* Lines over any scene, with an eye and without one. What is attached is chosen by chance. */
#include <stdlib.h>

#include "any_frame.h"

enum {
    LIST = 2048
};

/* --- lines ------------------------------------------------------------------------------------ */

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

static void draw_world_lines(fxl_renderer *renderer, const fxl_band *band)
{
    const fxl_view *view = &renderer->frame.view;
    fxl_world_line line;
    for (uint32_t i = 0; i < 24; i++) {
        line = (fxl_world_line){any_point(view), any_point(view), (uint8_t)any(256),
                                (uint8_t)(1 + any(FXL_LINE_WIDTH_MAX))};
        if (one_in(5)) {
            line.to = line.from;
        }
        DEMAND(fxl_frame_draw_line(renderer, NULL, &line, band) == FXL_OK);
    }
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

/* --- frames ----------------------------------------------------------------------------------- */

typedef struct {
    fxl_renderer renderer;
    some_lines lines;
    draw_parts parts;
    fxl_outlines outlines;
    draw_room room;
    const fxl_target *target;
    uint32_t list[LIST];
} some_frame;

/* Pixels of the frame: whole, and in bands with a list; the same. No frame, where things do not go
 * together. */
static void draw_frame(some_frame *of, const fxl_pose *pose)
{
    fxl_renderer *renderer = &of->renderer;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const uint32_t bytes = of->target->pixel_bits / 8u;
    const size_t size = (size_t)lens->width * lens->height * bytes;
    fxl_band band = draw_band(lens, draw_memory(size), 0, lens->height);
    uint8_t *parts = draw_memory(size);
    const char *names[2];
    band.palette = bytes == 2 ? of->room.palette : NULL;
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
        draw_world_lines(renderer, &band);
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
    fxl_renderer *renderer = &of->renderer;
    attach_surfaces(of, set);
    if (set != NULL || one_in(3)) {
        attach_light(renderer, &of->parts.light, true);
        DEMAND(one_in(3) || fxl_attach_lit(renderer, &of->parts.lit) == FXL_OK);
    }
    if (one_in(5)) {
        attach_outlines(renderer, &of->outlines, true);
    }
    if (one_in(4)) {
        attach_horizon(renderer, true);
    }
    if (renderer->scene->beam_count > 0 && one_in(3)) {
        attach_beams(renderer, &of->room, true);
    }
}

static void draw_target(some_frame *of, const fxl_scene *scene, const fxl_lens *lens,
                        const fxl_pose *pose, const fxl_surface_set *set)
{
    for (uint32_t round = 0; round < 4; round++) {
        const bool has_eye = round < 2;
        draw_init(&of->renderer, &of->room, scene, lens);
        draw_choose_in(&of->renderer, &of->room,
                       round % 2 && scene->bsp_nodes && one_in(2) ? &fxl_by_tree : NULL,
                       of->target);
        if (!has_eye) {
            DEMAND(fxl_renderer_set_orthographic(&of->renderer, 0) == FXL_E_RANGE);
            DEMAND(fxl_renderer_set_orthographic(&of->renderer, any_scale()) == FXL_OK);
        }
        make_lines(&of->lines, scene);
        misuse_lines(&of->renderer, &of->lines);
        DEMAND(fxl_attach_lines(&of->renderer, &of->lines.attached, &of->lines.set) == FXL_OK);
        attach_any(of, round == 0 ? NULL : set);
        draw_frame(of, pose);
        if (one_in(2)) {
            DEMAND(fxl_attach_lines(&of->renderer, NULL, NULL) == FXL_OK);
        }
    }
}

void draw_lines(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                const fxl_surface_set *set, const fuzz_input *in)
{
    static some_frame frame;
    memset(&frame, 0, sizeof frame);
    chance_begin(lens, pose, in);
    draw_open_room(&frame.room, scene, lens, 0);
    for (uint32_t i = 0; i < DRAW_TARGETS; i++) {
        frame.target = draw_targets[i];
        draw_target(&frame, scene, lens, pose, set);
    }
    draw_close_room(&frame.room);
    if (set == NULL && scene->model_count <= MADE_MODELS) {
        draw_changes(scene, lens, pose);
    }
}
