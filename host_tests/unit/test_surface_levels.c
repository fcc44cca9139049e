/* SPDX-License-Identifier: MIT */
/* Levels of textures, surfaces that are linear on the screen, and blending, against the
 * definitions. */
#include <math.h>

#include "frame_bands.h"
#include "quad_scene.h"

enum {
    ROUNDS = UNIT_REPEAT / 200
};

/* A texture of 8 x 2 texels, of which each is another colour: levels of 16, 4, 2 and 1 texels. */
static const uint8_t texels[] = {1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12,
                                 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23};
/* The same of 4 bits, with levels of 16, 4, 2 and 2 texels. */
static const uint8_t halves[] = {0x10, 0x32, 0x54, 0x76, 0x98, 0xBA,
                                 0xDC, 0xFE, 0x10, 0x32, 0x54, 0x76};
static const uint8_t colours[16] = {40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55};
static uint32_t compared, of_level[4];
static uint8_t again[QUAD_WIDTH * QUAD_HEIGHT]; /* a second frame: a board has 16 KB */

void setUp(void)
{
    compared = 0;
    memset(of_level, 0, sizeof of_level);
}

static int log_of(int log, int level, int least)
{
    return log > level + least ? log - level : least;
}

/* place sampling: definition: exact_texel */
/* The colour of a texel of a level, repeated. */
static uint8_t exact_texel(bool of_4_bits, int level, double u, double v)
{
    const int least = of_4_bits ? 1 : 0;
    int at = 0;
    for (int i = 0; i < level; i++) {
        at += 1 << (log_of(3, i, least) + log_of(1, i, 0));
    }
    const int columns = 1 << log_of(3, level, least), rows = 1 << log_of(1, level, 0);
    const int column = (int)floor(u * columns / 8) & (columns - 1);
    const int row = (int)floor(v * rows / 2) & (rows - 1);
    at += row * columns + column;
    return of_4_bits ? colours[halves[at / 2] >> 4 * (at % 2) & 15] : texels[at];
}

/* margin: how far a pixel's place may be off, in texels. */
static void check_levels(const quad_scene *quad, bool of_4_bits, int level, double margin)
{
    const double scale_u = ldexp(1, log_of(3, level, of_4_bits) - 3);
    const double scale_v = ldexp(1, log_of(1, level, 0) - 1);
    double u[3], v[3], weight;
    for (int k = 0; k < 3; k++) {
        u[k] = quad->mapped_corners[k].texel.u / 65536.0;
        v[k] = quad->mapped_corners[k].texel.v / 65536.0;
    }
    for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
        const double at_u = quad_value(quad, p % QUAD_WIDTH, p / QUAD_WIDTH, u, &weight);
        const double at_v = quad_value(quad, p % QUAD_WIDTH, p / QUAD_WIDTH, v, &weight);
        const double off = fmin(fabs(at_u * scale_u - floor(at_u * scale_u + 0.5)),
                                fabs(at_v * scale_v - floor(at_v * scale_v + 0.5)));
        if (quad->frame[p] != QUAD_BACKGROUND && weight > 0.02 && off > margin) {
            TEST_ASSERT_EQUAL(exact_texel(of_4_bits, level, at_u, at_v), quad->frame[p]);
            compared++;
            of_level[level]++;
        }
    }
}

/* The level is that of the definition, and so is each texel of it. A triangle has the first three
 * vertices of the face. */
static void check_faces(bool is_triangle, uint8_t division, double margin)
{
    for (uint32_t i = 0; i < ROUNDS; i++) {
        const bool of_4_bits = unit_between(0, 1) == 1;
        quad_scene *quad = quad_make(false);
        quad->texture = (fxl_texture){.texels = of_4_bits ? halves : texels,
                                      .colours = of_4_bits ? colours : NULL,
                                      .log_width = 3,
                                      .log_height = 1,
                                      .format = of_4_bits ? FXL_TEXTURE_4 : FXL_TEXTURE_8,
                                      .levels = 4};
        quad->set.texture_count = 1;
        quad->surface.texture = 1;
        quad->surface.division = division;
        if (is_triangle) {
            quad->face.count = 3;
            fxl_face_take_indices(&quad->face, quad->scene.indices, 0);
            quad->mapped_corners[2].vertex = 2;
            quad->mapped_corners[1].vertex = 1;
        }
        for (int k = 0; k < 3; k++) {
            quad->mapped_corners[k].texel.u = quad->mapped_corners[k].texel.u * 8 >> i % 10;
            quad->mapped_corners[k].texel.v = quad->mapped_corners[k].texel.v * 8 >> i % 10;
        }
        quad_begin(quad);
        quad_draw(quad);
        if (is_triangle) {
            quad->outline[3] = quad->outline[2];
        }
        const double ratio = quad_texels(quad);
        const double wanted = ratio <= 0 ? 0 : fmin(fmax((log2(ratio) + 1) / 2, 0), 3.9);
        if (fabs(wanted - floor(wanted + 0.5)) > 1e-6) {
            check_levels(quad, of_4_bits, (int)floor(wanted), margin);
        }
    }
}

