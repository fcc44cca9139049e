/* SPDX-License-Identifier: MIT */
#ifndef PORTS_ZEPHYR_DISPLAY_H
#define PORTS_ZEPHYR_DISPLAY_H
#include <zephyr/device.h>
enum display_pixel_format {
    PIXEL_FORMAT_RGB_565 = 1 << 4
};
struct display_buffer_descriptor {
    uint32_t buf_size;
    uint16_t width, height, pitch;
};
int display_write(const struct device *display, uint16_t x, uint16_t y,
                  const struct display_buffer_descriptor *descriptor, const void *bytes);
int display_set_pixel_format(const struct device *display, enum display_pixel_format format);
int display_blanking_off(const struct device *display);
#endif
