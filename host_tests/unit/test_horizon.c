/* SPDX-License-Identifier: MIT */
/* A sky and a ground, each pixel against its definition in double. */
#include <math.h>

#include "fixel/horizon.h"
#include "rgb565_scene.h"
/* place field: small images, each field broken */
#include "scene/scene_sections.h"
#include "tiny.h"

static fxl_renderer renderer;
static uint64_t memory[400];
static uint8_t frame[HEIGHT * WIDTH], again[HEIGHT * WIDTH];
static fxl_q2_30 sines[FXL_HORIZON_MAX];
static uint8_t colours[FXL_HORIZON_MAX + 1];
static fxl_horizon horizon = {sines, colours, 1};

/* No model is in sight: the scene's only instance is behind the eye, or far away. */
static const fxl_point corners[3] = {{0, 0, 0}, {0, 65536, 0}, {65536, 0, 0}};
static const uint16_t indices[3] = {0, 1, 2};
static const fxl_face faces[1] = {{{0, 0, -FXL_Q2_30_ONE}, 3, 200, FXL_INDICES_AT(0, 0)}};
static const fxl_model models[1] = {{0, 3, 0, 1, FXL_MODEL_CONVEX, 0, 0, Q16(2), 0}};
static const fxl_instance instances[1] = {{{Q16(8000), Q16(8000), Q16(8000)}, 0, 0, 0}};
static fxl_scene scene = {.vertices = corners,
                          .indices = indices,
                          .faces = faces,
                          .models = models,
                          .instances = instances,
                          .vertex_count = 3,
                          .index_count = 3,
                          .face_count = 1,
                          .model_count = 1,
                          .instance_count = 1};

static void start(const fxl_lens *lens)
{
    static fxl_draw_entry entries[8];
    const fxl_memory tables = {.draw_list = entries, .draw_list_capacity = 8};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &scene, lens, &tables));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_horizon(&renderer, &horizon));
}

/* Any sines, ascending; 0 and the ends are among them often. */
static void any_horizon(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t kind = unit_random() % 8;
        fxl_q2_30 sine = kind == 0   ? 0
                         : kind == 1 ? FXL_Q2_30_ONE
                         : kind == 2
                             ? -FXL_Q2_30_ONE
                             : unit_between(-FXL_Q2_30_ONE, FXL_Q2_30_ONE) >> unit_random() % 12;
        uint32_t at = i;
        for (; at > 0 && sines[at - 1] > sine; at--) {
            sines[at] = sines[at - 1];
        }
        sines[at] = sine;
    }
    for (uint32_t i = 0; i <= count; i++) {
        colours[i] = (uint8_t)(3 * i + 1);
    }
    horizon.count = count;
}

/* A lens of this screen; half of them are off-centre. */
static fxl_lens any_lens(void)
{
    fxl_lens lens;
    const fxl_angle fov = (fxl_angle)DEGREES(unit_between(11, 149));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(WIDTH, HEIGHT, fov, Q16(0.25), Q16(500), 0, &lens));
    if (unit_random() % 2) {
        const int32_t most = 4 * lens.focal < Q16(50) ? 4 * lens.focal : Q16(50);
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_lens_set_centre(&lens, Q16(WIDTH / 2) + unit_between(-most, most),
                                              Q16(HEIGHT / 2) + unit_between(-most, most)));
    }
    return lens;
}

static fxl_pose any_pose(void)
{
    fxl_pose pose = unit_pose();
    if (unit_random() % 4 == 0) {
        pose.roll = 0;
    }
    if (unit_random() % 4 == 0) { /* straight up or down, or nearly */
        pose.pitch = FXL_ANGLE_QUARTER * (unit_random() % 2 ? 1u : 3u) +
                     (unit_random() % 2 ? 0 : unit_random() >> 8);
    }
    return pose;
}

