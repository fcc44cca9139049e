/* SPDX-License-Identifier: MIT */
/* The sentences about refused calls: each mistake that a first program makes gets one that names
 * the argument and its range, and no call that succeeds gets one. */
#include "bsp_scene.h"
#include "tiny_frames.h"
#include "unit.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    LARGE = 4096
};

static uint64_t block[LARGE / 8], cells[2 * WIDTH * HEIGHT / 8];
static uint16_t pixels[WIDTH * HEIGHT + 1], palette[257];
static fxl_renderer renderer;
static fxl_scene scene;
static fxl_config config;
static fxl_pose eye;
static fxl_band band;

void setUp(void)
{
    tiny_scene *made = tiny_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    scene = made->scene;
    memset(&renderer, 0, sizeof renderer);
    config = fxl_config_default(WIDTH, HEIGHT);
    eye = (fxl_pose){.position = {0, 0, FXL_UNITS(-6)}};
    band = (fxl_band){.pixels = (uint8_t *)pixels, .width = WIDTH, .stride = WIDTH, .rows = HEIGHT};
}

static void expect_words(const char *said, const char *argument, const char *range)
{
    TEST_ASSERT_NOT_NULL(said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, argument), said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, range), said);
}

/* --- fxl_renderer_init ---------------------------------------------------------------------- */

static void refuse_init(fxl_renderer *of, const fxl_scene *shown, const fxl_config *chosen,
                        void *memory, size_t size, const char *argument, const char *range)
{
    TEST_ASSERT_NOT_EQUAL(FXL_OK, fxl_renderer_init(of, shown, chosen, memory, size));
    expect_words(fxl_renderer_explain(of, shown, chosen, memory, size), argument, range);
}

/* With the configuration as the test has changed it, which is then as before. */
static void refuse_config(const char *argument, const char *range)
{
    refuse_init(&renderer, &scene, &config, block, sizeof block, argument, range);
    config = fxl_config_default(WIDTH, HEIGHT);
}

void test_arguments_of_fxl_renderer_init(void)
{
    fxl_scene unchecked = scene;
    unchecked.draw_list_needed = 0;
    refuse_init(NULL, &scene, &config, block, LARGE, "renderer", "not be null");
    refuse_init(&renderer, NULL, &config, block, LARGE, "scene", "not be null");
    refuse_init(&renderer, &scene, NULL, block, LARGE, "config", "fxl_config_default");
    refuse_init(&renderer, &scene, &config, NULL, LARGE, "memory", "not be null");
    refuse_init(&renderer, &scene, &config, (uint8_t *)block + 4, LARGE - 8, "memory", "8 bytes");
    refuse_init(&renderer, &unchecked, &config, block, LARGE, "scene", "fxl_scene_check");
    refuse_init(&renderer, &scene, &config, block, 8, "memory_size", "draw_list_needed");
    unchecked = scene;
    unchecked.instance_count += 1000; /* after the check */
    refuse_init(&renderer, &unchecked, &config, block, LARGE, "instance_count", "fxl_scene_check");
}

void test_the_lens_of_a_configuration(void)
{
    config.width = 0;
    refuse_config("width", "1..1024");
    config.height = 1025;
    refuse_config("height", "1..1024");
    config.fov = 60;
    refuse_config("fov", "FXL_DEGREES(10)..FXL_DEGREES(150)");
    config.fov = FXL_DEGREES(170);
    refuse_config("fov", "FXL_DEGREES(10)..FXL_DEGREES(150)");
    config.near_z = 1;
    refuse_config("near_z", "FXL_RATIO(1, 256)");
    config.far_z = -1;
    refuse_config("far_z", "FXL_UNITS(32767)");
    config.inset = FXL_UNITS(2);
    refuse_config("inset", "0..FXL_UNITS(1)");
    config.far_z = config.near_z;
    refuse_config("far_z", "near_z");
}

void test_the_target_and_the_order_of_a_configuration(void)
{
    config.target = NULL;
    refuse_config("target", "not be null");
    config.target = &fxl_rgb565;
    refuse_config("palette", "256 colours");
    config.target = &fxl_rgb565;
    config.palette = (const uint16_t *)(const void *)((const uint8_t *)palette + 1);
    refuse_config("palette", "even address");
    config.target = &fxl_palette_depth_16;
    refuse_config("depth", "8 bytes");
    config.target = &fxl_palette_depth_16;
    refuse_config("depth", "FXL_DEPTH_BYTES(width, rows, bits)");
    config.target = &fxl_palette_depth_16;
    config.depth = cells;
    config.depth_size = 8;
    refuse_config("depth_size", "FXL_DEPTH_BYTES");
    bsp_scene *const made = bsp_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&made->tiny->scene, NULL));
    scene = made->tiny->scene;
    config.order = &fxl_by_tree;
    refuse_config("tree", "8 bytes");
    config.order = &fxl_by_tree;
    config.tree = (uint8_t *)cells + 4;
    config.tree_size = sizeof cells - 8;
    refuse_config("tree", "8 bytes");
    config.order = &fxl_by_tree;
    config.tree = cells;
    config.tree_size = 0;
    refuse_config("tree_size", "fxl_bsp_workspace_size");
    config.order = &fxl_by_tree;
    config.tree = cells;
    config.tree_size = sizeof cells;
    TEST_ASSERT_NULL(fxl_renderer_explain(&renderer, &scene, &config, block, sizeof block));
}

