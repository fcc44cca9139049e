/* SPDX-License-Identifier: MIT */
#include "../math/plane.h"
#include "scene_check.h"
#include "fixel/scene.h"

#include "../math/arith.h"
#include "../math/memory.h"

/* How exactly the side of a plane on which a window's corner lies is known, in units of 2^-46. A
 * normal's error of 2 units in each of three components, times a difference below 2^30, is below
 * 2^33. */
#define CORNER_TOLERANCE ((int64_t)1 << 34)

fxl_plane fxl_beam_plane_at(const fxl_beam *beam, uint32_t number)
{
    FXL_ASSERT(number < beam->plane_count);
    const fxl_beam_plane *stored = &beam->planes[number];
    fxl_plane plane = {stored->normal,
                       fxl_signed_64((uint64_t)stored->distance_high << 32 | stored->distance_low)};
    return plane;
}

static fxl_direction direction_of(const fxl_beam *beam)
{
    fxl_direction travel = {beam->from[0], beam->from[1], beam->from[2]};
    return travel;
}

/* beams 1.4 */
bool fxl_beam_shines_on(const fxl_beam *beam, const fxl_point *vertex, const fxl_direction *normal)
{
    if (beam->kind == FXL_BEAM_DIRECTION) {
        /* Unit vectors: the sum is below 2^61. */
        return fxl_dot(normal, beam->from[0], beam->from[1], beam->from[2]) < 0;
    }
    return fxl_dot(normal, beam->from[0] - vertex->x, beam->from[1] - vertex->y,
                   beam->from[2] - vertex->z) > 0;
}

/* A normal is at most 1 + 2^-29 long. So the distance of a vertex at the radius differs by at
 * most radius + 2^-14 from that of the centre: 28375 * 2^-29 < 2^-14. */
/* beams 2.2 */
bool fxl_beam_reaches(const fxl_beam *beam, const fxl_point *centre, fxl_q16_16 radius)
{
    const int64_t reach = ((int64_t)radius + 4) * FXL_Q2_30_ONE; /* below 2^62 */
    for (uint32_t i = 0; i < beam->plane_count; i++) {
        const fxl_plane plane = fxl_beam_plane_at(beam, i);
        if (fxl_plane_distance(&plane, centre) < -reach) {
            return false;
        }
    }
    return true;
}

static uint32_t planes_from(const fxl_beam *beams, uint32_t first, uint32_t beam_count)
{
    uint32_t planes = 0;
    for (uint32_t i = first; i < beam_count; i++) {
        planes += beams[i].plane_count;
    }
    return planes;
}

/* Each corner of a piece is a corner of the face, or lies where a plane's line meets the border
 * of a convex part; it meets that twice. Each plane of the first beam cuts the part that the
 * plane before left, and gives each part one corner more than it takes. */
/* beams 4.3 */
FXL_COLD bool fxl_beams_fit(const fxl_beam *beams, uint32_t beam_count, uint32_t face_vertices)
{
    return face_vertices + planes_from(beams, 0, beam_count) + planes_from(beams, 1, beam_count) <=
           FXL_FACE_VERTICES_MAX;
}

/* --- a beam as a table ------------------------------------------------------- */

static bool is_unused(const fxl_beam_plane *plane)
{
    return plane->normal.x == 0 && plane->normal.y == 0 && plane->normal.z == 0 &&
           plane->distance_low == 0 && plane->distance_high == 0;
}