/* How many pixels show another level than the definition, and the sine of their elevation is further than 2^-20 from the sine between. */
static void expect_levels(const fxl_lens *lens, const fxl_pose *pose, const uint8_t *pixels)
{
    fxl_camera camera;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(pose, &camera));
    const fxl_axes *axes = &camera.axes;
    for (int j = 0; j < HEIGHT; j++) {
        for (int i = 0; i < WIDTH; i++) {
            /* place fill-rule: definition of a ray through the centre of a pixel */
            const int64_t x = i * 65536 + 32768 - lens->centre_x,
                          y = lens->centre_y - j * 65536 - 32768;
            const int64_t e =
                axes->right.y * x + axes->up.y * y + (int64_t)axes->forward.y * lens->focal;
            const double length = sqrt((double)x * (double)x + (double)y * (double)y +
                                       (double)lens->focal * lens->focal);
            const double sine = (double)e / length / FXL_Q2_30_ONE;
            const uint32_t level = (pixels[j * WIDTH + i] - 1u) / 3;
            TEST_ASSERT_TRUE(level <= horizon.count);
            for (uint32_t k = 0; k < horizon.count; k++) {
                const double side = sine - (double)sines[k] / FXL_Q2_30_ONE;
                if ((k < level) != (side >= 0)) {
                    TEST_ASSERT_TRUE(fabs(side) < 0x1p-20);
                }
                if (sines[k] == 0 && lens->off_centre == NULL) {
                    TEST_ASSERT_EQUAL(e >= 0, k < level);
                }
            }
        }
    }
}

/* horizon 1.1a, 1.2a-b, 1.3a-b */
void test_each_pixel_has_its_level(void)
{
    for (int i = 0; i < UNIT_REPEAT / 300; i++) {
        const fxl_lens lens = any_lens();
        const fxl_pose pose = any_pose();
        any_horizon(1 + unit_random() % (i % 4 == 0 ? FXL_HORIZON_MAX : 5));
        start(&lens);
        memset(frame, 0, sizeof frame);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
        expect_levels(&lens, &pose, frame);
    }
}

/* Any rectangles of any heights draw what one call draws, and touch nothing else. */
/* horizon 1.4a */
void test_rectangles_are_parts_of_the_frame(void)
{
    for (int i = 0; i < UNIT_REPEAT / 1000; i++) {
        const fxl_lens lens = any_lens();
        const fxl_pose pose = any_pose();
        any_horizon(1 + unit_random() % 9);
        start(&lens);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
        memset(again, 255, sizeof again);
        const uint16_t column = (uint16_t)unit_between(1, WIDTH - 1);
        for (uint16_t row = 0, rows; row < HEIGHT; row = (uint16_t)(row + rows)) {
            rows = (uint16_t)unit_between(1, HEIGHT - row);
            for (int right = 0; right < 2; right++) {
                const uint16_t first = right ? column : 0;
                const fxl_band band = {.pixels = again + row * WIDTH + first,
                                       .width = WIDTH,
                                       .stride = WIDTH,
                                       .first_row = row,
                                       .rows = rows,
                                       .first_column = first,
                                       .columns = right ? (uint16_t)(WIDTH - column) : column};
                fxl_frame_fill(&renderer, &band, 77);
                TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
            }
        }
        TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
    }
}

/* About the zenith or the nadir, far from the axis of a wide lens, a row rises and falls, and in a narrow part its level
 * may change just where it turns: so in rows of which each half is alike, then in rows that turn beside the part (the
 * first part); in a row before such, whose second half changes within (the second); or in one whose second half is alike. */
