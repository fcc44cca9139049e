/* SPDX-License-Identifier: MIT */
/* Any scene with any surfaces, which are checked, drawn whole and drawn in bands. */
#include <string.h>

#include "answers.h"
#include "parts.h"
#include "study/clippers.h"
#include "study/targets.h"
#include "input.h"

enum {
    PIXELS = 2048,
    TEXTURES = 3,
    SURFACES = 4,
    NORMALS = 4,
    FIRST_CORNERS = 4 /* from one of these on surfaces count */
};

/* Surfaces whose texels, and what is beside them, end where they should. */
typedef struct {
    fxl_texture textures[TEXTURES];
    fxl_surface surfaces[SURFACES];
    fxl_mapped_face faces[MADE_FACES];
    fxl_corner corners[FIRST_CORNERS + 3 * MADE_FACES];
    fxl_direction normals[NORMALS];
    uint16_t face_map[MADE_FACES];
    uint8_t colours[16];
    uint8_t *texels[TEXTURES], *blend;
    fxl_surface_set set;
} made_surfaces;

static uint8_t *block(size_t size)
{
    uint8_t *made = draw_memory(size);
    for (size_t i = 0; i < size; i++) {
        made[i] = (uint8_t)(i * 37);
    }
    return made;
}

/* One number in thirty-two is spoilt: then the set is refused, or it is drawn all the same. */
static uint8_t spoilt(fuzz_input *in, uint32_t number)
{
    return (uint8_t)(fuzz_below(in, 32) == 0 ? fuzz_bits(in, 1) : number);
}

static size_t texel_bytes(const fxl_texture *texture)
{
    const uint32_t least = texture->format == FXL_TEXTURE_4 ? 1 : 0;
    size_t texels = 0;
    for (uint32_t i = 0; i < texture->levels; i++) {
        const uint32_t wide = texture->log_width > i + least ? texture->log_width - i : least;
        const uint32_t high = texture->log_height > i ? texture->log_height - i : 0;
        texels += (size_t)1 << (wide + high);
    }
    return texels >> least;
}

static void make_texture(made_surfaces *made, uint32_t number, fuzz_input *in)
{
    fxl_texture *texture = &made->textures[number];
    const uint32_t format = fuzz_below(in, 2);
    const uint32_t wide = format + fuzz_below(in, fuzz_below(in, 2) ? 4 : 8);
    const uint32_t high = fuzz_below(in, fuzz_below(in, 8) ? 4 : 9);
    memset(texture, 0, sizeof *texture);
    texture->log_width = (uint8_t)wide;
    texture->log_height = (uint8_t)high;
    texture->format = (uint8_t)format;
    texture->flags = (uint8_t)fuzz_below(in, 4);
    texture->key = (uint8_t)fuzz_bits(in, 1);
    texture->levels = (uint8_t)(1 + fuzz_below(in, 1 + (wide > high ? wide : high)));
    texture->colours = format == FXL_TEXTURE_4 ? made->colours : NULL;
    texture->levels = spoilt(in, texture->levels);
    texture->format = spoilt(in, texture->format);
    texture->log_width = spoilt(in, texture->log_width);
    texture->log_height = spoilt(in, texture->log_height);
    texture->key_565 = spoilt(in, 0);
    /* What is spoilt may be sound too. */
    const bool is_bounded = texture->log_width <= FXL_TEXTURE_LOG_MAX &&
                            texture->log_height <= FXL_TEXTURE_LOG_MAX &&
                            texture->levels <= FXL_TEXTURE_LOG_MAX + 1;
    made->texels[number] = block(is_bounded ? texel_bytes(texture) : 0);
    texture->texels = made->texels[number];
    if (fuzz_below(in, 32) == 0) {
        texture->texels = NULL;
    }
}

static void make_surface(fxl_surface *surface, fuzz_input *in)
{
    memset(surface, 0, sizeof *surface);
    surface->texture = spoilt(in, fuzz_below(in, TEXTURES + 1));
    surface->division = spoilt(in, fuzz_below(in, 4));
    surface->flags = spoilt(in, fuzz_below(in, 4));
    surface->opacity = spoilt(in, fuzz_below(in, 2) ? 16 : fuzz_below(in, 17));
    surface->reserved[0] = spoilt(in, 0);
    surface->first_corner = fuzz_below(in, FIRST_CORNERS);
}

static fxl_q16_16 any_texel(fuzz_input *in)
{
    const int32_t limit = fuzz_below(in, 4) ? 64 * 65536 : FXL_TEXEL_MAX;
    return fuzz_below(in, 64) ? fuzz_between(in, -limit, limit) : fuzz_any(in);
}

