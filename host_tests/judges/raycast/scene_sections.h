/* SPDX-License-Identifier: MIT */
/* The sections of a scene image (docs/formats.md, section 1.2). */
#ifndef RAYCAST_SCENE_SECTIONS_H
#define RAYCAST_SCENE_SECTIONS_H

#include "file.h"

/* place field: the ray-cast oracle's reader: sizes */
/* place field: a field of the header: SECTIONS_AT */
enum {
    SECTIONS_AT = 92, /* the table of sections follows the header */
    KIND_PALETTE = 1,
    KIND_VERTICES = 2,
    KIND_INDICES = 3,
    KIND_FACES = 4,
    KIND_MODELS = 5,
    KIND_INSTANCES = 6,
    KIND_POSES = 7,
    KIND_SEGMENTS = 8,
    KIND_BSP_NODES = 10,
    KIND_BEAMS = 11,
    KIND_LIT_COLOURS = 12,
    KIND_PLACEMENTS = 14,
    KIND_MOTIONS = 15,
    KIND_MOTION_KEYS = 16,
    KIND_LIGHT = 17,
    KIND_POINT_LIGHTS = 18,
    KIND_RAMP = 19,
    KIND_TEXTURES = 20,
    KIND_SURFACES = 22,
    KIND_MAPPED_FACES = 23,
    KIND_CORNERS = 24,
    KIND_FACE_MAP = 25,
    KIND_BLEND_TABLE = 27,
    KIND_BILLBOARDS = 28,
    KIND_BILLBOARD_MAP = 29,
    KIND_SPRITE_PIXELS = 30,
    KIND_LENS_CENTRE = 31,
    KIND_WHOLE_FACES = 32,
    KIND_LENS_SCALE = 33,
    KIND_LINES = 34,
    KIND_LINE_MAP = 35,
    KIND_HORIZON_SINES = 36,
    KIND_HORIZON_COLOURS = 37,
    KINDS = 38
};

/* A section: its first entry, and how many there are. Null and 0: there is none. */
typedef struct {
    const uint8_t *at;
    uint32_t count;
} table;

/* Writes the sections of an image by their kinds, and takes off the block what is behind the image.
 * Does not return if the header is not one, if a section is not where it must be, or if one is
 * missing that must be there. */
void sections_read(const char *path, file_block *image, table sections[KINDS]);

#endif
