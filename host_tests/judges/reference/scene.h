/* SPDX-License-Identifier: MIT */
/* A scene image (docs/formats.md, section 1), read byte by byte into tables of the reference
 * renderer. */
#ifndef REF_SCENE_H
#define REF_SCENE_H

#include "reference/camera.h"

typedef struct {
    int32_t normal[3]; /* 2.30 */
    uint32_t first_index;
    uint8_t count, material;
    uint16_t whole_count; /* of a part: the vertices of the whole face, behind its own; or 0 */
} ref_face;

enum {
    REF_MODEL_CONVEX = 0,
    REF_MODEL_SORTED = 1
};

typedef struct {
    uint32_t first_vertex, vertex_count, first_face, face_count;
    uint8_t kind;
    int32_t radius;         /* 16.16; no vertex is farther from the instance's centre */
    uint32_t first_cluster; /* counted from 1; 0: it has no clusters */
} ref_model;

/* A cluster: faces of a model in turn, in a sphere relative to the instance's centre. */
typedef struct {
    ref_lattice_point centre;
    int32_t radius; /* 16.16 */
    uint32_t face_count;
} ref_cluster;

typedef struct {
    ref_lattice_point centre;
    uint16_t model;
    uint8_t layer;
} ref_instance;

/* How an instance is turned and scaled. */
typedef struct {
    int32_t rows[3][3]; /* 2.30: the world's axes as the model sees them */
    int32_t scale;      /* 16.16 */
} ref_placement;

#define REF_BSP_NONE 65535u

/* A node of the BSP (docs/extras/bsp.md), relative to the centre of the BSP's instance. */
typedef struct {
    int32_t normal[3]; /* 2.30 */
    int64_t distance;  /* 18.46 */
    uint32_t front, back, parent, first_face, face_count;
} ref_bsp_node;

typedef struct {
    uint16_t keys, frames;
} ref_path_segment;

enum {
    REF_BEAM_POINT = 0,
    REF_BEAM_DIRECTION = 1
};

/* A light beam: a convex part of the world. */
typedef struct {
    int32_t from[3]; /* a point in 16.16, or the direction of the light in 2.30 */
    uint8_t kind;
    int plane_count;
    ref_plane planes[8];
} ref_beam;

typedef struct ref_light ref_light;
typedef struct ref_surfaces ref_surfaces;
typedef struct ref_billboards ref_billboards;

/* A line between two vertices of a model, or a point at one. */
typedef struct {
    uint16_t from, to, faces[2]; /* faces: counted from 1; 0: none */
    uint8_t colour, width;
} ref_line;

#define REF_HORIZON_MAX 64

/* What stands behind everything (docs/extras/horizon.md). */
typedef struct {
    int count; /* 0: there is none */
    double sines[REF_HORIZON_MAX];
    uint8_t colours[REF_HORIZON_MAX + 1];
} ref_horizon;

typedef struct {
    ref_lattice_point *vertices; /* relative to the instance's centre */
    uint16_t *indices;
    ref_face *faces;
    ref_model *models;
    ref_instance *instances;
    uint32_t vertex_count, index_count, face_count, model_count, instance_count;
    ref_bsp_node *bsp_nodes; /* null where there is no BSP */
    uint32_t bsp_node_count, bsp_instance;
    ref_beam *beams; /* null where there are none */
    uint32_t beam_count;
    uint8_t lit[256];      /* the colour of each colour in a beam */
    ref_cluster *clusters; /* null where there are none */
    uint32_t cluster_count;
    ref_placement
        *placements; /* of the instances from first_turned on; null where there are none */
    uint32_t first_turned;
    ref_surfaces *surfaces;     /* null where there are none */
    ref_billboards *billboards; /* null where there are none */
    const ref_light *light;     /* light at run time; or null */
    ref_line *lines;    /* null where there are none */
    uint32_t *line_map; /* of each model where its lines begin; behind them their number */
    ref_horizon horizon;
    bool has_outlines;  /* each face of a frame with depth has its edges as lines */
    uint8_t outline;    /* their colour */
} ref_scene;

/* place pixel-format: what the image asks for */
typedef struct {
    ref_scene scene;
    ref_lens lens;
    uint8_t background;
    int depth_bits;              /* of the depth buffer that the scene asks for, or 0 */
    bool is_rgb565, by_distance; /* it asks for frames of 16 bits; for the order by distance */
    uint16_t dark;               /* what light leaves in frames of 16 bits */
    uint8_t palette[768];
    ref_pose start;
    ref_motion_limits motion_limits;
    ref_pose *poses;            /* null where the path is segments */
    ref_path_segment *segments; /* null where the path is poses */
    uint32_t path_count, frame_count;
    uint32_t motion_count; /* instances that move; the reference draws them as in frame 0 */
    ref_light *light;      /* the scene's, if the image has one; or null */
} ref_scene_image;

/* Reads an image. Returns null, or one sentence that says what is wrong; *image then holds
 * nothing. Checks what the reference renderer relies on: lens, tables, counts and indices. The
 * rest is checked by the library's loader. */
const char *ref_scene_open(const uint8_t *bytes, size_t size, ref_scene_image *image);
void ref_scene_close(ref_scene_image *image);

/* CRC-32, IEEE 802.3, reflected; start with 0 and continue with the result. */
uint32_t ref_crc32(uint32_t crc, const uint8_t *bytes, size_t size);

/* Little-endian fields. */
uint16_t ref_u16(const uint8_t *bytes);
uint32_t ref_u32(const uint8_t *bytes);
int32_t ref_i32(const uint8_t *bytes);

/* Reads a point of 12 bytes, and a pose of 24 (position, yaw, pitch, roll), as here and in the
 * frame dump. */
ref_pose ref_pose_read(const uint8_t *bytes);
ref_lattice_point ref_point_read(const uint8_t *bytes);

/* Returns a vertex of a face in the model. */
ref_lattice_point ref_face_corner(const ref_scene *scene, const ref_instance *instance,
                                  const ref_face *face, int corner);

/* Face `number` of an instance's model. */
const ref_face *ref_face_of(const ref_scene *scene, const ref_instance *instance, uint32_t number);

/* Returns a vertex of an instance's model, as it stands there, and in the world, exactly; of an
 * instance that is turned, rounded once. */
ref_lattice_point ref_model_vertex(const ref_scene *scene, const ref_instance *instance,
                                   uint32_t number);
ref_lattice_point ref_instance_vertex(const ref_scene *scene, const ref_instance *instance,
                                      uint32_t number);

/* Returns a vertex of a face in the world, exactly; of an instance that is turned, rounded once. */
ref_lattice_point ref_face_vertex(const ref_scene *scene, const ref_instance *instance,
                                  const ref_face *face, int corner);

#endif
