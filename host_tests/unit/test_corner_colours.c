/* SPDX-License-Identifier: MIT */
/* Faces with colours at their corners, against the definition in double. */
#include <math.h>
#include <stdlib.h>

#include "quad_scene.h"

enum {
    ROUNDS = UNIT_REPEAT / 200,
    BENEATH = 0x1234,
    CHANNELS = 3,
    FAR = 4000 << 16 /* how far an eye is along an axis, at most */
};

static const int most[CHANNELS] = {31, 63, 31};
static uint16_t palette[256], frame[QUAD_WIDTH * QUAD_HEIGHT], again[QUAD_WIDTH * QUAD_HEIGHT];
static FXL_ALIGN_8 uint8_t memory[4000], depth[FXL_DEPTH_BYTES(QUAD_WIDTH, QUAD_HEIGHT, 16)];
static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(64)];
static fxl_light light;
static int corners[3][CHANNELS];
static double worst;
static uint32_t compared, differing, far_off;

void setUp(void)
{
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = BENEATH;
    }
    worst = 0;
    compared = differing = far_off = 0;
    memset(&light, 0, sizeof light);
    memset(ramp, 0, sizeof ramp);
}

/* A random face with colours at its corners, as a triangle or whole. Some channels are the least or
 * the largest ones. */
static quad_scene *make(bool is_triangle, uint8_t flags, uint8_t division)
{
    quad_scene *quad = quad_make(false);
    quad_begin(quad);
    quad->surface.flags = (uint8_t)(FXL_SURFACE_COLOURS | flags);
    quad->surface.division = division;
    if (is_triangle) {
        quad->face.count = 3;
        fxl_face_take_indices(&quad->face, quad->scene.indices, 0);
        for (uint16_t i = 0; i < 3; i++) {
            quad->mapped_corners[i].vertex = i;
            quad->corners[i] = exact_point(&quad->vertices[i], 1.0 / 65536);
        }
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < CHANNELS; k++) {
            const int channel = unit_between(-60, 315);
            corners[i][k] = channel < 0 ? 0 : channel > 255 ? 255 : channel;
        }
        quad->mapped_corners[i].texel =
            (fxl_texel){FXL_CORNER_COLOUR(corners[i][0], corners[i][1], corners[i][2]), 0};
    }
    return quad;
}

static void begin(quad_scene *quad, const fxl_target *target, const fxl_painter *painter)
{
    fxl_config config = fxl_config_for(QUAD_WIDTH, QUAD_HEIGHT, target);
    config.near_z = 4096;
    config.far_z = 2 * FAR;
    config.palette = palette;
    if (target->depth_bits != 0) {
        config.depth = depth;
        config.depth_size = sizeof depth;
    }
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_renderer_init(&quad->renderer, &quad->scene, &config, memory, sizeof memory));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_attach_surfaces(&quad->renderer, &quad->surfaces, &quad->set, painter));
}

static void draw(quad_scene *quad, uint16_t *to)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&quad->renderer, &quad->pose, to, QUAD_WIDTH));
}

/* A channel at the corners, in levels, of which a pixel shows the one below. */
static void find_channel(int k, const double parts[3], double dark, double values[3])
{
    const double scale = (most[k] + 1) / 256.0;
    for (int i = 0; i < 3; i++) {
        values[i] = dark + ((corners[i][k] + 0.5) * scale - dark) * parts[i];
    }
}

static int channel_of(uint16_t colour, int k)
{
    return colour >> (k == 0 ? 11 : k == 1 ? 5 : 0) & most[k];
}

static void check_pixel(const quad_scene *quad, int x, int y, const double parts[3],
                        uint16_t dark_colour, double tolerance)
{
    const uint16_t shown = frame[y * QUAD_WIDTH + x];
    for (int k = 0; k < CHANNELS; k++) {
        double values[3], weight;
        find_channel(k, parts, channel_of(dark_colour, k) + 0.5, values);
        const double exact =
            fmin(fmax(quad_value(quad, x, y, values, &weight), 0), most[k] + 1 - 1e-9);
        if (weight < 0.02) {
            return;
        }
        const double level = channel_of(shown, k);
        const double off = fmax(level - exact, exact - level - 1);
        TEST_ASSERT_TRUE(off <= tolerance);
        worst = fmax(worst, off);
        compared++;
        differing += off > 0;
        far_off += off > 0.34;
    }
}