/* horizon 1.1a, 1.4a */
void test_narrow_parts_whose_level_changes_where_a_row_turns(void)
{
    static const struct {
        int32_t degrees;
        fxl_angle pitch, roll;
        fxl_q2_30 sine;
        uint16_t first, columns;
    } parts[] = {{129, 3185434078u, 1339640739u, -1070730468, 25, 5},
                 {149, 2409953872u, 1429753746u, -1069836303, 42, 3},
                 {131, 2565049913u, 1659250203u, -1068745613, 36, 2}};
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_pose pose = {{0, 0, 0}, 0, parts[i].pitch, parts[i].roll};
        const fxl_angle fov = (fxl_angle)DEGREES(parts[i].degrees);
        fxl_lens lens;
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_lens_from_fov(WIDTH, HEIGHT, fov, Q16(0.25), Q16(500), 0, &lens));
        any_horizon(1);
        sines[0] = parts[i].sine;
        start(&lens);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
        expect_levels(&lens, &pose, frame);
        const fxl_band band = {.pixels = again + parts[i].first,
                               .width = WIDTH,
                               .stride = WIDTH,
                               .rows = HEIGHT,
                               .first_column = parts[i].first,
                               .columns = parts[i].columns};
        memcpy(again, frame, sizeof again);
        for (uint32_t y = 0; y < HEIGHT; y++) {
            memset(again + y * WIDTH + band.first_column, 255, band.columns);
        }
        fxl_frame_fill(&renderer, &band, 77);
        TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
    }
}

/* Of large frames the excess is followed from row to row; of bands of one row it is not. */
/* horizon 1.4a */
void test_rows_together_are_those_drawn_one_by_one(void)
{
    enum {
        COLUMNS = 200,
        ROWS = 120
    };
    static uint8_t whole[ROWS * COLUMNS], rows[ROWS * COLUMNS];
    for (int i = 0; i < UNIT_REPEAT / 1000; i++) {
        fxl_lens lens;
        fxl_camera camera;
        fxl_pose pose = any_pose();
        const fxl_angle fov = (fxl_angle)DEGREES(unit_between(11, 149));
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_lens_from_fov(COLUMNS, ROWS, fov, Q16(0.25), Q16(500), 0, &lens));
        any_horizon(1 + unit_random() % 9);
        if (i % 2) { /* near the horizon, hardly rolled */
            pose.pitch = unit_random() >> 5;
            pose.roll = unit_random() >> (2 + unit_random() % 16);
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
        const fxl_axes *axes = &camera.axes;
        for (uint32_t k = 0; k < horizon.count && i % 3; k++) { /* the sine of a pixel, or nearly */
            const int64_t x = unit_between(0, COLUMNS - 1) * 65536 + 32768 - lens.centre_x;
            const int64_t y = lens.centre_y - unit_between(0, ROWS - 1) * 65536 - 32768;
            const double length = sqrt((double)(x * x + y * y) + (double)lens.focal * lens.focal);
            const int64_t e =
                axes->right.y * x + axes->up.y * y + (int64_t)axes->forward.y * lens.focal;
            sines[k] = (fxl_q2_30)((double)e / length) / 2 * 2;
            for (uint32_t at = k; at > 0 && sines[at - 1] > sines[at]; at--) {
                const fxl_q2_30 other = sines[at];
                sines[at] = sines[at - 1];
                sines[at - 1] = other;
            }
        }
        start(&lens);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, whole, COLUMNS));
        for (uint16_t row = 0; row < ROWS; row++) {
            const fxl_band band = {.pixels = rows + row * COLUMNS,
                                   .width = COLUMNS,
                                   .stride = COLUMNS,
                                   .first_row = row,
                                   .rows = 1};
            fxl_frame_fill(&renderer, &band, 77);
        }
        TEST_ASSERT_EQUAL_MEMORY(rows, whole, sizeof whole);
    }
}

/* The colour of each entry, in RGB565, through the renderer's palette; and with a depth buffer. */
/* horizon 1.2b, 1.4a */
void test_frames_of_rgb565_have_the_palettes_colours(void)
{
    static uint16_t palette[256], wide[HEIGHT * WIDTH];
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, &fxl_rgb565);
    const fxl_pose pose = {{0, 0, 0}, 0, DEGREES(7), DEGREES(20)};
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(i * 257);
    }
    any_horizon(20);
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    start(&lens);
    config.palette = palette;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_horizon(&renderer, &horizon));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, wide, WIDTH));
    config.target = &fxl_palette_depth_16;
    static uint64_t cells[FXL_DEPTH_BYTES(WIDTH, 8, 16) / 8];
    config.depth = cells;
    config.depth_size = sizeof cells;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_horizon(&renderer, &horizon));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        TEST_ASSERT_EQUAL_HEX16(palette[frame[i]], wide[i]);
    }
}