/* The number of a vertex; if it is spoilt, of any of the model, or of one too many. */
static uint16_t spoilt_vertex(fuzz_input *in, uint32_t number, const fxl_model *model)
{
    return (uint16_t)(fuzz_below(in, 32) == 0 ? fuzz_bits(in, 1) % (model->vertex_count + 1u)
                                              : number);
}

/* Three corners of the face that follow each other. */
static void make_face(made_surfaces *made, uint32_t number, const fxl_scene *scene,
                      const fxl_model *model, fuzz_input *in)
{
    const fxl_face *face = &scene->faces[number];
    const uint32_t first = face->count < 3 ? 0 : fuzz_below(in, face->count - 2u);
    const uint16_t *vertices = &fxl_face_indices(scene->indices, face)[first];
    fxl_mapped_face *mapped = &made->faces[number];
    mapped->surface = spoilt(in, fuzz_below(in, SURFACES));
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t own = FIRST_CORNERS + 3 * number + i;
        const uint32_t at = fuzz_below(in, 64) ? own : (uint32_t)fuzz_bits(in, 1);
        fxl_corner *corner = &made->corners[own];
        mapped->corners[i] =
            (uint16_t)(at - made->surfaces[mapped->surface % SURFACES].first_corner);
        corner->vertex = i == 0 ? vertices[0] : spoilt_vertex(in, vertices[i], model);
        corner->texel.u = any_texel(in);
        corner->texel.v = any_texel(in);
        corner->normal = spoilt(in, fuzz_below(in, NORMALS));
    }
}

static void make_normals(made_surfaces *made, fuzz_input *in)
{
    for (uint32_t i = 0; i < NORMALS; i++) {
        const fxl_pose pose = fuzz_pose(in);
        fxl_camera camera;
        DEMAND(fxl_camera_from_pose(&pose, &camera) == FXL_OK);
        made->normals[i] = camera.axes.forward;
        made->normals[i].x += fuzz_below(in, 64) ? 0 : 5;
    }
}

static void make_surfaces(made_surfaces *made, const fxl_scene *scene, fuzz_input *in)
{
    memset(made, 0, sizeof *made);
    for (uint32_t i = 0; i < TEXTURES; i++) {
        make_texture(made, i, in);
    }
    for (uint32_t i = 0; i < SURFACES; i++) {
        make_surface(&made->surfaces[i], in);
    }
    make_normals(made, in);
    for (uint32_t m = 0; m < scene->model_count; m++) { /* the models take the faces in turn */
        const fxl_model *model = &scene->models[m];
        for (uint32_t i = model->first_face; i < model->first_face + model->face_count; i++) {
            make_face(made, i, scene, model, in);
            made->face_map[i] = (uint16_t)(fuzz_below(in, 4) ? i + 1 : spoilt(in, 0));
        }
    }
    const uint32_t first = fuzz_below(in, 256), count = fuzz_below(in, 257 - first);
    made->blend = block(256 * count);
    made->set = (fxl_surface_set){.textures = made->textures,
                                  .surfaces = made->surfaces,
                                  .faces = made->faces,
                                  .face_map = made->face_map,
                                  .corners = made->corners,
                                  .normals = made->normals,
                                  .texture_count = TEXTURES,
                                  .surface_count = SURFACES,
                                  .face_count = scene->face_count,
                                  .corner_count = FIRST_CORNERS + 3 * scene->face_count,
                                  .normal_count = NORMALS,
                                  .blend = fuzz_below(in, 32) ? made->blend : NULL,
                                  .blend_first = first,
                                  .blend_count = count + (fuzz_below(in, 64) ? 0 : 256)};
}

static void free_surfaces(made_surfaces *made)
{
    for (uint32_t i = 0; i < TEXTURES; i++) {
        free(made->texels[i]);
    }
    free(made->blend);
}

