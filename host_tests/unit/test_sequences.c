/* SPDX-License-Identifier: MIT */
/* What is attached to a renderer gives one picture, or one refusal, in whatever sequence it was
 * attached. */
#include "bsp_scene.h"
#include "depth_scene.h"
#include "draw/renderer.h"
#include "unit.h"

enum {
    SURFACES,
    LIGHT,
    LIT,
    BILLBOARDS,
    BEAMS,
    OUTLINES,
    THINGS,
    LEVELS = 4,
    TARGETS = 6
};

#define HAS(set, thing) (((set) >> (thing) & 1u) != 0)

/* A target, and what draws into it. */
typedef struct {
    const fxl_target *target;
    const fxl_painter *painter;
    const fxl_sprite_painter *sprites;
} way;

#define WAY(target) \
    { \
        &target, FXL_SURFACES_OF(target), FXL_SPRITES_OF(target) \
    }

static const way ways[TARGETS] = {WAY(fxl_palette),          WAY(fxl_palette_depth_16),
                                  WAY(fxl_palette_depth_32), WAY(fxl_rgb565),
                                  WAY(fxl_rgb565_depth_16),  WAY(fxl_rgb565_depth_32)};

static const fxl_instance instances[] = {
    {{0, 0, 0}, 0, 0, 0}, {{0, 0, 0}, 1, 0, 0}, {{-65536, 32768, 3 * 65536}, 2, 0, 0}};
static const fxl_direction normals[] = {{0, 0, -FXL_Q2_30_ONE}};
static const uint8_t sprite_pixels[] = {41, 42, 43, 44};
static const fxl_sprite sprite = {
    .pixels = sprite_pixels, .width = 2, .height = 2, .bits = 8, .key = FXL_SPRITE_OPAQUE};
static const fxl_billboard board = {&sprite, 65536, 65536, 32768, 32768};
static const uint16_t model_map[DEPTH_SCENE_QUADS] = {0, 0, 1};
static const fxl_billboard_set board_set = {&board, 1, model_map};
static const fxl_outline_style style = {
    .line = 77, .keeps_colours = true, .code = &fxl_outlines_by_depth};

static depth_scene *made;
static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)], brighter[256];
static uint16_t colours[256], pixels[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT];
static uint64_t cells[FXL_DEPTH_BYTES(DEPTH_SCENE_WIDTH, DEPTH_SCENE_HEIGHT, 32) / 8];
static fxl_light_settings lamp;
static fxl_beam beam;
static fxl_beam_set beam_set;
static fxl_light light;
static fxl_lit_surfaces lit;
static fxl_billboards billboards;
static fxl_outlines outlines;

void setUp(void)
{
    const fxl_point from = {0, 8 * 65536, 3 * 65536};
    const fxl_point window[] = {{-2 * 65536, 0, 65536},
                                {-2 * 65536, 0, 6 * 65536},
                                {2 * 65536, 0, 6 * 65536},
                                {2 * 65536, 0, 65536}};
    made = depth_scene_make();
    made->scene.instances = instances;
    made->face_map[1] = 1;
    made->surface.flags = FXL_SURFACE_LIT;
    made->set.normals = normals;
    made->set.normal_count = 1;
    for (uint32_t i = 0; i < 256; i++) {
        colours[i] = (uint16_t)(i * 257);
        brighter[i] = (uint8_t)(i + 1);
        for (uint32_t level = 0; level < LEVELS; level++) {
            ramp[256 * level + i] = (uint8_t)(i + 100 * (LEVELS - 1 - level));
        }
    }
    lamp.ambient = FXL_Q2_30_ONE / 4;
    lamp.ramp = ramp;
    lamp.levels = LEVELS;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&from, window, 4, &beam));
    beam_set = (fxl_beam_set){&beam, 1, brighter};
}

static void start(const way *into)
{
    fxl_config config = made->config;
    config.target = into->target;
    config.palette = into->target->pixel_bits == 16 ? colours : NULL;
    config.depth = cells;
    config.depth_size = sizeof cells;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&made->renderer, &made->scene, &config,
                                                made->memory, sizeof made->memory));
}

