/* SPDX-License-Identifier: MIT */
#include "changed_unit.h"

#include "bsp_scene.h"

enum {
    FACES = 13,
    LEVELS = 4,
    LIST = 300,
    TEXEL = 60
};

#define WAY(target) \
    { \
        &target, FXL_SURFACES_OF(target), FXL_SPRITES_OF(target) \
    }

const changed_target changed_palette = WAY(fxl_palette);
const changed_target changed_targets[CHANGED_TARGETS] = {
    WAY(fxl_palette), WAY(fxl_palette_depth_16), WAY(fxl_palette_depth_32),
    WAY(fxl_rgb565),  WAY(fxl_rgb565_depth_16),  WAY(fxl_rgb565_depth_32)};
static const fxl_direction normals[] = {{0, 0, -FXL_Q2_30_ONE}};

static fxl_point vertices[20];
static uint16_t indices[52];
static fxl_face faces[FACES];
static fxl_model models[CHANGED_MODELS];
static fxl_scene scene;
fxl_world changed_world;
static fxl_instance instances[CHANGED_PLACES];
static fxl_placement placements[CHANGED_TURNED];
static fxl_world_slot slots[CHANGED_PLACES];
static uint8_t tables[3 * 256], ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)], brighter[256];
static uint8_t blend[FXL_BLEND_TABLE_BYTES(8)], texels[4 * 4];
uint8_t changed_sprite_pixels[CHANGED_BOARDS][5 * 4];
uint16_t changed_colours[256];
static fxl_draw_entry order[CHANGED_PLACES + 6];
static uint32_t list[LIST];
static uint64_t cells[FXL_DEPTH_BYTES(CHANGED_WIDTH, 16, 32) / 8], tree_room[512], beam_room[512];
uint64_t changed_kept[CHANGED_KEPT];
fxl_renderer changed_renderer;
static fxl_texture texture;
static fxl_surface surface_table[2];
static fxl_mapped_face mapped[2];
static fxl_corner corners[3];
static uint16_t face_map[FACES];
uint16_t changed_model_map[CHANGED_MODELS];
static fxl_surface_set surface_set;
static fxl_surfaces surfaces;
static fxl_light light;
static fxl_light_settings lamp;
static fxl_lit_surfaces lit;
static fxl_beam beam;
static fxl_beam_set beam_set;
fxl_sprite changed_sprites[CHANGED_BOARDS];
fxl_billboard changed_boards[CHANGED_BOARDS];
static fxl_billboard_set board_set;
static fxl_billboards billboards;
static fxl_outlines outlines;
static fxl_lines lines_attached;
static const fxl_line lines[] = {
    {0, 7, {0, 0}, 9, 16, 0}, {1, 1, {0, 0}, 10, 13, 0}, {2, 4, {5, 2}, 11, 3, 0}};
static const uint32_t line_map[CHANGED_MODELS + 1] = {0, 3, 3, 3};
static const fxl_line_set line_set = {lines, 3, line_map};
static const fxl_q2_30 sines[] = {-Q30(0.2), 0, Q30(0.1)};
static const uint8_t elevations[] = {1, 2, 3, 4};
static const fxl_horizon horizon = {sines, elevations, 3};
static fxl_world_colours recolour;
fxl_changed changed;
fxl_handle changed_handles[CHANGED_PLACES];
uint32_t changed_handle_count;
fxl_pose changed_eye;
const changed_target *changed_into;

/* --- the scene ------------------------------------------------------------------------------ */

static void make_tables(void)
{
    for (uint32_t i = 0; i < 256; i++) {
        changed_colours[i] = (uint16_t)(i * 257u + 3u);
        brighter[i] = (uint8_t)(i + 9);
        for (uint32_t level = 0; level < LEVELS; level++) {
            ramp[256 * level + i] = (uint8_t)(i + 70 * (LEVELS - 1 - level));
        }
        for (uint32_t table = 0; table < 3; table++) {
            tables[256 * table + i] = (uint8_t)(i + 30 * (table + 1));
        }
    }
    for (uint32_t i = 0; i < sizeof blend; i++) {
        blend[i] = (uint8_t)(i * 7u + i / 256u);
    }
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(TEXEL + i % 8);
    }
    for (uint32_t i = 0; i < sizeof changed_sprite_pixels; i++) {
        changed_sprite_pixels[i / 20][i % 20] = (uint8_t)(100 + i);
    }
}