static void misuse(fxl_renderer *renderer, made_surfaces *made, const fxl_scene *scene)
{
    static fxl_renderer none;
    static fxl_surfaces surfaces;
    static uint8_t palette[768], table[512];
    fxl_surface_set set = made->set;
    const fxl_painter *painter = FXL_SURFACES_OF(fxl_palette);
    DEMAND(fxl_attach_surfaces(NULL, &surfaces, &set, painter) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_surfaces(renderer, NULL, &set, painter) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_surfaces(renderer, &surfaces, &set, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_surfaces(&none, &surfaces, &set, painter) == FXL_E_ORDER);
    DEMAND(fxl_attach_lit(NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_lit(&none, NULL) == FXL_E_ORDER);
    DEMAND(fxl_blend_make_table(NULL, 8, 0, 1, table) == FXL_E_ARGUMENT);
    DEMAND(fxl_blend_make_table(palette, 17, 0, 1, table) == FXL_E_RANGE);
    DEMAND(fxl_blend_make_table(palette, 0, 0, 1, table) == FXL_E_RANGE);
    DEMAND(fxl_blend_make_table(palette, 16, 255, 2, table) == FXL_E_COUNT);
    DEMAND(fxl_blend_make_table(palette, 16, 256, 1, table) == FXL_E_COUNT);
    DEMAND(fxl_blend_make_table(palette, 16, 0, 0, table) == FXL_E_COUNT);
    DEMAND(fxl_blend_make_table(palette, 8, 254, 2, table) == FXL_OK && table[511] == 255);
    DEMAND(fxl_surfaces_check(NULL, scene, 8, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_surfaces_check(&set, NULL, 8, NULL) == FXL_E_ARGUMENT);
    set.face_map = NULL;
    DEMAND(fxl_surfaces_check(&set, scene, 8, NULL) == FXL_E_ARGUMENT);
    set = made->set;
    set.face_count = FXL_MAPPED_FACES_MAX + 1;
    DEMAND(fxl_surfaces_check(&set, scene, 8, NULL) == FXL_E_COUNT);
}

/* The frame whole, without a list, and in bands, with one of any size. */
static void draw_twice(fxl_renderer *renderer, fuzz_input *in)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    const fxl_pose pose = fuzz_pose(in);
    const size_t size = (size_t)lens->width * lens->height;
    const uint32_t words = fuzz_below(in, 2) ? 4096 : fuzz_below(in, 200);
    uint8_t *whole = draw_memory(size), *bands = draw_memory(size);
    void *list = draw_memory(4 * (size_t)words);
    renderer->frame.display_list.capacity = 0;
    DEMAND(fxl_frame_begin(renderer, &pose) == FXL_OK);
    draw_bands(renderer, whole, lens->height, lens->height);
    DEMAND(renderer->workspace.counters.in == draw_model_view(renderer->scene));
    renderer->frame.display_list.words = list;
    renderer->frame.display_list.capacity = words;
    DEMAND(fxl_frame_begin(renderer, &pose) == FXL_OK);
    draw_bands(renderer, bands, lens->height, 1 + fuzz_below(in, lens->height));
    DEMAND(memcmp(whole, bands, size) == 0);
    draw_all_picks(renderer, NULL);
    draw_in_another(renderer, whole, DRAW_BACKGROUND, in);
    record_bytes(whole, size);
    record_bytes(&renderer->workspace.counters, sizeof renderer->workspace.counters);
    free(whole);
    free(bands);
    free(list);
}

void draw_attach(fxl_renderer *renderer, draw_parts *parts, const fxl_surface_set *set,
                 const fxl_painter *painter, bool is_lit)
{
    const fxl_light_settings settings = parts->light.settings;
    DEMAND(fxl_attach_light(renderer, &parts->light, &settings) == FXL_OK);
    DEMAND(fxl_attach_surfaces(renderer, &parts->surfaces, set, painter) == FXL_OK);
    DEMAND(fxl_attach_lit(renderer, is_lit ? &parts->lit : NULL) == FXL_OK);
}

void draw_detach(fxl_renderer *renderer)
{
    DEMAND(fxl_attach_lit(renderer, NULL) == FXL_OK);
    DEMAND(fxl_attach_light(renderer, NULL, NULL) == FXL_OK);
    DEMAND(fxl_attach_surfaces(renderer, NULL, NULL, NULL) == FXL_OK);
}

/* The same by a depth buffer of any size. */
static void draw_twice_by_depth(fxl_renderer *renderer, draw_parts *parts,
                                const fxl_surface_set *set, bool is_lit, fuzz_input *in)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    const bool wide = fuzz_below(in, 4) == 0;
    const fxl_target *target = wide ? &fxl_palette_depth_32 : &fxl_palette_depth_16;
    const uint32_t least = FXL_DEPTH_BYTES(lens->width, 1, wide ? 32u : 16u);
    const uint32_t size = least + fuzz_below(in, 4u * lens->width * lens->height);
    uint8_t *cells = draw_memory(size);
    DEMAND(draw_choose(renderer, target, cells, size) == FXL_E_ORDER);
    draw_detach(renderer);
    DEMAND(draw_choose(renderer, NULL, cells, size) == FXL_E_ARGUMENT);
    DEMAND(draw_choose(renderer, target, NULL, size) == FXL_E_ARGUMENT);
    DEMAND(draw_choose(renderer, target, cells, least - 1) == FXL_E_CAPACITY);
    DEMAND(draw_choose(renderer, target, cells, size) == FXL_OK);
    draw_attach(renderer, parts, set,
                wide ? FXL_SURFACES_OF(fxl_palette_depth_32)
                     : FXL_SURFACES_OF(fxl_palette_depth_16),
                is_lit);
    draw_twice(renderer, in);
    draw_detach(renderer);
    free(cells);
}

/* The same faces with light alone, whose planes may be words, in a whole frame with depths of 16
 * bits. */
static void draw_light_alone(fxl_renderer *renderer, draw_parts *parts, made_surfaces *made,
                             fuzz_input *in)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    const uint32_t size = FXL_DEPTH_BYTES(lens->width, lens->height, 16u);
    uint8_t *cells = draw_memory(size);
    for (uint32_t i = 0; i < made->set.surface_count; i++) {
        made->surfaces[i] = (fxl_surface){.flags = FXL_SURFACE_LIT,
                                          .opacity = 16,
                                          .first_corner = made->surfaces[i].first_corner};
    }
    if (fxl_surfaces_check(&made->set, renderer->scene, 8, NULL) != FXL_OK) {
        free(cells);
        return; /* a face has no normals */
    }
    DEMAND(draw_choose(renderer, &fxl_palette_depth_16, cells, size) == FXL_OK);
    draw_attach(renderer, parts, &made->set, FXL_SURFACES_OF(fxl_palette_depth_16), true);
    draw_twice(renderer, in);
    draw_detach(renderer);
    free(cells);
}

