/* SPDX-License-Identifier: MIT */
#ifndef PORTS_SEMPHR_H
#define PORTS_SEMPHR_H
#include "freertos/FreeRTOS.h"
typedef struct ports_semaphore *SemaphoreHandle_t;
SemaphoreHandle_t xSemaphoreCreateBinary(void);
BaseType_t xSemaphoreTake(SemaphoreHandle_t semaphore, TickType_t ticks);
BaseType_t xSemaphoreGiveFromISR(SemaphoreHandle_t semaphore, BaseType_t *is_woken);
#endif
