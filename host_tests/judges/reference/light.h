/* SPDX-License-Identifier: MIT */
/* Light and fog at run time (docs/extras/light.md), in double. */
#ifndef REF_LIGHT_H
#define REF_LIGHT_H

#include "reference/camera.h"
#include "reference/scene.h"

enum {
    REF_LIGHT_POINTS_MAX = 4,
    REF_LIGHT_LEVELS_MAX = 64
};

typedef struct {
    ref_point position;
    double range, strength;
} ref_point_light;

/* place light: the reference */
/* place light: a new setting: the reference's reader */
struct ref_light {
    double ambient, strength;
    ref_point direction;
    ref_point_light points[REF_LIGHT_POINTS_MAX];
    int point_count;
    double fog_near, fog_far; /* both 0: there is no fog */
    int levels;
    uint8_t ramp[REF_LIGHT_LEVELS_MAX][256];
};

/* Fills the ramp of `levels` levels from a palette of 256 x red, green, blue, and the colour of
 * black and of fog. */
void ref_light_make_ramp(ref_light *light, const uint8_t *palette, const uint8_t *dark);

/* Reads the light of a scene image (docs/formats.md, section 1.2): the entry of its table, its
 * point lights, its ramp. Requires counts that REF_LIGHT_POINTS_MAX and REF_LIGHT_LEVELS_MAX allow.
 */
void ref_light_read(ref_light *light, const uint8_t *base, const uint8_t *points, int point_count,
                    const uint8_t *ramp, int levels);

/* The brightness of a place of the world with a normal, 0..1. */
double ref_light_brightness(const ref_light *light, const ref_camera *camera, ref_point place,
                            ref_point normal);

/* The brightness of a face, at the middle of its bounding box. */
double ref_light_of_face(const ref_light *light, const ref_camera *camera, const ref_scene *scene,
                         const ref_instance *instance, const ref_face *face);

/* The colour of a face in the light. */
uint8_t ref_light_colour(const ref_light *light, const ref_camera *camera, const ref_scene *scene,
                         const ref_instance *instance, const ref_face *face);

#endif
