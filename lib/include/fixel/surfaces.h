/* SPDX-License-Identifier: MIT */
/* Surfaces: what a face shows instead of one colour. docs/extras/surfaces.md; SPEC.md, section 9.
 */
#ifndef FXL_SURFACES_H
#define FXL_SURFACES_H

#include "fixel/light.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_TEXTURE_LOG_MAX  8u /* a texture is 1 to 256 texels wide and high */
#define FXL_TEXTURES_MAX     65535u
#define FXL_SURFACES_MAX     65535u
#define FXL_MAPPED_FACES_MAX 65535u

/* The largest texture coordinate: 16383 texels. */
#define FXL_TEXEL_MAX FXL_CAST(fxl_q16_16, 16383 * 65536)

/* A place on a texture, in texels: u along a row, v downward. The texel in column i and row j
 * covers i <= u < i + 1, j <= v < j + 1. */
typedef struct {
    fxl_q16_16 u, v;
} fxl_texel;

/* place pixel-format: the records of painters, and formats of texels */
enum {
    FXL_TEXTURE_8 = 0,  /* a byte a texel: its palette index */
    FXL_TEXTURE_4 = 1,  /* two texels a byte, the left one in the lower bits: an index into
                           `colours`; log_width is at least 1 */
    FXL_TEXTURE_565 = 2 /* two bytes a texel: an array of uint16_t, RGB565 in the core's byte order.
                           In frames of 16 bits a pixel alone: docs/extras/rgb565.md */
};

enum {
    FXL_TEXTURE_CLAMP = 1u << 0, /* beyond its edge a texture shows the texel of the edge; else it
                                    repeats */
    FXL_TEXTURE_KEYED = 1u << 1  /* texels of the colour `key` are not drawn */
};

/* A texture of 2^log_width x 2^log_height texels. Rows follow each other without a gap. After them
 * come levels - 1 smaller pictures, each half as wide and as high as the one before, and at least
 * one texel (of 4 bits: two); a face takes one of them, by its distance. */
typedef struct {
    const uint8_t *texels;
    const uint8_t *colours; /* FXL_TEXTURE_4: 16 palette indices; else null */
    uint8_t log_width, log_height;
    uint8_t format;   /* FXL_TEXTURE_8, FXL_TEXTURE_4, FXL_TEXTURE_565 */
    uint8_t flags;    /* FXL_TEXTURE_CLAMP, FXL_TEXTURE_KEYED */
    uint8_t key;      /* palette index */
    uint8_t levels;   /* 1..9 */
    uint16_t key_565; /* FXL_TEXTURE_565: the key; else 0 */
} fxl_texture;

/* How often texture coordinates and light are divided exactly. Between two divisions they are
 * linear. Columns of the screen count from its left. */
enum {
    FXL_DIVIDE_16 = 0, /* at each 16th column; where that may be more than 0.3 texel off, at
                          each 8th or 4th one, or at each pixel */
    FXL_DIVIDE_8 = 1,  /* twice as often: nowhere more than 0.075 texel off */
    FXL_DIVIDE_1 = 2,  /* at each pixel */
    FXL_AFFINE = 3 /* nowhere: linear on the screen. Where one of the face's three vertices is not
                      on the screen, as FXL_DIVIDE_16 */
};

enum {
    FXL_SURFACE_LIT = 1u << 0, /* light is found at the three vertices, and is linear over the face:
                                  fxl_attach_lit */
    FXL_SURFACE_BLEND = 1u << 1, /* colours are blended with those beneath: by the set's table, in a
                                    frame of 16 bits a pixel by `sixteenths` */
    FXL_SURFACE_ADD = 1u << 2, /* colours are added to those beneath: in such a frame alone, and not
                                  together with FXL_SURFACE_BLEND */
    FXL_SURFACE_COLOURS = 1u << 3 /* each of the three vertices has a colour, and the face what is
                                     between them: in such a frame alone, and without a texture */
};

/* What faces look like. */
struct fxl_surface {
    uint16_t texture;    /* its number, counted from 1; 0: the face's own colour */
    uint8_t division;    /* FXL_DIVIDE_16 and so on */
    uint8_t flags;       /* FXL_SURFACE_LIT and so on */
    uint8_t opacity;     /* 16: opaque; 1..15: so many of 16 pixels are drawn, in a fixed pattern */
    uint8_t sixteenths;  /* FXL_SURFACE_BLEND: what a frame of 16 bits a pixel shows of the colour
                            itself, 1..16; 0: 8. Else 0 */
    uint8_t reserved[2]; /* 0 */
    uint32_t first_corner; /* from which its faces count their corners; mostly 0 */
};