static fxl_status attach(const way *into, uint32_t thing, bool is_there)
{
    fxl_renderer *renderer = &made->renderer;
    switch (thing) {
    case SURFACES:
        return fxl_attach_surfaces(renderer, &made->surfaces, is_there ? &made->set : NULL,
                                   into->painter);
    case LIGHT:
        return fxl_attach_light(renderer, &light, is_there ? &lamp : NULL);
    case LIT:
        return fxl_attach_lit(renderer, is_there ? &lit : NULL);
    case BILLBOARDS:
        return fxl_attach_billboards(renderer, &billboards, is_there ? &board_set : NULL,
                                     into->sprites);
    case BEAMS:
        return fxl_attach_beams(renderer, is_there ? &beam_set : NULL, made->room,
                                sizeof made->room);
    default:
        return fxl_attach_outlines(renderer, &outlines, is_there ? &style : NULL);
    }
}

/* Outlines do not go with beams. */
static bool is_refused(uint32_t set)
{
    return HAS(set, OUTLINES) && HAS(set, BEAMS);
}

/* The members of a set that show: light at corners needs surfaces, and light. */
static uint32_t shown_of(uint32_t set)
{
    return HAS(set, SURFACES) && HAS(set, LIGHT) ? set : set & ~(1u << LIT);
}

/* The picture of each set, once it was drawn. */
static bool is_drawn[1u << THINGS];
static uint32_t pictures[1u << THINGS];

static void look(uint32_t set)
{
    const char *names[2] = {NULL, NULL};
    const bool refused = is_refused(set);
    memset(pixels, 0x5A, sizeof pixels);
    TEST_ASSERT_EQUAL(refused, fxl_renderer_conflict(&made->renderer, names));
    TEST_ASSERT_EQUAL(refused, names[0] != NULL && names[1] != NULL);
    TEST_ASSERT_EQUAL(
        refused ? FXL_E_COMBINATION : FXL_OK,
        fxl_render(&made->renderer, &depth_scene_eye, pixels, DEPTH_SCENE_WIDTH));
    const char *said =
        fxl_render_explain(&made->renderer, &depth_scene_eye, pixels, DEPTH_SCENE_WIDTH, NULL);
    TEST_ASSERT_EQUAL(refused, said != NULL && strstr(said, names[0]) == said &&
                                   strstr(said, names[1]) != NULL);
    TEST_ASSERT_EQUAL_UINT32(refused, made->renderer.workspace.counters.refused_calls);
    TEST_ASSERT_EQUAL(refused, made->renderer.frame.state == FXL_FRAME_NONE);
    const uint32_t picture = fxl_crc(FXL_CRC_START, pixels, sizeof pixels);
    if (is_drawn[set]) {
        TEST_ASSERT_EQUAL_HEX32(pictures[set], picture);
    }
    is_drawn[set] = true;
    pictures[set] = picture;
}

/* A sequence: digits to the base 2 THINGS, each a thing that is attached or detached. */
static void take(const way *into, uint32_t number, uint32_t length)
{
    uint32_t set = 0;
    start(into);
    for (; length > 0; length--, number /= 2 * THINGS) {
        const uint32_t thing = number % (2 * THINGS) / 2, is_there = number & 1u;
        TEST_ASSERT_EQUAL(FXL_OK, attach(into, thing, is_there != 0));
        set = (set & ~(1u << thing)) | is_there << thing;
    }
    look(set);
}

static void expect_different_pictures(void)
{
    for (uint32_t a = 0; a < 1u << THINGS; a++) {
        for (uint32_t b = 0; b < a; b++) {
            if (is_drawn[a] && is_drawn[b] && !is_refused(a) && !is_refused(b)) {
                TEST_ASSERT_EQUAL(shown_of(a) == shown_of(b), pictures[a] == pictures[b]);
            }
        }
    }
}

