/* SPDX-License-Identifier: MIT */
#include "frames/session.h"

#include <stdlib.h>
#include <string.h>

#include "frames/input.h"

void *session_memory(size_t size)
{
    void *memory = calloc(size > 0 ? size : 1, 1);
    if (!memory) {
        give_up("there is not enough memory");
    }
    return memory;
}

const char *session_open(session *run, const char *path)
{
    size_t size;
    const uint8_t *bytes = read_file(path, &size);
    return bytes ? session_open_bytes(run, bytes, size) : "it cannot be read";
}

const char *session_open_bytes(session *run, const uint8_t *bytes, size_t size)
{
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
            session_memory(turned * sizeof(fxl_placement)), turned};
        status = fxl_motion_begin(&run->motion, &run->image.motion, scene, &memory);
    }
    return status == FXL_OK ? NULL : fxl_status_text(status);
}

void session_follow_scene(const session *run, session_settings *settings)
{
    const fxl_scene_image *image = &run->image;
    const bool has_tree = image->scene.bsp_nodes != NULL && !image->by_distance;
    settings->target = image->depth_bits == 32  ? &fxl_palette_depth_32
                       : image->depth_bits != 0 ? &fxl_palette_depth_16
                                                : &fxl_palette;
    settings->order = image->depth_bits == 0 && has_tree ? &fxl_by_tree : &fxl_by_distance;
}

void session_play(const session *run, uint32_t frame)
{
    if (run->image.motion.motion_count > 0) {
        fxl_motion_play(&run->motion, frame);
    }
}

/* What an order needs. */
static uint32_t order_bytes(const session *run, const fxl_order *order)
{
    return order->memory_size ? (order->memory_size(&run->image.scene) + 7u) & ~7u : 0;
}

static uint32_t beam_light_bytes(const fxl_scene *scene)
{
    return scene->beam_count > 0 ? fxl_beam_light_workspace_size(scene->beams, scene->beam_count)
                                 : 0;
}

void session_reserve(session *run, const session_settings *most)
{
    const fxl_scene *scene = &run->image.scene;
    run->memory = (fxl_memory){session_memory(scene->draw_list_needed * sizeof(fxl_draw_entry)),
                               scene->draw_list_needed,
                               session_memory(sizeof(uint32_t) * (size_t)most->display_list_words),
                               most->display_list_words,
                               session_memory(most->cache_entries * sizeof(fxl_cached_vertex)),
                               most->cache_entries};
    run->tree = session_memory(order_bytes(run, most->order) + most->pieces_bytes);
    run->depth = session_memory(most->raster_bytes);
    run->beam_light = session_memory(beam_light_bytes(scene));
}

/* Lights flat faces and surfaces. */
static fxl_status light_all(session *run, const fxl_light_settings *settings)
{
    fxl_renderer *renderer = &run->renderer;
    const fxl_status status = fxl_attach_light(renderer, &run->light, settings);
    return status == FXL_OK ? fxl_attach_lit(renderer, &run->lit) : status;
}

/* place pixel-format: the option pixels, the targets, frames as files */
/* The six targets, and what draws into them. */
static const struct {
    const fxl_target *target;
    const fxl_painter *surfaces;
    const fxl_sprite_painter *sprites;
} painters[] = {
    {&fxl_palette, &fxl_palette_surfaces, &fxl_palette_sprites},
    {&fxl_palette_depth_16, &fxl_palette_depth_16_surfaces, &fxl_palette_depth_16_sprites},
    {&fxl_palette_depth_32, &fxl_palette_depth_32_surfaces, &fxl_palette_depth_32_sprites},
    {&fxl_rgb565, &fxl_rgb565_surfaces, &fxl_rgb565_sprites},
    {&fxl_rgb565_depth_16, &fxl_rgb565_depth_16_surfaces, &fxl_rgb565_depth_16_sprites},
    {&fxl_rgb565_depth_32, &fxl_rgb565_depth_32_surfaces, &fxl_rgb565_depth_32_sprites},
};

enum {
    TARGETS = sizeof painters / sizeof *painters
};

static const fxl_target *target_of(const session_settings *settings)
{
    const fxl_target *named = settings->target;
    for (int i = 0; settings->pixel_bits == 16 && i < TARGETS; i++) {
        const fxl_target *target = painters[i].target;
        if (target->pixel_bits == 16 && target->depth_bits == named->depth_bits) {
            return target;
        }
    }
    return named;
}

static fxl_status choose(session *run, const session_settings *settings)
{
    const uint32_t tree = order_bytes(run, settings->order);
    const fxl_config config = {.order = settings->order,
                               .target = target_of(settings),
                               .palette = run->palette,
                               .depth = run->depth,
                               .depth_size = settings->raster_bytes,
                               .tree = run->tree,
                               .tree_size = tree > 0 ? tree + settings->pieces_bytes : 0};
    for (int i = 0; i < 256; i++) {
        const uint8_t *colour = run->image.palette + 3 * i;
        run->palette[i] = FXL_RGB565(colour[0], colour[1], colour[2]);
    }
    return fxl_renderer_choose(&run->renderer, &config);
}

/* What draws into the renderer's target. Nothing draws into a target of the study: the palette's
 * are refused when a frame begins. */
static int painters_of(const fxl_renderer *renderer)
{
    for (int i = 0; i < TARGETS; i++) {
        if (painters[i].target == renderer->target) {
            return i;
        }
    }
    return 0;
}