/* What a surface has at a vertex. Faces that meet there share it where they have the same. */
struct fxl_corner {
    fxl_texel
        texel; /* each coordinate within FXL_TEXEL_MAX. FXL_SURFACE_COLOURS: u is the colour at
                        the vertex, FXL_CORNER_COLOUR, and v is 0 */
    uint16_t vertex; /* its number within the model */
    uint16_t normal; /* its number; FXL_SURFACE_LIT only, else 0 */
};

/* A face that has a surface. Three corners, whose vertices are not on one line, say where the
 * texture lies; over the rest of their plane it is linear. Their vertices are those of the face,
 * or, of a face that is a part of another, of the whole. So all parts of a face share a record. */
struct fxl_mapped_face {
    uint16_t surface;    /* a number */
    uint16_t corners[3]; /* numbers, counted from the surface's first corner on */
};

/* A colour at a vertex: red, green and blue from 0 to 255. */
#define FXL_CORNER_COLOUR(red, green, blue) FXL_CAST(fxl_q16_16, (red)*65536 + (green)*256 + (blue))

/* The surfaces of a scene: tables that the caller owns and that must outlive it. */
typedef struct {
    const fxl_texture *textures;
    const fxl_surface *surfaces;
    const fxl_mapped_face *faces;
    const uint16_t *face_map; /* one for each face of the scene: 0, or the number of its record in
                                 faces, counted from 1 */
    const fxl_corner *corners;
    const fxl_direction *normals; /* at vertices, in the model */
    uint32_t texture_count, surface_count, face_count, corner_count, normal_count;
    const uint8_t *blend; /* blend[256 * (colour - blend_first) + beneath]: what FXL_SURFACE_BLEND
                             shows of a colour over another; null where no surface has that flag */
    uint32_t blend_first, blend_count; /* the colours that are blended; others are opaque. The sum
                                          is at most 256 */
} fxl_surface_set;

/* Bytes of a blend table of so many colours. */
#define FXL_BLEND_TABLE_BYTES(colours) (256u * (colours))

/* What draws faces with surfaces into a target: FXL_SURFACES_OF. Members are internal. */
typedef struct fxl_painter fxl_painter;

/* Those of each target. FXL_SURFACES_OF(fxl_palette) is the address of one. */
extern const fxl_painter fxl_palette_surfaces, fxl_palette_depth_16_surfaces,
    fxl_palette_depth_32_surfaces, fxl_rgb565_surfaces, fxl_rgb565_depth_16_surfaces,
    fxl_rgb565_depth_32_surfaces;
#define FXL_SURFACES_OF(target) (&target##_surfaces)

/* The same without colours at corners: in RGB565, a program that names no other one links 2.8 KB
 * less by -Os, and with a depth buffer 8.0 KB less at -O2 on a Cortex-M3. With a surface
 * FXL_SURFACE_COLOURS no frame begins: it does not go with the painter.
 * FXL_TEXTURES_OF(fxl_rgb565) is the address of one. */
extern const fxl_painter fxl_palette_textures, fxl_palette_depth_16_textures,
    fxl_palette_depth_32_textures, fxl_rgb565_textures, fxl_rgb565_depth_16_textures,
    fxl_rgb565_depth_32_textures;
#define FXL_TEXTURES_OF(target) (&target##_textures)

/* The surfaces of a renderer, which the caller owns. Members are internal. */
typedef struct {
    fxl_shader shader;
    const fxl_surface_set *set;
    const fxl_light *light; /* null: faces are not lit */
    const struct fxl_surface_light_code *light_code;
    const fxl_painter *painter;
    const fxl_shader *beams; /* null: there are none */
} fxl_surfaces;

