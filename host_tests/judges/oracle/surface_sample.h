/* SPDX-License-Identifier: MIT */
/* A triangle that has a surface, and one pixel of it: as numbers of an input, drawn by the library,
 * and its attributes in exact arithmetic. */
#ifndef ORACLE_SURFACE_SAMPLE_H
#define ORACLE_SURFACE_SAMPLE_H

#include "oracle/triangle.h"

enum {
    SURFACE_ATTRIBUTES = 3, /* of a corner: u, v, light, each 16.16 */
    SURFACE_NUMBERS = ORACLE_SETUP_NUMBERS + 2 + 3 * (3 + SURFACE_ATTRIBUTES),
    SURFACE_LIGHT_NUMBERS = SURFACE_NUMBERS + 9 + 10, /* three normals; the light */
    SURFACE_LEVELS = 64
};

#define SURFACE_TEXT ORACLE_SETUP_TEXT ", column row, three corners x y z u v light"

typedef struct {
    oracle_setup setup;
    fxl_lens lens; /* whose view that is */
    int64_t x, y;  /* the pixel */
    fxl_point corners[3];
    int64_t values[3][SURFACE_ATTRIBUTES];
    /* Whether the corners are those of the screen (SPEC.md, section 9.3), and these as points of
     * the view at the depth of the focal length. */
    int is_affine;
    oracle_view_point on_screen[3];
    /* The triangle as a scene of the library. */
    fxl_face face;
    fxl_model model;
    fxl_instance instance;
    fxl_scene scene;
    uint16_t indices[3];
} surface_sample;

/* Random numbers for a sample whose pixel lies in the triangle, if its corners are in range. */
void surface_sample_generate(oracle_random *random, oracle_input *input);

/* Reads the numbers. Returns 0 where the library refuses them. */
int surface_sample_read(const oracle_input *input, surface_sample *sample);

/* Makes the sample's exact values those of FXL_AFFINE. Returns 0 where the library's screen points
 * are not all on the screen, so that the face has its perspective. */
int surface_sample_make_affine(surface_sample *sample);

/* Makes them those of corners that are where docs/extras/orthographic.md, section 2.6, has them, to 2^-31 pixel.
 * Returns 0 where they are on one line there, or too far away for 64 bits. */
int surface_sample_make_orthographic(surface_sample *sample);

/* Judges the texel that a pixel shows, of SURFACE_NUMBERS and the log2 of the texture's side. The claim's variant is
 * the division. */
oracle_outcome surface_judge_texel(const oracle_input *input, FILE *words, oracle_verdict *verdict);

/* The colour of RGB565 that the pixel shows of a face with colours at its corners, divided every 16
 * columns or more often; or -1. Colours: 65536 red + 256 green + blue. */
int surface_sample_draw_colours(surface_sample *sample, const uint32_t colours[3]);

/* place sampling: the claims of texels */
/* The texel of u (attribute 0) or of v (1) that the pixel shows, of a texture of 2^log texels that
 * repeats; or -1. log is at most 7. */
int surface_sample_texel(surface_sample *sample, int attribute, int log, uint8_t division);

/* How far an exact coordinate, in 2^-32, is from a texel of 2^log, around. */
double surface_texel_distance(int64_t exact, int texel, int log);

/* The level of light that the pixel shows; or -1. settings: those of surface_sample_light. */
int surface_sample_level(surface_sample *sample, const fxl_direction normals[3],
                         const fxl_light_settings *settings);

/* How far an exact level is from one that is shown. */
double surface_level_distance(double exact, int level);

/* The exact value of an attribute at the pixel, in units of 2^-32, rounded down. *bound: what
 * docs/accuracy.md, section 5.1, allows, in the unit of the attribute. */
int64_t surface_sample_exact(const surface_sample *sample, int attribute, double *bound);

/* Appends random normals and a random light near the corners. */
void surface_sample_put_light(oracle_random *random, oracle_input *input);

/* Reads the normals and the light of SURFACE_LIGHT_NUMBERS numbers, and makes the exact light of
 * the corners, in 2^-32 level, the sample's values of light. */
void surface_sample_light(const oracle_input *input, surface_sample *sample,
                          fxl_direction normals[3], fxl_light_settings *settings);

/* The exact level at the pixel, after surface_sample_light, and as *bound what 5.1 allows. */
double surface_sample_exact_level(const surface_sample *sample, double *bound);

#endif
