/* SPDX-License-Identifier: MIT */
#include "reference/clipper.h"

#include <stddef.h>
#include <string.h>

#define DEPTHS (1u << REF_PLANE_NEAR | 1u << REF_PLANE_FAR)

/* place clipper: which sides each clipper cuts */
static const struct {
    const char *name;
    unsigned planes;
    bool by_points;
} clippers[] = {
    {"view", REF_CUT_ALL, false},
    {"world", REF_CUT_ALL, true},
    {"normalised", REF_CUT_ALL, true},
    {"once", REF_CUT_ALL, true},
    {"half-spaces", REF_CUT_ALL, true},
    /* It clips to the borders of the screen, and so does the scan. */
    {"triangles", DEPTHS, false},
    {"near", DEPTHS, false},
    {"near-box", DEPTHS, false},
    {"left", DEPTHS | 1u << REF_PLANE_LEFT, false},
};

bool ref_take_clipper(const char *name, void *method)
{
    ref_method *of = method;
    for (size_t i = 0; i < sizeof clippers / sizeof *clippers; i++) {
        if (strcmp(name, clippers[i].name) == 0) {
            of->cuts = clippers[i].planes;
            of->by_points = clippers[i].by_points;
            return true;
        }
    }
    return false;
}

static const struct {
    const char *name;
    bool by_bsp, flat;
    int depth_bits;
} methods[] = {
    {"sorted", false, true, 0},    {"box", false, true, 0},     {"spans", false, true, 0},
    {"spans-box", false, true, 0}, {"tree", true, true, 0},     {"tree-spans", true, true, 0},
    {"surfaces", false, false, 0}, {"depth", false, false, 16}, {"depth-32", false, false, 32}};

bool ref_take_visibility(const char *name, void *method)
{
    ref_method *of = method;
    of->is_asked = true;
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        if (strcmp(methods[i].name, name) == 0) {
            of->by_bsp = methods[i].by_bsp;
            of->flat = methods[i].flat;
            of->depth_bits = methods[i].depth_bits;
            return true;
        }
    }
    return false;
}