/* Checks the surfaces of a scene: every count, number, range and reserved field; that the three
 * vertices of a face are not on one line; that normals have unit length; that a set with a surface
 * that is FXL_SURFACE_BLEND has a table. pixel_bits: of the frames that they are for, 8 or 16. With
 * 16, textures may be FXL_TEXTURE_565, surfaces may be FXL_SURFACE_ADD and FXL_SURFACE_COLOURS, and
 * FXL_SURFACE_BLEND needs
 * no table. Requires a checked scene and tables as long as their counts; fault may be null.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ALIGNMENT: a table is not aligned, or the texels of a texture FXL_TEXTURE_565 to 2 bytes.
 * FXL_E_COUNT: a count is out of its range.
 * FXL_E_INDEX: an index is past the end of its table.
 * FXL_E_RANGE: a number is out of its range.
 * FXL_E_NORMAL: a normal is not of unit length.
 * FXL_E_DEGENERATE: vertices on one line.
 * FXL_E_RESERVED: an unknown value; a texture of a surface FXL_SURFACE_COLOURS; with 8 bits also a
 * texture FXL_TEXTURE_565 and a surface FXL_SURFACE_ADD or FXL_SURFACE_COLOURS.
 * With each of these statuses: *fault written.
 * On FXL_OK *fault is untouched. */
fxl_status fxl_surfaces_check(const fxl_surface_set *set, const fxl_scene *scene,
                              uint32_t pixel_bits, fxl_scene_fault *fault);

/* Makes a set of the surfaces of a scene image. textures: memory for its textures, which must
 * outlive *set, as the image must; it may be null if there are none. Checks that each texture lies
 * within the image's texels, and as fxl_surfaces_check for image->pixel_bits.
 * Requires an image that fxl_scene_open has opened; fault may be null.
 * FXL_E_ARGUMENT: a null pointer; an image without surfaces.
 * FXL_E_ALIGNMENT: textures are not aligned.
 * FXL_E_CAPACITY: more textures than capacity.
 * FXL_E_OFFSET: a table reaches outside the image.
 * The statuses of fxl_surfaces_check.
 * With each of these statuses: *set untouched, *fault written; textures may be overwritten.
 * On FXL_OK *fault is untouched. */
fxl_status fxl_surfaces_open(const fxl_scene_image *image, fxl_texture *textures, uint32_t capacity,
                             fxl_surface_set *set, fxl_scene_fault *fault);

/* Attaches the surfaces of a set to a renderer, or, where set is null, detaches them. painter is
 * FXL_SURFACES_OF the renderer's target, or FXL_TEXTURES_OF it. The renderer keeps a pointer to *surfaces, and that one to
 * *set. What else is attached, before or after, does not matter. The next frame must begin anew.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the renderer was never initialised.
 * The statuses of fxl_surfaces_check, for the bits of the painter's pixels.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_attach_surfaces(fxl_renderer *renderer, fxl_surfaces *surfaces,
                               const fxl_surface_set *set, const fxl_painter *painter);

/* The light at the vertices of lit surfaces. */
typedef struct {
    fxl_shader shader;
    const struct fxl_surface_light_code *code;
} fxl_lit_surfaces;

/* Has surfaces that are FXL_SURFACE_LIT take the light that fxl_attach_light attaches, at their
 * vertices, or, where lit is null, be drawn at full brightness. Without a light, or without
 * surfaces, it changes nothing. The renderer keeps a pointer to *lit. The next frame must begin
 * anew.
 * FXL_E_ARGUMENT: renderer is null.
 * FXL_E_ORDER: the renderer was never initialised.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_attach_lit(fxl_renderer *renderer, fxl_lit_surfaces *lit);

/* place stipple: a blend: its flag, and what makes its table */
/* Makes a blend table for the colours first..first + count - 1 of a palette of 256 colours of three
 * bytes, red, green, blue. The entry of a colour over another is the one of the palette that is
 * nearest to beneath + (colour - beneath) * sixteenths / 16, each of the three rounded to nearest,
 * halves upward; nearest as for fxl_light_make_ramp. Where colour and the one beneath are the same,
 * it is that colour. It looks at 65536 * count pairs of colours; a program with little time
 * computes the table on the host, and keeps it in flash.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: sixteenths is not within 1..16.
 * FXL_E_COUNT: count of 0, or first + count above 256.
 * With each of these statuses: table untouched. */
fxl_status fxl_blend_make_table(const uint8_t *palette, uint32_t sixteenths, uint32_t first,
                                uint32_t count, uint8_t *table);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_surfaces_reasons[];

#ifdef __cplusplus
}
#endif

#endif
