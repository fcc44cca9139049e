/* SPDX-License-Identifier: MIT */
/* The formats of displays, pixel by pixel, against docs/extras/pixels.md. */
#include "pixel_formats.h"
#include "unit.h"

#define WIDEST 66u
#define ROWS   11u
#define GUARD  0xA5u

static uint8_t palette[768];
static uint8_t frame[ROWS * (WIDEST + 3u) + 4u];
static uint32_t out_words[(3u * WIDEST * ROWS + 8u) / 4u];
static uint8_t *const out = (uint8_t *)out_words;
static uint16_t frame_565[ROWS * (WIDEST + 3u) + 4u];
static const uint16_t colours[256]; /* of a band of RGB565; no conversion reads them */
static fxl_pixels pixels;

/* place converter: got, expected (the formula in C) and sizes */
static const fxl_pixel_format *const formats[] = EVERY_FORMAT;

void setUp(void)
{
    for (uint32_t i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(unit_random() >> 9);
    }
    memset(out, GUARD, sizeof out_words);
}

/* Runs of any length, and noise. */
static void any_frame(void)
{
    for (uint32_t i = 0; i < sizeof frame;) {
        const uint8_t colour = (uint8_t)(unit_random() >> 11);
        const int32_t longest = (unit_random() & 0x100u) != 0 ? 1 : 60;
        for (int32_t left = unit_between(1, longest); left > 0 && i < sizeof frame; left--) {
            frame[i++] = colour;
        }
    }
}

/* The level of a pixel, by the formula of docs/formats.md, section 4. */
static uint32_t level_of(const uint8_t *colour, uint32_t highest, uint32_t x, uint32_t y)
{
    uint32_t sum = 0;
    for (uint32_t k = 0; k < 3; k++) {
        sum = 4u * sum + 2u * (((x ^ y) >> k) & 1u) + ((y >> k) & 1u);
    }
    const uint32_t luma = (54u * colour[0] + 183u * colour[1] + 19u * colour[2] + 128u) / 256u;
    const uint32_t rest = luma * highest % 255u;
    return luma * highest / 255u + (128u * rest > 255u * (2u * sum + 1u));
}

/* What stands for a pixel in the converted band. */
static uint32_t got(const fxl_band *band, uint32_t x, uint32_t row)
{
    const uint32_t width = band->width;
    if (pixels.format == &fxl_pixels_rgb565) {
        const uint8_t *at = out + 2u * (row * width + x);
        return (uint32_t)at[0] << 8 | at[1];
    }
    if (pixels.format == &fxl_pixels_rgb565_low) {
        const uint8_t *at = out + 2u * (row * width + x);
        return (uint32_t)at[1] << 8 | at[0];
    }
    if (pixels.format == &fxl_pixels_rgb332) {
        return out[row * width + x];
    }
    if (pixels.format == &fxl_pixels_rgb666) {
        const uint8_t *at = out + 3u * (row * width + x);
        return (uint32_t)at[0] << 16 | (uint32_t)at[1] << 8 | at[2];
    }
    if (pixels.format == &fxl_pixels_grey4) {
        const uint8_t byte = out[row * ((width + 1u) / 2u) + x / 2u];
        return x % 2u == 0 ? byte >> 4 : byte & 15u;
    }
    if (pixels.format == &fxl_pixels_mono_rows) {
        return (uint32_t)out[row * ((width + 7u) / 8u) + x / 8u] >> (7u - x % 8u) & 1u;
    }
    return (uint32_t)out[row / 8u * width + x] >> (row % 8u) & 1u;
}

