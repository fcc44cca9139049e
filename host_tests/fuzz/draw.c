/* SPDX-License-Identifier: MIT */
#include "parts.h"
#include "study/clippers.h"
#include "study/targets.h"
#include "study/span_buffer.h"

#include <string.h>

#include "answers.h"
#include "fixel/crc.h"
#include "../unit/clippers_list.h"

enum {
    GAP = 0x5A /* as draw_memory */
};

/* The clippers as a renderer knows them, with their promises checked. */
static fxl_clip_result checked_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                       fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    const uint16_t *corners = fxl_face_indices(model_view->indices, face);
    fxl_view_polygon seen = {.colour = face->material, .count = face->count};
    const fxl_view_polygon *clipped;
    static fxl_clip_view_work checked;
    fxl_planes needed = 0;
    for (uint32_t i = 0; i < face->count; i++) {
        if (model_view->axes != &model_view->view->camera.axes) { /* a turned instance */
            seen.vertices[i].position = fxl_fetch_vertex(model_view, corners[i])->position;
            needed |= judge_outcode(&model_view->view->view_frustum, &seen.vertices[i].position, 0);
            continue;
        }
        fxl_point from_eye = fxl_model_view_vertex(model_view, corners[i]), point = from_eye;
        point.x += model_view->view->camera.position.x;
        point.y += model_view->view->camera.position.y;
        point.z += model_view->view->camera.position.z;
        fxl_transform_point(&model_view->view->camera, &point, &seen.vertices[i].position);
        DEMAND(memcmp(&fxl_fetch_vertex(model_view, corners[i])->position,
                      &seen.vertices[i].position, sizeof seen.vertices[i].position) == 0);
        needed |= judge_outcode(&model_view->view->view_frustum, &seen.vertices[i].position, 0);
    }
    fxl_clip_result expected = fxl_clip_view_by_planes(
        &seen, &model_view->view->view_frustum, needed, &checked, NULL, &clipped);
    judge_view_clip(expected, clipped, model_view->view);
    fxl_clip_result cut = fxl_clip_by_view(model_view, face, work, screen);
    /* A face outside of one plane may have been cut away by one before it; one between the
     * centres of pixels is inside. */
    DEMAND(cut == expected || (cut == FXL_CLIP_OUTSIDE && clipped == NULL) ||
           (cut == FXL_CLIP_BETWEEN && expected == FXL_CLIP_INSIDE));
    judge_screen(cut, screen);
    if (clipped != NULL) {
        const fxl_lens lens = fxl_view_drawn_lens(model_view->view);
        DEMAND(clipped->count == screen->count && clipped->colour == screen->colour);
        for (uint32_t i = 0; i < clipped->count; i++) {
            fxl_screen_point same;
            DEMAND(fxl_project_point(&lens, &clipped->vertices[i].position, &same) == FXL_OK);
            DEMAND(memcmp(&same, &screen->points[i], sizeof same) == 0);
        }
    }
    return cut;
}

static fxl_clip_result checked_by_world(const fxl_model_view *model_view, const fxl_face *face,
                                        fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    fxl_clip_result cut = fxl_clip_by_world(model_view, face, work, screen);
    judge_screen(cut, screen);
    return cut;
}

/* Any other: its outlines are such as the scan takes. */
static const fxl_clipper *of_family;

static fxl_clip_result checked_clip(const fxl_model_view *model_view, const fxl_face *face,
                                    fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    fxl_clip_result cut = of_family->clip(model_view, face, work, screen);
    /* The guard band, or all planes, rule it out; but a face that is not convex is not for
     * the one that goes by edges. */
    DEMAND(cut != FXL_CLIP_RANGE || of_family == &fxl_clipper_once);
    judge_screen(cut, screen);
    return cut;
}

static fxl_clip_result checked_next(const fxl_model_view *model_view, fxl_clipper_work *work,
                                    fxl_screen_polygon *screen)
{
    fxl_clip_result cut = of_family->next(model_view, work, screen);
    DEMAND(cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_OUTSIDE);
    judge_screen(cut, screen);
    return cut;
}

uint32_t draw_clipper_count(void)
{
    return 2 + CLIPPERS;
}

