/* SPDX-License-Identifier: MIT */
#include "parts/stack.h"

#include "parts/cortexm.h"
#include "parts/semihosting.h"

#define MARGIN_WORDS 8u /* what a core pushes when it enters a handler */

/* Returns the bytes between the lowest word that is not paint and the end. */
static uint32_t used(const uint32_t *first, const uint32_t *end)
{
    while (first < end && *first == (uint32_t)STACK_PAINT) {
        first++;
    }
    return (uint32_t)(end - first) * (uint32_t)sizeof *first;
}

static uint32_t size(const uint32_t *first, const uint32_t *end)
{
    return (uint32_t)(end - first) * (uint32_t)sizeof *first;
}

uint32_t stack_deepest(void)
{
    return used(fxl_stack_limit, fxl_stack_top);
}

bool stack_is_spent(void)
{
    return used(fxl_stack_limit, fxl_stack_limit + MARGIN_WORDS) != 0;
}

void stack_print(void)
{
    semihosting_text("stack: ");
    semihosting_decimal(stack_deepest());
    semihosting_text(" of ");
    semihosting_decimal(size(fxl_stack_limit, fxl_stack_top));
    semihosting_text(" bytes; handlers: ");
    semihosting_decimal(used(fxl_stack_top, fxl_handler_stack_top));
    semihosting_text(" of ");
    semihosting_decimal(size(fxl_stack_top, fxl_handler_stack_top));
    semihosting_text(" bytes\n");
}