/* beams 1.1 */
FXL_COLD fxl_status fxl_beam_check(const fxl_beam *beam)
{
    if (beam == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (beam->kind > FXL_BEAM_DIRECTION || beam->reserved != 0) {
        return FXL_E_RESERVED;
    }
    if (beam->plane_count < 1 || beam->plane_count > FXL_BEAM_PLANES_MAX) {
        return FXL_E_COUNT;
    }
    const fxl_direction travel = direction_of(beam);
    const fxl_point light = {beam->from[0], beam->from[1], beam->from[2]};
    if (beam->kind == FXL_BEAM_DIRECTION && !fxl_is_unit(&travel)) {
        return FXL_E_NORMAL;
    }
    if (beam->kind == FXL_BEAM_POINT && !fxl_point_in_range(&light)) {
        return FXL_E_RANGE;
    }
    for (uint32_t i = 0; i < FXL_BEAM_PLANES_MAX; i++) {
        const fxl_beam_plane *plane = &beam->planes[i];
        if (i >= beam->plane_count) {
            if (!is_unused(plane)) {
                return FXL_E_RESERVED;
            }
            continue;
        }
        if (!fxl_is_unit(&plane->normal)) {
            return FXL_E_NORMAL;
        }
        if (!fxl_within(fxl_beam_plane_at(beam, i).distance, ((int64_t)1 << 61) - 1)) {
            return FXL_E_RANGE;
        }
    }
    return FXL_OK;
}

/* --- a beam through a window -------------------------------------------------- */

static fxl_point subtract(const fxl_point *a, const fxl_point *b)
{
    fxl_point difference = {a->x - b->x, a->y - b->y, a->z - b->z};
    return difference;
}

static void turn_about(fxl_plane *plane)
{
    plane->normal.x = -plane->normal.x;
    plane->normal.y = -plane->normal.y;
    plane->normal.z = -plane->normal.z;
    plane->distance = -plane->distance;
}

/* Turns the plane so that the window lies inside. Returns false where the window lies on both
 * sides, or only in the plane. */
static bool turn_to_window(fxl_plane *plane, const fxl_point *window, uint32_t count)
{
    fxl_q18_46 least = 0, greatest = 0;
    for (uint32_t i = 0; i < count; i++) {
        fxl_q18_46 distance = fxl_plane_distance(plane, &window[i]);
        least = distance < least ? distance : least;
        greatest = distance > greatest ? distance : greatest;
    }
    if (greatest <= CORNER_TOLERANCE && least < -CORNER_TOLERANCE) {
        turn_about(plane);
        return true;
    }
    return greatest > CORNER_TOLERANCE && least >= -CORNER_TOLERANCE;
}

/* beams 1.2 */
static void store(fxl_beam *beam, const fxl_plane *plane)
{
    fxl_beam_plane *stored = &beam->planes[beam->plane_count++];
    stored->normal = plane->normal;
    stored->distance_low = fxl_low_32(fxl_bits_64(plane->distance));
    stored->distance_high = (uint32_t)(fxl_bits_64(plane->distance) >> 32);
}

/* Makes the plane through a corner that holds the direction of the light there and a side of the
 * window. */
/* beams 1.2, 1.3 */
static bool side_plane(const fxl_beam *beam, const fxl_point *window, uint32_t count, uint32_t i,
                       fxl_plane *plane)
{
    const fxl_point *corner = &window[i], *next = &window[i + 1 == count ? 0 : i + 1];
    fxl_point from = {beam->from[0], beam->from[1], beam->from[2]};
    fxl_point ray = beam->kind == FXL_BEAM_DIRECTION ? from : subtract(corner, &from);
    fxl_point side = subtract(next, corner);
    fxl_direction unit;
    if (!fxl_unit_cross(&ray, &side, &unit)) {
        return false;
    }
    *plane = fxl_plane_from_point(corner, &unit, 0);
    return turn_to_window(plane, window, count);
}

/* Makes the window's own plane, with its normal away from the light. */
/* beams 1.3 */
static bool window_plane(const fxl_beam *beam, const fxl_point *window, fxl_plane *plane)
{
    if (fxl_plane_from_points(&window[0], &window[1], &window[2], plane) != FXL_OK) {
        return false;
    }
    const fxl_point from = {beam->from[0], beam->from[1], beam->from[2]};
    fxl_q18_46 along = beam->kind == FXL_BEAM_DIRECTION
                           ? fxl_dot(&plane->normal, from.x, from.y, from.z)
                           : -fxl_plane_distance(plane, &from);
    if (along < 0) {
        turn_about(plane);
    }
    return !fxl_within(along, CORNER_TOLERANCE);
}

/* kind and x, y, z as the beam has them: where its light is, or which way it travels. */
/* beams 1.3 */
static fxl_status through_window(uint8_t kind, int32_t x, int32_t y, int32_t z,
                                 const fxl_point *window, uint32_t count, fxl_beam *beam)
{
    if (window == NULL || beam == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (count < 3 || count > FXL_BEAM_PLANES_MAX - 1) {
        return FXL_E_COUNT;
    }
    for (uint32_t i = 0; i < count; i++) {
        if (!fxl_point_in_range(&window[i])) {
            return FXL_E_RANGE;
        }
    }
    fxl_beam made;
    memset(&made, 0, sizeof made);
    made.kind = kind;
    made.from[0] = x;
    made.from[1] = y;
    made.from[2] = z;
    fxl_plane plane;
    for (uint32_t i = 0; i < count; i++) {
        if (!side_plane(&made, window, count, i, &plane)) {
            return FXL_E_DEGENERATE;
        }
        store(&made, &plane);
    }
    if (!window_plane(&made, window, &plane)) {
        return FXL_E_DEGENERATE;
    }
    store(&made, &plane);
    *beam = made;
    return FXL_OK;
}

FXL_COLD fxl_status fxl_beam_from_point(const fxl_point *light, const fxl_point *window,
                                        uint32_t count, fxl_beam *beam)
{
    if (light == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_point_in_range(light)) {
        return FXL_E_RANGE;
    }
    return through_window(FXL_BEAM_POINT, light->x, light->y, light->z, window, count, beam);
}

FXL_COLD fxl_status fxl_beam_from_direction(const fxl_direction *travel, const fxl_point *window,
                                            uint32_t count, fxl_beam *beam)
{
    if (travel == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_is_unit(travel)) {
        return FXL_E_RANGE;
    }
    return through_window(FXL_BEAM_DIRECTION, travel->x, travel->y, travel->z, window, count, beam);
}
