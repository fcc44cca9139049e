/* SPDX-License-Identifier: MIT */
/* What a board does where its board.c does not say otherwise: how it starts, which panels it has,
 * where the scene is; and where it shares memory with the live window, whose keys it reads and how
 * it sleeps between the frames. */
#include <stddef.h>

#include "contract/input.h"
#include "contract/store.h"
#include "parts/cortexm.h"
#include "parts/dump.h"
#include "parts/systick.h"
#include "parts/window.h"

#ifdef BOARD_SYSTICK_HZ
__attribute__((weak)) void board_start(void)
{
    systick_start(SYSTICK_RELOAD_MAX);
}
#endif

/* store.h: a partition of the flash (linker/sections.ld). */
const void *store_scene(size_t *size)
{
    *size = (size_t)(uintptr_t)fxl_scene_size;
    return fxl_scene_base;
}

#ifdef BOARD_HAS_WINDOW

#define NAPS_PER_SECOND 1000u

uint32_t input_keys(void)
{
    return window_keys();
}

void window_nap(void)
{
    systick_nap(BOARD_SYSTICK_HZ / NAPS_PER_SECOND);
}

/* The window where a viewer waits, else a frame dump. */
__attribute__((weak)) const panel *const *board_panels(void)
{
    static const panel *const alone[] = {&dump_panel, NULL};
    static const panel *const watched[] = {&window_panel, NULL};

    return window_invited() ? watched : alone;
}

#else

__attribute__((weak)) const panel *const *board_panels(void)
{
    static const panel *const panels[] = {&dump_panel, NULL};

    return panels;
}

#endif
