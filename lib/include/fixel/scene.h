/* SPDX-License-Identifier: MIT */
/* Scenes: models, objects and a path, used in place from a scene image. The
 * byte layout of an image is docs/formats.md, section 1; these structures are that
 * layout, so a scene may also be written as C tables. */
#ifndef FXL_SCENE_H
#define FXL_SCENE_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How much a scene may hold. Placed vertices are those of all objects' models
 * added up: the limit bounds the loader's time. */
#define FXL_SCENE_IMAGE_MAX         (16u * 1024u * 1024u)
#define FXL_SCENE_VERTICES_MAX      1000000u
#define FXL_SCENE_INDICES_MAX       4000000u
#define FXL_SCENE_FACES_MAX         1000000u
#define FXL_SCENE_MODELS_MAX        65535u
#define FXL_SCENE_INSTANCES_MAX     65535u
#define FXL_SCENE_PATH_MAX          1000000u
#define FXL_SCENE_PLACED_MAX        4000000u
#define FXL_SCENE_FACE_VERTICES_MAX 24u
#define FXL_MODEL_VERTICES_MAX      65535u
#define FXL_MODEL_FACES_MAX         65535u
#define FXL_BSP_NODES_MAX           65535u
#define FXL_BSP_DEPTH_MAX           1023u /* of a node below the root */

/* How far the vertices of a node's faces may lie from its plane. */
#define FXL_BSP_PLANARITY_MAX FXL_CAST(fxl_q16_16, 8)

/* No node. */
#define FXL_BSP_NONE 0xFFFFu

/* A face: count corners from corners[first_index] on, each the number of a
 * vertex of the model, clockwise as seen from the front. The normal points to
 * the front and alone decides which side that is. */
typedef struct {
    fxl_direction normal;
    uint32_t first_index;
    uint8_t count; /* 3..24; a build draws up to FXL_FACE_VERTICES_MAX */
    uint8_t colour;
    uint16_t reserved; /* 0 */
} fxl_face;

/* What ordering asks of a face in every frame, worked out beforehand. */
typedef struct {
    uint32_t height_low; /* normal . first vertex in 18.46, two's complement */
    uint32_t height_high;
    int32_t box_x, box_y, box_z; /* minimum + maximum of the vertices, 16.16 */
} fxl_face_bounds;

enum {
    FXL_MODEL_CONVEX = 0, /* faces drawn by number */
    FXL_MODEL_SORTED = 1  /* faces drawn far to near */
};

/* A model: vertex_count vertices from vertices[first_vertex] on, face_count
 * faces from faces[first_face] on. Models share neither: the first begins at
 * 0, each begins where the one before ends, the last ends with the tables.
 * Vertices are relative to the object's centre; none is farther from it than
 * the radius. The smaller the radius, the sooner an object is left out. */
typedef struct {
    uint32_t first_vertex, vertex_count; /* vertex_count 3..65535 */
    uint32_t first_face, face_count;     /* face_count 1..65535 */
    uint8_t kind;
    uint8_t reserved[3];        /* 0 */
    fxl_q16_16 radius;          /* 0..FXL_RADIUS_MAX */
    uint32_t first_face_bounds; /* of a sorted model where the scene has keys, else 0 */
} fxl_model;

/* A model put somewhere. Objects of a lower layer are drawn first; within a
 * layer far to near. */
typedef struct {
    fxl_point centre;
    uint16_t model;
    uint8_t layer;
    uint8_t reserved; /* 0 */
} fxl_instance;

/* A node of a tree over the faces of one object (docs/extras/bsp.md): a plane,
 * relative to the object's centre, the faces on it, and what is in front of it
 * and behind. Nodes are listed as one comes upon them: root, front, back. */
typedef struct {
    fxl_direction normal;
    uint32_t distance_low;           /* 18.46, two's complement: a point is in front where */
    uint32_t distance_high;          /* normal . point > distance */
    uint16_t front, back, parent;    /* numbers of nodes, or FXL_BSP_NONE */
    uint16_t first_face, face_count; /* within the model, the first behind the node's before */
    uint16_t reserved;               /* 0 */
    fxl_point centre;                /* of a sphere that holds its faces, and the spheres of */
    fxl_q16_16 radius;               /* the nodes in front and behind; 0..FXL_RADIUS_MAX */
} fxl_bsp_node;

/* Planes of one beam, and beams of one scene. */
#define FXL_BEAM_PLANES_MAX 8
#define FXL_BEAMS_MAX       4

/* A plane of the world, as in a scene image: inside where normal . point >= distance. */
typedef struct {
    fxl_direction normal; /* to unit length as a face's is */
    uint32_t distance_low;
    uint32_t distance_high; /* the distance in 18.46, two's complement, below 2^61 */
} fxl_beam_plane;

enum {
    FXL_BEAM_POINT = 0,    /* light comes from a point of the world */
    FXL_BEAM_DIRECTION = 1 /* light travels along a direction */
};

