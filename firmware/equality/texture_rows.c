/* SPDX-License-Identifier: MIT */
/* The kernels that paint rows of a textured face. Each side writes into memory of its own, all of
 * which must be equal. */

#include <string.h>

#include "equality.h"
#include "paint/depth_rows.h"
#include "paint/plain_rows.h"
#include "sides.h"

#define COLUMNS 96u
#define LEVELS  32u

#define ROWS 6u

#define FEW 4096u /* texels */

typedef void row_kernel(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                        int32_t x1);
typedef bool rows_kernel(fxl_plain_rows *rows);

/* Texels of 8 or of 16 bits. */
static FXL_ALIGN_8 uint8_t texels[2u * 65536u];
static FXL_ALIGN_8 uint8_t
    few_texels[2u * FEW]; /* half of the bytes and of the pairs are below 8 */
static uint8_t ramp[256u * LEVELS];
static uint16_t palette[256];
static FXL_ALIGN_8 uint8_t by_core[ROWS][2u * (COLUMNS + 32u)];
static FXL_ALIGN_8 uint8_t by_portable[ROWS][2u * (COLUMNS + 32u)];

/* A number below 2^30 and above -2^30, of any length. */
static int64_t any_value(void)
{
    const int64_t value = (int64_t)(any_64() >> 2 >> (any_32() >> 7) % 62u);
    return any_32() >> 9 & 1u ? value : -value;
}

static bool is_same(void)
{
    const bool same = equality_same_words(by_core, by_portable, sizeof by_core);
    memset(by_core, 0xA5, sizeof by_core);
    memset(by_portable, 0xA5, sizeof by_portable);
    return same;
}

static void compare_row(const fxl_segment_face *face, fxl_paint_row *row, int32_t x0, int32_t x1,
                        row_kernel *core, row_kernel *portable)
{
    row->pixels = by_core[1] + 32;
    core(face, row, x0, x1);
    row->pixels = by_portable[1] + 32;
    portable(face, row, x0, x1);
    equality_case(is_same());
}

static bool paint_rows(const fxl_plain_rows *rows, uint8_t pixels[ROWS][2u * (COLUMNS + 32u)],
                       rows_kernel *kernel, fxl_plain_rows *after)
{
    *after = *rows;
    after->row.pixels = pixels[0] + 32;
    const bool stopped = kernel(after);
    after->row.pixels -= (uintptr_t)pixels;
    return stopped;
}

/* Rows whose edges lie within the columns, from x0 and x1 on. */
static void compare_rows(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                         int32_t x1, rows_kernel *core, rows_kernel *portable)
{
    fxl_plain_rows rows, after[2];
    rows.row = *row;
    rows.row.segments = face;
    rows.row.y = (int32_t)(any_32() >> 25);
    rows.end_row = rows.row.y + 1 + (int32_t)((any_32() >> 5) % ROWS);
    rows.stride = (uint32_t)sizeof by_core[0];
    rows.downs[0] =
        (int64_t)(any_64() >> 10 >> (any_32() >> 7) % 30u) * (any_32() >> 9 & 1u ? 1 : -1);
    if (any_32() >> 30 == 0) {
        rows.downs[0] = 0; /* rows of one weight */
    }
    rows.downs[1] = any_value() >> 3;
    rows.downs[2] = any_value() >> 3;
    for (uint32_t i = 0; i < 2; i++) {
        fxl_edge *edge = &rows.edges[i];
        const int32_t x = i == any_32() >> 31 ? x0 : x1;
        edge->x = x;
        edge->step = x < 8 ? 0 : x > 80 ? -1 : (int32_t)((any_32() >> 7) % 3u) - 1;
        edge->step_fraction = any_32();
        edge->fraction = any_32();
    }
    const bool stopped = paint_rows(&rows, by_core, core, &after[0]);
    bool same = paint_rows(&rows, by_portable, portable, &after[1]) == stopped && is_same();
    same &= after[0].row.weight == after[1].row.weight && after[0].row.y == after[1].row.y &&
            after[0].row.pixels == after[1].row.pixels &&
            after[0].edges[0].x == after[1].edges[0].x &&
            after[0].edges[1].fraction == after[1].edges[1].fraction;
    equality_case(same);
}

#if FXL_HAS_DEPTH_ROWS

typedef bool runs_kernel(fxl_plain_runs *runs);

