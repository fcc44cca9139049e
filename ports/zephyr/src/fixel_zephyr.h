/* SPDX-License-Identifier: MIT */
/* A display of Zephyr's display API, of 16 bits a pixel, as the sink of a pump. */
#ifndef FIXEL_ZEPHYR_H
#define FIXEL_ZEPHYR_H

#include <fixel/pump.h>
#include <zephyr/device.h>

/* Which the caller owns. Members are for reading only. */
typedef struct {
    fxl_pump_sink sink;
    const struct device *display;
    uint16_t width;
} fixel_zephyr;

/* Sets a sink up for frames that are width pixels wide, and turns the display on. Returns false if the display is not ready, or
 * refused something. */
bool fixel_zephyr_open(fixel_zephyr *zephyr, const struct device *display, uint16_t width);

#endif
