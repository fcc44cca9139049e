/* SPDX-License-Identifier: MIT */
/* A sky and a ground in the place of the background (docs/extras/horizon.md).
 *
 * The ray through a pixel's centre is d = right X + up Y + forward f, where X and Y say how far the
 * centre lies from the middle, to the right and upward, and f is the focal length, all in 16.16. The
 * sine of its elevation is E / |d| with E = d . (0, 1, 0), which is linear along a row, and |d|^2 =
 * X^2 + Y^2 + f^2. Along a row the sine has the derivative (B c - A X) / |d|^3, where E = A + B X
 * and c = Y^2 + f^2: it changes its sign once at most. So a row has two pieces at most in which the
 * level rises or falls throughout, and where it changes there is found by halving. */
#include "../math/arith.h"
#include "../math/plane.h"
#include "../raster/columns.h"
#include "../raster/fill.h"
#include "../view/view.h"
#include "fixel/horizon.h"
#include "renderer.h"
#include "submit.h"

/* A row of a band, in which all |d| are below 2^scale. */
typedef struct {
    const fxl_horizon *horizon;
    fxl_q2_30 right;         /* B */
    int64_t straight;        /* A, in units of 2^(scale - 78), as E is: below 2^62 */
    int64_t elevation, step; /* E of the first column, and what the next one's is more */
    uint64_t square;         /* c, in units of 2^(2 scale - 94): below 2^62 */
    uint32_t x, x_step;      /* X of the first column, in units of 2^(scale - 47), as 32 bits */
} horizon_row;

static int32_t x_of(const horizon_row *row, uint32_t column)
{
    return fxl_signed_32(row->x + column * row->x_step);
}

/* A sine, and its square. */
typedef struct {
    fxl_q2_30 sine;
    uint32_t high, low;
} threshold;

static threshold threshold_of(const horizon_row *row, uint32_t number)
{
    const fxl_q2_30 sine = row->horizon->sines[number];
    const uint64_t square = (uint64_t)fxl_multiply_s32(sine, sine);
    const threshold made = {sine, (uint32_t)(square >> 32), fxl_low_32(square)};
    return made;
}

/* Whether the sine of the elevation of a column is at least another one. Where both have one sign,
 * E^2 is compared with t^2 |d|^2, both in units of 2^(2 scale - 92). E is cut to 30 bits, the square
 * of |d| too, and the product with t^2, of 60 bits, by 30: each costs 2^-26 of |d| at most, as |d| is
 * 2^(scale - 3) at least. */
/* horizon 1.3 */
static inline bool is_above(const horizon_row *row, uint32_t column, const threshold *at)
{
    const int64_t e = row->elevation + (int64_t)column * row->step;
    if (at->sine == 0 || (e < 0) != (at->sine < 0)) {
        return e >= 0;
    }
    const int32_t x = x_of(row, column), part = (int32_t)(e >> 32);
    const uint32_t length = (uint32_t)((row->square + (uint64_t)fxl_multiply_s32(x, x)) >> 32);
    const uint64_t wanted = (fxl_multiply_u32(at->high, length) << 2) +
                            (fxl_multiply_u32(at->low, length) >> 30);
    const uint64_t got = (uint64_t)fxl_multiply_s32(part, part);
    return at->sine > 0 ? got >= wanted : got <= wanted;
}

/* How many of the sines are at most that of a column's elevation. near: a number near it. */
/* horizon 1.2 */
static uint32_t level_at(const horizon_row *row, uint32_t column, uint32_t near)
{
    const uint32_t count = row->horizon->count;
    uint32_t level = near;
    for (bool is_known = false; level < count && !is_known;) {
        const threshold next = threshold_of(row, level);
        is_known = !is_above(row, column, &next);
        level += !is_known;
    }
    for (bool is_known = level > near; level > 0 && !is_known;) {
        const threshold last = threshold_of(row, level - 1);
        is_known = is_above(row, column, &last);
        level -= !is_known;
    }
    return level;
}

/* The first column of low..high that is above a sine, or, where the level falls, that is not. At
 * high that is so. near: a column near it, from which steps are doubled until it lies between two. */
