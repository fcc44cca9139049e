/* SPDX-License-Identifier: MIT */
/* Settings of light by name, as plain numbers: for the program that draws lit frames by the library
 * (host_tests/judges/frames) and for the one that judges them by the reference (host_tests/judges/judge). */
#ifndef LIGHTS_NAMED_H
#define LIGHTS_NAMED_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* place light: a new setting: settings by name */
typedef struct {
    const char *name;
    int32_t ambient, strength, direction[3]; /* 2.30 */
    int point_count;
    struct {
        int32_t position[3], range, strength; /* 16.16, 16.16, 2.30 */
    } points[4];
    int32_t fog_near, fog_far; /* 16.16 */
    int levels;
    uint8_t dark[3];
} named_light;

/* Takes a light by its name into a const named_light *. False where there is none of this name. */
static inline bool take_light(const char *name, void *to)
{
    enum {
        UNIT = 65536,
        ONE = 1 << 30
    };
    static const named_light lights[] = {/* The sun from the upper left behind, far off in mist. */
                                         {"day",
                                          ONE / 5,
                                          3 * (ONE / 4),
                                          {715827883, -715827883, 357913941},
                                          0,
                                          {{{0}, 0, 0}},
                                          30 * UNIT,
                                          170 * UNIT,
                                          32,
                                          {226, 220, 246}},
                                         /* Night, and four lamps that overlap. */
                                         {"lamps",
                                          ONE / 8,
                                          0,
                                          {0, 0, 0},
                                          4,
                                          {{{-4 * UNIT, 4 * UNIT, -8 * UNIT}, 18 * UNIT, ONE},
                                           {{4 * UNIT, 3 * UNIT, 2 * UNIT}, 14 * UNIT, ONE},
                                           {{0, 6 * UNIT, 12 * UNIT}, 25 * UNIT, 3 * (ONE / 4)},
                                           {{UNIT / 2, 2 * UNIT, -20 * UNIT}, 9 * UNIT, ONE}},
                                          0,
                                          0,
                                          16,
                                          {12, 10, 28}},
                                         /* All of it. */
                                         {"dusk",
                                          ONE / 5,
                                          ONE / 3,
                                          {-858993459, -644245094, 0},
                                          2,
                                          {{{-4 * UNIT, 3 * UNIT, -4 * UNIT}, 20 * UNIT, ONE},
                                           {{3 * UNIT, 2 * UNIT, 6 * UNIT}, 16 * UNIT, ONE}},
                                          8 * UNIT,
                                          70 * UNIT,
                                          64,
                                          {70, 48, 84}}};
    for (unsigned i = 0; i < sizeof lights / sizeof lights[0]; i++) {
        if (strcmp(lights[i].name, name) == 0) {
            *(const named_light **)to = &lights[i];
            return true;
        }
    }
    return false;
}

#endif
