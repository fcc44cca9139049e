/* SPDX-License-Identifier: MIT */
/* The kernels of the depth test. Each side keeps codes in cells of its own, all of which must be
 * equal. */

#include "equality.h"
#include "paint/depth_cells.h"
#include "sides.h"

#define COUNT_MAX 40u
#define GAP       4u /* cells before and after, which no side may write */

static uint16_t by_core[COUNT_MAX + 2 * GAP], by_portable[COUNT_MAX + 2 * GAP];

/* The cells from `from` on are nearer than the line, or farther, by less than 2^spread. The cell of
 * `turn` is on the other side, or as near as the line. */
static void choose_cells(uint32_t code, uint32_t step, uint32_t turn, uint32_t spread,
                         bool are_hidden)
{
    for (uint32_t i = 0; i < COUNT_MAX + 2 * GAP; i++) {
        const uint32_t near = (code + (i - GAP) * step) >> 16;
        const uint32_t off = (any_32() >> 5) % (1u << spread);
        const bool is_hidden = are_hidden != (i == turn + GAP);
        const uint32_t cell = is_hidden ? near + off : near - 1u - off;
        by_core[i] = by_portable[i] = (uint16_t)cell;
    }
}

static void compare(uint32_t count, uint32_t code, uint32_t step)
{
    bool same = fxl_depth_skip_hidden(by_core + GAP, count, code, step) ==
                portable_depth_skip_hidden(by_portable + GAP, count, code, step);
    same &= fxl_depth_keep_visible(by_core + GAP, count, code, step) ==
            portable_depth_keep_visible(by_portable + GAP, count, code, step);
    for (uint32_t i = 0; i < COUNT_MAX + 2 * GAP; i++) {
        same &= by_core[i] == by_portable[i];
    }
    equality_case(same);
}

/* Every length, with a pixel of the other kind at every place, and with none. */
static void boundaries(void)
{
    for (uint32_t count = 0; count <= COUNT_MAX; count++) {
        for (uint32_t turn = 0; turn <= count; turn++) {
            const uint32_t code = 0x40000000u + (any_32() >> 4), step = (any_32() >> 8) - 0x800000u;
            choose_cells(code, step, turn, 1, (turn & 1u) != 0);
            compare(count, code, step);
        }
    }
}

/* Cells of which nothing is drawn, or all but one. The codes may be near the least. */
static void empty_cells(void)
{
    for (uint32_t count = 0; count <= COUNT_MAX; count++) {
        for (uint32_t turn = 0; turn <= count; turn++) {
            const uint32_t code = 65536u + ((any_32() >> 4) >> (any_32() >> 9 & 31u)) - 3u;
            const uint32_t most = code / COUNT_MAX; /* no code is below 0 */
            const uint32_t step = (any_32() >> 9) % (2 * most) - most;
            for (uint32_t i = 0; i < COUNT_MAX + 2 * GAP; i++) {
                by_core[i] = by_portable[i] = 0;
            }
            by_core[turn + GAP] = by_portable[turn + GAP] =
                (uint16_t)(any_32() >> (any_32() >> 27));
            compare(count, code, step);
        }
    }
}

void test_depth_rows(uint32_t rounds)
{
    boundaries();
    empty_cells();
    for (uint32_t i = 0; i < rounds; i++) {
        const uint32_t code = any_32(), step = any_32() >> ((any_32() >> 9) & 31u);
        choose_cells(code, step, (any_32() >> 7) % COUNT_MAX, (any_32() >> 6) % 16u,
                     (any_32() >> 8 & 1u) != 0);
        compare((any_32() >> 5) % (COUNT_MAX + 1u), code, step);
    }
}