/* The cubes of tiny.h, the second with a tree if asked, and a face for the billboard. */
static void make_scene(bool with_tree)
{
    bsp_scene *made = bsp_make();
    const tiny_scene *tiny = made->tiny;
    memcpy(vertices, tiny->vertices, sizeof tiny->vertices);
    memcpy(&vertices[16], tiny->vertices, 4 * sizeof vertices[0]);
    memcpy(indices, tiny->corners, sizeof tiny->corners);
    memcpy(&indices[48], tiny->corners, 4 * sizeof indices[0]);
    memcpy(faces, tiny->faces, sizeof tiny->faces);
    memcpy(models, tiny->models, sizeof tiny->models);
    faces[12] = tiny->faces[0];
    fxl_face_take_indices(&faces[12], indices, 48);
    models[2] = (fxl_model){.first_vertex = 16,
                            .vertex_count = 4,
                            .first_face = 12,
                            .face_count = 1,
                            .kind = FXL_MODEL_CONVEX,
                            .radius = Q16(3.5)};
    scene = tiny->scene;
    scene.vertices = vertices;
    scene.indices = indices;
    scene.faces = faces;
    scene.models = models;
    scene.vertex_count = 20;
    scene.index_count = 52;
    scene.face_count = FACES;
    scene.model_count = CHANGED_MODELS;
    if (!with_tree) {
        scene.bsp_nodes = NULL;
        scene.bsp_node_count = scene.bsp_instance = 0;
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&scene, NULL));
}

static void make_attachments(void)
{
    texture = (fxl_texture){.texels = texels, .log_width = 2, .log_height = 2, .levels = 1};
    surface_table[0] = (fxl_surface){.texture = 1, .opacity = 9, .flags = FXL_SURFACE_LIT};
    surface_table[1] = (fxl_surface){.texture = 1, .opacity = 16, .flags = FXL_SURFACE_BLEND};
    for (uint32_t i = 0; i < 3; i++) {
        const uint16_t *of = fxl_face_indices(indices, &faces[4]);
        corners[i] = (fxl_corner){{i == 2 ? Q16(4) : 0, i == 1 ? Q16(4) : 0}, of[i], 0};
        mapped[0].corners[i] = mapped[1].corners[i] = (uint16_t)i;
    }
    mapped[1].surface = 1;
    memset(face_map, 0, sizeof face_map);
    face_map[4] = 1;
    face_map[10] = 2;
    surface_set = (fxl_surface_set){.textures = &texture,
                                    .surfaces = surface_table,
                                    .faces = mapped,
                                    .face_map = face_map,
                                    .corners = corners,
                                    .normals = normals,
                                    .texture_count = 1,
                                    .surface_count = 2,
                                    .face_count = 2,
                                    .corner_count = 3,
                                    .normal_count = 1,
                                    .blend = blend,
                                    .blend_first = TEXEL,
                                    .blend_count = 8};
    lamp = (fxl_light_settings){.ambient = FXL_Q2_30_ONE / 4,
                                .strength = FXL_Q2_30_ONE / 2,
                                .direction = {0, -FXL_Q2_30_ONE, 0},
                                .fog_near = Q16(6),
                                .fog_far = Q16(30),
                                .ramp = ramp,
                                .levels = LEVELS};
    for (uint32_t i = 0; i < CHANGED_BOARDS; i++) {
        changed_sprites[i] =
            (fxl_sprite){changed_sprite_pixels[i], NULL, 5, 4, 8, i ? 103 : FXL_SPRITE_OPAQUE};
        changed_boards[i] =
            (fxl_billboard){&changed_sprites[i], Q16(2), Q16(3), Q16(1), i ? Q16(1.5) : 0};
    }
    changed_model_map[0] = changed_model_map[1] = 0;
    changed_model_map[2] = 1;
    board_set = (fxl_billboard_set){changed_boards, CHANGED_BOARDS, changed_model_map};
}

static fxl_placement random_placement(void)
{
    fxl_placement placement = {unit_orientation(), unit_between(Q16(0.3), Q16(2))};
    if (unit_between(0, 3) == 0) {
        placement.scale = FXL_Q16_16_ONE;
    }
    return placement;
}

