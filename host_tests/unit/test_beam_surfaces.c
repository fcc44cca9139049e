/* SPDX-License-Identifier: MIT */
/* Beams on faces with surfaces, in each target: a lit piece shows lit[c] of each colour c that it showed without a
 * beam, which texels are holes stays, and nothing else changes. */
#include "rgb565_scene.h"

enum {
    TARGETS = 6,
    PIXELS = WIDTH * HEIGHT,
    WALL = 20,  /* the colour of the face that has the surface */
    TEXEL = 64, /* the first of 8 colours of texels */
    TEXELS = 8,
    LIT = 8, /* lit[c] = c + LIT */
    LEVELS = 4
};

typedef struct {
    const fxl_target *target;
    const fxl_painter *painter;
} way;

#define WAY(target)                      \
    {                                    \
        &target, FXL_SURFACES_OF(target) \
    }

static const way ways[TARGETS] = {WAY(fxl_palette),          WAY(fxl_palette_depth_16),
                                  WAY(fxl_palette_depth_32), WAY(fxl_rgb565),
                                  WAY(fxl_rgb565_depth_16),  WAY(fxl_rgb565_depth_32)};

static uint8_t lit[256], four_bits[16 * 16 / 2], colours[16];
static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)], blend[FXL_BLEND_TABLE_BYTES(2 * TEXELS)];
static uint8_t flat[PIXELS], behind[PIXELS], dark[PIXELS], shown[PIXELS];
static uint16_t wide[PIXELS];
static uint64_t memory[500], cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 32) / 8], room[256];
static fxl_beam beam;
static fxl_light light;
static fxl_light_settings lamp;
static bool has_light;
static fxl_pose eye;

void setUp(void)
{
    const fxl_point from = {Q16(0.3), Q16(0.4), Q16(1)};
    const fxl_point window[] = {{Q16(-0.9), Q16(0.8), Q16(3)},
                                {Q16(1.1), Q16(0.9), Q16(3)},
                                {Q16(0.8), Q16(-0.9), Q16(3)},
                                {Q16(-0.7), Q16(-0.6), Q16(3)}};
    walls_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&from, window, 4, &beam));
    for (uint32_t i = 0; i < 256; i++) {
        lit[i] = (uint8_t)(i + LIT);
        for (uint32_t level = 0; level < LEVELS; level++) {
            ramp[256 * level + i] = (uint8_t)(i >= TEXEL && i < TEXEL + TEXELS
                                                  ? TEXEL + (i + level) % TEXELS
                                                  : i);
        }
    }
    for (uint32_t i = 0; i < sizeof walls.texels; i++) {
        walls.texels[i] = (uint8_t)(TEXEL + (i * 5 + (i >> 4) * 3) % TEXELS);
    }
    for (uint32_t i = 0; i < sizeof four_bits; i++) {
        four_bits[i] = (uint8_t)(i * 37 + (i >> 3) * 11);
    }
    for (uint32_t i = 0; i < 16; i++) {
        colours[i] = (uint8_t)(TEXEL + i % TEXELS);
    }
    for (uint32_t i = 0; i < sizeof blend; i++) {
        blend[i] = (uint8_t)(128 + (i ^ i >> 8) % 97);
    }
    walls_make_texture(FXL_TEXTURE_8);
    lamp.ambient = FXL_Q2_30_ONE / 4;
    lamp.points[0] = (fxl_point_light){{Q16(-1), Q16(1), Q16(3)}, Q16(6), FXL_Q2_30_ONE / 2};
    lamp.point_count = 1;
    lamp.ramp = ramp;
    lamp.levels = LEVELS;
    has_light = false;
    eye = walls_eye;
}

/* in_beam: the colours in the beam; null: no beam. */
static void start(const way *into, bool has_surfaces, const uint8_t *in_beam)
{
    const fxl_beam_set set = {&beam, 1, in_beam};
    fxl_renderer *renderer = &walls.renderer;
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, into->target);
    config.background = BACKGROUND;
    config.palette = into->target->pixel_bits == 16 ? walls.palette : NULL;
    config.depth = cells;
    config.depth_size = sizeof cells;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(renderer, &walls.scene, &config, memory, sizeof memory));
    if (has_surfaces) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(renderer, &walls.surfaces, &walls.set, into->painter));
    }
    if (in_beam != NULL) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(renderer, &set, room, sizeof room));
    }
    if (has_light) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(renderer, &light, &lamp));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(renderer, &walls.lit));
    }
}

