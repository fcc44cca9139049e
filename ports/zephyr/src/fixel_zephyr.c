/* SPDX-License-Identifier: MIT */
#include "fixel_zephyr.h"

#include <zephyr/drivers/display.h>

/* display_write returns when the bytes are sent or copied. */
static bool start(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes, size_t size)
{
    const fixel_zephyr *zephyr = user;
    const struct display_buffer_descriptor band = {.buf_size = (uint32_t)size, .width = zephyr->width, .height = rows, .pitch = zephyr->width};

    return display_write(zephyr->display, 0, first_row, &band, bytes) == 0;
}

static bool wait(void *user)
{
    (void)user;
    return true;
}

bool fixel_zephyr_open(fixel_zephyr *zephyr, const struct device *display, uint16_t width)
{
    zephyr->sink.user = zephyr;
    zephyr->sink.start = start;
    zephyr->sink.wait = wait;
    zephyr->display = display;
    zephyr->width = width;
    return device_is_ready(display) && display_set_pixel_format(display, PIXEL_FORMAT_RGB_565) == 0 && display_blanking_off(display) == 0;
}