static fxl_instance random_instance(void)
{
    return (fxl_instance){{unit_between(-Q16(6), Q16(6)), unit_between(-Q16(4), Q16(4)),
                           unit_between(-Q16(8), Q16(16))},
                          (uint16_t)(unit_between(0, 3) % CHANGED_MODELS),
                          (uint8_t)unit_between(0, 1),
                          0};
}

fxl_pose changed_random_eye(void)
{
    return (fxl_pose){{unit_between(-Q16(1), Q16(1)), unit_between(-Q16(1), Q16(1)), -Q16(5)},
                      DEGREES(unit_between(-20, 20)),
                      DEGREES(unit_between(-9, 9)),
                      DEGREES(unit_between(0, 30))};
}

/* About the origin, from above. */
static fxl_status attach_beam(bool is_there)
{
    const fxl_point from = {0, Q16(9), 0};
    const fxl_point window[] = {
        {-Q16(4), 0, -Q16(4)}, {-Q16(4), 0, Q16(4)}, {Q16(4), 0, Q16(4)}, {Q16(4), 0, -Q16(4)}};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&from, window, 4, &beam));
    beam_set = (fxl_beam_set){&beam, 1, brighter};
    return fxl_attach_beams(&changed_renderer, is_there ? &beam_set : NULL, beam_room,
                            sizeof beam_room);
}

static void attach(uint32_t thing, bool is_there)
{
    fxl_status status = FXL_OK;
    static const fxl_outline_style style = {
        .line = 77, .keeps_colours = true, .code = &fxl_outlines_by_depth};
    switch (thing) {
    case 0:
        status = fxl_attach_surfaces(&changed_renderer, &surfaces, is_there ? &surface_set : NULL,
                                     changed_into->painter);
        break;
    case 1:
        lamp.ambient = unit_between(0, FXL_Q2_30_ONE / 2);
        status = fxl_attach_light(&changed_renderer, &light, is_there ? &lamp : NULL);
        break;
    case 2:
        status = fxl_attach_lit(&changed_renderer, is_there ? &lit : NULL);
        break;
    case 3:
        status = fxl_attach_billboards(&changed_renderer, &billboards, is_there ? &board_set : NULL,
                                       changed_into->sprites);
        break;
    case CHANGED_BEAMS:
        status = attach_beam(is_there);
        break;
    case 5:
        status =
            fxl_world_set_colours(&changed_world, &changed_renderer, is_there ? &recolour : NULL);
        break;
    case CHANGED_LINES:
        status = fxl_attach_lines(&changed_renderer, &lines_attached, is_there ? &line_set : NULL);
        break;
    case CHANGED_HORIZON:
        status = fxl_attach_horizon(&changed_renderer, is_there ? &horizon : NULL);
        break;
    default:
        status = fxl_attach_outlines(&changed_renderer, &outlines, is_there ? &style : NULL);
    }
    TEST_ASSERT_EQUAL(FXL_OK, status);
}

void changed_attach(uint32_t thing, bool is_there)
{
    static const uint8_t going[] = {CHANGED_OUTLINES, CHANGED_LINES, CHANGED_BEAMS,
                                    CHANGED_HORIZON};
    const char *names[2];
    attach(thing, is_there);
    for (uint32_t i = 0; fxl_renderer_conflict(&changed_renderer, names); i++) {
        TEST_ASSERT_LESS_THAN(sizeof going, i);
        attach(going[i], false);
    }
}

void changed_start_plain(const changed_target *into, const fxl_lens *lens, bool with_tree,
                         uint32_t tree_size)
{
    const fxl_memory memory = {
        order, CHANGED_PLACES + 6, list, (uint32_t)unit_between(0, 1) * LIST, NULL, 0};
    const fxl_world_memory room = {instances,      slots,  placements, CHANGED_CAPACITY,
                                   CHANGED_TURNED, tables, 3,          &fxl_turned_instances};
    fxl_config config = fxl_config_for(lens->width, lens->height, into->target);
    changed_into = into;
    make_tables();
    make_scene(with_tree);
    make_attachments();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&changed_world, &scene, &room));
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_renderer_init_with(&changed_renderer, &changed_world.scene, lens, &memory));
    config.order = with_tree ? &fxl_by_tree : &fxl_by_distance;
    config.palette = into->target->pixel_bits == 16 ? changed_colours : NULL;
    config.depth = cells;
    config.depth_size = sizeof cells;
    config.tree = tree_room;
    config.tree_size = tree_size;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_choose(&changed_renderer, &config));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_attach(&changed_world, &changed_renderer));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_init(&changed, changed_kept, sizeof changed_kept));
    changed_handle_count = TINY_INSTANCES;
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        changed_handles[i] = fxl_world_handle(i);
    }
    changed_renderer.frame.background = 200;
}