/* combinations 1.2a */
void test_the_sequence_does_not_matter(void)
{
    const uint32_t longest = UNIT_REPEAT > 10000 ? 4 : 2;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    for (uint32_t i = 0; i < TARGETS; i++) {
        memset(is_drawn, 0, sizeof is_drawn);
        for (uint32_t length = 0, count = 1; length <= longest; length++, count *= 2 * THINGS) {
            for (uint32_t number = 0; number < count; number++) {
                take(&ways[i], number, length);
            }
        }
        expect_different_pictures();
    }
}

/* A renderer that was initialised for the palette draws into the target that is chosen then. */
/* combinations 1.5b */
void test_a_target_is_chosen_after_init(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    for (uint32_t i = 0; i < TARGETS; i++) {
        const bool has_depth = ways[i].target->depth_bits != 0;
        const bool is_rgb565 = ways[i].target->pixel_bits == 16;
        fxl_config config = made->config;
        memset(is_drawn, 0, sizeof is_drawn);
        start(&ways[i]);
        look(0);
        start(&ways[0]);
        config.target = ways[i].target;
        TEST_ASSERT_EQUAL(is_rgb565    ? FXL_E_ARGUMENT
                          : has_depth ? FXL_E_CAPACITY
                                      : FXL_OK,
                          fxl_renderer_choose(&made->renderer, &config));
        config.palette = colours; /* a target of palette indices does not take it */
        config.depth = has_depth ? (uint8_t *)cells + 4 : NULL;
        config.depth_size = has_depth ? (uint32_t)sizeof cells - 4 : 0;
        TEST_ASSERT_EQUAL(has_depth ? FXL_E_ALIGNMENT : FXL_OK,
                          fxl_renderer_choose(&made->renderer, &config));
        config.depth = has_depth ? cells : NULL;
        made->renderer.workspace.counters.refused_calls = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_choose(&made->renderer, &config));
        TEST_ASSERT_EQUAL_PTR(is_rgb565 ? colours : NULL, made->renderer.palette);
        look(0);
        TEST_ASSERT_EQUAL(FXL_OK, attach(&ways[i], LIGHT, true));
        TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_renderer_choose(&made->renderer, &config));
        TEST_ASSERT_EQUAL_PTR(ways[i].target, made->renderer.target);
    }
}

/* RGB565 at an odd address, and bands of bytes, are refused, and no pixel is written. */
/* rgb565 3.2 */
void test_bands_that_are_not_of_the_target(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    for (uint32_t i = 0; i < TARGETS; i++) {
        const bool is_rgb565 = ways[i].target->pixel_bits == 16;
        uint8_t *odd = (uint8_t *)pixels + 1;
        fxl_band band = {.pixels = odd,
                         .width = DEPTH_SCENE_WIDTH,
                         .stride = DEPTH_SCENE_WIDTH,
                         .rows = DEPTH_SCENE_HEIGHT - 1,
                         .palette = is_rgb565 ? colours : NULL};
        start(&ways[i]);
        memset(pixels, 0x5A, sizeof pixels);
        if (is_rgb565) {
            TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_render(&made->renderer, &depth_scene_eye, odd,
                                                          DEPTH_SCENE_WIDTH));
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &depth_scene_eye));
        TEST_ASSERT_EQUAL(is_rgb565 ? FXL_E_ALIGNMENT : FXL_OK,
                          fxl_frame_draw(&made->renderer, &band));
        if (is_rgb565) {
            band.pixels = (uint8_t *)pixels;
            band.palette = NULL;
            TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&made->renderer, &band));
            TEST_ASSERT_EQUAL_UINT32(3, made->renderer.workspace.counters.refused_calls);
            TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, pixels, sizeof pixels);
        }
    }
}

/* Any rectangle of the frame that was begun, in a buffer of its own: its pixels are those of
 * `pixels`, the whole frame, and no other byte of the buffer is written. */
