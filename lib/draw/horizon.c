/* SPDX-License-Identifier: MIT */
/* A sky and a ground in the place of the background (docs/extras/horizon.md).
 *
 * A row is a copy of the row above in which those pixels are filled that lie between the column
 * where its level changes and that of the row above. Rows of one colour are filled together. */
#include "../math/arith.h"
#include "../math/memory.h"
#include "../math/plane.h"
#include "../raster/columns.h"
#include "../raster/fill.h"
#include "../view/view.h"
#include "fixel/horizon.h"
#include "horizon_rows.h"
#include "renderer.h"
#include "submit.h"

#define COLUMNS (6 * FXL_HORIZON_MAX) /* that are found at once: of 2 rows of two pieces at least */
#define NARROW  8                     /* pixels: so few are stored one by one */

/* What is filled. */
typedef struct {
    const fxl_renderer *renderer;
    const fxl_band *band;
    uint8_t *pixels; /* of a row */
    uint32_t columns;
    fxl_pixel_kind kind;
    uint32_t first, rows; /* rows of one colour that are not filled yet */
    uint8_t colour;
} horizon_canvas;

/* horizon 1.2 */
static void fill_rows(horizon_canvas *canvas)
{
    const fxl_renderer *renderer = canvas->renderer;
    fxl_band part = *canvas->band;
    if (canvas->rows != 0) {
        part.pixels += fxl_pixel_bytes(canvas->kind, (size_t)canvas->first * part.stride);
        part.first_row = (uint16_t)(part.first_row + canvas->first);
        part.rows = (uint16_t)canvas->rows;
        canvas->rows = 0;
        renderer->target->fill(renderer, &part, canvas->colour);
    }
}

static void fill_columns(const horizon_canvas *canvas, uint32_t from, uint32_t end, uint8_t colour)
{
    if (canvas->kind.is_colour) {
        uint16_t *pixels = (uint16_t *)(void *)canvas->pixels;
        fxl_fill_row_rgb565(pixels + from, pixels + end, canvas->band->palette[colour]);
    } else {
        fxl_fill_row(canvas->pixels + from, canvas->pixels + end, colour * 0x01010101u);
    }
}

typedef struct __attribute__((may_alias)) {
    uint32_t words[16];
} horizon_words;

/* Copies the row above. */
static void copy_row(const horizon_canvas *canvas)
{
    const size_t stride = fxl_pixel_bytes(canvas->kind, canvas->band->stride);
    size_t left = fxl_pixel_bytes(canvas->kind, canvas->columns);
    uint8_t *to = canvas->pixels;
    const uint8_t *above = to - stride;
    if (fxl_is_aligned(to, sizeof(uint32_t)) && fxl_is_aligned(above, sizeof(uint32_t))) {
        for (; left >= sizeof(horizon_words); left -= sizeof(horizon_words)) {
            *(horizon_words *)(void *)to = *(const horizon_words *)(const void *)above;
            to += sizeof(horizon_words);
            above += sizeof(horizon_words);
        }
    }
    if (left > 0) {
        memcpy(to, above, left);
    }
}

/* The sines of a piece in the order in which it passes them from left to right, and the colours
 * before them. */
typedef struct {
    const fxl_q2_30 *sines;
    const uint8_t *colours;
    int32_t step; /* 1, or -1 if the level falls */
} horizon_order;

static inline fxl_q2_30 sine_of(const horizon_order *order, uint32_t number)
{
    return order->sines[(int32_t)number * order->step];
}

static inline uint8_t colour_of(const horizon_order *order, uint32_t number)
{
    return order->colours[(int32_t)number * order->step];
}

/* A piece of rows in which the level rises or falls throughout. A sine that it passes before its
 * first column is passed there, and one that it does not pass, at its end. */
typedef struct {
    uint32_t from, end;    /* its columns in the row above, */
    uint32_t begin, count; /* how many sines the first of these has passed, and the last; */
    fxl_horizon_change changes[FXL_HORIZON_MAX]; /* and where it passes those between */
    uint32_t first, last;                        /* the sines for which columns are found */
} horizon_piece;

static void set_piece(horizon_piece *piece, uint32_t from, uint32_t end, uint32_t count)
{
    piece->from = from;
    piece->end = end;
    piece->begin = count;
    piece->count = count;
}

/* Finds the columns of a piece of rows. For each sine, columns has that of the row above and those
 * of the rows. Returns where the next piece's begin. */
