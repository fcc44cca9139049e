/* SPDX-License-Identifier: MIT */
/* What ports/zephyr calls, as a diary. */
#include <stdio.h>
#include <stdlib.h>

#include "diary.h"
#include "zephyr/drivers/display.h"

const struct device ports_display = {"display"};
static bool is_asked, has_format, is_on;

static void require(bool holds, const char *sentence)
{
    if (!holds) {
        printf("fault %s\n", sentence);
        exit(1);
    }
}

bool device_is_ready(const struct device *device)
{
    is_asked = device == &ports_display;
    return is_asked;
}

int display_set_pixel_format(const struct device *display, enum display_pixel_format format)
{
    require(is_asked && display == &ports_display, "the display may not be ready");
    has_format = format == PIXEL_FORMAT_RGB_565;
    return 0;
}

int display_blanking_off(const struct device *display)
{
    is_on = display == &ports_display;
    return 0;
}

int display_write(const struct device *display, uint16_t x, uint16_t y,
                  const struct display_buffer_descriptor *descriptor, const void *bytes)
{
    require(display == &ports_display && has_format && is_on, "the display is off");
    require(descriptor->pitch == descriptor->width &&
                descriptor->buf_size == 2u * descriptor->width * descriptor->height,
            "the descriptor");
    printf("window %d %d %d %d\n", x, y, x + descriptor->width, y + descriptor->height);
    diary_bytes(bytes, descriptor->buf_size);
    return diary_fails() ? -5 : 0; /* EIO */
}
