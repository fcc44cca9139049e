/* SPDX-License-Identifier: MIT */
/* Where rows of a horizon pass a sine (docs/extras/horizon.md).
 *
 * The ray through a pixel's centre is d = right X + up Y + forward f, where X and Y say how far the
 * centre lies from the middle, to the right and upward, and f is the focal length. The sine of its
 * elevation is E / |d| with E = d . (0, 1, 0), which is linear along a row, and |d|^2 = X^2 + Y^2 +
 * f^2. Along a row the sine has the derivative (B c - A X) / |d|^3, where E = A + B X and c = Y^2 +
 * f^2: it changes its sign once at most. So a row has two pieces at most in which the level rises or
 * falls throughout, and a piece passes each sine once at most, in their order.
 *
 * A pixel is above a sine t where E |E| - t |t| |d|^2, its excess, is not negative. About a column
 * that passes t this is a quadratic function of the column and the row, so it is followed from pixel
 * to pixel by sums of 32 bits, and computed anew where these do not say its sign for sure. */
#include "../math/arith.h"
#include "fixel/horizon.h"
#include "horizon_rows.h"

#define FAR    8  /* columns: a place farther from the one expected says nothing of the row below */
#define STEPS  7  /* columns a row: up to these an excess is followed */
#define SCALE  23 /* the least at which it is: a pixel is 2^22 then */
#define MARGIN 384 /* of what was followed, in units of an excess */

/* A pixel's row. */
typedef struct {
    int64_t straight; /* A, in units of 2^(scale - 61), as E is: below 2^61 */
    uint64_t square;  /* c: below 2^62 */
    int32_t y;
} horizon_row;

static inline horizon_row row_of(const fxl_horizon_rows *rows, uint32_t number)
{
    const int32_t y = fxl_signed_32((uint32_t)rows->y - number * (uint32_t)rows->step);
    const horizon_row row = {rows->straight + fxl_multiply_s32(rows->up, y),
                             rows->ahead + (uint64_t)fxl_multiply_s32(y, y), y};
    return row;
}

static inline int32_t x_of(const fxl_horizon_rows *rows, uint32_t column)
{
    return fxl_signed_32((uint32_t)rows->x + column * (uint32_t)rows->step);
}

/* E of a pixel, cut to 29 bits. */
static inline int32_t elevation_of(const fxl_horizon_rows *rows, const horizon_row *row, int32_t x)
{
    return (int32_t)((row->straight + fxl_multiply_s32(rows->right, x)) >> 32);
}

static inline int32_t magnitude_of(int32_t elevation)
{
    return elevation < 0 ? -elevation : elevation;
}

/* -t |t|, in units of 2^-60. */
static inline int64_t square_of_sine(fxl_q2_30 sine)
{
    return fxl_multiply_s32(sine, sine < 0 ? sine : -sine);
}

/* E |E| - t |t| |d|^2, in units of 2^(2 scale - 58), and so below 2^59. The square of |d| is cut to 30
 * bits; all products are exact. */
/* horizon 1.3 */
static inline int64_t excess_of(const horizon_row *row, int32_t x, int32_t elevation,
                                int64_t square)
{
    const uint32_t length = (uint32_t)((row->square + (uint64_t)fxl_multiply_s32(x, x)) >> 32);
    int64_t sum = (int64_t)(fxl_multiply_u32(fxl_low_32(fxl_bits_64(square)), length) >> 32);
    sum += fxl_multiply_s32((int32_t)(square >> 32), (int32_t)length);
    return sum + fxl_multiply_s32(elevation, magnitude_of(elevation));
}

bool fxl_horizon_has_passed(const fxl_horizon_rows *rows, uint32_t row, uint32_t column,
                            fxl_q2_30 sine)
{
    const horizon_row at = row_of(rows, row);
    const int32_t x = x_of(rows, column);
    const int64_t excess = excess_of(&at, x, elevation_of(rows, &at, x), square_of_sine(sine));
    return ((int32_t)(excess >> 32) ^ rows->flip) >= 0;
}

/* Of rows that do not turn the first and the last are looked at: the excess is a quadratic function
 * of the row, whose second difference is below 2 pixels squared in magnitude, so between 16 rows it is
 * less than 57 of these from the straight line. */
