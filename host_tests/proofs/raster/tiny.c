/* SPDX-License-Identifier: MIT */
#include "raster/tiny.c"
#include "proof.h"

/* [[row]]
 * function = "edge_at"
 * property = "below 2^23 for points and centres less than 4 pixels apart"
 * checks = 112
 * contract = true
 */
void prove_edge_at(void)
{
    fxl_screen_point a, b;
    (void)edge_at(&a, &b, nondet_s32(), nondet_s32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "cover"
 * property = "any small box: nothing overflows, and 4 pixels"
 * checks = 555
 * contract = true
 * uses = ["edge_at"]
 */
void prove_cover(void)
{
    fxl_screen_point a, b, c;
    tiny_box box;
    (void)cover(&a, &b, &c, &box);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_tiny_find"
 * property = "any triangle and band: nothing overflows, and the pixels found begin in the band and are 4"
 * checks = 754
 * uses = ["edge_at", "cover"]
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
        ASSERT("4 pixels", tiny.pixels >> 4 == 0);
    }
    PROOF_ENDS();
}
