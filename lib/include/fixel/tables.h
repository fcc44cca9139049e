/* SPDX-License-Identifier: MIT */
/* What a scene has beside its models: a path and what moves, light, surfaces, billboards, lines and a horizon. These structures
 * too have the layout of a scene image. */
#ifndef FXL_TABLES_H
#define FXL_TABLES_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The keys that a player holds down, as bits. */
enum {
    FXL_KEY_FORWARD = 1u << 0,
    FXL_KEY_BACK = 1u << 1,
    FXL_KEY_LEFT = 1u << 2,     /* yaw decreases */
    FXL_KEY_RIGHT = 1u << 3,    /* yaw increases */
    FXL_KEY_PITCH_UP = 1u << 4, /* pitch increases */
    FXL_KEY_PITCH_DOWN = 1u << 5,
    FXL_KEY_ROLL_LEFT = 1u << 6, /* roll increases: the right side rises */
    FXL_KEY_ROLL_RIGHT = 1u << 7,
    FXL_KEY_ALL = 0xFFu
};

/* What the keys change in a step. */
typedef struct {
    fxl_q16_16 acceleration; /* world units per step per step, 0..256 */
    fxl_q16_16 friction;     /* the same unit and range; taken off the speed after the move */
    fxl_q16_16 speed_max;    /* world units per step, 0..256 */
    fxl_angle turn;          /* angle per step, at most a quarter turn */
} fxl_motion_limits;
#define FXL_MOTION_MAX FXL_CAST(fxl_q16_16, 256 * 65536)

/* A player: the eye, its speed, and a count. */
typedef struct {
    fxl_pose pose;
    fxl_q16_16 speed; /* world units per step along forward; negative is backward */
    uint32_t clamped; /* steps in which a coordinate was limited to FXL_COORDINATE_MAX */
} fxl_player;

/* The keys that a player holds down for a number of frames. */
typedef struct {
    uint16_t keys;   /* FXL_KEY_... */
    uint16_t frames; /* >= 1 */
} fxl_path_segment;

/* A key of a motion: centre, angles and scale in a frame (docs/extras/motion.md). */
typedef struct {
    uint32_t frame;   /* 0 for the first key, more than the key's before for the others */
    fxl_point centre; /* in the world, or in the parent's model; each coordinate below 2^30 */
    fxl_angle yaw, pitch, roll;
    fxl_q16_16 scale; /* FXL_SCALE_MIN..FXL_SCALE_MAX */
} fxl_motion_key;

/* How an instance moves: along its keys, and on a circle about that place, while its angles grow
 * and it spins about an axis of its own. Angles and steps are 0 for what a motion does not use. */
typedef struct {
    fxl_angle yaw_step, pitch_step, roll_step; /* a frame, on top of the keys' angles */
    fxl_point axis;                   /* of the spin, in the model, of any length; 0: no spin */
    fxl_angle spin, spin_step;        /* the spin in frame 0, and what a frame adds */
    fxl_q16_16 radius;                /* of the circle; 0: none */
    fxl_angle circle, circle_step;    /* 0 is +z of the place, a quarter +x */
    fxl_point extent;                 /* the largest |coordinate| of a key's centre */
    fxl_q16_16 scale_low, scale_high; /* the least and the largest scale of a key */
    uint32_t first_key, key_count;    /* the motions take the keys in turn; at least one each */
    uint16_t parent;  /* the number of a motion before this one, counted from 1; 0: none */
    uint8_t repeats;  /* 1: after the last key comes the first, in the same frame; else 0 */
    uint8_t reserved; /* 0 */
} fxl_motion;

/* The motions of a scene: of its last motion_count instances. All of them have placements. */
typedef struct {
    const fxl_motion *motions; /* null: nothing moves */
    uint32_t motion_count;
    const fxl_motion_key *keys;
    uint32_t key_count;
} fxl_motion_set;

/* The most point lights of a light; the fewest and the most levels of its ramp. */
#define FXL_LIGHT_POINTS_MAX 4
#define FXL_LIGHT_LEVELS_MIN 2
#define FXL_LIGHT_LEVELS_MAX 64

/* A light at a point of the world. It reaches as far as its range, and fades towards it. */
typedef struct {
    fxl_point position; /* each coordinate within FXL_COORDINATE_MAX */
    fxl_q16_16 range;   /* world units, 1/65536..8191 */
    fxl_q2_30 strength; /* 0..1 */
} fxl_point_light;

/* place light: a new setting: fxl_light_settings, fxl_light_base, fxl_light_settings_of */
/* place pixel-format: the colour of RGB565 that no light leaves */
/* What lights a frame (docs/extras/light.md). */
typedef struct {
    fxl_q2_30 ambient;       /* the brightness that every face has, 0..1 */
    fxl_q2_30 strength;      /* of the directional light, 0..1; 0: there is none */
    fxl_direction direction; /* in which it travels; of unit length where strength is not 0 */
    fxl_point_light points[FXL_LIGHT_POINTS_MAX];
    uint32_t point_count;         /* 0..FXL_LIGHT_POINTS_MAX */
    fxl_q16_16 fog_near, fog_far; /* depths: 0 <= begin < hides all <= FXL_FAR_MAX; both 0: none */
    const uint8_t *ramp;          /* ramp[256 * level + c]: the colour c at a level, from dark or
                                     hidden by fog (0) to full (levels - 1) */
    uint32_t levels;              /* FXL_LIGHT_LEVELS_MIN..FXL_LIGHT_LEVELS_MAX */
    uint16_t dark; /* RGB565 frames, which take no colour of the ramp: what no light leaves */
} fxl_light_settings;

