/* SPDX-License-Identifier: MIT */
/* Surfaces with a depth buffer: textures, stipple and glass. */
#include "depth_scene.h"

static depth_scene *made;
static uint8_t panes[FXL_BLEND_TABLE_BYTES(11)];
static uint8_t panes_frame[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT];

void setUp(void)
{
    made = depth_scene_make();
}

static void set_texture(uint32_t face)
{
    made->face_map[face] = 1;
    made->is_mapped = true;
    depth_scene_start_with(made, &fxl_palette_depth_16);
}

/* Pixels of the texture of face `face` are where the flat frame has its colour; a texel of the key
 * lets through what is behind. */
static void check_textured(uint32_t face, bool keyed)
{
    uint32_t drawn[2] = {0, 0};
    for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        const bool texel = made->again[i] == 98 || made->again[i] == 99;
        if (made->frame[i] != made->scene.faces[face].material) {
            TEST_ASSERT_EQUAL(made->frame[i], made->again[i]);
        } else if (!keyed) {
            TEST_ASSERT_TRUE(texel);
        } else {
            TEST_ASSERT_NOT_EQUAL(99, made->again[i]);
            TEST_ASSERT_NOT_EQUAL(made->scene.faces[face].material, made->again[i]);
        }
        drawn[0] += texel;
        drawn[1] += made->frame[i] == made->scene.faces[face].material && !texel;
    }
    TEST_ASSERT_GREATER_THAN(50, drawn[0]);
    TEST_ASSERT_EQUAL(keyed, drawn[1] > 50);
}

void test_textures_are_seen_where_they_are_nearest(void)
{
    static uint8_t plain[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT]; /* without a key */
    for (uint32_t face = 0; face < DEPTH_SCENE_QUADS; face++) {
        memset(made->face_map, 0, sizeof made->face_map);
        made->texture.flags = 0;
        made->is_mapped = false;
        depth_scene_start_with(made, &fxl_palette_depth_16);
        depth_scene_draw(made, made->frame);
        set_texture(face);
        depth_scene_draw(made, made->again);
        check_textured(face, false);
        memcpy(plain, made->again, sizeof plain);
        made->texture.flags = FXL_TEXTURE_KEYED;
        made->texture.key = 99;
        depth_scene_draw(made, made->again);
        check_textured(face, true);
        for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
            TEST_ASSERT_EQUAL(plain[i] == 98, made->again[i] == 98);
        }
        memcpy(made->frame, made->again, sizeof made->frame);
        depth_scene_check_bands(made, &fxl_palette_depth_16);
    }
}

/* SPEC 10.4d, surfaces 4.2a */
void test_a_stippled_surface_keeps_depth_where_it_is_drawn(void)
{
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->frame);
    set_texture(1);
    for (uint8_t opacity = 1; opacity < 16; opacity += 7) {
        made->surface.opacity = opacity;
        depth_scene_draw(made, made->again);
        uint32_t drawn = 0, through = 0, behind = 0;
        for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
            const bool texel = made->again[i] == 98 || made->again[i] == 99;
            const bool is_hole = made->frame[i] == made->scene.faces[1].material && !texel;
            drawn += texel;
            through += is_hole;
            behind += is_hole && made->again[i] != DEPTH_SCENE_BACKGROUND;
            TEST_ASSERT_TRUE(made->frame[i] == made->scene.faces[1].material || !texel);
        }
        TEST_ASSERT_INT_WITHIN(DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT / 50,
                               (drawn + through) * opacity / 16, drawn);
        TEST_ASSERT_GREATER_THAN(15, drawn);
        TEST_ASSERT_GREATER_THAN(15, through);
        TEST_ASSERT_GREATER_THAN(5, behind); /* faces that are drawn before and after it */
    }
}