static uint32_t expected(const uint8_t *colour, uint32_t x, uint32_t y)
{
    if (pixels.format == &fxl_pixels_rgb565 || pixels.format == &fxl_pixels_rgb565_low) {
        return (uint32_t)(colour[0] / 8u * 2048u + colour[1] / 4u * 32u + colour[2] / 8u);
    }
    if (pixels.format == &fxl_pixels_rgb332) {
        return (uint32_t)(colour[0] / 32u * 32u + colour[1] / 32u * 4u + colour[2] / 64u);
    }
    if (pixels.format == &fxl_pixels_rgb666) {
        const uint32_t red = colour[0] / 8u, green = colour[1] / 4u, blue = colour[2] / 8u;
        return (red * 8u + red / 4u) << 16 | (green * 4u + green / 16u) << 8 | (blue * 8u + blue / 4u);
    }
    return level_of(colour, pixels.format == &fxl_pixels_grey4 ? 15 : 1, x, y);
}

/* A colour of RGB565 as three bytes: 255 c / most of each channel, rounded to nearest. */
static void bytes_of(uint32_t colour, uint8_t *bytes)
{
    const uint32_t red = colour / 2048u, green = colour / 32u % 64u, blue = colour % 32u;
    bytes[0] = (uint8_t)((510u * red + 31u) / 62u);
    bytes[1] = (uint8_t)((510u * green + 63u) / 126u);
    bytes[2] = (uint8_t)((510u * blue + 31u) / 62u);
}

/* The three bytes that a pixel of the band stands for. */
static void colour_at(const fxl_band *band, uint32_t place, uint8_t *bytes)
{
    if (band->palette != NULL) {
        bytes_of(((const uint16_t *)(const void *)band->pixels)[place], bytes);
    } else {
        memcpy(bytes, &palette[3u * band->pixels[place]], 3);
    }
}

static void assert_converted(const fxl_band *band)
{
    const size_t size = fxl_pixels_size(pixels.format, band->width, band->rows);
    TEST_ASSERT_LESS_OR_EQUAL(sizeof out_words, size);
    memset(out, GUARD, sizeof out_words);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_convert(&pixels, band, out, size));
    for (uint32_t row = 0; row < band->rows; row++) {
        for (uint32_t x = 0; x < band->width; x++) {
            uint8_t colour[3];
            colour_at(band, row * band->stride + x, colour);
            TEST_ASSERT_EQUAL_HEX(expected(colour, x, band->first_row + row), got(band, x, row));
        }
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(GUARD, out + size, sizeof out_words - size);
}

/* The last byte of a row is filled up with zeros, also after seven ones. */
/* pixels 1.1a */
void test_seven_white_pixels(void)
{
    static const uint8_t white[3] = {255, 255, 255};
    uint8_t row[7] = {9, 9, 9, 9, 9, 9, 9};
    memcpy(&palette[3 * 9], white, sizeof white);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, &fxl_pixels_mono_rows, palette));
    for (uint16_t width = 1; width <= 7; width++) {
        const fxl_band band = UNIT_BAND(row, width, 0, 1);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_convert(&pixels, &band, out, 1));
        TEST_ASSERT_EQUAL_HEX8(0xFF00u >> width & 0xFFu, out[0]);
    }
}

/* pixels 1.1a, 1.1c, 1.5b */
void test_every_width_at_every_place_of_a_word(void)
{
    for (uint32_t f = 0; f < sizeof formats / sizeof formats[0]; f++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, formats[f], palette));
        for (uint32_t width = 1; width <= WIDEST; width++) {
            const uint32_t offset = width % 4u, stride = width + width / 4u % 4u;
            const fxl_band band = {.pixels = frame + offset, .width = (uint16_t)width,
                                   .stride = (uint16_t)stride,
                                   .first_row = (uint16_t)(width % 5u * 8u), .rows = (uint16_t)(1u + width % ROWS)};
            any_frame();
            assert_converted(&band);
        }
    }
}