/* Whether the kernel of runs takes a run: that of lit faces takes segments of one length. */
static bool is_taken(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    const uint32_t first = (uint32_t)x0 >> 4, last = ((uint32_t)x1 - 1u) >> 4;
    return fxl_segments_suffice(face, row, x0, x1) &&
           (face->ramp == NULL ||
            fxl_segment_log(face->least, (uint32_t)fxl_segment_weight(face, row, first),
                            (uint32_t)fxl_segment_weight(face, row, first + 1)) ==
                fxl_segment_log(face->least, (uint32_t)fxl_segment_weight(face, row, last),
                                (uint32_t)fxl_segment_weight(face, row, last + 1)));
}

/* Runs of some rows, up to three in a row, against each of them by itself. */
static void compare_runs(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                         int32_t x1, runs_kernel *core, row_kernel *portable)
{
    uint32_t list[ROWS];
    fxl_plain_runs runs;
    runs.row = *row;
    runs.row.segments = face;
    runs.row.pixels = by_core[0] + 32;
    runs.stride = (uint32_t)sizeof by_core[0];
    runs.next = list;
    runs.end = list + 1 + (any_32() >> 5) % ROWS;
    runs.downs[0] =
        (int64_t)(any_64() >> 10 >> (any_32() >> 7) % 30u) * (any_32() >> 9 & 1u ? 1 : -1);
    runs.downs[1] = any_value() >> 3;
    runs.downs[2] = any_value() >> 3;
    runs.downs[3] = any_value() >> 3;
    fxl_paint_row by_itself = runs.row;
    bool same = true;
    by_itself.pixels = by_portable[0] + 32;
    for (uint32_t i = 0; i < ROWS; i++) {
        const uint32_t begin = (uint32_t)x0 + (any_32() >> 9) % (uint32_t)(x1 - x0 + 1);
        const uint32_t end = begin + (any_32() >> 9) % ((uint32_t)x1 - begin + 1u);
        list[i] = begin | end << 16 | (i > 0 && any_32() >> 9 & 1u ? FXL_RUN_BELOW : 0);
    }
    for (const uint32_t *run = list; run != runs.end; run++) {
        const int32_t begin = (int32_t)(*run & 0xFFFFu), end = (int32_t)(*run >> 16 & 0x7FFFu);
        if (*run & FXL_RUN_BELOW) {
            by_itself.pixels += sizeof by_portable[0];
            by_itself.weight = (int64_t)((uint64_t)by_itself.weight + (uint64_t)runs.downs[0]);
            for (uint32_t i = 0; i < FXL_ATTRIBUTES; i++) {
                by_itself.attributes[i] =
                    (int64_t)((uint64_t)by_itself.attributes[i] + (uint64_t)runs.downs[1 + i]);
            }
        }
        if (begin < end && !is_taken(face, &by_itself, begin, end)) {
            same &= core(&runs) && runs.next == run + 1;
        } else if (begin < end) {
            portable(face, &by_itself, begin, end);
        }
    }
    same &= !core(&runs) && runs.next == runs.end && runs.row.weight == by_itself.weight;
    equality_case(is_same() && same);
}

typedef bool holes_kernel(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                          int32_t x1, const fxl_hole_depths *depths);

/* Pixels that are hidden or left out keep their depth. Which are left out is seen where the same is
 * painted over two backgrounds. */
static void compare_holes(const fxl_segment_face *face, fxl_paint_row *row, int32_t x0, int32_t x1,
                          holes_kernel *core, row_kernel *portable, uint32_t bytes)
{
    uint16_t cells[COLUMNS + 2];
    const fxl_hole_depths depths = {any_32(), cells + 1, any_32(), any_32() >> 31};
    uint16_t before[COLUMNS + 2];
    const bool is_taken = fxl_segments_suffice(face, row, x0, x1);
    bool same = true;
    memset(by_portable[2], 0x5A, sizeof by_portable[2]);
    for (uint32_t i = 0; i < 2 && is_taken; i++) {
        row->pixels = by_portable[1 + i] + 32;
        portable(face, row, x0, x1);
    }
    for (uint32_t i = 0; i < COLUMNS + 2; i++) {
        const uint32_t code = depths.code + (i - 1u) * depths.step;
        before[i] = cells[i] = (uint16_t)((any_32() >> 30 == 0 ? code : any_32()) >> 16);
    }
    row->pixels = by_core[1] + 32;
    same &= core(face, row, x0, x1, &depths) == !is_taken;
    for (uint32_t i = 0; i < COLUMNS + 2; i++) {
        const uint32_t at = 32 + (i - 1u) * bytes,
                       code = (depths.code + (i - 1u) * depths.step) >> 16;
        const bool drawn = memcmp(by_portable[1] + at, by_portable[2] + at, bytes) == 0;
        const bool is_visible = code + depths.or_equal > before[i];
        same &= cells[i] == (drawn && is_visible ? code : before[i]);
        if (!is_visible) {
            memset(by_portable[1] + at, 0xA5, bytes);
        }
    }
    memset(by_portable[2], 0xA5, sizeof by_portable[2]);
    equality_case(is_same() && same);
}