/* The light of an image without its point lights, in the units and ranges of fxl_light_settings. */
typedef struct {
    fxl_q2_30 ambient, strength;
    fxl_direction direction;
    fxl_q16_16 fog_near, fog_far;
} fxl_light_base;

/* The light of an image: fxl_light_settings_of makes settings of it. */
typedef struct {
    const fxl_light_base *base;    /* null: the image has no light */
    const fxl_point_light *points; /* null: there are none */
    uint32_t point_count;
    const uint8_t *ramp; /* 256 bytes a level */
    uint32_t levels;
    uint16_t dark; /* a colour of RGB565 */
} fxl_scene_light;

/* A texture of a scene image: fxl_texture (fixel/surfaces.h) with places instead of pointers. */
typedef struct {
    uint32_t texels;  /* where in the image's texels its first byte is; FXL_TEXTURE_565: even */
    uint32_t colours; /* FXL_TEXTURE_4: where in the image's texels its 16 colours are; else 0 */
    uint8_t log_width, log_height, format, flags, key, levels;
    uint16_t key_565; /* FXL_TEXTURE_565: the key; else 0 */
} fxl_scene_texture;

typedef struct fxl_surface fxl_surface;
typedef struct fxl_mapped_face fxl_mapped_face;
typedef struct fxl_corner fxl_corner;

/* The surfaces of a scene image, of which fxl_surfaces_open (fixel/surfaces.h) makes a set. */
typedef struct {
    const fxl_scene_texture *textures;
    const uint8_t *texels; /* of all textures */
    const fxl_surface *surfaces;
    const fxl_mapped_face *faces;
    const uint16_t *face_map; /* one for each face of the scene; null: there are no surfaces */
    const fxl_corner *corners;
    const fxl_direction *normals;
    const uint8_t *blend; /* null: there is none */
    uint32_t texture_count, texel_bytes, surface_count, face_count, corner_count, normal_count;
    uint32_t blend_first, blend_count;
} fxl_scene_surfaces;

/* A billboard of an image: fxl_billboard, fxl_sprite (fixel/billboards.h), places for pointers. */
typedef struct {
    uint32_t pixels;  /* where in the image's sprite pixels its first byte is */
    uint32_t colours; /* 1 or 4 bits: where in them its 2 or 16 colours are; else 0 */
    uint16_t pixel_width, pixel_height;
    uint16_t key;           /* 0..255, or 256: all pixels are drawn */
    uint8_t bits, reserved; /* reserved: 0 */
    fxl_q16_16 width, height, anchor_x, anchor_y;
} fxl_scene_billboard;

/* The billboards of an image, of which fxl_billboards_open (fixel/billboards.h) makes a set. */
typedef struct {
    const fxl_scene_billboard *billboards;
    const uint8_t *pixels;     /* of all sprites */
    const uint16_t *model_map; /* one for each model of the scene; null: there are no billboards */
    uint32_t count, pixel_bytes;
} fxl_scene_billboards;

#define FXL_LINE_WIDTH_MAX 16 /* pixels */

/* A line between two vertices of a model, or a point at one (fixel/lines.h). */
typedef struct {
    uint16_t from, to; /* vertices of the model; the same one twice: a point */
    uint16_t faces[2]; /* of the model, counted from 1, on which it lies; 0: none */
    uint8_t colour;    /* palette index */
    uint8_t width;     /* pixels, 1..FXL_LINE_WIDTH_MAX */
    uint16_t reserved; /* 0 */
} fxl_line;

/* The lines of a scene: tables that the caller owns and that must outlive it. */
typedef struct {
    const fxl_line *lines;
    uint32_t count;           /* 0..FXL_SCENE_FACES_MAX */
    const uint32_t *line_map; /* model_count + 1 numbers: model i has the lines from line_map[i]
                                 (included) to line_map[i + 1] (not included) */
} fxl_line_set;

#define FXL_HORIZON_MAX 64u

/* What stands behind everything. The caller owns it, and keeps it as long as it is attached; it may
 * change between two frames: fxl_changed_find learns of it when the horizon is attached anew. */
typedef struct fxl_horizon {
    /* count sines of elevations in 2.30, ascending, each from -1 to 1: 0 is the horizon, 1 the
     * zenith. */
    const fxl_q2_30 *sines;
    /* count + 1 entries of the palette: colours[k] is seen where k of the sines are at most that of
     * the elevation. So colours[0] is that of the nadir. */
    const uint8_t *colours;
    uint32_t count; /* 1..FXL_HORIZON_MAX */
} fxl_horizon;

#ifdef __cplusplus
}
#endif

#endif
