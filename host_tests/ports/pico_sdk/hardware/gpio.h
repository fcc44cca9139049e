/* SPDX-License-Identifier: MIT */
#ifndef PORTS_HARDWARE_GPIO_H
#define PORTS_HARDWARE_GPIO_H
#include "pico/stdlib.h"
#define GPIO_OUT true
typedef enum gpio_function {
    GPIO_FUNC_SPI = 1
} gpio_function_t;
void gpio_init(uint pin);
void gpio_set_dir(uint pin, bool is_output);
void gpio_put(uint pin, bool value);
void gpio_set_function(uint pin, gpio_function_t function);
#endif