bool fxl_horizon_are_alike(const fxl_horizon_rows *rows, fxl_q2_30 sine, bool is_last)
{
    const int64_t square = square_of_sine(sine);
    const int32_t side = rows->flip ^ (is_last ? -1 : 0);
    const uint32_t step = rows->turns || rows->count == 1 ? 1 : rows->count - 1;
    const int32_t least = step > 1 ? 2 + (int32_t)(57u << (59 - 2 * rows->scale)) : 0;
    for (uint32_t i = 0; i < rows->count; i += step) {
        const horizon_row row = row_of(rows, i);
        const int32_t x =
            x_of(rows, is_last ? fxl_horizon_end(rows, i) - 1 : fxl_horizon_from(rows, i));
        const int64_t excess = excess_of(&row, x, elevation_of(rows, &row, x), square);
        if (((int32_t)(excess >> 32) ^ side) < least) {
            return false;
        }
    }
    return true;
}

/* The first column of a row that has passed a sine, or the end. near: a column of the piece, from
 * which steps are doubled until it lies between two. */
static uint32_t search(const fxl_horizon_rows *rows, uint32_t row, fxl_q2_30 sine, uint32_t near)
{
    const bool is_down = fxl_horizon_has_passed(rows, row, near, sine);
    uint32_t low = is_down ? fxl_horizon_from(rows, row) : near + 1;
    uint32_t high = is_down ? near : fxl_horizon_end(rows, row);
    bool is_doubled = true;
    uint32_t step = 1;
    while (low < high) {
        is_doubled = is_doubled && high - low >= step;
        const uint32_t way = is_doubled ? step : (high - low + 1) / 2;
        const uint32_t column = is_down ? high - way : low + way - 1;
        const bool has_passed = fxl_horizon_has_passed(rows, row, column, sine);
        is_doubled = is_doubled && has_passed == is_down;
        if (has_passed) {
            high = column;
        } else {
            low = column + 1;
        }
        step *= 2;
    }
    return low;
}

/* An excess that is followed, less MARGIN: its value, what it is more than in the column before, and
 * in the row below, `step` columns to the right, more than here; and by how much these rise. */
typedef struct {
    int32_t value, along, down;
    int32_t along_along, along_down, down_down;
} horizon_track;

/* value / 2^shift, rounded. */
static inline int32_t rounded(int32_t value, unsigned shift)
{
    return (value + (1 << (shift - 1))) >> shift;
}

/* Begins at a pixel. False where an excess cannot be followed. With a sine of 0 it is E itself. */
static bool follow(const fxl_horizon_rows *rows, const horizon_row *row, fxl_q2_30 sine,
                   uint32_t column, int32_t step, horizon_track *track)
{
    const int32_t x = x_of(rows, column), elevation = elevation_of(rows, row, x);
    const int32_t flip = rows->flip, sign = (sine >> 31) ^ flip;
    const unsigned scale = rows->scale, second = 2 * scale - 40;
    const fxl_q2_30 right = (rows->right ^ flip) - flip, up = (rows->up ^ flip) - flip;
    if (sine == 0) {
        track->value = (elevation ^ flip) - MARGIN;
        track->along = right >> (scale - 15);
        track->down = (step * (right >> 4) - (up >> 4)) >> (scale - 19);
        track->along_along = 0;
        track->along_down = 0;
        track->down_down = 0;
        return true;
    }
    if ((elevation ^ sine) < 0) {
        return false;
    }
    const int64_t square = square_of_sine(sine);
    const int32_t high = ((int32_t)(square >> 32) ^ flip) - flip;
    const int32_t magnitude = magnitude_of(elevation);
    const int32_t xx = ((rows->xx ^ sign) + high) >> 6, xy = (rows->xy ^ ~sign) >> 6,
                  yy = ((rows->yy ^ sign) + high) >> 6;
    const int32_t along =
        (int32_t)((fxl_multiply_s32(right, magnitude) + fxl_multiply_s32(high, x)) >> 32);
    const int32_t down =
        (int32_t)((fxl_multiply_s32(up, magnitude) + fxl_multiply_s32(high, row->y)) >> 32);
    track->value = ((int32_t)(excess_of(row, x, elevation, square) >> 29) ^ flip) - MARGIN;
    track->along_along = rounded(xx, second);
    track->along_down = rounded(step * xx + xy, second);
    track->down_down = rounded(step * (step * xx + 2 * xy) + yy, second);
    track->along = (along >> (scale - 19)) - (track->along_along >> 1);
    track->down = ((step * along - down) >> (scale - 19)) + (track->down_down >> 1);
    return true;
}