/* The pump's bands, of more rows than two of them have. */
static bool take_rows(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes,
                      size_t size)
{
    (void)user;
    memcpy(again + first_row * WIDTH, bytes, size);
    return size == (size_t)rows * WIDTH;
}

static bool wait_for_rows(void *user)
{
    (void)user;
    return true;
}

/* horizon 1.4a-b */
void test_the_pump_draws_it_and_fill_band_does_not(void)
{
    static uint64_t bands[2 * WIDTH];
    const fxl_pump_sink sink = {.start = take_rows, .wait = wait_for_rows};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{0, 0, 0}, 0, DEGREES(-9), DEGREES(33)};
    const fxl_pump_config config = {.width = WIDTH, .height = HEIGHT, .rows = 4};
    fxl_pump pump;
    any_horizon(12);
    start(&lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
    memset(again, 255, sizeof again);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_init(&pump, &config, &sink, bands, sizeof bands));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_frame(&pump, &renderer, &pose));
    TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
    const fxl_band band = {.pixels = again, .width = WIDTH, .stride = WIDTH, .rows = HEIGHT};
    fxl_fill_band(&band, 77);
    TEST_ASSERT_EACH_EQUAL_UINT8(77, again, sizeof again);
}

/* What is drawn over it, mixed with it and lit, in fog, is what is drawn over its picture. */
/* horizon 1.5a-c */
void test_faces_are_drawn_over_it_and_nothing_is_picked_in_it(void)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(9)];
    const fxl_light_settings settings = {
        .point_count = 1,
        .ramp = ramp,
        .levels = 9,
        .fog_near = Q16(1),
        .fog_far = Q16(9),
        .points = {{{Q16(-2), Q16(1), Q16(4)}, Q16(7), FXL_Q2_30_ONE}}};
    fxl_band band = {
        .pixels = (uint8_t *)walls.again, .width = WIDTH, .stride = WIDTH, .rows = HEIGHT};
    uint32_t seen = 0, mixed = 0;
    walls_make();
    walls.surface[0].flags = FXL_SURFACE_BLEND;
    walls.surface[0].opacity = 7;
    any_horizon(30);
    walls_begin();
    walls_light(&settings);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_horizon(&walls.renderer, &horizon));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&walls.renderer, &walls_eye, walls.pixels, WIDTH));
    band.palette = walls.palette;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&walls.renderer, &walls_eye));
    for (uint16_t y = 0; y < HEIGHT; y++) {
        for (uint16_t x = 0; x < WIDTH; x++) {
            fxl_picked picked;
            TEST_ASSERT_EQUAL(FXL_OK, fxl_pick_face(&walls.renderer, x, y, &picked));
            frame[y * WIDTH + x] = picked.instance == FXL_PICK_NONE;
        }
    }
    fxl_frame_fill(&walls.renderer, &band, 77);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        if (frame[i]) {
            TEST_ASSERT_EQUAL_HEX16(walls.again[i], walls.pixels[i]);
            seen++;
        }
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&walls.renderer, &band));
    TEST_ASSERT_EQUAL_HEX16_ARRAY(walls.again, walls.pixels, WIDTH * HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_horizon(&walls.renderer, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&walls.renderer, &walls_eye, walls.again, WIDTH));
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        mixed += !frame[i] && walls.again[i] != walls.pixels[i];
    }
    TEST_ASSERT_GREATER_THAN(50, seen);
    TEST_ASSERT_GREATER_THAN(50, mixed);
}

void test_a_detached_horizon_leaves_the_background(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    any_horizon(3);
    start(&lens);
    renderer.frame.background = 9;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_horizon(&renderer, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
    memset(again, 9, sizeof again);
    TEST_ASSERT_EQUAL_MEMORY(again, frame, sizeof frame);
}

/* changed 1.3 */
void test_an_attached_horizon_changes_the_whole_frame(void)
{
    static uint64_t records[FXL_CHANGED_MEMORY(1, 1, 0, 0)];
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_changed changed;
    any_horizon(3);
    start(&lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_init(&changed, records, sizeof records));
    for (int i = 0; i < 4; i++) {
        if (i == 2) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_horizon(&renderer, &horizon));
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &renderer));
        TEST_ASSERT_EQUAL(i % 2 == 0, changed.whole);
    }
}