/* --- fxl_render and fxl_frame_draw ---------------------------------------------------------- */

static void begin(const fxl_target *target)
{
    config.target = target;
    config.palette = target->pixel_bits == 16 ? palette : NULL;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, block, sizeof block));
    TEST_ASSERT_NULL(fxl_renderer_explain(&renderer, &scene, &config, block, sizeof block));
}

static void refuse_render(const fxl_pose *from, void *to, uint16_t stride, const char *argument,
                          const char *range)
{
    TEST_ASSERT_NOT_EQUAL(FXL_OK, fxl_render(&renderer, from, to, stride));
    expect_words(fxl_render_explain(&renderer, from, to, stride, NULL), argument, range);
}

void test_arguments_of_fxl_render(void)
{
    refuse_render(&eye, pixels, WIDTH, "renderer", "fxl_renderer_init");
    expect_words(fxl_render_explain(NULL, &eye, pixels, WIDTH, NULL), "renderer", "not be null");
    begin(&fxl_palette);
    refuse_render(NULL, pixels, WIDTH, "eye", "not be null");
    refuse_render(&eye, NULL, WIDTH, "pixels", "rows");
    refuse_render(&eye, pixels, WIDTH - 1, "stride", "config.width");
    eye.position.y = FXL_UNITS(8191) + 1;
    refuse_render(&eye, pixels, WIDTH, "eye->position", "8191");
    eye.position.y = 0;
    scene.instance_count = renderer.instance_capacity + 1;
    refuse_render(&eye, pixels, WIDTH, "instance_count", "instance_capacity");
    setUp();
    begin(&fxl_rgb565);
    refuse_render(&eye, (uint8_t *)pixels + 1, WIDTH, "pixels", "even address");
    renderer.clipper = NULL; /* as fxl_renderer_init_bare leaves it */
    refuse_render(&eye, pixels, WIDTH, "renderer", "fxl_renderer_init");
    begin(&fxl_rgb565);
    renderer.target = NULL;
    refuse_render(&eye, pixels, WIDTH, "renderer", "fxl_renderer_init");
    begin(&fxl_rgb565);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, pixels, WIDTH));
    TEST_ASSERT_NULL(fxl_render_explain(&renderer, &eye, pixels, WIDTH, NULL));
}

/* combinations 1.2b-c */
void test_two_things_that_do_not_go_together(void)
{
    static fxl_outlines outlines;
    const fxl_outline_style style = {.line = 1};
    const char *names[2] = {"-", "-"};
    TEST_ASSERT_FALSE(fxl_renderer_conflict(&renderer, names)); /* it has no target */
    TEST_ASSERT_EQUAL_STRING("-", names[0]);
    config.depth = cells;
    config.depth_size = sizeof cells;
    begin(&fxl_palette_depth_16);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, &outlines, &style));
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_render(&renderer, &eye, pixels, WIDTH));
    TEST_ASSERT_TRUE(fxl_renderer_conflict(&renderer, names));
    expect_words(fxl_render_explain(&renderer, &eye, pixels, WIDTH, NULL), names[0], names[1]);
    expect_words(fxl_renderer_explain(&renderer, &scene, &config, block, sizeof block), names[0],
                 "&fxl_outlines_by_depth");
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, NULL, NULL));
    TEST_ASSERT_NULL(fxl_renderer_explain(&renderer, &scene, &config, block, sizeof block));
}

/* --- what has a list of sentences ------------------------------------------------------------ */

static void refuse(const char *reasons, fxl_status expected, fxl_status status,
                   const char *argument, const char *range)
{
    TEST_ASSERT_EQUAL(expected, status);
    expect_words(fxl_explain(reasons, status), argument, range);
}

static fxl_light light;

static void refuse_light(fxl_light_settings settings, fxl_status expected, const char *argument,
                         const char *range)
{
    refuse(fxl_light_reasons, expected, fxl_attach_light(&renderer, &light, &settings), argument,
           range);
}

