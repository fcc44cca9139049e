/* SPDX-License-Identifier: MIT */
/* The board of a program in a page, but for its frames: text for people, and how it ended. */
#include "page.h"

#include <stddef.h>

#include "contract/clock.h"
#include "contract/system.h"

#define PAGE_BYTES 65536u
#define TEXT_BYTES 1024u

extern uint8_t __heap_base; /* the linker's */

static struct {
    char text[TEXT_BYTES];
    uint32_t bytes;
    int status; /* of system_exit */
} said;

uint8_t *page_heap(void)
{
    return &__heap_base + (-(uintptr_t)&__heap_base & 7u);
}

bool page_reach(const uint8_t *end)
{
    const size_t held = __builtin_wasm_memory_size(0), pages = ((size_t)end + PAGE_BYTES - 1u) / PAGE_BYTES;

    return pages <= held || __builtin_wasm_memory_grow(0, pages - held) != SIZE_MAX;
}

void page_says_nothing(void)
{
    said.bytes = 0;
}

/* What was said: its bytes, and how many. */
EXPORTED("said") const char *what_was_said(void)
{
    return said.text;
}

EXPORTED("said_bytes") uint32_t how_much_was_said(void)
{
    return said.bytes;
}

/* The status with which the program ended; 0: it did not. */
EXPORTED("status") int how_it_ended(void)
{
    return said.status;
}

void system_start(int argc, char **argv)
{
    (void)argc;
    (void)argv;
}

void system_alive(void)
{
}

void system_text(const char *text)
{
    while (*text != '\0' && said.bytes < TEXT_BYTES) {
        said.text[said.bytes++] = *text++;
    }
}

/* The host sees a trap. */
void system_exit(int status)
{
    said.status = status;
    __builtin_trap();
}

uint64_t clock_instructions(void)
{
    return 0;
}