/* All rays of such a lens have one elevation. */
/* horizon 1.6c, combinations 1.2 */
void test_an_orthographic_lens_is_refused(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    const char *names[2];
    any_horizon(3);
    start(&lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, Q16(8)));
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_render(&renderer, &pose, frame, WIDTH));
    TEST_ASSERT_TRUE(fxl_renderer_conflict(&renderer, names));
    TEST_ASSERT_EQUAL_STRING("an orthographic lens", names[0]);
    TEST_ASSERT_EQUAL_STRING("a horizon", names[1]);
    TEST_ASSERT_NOT_NULL(
        strstr(fxl_render_explain(&renderer, &pose, frame, WIDTH, NULL), names[1]));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_horizon(&renderer, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
}

/* An image's horizon is that of its two sections, which come together. */
/* formats 1.2bf, 1.2bg, 1.15b */
void test_the_horizon_of_an_image(void)
{
    fxl_scene_image opened;
    fxl_scene_fault fault;
    tiny_image *image = tiny_image_make(false);
    any_horizon(3);
    tiny_set_section(image, SECTION_HORIZON_SINES, sines, 3, sizeof sines[0]);
    tiny_set_section(image, SECTION_HORIZON_COLOURS, colours, 4, sizeof colours[0]);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_UINT32(3, opened.horizon.count);
    TEST_ASSERT_EQUAL_MEMORY(sines, opened.horizon.sines, 3 * sizeof sines[0]);
    TEST_ASSERT_EQUAL_MEMORY(colours, opened.horizon.colours, 4);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_horizon_check(&opened.horizon));
    for (uint32_t count = 3; count <= 5; count += 2) {
        tiny_set_section(image, SECTION_HORIZON_COLOURS, colours, count, sizeof colours[0]);
        tiny_seal(image);
        TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_open(image->words, image->size, &opened, &fault));
        TEST_ASSERT_EQUAL_STRING("horizon colours", fault.what);
    }
    sines[0] = FXL_Q2_30_ONE; /* which the sections do not say is wrong */
    sines[2] = -1;
    tiny_set_section(image, SECTION_HORIZON_SINES, sines, 3, sizeof sines[0]);
    tiny_set_section(image, SECTION_HORIZON_COLOURS, colours, 4, sizeof colours[0]);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_horizon_check(&opened.horizon));
    tiny_set_section(image, SECTION_HORIZON_SINES, sines, 0, sizeof sines[0]);
    tiny_set_section(image, SECTION_HORIZON_COLOURS, colours, 0, sizeof colours[0]);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_NULL(opened.horizon.sines);
}

/* horizon 1.6a-b */
void test_what_is_no_horizon_is_refused(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    any_horizon(4);
    sines[0] = -5, sines[1] = 0, sines[2] = 0, sines[3] = FXL_Q2_30_ONE;
    start(&lens);
    fxl_horizon other = horizon;
    const uint32_t refused = renderer.workspace.counters.refused_calls;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_horizon_check(NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_horizon(NULL, &horizon));
    other.sines = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_horizon(&renderer, &other));
    other = horizon;
    other.colours = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_horizon(&renderer, &other));
    other = horizon;
    other.count = 0;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_attach_horizon(&renderer, &other));
    other.count = FXL_HORIZON_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_attach_horizon(&renderer, &other));
    other = horizon;
    sines[3] = FXL_Q2_30_ONE + 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_attach_horizon(&renderer, &other));
    sines[3] = -1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_attach_horizon(&renderer, &other));
    TEST_ASSERT_EQUAL_PTR(&horizon, renderer.horizon);
    TEST_ASSERT_EQUAL_UINT32(refused + 6, renderer.workspace.counters.refused_calls);
    fxl_renderer none;
    memset(&none, 0, sizeof none);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_attach_horizon(&none, &horizon));
}