/* Glass: face 2 shows what is beneath it in another colour, whatever is drawn first. */
/* SPEC 10.5a-c, surfaces 4.4b */
void test_a_blended_surface_is_seen_over_what_is_behind_it(void)
{
    static uint8_t beneath[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT], table[FXL_BLEND_TABLE_BYTES(1)];
    for (uint32_t i = 0; i < sizeof table; i++) {
        table[i] = (uint8_t)(i ^ 0x80);
    }
    depth_scene_start_with(made, &fxl_palette_depth_16);
    depth_scene_draw(made, made->frame);
    memset(made->texels, 99, sizeof made->texels);
    made->texture.flags = FXL_TEXTURE_KEYED;
    made->texture.key = 99;
    set_texture(2);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_render(&made->renderer, &depth_scene_eye, beneath, DEPTH_SCENE_WIDTH));
    made->surface.texture = 0;
    made->surface.flags = FXL_SURFACE_BLEND;
    made->set.blend = table;
    made->set.blend_first = made->scene.faces[2].material;
    made->set.blend_count = 1;
    const fxl_surface two[2] = {{.opacity = 16}, made->surface}; /* the blended one is the last */
    made->set.surfaces = two;
    made->set.surface_count = 2;
    made->mapped.surface = 1;
    set_texture(2);
    depth_scene_draw(made, made->again);
    uint32_t seen_through = 0;
    for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        const bool is_glass = made->frame[i] == made->scene.faces[2].material;
        seen_through += is_glass && beneath[i] != DEPTH_SCENE_BACKGROUND;
        TEST_ASSERT_EQUAL(is_glass ? table[beneath[i]] : made->frame[i], made->again[i]);
    }
    TEST_ASSERT_GREATER_THAN(100, seen_through);
    memcpy(made->frame, made->again, sizeof made->frame);
    depth_scene_check_bands(made, &fxl_palette_depth_16);
}

/* The floor, and of the two panes those that the bits of `shown` name. */
static void draw_panes(uint32_t shown, uint8_t *frame)
{
    fxl_instance instances[DEPTH_SCENE_QUADS];
    uint16_t count = 0;
    depth_scene *fresh = depth_scene_make();
    const fxl_instance *all = fresh->scene.instances;
    instances[count++] = all[0];
    for (uint32_t pane = 1; pane <= 2; pane++) {
        fresh->face_map[pane] = 1;
        if (shown >> pane & 1u) {
            instances[count++] = all[pane];
        }
    }
    fresh->scene.instances = instances;
    fresh->scene.instance_count = count;
    fresh->surface = (fxl_surface){.flags = FXL_SURFACE_BLEND, .opacity = 16};
    fresh->set.blend = panes;
    fresh->set.blend_first = 20; /* the colours of the panes are 20 and 30 */
    fresh->set.blend_count = 11;
    fresh->is_mapped = true;
    depth_scene_start_with(fresh, &fxl_palette_depth_16);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_render(&fresh->renderer, &depth_scene_eye, frame, DEPTH_SCENE_WIDTH));
}

/* Two panes that cross: in each pixel one covers the other, and both are seen. Each adds a number
 * to the colour beneath it, so the order does not matter. */
/* SPEC 10.5c, surfaces 4.4b */
void test_panes_that_cross_are_seen_through_each_other(void)
{
    static uint8_t frames[4][DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT];
    uint32_t through_both = 0;
    for (uint32_t i = 0; i < sizeof panes; i++) {
        panes[i] = (uint8_t)(i + (i < 256 ? 64 : 128));
    }
    for (uint32_t shown = 0; shown < 4; shown++) {
        draw_panes(2 * shown, frames[shown]);
    }
    for (uint32_t i = 0; i < sizeof frames[0]; i++) {
        const int beneath = frames[0][i], one = frames[1][i], other = frames[2][i];
        TEST_ASSERT_EQUAL_UINT8(one + other - beneath, frames[3][i]);
        TEST_ASSERT_TRUE(one == beneath || one == (beneath + 64) % 256);
        TEST_ASSERT_TRUE(other == beneath || other == (beneath + 128) % 256);
        through_both += one != beneath && other != beneath;
    }
    TEST_ASSERT_GREATER_THAN(100, through_both);
}

/* --- a small triangle behind a pane, which is drawn before it --------------------------------- */

