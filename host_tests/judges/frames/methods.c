/* SPDX-License-Identifier: MIT */
#include "frames/methods.h"

#include <string.h>
#include "study/clippers.h"
#include "study/targets.h"

/* place clipper: clippers: the names of firmware.mk, for the host */
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
    {"sorted", &fxl_by_distance, &fxl_palette, false},
    {"box", &fxl_by_distance, &fxl_palette_box, false},
    {"spans", &fxl_by_distance, &fxl_palette_spans, false},
    {"spans-box", &fxl_by_distance, &fxl_palette_spans_box, false},
    {"tree", &fxl_by_tree, &fxl_palette, false},
    {"tree-spans", &fxl_by_tree, &fxl_palette_spans, false},
    {"surfaces", &fxl_by_distance, &fxl_palette, true},
    {"depth", &fxl_by_distance, &fxl_palette_depth_16, true},
    {"depth-32", &fxl_by_distance, &fxl_palette_depth_32, true},
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
