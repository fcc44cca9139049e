/* SPDX-License-Identifier: MIT */
#include "reference/clipper.h"

#include <stddef.h>
#include <string.h>

#define DEPTHS (1u << REF_PLANE_NEAR | 1u << REF_PLANE_FAR)

static const struct {
    const char *name;
    unsigned planes;
} clippers[] = {
    {"view", REF_CUT_ALL},
    {"world", REF_CUT_ALL},
    {"normalised", REF_CUT_ALL},
    {"once", REF_CUT_ALL},
    {"half-spaces", REF_CUT_ALL},
    /* It clips to the borders of the screen, and so does the scan. */
    {"triangles", DEPTHS},
    {"near", DEPTHS},
    {"near-box", DEPTHS},
    {"left", DEPTHS | 1u << REF_PLANE_LEFT},
};

bool ref_clipper_cuts(const char *name, unsigned *planes)
{
    for (size_t i = 0; i < sizeof clippers / sizeof *clippers; i++) {
        if (strcmp(name, clippers[i].name) == 0) {
            *planes = clippers[i].planes;
            return true;
        }
    }
    return false;
}

static const struct {
    const char *name;
    bool by_bsp;
} methods[] = {{"sorted", false},    {"box", false}, {"spans", false},
               {"spans-box", false}, {"tree", true}, {"tree-spans", true}};

bool ref_visibility_goes_by_bsp(const char *name, bool *by_bsp)
{
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        if (strcmp(name, methods[i].name) == 0) {
            *by_bsp = methods[i].by_bsp;
            return true;
        }
    }
    return false;
}
