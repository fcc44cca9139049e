/* SPDX-License-Identifier: MIT */
/* Light and fog, and the colours of RGB565 frames, which it darkens. */
#ifndef REF_LIGHT_H
#define REF_LIGHT_H

#include "reference/scene.h"
#include "reference/split.h"

/* Light and fog at run time (docs/extras/light.md), in double. */

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

/* Colours of RGB565 frames (docs/extras/rgb565.md) from their definitions. */

enum {
    REF_CHANNELS = 3
};

/* place pixel-format: ref_rgb565: what a colour is, and how light takes a part of it; null for a palette */
/* What frames of 16 bits a pixel are drawn with. */
typedef struct {
    uint16_t palette[256];
    uint16_t dark; /* what the lowest level of light leaves */
} ref_rgb565;

/* From a palette of 256 x red, green, blue. */
void ref_rgb565_make(ref_rgb565 *made, const uint8_t *palette, uint16_t dark);

/* Red, green, blue of a colour, and the largest value of each. */
int ref_channel(uint16_t colour, int channel);
int ref_channel_most(int channel);
uint16_t ref_colour_of(const int channels[REF_CHANNELS]);

/* place light: who asks the reference, and the part in RGB565 */
/* The part of a colour that is left at a place of the ramp, in levels, of which the nearest is what
 * is below: 0..1. */
double ref_rgb565_part(const ref_light *light, double level);

/* How far the library's part may be off (docs/extras/rgb565.md, section 2.1). */
double ref_rgb565_part_bound(const ref_light *light);

/* The part that is left of a flat face's colour at a brightness (docs/extras/rgb565.md,
 * section 2.1). */
double ref_rgb565_flat_part(double brightness);

/* How far the library's brightness may be off (docs/extras/light.md, section 2.5). */
#define REF_BRIGHTNESS_BOUND 0x1.Ap-26

/* A channel of a colour of which a part is left, before it is rounded. */
double ref_rgb565_lit(const ref_rgb565 *of, uint16_t colour, int channel, double part);

/* A colour of which a part is left. */
uint16_t ref_rgb565_shown(const ref_rgb565 *of, uint16_t colour, double part);

/* --- beams -------------------------------------------------------------------------------------- */

/* Light beams (docs/extras/beams.md), in double. Points are integers, as the specification says. */

enum {
    REF_LIT_PIECES_MAX = 256
};

typedef struct {
    ref_piece shape;
    bool lit;
} ref_lit_piece;

typedef struct {
    int count;
    ref_lit_piece pieces[REF_LIT_PIECES_MAX];
} ref_lit_pieces;

/* Tells whether any part of a sphere may lie in a beam of the scene. */
bool ref_beam_light_reaches(const ref_scene *scene, const ref_lattice_point *centre,
                            int32_t radius);

/* Splits a polygon of the world, with this normal (2.30), by the beams of the scene. Returns
 * false where there would be more pieces, or larger ones, than the records hold. */
bool ref_beam_light_split(const ref_scene *scene, const ref_piece *polygon, const int32_t *normal,
                          ref_lit_pieces *to);

#endif