/* The entry of the palette of a pixel of 16 bits: its entries differ. */
static uint8_t entry_of(uint16_t pixel)
{
    uint32_t i = 0;
    while (i < 255 && walls.palette[i] != pixel) {
        i++;
    }
    TEST_ASSERT_EQUAL_HEX16(walls.palette[i], pixel);
    return (uint8_t)i;
}

/* Draws as indices, in bands of so many rows. */
static void draw(const way *into, uint8_t *indices, uint32_t rows)
{
    const bool is_wide = into->target->pixel_bits == 16;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&walls.renderer, &eye));
    for (uint32_t row = 0; row < HEIGHT; row += rows) {
        const fxl_band band = {.pixels = (uint8_t *)wide + row * WIDTH * (is_wide ? 2 : 1),
                               .width = WIDTH,
                               .stride = WIDTH,
                               .first_row = (uint16_t)row,
                               .rows = (uint16_t)(rows < HEIGHT - row ? rows : HEIGHT - row),
                               .palette = is_wide ? walls.palette : NULL};
        fxl_frame_fill(&walls.renderer, &band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&walls.renderer, &band));
    }
    for (uint32_t i = 0; i < PIXELS; i++) {
        indices[i] = is_wide ? entry_of(wide[i]) : ((const uint8_t *)wide)[i];
    }
}

/* The frames that a test compares: `flat`, of faces without surfaces in the beam; `behind`, the same without the
 * first wall; `dark`, with surfaces and a beam that changes no colour; `shown`, with both. */
static void draw_all(const way *into)
{
    static uint8_t same[256];
    for (uint32_t i = 0; i < 256; i++) {
        same[i] = (uint8_t)i;
    }
    static const fxl_instance others[] = {{{0, 0, 0}, 1, 0, 0}, {{0, 0, 0}, 2, 0, 0}};
    const fxl_scene whole = walls.scene;
    start(into, false, lit);
    draw(into, flat, HEIGHT);
    walls.scene.instances = others;
    walls.scene.instance_count = 2;
    start(into, false, lit);
    draw(into, behind, HEIGHT);
    walls.scene = whole;
    start(into, true, same);
    draw(into, dark, HEIGHT);
    start(into, true, lit);
    draw(into, shown, HEIGHT);
}

static bool is_wall(uint32_t i)
{
    return flat[i] == WALL || flat[i] == WALL + LIT;
}

/* Compares the frames, pixel by pixel. holes: whether the surface has some; count: of the colours that it shows
 * without a beam. */
static void check(bool holes, uint32_t first_colour, uint32_t count)
{
    uint32_t lit_pixels = 0, dark_pixels = 0, through = 0;
    for (uint32_t i = 0; i < PIXELS; i++) {
        const bool is_drawn = is_wall(i) && dark[i] >= first_colour && dark[i] < first_colour + count;
        const bool is_lit = flat[i] == WALL + LIT;
        TEST_ASSERT_EQUAL_UINT8(is_drawn ? dark[i] + (is_lit ? LIT : 0) : is_wall(i) ? behind[i] : flat[i],
                                shown[i]);
        lit_pixels += is_drawn && is_lit;
        dark_pixels += is_drawn && !is_lit;
        through += is_wall(i) && !is_drawn;
    }
    TEST_ASSERT_GREATER_THAN(60, lit_pixels);
    TEST_ASSERT_GREATER_THAN(60, dark_pixels);
    TEST_ASSERT_EQUAL(holes, through > 20);
}

static void check_each_target(bool holes, uint32_t first_colour, uint32_t count)
{
    for (uint32_t i = 0; i < TARGETS; i++) {
        draw_all(&ways[i]);
        check(holes, first_colour, count);
        memcpy(dark, shown, sizeof dark);
        walls.renderer.frame.display_list.capacity = 60;
        draw(&ways[i], shown, 5);
        TEST_ASSERT_EQUAL_MEMORY(dark, shown, sizeof dark);
        TEST_ASSERT_GREATER_THAN(0, walls.renderer.workspace.counters.spilled);
    }
}

/* beams 6.1b */
void test_texels_of_8_bits(void)
{
    for (uint8_t division = FXL_DIVIDE_16; division <= FXL_AFFINE; division++) {
        walls.surface[0].division = division;
        check_each_target(false, TEXEL, TEXELS);
    }
}

/* surfaces 1.3, beams 6.1a-b */
void test_texels_of_4_bits(void)
{
    walls_make_texture(FXL_TEXTURE_4);
    walls.texture.levels = 1;
    walls.texture.texels = four_bits;
    walls.texture.colours = colours;
    check_each_target(false, TEXEL, TEXELS);
}

