/* SPDX-License-Identifier: MIT */
/* A pump: draws a frame in bands, and sends each band while the next one is drawn.
 *
 *   band()  the band to draw, in memory that is not being sent
 *   send()  converts it into the free one of two buffers, waits for the other, starts the transfer
 *
 * So at most one transfer is under way, and nothing reads or writes the bytes that it sends. */
#ifndef FXL_PUMP_H
#define FXL_PUMP_H

#include "fixel/changed.h"
#include "fixel/pixels.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where the bytes go: a display of fixel/display.h, or functions of the caller's. Each
 * returns false where the transfer failed. */
typedef struct {
    void *user; /* handed to both functions */

    /* Begins to send rows first_row .. first_row + rows - 1 of the frame, and may return before
     * they are sent. The bytes stay as they are until wait has returned. Never called while
     * a transfer is under way. */
    bool (*start)(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes, size_t size);

    /* Returns when nothing is being sent. Called also where nothing was started. */
    bool (*wait)(void *user);

    /* Begins to send a box of the frame that has some of the columns, as start sends rows. Null: the
     * sink takes whole rows alone, by start. */
    bool (*start_box)(void *user, const fxl_screen_box *box, const uint8_t *bytes, size_t size);

    /* A box begins and ends with multiples of columns_less_1 + 1 columns, which are 1, 2, 4 or 8, or
     * it ends with the frame. Of 16 greys and of rows of one bit a byte has 2 and 8 pixels. */
    uint8_t columns_less_1;
} fxl_pump_sink;

/* What a pump sends, and in which pieces. */
typedef struct {
    const fxl_pixels *pixels; /* the format; null sends bands as they are drawn */
    uint16_t width, height;   /* of the frame, 1..FXL_SCREEN_MAX */
    uint16_t rows;            /* of a band, 1..height; with pages a multiple of 8 */
    const uint16_t *palette;  /* null: bands are palette indices, one byte a pixel; else they are
                                 RGB565, and these are the colours of the renderer and of what is
                                 drawn over */
} fxl_pump_config;

/* uint64_t of memory for a pump: for bands of rows of width pixels, sent in so many bits a pixel
 * (16 for RGB565, 0 where they are sent as they are drawn). A constant expression. For formats of
 * fewer than 8 bits width must be a multiple of 8; fxl_pump_memory_size serves every width. */
#define FXL_PUMP_MEMORY(width, rows, bits)        FXL_PUMP_MEMORY_OF(width, rows, bits, 1)
#define FXL_PUMP_MEMORY_RGB565(width, rows, bits) FXL_PUMP_MEMORY_OF(width, rows, bits, 2)

/* The same; drawn: bytes of a pixel as it is drawn, 1 or 2. */
#define FXL_PUMP_MEMORY_OF(width, rows, bits, drawn) \
    (((width) * (rows) * (drawn) + 7) / 8 + 2 * (((width) * (rows) * (bits) + 63) / 64) + \
     ((bits) == 0 ? ((width) * (rows) * (drawn) + 7) / 8 : 0))

/* A pump, which the caller owns. Members are for reading only. */
typedef struct {
    fxl_pump_config config;
    fxl_pump_sink sink;
    fxl_band band;       /* what is drawn next; no rows: the frame is done */
    uint8_t *buffers[2]; /* sent in turn; without a format they are the bands */
    size_t buffer_size;
    uint16_t end_row;    /* of the frame, or of the box that is drawn */
    uint8_t free_buffer; /* 0 or 1: the other one may be on its way */
    bool is_begun;       /* a frame has begun, and nothing has failed */
} fxl_pump;

/* Bytes of memory that a pump needs, or 0 where the configuration is null or out of range. Pixels
 * that fxl_pixels_init did not prepare, all of whose bytes are 0, are out of range. */
size_t fxl_pump_memory_size(const fxl_pump_config *config);

/* Sets up a pump in memory of the caller's, aligned to 8 bytes; the pump keeps the pointers to it
 * and to the pixels, and copies the sink.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ALIGNMENT: memory is not aligned to 8 bytes, or config->palette to 2.
 * FXL_E_RANGE: a member of config is out of range.
 * FXL_E_CAPACITY: memory_size is too small.
 * With each of these statuses: *pump untouched. */
fxl_status fxl_pump_init(fxl_pump *pump, const fxl_pump_config *config, const fxl_pump_sink *sink,
                         void *memory, size_t memory_size);