/* One at a time. */
static const fxl_clipper *checked(uint32_t number)
{
    static const fxl_clipper checked_view = {.clip = checked_by_view, .by_clip_flags = true};
    static const fxl_clipper checked_world = {.clip = checked_by_world,
                                              .begin = fxl_view_set_world_frustum,
                                              .by_points = &fxl_rounded_faces};
    static fxl_clipper made;
    if (number < 2) {
        return number == 1 ? &checked_world : &checked_view;
    }
    of_family = clippers[number - 2];
    made = (fxl_clipper){.clip = checked_clip,
                         .next = of_family->next != NULL ? checked_next : NULL,
                         .workspace_size = of_family->workspace_size,
                         .begin = of_family->begin,
                         .by_clip_flags = of_family->by_clip_flags,
                         .by_points = of_family->by_points};
    return &made;
}

void *draw_memory(size_t size)
{
    void *made = malloc(size > 0 ? size : 1);
    DEMAND(made != NULL);
    memset(made, GAP, size);
    return made;
}

fxl_band draw_band(const fxl_lens *lens, void *pixels, uint32_t first_row, uint32_t rows)
{
    return (fxl_band){.pixels = pixels,
                      .width = lens->width,
                      .stride = lens->width,
                      .first_row = (uint16_t)first_row,
                      .rows = (uint16_t)rows};
}

void draw_bands(fxl_renderer *renderer, uint8_t *pixels, uint32_t rows, uint32_t step)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    for (uint32_t row = 0, count; row < rows; row += count) {
        count = step < rows - row ? step : rows - row;
        const fxl_band band = draw_band(lens, pixels + (size_t)row * lens->width, row, count);
        fxl_fill_band(&band, DRAW_BACKGROUND);
        DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    }
}

void draw_changed_boxes(fxl_renderer *renderer, const fxl_changed *changed, uint8_t *picture,
                        uint8_t background)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    for (uint32_t i = 0; i < changed->count; i++) {
        const fxl_screen_box *box = &changed->boxes[i];
        fxl_band part =
            draw_band(lens, picture + (size_t)box->first_row * lens->width + box->first_column,
                      box->first_row, box->rows);
        part.first_column = box->first_column;
        part.columns = box->columns;
        fxl_frame_fill(renderer, &part, background);
        DEMAND(fxl_frame_draw(renderer, &part) == FXL_OK);
    }
}

bool draw_accounted(const fxl_counters *counters)
{
    return counters->in == (uint64_t)counters->backfacing + counters->outside + counters->degenerate +
                               counters->refused + counters->drawn;
}

void *draw_beams(fxl_renderer *renderer)
{
    const fxl_scene *scene = renderer->scene;
    const fxl_beam_set set = {scene->beams, scene->beam_count, scene->lit};
    if (set.count == 0) {
        return NULL;
    }
    const uint32_t size = fxl_beam_light_workspace_size(set.beams, set.count);
    void *light = draw_memory(size);
    DEMAND(fxl_attach_beams(renderer, &set, light, size) == FXL_OK);
    return light;
}

uint64_t draw_model_view(const fxl_scene *scene)
{
    uint64_t faces = 0;
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        faces += scene->models[scene->instances[i].model].face_count;
    }
    return faces;
}

/* A band of memory of its own, so that the sanitizer sees every byte beside it. */
static fxl_band make_band(const fxl_lens *lens, uint32_t gap, uint32_t first_row, uint32_t rows)
{
    const size_t stride = lens->width + gap;
    fxl_band band = draw_band(lens, draw_memory(stride * rows), first_row, rows);
    band.stride = (uint16_t)stride;
    fxl_fill_band(&band, DRAW_BACKGROUND);
    return band;
}

static void demand_gaps_intact(const fxl_band *band)
{
    for (uint32_t row = 0; row < band->rows; row++) {
        for (uint32_t x = band->width; x < band->stride; x++) {
            DEMAND(band->pixels[row * band->stride + x] == GAP);
        }
    }
}

static void demand_accounted(const fxl_counters *counters, uint64_t model_view)
{
    DEMAND(counters->in == model_view && draw_accounted(counters));
    DEMAND(counters->clipped <= counters->drawn && counters->spilled <= counters->drawn);
    DEMAND(counters->refused_calls == 0);
}

