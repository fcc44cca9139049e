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

/* For fxl_fill_band: the rows lie within the cells of the band. */
static void any_fill_band(const fxl_band *band, uint8_t colour)
{
    (void)colour;
    ASSERT("cells of the band", band->rows >= 1 && band->pixels >= (const uint8_t *)memory.cells &&
                                    band->pixels + ((band->rows - 1u) * band->stride + band->width) <= end_of_cells);
}

#define fxl_fill_band any_fill_band
#include "draw/depth.c"

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
 * checks = 166
 * stubs = { fxl_fill_band = "asserts that all lies within the cells of the band" }
 */
void prove_depth_clear(void)
{
    fxl_workspace workspace;
    const uint32_t cell_bytes = nondet_bool() ? 2 : 4;
    const fxl_band band = any_band(cell_bytes);
    const int32_t first = nondet_s32(), end = nondet_s32();
    workspace.target_memory = (uint8_t *)&memory;
    ANY_CONTENT(&memory);
    ASSUME(is_range(&band));
    fxl_depth_clear(&workspace, &band, first, end, cell_bytes);
    ASSERT("still rows of the band", is_range(&band));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/depth.c:fxl_depth_clear_all"
 * property = "from any state: nothing but cells of the band is cleared, and all are clear; bands of up to 4 rows of 4 cells"
 * checks = 179
 * stubs = { fxl_fill_band = "asserts that all lies within the cells of the band" }
 */
void prove_depth_clear_all(void)
{
    fxl_workspace workspace;
    const uint32_t cell_bytes = nondet_bool() ? 2 : 4;
    const fxl_band band = any_band(cell_bytes);
    workspace.target_memory = (uint8_t *)&memory;
    ANY_CONTENT(&memory);
    ASSUME(is_range(&band));
    fxl_depth_clear_all(&workspace, &band, cell_bytes);
    ASSERT("all are clear", memory.head.clear_from == FXL_DEPTH_ALL_CLEAR);
    PROOF_ENDS();
}