static fxl_status attach_pictures(session *run, bool without_surfaces)
{
    fxl_renderer *renderer = &run->renderer;
    const int number = painters_of(renderer);
    fxl_status status = FXL_OK;
    if (run->image.surfaces.face_map && !without_surfaces) {
        status = fxl_attach_surfaces(renderer, &run->surfaces, &run->surface_set,
                                     painters[number].surfaces);
    }
    if (status == FXL_OK && run->image.billboards.model_map) {
        status = fxl_attach_billboards(renderer, &run->billboards, &run->billboard_set,
                                       painters[number].sprites);
    }
    if (status == FXL_OK && run->image.lines.line_map) {
        status = fxl_attach_lines(renderer, &run->lines, &run->image.lines);
    }
    if (status == FXL_OK && run->image.horizon.sines) {
        status = fxl_attach_horizon(renderer, &run->image.horizon);
    }
    return status;
}

fxl_status session_take_scale(fxl_scene_image *image)
{
    const fxl_lens lens = image->lens;
    if (image->scale == 0) {
        return FXL_OK;
    }
    const fxl_status status = fxl_lens_orthographic(lens.width, lens.height, image->scale,
                                                    lens.near_z, lens.far_z, &image->lens);
    return status != FXL_OK ? status
                            : fxl_lens_set_centre(&image->lens, lens.centre_x, lens.centre_y);
}

fxl_status session_set_up(session *run, const session_settings *settings)
{
    const fxl_scene *scene = &run->image.scene;
    fxl_renderer *renderer = &run->renderer;
    fxl_memory memory = run->memory;
    memory.display_list_capacity = settings->display_list_words;
    memory.cache_capacity = settings->cache_entries;
    fxl_status status = session_take_scale(&run->image);
    if (status == FXL_OK) {
        status = fxl_renderer_init_with(renderer, scene, &run->image.lens, &memory);
    }
    if (status == FXL_OK) {
        status = fxl_renderer_set_clipper(renderer, settings->clipper, &run->clipper_workspace,
                                          sizeof run->clipper_workspace);
    }
    if (status == FXL_OK) {
        status = choose(run, settings);
    }
    if (status == FXL_OK) {
        status = attach_pictures(run, settings->without_surfaces);
    }
    if (status == FXL_OK && scene->beam_count > 0) {
        const fxl_beam_set set = {scene->beams, scene->beam_count, scene->lit};
        status = fxl_attach_beams(renderer, &set, run->beam_light, beam_light_bytes(scene));
    }
    if (status == FXL_OK && run->image.light.base) {
        fxl_light_settings light;
        fxl_light_settings_of(&run->image.light, &light);
        status = light_all(run, &light);
    }
    return status;
}

/* place light: a new setting: who draws with settings by name */
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
    settings.dark = FXL_RGB565(light->dark[0], light->dark[1], light->dark[2]);
    fxl_status status =
        fxl_light_make_ramp(run->image.palette, light->dark, settings.levels, run->ramp);
    return status == FXL_OK ? light_all(run, &settings) : status;
}

/* renderer: what clears the bands; null: the palette's target. palette: of frames of 16 bits a pixel; else null. */
static fxl_status draw_bands(const fxl_renderer *renderer, const fxl_lens *lens, uint32_t rows,
                             uint8_t background, const uint16_t *palette, uint8_t *pixels,
                             session_band_drawer *draw, void *with)
{
    const size_t row_bytes = (size_t)lens->width * (palette ? 2 : 1);
    fxl_status status = FXL_OK;
    rows = rows > 0 ? rows : lens->height;
    for (uint32_t row = 0; status == FXL_OK && row < lens->height; row += rows) {
        const uint32_t left = lens->height - row;
        const fxl_band band = {.pixels = pixels + row * row_bytes,
                               .width = lens->width,
                               .stride = lens->width,
                               .first_row = (uint16_t)row,
                               .rows = (uint16_t)(rows < left ? rows : left),
                               .palette = palette};
        (renderer ? renderer->fill : fxl_palette.fill)(renderer, &band, background);
        status = draw(with, &band);
    }
    return status;
}

fxl_status session_draw_bands(const fxl_lens *lens, uint32_t rows, uint8_t background,
                              uint8_t *pixels, session_band_drawer *draw, void *with)
{
    return draw_bands(NULL, lens, rows, background, NULL, pixels, draw, with);
}

fxl_status session_draw_band(void *renderer, const fxl_band *band)
{
    return fxl_frame_draw(renderer, band);
}

uint8_t session_pixel_bits(const session *run)
{
    return run->renderer.target->pixel_bits;
}

fxl_status session_add_core(session *run)
{
    const size_t size = fxl_workspace_size(&run->renderer) + 4096;
    run->has_second = true;
    return fxl_workspace_init(&run->second, &run->renderer, session_memory(size), size);
}

/* A band of a frame, in the workspace whose turn it is, and what is drawn over it. */
static fxl_status draw_in_turn(void *with, const fxl_band *band)
{
    session *run = with;
    const bool is_second = run->has_second && run->bands++ % 2 != 0;
    fxl_status status = is_second ? fxl_frame_draw_with(&run->renderer, &run->second, band)
                                  : fxl_frame_draw(&run->renderer, band);
    if (status == FXL_OK && run->border > 0) {
        status = fxl_draw_border(band, 4, 4, 24, 16, (uint8_t)(run->border - 1));
    }
    return status;
}

fxl_status session_draw(session *run, const fxl_pose *pose, uint32_t rows, uint8_t background,
                        void *pixels)
{
    const uint16_t *palette = session_pixel_bits(run) == 16 ? run->palette : NULL;
    fxl_status status = fxl_frame_begin(&run->renderer, pose);
    run->bands = 0;
    return status == FXL_OK
               ? draw_bands(&run->renderer, &run->image.lens, rows, background, palette, pixels,
                            draw_in_turn, run)
               : status;
}
