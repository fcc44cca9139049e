/* SPDX-License-Identifier: MIT */
#include "frames/session.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frames/read_file.h"

void *session_memory(size_t size)
{
    void *memory = calloc(size > 0 ? size : 1, 1);
    if (!memory) {
        fputs("error: there is not enough memory\n", stderr);
        exit(2);
    }
    return memory;
}

const char *session_open(session *run, const char *path)
{
    size_t size;
    const uint8_t *bytes = read_file(path, &size);
    if (!bytes) {
        return "it cannot be read";
    }
    fxl_status status = fxl_scene_open(bytes, size, &run->image, NULL);
    if (status == FXL_OK && run->image.surfaces.face_map) {
        const uint32_t count = run->image.surfaces.texture_count;
        status = fxl_surfaces_open(&run->image, session_memory(count * sizeof(fxl_texture)), count,
                                   &run->surface_set, NULL);
    }
    if (status == FXL_OK && run->image.billboards.model_map) {
        const uint32_t count = run->image.billboards.count;
        status = fxl_billboards_open(&run->image, session_memory(count * sizeof(fxl_sprite)),
                                     session_memory(count * sizeof(fxl_billboard)), count,
                                     &run->billboard_set, NULL);
    }
    if (status == FXL_OK && run->image.motion.motion_count > 0) {
        fxl_scene *scene = &run->image.scene;
        const uint32_t turned = scene->instance_count - scene->first_turned;
        const fxl_motion_memory memory = {
            session_memory(scene->instance_count * sizeof(fxl_instance)), scene->instance_count,
            session_memory(turned * sizeof(fxl_turn)), turned};
        status = fxl_motion_begin(&run->motion, &run->image.motion, scene, &memory);
    }
    return status == FXL_OK ? NULL : fxl_status_text(status);
}

const fxl_visibility *session_visibility(const session *run)
{
    return run->image.depth_bits != 0 ? &fxl_visibility_depth
           : run->image.scene.bsp_nodes != NULL        ? &fxl_visibility_bsp
           : run->image.surfaces.face_map              ? &fxl_visibility_surfaces
                                                       : &fxl_visibility_sorted;
}

void session_play(const session *run, uint32_t frame)
{
    if (run->image.motion.motion_count > 0) {
        fxl_motion_play(&run->motion, frame);
    }
}

uint32_t session_submit_bytes(const session *run, const fxl_visibility *visibility)
{
    return visibility->order->memory_size
               ? (visibility->order->memory_size(&run->image.scene) + 7u) & ~7u
               : 0;
}

static uint32_t beam_light_bytes(const fxl_scene *scene)
{
    return scene->beam_count > 0 ? fxl_beam_light_workspace_size(scene->beams, scene->beam_count)
                                 : 0;
}

void session_reserve(session *run, const session_settings *most)
{
    const fxl_scene *scene = &run->image.scene;
    run->memory = (fxl_memory){session_memory(scene->order_needed * sizeof(fxl_order_entry)),
                               scene->order_needed,
                               session_memory(sizeof(uint32_t) * (size_t)most->display_list_words),
                               most->display_list_words,
                               session_memory(most->cache_entries * sizeof(fxl_cached_vertex)),
                               most->cache_entries};
    run->workspace =
        session_memory(session_submit_bytes(run, most->visibility) + (size_t)most->raster_bytes);
    run->pieces = session_memory(most->pieces_bytes);
    run->beam_light = session_memory(beam_light_bytes(scene));
}

static bool goes_by_bsp(const session *run, const fxl_visibility *visibility)
{
    return run->image.scene.bsp_nodes &&
           visibility->order->memory_size == fxl_visibility_bsp.order->memory_size;
}

/* Lights flat faces and surfaces. */
static fxl_status light_all(session *run, const fxl_light_settings *settings)
{
    const fxl_status status = fxl_renderer_set_light(&run->renderer, &run->light, settings);
    return status == FXL_OK && run->has_surfaces
               ? fxl_renderer_light_surfaces(&run->renderer, &run->light)
               : status;
}

static bool has_depth(const fxl_visibility *visibility)
{
    return visibility->target == fxl_visibility_depth.target ||
           visibility->target == fxl_visibility_depth_32.target;
}

/* After the visibility method is set. */
static fxl_status add_billboards(session *run)
{
    if (!run->image.billboards.model_map) {
        return FXL_OK;
    }
    return run->renderer.target->depth_bits > 0
               ? fxl_renderer_set_billboards_by_depth(&run->renderer, &run->billboards,
                                                      &run->billboard_set)
               : fxl_renderer_set_billboards(&run->renderer, &run->billboards, &run->billboard_set);
}

