/* SPDX-License-Identifier: MIT */
#include "play.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "file.h"

enum {
    INSTANCE = 16,
    PLACEMENT = 40,
    MOTION = 76,
    KEY = 32
};

/* A place as the keys and the circle give it; angles in turns. */
typedef struct {
    vector centre;
    double angles[3], scale;
} stop;

static vector point_of(const uint8_t *at, double unit)
{
    return (vector){get_i32(at) * unit, get_i32(at + 4) * unit, get_i32(at + 8) * unit};
}

/* A binary angle after so many frames, in radians. */
static double angle_of(uint32_t start, uint32_t step, uint32_t frame)
{
    return (start + step * frame) * (2 * acos(-1.0) / 4294967296.0);
}

static placing unturned(vector centre)
{
    return (placing){centre, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1};
}

/* Turns what an orientation makes of each axis: in the plane of two of its rows, what points along
 * `from` then points an angle further towards `towards`. */
static void turn_rows(vector *from, vector *towards, double angle)
{
    const vector a = *from, b = *towards;
    *from = vector_minus(vector_times(a, cos(angle)), vector_times(b, sin(angle)));
    *towards = vector_plus(vector_times(a, sin(angle)), vector_times(b, cos(angle)));
}

/* Rodrigues' formula. */
static void spin_rows(vector rows[3], vector axis, double angle)
{
    const vector a = vector_times(axis, 1 / sqrt(vector_dot(axis, axis)));
    for (int i = 0; i < 3; i++) {
        const vector row = rows[i];
        /* The row of R times the spin is the spin's inverse of the row. */
        rows[i] = vector_plus(vector_plus(vector_times(row, cos(angle)),
                                          vector_times(vector_cross(row, a), sin(angle))),
                              vector_times(a, vector_dot(a, row) * (1 - cos(angle))));
    }
}

static uint32_t frame_of(const uint8_t *keys, uint32_t number)
{
    return get_u32(keys + (size_t)KEY * number);
}

static stop stop_of(const uint8_t *key)
{
    stop at = {point_of(key + 4, 1 / 65536.0), {0}, get_i32(key + 28) / 65536.0};
    for (int i = 0; i < 3; i++)
        at.angles[i] = get_u32(key + 16 + 4 * i) / 4294967296.0;
    return at;
}

/* Where the keys are in a frame. Between two keys an angle takes the short way. */
static stop between_keys(const uint8_t *keys, uint32_t count, bool repeats, uint32_t frame)
{
    const uint32_t last = count - 1;
    uint32_t number = 0;
    if (repeats && last > 0)
        frame %= frame_of(keys, last);
    while (number < last && frame_of(keys, number + 1) <= frame)
        number++;
    stop a = stop_of(keys + (size_t)KEY * number);
    if (number == last)
        return a;
    const stop b = stop_of(keys + (size_t)KEY * (number + 1));
    const double part = (double)(frame - frame_of(keys, number)) /
                        (frame_of(keys, number + 1) - frame_of(keys, number));
    a.centre = vector_plus(a.centre, vector_times(vector_minus(b.centre, a.centre), part));
    a.scale += (b.scale - a.scale) * part;
    for (int i = 0; i < 3; i++) {
        const double way = b.angles[i] - a.angles[i];
        a.angles[i] += (way - floor(way + 0.5)) * part;
    }
    return a;
}

static placing move(const uint8_t *motion, const uint8_t *keys, uint32_t frame)
{
    const double radius = get_i32(motion + 32) / 65536.0;
    const double around = angle_of(get_u32(motion + 36), get_u32(motion + 40), frame);
    const vector axis = point_of(motion + 12, 1.0);
    const stop at = between_keys(keys, get_u32(motion + 68), motion[74] != 0, frame);
    placing place =
        unturned(vector_plus(at.centre, (vector){radius * sin(around), 0, radius * cos(around)}));
    double angles[3];
    for (int i = 0; i < 3; i++)
        angles[i] = at.angles[i] * 2 * acos(-1.0) + angle_of(0, get_u32(motion + 4 * i), frame);
    /* Rows are turned as points are: roll first, yaw last. */
    turn_rows(&place.rows[0], &place.rows[1], angles[2]); /* x towards y */
    turn_rows(&place.rows[2], &place.rows[1], angles[1]); /* z towards y */
    turn_rows(&place.rows[2], &place.rows[0], angles[0]); /* z towards x */
    if (vector_dot(axis, axis) > 0)
        spin_rows(place.rows, axis, angle_of(get_u32(motion + 24), get_u32(motion + 28), frame));
    place.scale = at.scale;
    return place;
}

vector placing_point(const placing *at, vector point)
{
    const vector turned = {vector_dot(at->rows[0], point), vector_dot(at->rows[1], point),
                           vector_dot(at->rows[2], point)};
    return vector_plus(at->centre, vector_times(turned, at->scale));
}

static placing attached(const placing *parent, const placing *child)
{
    placing place = unturned(placing_point(parent, child->centre));
    place.scale = parent->scale * child->scale;
    for (int i = 0; i < 3; i++) {
        const vector row = parent->rows[i];
        place.rows[i] = vector_plus(
            vector_times(child->rows[0], row.x),
            vector_plus(vector_times(child->rows[1], row.y), vector_times(child->rows[2], row.z)));
    }
    return place;
}

void play_frame(const play_tables *of, uint32_t frame, placing *places)
{
    const uint32_t still = of->instance_count - of->placement_count;
    const uint32_t unmoved = of->instance_count - of->motion_count;
    for (uint32_t i = 0; i < of->instance_count; i++) {
        placing *place = &places[i];
        *place = unturned(point_of(of->instances + (size_t)INSTANCE * i, 1 / 65536.0));
        if (i >= still && i < unmoved) {
            const uint8_t *placement = of->placements + (size_t)PLACEMENT * (i - still);
            for (int row = 0; row < 3; row++)
                place->rows[row] = point_of(placement + 12 * row, 1 / 1073741824.0);
            place->scale = get_i32(placement + 36) / 65536.0;
        }
        if (i >= unmoved) {
            const uint8_t *motion = of->motions + (size_t)MOTION * (i - unmoved);
            const uint32_t first = get_u32(motion + 64), count = get_u32(motion + 68);
            const uint32_t parent = get_u16(motion + 72);
            if (count == 0 || first > of->key_count || count > of->key_count - first ||
                parent > i - unmoved)
                unusable("motion %u makes no sense", i - unmoved);
            *place = move(motion, of->keys + (size_t)KEY * first, frame);
            if (parent > 0)
                *place = attached(&places[unmoved + parent - 1], place);
        }
    }
}
