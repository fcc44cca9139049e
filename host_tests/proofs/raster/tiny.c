/* SPDX-License-Identifier: MIT */
#include "raster/tiny.c"
#include "proof.h"

/* [[row]]
 * function = "lib/raster/scan.h:fxl_tiny_edge"
 * property = "below 2^24 for points less than 9 pixels from a centre"
 * checks = 103
 * contract = true
 */
void prove_edge(void)
{
    fxl_screen_point a, b;
    (void)fxl_tiny_edge(&a, &b);
    PROOF_ENDS();
}

/* Points less than 9 pixels apart, and a box of centres between them. */
static void any_box(fxl_screen_point *points, fxl_tiny *tiny)
{
    ASSUME(tiny->rows >= 1 && tiny->rows <= FXL_TINY_LONGEST && tiny->columns >= 1 && tiny->columns <= FXL_TINY_LONGEST &&
           tiny->rows * tiny->columns <= FXL_TINY_CENTRES && WITHIN(tiny->row, FXL_SCREEN_MAX) && WITHIN(tiny->column, FXL_SCREEN_MAX));
    for (int i = 0; i < 3; i++) {
        ASSUME(WITHIN(points[i].x, FXL_SCREEN_COORDINATE_MAX) && WITHIN(points[i].y, FXL_SCREEN_COORDINATE_MAX));
        ASSUME(WITHIN(points[i].x - (int64_t)fxl_centre_of(tiny->column), 9 * 65536 - 1) && WITHIN(points[i].y - (int64_t)fxl_centre_of(tiny->row), 9 * 65536 - 1));
        ASSUME(WITHIN(points[i].x - (int64_t)points[(i + 1) % 3].x, 9 * 65536 - 1) && WITHIN(points[i].y - (int64_t)points[(i + 1) % 3].y, 9 * 65536 - 1));
    }
}

/* [[row]]
 * function = "lib/raster/scan.h:fxl_tiny_cover"
 * property = "any box of up to 32 centres: nothing overflows, and no pixel beyond them"
 * checks = 520
 * unwind = 9
 * uses = ["fxl_tiny_edge"]
 */
void prove_cover(void)
{
    fxl_screen_point points[3];
    fxl_tiny tiny;
    any_box(points, &tiny);
    if (fxl_tiny_cover(points, &tiny) && tiny.rows * tiny.columns < 32) {
        ASSERT("no pixel beyond", tiny.pixels << (tiny.rows * tiny.columns) == 0);
    }
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/scan.h:fxl_tiny_fits"
 * property = "any box and band: nothing overflows, and what fits has rows of the band and centres for a word"
 * checks = 70
 */
void prove_fits(void)
{
    fxl_tiny box;
    fxl_band band;
    ASSUME(box.row >= 0 && box.row <= FXL_SCREEN_MAX && box.rows >= 1 && box.rows <= FXL_SCREEN_MAX);
    ASSUME(box.columns >= 0 && box.columns <= FXL_SCREEN_MAX && band.first_row + band.rows <= FXL_SCREEN_MAX);
    if (fxl_tiny_fits(&box, &band)) {
        ASSERT("rows of the band", box.row >= band.first_row && box.row + box.rows <= band.first_row + band.rows);
        ASSERT("centres for a word", box.columns >= 1 && box.columns * box.rows <= 32);
    }
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_tiny_find"
 * property = "any triangle and band: nothing overflows, and the pixels found begin in the band and are 4"
 * checks = 441
 * uses = ["fxl_tiny_edge"]
 */
void prove_tiny_find(void)
{
    fxl_screen_point points[3];
    fxl_band band;
    fxl_tiny tiny;
    for (int i = 0; i < 3; i++) {
        ASSUME(WITHIN(points[i].x, FXL_SCREEN_COORDINATE_MAX) && WITHIN(points[i].y, FXL_SCREEN_COORDINATE_MAX));
    }
    ASSUME(band.width >= 1 && band.width <= FXL_SCREEN_MAX && band.rows >= 1 && band.first_row + band.rows <= FXL_SCREEN_MAX &&
           fxl_band_end_column(&band) <= band.width);
    if (fxl_tiny_find(points, &band, &tiny) && tiny.pixels != 0) {
        ASSERT("in the band", tiny.row >= band.first_row && tiny.row < band.first_row + band.rows && tiny.column >= band.first_column &&
                                  tiny.column < (int32_t)fxl_band_end_column(&band));
        ASSERT("4 pixels", tiny.pixels << 4 == 0);
    }
    PROOF_ENDS();
}