static void check_frame(const quad_scene *quad, const double parts[3], uint16_t dark,
                        double tolerance)
{
    for (int y = 0; y < QUAD_HEIGHT; y++) {
        for (int x = 0; x < QUAD_WIDTH; x++) {
            if (frame[y * QUAD_WIDTH + x] != BENEATH) {
                check_pixel(quad, x, y, parts, dark, tolerance);
            }
        }
    }
}

static const double full[3] = {1, 1, 1};

static void draw_random_faces(bool is_triangle, uint8_t division, double tolerance)
{
    for (uint32_t i = 0; i < ROUNDS; i++) {
        quad_scene *quad = make(is_triangle, 0, division);
        begin(quad, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565));
        draw(quad, frame);
        check_frame(quad, full, 0, tolerance);
    }
    TEST_ASSERT_GREATER_THAN(50 * ROUNDS, compared);
}

void test_a_painter_of_textures_is_refused(void)
{
    quad_scene *quad = make(false, 0, FXL_DIVIDE_16);
    begin(quad, &fxl_rgb565, FXL_TEXTURES_OF(fxl_rgb565));
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION,
                      fxl_render(&quad->renderer, &quad->pose, frame, QUAD_WIDTH));
    begin(quad, &fxl_rgb565_depth_16, FXL_TEXTURES_OF(fxl_rgb565_depth_16));
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION,
                      fxl_render(&quad->renderer, &quad->pose, frame, QUAD_WIDTH));
    begin(quad, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565));
    draw(quad, frame);
}

/* SPEC 9.8b-c, 9.8f */
void test_channels_divided_at_each_pixel(void)
{
    draw_random_faces(false, FXL_DIVIDE_1, 1.0 / 256);
    TEST_ASSERT_TRUE(differing < compared / 500);
}

/* Between two divisions a channel is 0.3 of a level off at most, and rounded down by less than
 * 1/32. */
/* SPEC 9.8g-h, 9.1.1q, surfaces 1.4a-b */
void test_channels_of_triangles(void)
{
    draw_random_faces(true, FXL_DIVIDE_16, 0.34);
    TEST_ASSERT_TRUE(worst > 1.0 / 256);
}

void test_channels_of_faces_with_more_corners(void)
{
    draw_random_faces(false, FXL_DIVIDE_16, 0.34);
    draw_random_faces(false, FXL_DIVIDE_8, 0.12);
}

void test_channels_that_are_linear_on_the_screen(void)
{
    uint32_t looked = 0;
    for (uint32_t i = 0; i < 40 * ROUNDS; i++) {
        double any;
        quad_scene *quad = make(true, 0, FXL_AFFINE);
        begin(quad, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&quad->renderer, &quad->pose));
        if (!quad_affine_value(quad, 0, 0, full, &any)) {
            continue; /* few faces have all of their corners on the screen */
        }
        draw(quad, frame);
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            for (int k = 0; frame[p] != BENEATH && k < CHANNELS; k++) {
                double values[3], exact;
                find_channel(k, full, 0, values);
                if (!quad_affine_value(quad, p % QUAD_WIDTH, p / QUAD_WIDTH, values, &exact)) {
                    continue;
                }
                exact = fmin(fmax(exact, 0), most[k] + 1 - 1e-9);
                const double level = channel_of(frame[p], k);
                TEST_ASSERT_TRUE(fmax(level - exact, exact - level - 1) <= 0.05);
                looked++;
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(20 * ROUNDS, looked);
}

/* Triangles of few pixels, whose channels change by many levels from one pixel to the next: so what
 * rounds a narrow one's corners may show. */
void test_channels_of_triangles_of_few_pixels(void)
{
    for (uint32_t i = 0; i < 200 * ROUNDS; i++) {
        quad_scene *quad = make(true, 0, unit_between(0, 1) != 0 ? FXL_DIVIDE_16 : FXL_AFFINE);
        const int32_t times = unit_between(20, 300);
        quad->pose.position.x *= times;
        quad->pose.position.y *= times;
        quad->pose.position.z *= times;
        if (abs(quad->pose.position.x) > FAR || abs(quad->pose.position.y) > FAR ||
            abs(quad->pose.position.z) > FAR) {
            continue;
        }
        begin(quad, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565));
        draw(quad, frame);
        check_frame(quad, full, 0, 64);
    }
    TEST_ASSERT_GREATER_THAN(30 * ROUNDS, compared);
    TEST_ASSERT_TRUE(far_off < compared / 300);
}

