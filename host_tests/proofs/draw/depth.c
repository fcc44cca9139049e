/* SPDX-License-Identifier: MIT */
#include "draw/submit.h"
#include "draw/surface_polygon.h"
#include "paint/depth_row.h"
#include "proof.h"

#define WIDTH 4
#define ROWS  4

static struct {
    fxl_depth_head head;
    uint32_t cells[ROWS * WIDTH];
} memory;
static const uint8_t *end_of_cells;

static uint32_t pixel_bytes;

/* For fxl_target.fill: the rows lie within the cells of the band, and the colour makes a code of 0. */
static void any_fill(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour)
{
    (void)renderer;
    ASSERT("cells of the band", band->rows >= 1 && band->pixels >= (const uint8_t *)memory.cells &&
                                    band->pixels + ((band->rows - 1u) * band->stride + band->width) * pixel_bytes <= end_of_cells);
    ASSERT("a code of 0", pixel_bytes == 1 ? colour == 0 : band->palette[colour] == 0);
}

#include "draw/depth.c"

static fxl_target any_target(void)
{
    fxl_target target;
    target.pixel_bits = nondet_bool() ? 8 : 16;
    target.depth_bits = nondet_bool() ? 16 : 32;
    target.fill = any_fill;
    pixel_bytes = target.pixel_bits / 8;
    return target;
}

static fxl_band any_band(uint32_t cell_bytes)
{
    fxl_band band;
    ASSUME(band.width == WIDTH && band.rows >= 1 && band.rows <= ROWS && band.first_row + band.rows <= FXL_SCREEN_MAX);
    end_of_cells = (const uint8_t *)memory.cells + band.rows * WIDTH * cell_bytes;
    return band;
}

/* Cleared are rows of the band, or all, or none yet. */
static bool is_range(const fxl_band *band)
{
    const int32_t from = memory.head.clear_from, to = memory.head.clear_to;
    return from == FXL_DEPTH_ALL_CLEAR || (from <= to && from >= band->first_row && to <= band->first_row + band->rows);
}

/* [[row]]
 * function = "lib/draw/depth.c:fxl_depth_clear"
 * property = "any rows: nothing but cells of the band is cleared, and the rows that are clear stay rows of the band; bands of up to 4 rows of 4 cells"
 * checks = 229
 * stubs = { any_fill = "asserts that all lies within the cells of the band" }
 */
void prove_depth_clear(void)
{
    fxl_workspace workspace;
    const fxl_target target = any_target();
    const fxl_band band = any_band(target.depth_bits / 8);
    const int32_t first = nondet_s32(), end = nondet_s32();
    workspace.target_memory = (uint8_t *)&memory;
    ANY_CONTENT(&memory);
    ASSUME(is_range(&band));
    fxl_depth_clear(&workspace, &band, first, end, &target);
    ASSERT("still rows of the band", is_range(&band));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/depth.c:fxl_depth_clear_all"
 * property = "from any state: nothing but cells of the band is cleared, and all are clear; bands of up to 4 rows of 4 cells"
 * checks = 242
 * stubs = { any_fill = "asserts that all lies within the cells of the band" }
 */
void prove_depth_clear_all(void)
{
    fxl_workspace workspace;
    const fxl_target target = any_target();
    const fxl_band band = any_band(target.depth_bits / 8);
    workspace.target_memory = (uint8_t *)&memory;
    ANY_CONTENT(&memory);
    ASSUME(is_range(&band));
    fxl_depth_clear_all(&workspace, &band, &target);
    ASSERT("all are clear", memory.head.clear_from == FXL_DEPTH_ALL_CLEAR);
    PROOF_ENDS();
}