/* surfaces 3.1c, 3.2a-c, SPEC 9.4a, 9.4c, 9.4e */
void test_a_face_takes_the_level_of_its_nearest_vertex(void)
{
    check_faces(false, FXL_DIVIDE_1, 0.01);
    TEST_ASSERT_GREATER_THAN(50 * ROUNDS, compared);
    for (int level = 0; level < 4; level++) {
        TEST_ASSERT_GREATER_THAN(compared / 200, of_level[level]);
    }
}

/* Triangles of few pixels, whose texels may be off by 0.3 of one. */
/* surfaces 3.2a-c, SPEC 9.4a, 9.4c */
void test_a_small_triangle_takes_the_level_of_its_nearest_vertex(void)
{
    check_faces(true, FXL_DIVIDE_16, 0.35);
    TEST_ASSERT_GREATER_THAN(5 * ROUNDS, compared);
    for (int level = 0; level < 4; level++) {
        TEST_ASSERT_GREATER_THAN(0, of_level[level]);
    }
}

/* A part of the screen, which has an off-centre lens, shows what the whole screen shows there. */
void test_an_off_centre_lens_shows_the_same_texels(void)
{
    enum {
        LEFT = 16,
        TOP = 5,
        PART_WIDTH = 30,
        PART_HEIGHT = 25
    };
    uint32_t different = 0;
    for (uint32_t i = 0; i < ROUNDS / 4; i++) {
        quad_scene *quad = quad_make(false);
        fxl_draw_entry order[2];
        fxl_lens lens;
        quad->texture =
            (fxl_texture){.texels = texels, .log_width = 3, .log_height = 1, .levels = 4};
        quad->set.texture_count = 1;
        quad->surface.texture = 1;
        quad->surface.division = i % 2 ? FXL_DIVIDE_16 : FXL_DIVIDE_1;
        quad_begin(quad);
        quad_draw(quad);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_of_part(&quad->renderer.frame.view.lens, LEFT, TOP,
                                                   PART_WIDTH, PART_HEIGHT, &lens));
        const fxl_memory memory = {order, 2, NULL, 0, NULL, 0};
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_renderer_init_with(&quad->renderer, &quad->scene, &lens, &memory));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&quad->renderer, &quad->surfaces, &quad->set,
                                                      FXL_SURFACES_OF(fxl_palette)));
        frame_draw_pose(&quad->renderer, &quad->pose, again, PART_HEIGHT, QUAD_BACKGROUND);
        for (int y = 0; y < PART_HEIGHT; y++) {
            for (int x = 0; x < PART_WIDTH; x++) {
                const uint8_t shown = quad->frame[(y + TOP) * QUAD_WIDTH + x + LEFT];
                different += again[y * PART_WIDTH + x] != shown;
                compared += shown != QUAD_BACKGROUND;
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(10 * ROUNDS, compared);
    TEST_ASSERT_LESS_THAN(3 + compared / 500, different); /* of the 1,500 of a small board, too */
}

static void expect_same_in_bands(quad_scene *quad)
{
    frame_draw_pose(&quad->renderer, &quad->pose, again, 4, QUAD_BACKGROUND);
    TEST_ASSERT_EQUAL_MEMORY(quad->frame, again, sizeof again);
}

/* The display list keeps level, light and blending of a face. */
void test_lists_and_bands_give_the_same_pixels(void)
{
    static uint8_t table[FXL_BLEND_TABLE_BYTES(1)], ramp[512];
    static fxl_light light;
    const fxl_light_settings of = {.ambient = FXL_Q2_30_ONE / 3,
                                   .strength = FXL_Q2_30_ONE,
                                   .direction = {FXL_Q2_30_ONE, 0, 0},
                                   .ramp = ramp,
                                   .levels = 2};
    uint32_t listed = 0;
    for (uint32_t i = 0; i < 256; i++) {
        ramp[i] = (uint8_t)(i + 100);
        ramp[256 + i] = (uint8_t)(i + 150);
        table[i] = (uint8_t)(255 - i);
    }
    for (uint32_t i = 0; i < ROUNDS / 4; i++) {
        quad_scene *quad = quad_make(i % 2 == 0);
        quad->texture =
            (fxl_texture){.texels = texels, .log_width = 3, .log_height = 1, .levels = 4};
        quad->set.texture_count = 1;
        quad->set.blend = table;
        quad->set.blend_first = 105;
        quad->set.blend_count = 1;
        quad->surface.texture = i % 3 != 0;
        quad->surface.flags = FXL_SURFACE_LIT | FXL_SURFACE_BLEND;
        quad->surface.opacity = i % 5 == 0 ? 8 : 16;
        quad_begin(quad);
        quad_light(quad, &light, &of);
        quad_draw(quad);
        expect_same_in_bands(quad);
        listed += quad->renderer.frame.display_list.used > 0;
        quad->renderer.frame.display_list.capacity = 0;
        expect_same_in_bands(quad);
        TEST_ASSERT_EQUAL_UINT32(0, quad->renderer.frame.display_list.used);
    }
    TEST_ASSERT_GREATER_THAN(ROUNDS / 8, listed);
}

/* Where its corners are on the screen, a face of FXL_AFFINE is linear there; else it is exact to
 * half a texel. */
/* SPEC 9.3b, 9.2i */
void test_an_affine_face_is_linear_on_the_screen(void)
{
    static uint8_t wide[64];
    uint32_t linear = 0;
    for (uint32_t i = 0; i < sizeof wide; i++) {
        wide[i] = (uint8_t)i;
    }
    for (uint32_t i = 0; i < ROUNDS * 4; i++) {
        quad_scene *quad = quad_make(false);
        double u[3], at;
        quad->texture = (fxl_texture){.texels = wide, .log_width = 6, .levels = 1};
        quad->set.texture_count = 1;
        quad->surface.texture = 1;
        quad->surface.division = FXL_AFFINE;
        for (int k = 0; k < 3; k++) {
            quad->mapped_corners[k].texel.u /= 8;
            u[k] = quad->mapped_corners[k].texel.u / 65536.0;
        }
        quad_begin(quad);
        quad_draw(quad);
        const bool is_linear = quad_affine_value(quad, 0, 0, u, &at);
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            if (quad->frame[p] == QUAD_BACKGROUND || !is_linear) {
                continue;
            }
            (void)quad_affine_value(quad, p % QUAD_WIDTH, p / QUAD_WIDTH, u, &at);
            if (fabs(at - floor(at + 0.5)) > 0.01) {
                TEST_ASSERT_EQUAL((int)floor(at) & 63, quad->frame[p]);
                linear++;
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(10 * ROUNDS, linear);
}

/* A face beyond the screen's borders is drawn as one that is divided every 16 pixels. */
/* surfaces 2.3b */
void test_an_affine_face_beyond_the_screen_is_divided(void)
{
    quad_scene *quad;
    double zero[3] = {0, 0, 0}, at;
    do {
        quad = quad_make(false);
        quad->texture =
            (fxl_texture){.texels = texels, .log_width = 3, .log_height = 1, .levels = 1};
        quad->set.texture_count = 1;
        quad->surface.texture = 1;
        quad->surface.division = FXL_AFFINE;
        quad_begin(quad);
        quad_draw(quad);
    } while (quad_affine_value(quad, 0, 0, zero, &at) ||
             quad->renderer.workspace.counters.clipped == 0);
    memcpy(again, quad->frame, sizeof again);
    quad->surface.division = FXL_DIVIDE_16;
    quad_draw(quad);
    TEST_ASSERT_EQUAL_MEMORY(quad->frame, again, sizeof again);
}

/* --- blending ------------------------------------------------------------------------------ */

/* Three colours from QUAD_COLOUR on are blended; the one of the face is the first. */
/* SPEC 9.5, 9.6d, 9.6i, surfaces 1.1, 4.3a-b */
void test_colours_are_blended_with_those_beneath(void)
{
    static uint8_t table[FXL_BLEND_TABLE_BYTES(3)], plain[16];
    uint32_t covered = 0;
    memset(plain, QUAD_COLOUR, sizeof plain);
    for (uint32_t i = 0; i < sizeof table; i++) {
        table[i] = (uint8_t)(100 + 10 * (i / 256) + (i & 255) % 7);
    }
    for (uint32_t i = 0; i < 40; i++) {
        quad_scene *quad = quad_make(false);
        const int32_t first = unit_between(QUAD_COLOUR - 4, QUAD_COLOUR + 1);
        quad->texture = (fxl_texture){.texels = plain, .log_width = 4, .levels = 1};
        quad->set.texture_count = 1;
        quad->surface.texture = i % 2;
        quad->surface.flags = FXL_SURFACE_BLEND;
        quad->set.blend = table;
        quad->set.blend_first = (uint32_t)first;
        quad->set.blend_count = 3;
        quad_begin(quad);
        const fxl_band band = UNIT_BAND(quad->frame, QUAD_WIDTH, 0, QUAD_HEIGHT);
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            quad->frame[p] = (uint8_t)(200 + p % 50);
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&quad->renderer, &quad->pose));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&quad->renderer, &band));
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            const int beneath = 200 + p % 50;
            if (quad->frame[p] != beneath) {
                covered++;
                TEST_ASSERT_EQUAL(first <= QUAD_COLOUR && QUAD_COLOUR < first + 3
                                      ? 100 + 10 * (QUAD_COLOUR - first) + beneath % 7
                                      : QUAD_COLOUR,
                                  quad->frame[p]);
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(1000, covered);
}

/* A set says which colours it blends, and has a table where a surface does. */
void test_a_blend_table_that_is_none_is_refused(void)
{
    quad_scene *quad = quad_make(false);
    const uint8_t table[1] = {0};
    quad_begin(quad);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_surfaces_check(&quad->set, &quad->scene, 8, NULL));
    quad->surface.flags = FXL_SURFACE_BLEND;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_surfaces_check(&quad->set, &quad->scene, 8, NULL));
    quad->set.blend = table;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_surfaces_check(&quad->set, &quad->scene, 8, NULL));
    quad->set.blend_first = 1;
    quad->set.blend_count = 256;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_surfaces_check(&quad->set, &quad->scene, 8, NULL));
    quad->set.blend_count = 255;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_surfaces_check(&quad->set, &quad->scene, 8, NULL));
    quad->set.blend_first = 256;
    quad->set.blend_count = 0;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_surfaces_check(&quad->set, &quad->scene, 8, NULL));
    quad->set.blend_first = 0;
    quad->surface.flags = 4;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check(&quad->set, &quad->scene, 8, NULL));
}

