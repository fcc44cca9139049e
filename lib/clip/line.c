/* SPDX-License-Identifier: MIT */
#include "fixel/line.h"
#include "volume.h"

#include "intersection.h"

/* Moves the outside end onto the plane, along the line from the inside end. */
static void move(const fxl_varying_vertex *inside, fxl_varying_vertex *outside, fxl_q18_46 in,
                 fxl_q18_46 out, uint32_t carried, uint32_t *intersections)
{
    fxl_varying_vertex intersection;
    fxl_intersection_vertex(inside, outside, fxl_intersection_fraction(in, out), carried,
                            &intersection);
    fxl_copy_vertex(&intersection, carried, outside);
    *intersections += 1;
}

bool fxl_line_by_planes(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections)
{
    for (uint32_t i = 0; i < FXL_PLANE_COUNT; i++) {
        fxl_q18_46 from = fxl_half_space_distance(&volume->planes[i], &line->from.position);
        fxl_q18_46 to = fxl_half_space_distance(&volume->planes[i], &line->to.position);
        if (from < 0 && to < 0) {
            return false;
        }
        if (from < 0) {
            move(&line->to, &line->from, to, from, line->carried, intersections);
        } else if (to < 0) {
            move(&line->from, &line->to, from, to, line->carried, intersections);
        }
    }
    return true;
}

/* Each end is moved to a plane at most once. Rounding may leave it a unit outside of that plane;
 * it is not moved there again. So there are at most twelve moves. */
bool fxl_line_by_codes(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections)
{
    uint32_t from_moved = 0, to_moved = 0;
    for (;;) {
        uint32_t from_code = fxl_volume_code(volume, &line->from.position) & ~from_moved;
        uint32_t to_code = fxl_volume_code(volume, &line->to.position) & ~to_moved;
        if ((from_code & to_code) != 0) {
            return false;
        }
        if ((from_code | to_code) == 0) {
            return true;
        }
        bool moves_from = from_code != 0;
        uint32_t plane = 0;
        while (((moves_from ? from_code : to_code) >> plane & 1u) == 0) {
            plane++;
        }
        const fxl_half_space *at = &volume->planes[plane];
        fxl_q18_46 from = fxl_half_space_distance(at, &line->from.position);
        fxl_q18_46 to = fxl_half_space_distance(at, &line->to.position);
        if (from < 0 && to < 0) { /* one of them is outside by rounding */
            return false;
        }
        if (moves_from) {
            move(&line->to, &line->from, to, from, line->carried, intersections);
            from_moved |= (uint32_t)1 << plane;
        } else {
            move(&line->from, &line->to, from, to, line->carried, intersections);
            to_moved |= (uint32_t)1 << plane;
        }
    }
}