enum {
    WIDE = QUAD_WIDTH * QUAD_HEIGHT / 2
};

/* One row of a screen of WIDE x 256 pixels. */
static void draw_wide_row(quad_scene *quad, const fxl_target *target, const fxl_painter *painter,
                          int row, uint16_t *to)
{
    fxl_config config = fxl_config_for(WIDE, 256, target);
    const fxl_band band = {.pixels = (uint8_t *)to,
                           .width = WIDE,
                           .stride = WIDE,
                           .first_row = (uint16_t)row,
                           .rows = 1,
                           .palette = palette};
    config.near_z = 4096;
    config.palette = palette;
    config.depth = target->depth_bits != 0 ? depth : NULL;
    config.depth_size = target->depth_bits != 0 ? sizeof depth : 0;
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_renderer_init(&quad->renderer, &quad->scene, &config, memory, sizeof memory));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_attach_surfaces(&quad->renderer, &quad->surfaces, &quad->set, painter));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&quad->renderer, &quad->pose));
    fxl_frame_fill(&quad->renderer, &band, 0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&quad->renderer, &band));
}

/* Triangles that face the eye, up to the whole width of a wide screen, of which single rows are
 * drawn: their channels are linear on the screen, and a run begins anew every 64 columns. With a depth
 * buffer they show the same. */
/* SPEC 9.8g */
void test_channels_of_wide_triangles(void)
{
    uint32_t looked = 0;
    for (uint32_t i = 0; i < ROUNDS; i++) {
        quad_scene *quad = make(true, 0, FXL_DIVIDE_16);
        double x[3], y[3];
        for (int k = 0; k < 3; k++) { /* clockwise, 512 units a screen's width */
            x[k] = (k == 0 ? -1 : k == 1 ? 1 : 0.1) * unit_between(10, i % 2 ? 255 : 40);
            y[k] = (k == 2 ? -1 : 1) * unit_between(4, 60);
            quad->vertices[k] = (fxl_point){Q16(x[k] / 64), Q16(y[k] / 64), 0};
            quad->corners[k] = exact_point(&quad->vertices[k], 1.0 / 65536);
        }
        quad->face.normal = (fxl_direction){0, 0, -FXL_Q2_30_ONE};
        quad->pose = (fxl_pose){.position = {0, 0, -Q16(4)}};
        const int row = unit_between(0, 255);
        draw_wide_row(quad, &fxl_rgb565_depth_16, FXL_SURFACES_OF(fxl_rgb565_depth_16), row, again);
        draw_wide_row(quad, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565), row, frame);
        TEST_ASSERT_EQUAL_MEMORY(frame, again, WIDE * sizeof *frame);
        const double scale = quad->renderer.frame.view.lens.focal / 65536.0 / 4 / 64;
        for (int c = 0; c < WIDE; c++) {
            const double px = (c + 0.5 - WIDE / 2) / scale, py = (128 - row - 0.5) / scale;
            const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
            const double b1 = ((px - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (py - y[0])) / area;
            const double b2 = ((x[1] - x[0]) * (py - y[0]) - (px - x[0]) * (y[1] - y[0])) / area;
            for (int k = 0; frame[c] != BENEATH && k < CHANNELS; k++) {
                double values[3];
                find_channel(k, full, 0, values);
                const double exact =
                    values[0] + b1 * (values[1] - values[0]) + b2 * (values[2] - values[0]);
                const double level = channel_of(frame[c], k);
                TEST_ASSERT_TRUE(fmax(level - exact, exact - level - 1) <= 0.05);
                looked++;
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(20 * ROUNDS, looked);
}

/* One colour at all corners is the palette's entry of that colour: the upper bits of each channel.
 */
/* rgb565 2.4a-b */
void test_one_colour_at_all_corners(void)
{
    for (uint32_t i = 0; i < ROUNDS; i++) {
        quad_scene *quad = make(unit_between(0, 1) != 0, 0, (uint8_t)unit_between(0, 3));
        const int *c = corners[0];
        const uint16_t colour = (uint16_t)(c[0] >> 3 << 11 | c[1] >> 2 << 5 | c[2] >> 3);
        quad->mapped_corners[1].texel = quad->mapped_corners[2].texel =
            quad->mapped_corners[0].texel;
        begin(quad, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565));
        draw(quad, frame);
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            TEST_ASSERT_TRUE(frame[p] == BENEATH || frame[p] == colour);
        }
    }
}

/* place light: definition: light of colours at corners */
/* Light from a direction: it is multiplied at the corners, whose products are linear. */
static void check_lit_faces(uint8_t division, double tolerance)
{
    for (uint32_t i = 0; i < ROUNDS; i++) {
        const fxl_point origin = {0, 0, 0};
        fxl_light_settings settings = exact_light_any(ramp, &origin);
        settings.levels = (uint8_t)unit_between(2, 64);
        settings.dark = (uint16_t)unit_random();
        quad_scene *quad = make(unit_between(0, 1) != 0, FXL_SURFACE_LIT, division);
        double parts[3];
        begin(quad, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565));
        quad_light(quad, &light, &settings);
        draw(quad, frame);
        for (int k = 0; k < 3; k++) {
            parts[k] =
                exact_brightness(&settings, &quad->renderer.frame.view.camera, quad->corners[k],
                                 exact_direction(&quad->normals[quad->mapped_corners[k].normal]));
        }
        check_frame(quad, parts, settings.dark, tolerance);
    }
}

