/* SPDX-License-Identifier: MIT */
/* The clippers of the view and of the world, with an account of what they worked out.
 * Internal. */
#ifndef FXL_COUNTED_H
#define FXL_COUNTED_H

#include "fixel/clip_record.h"
#include "fixel/clip_view.h"

/* fxl_clip_view_to_planes, and fxl_clip_to_frustum for a polygon of which no vertex lies
 * outside of other planes than those; account may be null. */
fxl_clip_result fxl_cut_view_by_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                       fxl_planes planes, fxl_clip_view_work *work,
                                       fxl_clip_account *account, const fxl_view_polygon **result);
fxl_clip_result fxl_cut_world_by_planes(const fxl_polygon *in, const fxl_frustum *frustum,
                                        unsigned planes, fxl_clip_work *work,
                                        fxl_clip_account *account, const fxl_polygon **result);

/* A plane measured and cut: crossings are the vertices of the result that are new. */
static inline void fxl_count_cut(fxl_clip_account *account, const fxl_q18_46 *distances,
                                 uint32_t measured, uint32_t left)
{
    if (account != NULL) {
        account->distances += measured;
        for (uint32_t i = 0; left > 0 && i < measured; i++) {
            left -= distances[i] >= 0;
        }
        account->intersections += left;
    }
}

#endif