void changed_start(const fxl_lens *lens)
{
    const changed_target *into = &changed_targets[unit_between(0, CHANGED_TARGETS - 1)];
    const bool with_tree =
        into->target->depth_bits == 0 && lens->off_centre == NULL && unit_between(0, 1) == 0;
    changed_start_plain(into, lens, with_tree,
                        (uint32_t)unit_between(1, 4) * (uint32_t)sizeof tree_room / 4);
    for (uint32_t thing = 0; thing < CHANGED_THINGS; thing++) {
        changed_attach(thing, unit_between(0, 2) != 0);
    }
    changed_eye = changed_random_eye();
}

fxl_band changed_draw(uint16_t *pixels, const fxl_screen_box *box, fxl_workspace *core)
{
    const uint16_t width = changed_renderer.frame.view.lens.width;
    const size_t first = (size_t)box->first_row * width + box->first_column;
    const bool wide = changed_into->target->pixel_bits == 16;
    const fxl_band band = {.pixels = wide ? (uint8_t *)&pixels[first] : (uint8_t *)pixels + first,
                           .width = width,
                           .stride = width,
                           .first_row = box->first_row,
                           .rows = box->rows,
                           .palette = wide ? changed_colours : NULL,
                           .first_column = box->first_column,
                           .columns = box->columns};
    fxl_frame_fill(&changed_renderer, &band, changed_renderer.frame.background);
    TEST_ASSERT_EQUAL(FXL_OK, core != NULL ? fxl_frame_draw_with(&changed_renderer, core, &band)
                                           : fxl_frame_draw(&changed_renderer, &band));
    return band;
}

void changed_change_world(void)
{
    const uint32_t which = (uint32_t)unit_between(0, (int32_t)changed_handle_count - 1);
    const fxl_handle handle = changed_handles[which];
    fxl_instance instance = random_instance();
    const fxl_placement placement = random_placement();
    switch (unit_between(0, 9)) {
    case 0:
        if (changed_handle_count < CHANGED_PLACES &&
            fxl_world_spawn(&changed_world, &instance, unit_between(0, 1) ? &placement : NULL,
                            &changed_handles[changed_handle_count]) == FXL_OK) {
            changed_handle_count++;
        }
        break;
    case 1:
        if (changed_handle_count > 2 && fxl_world_remove(&changed_world, handle) == FXL_OK) {
            changed_handles[which] = changed_handles[--changed_handle_count];
        }
        break;
    case 2:
        (void)fxl_world_hide(&changed_world, handle);
        break;
    case 3:
        (void)fxl_world_show(&changed_world, handle);
        break;
    case 4:
        (void)fxl_world_set_model(&changed_world, handle, instance.model);
        break;
    case 5:
        (void)fxl_world_set_layer(&changed_world, handle, instance.layer);
        break;
    case 6:
        (void)fxl_world_recolour(&changed_world, handle, (uint32_t)unit_between(0, 3));
        break;
    case 7:
        (void)fxl_world_set_placement(&changed_world, handle,
                                      unit_between(0, 2) ? &placement : NULL);
        break;
    case 8: /* a little */
        instance.centre = fxl_world_instance(&changed_world, handle)->centre;
        instance.centre.x += unit_between(-2000, 2000);
        (void)fxl_world_move(&changed_world, handle, &instance.centre);
        break;
    default:
        (void)fxl_world_move(&changed_world, handle, &instance.centre);
    }
}

void changed_change_billboards(void)
{
    const uint32_t which = (uint32_t)unit_between(0, CHANGED_BOARDS - 1);
    switch (unit_between(0, 2)) {
    case 0:
        changed_model_map[2] = (uint16_t)unit_between(0, CHANGED_BOARDS);
        break;
    case 1:
        changed_sprites[which].pixels = changed_sprite_pixels[unit_between(0, 1)];
        break;
    default:
        changed_boards[which].width = unit_between(Q16(1), Q16(2));
    }
}
