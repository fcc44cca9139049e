/* SPDX-License-Identifier: MIT */
/* A small scene that tests may change: cubes of side 2, as tables and as a
 * scene image. */
#ifndef TINY_H
#define TINY_H

/* place field: small images, each field broken */
#include "scene/scene_sections.h"
#include "unit.h"

enum {
    TINY_INSTANCES = 3,
    TINY_POSES = 2,
    TINY_STRIDES = 2
};

/* Of both models: a little more than sqrt(3). */
#define TINY_RADIUS Q16(1.75)

/* Two models of the same cube, the first convex, the second sorted. Colours of
 * the first are 1..6, of the second 11..16: -x +x -y +y -z +z. */
typedef struct {
    fxl_point vertices[16];
    uint16_t corners[48];
    fxl_face faces[12];
    fxl_model models[2];
    fxl_instance instances[TINY_INSTANCES];
    fxl_face_bounds keys[6]; /* of the second model */
    fxl_scene scene;
} tiny_scene;

/* The scene anew: object 0 (model 0) about the origin, 1 (model 1) at z = 10,
 * 2 (model 0) at (5, 1, 12). Not checked yet. */
tiny_scene *tiny_make(void);

/* Byte offsets of a scene image's header (docs/formats.md, section 1.1). */
enum {
    AT_MAGIC = 0,
    AT_VERSION = 4,
    AT_SECTION_COUNT = 6,
    AT_SIZE = 8,
    AT_CRC = 12,
    AT_WIDTH = 16,
    AT_HEIGHT = 18,
    AT_FOV = 20,
    AT_NEAR = 24,
    AT_FAR = 28,
    AT_INSET = 32,
    AT_BACKGROUND = 36,
    AT_TARGET = 37,
    AT_START = 40,
    AT_MOTION_LIMITS = 64,
    AT_FRAMES = 80,
    AT_BSP_INSTANCE = 84,
    AT_BLEND_FIRST = 88,
    HEADER_SIZE = 92,
    /* The offsets of tiny's sections in the table of sections. 4 bytes on is the count, 4 bytes
     * before are kind, whether it is needed, and a reserved byte. */
    SECTION_BYTES = 12,
    AT_PALETTE = HEADER_SIZE + 4,
    AT_VERTICES = AT_PALETTE + SECTION_BYTES,
    AT_CORNERS = AT_VERTICES + SECTION_BYTES,
    AT_FACES = AT_CORNERS + SECTION_BYTES,
    AT_MODELS = AT_FACES + SECTION_BYTES,
    AT_INSTANCES = AT_MODELS + SECTION_BYTES,
    AT_PATH = AT_INSTANCES + SECTION_BYTES,
    AT_KEYS = AT_PATH + SECTION_BYTES,
    AT_MORE = AT_KEYS + SECTION_BYTES, /* of the first section that a test adds */
    TINY_SECTIONS = 8,
    TINY_WORDS = 704
};

typedef struct {
    uint32_t words[TINY_WORDS]; /* aligned to four bytes */
    uint32_t size;
} tiny_image;

/* The image of tiny_make's scene: 48x32, 90 degrees, a path of two poses (or
 * two strides of 3 and 4 frames), sealed. */
tiny_image *tiny_image_make(bool strides);

/* Puts a section into an image, in place of that of its kind, and in the order of the kinds; or
 * takes that out if count is 0. Each is as needed as the format says. Not sealed. */
void tiny_set_section(tiny_image *image, uint16_t kind, const void *entries, uint32_t count,
                      uint32_t entry_size);

/* Bytes of the image, and of an entry of a table. */
uint8_t *tiny_at(tiny_image *image, uint32_t offset);
uint8_t *tiny_entry(tiny_image *image, uint32_t table, uint32_t number, uint32_t entry_size);

uint32_t tiny_get(tiny_image *image, uint32_t offset);
void tiny_put32(uint8_t *at, uint32_t value);
void tiny_put16(uint8_t *at, uint16_t value);

/* Writes the checksum that the contents now have. */
void tiny_seal(tiny_image *image);

/* The scene whose sorted cube has three clusters. */
enum {
    CLUSTERS = 3
};

typedef struct {
    tiny_scene *tiny;
    fxl_cluster clusters[CLUSTERS];
} cluster_scene;

/* The scene anew. Of the cube's faces (-x +x -y +y -z +z) cluster 0 has -x, with a cone; cluster 1
 * has +x and -y, with a cone of 45 degrees about (1, -1, 0); cluster 2 has the last three, which
 * have no cone, as +z and -z face away from each other. */
cluster_scene *cluster_make(void);

/* What the definition says of a cluster, and of a face, of the sorted cube. */
typedef struct {
    bool (*is_outside)(const cluster_scene *made, const fxl_view *view, const fxl_cluster *cluster);
    bool (*is_front)(const cluster_scene *made, const fxl_view *view, const fxl_face *face);
} cluster_definition;

/* Of the sorted cube's faces: how many lie in clusters that are outside, and how many of the others
 * do not face the eye. */
void cluster_count(const cluster_scene *scene, const cluster_definition *definition,
                   const fxl_view *view, uint32_t *outside, uint32_t *backfacing);

#endif