void test_mistakes_with_a_light(void)
{
    static const uint8_t ramp[2 * 256];
    const fxl_light_settings good = {.ambient = FXL_Q2_30_ONE, .ramp = ramp, .levels = 2};
    fxl_light_settings wrong = good;
    refuse_light(good, FXL_E_ORDER, "renderer", "fxl_renderer_init");
    begin(&fxl_palette);
    TEST_ASSERT_NULL(fxl_explain(fxl_light_reasons, fxl_attach_light(&renderer, &light, &good)));
    wrong.levels = 1;
    refuse_light(wrong, FXL_E_COUNT, "settings->levels", "2..64");
    wrong.levels = 65;
    refuse_light(wrong, FXL_E_COUNT, "settings->levels", "2..64");
    wrong = good;
    wrong.point_count = FXL_LIGHT_POINTS_MAX + 1;
    refuse_light(wrong, FXL_E_COUNT, "settings->point_count", "0..4");
    wrong = good;
    wrong.ramp = NULL;
    refuse_light(wrong, FXL_E_ARGUMENT, "settings->ramp", "not be null");
    wrong = good;
    wrong.strength = FXL_Q2_30_ONE;
    wrong.direction.x = FXL_Q2_30_ONE / 2;
    refuse_light(wrong, FXL_E_NORMAL, "settings->direction", "unit length");
    wrong = good;
    wrong.ambient = -1;
    refuse_light(wrong, FXL_E_RANGE, "settings->ambient", "0..FXL_Q2_30_ONE");
}

void test_texels_of_16_bits_on_a_palette(void)
{
    static const uint16_t texels[1], face_map[64];
    static const fxl_mapped_face faces[1];
    static const fxl_corner corners[1];
    const fxl_texture texture = {.texels = (const uint8_t *)texels,
                                 .format = FXL_TEXTURE_565, .levels = 1};
    const fxl_surface surface = {.texture = 1, .opacity = 16};
    const fxl_surface_set set = {.textures = &texture, .surfaces = &surface, .faces = faces,
                                 .face_map = face_map, .corners = corners, .texture_count = 1, .surface_count = 1};
    static fxl_surfaces surfaces;
    refuse(fxl_surfaces_reasons, FXL_E_ORDER,
           fxl_attach_surfaces(&renderer, &surfaces, &set, FXL_SURFACES_OF(fxl_rgb565)),
           "renderer", "fxl_renderer_init");
    begin(&fxl_palette);
    refuse(fxl_surfaces_reasons, FXL_E_RESERVED,
           fxl_attach_surfaces(&renderer, &surfaces, &set, FXL_SURFACES_OF(fxl_palette)),
           "16-bit texels", "config.target of RGB565");
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&renderer, &surfaces, &set,
                                                  FXL_SURFACES_OF(fxl_rgb565)));
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_render(&renderer, &eye, pixels, WIDTH));
    const char *said = fxl_render_explain(&renderer, &eye, pixels, WIDTH, NULL);
    expect_words(said, "surfaces", "the renderer's target");
    expect_words(said, "16-bit texels", "RGB565");
}

void test_a_status_that_has_no_sentence(void)
{
    TEST_ASSERT_NULL(fxl_explain(fxl_light_reasons, FXL_OK));
    TEST_ASSERT_NULL(fxl_explain(fxl_light_reasons, FXL_E_STALE));
    TEST_ASSERT_NULL(fxl_explain(NULL, FXL_E_RANGE));
    expect_words(fxl_explain(fxl_world_reasons, FXL_E_STALE), "handle", "removed"); /* the last */
}

/* With a placement as the test has changed it, which is then as before. */
static void refuse_placement(fxl_placement *placement, uint32_t number, const char *range)
{
    uint32_t found = UINT32_MAX;
    const char *said;
    TEST_ASSERT_NOT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, pixels, WIDTH));
    said = fxl_render_explain(&renderer, &eye, pixels, WIDTH, &found);
    expect_words(said, "instance *number", range);
    TEST_ASSERT_EQUAL_UINT32(number, found);
    TEST_ASSERT_EQUAL_PTR(said, fxl_render_explain(&renderer, &eye, pixels, WIDTH, NULL));
    *placement = (fxl_placement)FXL_PLACEMENT_NONE;
}