static uint32_t change_at(const horizon_row *row, uint32_t low, uint32_t high, const threshold *at,
                          bool rises, uint32_t near)
{
    uint32_t step = 1;
    if (near < high && near >= low && is_above(row, near, at) != rises) {
        low = near + 1;
        while (high - low >= step && is_above(row, low + step - 1, at) != rises) {
            low += step;
            step *= 2;
        }
        high = high - low >= step ? low + step - 1 : high;
    } else if (near < high && near >= low) {
        high = near;
        while (high - low >= step && is_above(row, high - step, at) == rises) {
            high -= step;
            step *= 2;
        }
        low = high - low >= step ? high - step + 1 : low;
    }
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (is_above(row, middle, at) == rises) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

/* Whether the elevation rises from a column to the right: B c > A X, in units of 2^(2 scale - 93). */
static bool is_rising(const horizon_row *row, uint32_t column)
{
    const int64_t turning = fxl_multiply_s32(row->right, (int32_t)(row->square >> 32));
    return 2 * turning > fxl_multiply_s32((int32_t)(row->straight >> 32), x_of(row, column));
}

/* Whole rows that have one colour and are not filled yet; and where the first pixel of a row is. */
typedef struct {
    const fxl_renderer *renderer;
    const fxl_band *band;
    uint32_t row, rows, level;
    uint8_t *pixels; /* of the row that is looked at */
    uint32_t columns;
    fxl_pixel_kind kind;
} horizon_run;

/* horizon 1.2 */
static void fill_run(horizon_run *run)
{
    const fxl_renderer *renderer = run->renderer;
    fxl_band part = *run->band;
    if (run->rows != 0) {
        part.pixels += fxl_pixel_bytes(run->kind, (size_t)run->row * part.stride);
        part.first_row = (uint16_t)(part.first_row + run->row);
        part.rows = (uint16_t)run->rows;
        run->rows = 0;
        renderer->target->fill(renderer, &part, renderer->horizon->colours[run->level]);
    }
}

/* Columns of a row have a level: they are filled, or go on a run of whole rows, or begin one. */
static inline void emit(horizon_run *run, uint32_t row, uint32_t from, uint32_t end, uint32_t level)
{
    if (end - from == run->columns) {
        if (run->level != level || run->row + run->rows != row) {
            fill_run(run);
            run->row = row;
            run->level = level;
        }
        run->rows++;
        return;
    }
    const uint8_t colour = run->renderer->horizon->colours[level];
    if (!run->kind.is_colour) {
        fxl_fill_row(run->pixels + from, run->pixels + end, colour * 0x01010101u);
    } else {
        uint16_t *pixels = (uint16_t *)(void *)run->pixels;
        fxl_fill_row_rgb565(pixels + from, pixels + end, run->band->palette[colour]);
    }
}

/* A piece of a row in which the level rises or falls throughout, of one column at least; what stays
 * of it for the row below. */
typedef struct {
    uint32_t first, last; /* levels at its ends */
    struct {
        int16_t column, step; /* where the level changes, and how far that is from the row above */
    } changes[FXL_HORIZON_MAX];
} horizon_piece;

static void fill_piece(horizon_run *run, const horizon_row *row, horizon_piece *piece,
                       uint32_t number, uint32_t from, uint32_t end)
{
    uint32_t level = level_at(row, from, piece->first);
    const uint32_t last = level_at(row, end - 1, piece->last);
    const bool rises = last > level;
    piece->first = level;
    piece->last = last;
    while (level != last) {
        const uint32_t k = rises ? level : level - 1;
        const int32_t before = piece->changes[k].column, step = piece->changes[k].step;
        const threshold at = threshold_of(row, k);
        const uint32_t next =
            change_at(row, from, end - 1, &at, rises, (uint32_t)(before + step));
        piece->changes[k].column = (int16_t)next;
        piece->changes[k].step = (int16_t)((int32_t)next - before);
        emit(run, number, from, next, level);
        from = next;
        level = rises ? level + 1 : level - 1;
    }
    emit(run, number, from, end, level);
}

/* The first column from which the elevation goes the other way than at the first; else all. */
static uint32_t turn_of(const horizon_row *row, uint32_t columns)
{
    const bool rises = is_rising(row, 0);
    uint32_t low = 0, high = columns;
    if (is_rising(row, columns - 1) == rises) {
        return columns;
    }
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (is_rising(row, middle) == rises) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/* --- a band ---------------------------------------------------------------------------------- */

/* An upward component of a row of the camera before the shear of an off-centre lens (SPEC 4.2):
 * the shear backward. */
static fxl_q2_30 before_shear(fxl_q2_30 sheared, fxl_q2_30 forward, int32_t offset,
                              const fxl_view *view)
{
    const int64_t drawn = fxl_multiply_s32(fxl_view_drawn_focal(view), sheared);
    return fxl_divide_round(drawn - fxl_multiply_s32(offset, forward), (uint32_t)view->lens.focal);
}

static uint64_t square_of(int32_t length)
{
    return (uint64_t)fxl_multiply_s32(length, length);
}

/* The square of the longest |d| of a band, and of the focal length. */
static uint64_t most_of(int32_t x, int32_t y, const fxl_band *band, uint64_t ahead)
{
    const uint64_t left = square_of(x), top = square_of(y);
    const uint64_t right = square_of(x + (int32_t)(fxl_band_columns(band) - 1) * 65536);
    const uint64_t bottom = square_of(y - (band->rows - 1) * 65536);
    return (left > right ? left : right) + (top > bottom ? top : bottom) + ahead;
}

/* horizon 1.1, 1.4, 1.5 */
static void fill_horizon(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour)
{
    const fxl_view *view = &renderer->frame.view;
    const fxl_lens *lens = &view->lens;
    const fxl_axes *axes = &view->camera.axes;
    const uint32_t columns = fxl_band_columns(band);
    const uint64_t ahead = square_of(lens->focal);
    /* place fill-rule: the ray through the centre of a pixel */
    const int32_t x = band->first_column * 65536 + 32768 - lens->centre_x;
    int32_t y = lens->centre_y - band->first_row * 65536 - 32768;
    const unsigned scale = (fxl_bit_length(most_of(x, y, band, ahead)) + 1) / 2;
    const int64_t unit = (int64_t)1 << (32 - scale);
    horizon_piece pieces[2] = {{0}};
    horizon_run run = {.renderer = renderer,
                       .band = band,
                       .pixels = band->pixels,
                       .columns = columns,
                       .kind = fxl_kind_of_band(band)};
    horizon_row row = {.horizon = renderer->horizon, .right = axes->right.y};
    fxl_q2_30 up = axes->up.y;
    (void)colour;
    if (lens->off_centre != NULL) {
        const fxl_q2_30 forward = axes->forward.y;
        row.right = before_shear(row.right, forward, lens->centre_x - lens->width * 32768, view);
        up = before_shear(up, forward, lens->height * 32768 - lens->centre_y, view);
    }
    row.x = (uint32_t)x << (31 - scale);
    row.x_step = 65536u << (31 - scale);
    row.step = fxl_multiply_s64((int64_t)row.right * 65536, unit);
    for (uint32_t number = 0; number < band->rows; number++, y -= 65536) {
        row.straight =
            (fxl_multiply_s32(up, y) + fxl_multiply_s32(axes->forward.y, lens->focal)) * unit;
        row.elevation = row.straight + fxl_multiply_s32(row.right, x) * unit;
        row.square = (square_of(y) + ahead) << (62 - 2 * scale);
        const uint32_t turn = turn_of(&row, columns);
        fill_piece(&run, &row, &pieces[0], number, 0, turn);
        if (turn < columns) {
            fill_piece(&run, &row, &pieces[1], number, turn, columns);
        }
        run.pixels += fxl_pixel_bytes(run.kind, band->stride);
    }
    fill_run(&run);
}

/* --- attaching ------------------------------------------------------------------------------- */

/* horizon 1.6 */
fxl_status fxl_horizon_check(const fxl_horizon *horizon)
{
    if (horizon == NULL || horizon->sines == NULL || horizon->colours == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (horizon->count < 1 || horizon->count > FXL_HORIZON_MAX) {
        return FXL_E_COUNT;
    }
    for (uint32_t i = 0; i < horizon->count; i++) {
        if (!fxl_within(horizon->sines[i], FXL_Q2_30_ONE) ||
            (i > 0 && horizon->sines[i] < horizon->sines[i - 1])) {
            return FXL_E_RANGE;
        }
    }
    return FXL_OK;
}

fxl_status fxl_attach_horizon(fxl_renderer *renderer, const fxl_horizon *horizon)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = renderer->target == NULL ? FXL_E_ORDER : FXL_OK;
    if (status == FXL_OK && horizon != NULL) {
        status = fxl_horizon_check(horizon);
    }
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    renderer->horizon = horizon;
    renderer->check = fxl_check_combination;
    FXL_COUNT_CHANGE(&renderer->workspace);
    renderer->fill = horizon != NULL ? fill_horizon : renderer->target->fill;
    return FXL_OK;
}
