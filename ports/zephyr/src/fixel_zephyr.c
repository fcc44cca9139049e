/* SPDX-License-Identifier: MIT */
#include "fixel_zephyr.h"

#include <zephyr/drivers/display.h>

/* display_write returns when the bytes are sent or copied. */
static bool start_box(void *user, const fxl_screen_box *box, const uint8_t *bytes, size_t size)
{
    const fixel_zephyr *zephyr = user;
    const struct display_buffer_descriptor band = {
        .buf_size = (uint32_t)size, .width = box->columns, .height = box->rows, .pitch = box->columns};

    return display_write(zephyr->display, box->first_column, box->first_row, &band, bytes) == 0;
}

static bool start(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes, size_t size)
{
    const fxl_screen_box box = {0, ((const fixel_zephyr *)user)->width, first_row, rows};

    return start_box(user, &box, bytes, size);
}

static bool wait(void *user)
{
    (void)user;
    return true;
}

bool fixel_zephyr_open(fixel_zephyr *zephyr, const struct device *display, uint16_t width)
{
    zephyr->sink = (fxl_pump_sink){.user = zephyr, .start = start, .wait = wait, .start_box = start_box};
    zephyr->display = display;
    zephyr->width = width;
    return device_is_ready(display) && display_set_pixel_format(display, PIXEL_FORMAT_RGB_565) == 0 && display_blanking_off(display) == 0;
}