enum {
    SPOT = 30 /* the triangle's colour */
};

/* The pane's instance is farther away than the triangle's, and its plane is nearer. with_pane: false
 * leaves it out. times: how large the triangle is, times 2 pixels. */
static void make_spot(bool with_pane, int32_t times)
{
    static fxl_point corners[] = {{-16 * 65536, -131072, 0},
                                  {-16 * 65536, 131072, 0},
                                  {-4 * 65536, 131072, 0},
                                  {-4 * 65536, -131072, 0},
                                  {0, 0, 0},
                                  {0, 0, 0},
                                  {0, 0, 0}};
    static const uint16_t indices[] = {0, 1, 2, 3};
    static const fxl_face faces[] = {{{0, 0, -FXL_Q2_30_ONE}, 4, 20, FXL_INDICES_AT(0, 0)},
                                     {{0, 0, -FXL_Q2_30_ONE}, 3, SPOT, {0, 1, 2}}};
    static const fxl_model both[] = {
        {.vertex_count = 4, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = 18 * 65536},
        {.first_vertex = 4,
         .vertex_count = 3,
         .first_face = 1,
         .face_count = 1,
         .kind = FXL_MODEL_CONVEX,
         .radius = 131072}};
    static const fxl_instance instances[] = {{{0, 0, 5 * 65536}, 1, 0, 0},
                                             {{10 * 65536, 0, 4 * 65536}, 0, 0, 0}};
    made = depth_scene_make();
    corners[4] = (fxl_point){-12000 * times, -14000 * times, 0};
    corners[5] = (fxl_point){1000 * times, 15000 * times, 0};
    corners[6] = (fxl_point){14000 * times, -11000 * times, 0};
    made->scene.vertices = corners;
    made->scene.vertex_count = 7;
    made->scene.indices = indices;
    made->scene.index_count = 4;
    made->scene.faces = faces;
    made->scene.models = both;
    made->scene.face_count = made->scene.model_count = 2;
    made->scene.instances = instances;
    made->scene.instance_count = with_pane ? 2 : 1;
    made->face_map[0] = 1;
    made->surface = (fxl_surface){.flags = FXL_SURFACE_BLEND, .opacity = 16};
    made->set.blend = panes;
    made->set.blend_first = 20;
    made->set.blend_count = 1;
    made->is_mapped = true;
}

/* SPEC 10.5b-c, surfaces 4.4b */
void test_a_small_face_is_seen_through_a_pane_that_is_drawn_first(void)
{
    static const fxl_target *const targets[] = {&fxl_palette_depth_16, &fxl_palette_depth_32};
    static const fxl_pose ahead = {{0, 0, 0}, 0, 0, 0};
    for (uint32_t i = 0; i < sizeof panes; i++) {
        panes[i] = (uint8_t)(i ^ 0x80);
    }
    for (uint32_t i = 0; i < 4; i++) {
        uint32_t spots = 0, pane = 0;
        for (uint32_t k = 0; k < 2; k++) {
            make_spot(k == 1, 1);
            depth_scene_start_with(made, targets[i % 2]);
            made->renderer.frame.display_list.capacity = i < 2 ? 0 : 64;
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &ahead));
            uint8_t *to = k == 0 ? panes_frame : made->again;
            const fxl_band band = UNIT_BAND(to, DEPTH_SCENE_WIDTH, 0, DEPTH_SCENE_HEIGHT);
            fxl_frame_fill(&made->renderer, &band, DEPTH_SCENE_BACKGROUND);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&made->renderer, &band));
        }
        for (uint32_t at = 0; at < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; at++) {
            pane += made->again[at] == (DEPTH_SCENE_BACKGROUND ^ 0x80);
            if (panes_frame[at] == SPOT) {
                TEST_ASSERT_EQUAL(SPOT ^ 0x80, made->again[at]);
                spots++;
            }
        }
        TEST_ASSERT_TRUE(spots >= 2 && pane > 300);
    }
}