fxl_status session_set_up(session *run, const session_settings *settings)
{
    const fxl_scene *scene = &run->image.scene;
    fxl_renderer *renderer = &run->renderer;
    fxl_memory memory = run->memory;
    memory.display_list_capacity = settings->display_list_words;
    memory.cache_capacity = settings->cache_entries;
    fxl_status status = fxl_renderer_init_with(renderer, scene, &run->image.lens, &memory);
    if (status == FXL_OK) {
        status = fxl_renderer_set_clipper(renderer, settings->clipper, &run->clipper_workspace,
                                          sizeof run->clipper_workspace);
    }
    run->has_surfaces = run->image.surfaces.face_map && !settings->without_surfaces;
    if (status == FXL_OK && run->has_surfaces) {
        status = fxl_renderer_set_surfaces(renderer, &run->surfaces, &run->surface_set);
    }
    if (status == FXL_OK && has_depth(settings->visibility)) {
        status = fxl_renderer_set_depth(renderer, &run->depth, settings->visibility, run->workspace,
                                        settings->raster_bytes);
    } else if (status == FXL_OK) {
        status = fxl_renderer_set_visibility(renderer, settings->visibility, run->workspace,
                                             session_submit_bytes(run, settings->visibility) +
                                                 settings->raster_bytes);
    }
    if (status == FXL_OK) {
        status = add_billboards(run);
    }
    if (status == FXL_OK && scene->beam_count > 0) {
        status = fxl_renderer_set_beams(renderer, scene->beams, scene->beam_count, scene->lit,
                                        run->beam_light, beam_light_bytes(scene));
    }
    if (status == FXL_OK && goes_by_bsp(run, settings->visibility)) {
        fxl_bsp_workspace *bsp = run->workspace;
        bsp->pieces = run->pieces;
        bsp->pieces_size = settings->pieces_bytes;
    }
    if (status == FXL_OK && run->image.light.base) {
        fxl_light_settings light;
        fxl_light_settings_of(&run->image.light, &light);
        status = light_all(run, &light);
    }
    return status;
}

fxl_status session_light(session *run, const named_light *light)
{
    fxl_light_settings settings;
    memset(&settings, 0, sizeof settings);
    settings.ambient = light->ambient;
    settings.strength = light->strength;
    settings.direction =
        (fxl_direction){light->direction[0], light->direction[1], light->direction[2]};
    settings.point_count = (uint32_t)light->point_count;
    for (int i = 0; i < light->point_count; i++) {
        const int32_t *at = light->points[i].position;
        settings.points[i] = (fxl_point_light){
            {at[0], at[1], at[2]}, light->points[i].range, light->points[i].strength};
    }
    settings.fog_near = light->fog_near;
    settings.fog_far = light->fog_far;
    settings.levels = (uint32_t)light->levels;
    settings.ramp = run->ramp;
    fxl_status status =
        fxl_light_make_ramp(run->image.palette, light->dark, settings.levels, run->ramp);
    return status == FXL_OK ? light_all(run, &settings) : status;
}

fxl_status session_draw_bands(const fxl_lens *lens, uint32_t rows, uint8_t background,
                              uint8_t *pixels, session_band_drawer *draw, void *with)
{
    fxl_status status = FXL_OK;
    rows = rows > 0 ? rows : lens->height;
    for (uint32_t row = 0; status == FXL_OK && row < lens->height; row += rows) {
        const uint32_t left = lens->height - row;
        const fxl_band band = {.pixels = pixels + (size_t)row * lens->width, .width = lens->width,
                               .stride = lens->width, .first_row = (uint16_t)row,
                               .rows = (uint16_t)(rows < left ? rows : left)};
        fxl_fill_band(&band, background);
        status = draw(with, &band);
    }
    return status;
}

fxl_status session_draw_band(void *renderer, const fxl_band *band)
{
    return fxl_frame_draw(renderer, band);
}

fxl_status session_draw(session *run, const fxl_pose *pose, uint32_t rows, uint8_t background,
                        uint8_t *pixels)
{
    fxl_status status = fxl_frame_begin(&run->renderer, pose);
    return status == FXL_OK ? session_draw_bands(&run->image.lens, rows, background, pixels,
                                                 session_draw_band, &run->renderer)
                            : status;
}