#endif

/* The same texels, keyed, stippled or of 4 bits: the kernels are the same, the code of pixels is
 * not. */
static void compare_special(const fxl_segment_face *plain, fxl_paint_row *row, int32_t x0,
                            int32_t x1)
{
    fxl_segment_face face = *plain;
    if (face.rows_mask + (1u << face.log_width) > FEW) {
        return;
    }
    face.kind = (uint8_t)(FXL_TEXELS_KEYED + (any_32() >> 7) % 3u);
    face.form = 0;
    face.palette = face.kind == FXL_TEXELS_4 ? palette : NULL;
    row->y = (int32_t)(any_32() >> 25);
    if (face.kind == FXL_TEXELS_KEYED) {
        face.key = (any_32() >> 9) % 8u; /* texels are few */
    } else if (face.kind == FXL_TEXELS_STIPPLED) {
        face.stipple = any_32() >> 16;
    } else {
        face.colours = ramp;
    }
    face.texels = few_texels;
    compare_row(&face, row, x0, x1, fxl_paint_segments, portable_paint_segments);
    compare_rows(&face, row, x0, x1, fxl_paint_rows, portable_paint_rows);
    compare_row(&face, row, x0, x1, fxl_paint_segments_565, portable_paint_segments_565);
    compare_rows(&face, row, x0, x1, fxl_paint_rows_565, portable_paint_rows_565);
#if FXL_HAS_DEPTH_ROWS
    if (FXL_TEXELS_HAVE_HOLES(face.kind)) {
        compare_holes(&face, row, x0, x1, fxl_paint_holes, portable_paint_segments, 1);
        compare_holes(&face, row, x0, x1, fxl_paint_holes_565, portable_paint_segments_565, 2);
    } else {
        compare_runs(&face, row, x0, x1, fxl_paint_runs_565, portable_paint_segments_565);
        compare_runs(&face, row, x0, x1, fxl_paint_runs, portable_paint_segments);
    }
#endif
}

/* The same texture, which does not repeat. */
static void compare_clamped(const fxl_segment_face *plain, fxl_paint_row *row, int32_t x0,
                            int32_t x1)
{
    fxl_segment_face face = *plain;
    if (face.log_width < 5 || face.rows_mask >> face.log_width != (1u << face.log_width) - 1u) {
        return;
    }
    face.kind = FXL_TEXELS_CLAMPED;
    face.form = 0;
    face.is_constant = false;
    face.palette = any_32() >> 13 & 1u ? palette : NULL;
    compare_row(&face, row, x0, x1, fxl_paint_segments, portable_paint_segments);
    compare_rows(&face, row, x0, x1, fxl_paint_rows, portable_paint_rows);
    face.in_beam = NULL;
    compare_row(&face, row, x0, x1, fxl_paint_segments_565, portable_paint_segments_565);
    compare_rows(&face, row, x0, x1, fxl_paint_rows_565, portable_paint_rows_565);
#if FXL_HAS_DEPTH_ROWS
    compare_runs(&face, row, x0, x1, fxl_paint_runs_565, portable_paint_segments_565);
    compare_runs(&face, row, x0, x1, fxl_paint_runs, portable_paint_segments);
#endif
}

/* A line has more bits than a segment's coordinates; so its least weight is larger, or its drops.
 */
static void compare(fxl_segment_face *face, fxl_paint_row *row, int32_t x0, int32_t x1)
{
    if (face->is_constant && face->ramp == NULL) {
        face->u_drop += FXL_ROW_BITS;
        face->v_drop += FXL_ROW_BITS;
    }
    face->table = face->ramp == NULL && any_32() >> 15 & 1u ? ramp : NULL;
    compare_row(face, row, x0, x1, fxl_paint_segments, portable_paint_segments);
    if (face->ramp != NULL) {
#if FXL_HAS_DEPTH_ROWS
        compare_runs(face, row, x0, x1, fxl_paint_lit_runs, portable_paint_segments);
#endif
        return;
    }
    compare_special(face, row, x0, x1);
    compare_clamped(face, row, x0, x1);
    const uint32_t form = face->form;
    face->palette = any_32() >> 13 & 1u ? palette : NULL;
    face->in_beam = any_32() >> 19 & 1u && face->palette != NULL ? ramp : NULL;
    face->form = (uint8_t)(face->in_beam != NULL ? 0 : form);
    compare_row(face, row, x0, x1, fxl_paint_segments_565, portable_paint_segments_565);
    compare_rows(face, row, x0, x1, fxl_paint_rows_565, portable_paint_rows_565);
#if FXL_HAS_DEPTH_ROWS
    compare_runs(face, row, x0, x1, fxl_paint_runs_565, portable_paint_segments_565);
#endif
    face->form = (uint8_t)form;
#if FXL_HAS_DEPTH_ROWS
    compare_runs(face, row, x0, x1, fxl_paint_runs, portable_paint_segments);
#endif
    compare_rows(face, row, x0, x1, fxl_paint_rows, portable_paint_rows);
}