/* The same in 16 bits a pixel: a triangle with a texture of one colour. */
static void draw_spot(const fxl_target *target, const fxl_painter *painter, bool with_pane,
                      uint32_t words, uint16_t *to)
{
    static const fxl_pose ahead = {{0, 0, 0}, 0, 0, 0};
    static uint16_t palette[256];
    static fxl_surface both[2];
    static fxl_mapped_face mapped[2];
    make_spot(with_pane, 4);
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(i * 257u);
    }
    memset(made->texels, 77, sizeof made->texels);
    both[0] = (fxl_surface){.flags = FXL_SURFACE_BLEND, .opacity = 16, .sixteenths = 8};
    both[1] = (fxl_surface){.texture = 1, .opacity = 16};
    for (uint16_t i = 0; i < 2; i++) {
        mapped[i] = (fxl_mapped_face){.surface = i, .corners = {0, 1, 2}};
        made->face_map[i] = (uint16_t)(i + 1);
    }
    made->set.surfaces = both;
    made->set.faces = mapped;
    made->set.surface_count = made->set.face_count = 2;
    made->set.blend = NULL;
    made->set.blend_first = made->set.blend_count = 0;
    made->is_mapped = false;
    made->config.palette = palette;
    depth_scene_start_with(made, target);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_attach_surfaces(&made->renderer, &made->surfaces, &made->set, painter));
    made->renderer.frame.display_list.capacity = words;
    const fxl_band band = {.pixels = (uint8_t *)(void *)to,
                           .width = DEPTH_SCENE_WIDTH,
                           .stride = DEPTH_SCENE_WIDTH,
                           .rows = DEPTH_SCENE_HEIGHT,
                           .palette = palette};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &ahead));
    fxl_frame_fill(&made->renderer, &band, DEPTH_SCENE_BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&made->renderer, &band));
}

/* SPEC 10.5b-c, surfaces 4.4b */
void test_a_small_texture_is_seen_through_a_pane_that_is_drawn_first(void)
{
    static uint16_t narrow[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT];
    static uint16_t wide[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT];
    uint32_t spots = 0;
    draw_spot(&fxl_rgb565_depth_32, FXL_SURFACES_OF(fxl_rgb565_depth_32), true, 0, wide);
    for (uint32_t words = 0; words <= 128; words += 64) {
        draw_spot(&fxl_rgb565_depth_16, FXL_SURFACES_OF(fxl_rgb565_depth_16), true, words, narrow);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(wide, narrow, DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT);
    }
    draw_spot(&fxl_rgb565_depth_16, FXL_SURFACES_OF(fxl_rgb565_depth_16), false, 0, wide);
    for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        if (wide[i] == 77 * 257) {
            TEST_ASSERT_NOT_EQUAL(77 * 257, narrow[i]);
            spots++;
        }
    }
    TEST_ASSERT_GREATER_THAN(20, spots);
}

/* --- opaque faces of a frame that blends, which come near to far where they may ------------------ */

/* Two sorted models, each a square of several faces. The front face of the far one has another number than those
 * of the near one, of which two are at the same place, and one is blended. hides_far: the far one has none. */
