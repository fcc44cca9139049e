/* SPDX-License-Identifier: MIT */
#include "frames/methods.h"

#include <string.h>
#include "study/clippers.h"
#include "study/methods.h"

static const named_clipper clippers[] = {
    {"view", &fxl_clipper_view, NULL},
    {"world", &fxl_clipper_world, NULL},
    {"normalised", &fxl_clipper_normalised, NULL},
    {"once", &fxl_clipper_once, NULL},
    {"half-spaces", &fxl_clipper_half_spaces, NULL},
    {"triangles", &fxl_clipper_triangles, NULL},
    {"near", &fxl_clipper_near, NULL},
    {"near-box", &fxl_clipper_near, &fxl_palette_box},
    {"left", &fxl_clipper_left, NULL},
};

static const named_visibility methods[] = {
    {"sorted", &fxl_visibility_sorted, false},     {"spans", &fxl_visibility_spans, false},
    {"tree", &fxl_visibility_bsp, false},          {"tree-spans", &fxl_visibility_bsp_spans, false},
    {"surfaces", &fxl_visibility_surfaces, true},  {"depth", &fxl_visibility_depth, true},
    {"depth-32", &fxl_visibility_depth_32, true},
};

const named_clipper *find_clipper(const char *name)
{
    for (size_t i = 0; i < sizeof clippers / sizeof *clippers; i++) {
        if (strcmp(clippers[i].name, name) == 0) {
            return &clippers[i];
        }
    }
    return NULL;
}

const named_visibility *find_visibility(const char *name)
{
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        if (strcmp(methods[i].name, name) == 0) {
            return &methods[i];
        }
    }
    return NULL;
}