/* Cuts the rows of `whole` into bands, draws each, compares. */
static void draw_in_bands(fxl_renderer *renderer, const fxl_band *whole, fuzz_input *in)
{
    uint32_t end = (uint32_t)whole->first_row + whole->rows;
    uint32_t gap = fuzz_below(in, 4);
    /* A band costs a pass over the scene: at most eight. */
    uint32_t rows_least = (whole->rows + 7u) / 8u;
    for (uint32_t row = whole->first_row; row < end;) {
        uint32_t rows = rows_least + fuzz_below(in, whole->rows);
        rows = rows > end - row ? end - row : rows;
        fxl_band band = make_band(&renderer->frame.view.lens, gap, row, rows);
        DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
        demand_gaps_intact(&band);
        uint32_t crc = FXL_CRC_START, expected_crc = FXL_CRC_START;
        for (uint32_t i = 0; i < rows; i++) {
            const uint8_t *expected =
                whole->pixels + (size_t)(row - whole->first_row + i) * whole->stride;
            DEMAND(memcmp(band.pixels + (size_t)i * band.stride, expected, band.width) == 0);
            expected_crc = fxl_crc(expected_crc, expected, band.width);
        }
        DEMAND(fxl_band_crc(&crc, &band) == FXL_OK && crc == expected_crc);
        free(band.pixels);
        row += rows;
    }
}

/* A renderer whose memory ends where it should, so that the sanitizer sees what
 * is written beside it. */
static fxl_renderer *make_renderer(const fxl_scene *scene, const fxl_lens *lens, uint32_t clipper,
                                   uint32_t list_words, uint32_t cache_entries)
{
    fxl_renderer *renderer = draw_memory(sizeof *renderer);
    fxl_memory memory = {.draw_list_capacity = scene->draw_list_needed,
                         .display_list_capacity = list_words,
                         .cache_capacity = cache_entries};
    memory.draw_list = draw_memory(scene->draw_list_needed * sizeof *memory.draw_list);
    memory.display_list = draw_memory(list_words * sizeof *memory.display_list);
    memory.cache = cache_entries > 0 ? draw_memory(cache_entries * sizeof *memory.cache) : NULL;
    DEMAND(fxl_renderer_init_with(renderer, scene, lens, &memory) == FXL_OK);
    const fxl_clipper *which = checked(clipper);
    void *room = which->workspace_size > 0 ? draw_memory(which->workspace_size) : NULL;
    DEMAND(fxl_renderer_set_clipper(renderer, which, room, which->workspace_size) == FXL_OK);
    return renderer;
}

fxl_status draw_choose(fxl_renderer *renderer, const fxl_target *target, void *memory,
                       uint32_t size)
{
    fxl_config config = fxl_config_for(1, 1, target);
    config.depth = memory;
    config.depth_size = size;
    return fxl_renderer_choose(renderer, &config);
}

/* Without a cache of the caller's a frame may use what is left of the order as one. */
static bool has_own_cache(const fxl_renderer *renderer)
{
    const uintptr_t at = (uintptr_t)renderer->workspace.cache.entries;
    return at < (uintptr_t)renderer->frame.draw_list ||
           at >= (uintptr_t)(renderer->frame.draw_list + renderer->scene->draw_list_needed);
}

static void free_renderer(fxl_renderer *renderer)
{
    free(renderer->workspace.cache.clipper_workspace);
    free(renderer->frame.display_list.words);
    if (has_own_cache(renderer)) {
        free(renderer->workspace.cache.entries);
    }
    free(renderer->frame.draw_list);
    free((void *)(uintptr_t)renderer->shader); /* it lies at the beginning of its room */
    free(renderer);
}

/* The same frame again, in bands and with a list and a cache of any size. */
static void draw_again(const fxl_renderer *first, const fxl_pose *pose, const fxl_band *whole,
                       uint32_t clipper, fuzz_input *in)
{
    fxl_counters counters = first->workspace.counters;
    uint32_t words = fuzz_below(in, (counters.drawn + 1) * FXL_DISPLAY_LIST_WORDS(8));
    fxl_renderer *renderer =
        make_renderer(first->scene, &first->frame.view.lens, clipper, words, fuzz_below(in, 40));
    if (fuzz_below(in, 4) == 0) {
        DEMAND(draw_choose(renderer, &fxl_palette_box, NULL, 0) == FXL_OK);
    }
    draw_beams(renderer);
    DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
    draw_in_bands(renderer, whole, in);
    DEMAND(renderer->workspace.counters.spilled <= counters.spilled);
    DEMAND(renderer->workspace.counters.spilled < counters.spilled ||
           renderer->frame.display_list.used == 0);
    counters.spilled = renderer->workspace.counters.spilled;
    DEMAND(memcmp(&counters, &renderer->workspace.counters, sizeof counters) == 0);
    record_number(counters.spilled);
    free_renderer(renderer);
}