static void set_plain_light(fxl_renderer *renderer, fxl_light *light)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(2)] = {1, 2, 3};
    const fxl_light_settings settings = {.ambient = FXL_Q2_30_ONE / 3,
                                         .strength = FXL_Q2_30_ONE,
                                         .direction = {0, -FXL_Q2_30_ONE, 0},
                                         .ramp = ramp,
                                         .levels = 2};
    DEMAND(fxl_attach_light(renderer, light, &settings) == FXL_OK);
}

/* place clipper: only if a random clipper is to draw surfaces: a list of four */
static void draw_made(const fxl_scene *scene, made_surfaces *made, fuzz_input *in)
{
    static const fxl_clipper *const clippers[] = {&fxl_clipper_view, &fxl_clipper_triangles,
                                                  &fxl_clipper_near, &fxl_clipper_world};
    static draw_parts parts;
    const fxl_clipper *clipper = clippers[fuzz_below(in, 4)];
    const fxl_lens lens = fuzz_lens(in, PIXELS);
    void *order = draw_memory(scene->draw_list_needed * sizeof(fxl_draw_entry)),
         *room = draw_memory(clipper->workspace_size);
    const fxl_memory memory = {.draw_list = order, .draw_list_capacity = scene->draw_list_needed};
    fxl_renderer renderer;
    fxl_scene_fault fault = {NULL, 0};
    memset(&parts, 0, sizeof parts);
    DEMAND(fxl_renderer_init_with(&renderer, scene, &lens, &memory) == FXL_OK);
    DEMAND(fxl_renderer_set_clipper(&renderer, clipper, clipper->workspace_size > 0 ? room : NULL,
                                    clipper->workspace_size) == FXL_OK);
    fuzz_set_light(&renderer, &parts.light, in);
    const bool is_plain = parts.light.settings.ramp == NULL;
    if (is_plain) {
        set_plain_light(&renderer, &parts.light);
    }
    const fxl_painter *painter = FXL_SURFACES_OF(fxl_palette);
    DEMAND(fxl_attach_surfaces(&renderer, &parts.surfaces, &made->set, NULL) == FXL_E_ARGUMENT);
    const fxl_status status = fxl_surfaces_check(&made->set, scene, 8, &fault);
    DEMAND((status == FXL_OK) == (fault.what == NULL));
    DEMAND(fxl_attach_surfaces(&renderer, &parts.surfaces, &made->set, painter) == status);
    if (status == FXL_OK) {
        const bool is_lit = is_plain || fuzz_below(in, 4);
        draw_attach(&renderer, &parts, &made->set, painter, is_lit);
        draw_twice(&renderer, in);
        draw_twice_by_depth(&renderer, &parts, &made->set, is_lit, in);
        draw_rgb565(&renderer, &parts, &made->set, in);
        misuse(&renderer, made, scene);
        draw_light_alone(&renderer, &parts, made, in);
    }
    if (status == FXL_OK) {
        const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
        draw_lines(scene, &lens, &pose, &made->set, in);
    }
    free(order);
    free(room);
}

void fuzz_surfaces(fuzz_input *in)
{
    static made_surfaces surfaces;
    made_scene *made = make_scene(in);
    if (fuzz_below(in, 2)) {
        add_placements(made, in);
    }
    if (fxl_scene_check_all(&made->scene, NULL) == FXL_OK) {
        make_surfaces(&surfaces, &made->scene, in);
        draw_made(&made->scene, &surfaces, in);
        free_surfaces(&surfaces);
    }
    free_scene(made);
}