static uint16_t *find_piece(const fxl_horizon_rows *rows, const horizon_order *order,
                            uint32_t sines, horizon_piece *piece, uint16_t *columns)
{
    const uint32_t last = rows->count - 1, from = fxl_horizon_from(rows, last),
                   end = fxl_horizon_end(rows, last);
    uint32_t first = piece->begin, i;
    for (; first > 0 && !fxl_horizon_are_alike(rows, sine_of(order, first - 1), false); first--) {
        piece->changes[first - 1].column = (int16_t)piece->from;
        piece->changes[first - 1].step = 0;
    }
    for (i = first; i < sines; i++) {
        fxl_horizon_change *change = &piece->changes[i];
        if (i >= piece->count) {
            if (fxl_horizon_are_alike(rows, sine_of(order, i), true)) {
                break;
            }
            change->column = (int16_t)piece->end;
            change->step = 0;
        }
        *columns++ = (uint16_t)change->column;
        fxl_horizon_find(rows, sine_of(order, i), change, columns);
        columns += rows->count;
    }
    piece->first = first;
    piece->last = i;
    set_piece(piece, from, end, i);
    for (; first < i && piece->changes[first].column == (int32_t)from; first++) {
    }
    piece->begin = first;
    for (; piece->count > first && piece->changes[piece->count - 1].column == (int32_t)end;) {
        piece->count--;
    }
    return columns;
}

/* Fills what the piece of a row has otherwise than the row above. columns: that of the row above and
 * that of the row, for the first sine; those of the next are `size` farther. Returns the last of the
 * row. */