/* Finds columns as long as an excess that is followed says them for sure, and returns of how many
 * rows. Then *step is one more or one less, if the next column is out of its reach. */
static uint32_t find_followed(horizon_track track, int32_t *step, int32_t column, uint16_t *columns,
                              uint32_t count)
{
    const int32_t way = *step;
    uint32_t left = count;
    do {
        if (track.value < 0) {
            track.along += track.along_along;
            track.value += track.along;
            track.down += track.along_down;
            column++;
        }
        if (track.value < 0 || track.value >= track.along - 2 * MARGIN) {
            *step += track.value < -2 * MARGIN ? 1 : track.value >= track.along ? -1 : 0;
            break;
        }
        *columns++ = (uint16_t)column;
        track.value += track.down;
        track.down += track.down_down;
        track.along += track.along_down;
        column += way;
    } while (--left > 0);
    return count - left;
}

/* How many of at most `count` rows keep a column within the piece that all rows have, but for its
 * first column, if it moves `step` columns a row or one more. */
static uint32_t within(const fxl_horizon_rows *rows, int32_t column, int32_t step, uint32_t count)
{
    const int32_t left = column - (int32_t)rows->from - 1;
    const int32_t right = (int32_t)rows->end - 2 - column;
    if (left < 0 || right < 0) {
        return 0;
    }
    while (count > 0 &&
           (step < 0 ? -step * (int32_t)count > left : (step + 1) * (int32_t)count > right)) {
        count /= 2;
    }
    return count;
}

/* The columns of rows from the first one on that can be followed; how many. */
static uint32_t find_some(const fxl_horizon_rows *rows, uint32_t first, fxl_q2_30 sine,
                          int32_t column, int32_t *step, uint16_t *columns)
{
    const int32_t near = column + *step;
    const uint32_t count = within(rows, near, *step, rows->count - first);
    const horizon_row row = row_of(rows, first);
    horizon_track track;
    if (rows->scale < SCALE || *step > STEPS || *step < -STEPS || count == 0 ||
        !follow(rows, &row, sine, (uint32_t)near, *step, &track)) {
        return 0;
    }
    return find_followed(track, step, near, columns + first, count);
}

/* The column of one row, looked for near one that may lie beside the piece. */
static int32_t find_one(const fxl_horizon_rows *rows, uint32_t row, fxl_q2_30 sine, int32_t near,
                        int32_t *step)
{
    const int32_t from = (int32_t)fxl_horizon_from(rows, row);
    const int32_t end = (int32_t)fxl_horizon_end(rows, row), before = near - *step;
    near = near < from ? from : near >= end ? end - 1 : near;
    const int32_t found = (int32_t)search(rows, row, sine, (uint32_t)near), moved = found - before;
    if (found - near > FAR || near - found > FAR) {
        *step = 0;
    } else if (moved < *step) {
        *step = moved;
    } else if (moved > *step + 1) {
        *step = moved - 1;
    }
    return found;
}

void fxl_horizon_find(const fxl_horizon_rows *rows, fxl_q2_30 sine, fxl_horizon_change *change,
                      uint16_t *columns)
{
    int32_t column = change->column, step = change->step;
    uint32_t i = 0;
    while (i < rows->count) {
        const uint32_t found = find_some(rows, i, sine, column, &step, columns);
        if (found > 0) {
            i += found;
            column = columns[i - 1];
        } else {
            column = find_one(rows, i, sine, column + step, &step);
            columns[i++] = (uint16_t)column;
        }
    }
    change->column = (int16_t)column;
    change->step = (int16_t)step;
}

/* --- rows that are alike --------------------------------------------------------------------- */

static uint64_t square_of(int32_t length)
{
    return (uint64_t)fxl_multiply_s32(length, length);
}