/* Draws a frame and sends it: fxl_frame_begin, and for each band the clear to the
 * renderer's background, fxl_frame_draw and fxl_pump_send. When it returns, the last band may still
 * be on its way: the next frame waits for it, as does fxl_pump_wait.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: a screen of another size than the pump's.
 * FXL_E_COMBINATION: a renderer of RGB565 and a pump of palette indices, or the other way round.
 * The statuses of fxl_frame_begin.
 * With each of these statuses: nothing was sent; with those of fxl_frame_begin the frame before
 * ends where it says so.
 * FXL_E_DISPLAY: the display failed; a part of the frame was sent, and the frame ends here.
 * The statuses of fxl_frame_draw and fxl_pump_send: the bands before the refused one were sent. */
fxl_status fxl_pump_frame(fxl_pump *pump, fxl_renderer *renderer, const fxl_pose *eye);

/* Draws what changed since the frame before and sends it: fxl_frame_begin, fxl_changed_find,
 * fxl_pump_widen, and for each box its bands, as fxl_pump_frame does. A display that shows the frame
 * before then shows this one. Where nothing changed, nothing is sent.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: a screen of another size than the pump's.
 * FXL_E_COMBINATION: a renderer of RGB565 and a pump of palette indices, or the other way round.
 * The statuses of fxl_frame_begin and fxl_changed_find.
 * With each of these statuses: nothing was sent; with those of fxl_frame_begin the frame before
 * ends where it says so.
 * FXL_E_DISPLAY: the display failed; a part of the frame was sent, and the frame ends here. The next
 * call draws and sends the whole frame.
 * The statuses of fxl_frame_draw and fxl_pump_send: the bands before the refused one were sent; the
 * next call draws and sends the whole frame. */
fxl_status fxl_pump_changed(fxl_pump *pump, fxl_renderer *renderer, const fxl_pose *eye,
                            fxl_changed *changed);

/* fxl_changed_widen to what a pump sends: fxl_pump_steps.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the pump was never set up, or fxl_changed_find has found nothing yet.
 * With each of these statuses: *changed untouched. */
fxl_status fxl_pump_widen(const fxl_pump *pump, fxl_changed *changed);

/* --- the same step by step, to draw more into a band -------------------------------------------
 */

/* Begins a frame at its first row, whether or not the frame before was finished.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the pump was never set up: it is all zeros.
 * With each of these statuses: nothing happens. */
fxl_status fxl_pump_begin(fxl_pump *pump);

/* Begins a box of a frame: fxl_pump_band then has the bands of the box, with its columns alone.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the pump was never set up: it is all zeros.
 * FXL_E_RANGE: a box without pixels or beyond the frame; or one that does not begin and end as fxl_pump_steps
 * says.
 * With each of these statuses: nothing happens. */
fxl_status fxl_pump_begin_box(fxl_pump *pump, const fxl_screen_box *box);

/* How the boxes that a pump sends begin and end: with multiples of *columns and *rows, or with the
 * frame's end. *columns 0: with whole rows. Requires a pump that fxl_pump_init set up. */
void fxl_pump_steps(const fxl_pump *pump, uint32_t *columns, uint32_t *rows);

/* Returns the band to draw next, whose pixels are those of an earlier band. Null after the last
 * band of a frame or of a box, before the first frame, and after a failure, and for null. */
const fxl_band *fxl_pump_band(const fxl_pump *pump);

/* Converts the band of fxl_pump_band, waits for the transfer before, and starts to send. Then
 * fxl_pump_band has the next band.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: there is no band.
 * The statuses of fxl_pixels_convert, if the prepared pixels were changed after fxl_pump_init.
 * With each of these statuses: nothing is sent, and the band stays the next one.
 * FXL_E_DISPLAY: the transfer before failed, or this one did not start; the frame ends here. */
fxl_status fxl_pump_send(fxl_pump *pump);

/* Sends rows that lie elsewhere, or some columns of them, as fxl_pump_send does: of the pump's width,
 * and at most as many rows as its bands have. Columns begin and end as fxl_pump_steps says. Their
 * pixels may change as soon as it returns. It neither needs a frame nor changes which band is next;
 * without a format that band's pixels are lost.
 * FXL_E_ARGUMENT: a null pointer, no rows.
 * FXL_E_RANGE: another width, columns that the pump does not send, too many rows, rows beyond the
 * frame, the ranges of fxl_pixels_convert.
 * FXL_E_COMBINATION: a pump without a format, whose bands are RGB565 and the rows palette indices,
 * or the other way round.
 * FXL_E_ALIGNMENT: that of fxl_pixels_convert.
 * With each of these statuses: nothing happens.
 * FXL_E_DISPLAY: as with fxl_pump_send. */
fxl_status fxl_pump_send_rows(fxl_pump *pump, const fxl_band *rows);

/* Returns when nothing is being sent.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the pump was never set up: it is all zeros.
 * With each of these statuses: nothing happens.
 * FXL_E_DISPLAY: the last transfer failed. */
fxl_status fxl_pump_wait(fxl_pump *pump);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_pump_reasons[];

#ifdef __cplusplus
}
#endif

#endif
