/* SPDX-License-Identifier: MIT */
#include "raster/fill.h"
#include "proof.h"

#define ROWS   3
#define STRIDE 16

static uint8_t memory[2 * ROWS * STRIDE + 4];
static const uint8_t *lowest, *highest; /* of the band's pixels */

/* For fxl_fill_row, which writes what lies between: any bytes of the band. */
static void any_fill_row(uint8_t *pixel, uint8_t *end, uint32_t four)
{
    (void)four;
    ASSERT("pixels of the band", pixel >= lowest && pixel <= end && end <= highest);
}

#define fxl_fill_row any_fill_row
#include "raster/fill.c"
#include "raster/fill_rgb565.c"

/* A band of few rows anywhere on the screen, at any address. */
static fxl_band any_band(uint32_t bytes_a_pixel)
{
    fxl_band band;
    const uint32_t before = nondet_u8() & 3u & -bytes_a_pixel;
    ASSUME(band.width >= 1 && band.width <= STRIDE && band.stride == STRIDE);
    ASSUME(band.rows >= 1 && band.rows <= ROWS && band.first_row + band.rows <= FXL_SCREEN_MAX);
    ASSUME(band.first_column == 0 && band.columns == 0);
    band.palette = NULL;
    band.pixels = memory + before;
    lowest = band.pixels;
    highest = band.pixels + bytes_a_pixel * STRIDE * band.rows;
    return band;
}

/* A trapezoid of the band, both of whose edges lie within the band on each of its rows. */
static fxl_trapezoid any_trapezoid(const fxl_band *band)
{
    fxl_trapezoid trapezoid;
    ASSUME(trapezoid.first_row >= band->first_row && trapezoid.first_row < trapezoid.end_row &&
           trapezoid.end_row <= band->first_row + band->rows);
    for (int side = 0; side < 2; side++) {
        fxl_edge edge = trapezoid.edges[side];
        ASSUME(WITHIN(edge.step, 1 << 20));
        for (int32_t row = 0; row < ROWS; row++) {
            ASSUME(trapezoid.first_row + row >= trapezoid.end_row || (edge.x >= 0 && edge.x <= band->width));
            fxl_edge_step(&edge);
        }
    }
    return trapezoid;
}

/* [[row]]
 * function = "lib/raster/fill.c:fxl_fill_trapezoid"
 * property = "any edges that lie within the band on each row: nothing but the band is filled; bands of up to 3 rows of up to 16 pixels at any address"
 * checks = 235
 * unwind = 4
 * stubs = { fxl_fill_row = "fills any bytes of the band: its own text is within the row of fxl_fill_row_rgb565" }
 */
void prove_fill_trapezoid(void)
{
    const fxl_band band = any_band(1);
    const fxl_trapezoid trapezoid = any_trapezoid(&band);
    fxl_fill_trapezoid(&band, &trapezoid, nondet_u8());
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/fill_rgb565.c:fxl_fill_trapezoid_rgb565"
 * property = "any edges that lie within the band on each row: nothing but the band is filled; bands of up to 3 rows of up to 16 pixels at any even address"
 * checks = 286
 * unwind = 4
 * stubs = { fxl_fill_row = "fills any bytes of the band: its own text is within the row of fxl_fill_row_rgb565" }
 */
void prove_fill_trapezoid_rgb565(void)
{
    const fxl_band band = any_band(2);
    const fxl_trapezoid trapezoid = any_trapezoid(&band);
    fxl_fill_trapezoid_rgb565(&band, &trapezoid, nondet_u16());
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/fill.c:fxl_fill_span"
 * property = "any span of the band: nothing else is filled; bands of up to 3 rows of up to 16 pixels at any address"
 * checks = 313
 * unwind = 4
 * stubs = { fxl_fill_row = "fills any bytes of the band: its own text is within the row of fxl_fill_row_rgb565" }
 */
void prove_fill_span(void)
{
    const fxl_band band = any_band(1);
    fxl_span span;
    ASSUME(span.y >= band.first_row && span.y < band.first_row + band.rows);
    ASSUME(span.x0 >= 0 && span.x0 < span.x1 && span.x1 <= band.width);
    fxl_fill_span(&band, &span, nondet_u8());
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/fill.c:fxl_fill_band"
 * property = "nothing but the band is filled; bands of up to 3 rows of up to 16 pixels at any address"
 * checks = 267
 * unwind = 4
 * stubs = { fxl_fill_row = "fills any bytes of the band: its own text is within the row of fxl_fill_row_rgb565" }
 */
void prove_fill_band(void)
{
    const fxl_band band = any_band(1);
    fxl_fill_band(&band, nondet_u8());
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/fill_rgb565.c:fxl_fill_band_rgb565"
 * property = "nothing but the band is filled; bands of up to 3 rows of up to 16 pixels at any even address"
 * checks = 372
 * unwind = 4
 * stubs = { fxl_fill_row = "fills any bytes of the band: its own text is within the row of fxl_fill_row_rgb565" }
 */
void prove_fill_band_rgb565(void)
{
    fxl_band band = any_band(2);
    static const uint16_t palette[256];
    band.palette = palette;
    fxl_fill_band_rgb565(NULL, &band, nondet_u8());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_edge_step"
 * property = "nothing overflows; by the step or one pixel more"
 * checks = 37
 */
void prove_edge_step(void)
{
    fxl_edge edge;
    ASSUME(WITHIN(edge.x, 1 << 29) && WITHIN(edge.step, 1 << 29));
    const int32_t x = edge.x;
    fxl_edge_step(&edge);
    ASSERT("by the step or one more", edge.x == x + edge.step || edge.x == x + edge.step + 1);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_edge_step"
 * id = "fxl_edge_step, its result"
 * property = "x and fraction, as one number of 64 bits, are larger by the step"
 * checks = 41
 */
void prove_edge_step_result(void)
{
    fxl_edge edge;
    ASSUME(WITHIN(edge.x, 1 << 29) && WITHIN(edge.step, 1 << 29));
    const fxl_edge before = edge;
    fxl_edge_step(&edge);
    ASSERT("the sum", edge.x * ((int64_t)1 << 32) + edge.fraction ==
                          (before.x + (int64_t)before.step) * ((int64_t)1 << 32) + before.fraction + before.step_fraction);
    ASSERT("the step stays", edge.step == before.step && edge.step_fraction == before.step_fraction);
    PROOF_ENDS();
}
