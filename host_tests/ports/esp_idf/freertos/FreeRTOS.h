/* SPDX-License-Identifier: MIT */
#ifndef PORTS_FREERTOS_H
#define PORTS_FREERTOS_H
#include <stdint.h>
typedef int BaseType_t;
typedef uint32_t TickType_t;
#define pdFALSE       0
#define pdTRUE        1
#define portMAX_DELAY 0xFFFFFFFFu
#define configTICK_RATE_HZ ((TickType_t)100)
#define pdMS_TO_TICKS(milliseconds) \
    ((TickType_t)((uint64_t)(milliseconds) * configTICK_RATE_HZ / 1000u))
#endif