/* The same frame front to back by a span buffer of any size, in bands and with any list. */
static void draw_front_to_back(const fxl_renderer *first, const fxl_pose *pose,
                               const fxl_band *whole, uint32_t clipper, fuzz_input *in)
{
    const fxl_lens *lens = &first->frame.view.lens;
    fxl_counters counters = first->workspace.counters;
    uint32_t words = fuzz_below(in, (counters.drawn + 1) * FXL_DISPLAY_LIST_WORDS(8));
    uint32_t size = FXL_SPAN_BUFFER_BYTES_LEAST(lens->width, lens->height);
    fxl_renderer *renderer = make_renderer(first->scene, lens, clipper, words, fuzz_below(in, 40));
    const fxl_target *target = fuzz_below(in, 4) ? &fxl_palette_spans : &fxl_palette_spans_box;
    void *room = draw_memory(size += fuzz_below(in, 12u * lens->height));
    DEMAND(draw_choose(renderer, target, room, size) == FXL_OK);
    draw_beams(renderer);
    DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
    draw_in_bands(renderer, whole, in);
    DEMAND(renderer->workspace.counters.spilled <= counters.spilled);
    counters.spilled = renderer->workspace.counters.spilled;
    counters.split_bands = renderer->workspace.counters.split_bands;
    record_bytes(&renderer->workspace.counters, sizeof counters);
    DEMAND(memcmp(&counters, &renderer->workspace.counters, sizeof counters) == 0);
    free(room);
    free_renderer(renderer);
}

/* The frame by a depth buffer of any size: whole and in bands, with any list. */
static void draw_by_depth(const fxl_renderer *first, const fxl_pose *pose, const fxl_band *whole,
                          uint32_t clipper, fuzz_input *in)
{
    const fxl_lens *lens = &first->frame.view.lens;
    const uint32_t words =
        fuzz_below(in, (first->workspace.counters.drawn + 1) * FXL_DISPLAY_LIST_WORDS(16));
    const bool wide = fuzz_below(in, 4) == 0;
    const uint32_t bits = wide ? 32 : 16, rows = 1 + fuzz_below(in, whole->rows);
    const uint32_t size = FXL_DEPTH_BYTES(lens->width, rows, bits);
    fxl_renderer *renderer = make_renderer(first->scene, lens, clipper, words, fuzz_below(in, 40));
    fxl_band band = make_band(lens, 1, whole->first_row, whole->rows);
    void *cells = draw_memory(size);
    DEMAND(draw_choose(renderer, wide ? &fxl_palette_depth_32 : &fxl_palette_depth_16, cells,
                       size) == FXL_OK);
    draw_beams(renderer);
    DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    demand_gaps_intact(&band);
    draw_in_bands(renderer, &band, in);
    DEMAND(renderer->workspace.counters.drawn == first->workspace.counters.drawn);
    record_band(&band);
    record_bytes(&renderer->workspace.counters, sizeof renderer->workspace.counters);
    free(band.pixels);
    free(cells);
    if (renderer->shader == renderer->target->extras->last) {
        renderer->shader = NULL; /* it is no beams' room */
    }
    free_renderer(renderer);
}

/* The frame with outlines, which go with no beams: whole and in bands, with any list; and what its
 * pixels show. */