static uint32_t fill_piece(const horizon_canvas *canvas, const horizon_order *order,
                           const horizon_piece *piece, const uint16_t *columns, uint32_t size,
                           uint32_t from)
{
    const uint8_t *colour = order->colours + (int32_t)piece->first * order->step;
    const int32_t step = order->step;
    uint8_t *const pixels = canvas->pixels;
    const uint32_t most = canvas->kind.is_colour ? 0 : NARROW;
    for (uint32_t left = piece->last - piece->first; left > 0; left--) {
        const uint32_t was = columns[0], is = columns[1];
        uint32_t low = was > from ? was : from, high = is;
        uint8_t entry = *colour;
        colour += step;
        columns += size;
        if (is < was) {
            low = is;
            high = was;
            entry = *colour;
        }
        from = is;
        if (low >= high) {
            continue;
        }
        if (high - low > most) {
            fill_columns(canvas, low, high, entry);
        } else {
            uint8_t *pixel = pixels + low;
            const uint8_t *const end = pixels + high;
            do {
                *pixel++ = entry;
            } while (pixel != end);
        }
    }
    return from;
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

/* What a band is drawn with. */
typedef struct {
    horizon_canvas canvas;
    fxl_horizon_rows rows;
    horizon_order orders[2];
    horizon_piece pieces[2];
    uint16_t columns[COLUMNS];
    uint32_t sines, turn; /* turn: of the row above */
} horizon_drawing;

/* The first row, or one from which the pieces rise and fall the other way: what lies above says
 * nothing of it. As if the row above had the colour of this row's first column. */
static void begin_rows(horizon_drawing *drawing, const horizon_order *order)
{
    const uint32_t columns = drawing->rows.columns;
    uint32_t passed = 0;
    while (passed < drawing->sines &&
           fxl_horizon_has_passed(&drawing->rows, 0, 0, sine_of(order, passed))) {
        passed++;
    }
    fill_rows(&drawing->canvas);
    set_piece(&drawing->pieces[0], 0, columns, passed);
    set_piece(&drawing->pieces[1], columns, columns, 0);
    drawing->turn = columns;
}

/* How many sines a piece of a row has passed before a column, of which columns are found. */
static uint32_t passed_before(const horizon_piece *piece, const uint16_t *columns, uint32_t size,
                              uint32_t column)
{
    uint32_t passed = piece->first;
    for (; passed < piece->last && columns[1] < column; passed++) {
        columns += size;
    }
    return passed;
}

/* One row, as the row above but for what the columns of its pieces say. Where it turns elsewhere,
 * what lies between has the level of the first piece's end, or that of the second one's beginning. */
static void fill_row(horizon_drawing *drawing, const uint16_t *second, uint32_t number)
{
    const fxl_horizon_rows *rows = &drawing->rows;
    const horizon_canvas *canvas = &drawing->canvas;
    const horizon_piece *pieces = drawing->pieces;
    const horizon_order *order = &drawing->orders[!rows->rises],
                        *other = &drawing->orders[rows->rises];
    const uint32_t size = rows->count + 1, turn = rows->turn[number], was = drawing->turn;
    const uint16_t *columns = drawing->columns + number;
    uint32_t low = fill_piece(canvas, order, &pieces[0], columns, size, 0);
    second += number;
    if (turn > was) {
        low = low > was ? low : was;
        fill_columns(canvas, low, turn,
                     colour_of(order, passed_before(&pieces[0], columns, size, turn)));
    } else if (turn < was) {
        fill_columns(canvas, turn, was,
                     colour_of(other, passed_before(&pieces[1], second, size, turn + 1)));
    }
    drawing->turn = turn;
    if (turn < rows->columns) {
        (void)fill_piece(canvas, other, &pieces[1], second, size, turn);
    }
}

static void draw_rows(horizon_drawing *drawing, uint32_t first, bool is_fresh)
{
    fxl_horizon_rows *rows = &drawing->rows;
    horizon_canvas *canvas = &drawing->canvas;
    horizon_piece *pieces = drawing->pieces;
    const horizon_order *order = &drawing->orders[!rows->rises];
    const size_t stride = fxl_pixel_bytes(canvas->kind, canvas->band->stride);
    const uint32_t sines = drawing->sines;
    fxl_horizon_choose(rows, false);
    if (is_fresh) {
        begin_rows(drawing, order);
    }
    const uint32_t before = pieces[0].count;
    const uint8_t colour = colour_of(order, before);
    uint16_t *const second = find_piece(rows, order, sines, &pieces[0], drawing->columns);
    bool is_plain = pieces[0].first == pieces[0].last;
    if (rows->turns) {
        if (pieces[1].from == rows->columns) {
            set_piece(&pieces[1], rows->columns, rows->columns, sines - before);
        }
        fxl_horizon_choose(rows, true);
        (void)find_piece(rows, &drawing->orders[rows->rises], sines, &pieces[1], second);
        is_plain = is_plain && pieces[1].first == pieces[1].last &&
                   pieces[0].count + pieces[1].begin == sines;
    } else if (pieces[1].from != rows->columns) {
        is_plain = is_plain && pieces[1].begin == pieces[1].count &&
                   pieces[0].count + pieces[1].begin == sines;
        set_piece(&pieces[1], rows->columns, rows->columns, 0);
    }
    if (is_plain) {
        if (canvas->rows == 0) {
            canvas->first = first;
            canvas->colour = colour;
        }
        canvas->rows += rows->count;
        canvas->pixels += rows->count * stride;
        drawing->turn = rows->turn[rows->count - 1];
        return;
    }
    fill_rows(canvas);
    for (uint32_t i = 0; i < rows->count; i++) {
        if (is_fresh && i == 0) {
            fill_columns(canvas, 0, rows->columns, colour);
        } else {
            copy_row(canvas);
        }
        fill_row(drawing, second, i);
        canvas->pixels += stride;
    }
}

/* horizon 1.1, 1.4, 1.5 */
static void fill_horizon(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour)
{
    const fxl_view *view = &renderer->frame.view;
    const fxl_lens *lens = &view->lens;
    const fxl_axes *axes = &view->camera.axes;
    const fxl_horizon *horizon = renderer->horizon;
    const uint32_t sines = horizon->count, most = COLUMNS / sines - 1;
    const horizon_canvas canvas = {.renderer = renderer,
                                   .band = band,
                                   .pixels = band->pixels,
                                   .columns = fxl_band_columns(band),
                                   .kind = fxl_kind_of_band(band)};
    const horizon_order rising = {horizon->sines, horizon->colours, 1};
    const horizon_order falling = {horizon->sines + sines - 1, horizon->colours + sines, -1};
    horizon_drawing drawing;
    fxl_horizon_rows *rows = &drawing.rows;
    (void)colour;
    drawing.canvas = canvas;
    drawing.orders[0] = rising;
    drawing.orders[1] = falling;
    drawing.sines = sines;
    rows->lens = lens;
    rows->right = axes->right.y;
    rows->up = axes->up.y;
    rows->forward = axes->forward.y;
    rows->columns = canvas.columns;
    rows->rises = false;
    if (lens->off_centre != NULL) {
        rows->right =
            before_shear(rows->right, rows->forward, lens->centre_x - lens->width * 32768, view);
        rows->up =
            before_shear(rows->up, rows->forward, lens->height * 32768 - lens->centre_y, view);
    }
    /* place fill-rule: the ray through the centre of a pixel */
    rows->first_x = band->first_column * 65536 + 32768 - lens->centre_x;
    const int32_t y = lens->centre_y - band->first_row * 65536 - 32768;
    for (uint32_t number = 0; number < band->rows; number += rows->count) {
        const uint32_t left = band->rows - number;
        uint32_t count = most < FXL_HORIZON_ROWS ? most : FXL_HORIZON_ROWS;
        const bool rose = rows->rises;
        count = count < left ? count : left;
        fxl_horizon_take(rows, y - (int32_t)number * 65536, count);
        if (rows->turns && rows->count > COLUMNS / (2 * sines) - 1) {
            rows->count = COLUMNS / (2 * sines) - 1;
        }
        draw_rows(&drawing, number, number == 0 || rows->rises != rose);
    }
    fill_rows(&drawing.canvas);
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
