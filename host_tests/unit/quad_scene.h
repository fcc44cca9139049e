/* SPDX-License-Identifier: MIT */
/* A scene of one quadrilateral that has a surface, anywhere and turned any way, and what its pixels
 * show by the definitions in double. */
#ifndef QUAD_SCENE_H
#define QUAD_SCENE_H

/* place light: pictures of lit surfaces */
#include "exact_light.h"

enum {
    QUAD_WIDTH = 48,
    QUAD_HEIGHT = 32,
    QUAD_BACKGROUND = 255,
    QUAD_COLOUR = 7 /* of the face */
};

/* The tables, which a test may change before quad_begin. */
typedef struct {
    fxl_point vertices[4];
    fxl_face face;
    fxl_model model;
    fxl_instance instance;
    fxl_placement placement;
    fxl_scene scene;
    fxl_texture texture;
    fxl_surface surface;
    fxl_mapped_face mapped;
    fxl_corner mapped_corners[3];
    fxl_direction normals[4];
    uint16_t face_map;
    fxl_surface_set set;
    fxl_surfaces surfaces;
    fxl_lit_surfaces corner_light;
    fxl_renderer renderer;
    fxl_pose pose;
    uint8_t frame[QUAD_WIDTH * QUAD_HEIGHT];
    exact_vector corners[3]; /* those of the map in the world: after quad_begin */
    exact_vector outline[4]; /* the vertices there */
    exact_vector lit[3];     /* their normals there */
} quad_scene;

/* Makes a random face before a random eye, with random texels and normals, no texture and no light.
 * turned: its instance has a random placement. Answers the scene, of which there is one. */
quad_scene *quad_make(bool turned);

/* Checks the scene, and sets up renderer, surfaces and corners. */
void quad_begin(quad_scene *quad);

/* Attaches a light, which the face takes at its corners. */
void quad_light(quad_scene *quad, fxl_light *light, const fxl_light_settings *settings);

/* Draws the frame as one band. */
void quad_draw(quad_scene *quad);

/* A pixel's centre on the face's plane: a value that is a at its three corners; and how small the
 * weight is there, from 0 at the horizon to 1. */
double quad_value(const quad_scene *quad, int x, int y, const double a[3], double *weight);

/* The same for a value that is linear on the screen. False if a corner is not well on the screen.
 */
bool quad_affine_value(const quad_scene *quad, int x, int y, const double a[3], double *value);

/* Texels a pixel by area at the nearest vertex; 0 if it is not in front of the eye. */
double quad_texels(const quad_scene *quad);

#endif