void test_the_placement_that_is_wrong(void)
{
    static fxl_placement placements[TINY_INSTANCES];
    tiny_scene *tiny = tiny_make();
    fxl_q16_16 *const z = &tiny->instances[2].centre.z;
    const fxl_q16_16 before = *z;
    uint32_t found = UINT32_MAX;
    tiny_place_from(tiny, placements, 1);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    scene = tiny->scene;
    begin(&fxl_palette);
    placements[1].scale = FXL_SCALE_MIN - 1;
    refuse_placement(&placements[1], 2, "1/256..256");
    placements[1].scale = 0; /* of a record that is all zeros */
    refuse_placement(&placements[1], 2, "FXL_PLACEMENT_NONE");
    placements[0].scale = FXL_SCALE_MAX + 1;
    refuse_placement(&placements[0], 1, "1/256..256");
    *z = FXL_UNITS(8191);
    refuse_placement(&placements[1], 2, "FXL_UNITS(8191)");
    *z = FXL_UNITS(-1000); /* behind the eye, where no orientation is read */
    placements[1].orientation.x.x = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, pixels, WIDTH));
    TEST_ASSERT_NULL(fxl_render_explain(&renderer, &eye, pixels, WIDTH, &found));
    *z = before;
    refuse_placement(&placements[1], 2, "a rotation");
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, pixels, WIDTH));
    TEST_ASSERT_NULL(fxl_render_explain(&renderer, &eye, pixels, WIDTH, &found));
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, found);
    scene.placement_code = NULL;
    refuse_render(&eye, pixels, WIDTH, "placement_code", "not be null");
    scene.placement_code = tiny->scene.placement_code;
    eye.position.x = INT32_MAX;
    refuse_render(&eye, pixels, WIDTH, "eye->position", "8191");
}

/* With the band as the test has changed it, which is then as before. */
static void refuse_band(const char *argument, const char *range)
{
    const fxl_band as_changed = band;
    TEST_ASSERT_NOT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &as_changed));
    expect_words(fxl_frame_explain(&renderer, &as_changed), argument, range);
    band = (fxl_band){.pixels = (uint8_t *)pixels,
                      .width = WIDTH,
                      .stride = WIDTH,
                      .rows = HEIGHT,
                      .palette = renderer.palette};
}

void test_arguments_of_fxl_frame_draw(void)
{
    begin(&fxl_palette);
    expect_words(fxl_frame_explain(NULL, &band), "renderer", "not be null");
    expect_words(fxl_frame_explain(&renderer, NULL), "band must", "not be null");
    refuse_band("frame", "fxl_frame_begin");
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    band.pixels = NULL;
    refuse_band("band->pixels must", "not be null");
    band.width = WIDTH / 2;
    refuse_band("band->width", "config.width");
    band.stride = WIDTH - 1;
    refuse_band("band->stride", "pixels of a row");
    band.rows = 0;
    refuse_band("band->rows", "at least 1");
    band.first_row = 1;
    refuse_band("band->first_row + band->rows", "config.height");
    band.first_column = 40;
    band.columns = 9;
    refuse_band("band->columns", "config.width");
    band.palette = palette;
    refuse_band("band->palette", "null");
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
    TEST_ASSERT_NULL(fxl_frame_explain(&renderer, &band));
    begin(&fxl_rgb565);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    band.palette = NULL;
    refuse_band("band->palette", "config.palette");
    band.pixels += 1;
    refuse_band("pixels", "even address");
}

/* A call is refused if and only if there is a sentence. */
void test_random_arguments(void)
{
    static const fxl_q16_16 lengths[] = {-1, 0, 255, 256, 65536, 65537, 32767 * 65536, INT32_MAX};
    static const uint16_t extents[] = {0, 1, WIDTH, 1024, 1025, UINT16_MAX};
    static const fxl_target *const targets[] = {&fxl_palette, &fxl_rgb565, &fxl_palette_depth_16,
                                                &fxl_rgb565_depth_32, NULL};
    uint32_t sound = 0;
    for (uint32_t i = 0; i < UNIT_REPEAT; i++) {
        config.width = extents[unit_between(0, 5)];
        config.height = extents[unit_between(0, 5)];
        config.fov = unit_between(0, 3) ? FXL_DEGREES(70) : unit_random();
        config.near_z = lengths[unit_between(0, 7)];
        config.far_z = lengths[unit_between(2, 7)];
        config.inset = lengths[unit_between(0, 5)];
        config.target = targets[unit_between(0, 4)];
        config.palette = unit_between(0, 3) ? palette : NULL;
        config.depth = unit_between(0, 3) ? cells : NULL;
        config.depth_size = (uint32_t)unit_between(0, (int32_t)sizeof cells);
        const size_t size = (size_t)unit_between(0, LARGE);
        const fxl_status status = fxl_renderer_init(&renderer, &scene, &config, block, size);
        const char *said = fxl_renderer_explain(&renderer, &scene, &config, block, size);
        TEST_ASSERT_EQUAL_MESSAGE(status == FXL_OK, said == NULL, said != NULL ? said : "nothing");
        sound += status == FXL_OK;
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, sound);
}
