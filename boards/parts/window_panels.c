/* SPDX-License-Identifier: MIT */
/* The panels of a board without a display of its own: the window where a viewer
 * waits, else a frame dump. */
#include <stddef.h>

#include "parts/dump.h"
#include "parts/window.h"

const panel *const *board_panels(void)
{
    static const panel *const alone[] = {&dump_panel, NULL};
    static const panel *const watched[] = {&window_panel, NULL};

    return window_invited() ? watched : alone;
}
