/* SPDX-License-Identifier: MIT */
#include "judge/outlined.h"

#include "reference/wire.h"

bool judge_is_on_outline(const ref_screen_polygon *polygon, int x, int y)
{
    for (int k = 0; k < polygon->count; k++) {
        const ref_screen_line line = {polygon->points[k], polygon->points[(k + 1) % polygon->count],
                                      polygon->colour};
        if (ref_wire_is_near(&line, x, y, 1)) {
            return true;
        }
    }
    return false;
}
