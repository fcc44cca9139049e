/* SPDX-License-Identifier: MIT */
/* A scene as tables, from a fuzzer's bytes. */
#ifndef MAKE_SCENE_H
#define MAKE_SCENE_H

#include "input.h"

enum {
    MADE_MODELS = 3,
    MADE_FACES = 24,
    MADE_VERTICES = MADE_FACES * FXL_FACE_VERTICES_MAX,
    MADE_INSTANCES = 6,
    MADE_NODES = MADE_FACES + 8
};

typedef struct {
    fxl_point vertices[MADE_VERTICES];
    uint16_t corners[MADE_VERTICES];
    fxl_face faces[MADE_FACES];
    fxl_model models[MADE_MODELS];
    fxl_instance instances[MADE_INSTANCES];
    fxl_face_bounds keys[MADE_FACES];
    fxl_bsp_node nodes[MADE_NODES];
    fxl_cluster clusters[MADE_FACES];
    fxl_scene scene; /* its tables are copies of just the size that it states */
} made_scene;

/* Models of flat faces that turn any way, outlines of any shape (convex,
 * concave, crossing themselves, repeated vertices), objects anywhere. Most are
 * in order; some then have one number spoilt. Free with free_scene. */
made_scene *make_scene(fuzz_input *in);

/* Turns some of the instances, the last ones: about one axis, by any scale. Most are in range. */
void add_placements(made_scene *made, fuzz_input *in);

void free_scene(made_scene *made);

#endif