static unsigned scale_of(const fxl_horizon_rows *rows, int32_t y)
{
    const fxl_lens *lens = rows->lens;
    const uint64_t left = square_of(32768 - lens->centre_x);
    const uint64_t right = square_of(lens->width * 65536 - 32768 - lens->centre_x);
    const uint64_t most = (left > right ? left : right) + square_of(y) + square_of(lens->focal);
    return (fxl_bit_length(most) + 1) / 2;
}

/* B c - A X: the elevation rises from a column to the right where it is above 0. In units of
 * 2^(2 scale - 60), and off by 2^32 of these at most. */
static int64_t rise_of(const fxl_horizon_rows *rows, uint32_t row, uint32_t column)
{
    const horizon_row at = row_of(rows, row);
    return fxl_multiply_s32(rows->right, (int32_t)(at.square >> 32)) -
           fxl_multiply_s32((int32_t)(at.straight >> 32), x_of(rows, column));
}

/* Whether a column rises in all rows, or falls in all. As a function of the row the rise is
 * quadratic, and between the first and the last of 16 rows less than 57 times what B and a pixel's
 * square make from the straight line. */
static bool is_one_side(const fxl_horizon_rows *rows, uint32_t column)
{
    const int64_t first = rise_of(rows, 0, column), last = rise_of(rows, rows->count - 1, column);
    const int64_t least =
        fxl_multiply_s32(magnitude_of(rows->right), 57 << (62 - 2 * rows->scale)) +
        ((int64_t)1 << 33);
    return (first > least && last > least) || (first < -least && last < -least);
}

/* Whether so many rows have one scale. */
static bool is_one_scale(const fxl_horizon_rows *rows, int32_t y)
{
    const int32_t last = y - (int32_t)(rows->count - 1) * 65536;
    return scale_of(rows, last) == rows->scale &&
           ((y ^ last) >= 0 || scale_of(rows, 0) == rows->scale);
}

/* The first column from which the elevation goes the other way than at the first. */
static uint32_t turn_of(const fxl_horizon_rows *rows, uint32_t row)
{
    uint32_t low = 0, high = rows->columns;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if ((rise_of(rows, row, middle) > 0) == rows->rises) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

void fxl_horizon_take(fxl_horizon_rows *rows, int32_t y, uint32_t most)
{
    const uint32_t last = rows->columns - 1;
    const unsigned scale = scale_of(rows, y), shift = 31 - scale;
    rows->scale = scale;
    rows->x = (int32_t)((uint32_t)rows->first_x << shift);
    rows->y = (int32_t)((uint32_t)y << shift);
    rows->step = (int32_t)(65536u << shift);
    rows->xx = (int32_t)(fxl_multiply_s32(rows->right, rows->right) >> 32);
    rows->xy = (int32_t)(fxl_multiply_s32(rows->right, rows->up) >> 32);
    rows->yy = (int32_t)(fxl_multiply_s32(rows->up, rows->up) >> 32);
    rows->straight = fxl_multiply_s32(rows->forward, rows->lens->focal) * ((int64_t)1 << shift);
    rows->ahead = square_of(rows->lens->focal) << (2 * shift);
    rows->count = most;
    if (scale < SCALE || !is_one_scale(rows, y) || !is_one_side(rows, 0) ||
        !is_one_side(rows, last)) {
        rows->count = 1;
    }
    rows->rises = rise_of(rows, 0, 0) > 0;
    rows->turns = (rise_of(rows, 0, last) > 0) != rows->rises;
}

void fxl_horizon_choose(fxl_horizon_rows *rows, bool is_second)
{
    rows->is_second = is_second;
    rows->flip = 0;
    if (rows->rises == is_second) {
        rows->flip = -1;
    }
    rows->from = 0;
    rows->end = rows->columns;
    for (uint32_t i = 0; i < rows->count && !is_second; i++) {
        rows->turn[i] = (uint16_t)(rows->turns ? turn_of(rows, i) : rows->columns);
    }
    for (uint32_t i = 0; i < rows->count && rows->turns; i++) {
        const uint32_t from = fxl_horizon_from(rows, i), end = fxl_horizon_end(rows, i);
        rows->from = from > rows->from ? from : rows->from;
        rows->end = end < rows->end ? end : rows->end;
    }
}