/* place stipple: definition: the table of a blend */
/* A grey of a palette of greys, some of them twice, blended with another. */
/* surfaces 4.3c */
void test_a_blend_table_has_the_nearest_colours(void)
{
    static uint8_t palette[3 * 256], table[FXL_BLEND_TABLE_BYTES(2)];
    for (int i = 0; i < 256; i++) {
        palette[3 * i] = palette[3 * i + 1] = palette[3 * i + 2] = (uint8_t)(i < 250 ? i : 9);
    }
    for (int sixteenths = 1; sixteenths <= 16; sixteenths += 5) {
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_blend_make_table(palette, (uint32_t)sixteenths, 249, 2, table));
        for (int beneath = 0; beneath < 250; beneath++) {
            const int mixed = (int)floor(beneath + (249 - beneath) * sixteenths / 16.0 + 0.5);
            TEST_ASSERT_EQUAL(mixed, table[beneath]);
            TEST_ASSERT_EQUAL((int)floor(beneath + (9 - beneath) * sixteenths / 16.0 + 0.5),
                              table[256 + beneath]);
        }
        TEST_ASSERT_EQUAL(9, table[256 + 255]); /* of two that are equal, the first */
        TEST_ASSERT_EQUAL(250, table[256 + 250]);
    }
    memset(palette, 0, sizeof palette); /* far from white, all but one a little more than that */
    memset(&palette[3 * 255], 255, 3);
    palette[3 * 7] = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_blend_make_table(palette, 1, 255, 1, table));
    TEST_ASSERT_EQUAL(7, table[0]); /* of (16, 16, 16) */
    TEST_ASSERT_EQUAL(255, table[255]);
    const uint8_t before = table[0];
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_blend_make_table(NULL, 8, 0, 1, table));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_blend_make_table(palette, 8, 0, 1, NULL));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_blend_make_table(palette, 0, 0, 1, table));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_blend_make_table(palette, 17, 0, 1, table));
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_blend_make_table(palette, 8, 0, 0, table));
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_blend_make_table(palette, 8, 255, 2, table));
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_blend_make_table(palette, 8, 256, 1, table));
    TEST_ASSERT_EQUAL(before, table[0]);
}

