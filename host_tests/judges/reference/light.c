/* SPDX-License-Identifier: MIT */
#include "reference/light.h"

#include <math.h>
#include <string.h>

#include "reference/placement.h"

static double dot(ref_point a, ref_point b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static ref_point from_to(ref_point a, ref_point b)
{
    return (ref_point){b.x - a.x, b.y - a.y, b.z - a.z};
}

void ref_light_make_ramp(ref_light *light, const uint8_t *palette, const uint8_t *dark)
{
    for (int level = 0; level < light->levels; level++) {
        for (int colour = 0; colour < 256; colour++) {
            double least = INFINITY;
            int best = colour;
            for (int entry = 0; entry < 256 && level < light->levels - 1; entry++) {
                double distance = 0;
                for (int k = 0; k < 3; k++) {
                    double wanted = floor(dark[k] +
                                          (palette[3 * colour + k] - dark[k]) * (double)level /
                                              (light->levels - 1) +
                                          0.5);
                    distance +=
                        (palette[3 * entry + k] - wanted) * (palette[3 * entry + k] - wanted);
                }
                if (distance < least) {
                    least = distance;
                    best = entry;
                }
            }
            light->ramp[level][colour] = (uint8_t)best;
        }
    }
}

static double q16(const uint8_t *bytes)
{
    return ldexp(ref_i32(bytes), -16);
}

static double q30(const uint8_t *bytes)
{
    return ldexp(ref_i32(bytes), -30);
}

/* place light: the reference */
/* place light: a new setting: the reference's reader */
void ref_light_read(ref_light *light, const uint8_t *base, const uint8_t *points, int point_count,
                    const uint8_t *ramp, int levels)
{
    light->ambient = q30(base);
    light->strength = q30(base + 4);
    light->direction = (ref_point){q30(base + 8), q30(base + 12), q30(base + 16)};
    light->fog_near = q16(base + 20);
    light->fog_far = q16(base + 24);
    light->point_count = point_count;
    for (int i = 0; i < point_count; i++) {
        const uint8_t *at = points + 20 * i;
        light->points[i] =
            (ref_point_light){{q16(at), q16(at + 4), q16(at + 8)}, q16(at + 12), q30(at + 16)};
    }
    light->levels = levels;
    memcpy(light->ramp, ramp, (size_t)levels * sizeof light->ramp[0]);
}

/* The middle of the bounding box of a face, of a part that of the whole face: in the world, or, of
 * an instance that is turned, of the box in its model, turned and scaled. */
static ref_point middle_of(const ref_scene *scene, const ref_instance *instance,
                           const ref_face *face)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    ref_lattice_point low = {INT32_MAX, INT32_MAX, INT32_MAX},
                      high = {INT32_MIN, INT32_MIN, INT32_MIN};
    const int first = face->whole_count ? face->count : 0;
    const int end = face->count + face->whole_count;
    for (int i = first; i < end; i++) {
        const ref_lattice_point at = placement ? ref_face_corner(scene, instance, face, i)
                                               : ref_face_vertex(scene, instance, face, i);
        low = (ref_lattice_point){at.x < low.x ? at.x : low.x, at.y < low.y ? at.y : low.y,
                                  at.z < low.z ? at.z : low.z};
        high = (ref_lattice_point){at.x > high.x ? at.x : high.x, at.y > high.y ? at.y : high.y,
                                   at.z > high.z ? at.z : high.z};
    }
    const ref_point a = placement ? ref_placement_point(placement, &instance->centre, &low)
                                  : ref_point_from_lattice(&low);
    const ref_point b = placement ? ref_placement_point(placement, &instance->centre, &high)
                                  : ref_point_from_lattice(&high);
    return (ref_point){(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
}

static double from_point(const ref_point_light *light, ref_point middle, ref_point normal)
{
    const ref_point to = from_to(middle, light->position);
    const double distance = sqrt(dot(to, to));
    if (distance == 0 || distance >= light->range) {
        return 0;
    }
    return light->strength * fmax(0, dot(normal, to) / distance) *
           (1 - (distance / light->range) * (distance / light->range));
}

double ref_light_brightness(const ref_light *light, const ref_camera *camera, ref_point middle,
                            ref_point normal)
{
    double sum = light->ambient + light->strength * fmax(0, -dot(normal, light->direction));
    for (int i = 0; i < light->point_count; i++) {
        sum += from_point(&light->points[i], middle, normal);
    }
    sum = fmin(sum, 1);
    if (light->fog_far != 0) {
        const double depth = dot(from_to(camera->position, middle), camera->forward);
        const double left = (light->fog_far - depth) / (light->fog_far - light->fog_near);
        sum *= fmin(fmax(left, 0), 1);
    }
    return sum;
}

double ref_light_of_face(const ref_light *light, const ref_camera *camera, const ref_scene *scene,
                         const ref_instance *instance, const ref_face *face)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    int32_t turned[3] = {face->normal[0], face->normal[1], face->normal[2]};
    if (placement) {
        ref_placement_normal(placement, face->normal, turned);
    }
    const ref_point normal = {ldexp(turned[0], -30), ldexp(turned[1], -30), ldexp(turned[2], -30)};
    return ref_light_brightness(light, camera, middle_of(scene, instance, face), normal);
}

uint8_t ref_light_colour(const ref_light *light, const ref_camera *camera, const ref_scene *scene,
                         const ref_instance *instance, const ref_face *face)
{
    const double exact =
        ref_light_of_face(light, camera, scene, instance, face) * (light->levels - 1);
    return light->ramp[(int)floor(exact + 0.5)][face->material];
}

static const struct {
    int first_bit, most;
} channels[REF_CHANNELS] = {{11, 31}, {5, 63}, {0, 31}};

int ref_channel(uint16_t colour, int channel)
{
    return colour >> channels[channel].first_bit & channels[channel].most;
}

int ref_channel_most(int channel)
{
    return channels[channel].most;
}

uint16_t ref_colour_of(const int values[REF_CHANNELS])
{
    int colour = 0;
    for (int i = 0; i < REF_CHANNELS; i++) {
        colour += values[i] << channels[i].first_bit;
    }
    return (uint16_t)colour;
}

/* place pixel-format: ref_rgb565: what a colour is, and how light takes a part of it; null for a palette */
void ref_rgb565_make(ref_rgb565 *made, const uint8_t *palette, uint16_t dark)
{
    for (int i = 0; i < 256; i++) {
        const int values[REF_CHANNELS] = {palette[3 * i] / 8, palette[3 * i + 1] / 4,
                                          palette[3 * i + 2] / 8};
        made->palette[i] = ref_colour_of(values);
    }
    made->dark = dark;
}

/* place light: who asks the reference, and the part in RGB565 */
double ref_rgb565_part(const ref_light *light, double level)
{
    const double most = light->levels - 1;
    return most > 0 ? fmin(fmax(level - 0.5, 0), most) / most : 1;
}

double ref_rgb565_part_bound(const ref_light *light)
{
    return (0.5 + 0.125 + 1.0 / (light->levels - 1)) / 256;
}

double ref_rgb565_flat_part(double brightness)
{
    return floor(256 * brightness + 0.5) / 256;
}

double ref_rgb565_lit(const ref_rgb565 *of, uint16_t colour, int channel, double part)
{
    const int lit = ref_channel(colour, channel), dark = ref_channel(of->dark, channel);
    return dark + (lit - dark) * part;
}

uint16_t ref_rgb565_shown(const ref_rgb565 *of, uint16_t colour, double part)
{
    int values[REF_CHANNELS];
    for (int i = 0; i < REF_CHANNELS; i++) {
        values[i] = (int)floor(ref_rgb565_lit(of, colour, i, part) + 0.5);
    }
    return ref_colour_of(values);
}

/* --- beams -------------------------------------------------------------------------------------- */

#define UNIT (1.0L / 65536)

/* Returns the side of a plane on which a point lies: -1 behind, 1 in front, 0 if it is at most 4
 * units of 1/65536 away. */
static int side_of(const ref_plane *plane, const ref_lattice_point *point)
{
    long double distance = ref_split_distance(plane, point);
    return fabsl(distance) <= 4 * UNIT ? 0 : distance < 0 ? -1 : 1;
}

bool ref_beam_light_reaches(const ref_scene *scene, const ref_lattice_point *centre, int32_t radius)
{
    const long double reach = ((long double)radius + 4) * UNIT;
    for (uint32_t b = 0; b < scene->beam_count; b++) {
        bool ruled_out = false;
        for (int i = 0; i < scene->beams[b].plane_count; i++) {
            ruled_out |= ref_split_distance(&scene->beams[b].planes[i], centre) < -reach;
        }
        if (!ruled_out) {
            return true;
        }
    }
    return false;
}

static bool shines_on(const ref_beam *beam, const ref_lattice_point *vertex, const int32_t *normal)
{
    long double sum = 0;
    const int32_t at[3] = {vertex->x, vertex->y, vertex->z};
    for (int i = 0; i < 3; i++) {
        long double way = beam->kind == REF_BEAM_DIRECTION ? -(long double)beam->from[i]
                                                           : (long double)beam->from[i] - at[i];
        sum += normal[i] * way; /* below 2^63: exact */
    }
    return sum > 0;
}

/* Inserts an intersection into every piece that has the edge between two points. */
static bool insert_into_all(ref_lit_pieces *to, const ref_lattice_point *a,
                            const ref_lattice_point *b, const ref_lattice_point *intersection)
{
    const ref_lattice_point ends[2] = {*a, *b};
    bool fits = true;
    for (int i = 0; i < to->count && fits; i++) {
        fits = ref_piece_insert(&to->pieces[i].shape, ends, intersection, REF_POLYGON_CAPACITY);
    }
    return fits;
}

static ref_lattice_point intersect(const ref_plane *plane, const ref_lattice_point *a,
                                   const ref_lattice_point *b)
{
    long double from = ref_split_distance(plane, a), to = ref_split_distance(plane, b);
    return from > 0 ? ref_split_edge(a, b, from, to) : ref_split_edge(b, a, to, from);
}

/* Inserts the intersection of every edge that a plane crosses, in all pieces that have the edge.
 * After that the outline meets the plane only in corners. */
static bool insert_intersections(ref_lit_pieces *to, int number, const ref_plane *plane)
{
    const ref_piece whole = to->pieces[number].shape;
    for (int i = 0; i < whole.count; i++) {
        const ref_lattice_point *a = &whole.points[i], *b = &whole.points[(i + 1) % whole.count];
        if (side_of(plane, a) * side_of(plane, b) < 0) {
            ref_lattice_point intersection = intersect(plane, a, b);
            if (!insert_into_all(to, a, b, &intersection)) {
                return false;
            }
        }
    }
    return true;
}

/* Returns the first side other than 0 that is met from a corner on, in one direction. */
static int next_side(const ref_plane *plane, const ref_piece *piece, int from, int step)
{
    for (int k = 0; k < piece->count; k++) {
        int side =
            side_of(plane, &piece->points[(from + step * k + piece->count * k) % piece->count]);
        if (side != 0) {
            return side;
        }
    }
    return 0;
}

/* Places a corner on the plane. It belongs to the front part if the outline is in front on both
 * sides of it. Where the outline changes sides, the corner next to the front belongs to both
 * parts, and the other corners on the plane to the part behind. */
static void place_on_plane(const ref_plane *plane, const ref_piece *piece, int i, bool *in_front,
                           bool *behind)
{
    int before = next_side(plane, piece, (i + piece->count - 1) % piece->count, -1);
    int after = next_side(plane, piece, (i + 1) % piece->count, 1);
    int left = side_of(plane, &piece->points[(i + piece->count - 1) % piece->count]);
    int right = side_of(plane, &piece->points[(i + 1) % piece->count]);
    if (before == after) {
        *in_front = before > 0;
        *behind = before < 0;
    } else {
        *in_front = left > 0 || right > 0;
        *behind = true;
    }
}

/* Cuts an edge on a plane by the later planes of the beam. The edge counts as in front of the
 * plane, whichever polygon it belongs to. */
static bool follow(ref_lit_pieces *to, ref_lattice_point a, ref_lattice_point b,
                   const ref_beam *beam, int next)
{
    for (int i = next; i < beam->plane_count; i++) {
        const ref_plane *plane = &beam->planes[i];
        int from = side_of(plane, &a), there = side_of(plane, &b);
        if (from * there < 0) {
            ref_lattice_point intersection = intersect(plane, &a, &b);
            if (!insert_into_all(to, &a, &b, &intersection)) {
                return false;
            }
            if (from < 0) {
                a = intersection;
            } else {
                b = intersection;
            }
        } else if (from < 0 || there < 0) {
            return true;
        }
    }
    return true;
}

static bool follow_all(ref_lit_pieces *to, int number, const ref_beam *beam, int plane)
{
    const ref_piece piece = to->pieces[number].shape;
    for (int i = 0; i < piece.count; i++) {
        const ref_lattice_point *a = &piece.points[i], *b = &piece.points[(i + 1) % piece.count];
        if (side_of(&beam->planes[plane], a) == 0 && side_of(&beam->planes[plane], b) == 0 &&
            !follow(to, *a, *b, beam, plane + 1)) {
            return false;
        }
    }
    return true;
}

typedef enum {
    IN,
    OUT,
    FULL
} outcome;

/* Cuts a piece by a plane: the piece keeps the part in front, and the rest becomes a new piece. */
static outcome cut(ref_lit_pieces *to, int number, const ref_beam *beam, int which)
{
    const ref_plane *plane = &beam->planes[which];
    bool any_front = false, any_behind = false, edge = false;
    const ref_piece before = to->pieces[number].shape;
    for (int i = 0; i < before.count; i++) {
        int side = side_of(plane, &before.points[i]);
        any_front |= side > 0;
        any_behind |= side < 0;
        edge |= side == 0 && side_of(plane, &before.points[(i + 1) % before.count]) == 0;
    }
    if (!any_behind) {
        return IN;
    }
    if (!any_front) {
        return !edge || follow_all(to, number, beam, which) ? OUT : FULL;
    }
    if (!insert_intersections(to, number, plane) || to->count == REF_LIT_PIECES_MAX) {
        return FULL;
    }
    const ref_piece whole = to->pieces[number].shape;
    ref_lit_piece *front = &to->pieces[number], *back = &to->pieces[to->count];
    back->lit = front->lit;
    back->shape.count = front->shape.count = 0;
    for (int i = 0; i < whole.count; i++) {
        int side = side_of(plane, &whole.points[i]);
        bool in_front = side > 0, behind = side < 0;
        if (side == 0) {
            place_on_plane(plane, &whole, i, &in_front, &behind);
        }
        if (in_front) {
            front->shape.points[front->shape.count++] = whole.points[i];
        }
        if (behind) {
            back->shape.points[back->shape.count++] = whole.points[i];
        }
    }
    to->count++;
    return !edge || follow_all(to, to->count - 1, beam, which) ? IN : FULL;
}

bool ref_beam_light_split(const ref_scene *scene, const ref_piece *polygon, const int32_t *normal,
                          ref_lit_pieces *to)
{
    to->count = 1;
    to->pieces[0] = (ref_lit_piece){*polygon, false};
    for (uint32_t b = 0; b < scene->beam_count; b++) {
        const ref_beam *beam = &scene->beams[b];
        const bool shines = shines_on(beam, &polygon->points[0], normal);
        for (int i = 0, pieces = to->count; i < pieces; i++) {
            outcome is = IN;
            for (int plane = 0; plane < beam->plane_count && is == IN; plane++) {
                is = cut(to, i, beam, plane);
            }
            if (is == FULL) {
                return false;
            }
            to->pieces[i].lit |= shines && is == IN;
        }
    }
    return true;
}
