/* SPDX-License-Identifier: MIT */
/* Surfaces (SPEC.md, section 9) from their definition: the ray through a pixel's centre meets the
 * plane of the face, the place there has texture coordinates, and these lie in a texel. */
#ifndef REF_SURFACE_H
#define REF_SURFACE_H

#include "reference/camera.h"
#include "reference/scene.h"

enum {
    REF_DIVIDE_16 = 0,
    REF_DIVIDE_8 = 1,
    REF_DIVIDE_1 = 2,
    REF_OPAQUE = 16,
    REF_CLEAR = -1 /* the colour of what is not drawn */
};

typedef struct {
    int width, height;
    bool clamps, is_keyed;
    uint8_t key;
    uint8_t *colours; /* of the texels of the first level, row by row: palette indices */
} ref_texture;

typedef struct {
    int texture; /* its number, counted from 1; 0: the face's own colour */
    int division, opacity;
} ref_surface;

typedef struct {
    int surface, corners[3];
    double texels[3][2]; /* u, v */
} ref_mapped_face;

struct ref_surfaces {
    ref_texture *textures;
    ref_surface *surfaces;
    ref_mapped_face *faces;
    uint16_t *face_map; /* for each face of the scene 0, or 1 + the number of its record in faces */
    uint32_t texture_count, surface_count, face_count;
};

/* Reads the surfaces of an image into its scene. Returns true also where there are none. */
bool ref_surfaces_read(const uint8_t *bytes, size_t size, ref_scene *scene);
void ref_surfaces_close(ref_surfaces *surfaces);

/* How a face lies in the view of a frame. Null surface: it has none. */
typedef struct {
    const ref_surface *surface;
    const ref_texture *texture; /* or null */
    ref_view_point corner, sides[2];
    double texel[2], steps[2][2]; /* u, v at the corner, and what each side adds */
} ref_surface_view;

/* Where texture coordinates lie: those at a pixel's centre, and how far from them texels may be
 * chosen. */
typedef struct {
    double u, v, slack;
} ref_place;

/* Finds the surface of a face of an instance; its number is counted in the model. */
void ref_surface_look(const ref_scene *scene, const ref_camera *camera,
                      const ref_instance *instance, uint32_t face, ref_surface_view *view);

/* The texture coordinates at a point of the screen; false where the face's plane is not in front of
 * the eye there, or farther than 2^40 texels. Requires a texture. */
bool ref_surface_place(const ref_surface_view *view, const ref_lens *lens, double x, double y,
                       ref_place *place);

/* The colour of the texel in a column and a row, repeated or clamped; or REF_CLEAR. */
int ref_texture_colour(const ref_texture *texture, int64_t column, int64_t row);

/* Whether the stipple of an opacity draws a pixel. */
bool ref_stipple_draws(int opacity, int x, int y);

/* The colour of a pixel of a face; or REF_CLEAR. own: the face's colour. */
int ref_surface_colour(const ref_surface_view *view, const ref_lens *lens, int x, int y,
                       uint8_t own);

#endif