/* Twice the square pixels of the triangle, and the sides of its box: SPEC 9.4's a, w and h. */
static void find_box(const quad_scene *quad, double *twice_area, double *sides)
{
    const fxl_lens *lens = &quad->renderer.frame.view.lens;
    const fxl_axes *axes = &quad->renderer.frame.view.camera.axes;
    double x[3], y[3];
    for (int i = 0; i < 3; i++) {
        const exact_vector p = exact_minus(
            quad->corners[i], exact_point(&quad->renderer.frame.view.camera.position, 1.0 / 65536));
        const double z = exact_dot(exact_direction(&axes->forward), p);
        x[i] = lens->focal / 65536.0 * exact_dot(exact_direction(&axes->right), p) / z;
        y[i] = lens->focal / 65536.0 * exact_dot(exact_direction(&axes->up), p) / z;
    }
    *twice_area = fabs((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]));
    *sides = fmax(x[0], fmax(x[1], x[2])) - fmin(x[0], fmin(x[1], x[2])) +
             fmax(y[0], fmax(y[1], y[2])) - fmin(y[0], fmin(y[1], y[2]));
}

/* Triangles whose texels a pixel are 2^-6 to 2^-20 of them beside the end of a level: it is the next
 * one only nearer than the definition says. */
/* SPEC 9.4d */
void test_the_level_beside_its_end(void)
{
    static const uint8_t of_level_alone[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
                                             1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 4};
    uint32_t checked = 0, close = 0;
    for (uint32_t i = 0; i < ROUNDS * 20; i++) {
        quad_scene *quad = quad_make(false);
        quad->texture =
            (fxl_texture){.texels = of_level_alone, .log_width = 3, .log_height = 1, .levels = 4};
        quad->set.texture_count = 1;
        quad->surface.texture = 1;
        quad->face.count = 3;
        fxl_face_take_indices(&quad->face, quad->scene.indices, 0);
        quad->mapped_corners[2].vertex = 2;
        quad->mapped_corners[1].vertex = 1;
        quad_begin(quad);
        quad_draw(quad);
        quad->outline[3] = quad->outline[2];
        const double off = ldexp(i % 2 ? 1 : -1, -unit_between(6, 20));
        const double times = sqrt(ldexp(1 + off, unit_between(0, 1) * 2 + 1) / quad_texels(quad));
        if (!(times < 60)) {
            continue; /* it is behind the eye, or its numbers would be too large */
        }
        for (int k = 0; k < 3; k++) {
            quad->mapped_corners[k].texel.u = (int32_t)(quad->mapped_corners[k].texel.u * times);
            quad->mapped_corners[k].texel.v = (int32_t)(quad->mapped_corners[k].texel.v * times);
        }
        quad_begin(quad);
        quad_draw(quad);
        quad->outline[3] = quad->outline[2];
        double area, sides;
        find_box(quad, &area, &sides);
        const double wanted = (log2(quad_texels(quad)) + 1) / 2, end = floor(wanted + 0.5);
        const double beside = fabs(exp2(2 * (wanted - end)) - 1);
        const double error = ldexp(1, -26) + 1.1 * sides / (65536 * area) + ldexp(1, -27);
        for (int p = 0; p < QUAD_WIDTH * QUAD_HEIGHT; p++) {
            if (quad->frame[p] != QUAD_BACKGROUND) {
                const int level = quad->frame[p] - 1;
                TEST_ASSERT_TRUE(level == (int)floor(wanted) ||
                                 (beside < error && level == (int)end - (wanted >= end)));
                checked++;
                close += beside < 4 * error;
            }
        }
    }
    TEST_ASSERT_TRUE(checked > 100 * ROUNDS && close > ROUNDS);
}