/* The key is that of the texel, not of what the beam makes of it. */
/* beams 6.3a-c */
void test_a_hole_stays_a_hole(void)
{
    walls.texture.flags = FXL_TEXTURE_KEYED | FXL_TEXTURE_CLAMP;
    walls.texture.key = TEXEL + 3;
    walls.mapped_corners[0][1].texel.u = walls.mapped_corners[0][2].texel.u = Q16(16);
    walls.mapped_corners[0][2].texel.v = Q16(12);
    check_each_target(true, TEXEL, TEXELS);
}

/* beams 6.3a */
void test_a_stipple_stays(void)
{
    walls.surface[0].opacity = 9;
    check_each_target(true, TEXEL, TEXELS);
}

void test_a_surface_without_a_texture(void)
{
    walls.surface[0].texture = 0;
    walls.surface[0].opacity = 9;
    check_each_target(true, WALL, 1);
}

/* In a palette the colour that light has made is the one that the beam changes. */
/* beams 6.2b, SPEC 9.6h */
void test_light_comes_before_the_beam(void)
{
    walls.surface[0].flags = FXL_SURFACE_LIT;
    has_light = true;
    for (uint32_t i = 0; i < 3; i++) {
        draw_all(&ways[i]);
        check(false, TEXEL, TEXELS);
    }
}

/* In RGB565 light takes a part of the colour of lit[c]: that of a texture whose texels are lit[c].
 * */
/* beams 6.2c */
void test_light_in_rgb565_takes_a_part_of_the_colour_in_the_beam(void)
{
    static uint16_t in_beam[PIXELS], all_lit[PIXELS], none_lit[PIXELS];
    walls.surface[0].flags = FXL_SURFACE_LIT;
    for (uint32_t i = 3; i < TARGETS; i++) {
        const way *into = &ways[i];
        has_light = false;
        start(into, false, lit);
        draw(into, flat, HEIGHT);
        has_light = true;
        start(into, true, lit);
        walls_draw(in_beam);
        start(into, true, NULL);
        walls_draw(none_lit);
        for (uint32_t k = 0; k < sizeof walls.texels; k++) {
            walls.texels[k] = (uint8_t)(walls.texels[k] + LIT);
        }
        walls_draw(all_lit);
        for (uint32_t k = 0; k < sizeof walls.texels; k++) {
            walls.texels[k] = (uint8_t)(walls.texels[k] - LIT);
        }
        for (uint32_t k = 0; k < PIXELS; k++) {
            if (is_wall(k)) {
                TEST_ASSERT_EQUAL_HEX16(flat[k] == WALL ? none_lit[k] : all_lit[k], in_beam[k]);
            }
        }
    }
}

/* Draws the surface opaque, and then blended, each with the beam. */
static void draw_blended(const way *into, uint8_t opaque[PIXELS])
{
    walls.surface[0].flags = 0;
    draw_all(into);
    memcpy(opaque, shown, sizeof shown);
    walls.surface[0].flags = FXL_SURFACE_BLEND;
    start(into, true, lit);
    draw(into, shown, HEIGHT);
}

/* What is blended is the colour in the beam, over what is beneath in the beam. */
/* beams 6.2b, 6.3c, 6.4 */
void test_the_beam_comes_before_blending(void)
{
    static uint8_t opaque[PIXELS];
    walls.surface[0].division = FXL_DIVIDE_1; /* the kernel, which rounds texels, does not blend */
    walls.set.blend = blend;
    walls.set.blend_first = TEXEL;
    walls.set.blend_count = 2 * TEXELS;
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t lit_pixels = 0;
        draw_blended(&ways[i], opaque);
        for (uint32_t k = 0; k < PIXELS; k++) {
            if (is_wall(k)) {
                TEST_ASSERT_EQUAL_UINT8(blend[256 * (opaque[k] - TEXEL) + behind[k]], shown[k]);
                lit_pixels += opaque[k] >= TEXEL + LIT;
            }
        }
        TEST_ASSERT_GREATER_THAN(60, lit_pixels);
    }
}