/* Segments of all lengths: the least weights lie about those of the row. */
static void choose_least(fxl_segment_face *face, const fxl_paint_row *row, uint32_t least)
{
    const uint32_t weight = (uint32_t)(row->weight >> 32);
    face->least[3] = least;
    for (uint32_t i = 3; i-- > 0;) {
        const uint32_t more = face->least[i + 1] + (any_32() >> 5) % (weight / 3u + 1u);
        face->least[i] = i == 2 && face->ramp != NULL ? least : more > INT32_MAX ? INT32_MAX : more;
    }
}

/* A texture of any size that the kernel takes. */
static void choose_texture(fxl_segment_face *face, uint32_t log_width, uint32_t log_height)
{
    const uint32_t log = log_width > log_height ? log_width : log_height;
    face->kind = FXL_TEXELS_PLAIN;
    face->texels = texels;
    face->rows_mask = ((1u << log_height) - 1u) << log_width;
    face->log_width = (uint8_t)log_width;
    face->row_drop = (uint8_t)(16u - log - log_width);
    face->form = (uint8_t)(log_width == log ? log_width - FXL_SEGMENT_LOG_MIN : 0u);
}

/* The weight rises or falls between two weights that the face allows, from column 0 to the last. */
static void choose_weights(fxl_segment_face *face, fxl_paint_row *row, int64_t at, int64_t end)
{
    face->weight_step = (end - at) / (int64_t)COLUMNS * 16;
    face->is_constant = face->weight_step == 0;
    row->weight = at;
}

static void choose_light(fxl_segment_face *face, fxl_paint_row *row, uint32_t levels)
{
    face->ramp = levels == 0 ? NULL : ramp;
    face->light_max = (int32_t)(256u * levels) - 1;
    face->light_step = (int32_t)(any_value() >> 32);
    row->attributes[FXL_SEGMENT_LIGHT] = any_value();
}

static void choose_coordinates(fxl_segment_face *face, fxl_paint_row *row)
{
    face->u_step = any_value() / 16 * 16;
    face->v_step = any_value() / 16 * 16;
    row->attributes[FXL_ATTRIBUTE_U] = any_value();
    row->attributes[FXL_ATTRIBUTE_V] = any_value();
}

/* The drops are at least what the least weight needs: 32 less than its leading zeros. */
static void choose_drops(fxl_segment_face *face, int32_t least, uint32_t range)
{
    face->u_drop = least + (int32_t)((any_32() >> 8) % range);
    face->v_drop = least + (int32_t)((any_32() >> 8) % range);
    face->light_drop = least + (int32_t)((any_32() >> 8) % range);
    face->drop_min = face->u_drop < face->v_drop ? face->u_drop : face->v_drop;
    face->drop_min = face->drop_min < face->light_drop ? face->drop_min : face->light_drop;
}

/* Every size, at every beginning and end of a row. */
static void sizes(void)
{
    fxl_segment_face face;
    fxl_paint_row row;
    for (uint32_t log_width = FXL_SEGMENT_LOG_MIN; log_width <= 8; log_width++) {
        for (uint32_t log_height = 0; log_height <= 8; log_height++) {
            for (uint32_t i = 0; i < 34u * 3u; i++) {
                const int32_t x0 = (int32_t)(i % 34u);
                const int32_t x1 = x0 + 1 + (int32_t)((any_32() >> 9) % (COLUMNS - 34u));
                choose_texture(&face, log_width, log_height);
                choose_weights(&face, &row, (int64_t)(any_32() >> 2 | 1u << 20) << 32,
                               (int64_t)(any_32() >> 2 | 1u << 20) << 32);
                choose_coordinates(&face, &row);
                choose_drops(&face, -21, 40);
                choose_light(&face, &row, i % 3u == 0 ? 0 : LEVELS - i % LEVELS);
                choose_least(&face, &row, 1u << 20);
                compare(&face, &row, x0, x1);
            }
        }
    }
}