/* A beam. The order of its planes is that in which they cut (docs/extras/beams.md). */
typedef struct {
    int32_t from[3]; /* the point in 16.16, or the direction in 2.30 */
    uint8_t kind;
    uint8_t plane_count; /* 1..FXL_BEAM_PLANES_MAX; the others are all 0 */
    uint16_t reserved;   /* 0 */
    fxl_beam_plane planes[FXL_BEAM_PLANES_MAX];
} fxl_beam;

/* What a player holds down, as bits. */
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

/* How fast keys work, per step. */
typedef struct {
    fxl_q16_16 acceleration; /* world units per step per step, 0..256 */
    fxl_q16_16 friction;     /* the same, taken off the speed after moving, 0..256 */
    fxl_q16_16 speed_max;    /* world units per step, 0..256 */
    fxl_angle turn;          /* angle per step, at most a quarter turn */
} fxl_motion_limits;

#define FXL_MOTION_MAX FXL_CAST(fxl_q16_16, 256 * 65536)

/* Who looks, and moves. */
typedef struct {
    fxl_pose pose;
    fxl_q16_16 speed; /* along the view, negative is backward */
    uint32_t clamped; /* steps in which a coordinate was held at the range's end */
} fxl_player;

/* What a player holds down for a number of frames. */
typedef struct {
    uint16_t keys;   /* FXL_KEY_... */
    uint16_t frames; /* >= 1 */
} fxl_path_segment;

/* A scene: tables that the caller owns and that outlive it. Without keys it is
 * drawn the same, and its sorted models take longer. */
typedef struct {
    const fxl_point *vertices;
    const uint16_t *indices;
    const fxl_face *faces;
    const fxl_model *models;
    const fxl_instance *instances;
    uint32_t vertex_count, index_count, face_count, model_count, instance_count;
    uint32_t order_needed; /* entries that fxl_renderer_init_with asks for */
    const fxl_face_bounds
        *face_bounds; /* one for each face of each sorted model in turn; or null */
    uint32_t face_bounds_count;
    const fxl_bsp_node *bsp_nodes; /* of a tree over the faces of one object; or null */
    uint32_t bsp_node_count;
    uint32_t bsp_instance; /* whose: its model is sorted, and no other object's; 0 without a tree */
    const fxl_beam *beams; /* of light, for fxl_renderer_set_beams; or null */
    uint32_t beam_count;
    const uint8_t *lit; /* for each colour, the one that it has in a beam; or null */
} fxl_scene;

/* Everything that a scene image holds beside the scene. */
typedef struct {
    fxl_scene scene;
    fxl_lens lens;
    uint8_t background;
    const uint8_t *palette; /* 256 x red, green, blue */
    fxl_player start;       /* where a walk begins */
    fxl_motion_limits motion_limits;
    const fxl_pose *poses;            /* one a frame; null where the path is strides */
    const fxl_path_segment *segments; /* null where the path is poses */
    uint32_t path_count;              /* poses or strides */
    uint32_t frame_count;             /* frames of the whole path */
} fxl_scene_image;

/* Where a check failed: the number of the element, counted from 0, and of
 * what. For people. */
typedef struct {
    const char *what; /* "vertex", "face", "object" and so on; never null */
    uint32_t index;
} fxl_scene_fault;

/* Checks a scene written as tables: every count, index, range, normal and
 * planarity, that no vertex lies outside its model's radius, and that every
 * vertex of every object lies within FXL_COORDINATE_MAX; sets order_needed. scene->order_needed is
 * written only on FXL_OK; *fault (may be null) only on an error. FXL_E_ARGUMENT, _COUNT, _INDEX,
 * _RANGE, _RADIUS, _NORMAL, _PLANARITY, _KEY, _TREE,
 * _RESERVED; _CAPACITY for a face of more than
 * FXL_FACE_VERTICES_MAX vertices, which a build with a larger FXL_POLYGON_CAPACITY would draw.
 * A scene that has a tree or beams is refused (FXL_E_ARGUMENT): fxl_scene_check_all checks those
 * too. A program that does not call it links neither check. */
fxl_status fxl_scene_check(fxl_scene *scene, fxl_scene_fault *fault);

/* The same for a scene that may have a tree and beams, which it checks. */
fxl_status fxl_scene_check_all(fxl_scene *scene, fxl_scene_fault *fault);

/* Opens a scene image of size bytes in memory aligned to four bytes, on a
 * little-endian machine. Checks everything before anything is used: magic,
 * version, size, checksum, every table, every count, index and range. Nothing
 * is copied: the image must outlive *opened. size may exceed what the image
 * says it needs (a flash partition is longer than what is in it).
 * *opened is written only on FXL_OK, *fault (may be null) only on an error. */
fxl_status fxl_scene_open(const void *image, size_t size, fxl_scene_image *opened,
                          fxl_scene_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
