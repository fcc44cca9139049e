/* SPDX-License-Identifier: MIT */
/* Numbers from a fuzzer's bytes, and a scene as tables. Past their end everything is 0, so that every
 * input means something and a shorter one means less. */
#ifndef INPUT_H
#define INPUT_H

#include "draw/stages.h"
#include "fixel/all.h"

typedef struct {
    const uint8_t *at;
    size_t left;
} fuzz_input;

/* A scene of tables, which are arrays: all members but those of extras. */
#define SCENE_OF(points, corners, face_table, model_table, instance_table) \
    ((fxl_scene){.vertices = (points), \
                 .indices = (corners), \
                 .faces = (face_table), \
                 .models = (model_table), \
                 .instances = (instance_table), \
                 .vertex_count = sizeof(points) / sizeof *(points), \
                 .index_count = sizeof(corners) / sizeof *(corners), \
                 .face_count = sizeof(face_table) / sizeof *(face_table), \
                 .model_count = sizeof(model_table) / sizeof *(model_table), \
                 .instance_count = sizeof(instance_table) / sizeof *(instance_table)})

/* The next 0..8 bytes, little-endian. */
uint64_t fuzz_bits(fuzz_input *in, unsigned bytes);

/* A number of 0 .. count - 1, from one byte where that suffices. */
uint32_t fuzz_below(fuzz_input *in, uint32_t count);

/* A number of low..high. */
int32_t fuzz_between(fuzz_input *in, int32_t low, int32_t high);

/* Any 32 bits, or a number near one of the edges where bugs live. */
int32_t fuzz_any(fuzz_input *in);

/* A world coordinate within limit: often small, often at the range's end. */
fxl_q16_16 fuzz_coordinate(fuzz_input *in, fxl_q16_16 limit);

fxl_point fuzz_point(fuzz_input *in, fxl_q16_16 limit);

/* A pose in range; angles at the quarter turns are as likely as others. */
fxl_pose fuzz_pose(fuzz_input *in);

/* A lens made by its function: any field of view, any depths, and a screen of
 * at most pixels pixels. */
fxl_lens fuzz_lens(fuzz_input *in, uint32_t pixels);

/* --- a scene ------------------------------------------------------------------ */

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