static void expect_rectangle(const way *into)
{
    static uint16_t buffer[DEPTH_SCENE_WIDTH * (DEPTH_SCENE_HEIGHT + 2)];
    const uint32_t bytes = into->target->pixel_bits / 8u;
    fxl_band band = {.width = DEPTH_SCENE_WIDTH,
                     .palette = bytes == 2 ? colours : NULL};
    band.columns = (uint16_t)unit_between(1, DEPTH_SCENE_WIDTH);
    band.first_column = (uint16_t)unit_between(0, DEPTH_SCENE_WIDTH - band.columns);
    band.rows = (uint16_t)unit_between(1, DEPTH_SCENE_HEIGHT);
    band.first_row = (uint16_t)unit_between(0, DEPTH_SCENE_HEIGHT - band.rows);
    band.stride = (uint16_t)unit_between(band.columns, DEPTH_SCENE_WIDTH);
    uint8_t *first = (uint8_t *)buffer + DEPTH_SCENE_WIDTH * bytes;
    band.pixels = first;
    memset(buffer, 0x5A, sizeof buffer);
    fxl_frame_fill(&made->renderer, &band, made->renderer.frame.background);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&made->renderer, &band));
    for (uint32_t i = 0; i < sizeof buffer; i++) {
        const uint32_t at = i - DEPTH_SCENE_WIDTH * bytes, row_bytes = band.stride * bytes;
        const uint32_t row = at / row_bytes, in_row = at % row_bytes;
        const bool inside = i >= DEPTH_SCENE_WIDTH * bytes && row < band.rows &&
                            in_row < band.columns * bytes;
        const uint32_t whole = ((band.first_row + row) * DEPTH_SCENE_WIDTH + band.first_column) *
                               bytes + in_row;
        TEST_ASSERT_EQUAL_HEX8(inside ? ((const uint8_t *)pixels)[whole] : 0x5A,
                               ((const uint8_t *)buffer)[i]);
    }
}

void test_a_rectangle_has_the_pixels_of_the_whole_frame(void)
{
    const int32_t repeat = UNIT_REPEAT > 10000 ? 6 : 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    for (uint32_t i = 0; i < TARGETS; i++) {
        for (uint32_t set = 0; set < 1u << THINGS; set++) {
            if (is_refused(set)) {
                continue;
            }
            start(&ways[i]);
            for (uint32_t thing = 0; thing < THINGS; thing++) {
                TEST_ASSERT_EQUAL(FXL_OK, attach(&ways[i], thing, HAS(set, thing)));
            }
            TEST_ASSERT_EQUAL(
                FXL_OK, fxl_render(&made->renderer, &depth_scene_eye, pixels, DEPTH_SCENE_WIDTH));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &depth_scene_eye));
            for (int32_t k = 0; k < repeat; k++) {
                expect_rectangle(&ways[i]);
            }
        }
    }
}

/* Columns beyond the frame or the stride. */
void test_rectangles_that_are_none(void)
{
    fxl_band band = {.pixels = (uint8_t *)pixels, .width = DEPTH_SCENE_WIDTH, .stride = 8,
                     .rows = 1, .first_column = DEPTH_SCENE_WIDTH - 7, .columns = 8};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    start(&ways[0]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &depth_scene_eye));
    memset(pixels, 0x5A, sizeof pixels);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw(&made->renderer, &band));
    band.first_column--;
    band.stride = 7;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw(&made->renderer, &band));
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, pixels, sizeof pixels);
    band.stride = 8;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&made->renderer, &band));
}

/* A refused frame changes no pixel, and what was refused can be detached. */
/* combinations 1.2 */
void test_after_a_refusal(void)
{
    const way *into = &ways[0];
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    start(into);
    TEST_ASSERT_EQUAL(FXL_OK, attach(into, OUTLINES, true));
    TEST_ASSERT_EQUAL(FXL_OK, attach(into, BEAMS, true));
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_frame_begin(&made->renderer, &depth_scene_eye));
    const fxl_band band = UNIT_BAND(made->frame, DEPTH_SCENE_WIDTH, 0, DEPTH_SCENE_HEIGHT);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&made->renderer, &band));
    const char *names[2];
    TEST_ASSERT_TRUE(fxl_renderer_conflict(&made->renderer, names));
    TEST_ASSERT_EQUAL_STRING("outlines", names[0]);
    TEST_ASSERT_EQUAL_STRING("beams", names[1]);
    TEST_ASSERT_EQUAL(FXL_OK, attach(into, BEAMS, false));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &depth_scene_eye));
    TEST_ASSERT_FALSE(fxl_renderer_conflict(&made->renderer, names));
}