/* pixels 1.2e, 1.2g-h, 1.2j */
void test_every_width_of_rgb565_at_every_place_of_a_word(void)
{
    for (uint32_t f = 0; f < sizeof formats / sizeof formats[0]; f++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, formats[f], palette));
        memset(pixels.entries, 0, sizeof pixels.entries); /* nothing of the palette is asked for */
        for (uint32_t width = 1; width <= WIDEST; width++) {
            const uint32_t offset = width % 2u, stride = width + width / 4u % 4u;
            const fxl_band band = {.pixels = (uint8_t *)(frame_565 + offset),
                                   .width = (uint16_t)width, .stride = (uint16_t)stride,
                                   .first_row = (uint16_t)(width % 5u * 8u),
                                   .rows = (uint16_t)(1u + width % ROWS), .palette = colours};
            for (uint32_t i = 0; i < sizeof frame_565 / 2u; i++) {
                frame_565[i] = (uint16_t)(unit_random() >> 7);
            }
            assert_converted(&band);
        }
    }
}

/* Some columns: those of the band of all of them, the dither too. */
/* formats 4.4, pixels 1.3c */
void test_some_columns(void)
{
    for (uint32_t f = 0; f < sizeof formats / sizeof formats[0]; f++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, formats[f], palette));
        for (uint32_t k = 0; k < 40; k++) {
            fxl_band band = {.pixels = frame, .width = 60, .stride = 60, .first_row = 8, .rows = 9};
            const uint16_t first = (uint16_t)unit_between(0, 59);
            const uint16_t columns = (uint16_t)unit_between(1, 60 - first);
            uint32_t all[60];
            any_frame();
            TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_convert(&pixels, &band, out, sizeof out_words));
            for (uint32_t x = 0; x < columns; x++) {
                all[x] = got(&band, first + x, 2);
            }
            band.first_column = first;
            band.columns = columns;
            band.pixels = frame + first;
            TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_convert(&pixels, &band, out, sizeof out_words));
            const fxl_band seen = {.width = columns};
            for (uint32_t x = 0; x < columns; x++) {
                TEST_ASSERT_EQUAL_HEX(all[x], got(&seen, x, 2));
            }
            band.columns = (uint16_t)(61 - first);
            TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pixels_convert(&pixels, &band, out, sizeof out_words));
        }
    }
}

/* Every colour has the entry that a palette with its three bytes has. */
/* pixels 1.2i */
void test_greys_of_rgb565(void)
{
    static const uint32_t highests[] = {1, 15, 254, 255};
    for (uint32_t k = 0; k < 4; k++) {
        const uint32_t highest = highests[k];
        uint8_t bytes[768];
        uint16_t table[256];
        for (uint32_t upper = 0; upper < 256; upper++) {
            for (uint32_t i = 0; i < 256; i++) {
                bytes_of(upper << 8 | i, &bytes[3u * i]);
            }
            fxl_grey_table(table, bytes, highest);
            for (uint32_t i = 0; i < 256; i++) {
                TEST_ASSERT_EQUAL(table[i], fxl_grey_of_rgb565((uint16_t)(upper << 8 | i), highest));
            }
        }
        TEST_ASSERT_EQUAL(0, fxl_grey_of_rgb565(0, highest));
        TEST_ASSERT_EQUAL(128u * highest, fxl_grey_of_rgb565(0xFFFF, highest));
    }
}

/* Rows that are one run, and rows in which one pixel is another: at each place of a block. */
/* pixels 1.5b */
void test_a_pixel_within_a_run(void)
{
    const fxl_band band = {.pixels = frame, .width = 48, .stride = 48, .first_row = 0, .rows = 1};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, &fxl_pixels_rgb565, palette));
    for (uint32_t at = 0; at <= 48; at++) {
        memset(frame, 7, 48);
        if (at < 48) {
            frame[at] = 9;
        }
        assert_converted(&band);
    }
    for (uint32_t i = 0; i < 48; i++) { /* equal words, which are no run */
        frame[i] = (uint8_t)(i % 4u);
    }
    assert_converted(&band);
}

