/* SPDX-License-Identifier: MIT */
/* The parts of a scene image that it need not have (docs/formats.md, section 1): light, placements,
 * a BSP, clusters, beams. Each function returns true also where the image has none of its own, and
 * false where a part is not usable. The tables that it makes are ref_scene_close's to free. */
#ifndef REF_SCENE_PARTS_H
#define REF_SCENE_PARTS_H

#include "reference/scene.h"

bool ref_light_part_read(const uint8_t *bytes, ref_scene_image *image);
bool ref_placements_read(const uint8_t *bytes, ref_scene_image *image);
bool ref_bsp_read(const uint8_t *bytes, ref_scene *scene);
bool ref_clusters_read(const uint8_t *bytes, ref_scene *scene);
bool ref_beams_read(const uint8_t *bytes, ref_scene *scene);

#endif