/* A painter draws into its own target alone. */
/* combinations 1.3b */
void test_another_painter_is_refused(void)
{
    const way other = {&fxl_palette, FXL_SURFACES_OF(fxl_palette_depth_16),
                       FXL_SPRITES_OF(fxl_rgb565)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    for (uint32_t i = 0; i < 2; i++) {
        start(&other);
        TEST_ASSERT_EQUAL(FXL_OK, attach(&other, i == 0 ? SURFACES : BILLBOARDS, true));
        TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_frame_begin(&made->renderer, &depth_scene_eye));
    }
}

/* A tree whose instances move among its leaves. */
void test_what_goes_with_a_tree(void)
{
    static uint64_t tree_memory[512];
    bsp_scene *scene = bsp_make();
    const struct {
        const fxl_target *target;
        bool has_outlines;
        const char *refused;
    } cases[] = {{&fxl_palette, false, NULL},
                 {&fxl_rgb565, false, NULL},
                 {&fxl_palette_depth_16, false, "a depth buffer"},
                 {&fxl_rgb565_depth_32, false, "a depth buffer"},
                 {&fxl_palette, true, "instances that the tree cuts"}};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&scene->tiny->scene, NULL));
    for (uint32_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *names[2] = {NULL, NULL};
        fxl_config config = made->config;
        config.target = cases[i].target;
        config.order = &fxl_by_tree;
        config.palette = config.target->pixel_bits == 16 ? colours : NULL;
        config.tree = tree_memory;
        config.tree_size = sizeof tree_memory;
        config.depth = cells;
        config.depth_size = sizeof cells;
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_renderer_init(&made->renderer, &scene->tiny->scene, &config,
                                            made->memory, sizeof made->memory));
        if (cases[i].has_outlines) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&made->renderer, &outlines, &style));
        }
        TEST_ASSERT_EQUAL(cases[i].refused != NULL,
                          fxl_renderer_conflict(&made->renderer, names));
        TEST_ASSERT_EQUAL(
            cases[i].refused != NULL ? FXL_E_COMBINATION : FXL_OK,
            fxl_render(&made->renderer, &depth_scene_eye, pixels, DEPTH_SCENE_WIDTH));
        if (cases[i].refused != NULL) {
            TEST_ASSERT_EQUAL_STRING(cases[i].refused, names[1]);
        }
    }
}

/* combinations 1.1b */
void test_wrong_arguments(void)
{
    fxl_renderer none;
    memset(&none, 0, sizeof none);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    start(&ways[0]);
    fxl_renderer *renderer = &made->renderer;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_attach_surfaces(NULL, &made->surfaces, &made->set, ways[0].painter));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_attach_surfaces(renderer, &made->surfaces, &made->set, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_attach_billboards(NULL, &billboards, &board_set, ways[0].sprites));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_attach_billboards(renderer, &billboards, &board_set, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_lit(NULL, &lit));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_outlines(NULL, &outlines, &style));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_outlines(renderer, NULL, &style));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_attach_lit(&none, &lit));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_attach_outlines(&none, &outlines, &style));
    TEST_ASSERT_FALSE(fxl_renderer_conflict(&none, NULL));
    fxl_config config = made->config;
    config.target = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_init(renderer, &made->scene, &config,
                                                        made->memory, sizeof made->memory));
    config.target = &fxl_rgb565; /* without a palette */
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_init(renderer, &made->scene, &config,
                                                        made->memory, sizeof made->memory));
    config.target = &fxl_palette_depth_16; /* without memory */
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_renderer_init(renderer, &made->scene, &config,
                                                        made->memory, sizeof made->memory));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_begin(renderer, &depth_scene_eye));
}
