/* SPDX-License-Identifier: MIT */
/* A WebAssembly module as a board. It imports nothing: its host, webassembly.mjs, writes the scene image
 * into the module's memory, calls run, and reads the outcome. */
#include <stddef.h>

#include "contract/clock.h"
#include "contract/input.h"
#include "contract/panel.h"
#include "contract/store.h"
#include "contract/system.h"
#include "parts/dump.h"

#define EXPORTED(name) __attribute__((export_name(name)))
#define PAGE_BYTES     65536u
#define MEMORY_BYTES   0x80000000u
#define TEXT_BYTES     1024u

extern uint8_t __heap_base; /* the linker's: behind data and stack */
int main(int argc, char **argv);

static const uint8_t *scene;
static size_t scene_bytes;
static uint8_t *top = &__heap_base; /* the scene, the dump behind it */

/* The host reads it as words, in this order. */
static struct {
    int status; /* of system.h; 0: the program has not ended */
    const uint8_t *dump;
    size_t dump_bytes;
    const char *text;
    size_t text_bytes;
} outcome;

/* Null: the memory has no room for so many bytes. */
static uint8_t *taken(size_t size)
{
    uint8_t *const first = top;
    const size_t held = __builtin_wasm_memory_size(0);
    size_t pages;

    if (size > MEMORY_BYTES - (size_t)first) { /* top stays at MEMORY_BYTES or below */
        return NULL;
    }
    pages = ((size_t)first + size + PAGE_BYTES - 1u) / PAGE_BYTES;
    if (pages > held && __builtin_wasm_memory_grow(0, pages - held) == SIZE_MAX) {
        return NULL;
    }
    top += size;
    return first;
}

/* Before run: where the host writes the scene image. */
EXPORTED("scene") uint8_t *scene_room(size_t size)
{
    uint8_t *const room = taken(size);

    scene = room;
    scene_bytes = size;
    return room;
}

/* Ends with a trap. */
EXPORTED("run") void run(void)
{
    (void)main(0, NULL);
}

EXPORTED("outcome") const void *outcome_of_the_run(void)
{
    return &outcome;
}

void system_start(int argc, char **argv)
{
    (void)argc;
    (void)argv;
}

uint32_t system_frames(void)
{
    return 0;
}

bool system_live(void)
{
    return false;
}

void system_alive(void)
{
}

/* The first TEXT_BYTES. */
void system_text(const char *text)
{
    static char said[TEXT_BYTES];

    outcome.text = said;
    while (*text != '\0' && outcome.text_bytes < TEXT_BYTES) {
        said[outcome.text_bytes++] = *text++;
    }
}

void system_exit(int status)
{
    outcome.status = status;
    __builtin_trap();
}

const void *store_scene(size_t *size)
{
    *size = scene != NULL ? scene_bytes : 0;
    return scene;
}

const panel *const *board_panels(void)
{
    static const panel *const panels[] = {&dump_panel, NULL};

    return panels;
}

bool sink_open(void)
{
    outcome.dump = top;
    return true;
}

bool sink_write(const void *bytes, size_t size)
{
    const uint8_t *from = bytes;
    uint8_t *to = taken(size);
    size_t i;

    for (i = 0; to != NULL && i < size; i++) {
        to[i] = from[i];
    }
    return to != NULL;
}

bool sink_close(bool whole)
{
    outcome.dump_bytes = whole ? (size_t)(top - outcome.dump) : 0;
    return true;
}

uint64_t clock_instructions(void)
{
    return 0;
}

uint32_t input_keys(void)
{
    return 0;
}