/* SPEC 9.8d, surfaces 1.4d */
void test_light_at_the_corners(void)
{
    check_lit_faces(FXL_DIVIDE_16, 0.34);
    TEST_ASSERT_GREATER_THAN(50 * ROUNDS, compared);
    check_lit_faces(FXL_DIVIDE_8, 0.12);
    TEST_ASSERT_GREATER_THAN(100 * ROUNDS, compared);
}

/* The same pixels in one band and in bands of five rows, and with a depth buffer. */
/* rgb565 3.6 */
void test_bands_and_depth_change_no_pixel(void)
{
    for (uint32_t i = 0; i < ROUNDS; i++) {
        quad_scene *quad = make(unit_between(0, 1) != 0, 0, FXL_DIVIDE_16);
        begin(quad, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565));
        draw(quad, frame);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&quad->renderer, &quad->pose));
        for (uint16_t row = 0; row < QUAD_HEIGHT; row = (uint16_t)(row + 5)) {
            const fxl_band band = {.pixels = (uint8_t *)(again + row * QUAD_WIDTH),
                                   .width = QUAD_WIDTH,
                                   .stride = QUAD_WIDTH,
                                   .first_row = row,
                                   .rows =
                                       (uint16_t)(QUAD_HEIGHT - row < 5 ? QUAD_HEIGHT - row : 5),
                                   .palette = palette};
            fxl_frame_fill(&quad->renderer, &band, 0);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&quad->renderer, &band));
        }
        TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
        begin(quad, &fxl_rgb565_depth_16, FXL_SURFACES_OF(fxl_rgb565_depth_16));
        draw(quad, again);
        TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
    }
}

/* A triangle that is cut within the screen shows what it shows where it is whole, and so does one of
 * a renderer without a display list and a cache. Cut edges are rounded, so a pixel whose centre is on one may be drawn. */
