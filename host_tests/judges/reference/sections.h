/* SPDX-License-Identifier: MIT */
/* A scene image as sections, and the parts of a scene that an image need not have. */
#ifndef REF_SECTIONS_H
#define REF_SECTIONS_H

#include <stddef.h>
#include <stdint.h>

#include "reference/scene.h"

/* The sections of a scene image, as docs/formats.md, section 1.2, lists them. */

/* Their kinds. */
enum {
    REF_PALETTE = 1,
    REF_VERTICES,
    REF_INDICES,
    REF_FACES,
    REF_MODELS,
    REF_INSTANCES,
    REF_POSES,
    REF_SEGMENTS,
    REF_FACE_BOUNDS,
    REF_BSP_NODES,
    REF_BEAMS,
    REF_LIT_COLOURS,
    REF_CLUSTERS,
    REF_PLACEMENTS,
    REF_MOTIONS,
    REF_MOTION_KEYS,
    REF_LIGHT,
    REF_POINT_LIGHTS,
    REF_RAMP,
    REF_TEXTURES,
    REF_TEXELS,
    REF_SURFACES,
    REF_MAPPED_FACES,
    REF_CORNERS,
    REF_FACE_MAP,
    REF_CORNER_NORMALS,
    REF_BLEND_TABLE,
    REF_BILLBOARDS,
    REF_BILLBOARD_MAP,
    REF_SPRITE_PIXELS,
    REF_LENS_CENTRE,
    REF_WHOLE_FACES,
    REF_LENS_SCALE,
    REF_LINES,
    REF_LINE_MAP,
    REF_HORIZON_SINES,
    REF_HORIZON_COLOURS,
    REF_LAST_KIND = REF_HORIZON_COLOURS
};

/* Tells what is wrong with the header of an image, with the table of sections, with where they lie,
 * or with which there are; null if nothing is. */
const char *ref_sections_check(const uint8_t *bytes, size_t size);

/* Returns the first entry of a section, and writes how many there are; null and 0 where there is no
 * such section. Requires sections that are sound. */
const uint8_t *ref_section(const uint8_t *bytes, int kind, uint32_t *count);

/* The same, and memory for a record of `size` zeros for each entry and one more, which the caller
 * frees; null where memory is short. */
void *ref_table(const uint8_t *bytes, int kind, size_t size, const uint8_t **entries,
                uint32_t *count);

/* The parts of a scene image that it need not have (docs/formats.md, section 1): light, placements,
 * a BSP, clusters, beams. Each function returns true also where the image has none of its own, and
 * false where a part is not usable. The tables that it makes are ref_scene_close's to free. */

bool ref_light_part_read(const uint8_t *bytes, ref_scene_image *image);
bool ref_placements_read(const uint8_t *bytes, ref_scene_image *image);
bool ref_bsp_read(const uint8_t *bytes, ref_scene *scene);
bool ref_clusters_read(const uint8_t *bytes, ref_scene *scene);
bool ref_beams_read(const uint8_t *bytes, ref_scene *scene);

#endif
