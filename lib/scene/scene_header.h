/* SPDX-License-Identifier: MIT */
/* The header of a scene image, byte for byte (docs/formats.md, section 1.1). Internal. */
#ifndef SCENE_HEADER_H
#define SCENE_HEADER_H

#include "fixel/scene.h"

typedef struct {
    uint32_t offset, count;
} table;

/* The header of an image, byte for byte. */
typedef struct {
    uint32_t magic;
    uint16_t version, header_size;
    uint32_t image_size, crc;
    uint16_t width, height;
    uint32_t fov;
    int32_t near_z, far_z, inset;
    uint8_t background, path_kind;
    uint8_t has_centre; /* 1: a lens_centre follows the whole header; else 0 */
    uint8_t visibility; /* FXL_SCENE_BY_... */
    fxl_pose start;
    int32_t acceleration, friction, speed_max;
    uint32_t turn;
    table palette, vertices, indices, faces, models, instances, path;
    uint32_t frame_count;
    table face_bounds, bsp_nodes;
    uint32_t bsp_instance;
} header;

/* The rest of the header, only if the scene has beams. */
typedef struct {
    table beams;
    uint32_t lit; /* offset of 256 bytes */
    uint32_t reserved;
} beam_header;

/* The rest of the header after that of beams, only if the scene has clusters. */
typedef struct {
    table clusters;
} cluster_header;

/* The rest of the header after that of clusters, only if the scene has turned instances. */
typedef struct {
    table turns, motions, keys;
} turn_header;

/* The rest of the header after that of turned instances, only if the scene has light or surfaces.
 */
typedef struct {
    table light, points, ramp; /* of the ramp: its levels */
} light_header;

/* Behind the header, however long that is, only if the lens is off-centre. */
typedef struct {
    fxl_q16_16 x, y;
} lens_centre;

/* The rest of the header after that of light, only if the scene has surfaces. */
typedef struct {
    table textures, texels, surfaces, mapped_faces, face_map, corner_normals;
    table blend; /* of the table: its colours */
    uint32_t blend_first, reserved;
} surface_header;

/* The rest of the header after that of surfaces, only if the scene has billboards. */
typedef struct {
    table billboards, model_map;
    table pixels; /* of all sprites, bytes */
} billboard_header;

FXL_STATIC_ASSERT(sizeof(header) == 160, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(offsetof(header, start) == 40, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(offsetof(header, palette) == 80, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(offsetof(header, frame_count) == 136, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_point) == 12, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_face) == 20, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_model) == 28, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_instance) == 16, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_face_bounds) == 20, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(offsetof(header, bsp_nodes) == 148, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_bsp_node) == 48, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(lens_centre) == 8, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(beam_header) == 16, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_beam) == 176, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(cluster_header) == 8, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_cluster) == 48, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(offsetof(fxl_model, first_cluster) == 18, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(turn_header) == 24, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_turn) == 40, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_motion) == 76, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_motion_key) == 32, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(light_header) == 24, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_light_base) == 28, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_point_light) == 20, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(surface_header) == 64, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_scene_texture) == 16, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(billboard_header) == 24, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_scene_billboard) == 32, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_pose) == 24, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(sizeof(fxl_path_segment) == 4, "docs/formats.md, section 1");
FXL_STATIC_ASSERT(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "images are used in place");

#define MAGIC            0x534C5846u /* "FXLS" */
#define VERSION          2u
#define VERSION_MORE     3u /* has a BSP tree, or beams, or both */
#define VERSION_CLUSTERS 4u /* has clusters, and may have a BSP tree and beams */
#define VERSION_TURNS    5u /* has turned instances, and may have all the others */
#define VERSION_LIGHT    6u /* has light or surfaces, and may have all the others */
#define VERSION_BOARDS   7u /* has billboards, and may have all the others */
#define PALETTE_ENTRIES  256u

/* Bytes of a surface and of a mapped face, which fixel/surfaces.h defines. */
#define SURFACE_SIZE     8u
#define MAPPED_FACE_SIZE 36u

#define BEAM_HEADER_SIZE    (sizeof(header) + sizeof(beam_header))
#define CLUSTER_HEADER_SIZE (BEAM_HEADER_SIZE + sizeof(cluster_header))
#define TURN_HEADER_SIZE    (CLUSTER_HEADER_SIZE + sizeof(turn_header))
#define LIGHT_HEADER_SIZE   (TURN_HEADER_SIZE + sizeof(light_header))
#define SURFACE_HEADER_SIZE (LIGHT_HEADER_SIZE + sizeof(surface_header))
#define BOARD_HEADER_SIZE   (SURFACE_HEADER_SIZE + sizeof(billboard_header))

enum {
    PATH_POSES = 0,
    PATH_SEGMENTS = 1
};

/* Null where the header has no such part. A part before another may be 0. */
static inline const beam_header *beam_header_of(const header *head)
{
    return head->header_size > sizeof *head ? (const beam_header *)(const void *)(head + 1) : NULL;
}

static inline const cluster_header *cluster_header_of(const header *head)
{
    return head->header_size > BEAM_HEADER_SIZE
               ? (const cluster_header *)(const void *)(beam_header_of(head) + 1)
               : NULL;
}

static inline const turn_header *turn_header_of(const header *head)
{
    return head->header_size > CLUSTER_HEADER_SIZE
               ? (const turn_header *)(const void *)(cluster_header_of(head) + 1)
               : NULL;
}

static inline const light_header *light_header_of(const header *head)
{
    return head->header_size > TURN_HEADER_SIZE
               ? (const light_header *)(const void *)(turn_header_of(head) + 1)
               : NULL;
}

/* Its tables may be empty where there are billboards. */
static inline const surface_header *surface_header_of(const header *head)
{
    return head->header_size > LIGHT_HEADER_SIZE
               ? (const surface_header *)(const void *)(light_header_of(head) + 1)
               : NULL;
}

static inline const billboard_header *billboard_header_of(const header *head)
{
    return head->header_size > SURFACE_HEADER_SIZE
               ? (const billboard_header *)(const void *)(surface_header_of(head) + 1)
               : NULL;
}

/* Checks that each table lies within the image, and is as long as others want it. */
fxl_status fxl_scene_tables_check(const header *head, fxl_scene_fault *fault);

/* Has what is opened point to the tables, which fxl_scene_tables_check has checked. */
void fxl_scene_tables_open(const header *head, fxl_scene_image *opened);

#endif