/* SPEC 9.1.1r */
void test_what_cuts_a_triangle_changes_no_pixel(void)
{
    uint32_t drawn = 0, cut = 0, more = 0;
    for (uint32_t i = 0; i < 4 * ROUNDS; i++) {
        quad_scene *quad = make(true, 0, FXL_DIVIDE_16);
        fxl_config config = fxl_config_for(QUAD_WIDTH, QUAD_HEIGHT, &fxl_rgb565);
        config.near_z = 4096;
        config.far_z = 2 * FAR;
        config.palette = palette;
        begin(quad, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565));
        draw(quad, frame);
        for (uint32_t k = 0; k < 2; k++) {
            fxl_lens lens = quad->renderer.frame.view.lens;
            fxl_memory tables = {
                (fxl_draw_entry *)(void *)memory, quad->scene.draw_list_needed, NULL, 0, NULL, 0};
            lens.inset = k == 0 ? lens.inset : FXL_INSET_MAX;
            TEST_ASSERT_EQUAL(
                FXL_OK, fxl_renderer_init_with(&quad->renderer, &quad->scene, &lens, &tables));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_choose(&quad->renderer, &config));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&quad->renderer, &quad->surfaces,
                                                          &quad->set, FXL_SURFACES_OF(fxl_rgb565)));
            draw(quad, again);
            for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
                const bool is_edge = k != 0 && (again[p] == BENEATH || frame[p] == BENEATH);
                TEST_ASSERT_TRUE(again[p] == frame[p] || is_edge);
                more += again[p] != BENEATH && frame[p] == BENEATH;
                drawn += again[p] != BENEATH;
                cut += again[p] != frame[p];
            }
        }
    }
    TEST_ASSERT_TRUE(drawn > 50 * ROUNDS && cut > ROUNDS);
    TEST_ASSERT_LESS_THAN(3, more);
}

/* Stipple leaves pixels out, and blending mixes them, each by the rule of any surface. */
/* surfaces 4.2, SPEC 9.8i */
void test_opacity_and_blending(void)
{
    uint32_t left_out = 0, drawn = 0;
    for (uint32_t i = 0; i < ROUNDS; i++) {
        quad_scene *quad = make(true, 0, FXL_DIVIDE_16);
        begin(quad, &fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565));
        draw(quad, frame);
        quad->surface.opacity = 8;
        draw(quad, again);
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            TEST_ASSERT_TRUE(again[p] == BENEATH || again[p] == frame[p]);
            left_out += again[p] != frame[p];
            drawn += again[p] != BENEATH;
        }
        quad->surface.opacity = 16;
        quad->surface.flags = FXL_SURFACE_COLOURS | FXL_SURFACE_BLEND;
        quad->surface.sixteenths = 4;
        draw(quad, again);
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            for (int k = 0; frame[p] != BENEATH && k < CHANNELS; k++) {
                TEST_ASSERT_EQUAL((4 * channel_of(frame[p], k) + 12 * channel_of(BENEATH, k)) / 16,
                                  channel_of(again[p], k));
            }
        }
        quad->surface.flags = FXL_SURFACE_COLOURS | FXL_SURFACE_ADD;
        quad->surface.sixteenths = 0;
        draw(quad, again);
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            for (int k = 0; frame[p] != BENEATH && k < CHANNELS; k++) {
                const int sum = channel_of(frame[p], k) + channel_of(BENEATH, k);
                TEST_ASSERT_EQUAL(sum < most[k] ? sum : most[k], channel_of(again[p], k));
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(drawn / 2, left_out);
    TEST_ASSERT_GREATER_THAN(20 * ROUNDS, drawn);
}

/* --- what is refused ----------------------------------------------------------------------- */

static fxl_status status_of(quad_scene *quad, uint32_t bits)
{
    return fxl_surfaces_check(&quad->set, &quad->scene, bits, NULL);
}

/* surfaces 1.4e, SPEC 9.8a */
void test_what_the_check_refuses(void)
{
    quad_scene *quad = make(false, 0, FXL_DIVIDE_16);
    TEST_ASSERT_EQUAL(FXL_OK, status_of(quad, 16));
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, status_of(quad, 8));
    quad->mapped_corners[2].texel.u = 0xFFFFFF;
    TEST_ASSERT_EQUAL(FXL_OK, status_of(quad, 16));
    quad->mapped_corners[2].texel.u = 0x1000000;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, status_of(quad, 16));
    quad->mapped_corners[2].texel.u = -1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, status_of(quad, 16));
    quad->mapped_corners[2].texel = (fxl_texel){0, 1};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, status_of(quad, 16));
    quad->mapped_corners[2].texel = (fxl_texel){0, 0};
    static const uint16_t texel[1];
    quad->texture =
        (fxl_texture){.texels = (const uint8_t *)texel, .levels = 1, .format = FXL_TEXTURE_565};
    quad->set.texture_count = 1;
    quad->surface.texture = 1;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, status_of(quad, 16));
    quad->surface.flags = 0;
    TEST_ASSERT_EQUAL(FXL_OK, status_of(quad, 16));
}