/* A blend table of the dark colours alone: a lit piece is opaque. */
/* beams 6.4a */
void test_a_lit_piece_that_the_blend_table_lacks_is_opaque(void)
{
    walls.surface[0].division = FXL_DIVIDE_1;
    walls.set.blend = blend;
    walls.set.blend_first = TEXEL;
    walls.set.blend_count = TEXELS;
    for (uint32_t i = 0; i < 3; i++) {
        static uint8_t opaque[PIXELS];
        uint32_t lit_pixels = 0, dark_pixels = 0;
        draw_blended(&ways[i], opaque);
        for (uint32_t k = 0; k < PIXELS; k++) {
            if (is_wall(k)) {
                const bool is_lit = opaque[k] >= TEXEL + LIT;
                TEST_ASSERT_EQUAL_UINT8(is_lit ? opaque[k] : blend[256 * (opaque[k] - TEXEL) + behind[k]],
                                        shown[k]);
                lit_pixels += is_lit;
                dark_pixels += !is_lit;
            }
        }
        TEST_ASSERT_GREATER_THAN(60, lit_pixels);
        TEST_ASSERT_GREATER_THAN(60, dark_pixels);
    }
}

/* What the surface has and a beam cannot change: refused until the beams are detached. */
static void expect_refused_in_rgb565(const char *what)
{
    const char *names[2] = {NULL, NULL};
    for (uint32_t i = 3; i < TARGETS; i++) {
        start(&ways[i], true, lit);
        TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_frame_begin(&walls.renderer, &walls_eye));
        TEST_ASSERT_TRUE(fxl_renderer_conflict(&walls.renderer, names));
        TEST_ASSERT_EQUAL_STRING(what, names[0]);
        TEST_ASSERT_EQUAL_STRING("beams", names[1]);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(&walls.renderer, NULL, NULL, 0));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&walls.renderer, &walls_eye));
    }
}

/* A texel of 16 bits has no number that lit[] knows. */
/* beams 6.5b */
void test_texels_of_16_bits_are_refused(void)
{
    walls_make_texture(FXL_TEXTURE_565);
    expect_refused_in_rgb565("textures of RGB565");
}

/* Nor has a colour between those of corners. */
void test_colours_at_corners_are_refused(void)
{
    walls.surface[0] = (fxl_surface){.flags = FXL_SURFACE_COLOURS, .opacity = 16};
    for (int i = 0; i < 3; i++) {
        walls.mapped_corners[0][i].texel = (fxl_texel){0, 0};
    }
    expect_refused_in_rgb565("colours at corners");
}

/* Beside the walls, a beam changes no pixel of them. */
void test_a_beam_that_reaches_no_wall(void)
{
    const fxl_point from = {Q16(500), Q16(500), 0};
    const fxl_point window[] = {{Q16(499.9), Q16(500.1), Q16(1)},
                                {Q16(500.1), Q16(500.1), Q16(1)},
                                {Q16(500.1), Q16(499.9), Q16(1)},
                                {Q16(499.9), Q16(499.9), Q16(1)}};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&from, window, 4, &beam));
    start(&ways[0], true, lit);
    draw(&ways[0], shown, HEIGHT);
    start(&ways[0], true, NULL);
    draw(&ways[0], behind, HEIGHT);
    TEST_ASSERT_EQUAL_MEMORY(behind, shown, sizeof shown);
    TEST_ASSERT_NOT_NULL(memchr(shown, walls.texels[0], sizeof shown));
}

static fxl_counters counters_of(const way *into, const uint8_t *in_beam)
{
    start(into, true, in_beam);
    draw(into, shown, HEIGHT);
    return walls.renderer.workspace.counters;
}

/* Also where pieces of a face lie beside the screen, the last of them or others. */
void test_a_face_in_pieces_counts_once(void)
{
    uint32_t drawn = 0, clipped = 0;
    for (uint32_t i = 0; i < 300; i++) {
        const way *into = &ways[i % TARGETS];
        eye.yaw = walls_eye.yaw + DEGREES(80) / 300 * i - DEGREES(40);
        const fxl_counters expected = counters_of(into, NULL), found = counters_of(into, lit);
        TEST_ASSERT_EQUAL_UINT32(expected.in, found.in);
        TEST_ASSERT_EQUAL_UINT32(expected.outside, found.outside);
        TEST_ASSERT_EQUAL_UINT32(expected.drawn, found.drawn);
        TEST_ASSERT_EQUAL_UINT32(expected.clipped, found.clipped);
        TEST_ASSERT_EQUAL_UINT32(0, found.refused);
        drawn += found.drawn;
        clipped += found.clipped;
    }
    TEST_ASSERT_GREATER_THAN(300, drawn);
    TEST_ASSERT_GREATER_THAN(100, clipped);
}