static void draw_outlined(const fxl_renderer *first, const fxl_pose *pose, const fxl_band *whole,
                          uint32_t clipper, fuzz_input *in)
{
    const fxl_lens *lens = &first->frame.view.lens;
    if (first->scene->beam_count > 0) {
        return;
    }
    const uint32_t words =
        fuzz_below(in, (first->workspace.counters.drawn + 1) * FXL_DISPLAY_LIST_WORDS(8));
    const uint8_t colour = (uint8_t)fuzz_bits(in, 1);
    const bool keeps = fuzz_below(in, 2) == 1;
    const fxl_outline_style style = {.line = colour, .fill = 3, .keeps_colours = keeps};
    fxl_outlines outlines;
    fxl_renderer *renderer = make_renderer(first->scene, lens, clipper, words, 0);
    fxl_band band = make_band(lens, 1, whole->first_row, whole->rows);
    DEMAND(fxl_attach_outlines(renderer, &outlines, &style) == FXL_OK);
    DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    demand_gaps_intact(&band);
    draw_in_bands(renderer, &band, in);
    draw_picks(renderer, whole, in);
    record_band(&band);
    free(band.pixels);
    DEMAND(fxl_attach_outlines(renderer, NULL, NULL) == FXL_OK);
    free_renderer(renderer);
}

/* The same frame with radii so large that no object is left out, without clusters and without keys.
 * What was drawn was drawn all the same. */
static void draw_all_instances(const fxl_renderer *first, const fxl_pose *pose,
                               const fxl_band *whole, uint32_t clipper)
{
    fxl_scene scene = *first->scene;
    fxl_model *models = draw_memory(scene.model_count * sizeof *models);
    memcpy(models, scene.models, scene.model_count * sizeof *models);
    for (uint32_t i = 0; i < scene.model_count; i++) {
        models[i].radius = FXL_RADIUS_MAX;
        models[i].first_face_bounds = 0;
        models[i].first_cluster = 0;
    }
    scene.models = models;
    scene.face_bounds = NULL;
    fxl_renderer *renderer = make_renderer(&scene, &first->frame.view.lens, clipper, 0, 1);
    draw_beams(renderer);
    fxl_band band = make_band(&first->frame.view.lens, 0, whole->first_row, whole->rows);
    DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    for (uint32_t row = 0; row < whole->rows; row++) {
        DEMAND(memcmp(band.pixels + (size_t)row * band.stride,
                      whole->pixels + (size_t)row * whole->stride, band.width) == 0);
    }
    const fxl_counters *all = &renderer->workspace.counters, *some = &first->workspace.counters;
    DEMAND(all->in == some->in && all->drawn == some->drawn && all->clipped == some->clipped &&
           all->spilled == some->spilled && all->outside <= some->outside);
    record_number(all->outside);
    free(band.pixels);
    free(models);
    free_renderer(renderer);
}

void draw_scene(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                const draw_choice *choice, fuzz_input *in)
{
    fxl_renderer *renderer = make_renderer(scene, lens, choice->clipper, 0, 1);
    draw_beams(renderer);
    fxl_band whole = make_band(lens, fuzz_below(in, 4), choice->first_row, choice->rows);
    DEMAND(fxl_frame_draw(renderer, &whole) == FXL_E_ORDER);
    DEMAND(renderer->workspace.counters.refused_calls == 1);
    renderer->workspace.counters.refused_calls = 0;
    DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
    DEMAND(fxl_frame_draw(renderer, &whole) == FXL_OK);
    demand_gaps_intact(&whole);
    demand_accounted(&renderer->workspace.counters, draw_model_view(scene));
    record_band(&whole);
    record_bytes(&renderer->workspace.counters, sizeof renderer->workspace.counters);
    draw_again(renderer, pose, &whole, choice->clipper, in);
    if (scene->beam_count == 0 &&
        scene->placements == NULL) { /* larger spheres reach into beams, and split outlines anew;
                                   turned ones leave the world */
        draw_all_instances(renderer, pose, &whole, choice->clipper);
    }
    draw_front_to_back(renderer, pose, &whole, choice->clipper, in);
    draw_outlined(renderer, pose, &whole, choice->clipper, in);
    draw_by_depth(renderer, pose, &whole, choice->clipper, in);
    draw_by_bsp(scene, lens, pose, in);
    draw_wireframe(scene, lens, pose, in);
    draw_boxes(scene, lens, pose);
    draw_picks(renderer, &whole, in);
    draw_hits(scene, &renderer->frame.view, in);
    draw_billboards(scene, lens, pose, in);
    free(whole.pixels);
    free_renderer(renderer);
}
