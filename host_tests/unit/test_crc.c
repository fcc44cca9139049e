/* SPDX-License-Identifier: MIT */
/* CRC-32 of bytes and of the pixels of bands: against the check value of its definition, and
 * against a CRC that is computed bit by bit. */
#include "fixel/crc.h"

#include "unit.h"

#define WIDTH  21u
#define HEIGHT 19u
#define STRIDE 26u
#define GUARD  7u

static uint8_t bytes_drawn[HEIGHT * STRIDE];
static uint16_t colours_drawn[HEIGHT * STRIDE];
static uint8_t packed[2u * HEIGHT * WIDTH];
static const uint16_t colours[256];

void setUp(void)
{
    for (uint32_t i = 0; i < HEIGHT * STRIDE; i++) {
        bytes_drawn[i] = (uint8_t)(unit_random() >> 9);
        colours_drawn[i] = (uint16_t)(unit_random() >> 9);
    }
}

static fxl_band band_of(bool is_rgb565, uint16_t first_row, uint16_t rows)
{
    const fxl_band band = {.pixels = is_rgb565
                                         ? (uint8_t *)(void *)(colours_drawn + first_row * STRIDE)
                                         : bytes_drawn + first_row * STRIDE,
                           .width = WIDTH,
                           .stride = STRIDE,
                           .first_row = first_row,
                           .rows = rows,
                           .palette = is_rgb565 ? colours : NULL};
    return band;
}

/* The pixels of a rectangle as bytes, rows downward, the high byte of a colour first. */
static uint32_t expected(bool is_rgb565, uint32_t left, uint32_t top, uint32_t width,
                         uint32_t height)
{
    uint32_t count = 0;
    for (uint32_t y = top; y < top + height; y++) {
        for (uint32_t x = left; x < left + width; x++) {
            if (is_rgb565) {
                packed[count++] = (uint8_t)(colours_drawn[y * STRIDE + x] >> 8);
                packed[count++] = (uint8_t)(colours_drawn[y * STRIDE + x] & 255u);
            } else {
                packed[count++] = bytes_drawn[y * STRIDE + x];
            }
        }
    }
    return unit_crc32(packed, count);
}

void test_the_check_value_of_the_definition(void)
{
    TEST_ASSERT_EQUAL_HEX32(0xCBF43926u, fxl_crc(FXL_CRC_START, "123456789", 9));
}

void test_no_bytes_change_nothing(void)
{
    TEST_ASSERT_EQUAL_HEX32(FXL_CRC_START, fxl_crc(FXL_CRC_START, NULL, 0));
    TEST_ASSERT_EQUAL_HEX32(0x12345678u, fxl_crc(0x12345678u, NULL, 0));
}

void test_bytes_may_come_in_parts(void)
{
    for (uint32_t size = 0; size <= 64; size++) {
        const uint32_t whole = unit_crc32(bytes_drawn, size);
        TEST_ASSERT_EQUAL_HEX32(whole, fxl_crc(FXL_CRC_START, bytes_drawn, size));
        for (uint32_t cut = 0; cut <= size; cut++) {
            const uint32_t first = fxl_crc(FXL_CRC_START, bytes_drawn, cut);
            TEST_ASSERT_EQUAL_HEX32(whole, fxl_crc(first, bytes_drawn + cut, size - cut));
        }
    }
}

void test_a_band_is_its_pixels_without_the_stride(void)
{
    for (uint32_t format = 0; format < 2; format++) {
        const fxl_band band = band_of(format == 1, 0, HEIGHT);
        uint32_t crc = FXL_CRC_START;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_band_crc(&crc, &band));
        TEST_ASSERT_EQUAL_HEX32(expected(format == 1, 0, 0, WIDTH, HEIGHT), crc);
    }
}

void test_bands_of_any_height_give_the_crc_of_the_frame(void)
{
    for (uint32_t format = 0; format < 2; format++) {
        const uint32_t whole = expected(format == 1, 0, 0, WIDTH, HEIGHT);
        for (uint16_t rows = 1; rows <= HEIGHT; rows++) {
            uint32_t crc = FXL_CRC_START;
            for (uint16_t row = 0; row < HEIGHT; row = (uint16_t)(row + rows)) {
                const uint16_t left = (uint16_t)(HEIGHT - row);
                const fxl_band band = band_of(format == 1, row, rows < left ? rows : left);
                TEST_ASSERT_EQUAL(FXL_OK, fxl_band_crc(&crc, &band));
            }
            TEST_ASSERT_EQUAL_HEX32(whole, crc);
        }
    }
}

void test_a_band_of_some_columns(void)
{
    for (uint32_t format = 0; format < 2; format++) {
        for (uint16_t columns = 1; columns + 3u <= WIDTH; columns++) {
            fxl_band band = band_of(format == 1, 2, 5);
            uint32_t crc = FXL_CRC_START;
            band.first_column = 3;
            band.columns = columns;
            /* The first pixel is that of the first column. */
            TEST_ASSERT_EQUAL(FXL_OK, fxl_band_crc(&crc, &band));
            TEST_ASSERT_EQUAL_HEX32(expected(format == 1, 0, 2, columns, 5), crc);
        }
    }
}

void test_a_pixel_more_or_less_is_another_number(void)
{
    const fxl_band band = band_of(false, 0, HEIGHT);
    uint32_t before = FXL_CRC_START, after = FXL_CRC_START;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_band_crc(&before, &band));
    bytes_drawn[7 * STRIDE + WIDTH] ^= 1u; /* between two rows */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_band_crc(&after, &band));
    TEST_ASSERT_EQUAL_HEX32(before, after);
    bytes_drawn[7 * STRIDE + WIDTH - 1u] ^= 1u; /* the last pixel of a row */
    after = FXL_CRC_START;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_band_crc(&after, &band));
    TEST_ASSERT_NOT_EQUAL(before, after);
}

static void refused(fxl_status status, const fxl_band *band)
{
    uint32_t crc = GUARD;
    TEST_ASSERT_EQUAL(status, fxl_band_crc(&crc, band));
    TEST_ASSERT_EQUAL_HEX32(GUARD, crc);
}

void test_wrong_bands_are_refused(void)
{
    fxl_band band = band_of(false, 0, HEIGHT);
    refused(FXL_E_ARGUMENT, NULL);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_band_crc(NULL, &band));
    band.pixels = NULL;
    refused(FXL_E_ARGUMENT, &band);
    band = band_of(false, 0, 0);
    refused(FXL_E_RANGE, &band);
    band = band_of(false, 0, HEIGHT);
    band.stride = WIDTH - 1u;
    refused(FXL_E_RANGE, &band);
    band = band_of(false, 0, HEIGHT);
    band.first_column = 2;
    band.columns = WIDTH - 1u;
    refused(FXL_E_RANGE, &band);
    band = band_of(true, 0, HEIGHT);
    band.pixels++;
    refused(FXL_E_ALIGNMENT, &band);
}