/* Weights about powers of two, constant and not, with the least drops. */
static void weights(void)
{
    fxl_segment_face face;
    fxl_paint_row row;
    for (uint32_t bits = 1; bits <= 30; bits++) {
        for (uint32_t i = 0; i < 24; i++) {
            const int64_t at = ((int64_t)1 << (bits + 32)) - (i & 1u ? 1 : 0) * ((int64_t)1 << 32);
            const int64_t end = i & 2u ? at : (int64_t)1 << (33 + i);
            const int64_t less = at < end ? at : end;
            int32_t zeros = 0;
            while (less >> (62 - zeros) == 0) {
                zeros++;
            }
            if (less < (int64_t)2 << 32) {
                continue;
            }
            choose_texture(&face, 4u + i % 5u, 4u + i % 5u);
            choose_weights(&face, &row, at, end);
            choose_coordinates(&face, &row);
            choose_drops(&face, zeros + 1 - 32, i & 4u ? 1 : 60);
            choose_light(&face, &row, i & 8u ? LEVELS : 0);
            choose_least(&face, &row, (uint32_t)(less >> 32));
            compare(&face, &row, (int32_t)(i & 15u), (int32_t)COLUMNS - (int32_t)(i >> 1));
        }
    }
}

/* A coordinate that begins within a texture, whose size is `bound` in the upper word, and ends
 * there or near it. */
static int64_t choose_within(int32_t bound, int64_t *step)
{
    const uint32_t size = (uint32_t)bound;
    const int64_t at = (int64_t)(any_32() % size) << 32 | any_32();
    const int64_t end =
        ((int64_t)(any_32() % (size + size / 8u)) - bound / 16) * ((int64_t)1 << 32);
    *step = (end - at) / (int64_t)COLUMNS * 16;
    return at;
}

/* A texture that does not repeat, on rows of constant weight that mostly lie within it. */
static void rows_within(int32_t x0, int32_t x1)
{
    fxl_segment_face face;
    fxl_paint_row row;
    const uint32_t log = 5u + (any_32() >> 5) % 4u;
    const int32_t weight = (int32_t)(any_32() >> 3 | 1u << 26);
    const int64_t all = (int64_t)weight << 32 | any_32();
    const int32_t u_down = (int32_t)((any_32() >> 8) % 7u),
                  v_down = (int32_t)((any_32() >> 8) % 7u);
    choose_texture(&face, log, log);
    choose_weights(&face, &row, all, all);
    choose_drops(&face, 10, 1);
    face.u_drop -= u_down;
    face.v_drop -= v_down;
    face.drop_min = 4;
    choose_light(&face, &row, 0);
    choose_least(&face, &row, 1u << 20);
    face.table = any_32() >> 15 & 1u ? ramp : NULL;
    row.attributes[FXL_ATTRIBUTE_U] = choose_within(weight >> u_down, &face.u_step);
    row.attributes[FXL_ATTRIBUTE_V] = choose_within(weight >> v_down, &face.v_step);
    compare_clamped(&face, &row, x0, x1);
}

void test_texture_rows(uint32_t rounds)
{
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(any_32() >> 11);
    }
    for (uint32_t i = 0; i < sizeof few_texels; i++) {
        few_texels[i] = (uint8_t)(i % 2u == 0 ? (any_32() >> 11) % 8u : any_32() >> 31);
    }
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)(any_32() >> 11);
    }
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(any_32() >> 11);
    }
    sizes();
    weights();
    for (uint32_t i = 0; i < rounds; i++) {
        fxl_segment_face face;
        fxl_paint_row row;
        const uint32_t least = 1u + (any_32() >> 5) % 28u;
        const int32_t x0 = (int32_t)(any_32() >> 8 & 31u);
        choose_texture(&face, 4u + (any_32() >> 5) % 5u, (any_32() >> 5) % 9u);
        choose_weights(&face, &row, (int64_t)(any_64() >> 2 | (uint64_t)1 << (32u + least)),
                       (int64_t)(any_64() >> 2 | (uint64_t)1 << (32u + least)));
        choose_coordinates(&face, &row);
        choose_drops(&face, -1 - (int32_t)least, 50);
        choose_light(&face, &row, (any_32() >> 5) % 3u == 0 ? 0 : (any_32() >> 5) % (LEVELS + 1u));
        choose_least(&face, &row, 1u << least);
        compare(&face, &row, x0, x0 + 1 + (int32_t)((any_32() >> 7) % 63u));
        rows_within(x0, x0 + 1 + (int32_t)((any_32() >> 7) % 63u));
    }
}
