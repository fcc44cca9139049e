/* SPDX-License-Identifier: MIT */
/* The header of a scene image and its table of sections, byte for byte (docs/formats.md, section 1).
 * Internal. */
#ifndef FXL_SCENE_HEADER_H
#define FXL_SCENE_HEADER_H

#include <stddef.h>
#include <stdint.h>

#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* place field: a field of the header: fxl_image_header */
/* The header of an image. */
typedef struct {
    uint32_t magic;
    uint16_t version, section_count;
    uint32_t image_size, crc;
    uint16_t width, height;
    uint32_t fov;
    int32_t near_z, far_z, inset;
    uint8_t background;
    uint8_t target; /* docs/formats.md, section 1 */
    uint16_t dark;
    fxl_pose start;
    int32_t acceleration, friction, speed_max;
    uint32_t turn;
    uint32_t frame_count;
    uint32_t bsp_instance; /* 0 where there is no tree */
    uint32_t blend_first;  /* 0 where there is no blend table */
} fxl_image_header;

/* An entry of the table of sections, which follows the header. */
typedef struct {
    uint16_t kind; /* SECTION_... */
    uint8_t is_needed, reserved;
    uint32_t offset, count;
} fxl_image_section;

typedef struct {
    fxl_q16_16 x, y;
} fxl_image_centre;

typedef struct {
    fxl_q16_16 scale;
} fxl_image_scale;

#define FXL_AS_DOCUMENTED "docs/formats.md, section 1"

FXL_STATIC_ASSERT(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "images are used in place");

/* Checks the header of an image in a block of size bytes, and its sections: each lies where it must,
 * and is as long as others want it. Requires a block that is aligned to four bytes.
 * FXL_E_SIZE, FXL_E_MAGIC, FXL_E_CRC, FXL_E_RESERVED, FXL_E_OFFSET, FXL_E_COUNT, FXL_E_ALIGNMENT,
 * FXL_E_VERSION (also where a section that is needed is unknown): *fault written. */
fxl_status fxl_scene_sections_check(const fxl_image_header *head, size_t size,
                                    fxl_scene_fault *fault);

/* The entry of a section in the table of an image whose header was checked; null: there is none. */
const fxl_image_section *fxl_scene_section(const fxl_image_header *head, uint32_t kind);

#ifdef __cplusplus
}
#endif

#endif
