/* SPDX-License-Identifier: MIT */
/* Surfaces (SPEC.md, section 9) from their definition: the ray through a pixel's centre meets the
 * plane of the face, the place there has texture coordinates, and these lie in a texel. */
#ifndef REF_SURFACE_H
#define REF_SURFACE_H

#include "reference/light.h"
#include "reference/scene.h"

enum {
    REF_DIVIDE_16 = 0,
    REF_DIVIDE_8 = 1,
    REF_DIVIDE_1 = 2,
    REF_AFFINE = 3,
    REF_OPAQUE = 16,
    REF_TEXTURE_LEVELS = 9,
    REF_CLEAR = -1 /* the colour of what is not drawn */
};

/* What varies over a face. With colours at its corners: red, green and blue in levels of RGB565, of
 * which a pixel shows the one below. */
enum {
    REF_U,
    REF_V,
    REF_BRIGHTNESS, /* in levels of the ramp */
    REF_VALUES
};

typedef struct {
    int width, height;
    uint16_t *colours; /* of the texels, row by row: palette indices, or RGB565 */
} ref_texture_level;

typedef struct {
    bool clamps, is_keyed, is_565;
    uint16_t key;
    int level_count;
    ref_texture_level levels[REF_TEXTURE_LEVELS];
} ref_texture;

typedef struct {
    int texture; /* its number, counted from 1; 0: the face's own colour */
    int division, opacity;
    int sixteenths; /* that a blended colour shows of itself in RGB565 */
    bool is_lit, blends, adds, has_colours;
    uint32_t first_corner; /* from which its faces count theirs */
} ref_surface;

typedef struct {
    int surface, vertices[3], normals[3]; /* numbers; of vertices within the model */
    double texels[3][2];                  /* u, v */
    int colours[3][REF_CHANNELS]; /* red, green, blue of 8 bits, where the surface has them */
} ref_mapped_face;

struct ref_surfaces {
    ref_texture *textures;
    ref_surface *surfaces;
    ref_mapped_face *faces;
    uint16_t *face_map; /* for each face of the scene 0, or 1 + the number of its record in faces */
    int32_t (*normals)[3]; /* 2.30 */
    uint8_t *blend;        /* blend[256 * (colour - blend_first) + beneath] */
    uint32_t texture_count, surface_count, face_count, normal_count, blend_first, blend_count;
};

/* Reads the surfaces of an image into its scene. Returns true also where there are none. */
bool ref_surfaces_read(const uint8_t *bytes, ref_scene *scene);
void ref_surfaces_close(ref_surfaces *surfaces);

/* How a face looks in a frame. Null surface: it has none. */
typedef struct {
    const ref_surfaces *surfaces;
    const ref_surface *surface;
    const ref_texture *texture;     /* or null */
    const ref_texture_level *level; /* of the texture */
    const ref_light *light;         /* null: unlit */
    const ref_rgb565 *rgb565;       /* of frames of 16 bits a pixel; or null */
    const uint8_t *in_beam;         /* of a lit piece: what each colour is in a beam; or null */
    ref_view_point corner, sides[2];
    bool is_affine, is_billboard;
    bool is_in_front;     /* all corners: then points are theirs on the screen */
    bool is_light_coarse; /* a depth buffer of 16 bits: SPEC.md, section 9.1.1 */
    ref_screen_point points[3];
    double values[REF_VALUES], steps[2][REF_VALUES]; /* at the corner, and what each side adds */
    double scales[2]; /* texels of the level for one of the texture */
    const ref_texture_level
        *other;                  /* that the library may choose as well (SPEC.md, 9.4); or null */
    double rounding[REF_VALUES]; /* of a billboard: what a value may be off */
    uint8_t own;                 /* the face's own colour */
} ref_surface_view;

/* The values at a point of the screen. */
typedef struct {
    double values[REF_VALUES];
} ref_place;

/* Finds the look of a face of an instance; its number is counted in the model. rgb565: of frames of
 * 16 bits a pixel; or null. */
void ref_surface_look(const ref_scene *scene, const ref_camera *camera, const ref_lens *lens,
                      const ref_rgb565 *rgb565, const ref_instance *instance, uint32_t face,
                      ref_surface_view *view);

/* Returns false where the face's plane is not in front of the eye, or where a value is above 2^40.
 */
bool ref_surface_place(const ref_surface_view *view, const ref_lens *lens, double x, double y,
                       ref_place *place);

/* From where to where the library's values at a pixel's centre may be, of which `place` has the exact
 * ones: between those and what the promises of SPEC.md, sections 9.1.1 to 9.3, and docs/accuracy.md,
 * section 5, leave. */
void ref_surface_find_range(const ref_surface_view *view, const ref_lens *lens, int x, int y,
                            const ref_place *place, ref_place *low, ref_place *high);

/* The same look with the other level, if there is one. */
ref_surface_view ref_surface_with_level(const ref_surface_view *view,
                                        const ref_texture_level *level);

/* place sampling: the reference */
/* The colour of the texel in a column and a row, repeated or clamped; or REF_CLEAR. Without a
 * texture: the face's own. */
int ref_surface_texel(const ref_surface_view *view, int64_t column, int64_t row);

/* Finds the column and the row, within its level, of the texel at a point of the screen. False:
 * there is none. */
bool ref_surface_texel_at(const ref_surface_view *view, const ref_lens *lens, double x, double y,
                          int texel[2]);

/* A colour at a level of light, counted from 0 and limited to those that there are, and then in a beam, if the
 * view is that of a lit piece. */
uint8_t ref_surface_lit(const ref_surface_view *view, int64_t level, uint8_t colour);

/* The channels of a pixel of colours at corners, for these values of red, green and blue. */
void ref_surface_channels(const double values[REF_CHANNELS], int channels[REF_CHANNELS]);

/* A texel, or the face's own colour, in RGB565, before light: of a lit piece, in a beam. */
uint16_t ref_surface_full(const ref_surface_view *view, int texel);

/* Whether what is beneath a surface has a part in what it shows. */
bool ref_surface_mixes(const ref_surface *surface);

/* place stipple: what the judge asks of the pattern and of blends */
/* What a colour shows over another one. */
uint8_t ref_surface_over(const ref_surface_view *view, uint8_t colour, uint8_t beneath);

/* Whether the stipple of an opacity draws a pixel. */
bool ref_stipple_draws(int opacity, int x, int y);

/* The colour of a pixel of a face over another colour; or REF_CLEAR. Of the palette, or of RGB565.
 */
int ref_surface_colour(const ref_surface_view *view, const ref_lens *lens, int x, int y,
                       uint16_t beneath);

#endif