static void make_squares(bool hides_far)
{
    static const fxl_point corners[] = {
        {-4 * 65536, -4 * 65536, 0}, {-4 * 65536, 4 * 65536, 0}, {4 * 65536, 4 * 65536, 0},
        {4 * 65536, -4 * 65536, 0},  {-65536, -65536, 0},        {-65536, 65536, 0},
        {65536, 65536, 0},           {65536, -65536, 0},         {-32768, -32768, -6553},
        {-32768, 32768, -6553},      {32768, 32768, -6553},      {32768, -32768, -6553}};
    static const uint16_t indices[] = {0, 1, 2, 3, 3, 2, 1, 0, 3, 2, 1, 0,
                                       0, 1, 2, 3, 0, 1, 2, 3, 4, 5, 6, 7};
    static fxl_face faces[] = {{{0, 0, -FXL_Q2_30_ONE}, 4, 40, FXL_INDICES_AT(0, 0)},
                               {{0, 0, FXL_Q2_30_ONE}, 4, 41, FXL_INDICES_AT(3, 4)},
                               {{0, 0, FXL_Q2_30_ONE}, 4, 42, FXL_INDICES_AT(3, 8)},
                               {{0, 0, -FXL_Q2_30_ONE}, 4, 43, FXL_INDICES_AT(0, 12)},
                               {{0, 0, -FXL_Q2_30_ONE}, 4, 44, FXL_INDICES_AT(0, 16)},
                               {{0, 0, -FXL_Q2_30_ONE}, 4, 20, FXL_INDICES_AT(4, 20)}};
    static const fxl_model both[] = {
        {.vertex_count = 4, .face_count = 2, .kind = FXL_MODEL_SORTED, .radius = 6 * 65536},
        {.first_vertex = 4,
         .vertex_count = 8,
         .first_face = 2,
         .face_count = 4,
         .kind = FXL_MODEL_SORTED,
         .radius = 2 * 65536}};
    static const fxl_instance instances[] = {{{0, 0, 8 * 65536}, 0, 0, 0},
                                             {{0, 0, 4 * 65536}, 1, 0, 0}};
    static uint16_t face_map[] = {0, 0, 0, 0, 0, 1};
    made = depth_scene_make();
    faces[0].normal.z = hides_far ? FXL_Q2_30_ONE : -FXL_Q2_30_ONE;
    made->scene.vertices = corners;
    made->scene.vertex_count = 12;
    made->scene.indices = indices;
    made->scene.index_count = 24;
    made->scene.faces = faces;
    made->scene.face_count = 6;
    made->scene.models = both;
    made->scene.model_count = 2;
    made->scene.instances = instances;
    made->scene.instance_count = 2;
    for (uint16_t i = 0; i < 3; i++) {
        made->mapped_corners[i].vertex = (uint16_t)(4u + i);
    }
    made->set.face_map = face_map;
    made->surface = (fxl_surface){.flags = FXL_SURFACE_BLEND, .opacity = 16};
    made->set.blend = panes;
    made->set.blend_first = 20;
    made->set.blend_count = 1;
    made->is_mapped = true;
}

/* SPEC 10.4c, 10.5a-c */
void test_opaque_faces_of_a_frame_that_blends_are_those_of_a_display_list(void)
{
    static const fxl_target *const targets[] = {&fxl_palette_depth_16, &fxl_palette_depth_32};
    static const fxl_pose ahead = {{0, 0, 0}, 0, 0, 0};
    for (uint32_t i = 0; i < sizeof panes; i++) {
        panes[i] = (uint8_t)(i ^ 0x80);
    }
    for (uint32_t i = 0; i < 8; i++) {
        const bool hides_far = i >= 4;
        uint32_t near = 0, far = 0, blended = 0;
        make_squares(hides_far);
        depth_scene_start_with(made, targets[i % 2]);
        made->renderer.frame.display_list.capacity = i % 4 < 2 ? 0 : 256;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &ahead));
        const fxl_band band = UNIT_BAND(made->again, DEPTH_SCENE_WIDTH, 0, DEPTH_SCENE_HEIGHT);
        fxl_frame_fill(&made->renderer, &band, DEPTH_SCENE_BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&made->renderer, &band));
        for (uint32_t at = 0; at < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; at++) {
            far += made->again[at] == 40;
            near += made->again[at] == 44; /* of the two the greater number */
            blended += made->again[at] == (44 ^ 0x80);
            TEST_ASSERT_TRUE(made->again[at] != 43 && made->again[at] != (43 ^ 0x80));
        }
        TEST_ASSERT_TRUE(near > 50 && (far > 100) != hides_far && blended > 20);
        const fxl_counters *counters = &made->renderer.workspace.counters;
        TEST_ASSERT_EQUAL(6, counters->in);
        TEST_ASSERT_EQUAL(4 - hides_far, counters->drawn);
        TEST_ASSERT_EQUAL(2 + hides_far, counters->backfacing);
    }
}
