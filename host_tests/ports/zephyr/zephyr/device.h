/* SPDX-License-Identifier: MIT */
/* Declarations of what ports/zephyr calls, after the API documentation of Zephyr 3 and 4. */
#ifndef PORTS_ZEPHYR_DEVICE_H
#define PORTS_ZEPHYR_DEVICE_H
#include <stdbool.h>
#include <stdint.h>
struct device {
    const char *name;
};
extern const struct device ports_display;
#define DT_CHOSEN(name)     name
#define DEVICE_DT_GET(node) (&ports_display)
bool device_is_ready(const struct device *device);
#endif