/* pixels 1.2a, 1.2c */
void test_bits_that_no_pixel_has_are_zero(void)
{
    const fxl_band band = {.pixels = frame, .width = 5, .stride = 5, .first_row = 0, .rows = 2};
    memset(palette, 255, sizeof palette);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, &fxl_pixels_grey4, palette));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_convert(&pixels, &band, out, 6));
    TEST_ASSERT_EQUAL_HEX8(0xF0, out[2]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, &fxl_pixels_mono_rows, palette));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_convert(&pixels, &band, out, 2));
    TEST_ASSERT_EQUAL_HEX8(0xF8, out[1]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, &fxl_pixels_mono_pages, palette));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_convert(&pixels, &band, out, 5));
    TEST_ASSERT_EACH_EQUAL_HEX8(0x03, out, 5);
}

/* pixels 1.2b, 1.2d */
void test_sizes(void)
{
    static const size_t sizes[] = {340, 340, 170, 510, 90, 30, 34};
    for (uint32_t f = 0; f < sizeof formats / sizeof formats[0]; f++) {
        TEST_ASSERT_EQUAL(sizes[f], fxl_pixels_size(formats[f], 17, 10));
    }
}

/* pixels 1.2b */
void test_what_is_refused_changes_nothing(void)
{
    fxl_band band = {.pixels = frame, .width = 8, .stride = 8, .first_row = 0, .rows = 8};
    memset(&pixels, GUARD, sizeof pixels);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_init(NULL, &fxl_pixels_rgb565, palette));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_init(&pixels, NULL, palette));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_init(&pixels, &fxl_pixels_rgb565, NULL));
    static const fxl_pixel_format zeros;
    static const fxl_pixels unprepared;
    fxl_pixel_format part = fxl_pixels_rgb565;
    part.convert = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_init(&pixels, &part, palette));
    part = fxl_pixels_rgb565;
    part.rows = 0;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_init(&pixels, &part, palette));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_init(&pixels, &zeros, palette));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pixels_convert(&unprepared, &band, out, 64));
    TEST_ASSERT_EQUAL(0, fxl_pixels_size(&zeros, 17, 10));
    TEST_ASSERT_EQUAL(0, fxl_pixels_size(NULL, 17, 10));
    TEST_ASSERT_EACH_EQUAL_HEX8(GUARD, &pixels, sizeof pixels);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, &fxl_pixels_mono_pages, palette));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_convert(NULL, &band, out, 64));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_convert(&pixels, NULL, out, 64));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_convert(&pixels, &band, NULL, 64));
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_pixels_convert(&pixels, &band, out + 2, 64));
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_pixels_convert(&pixels, &band, out, 7));
    band.palette = colours;
    band.pixels++;
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_pixels_convert(&pixels, &band, out, 64));
    band.palette = NULL;
    band.pixels--;
    band.first_row = 4;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pixels_convert(&pixels, &band, out, 64));
    band.first_row = 8;
    band.stride = 7;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pixels_convert(&pixels, &band, out, 64));
    band.stride = 8;
    band.rows = 0;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_convert(&pixels, &band, out, 64));
    band.rows = 8;
    band.width = 0;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_convert(&pixels, &band, out, 64));
    band.width = 8;
    band.pixels = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pixels_convert(&pixels, &band, out, 64));
    TEST_ASSERT_EACH_EQUAL_HEX8(GUARD, out, sizeof out_words);
}

/* A frame in bands that begin at any row, or, of pages of 8 rows, at any page. */
/* formats 4.4, pixels 1.3a-b */
void test_bands_of_any_rows(void)
{
    uint32_t cut = 0;
    for (uint32_t f = 0; f < sizeof formats / sizeof formats[0]; f++) {
        const uint16_t unit = formats[f] == &fxl_pixels_mono_pages ? 8 : 1;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&pixels, formats[f], palette));
        any_frame();
        for (uint16_t first = 0; first < ROWS; first = (uint16_t)(first + unit)) {
            const fxl_band band = UNIT_BAND(frame, 37, first, (uint16_t)(ROWS - first));
            assert_converted(&band);
            cut += first % 8u != 0;
        }
    }
    TEST_ASSERT_GREATER_THAN(20, cut);
}
