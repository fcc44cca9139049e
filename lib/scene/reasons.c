/* SPDX-License-Identifier: MIT */
/* What the functions of these headers refuse. */
#include "../math/core.h"
#include "fixel/camera.h"
#include "fixel/crc.h"
#include "fixel/scene.h"
#include "reasons.h"

const char fxl_camera_reasons[] =
    ON_ARGUMENT "lens, part and camera must not be null\0"
    ON_RANGE "width and height must be 1..1024, fov FXL_DEGREES(10)..FXL_DEGREES(150), "
    "near_z at least FXL_RATIO(1, 256), near_z + 2 inset less than far_z, far_z "
    "at most FXL_UNITS(32767), inset 0..FXL_UNITS(1); a centre at most 1.5 "
    "screens and 4 focal lengths from the middle, without inset; a position "
    "within FXL_UNITS(-8191)..FXL_UNITS(8191)\0";

const char fxl_crc_reasons[] =
    ON_ARGUMENT "crc, band and band->pixels must not be null\0"
    ON_RANGE "band->width must be 1..1024, band->rows 1..1024, and band->first_column + "
    "columns at most width and stride\0"
    ON_ALIGNMENT "band->pixels must begin at an even address: a pixel of RGB565 takes 2 "
    "bytes\0";

const char fxl_scene_reasons[] =
    ON_ARGUMENT "a pointer must not be null; a scene with clusters, a tree or beams is "
    "checked by fxl_scene_check_all\0"
    ON_RANGE "positions must be within FXL_UNITS(-8191)..FXL_UNITS(8191), radii 0..28375 "
    "units, scales 1/256..256, light 0..FXL_Q2_30_ONE, distances of beams below "
    "2^61\0"
    ON_CAPACITY "a face must have at most FXL_FACE_VERTICES_MAX vertices; with beams fewer, "
    "by their planes\0"
    ON_DEGENERATE "a window must be convex, and the light at least 2^-12 unit off its "
    "planes\0"
    ON_ALIGNMENT "image and tables must be aligned to 4 bytes, indices to 2\0"
    ON_SIZE "size must be at least that which the image states: the image is cut off\0"
    ON_MAGIC "image must be one that fixel build wrote: it does not begin as one\0"
    ON_VERSION "image must be of the library's version: build it again\0"
    ON_CRC "image must be as it was written: its checksum does not match\0"
    ON_OFFSET "each table of image must begin where the one before it ends, and lie "
    "within it\0"
    ON_COUNT "counts must be within FXL_SCENE_..._MAX, vertices of a face 3..24, corners "
    "of a window 3..7, planes of a beam 1..8, points of light 0..4, its levels "
    "2..64\0"
    ON_INDEX "indices must be below the counts of their tables, and records in turn\0"
    ON_NORMAL "normals and directions must be of unit length, to within 2^-28\0"
    ON_PLANARITY "vertices of a face must be within 4/65536 unit of its plane\0"
    ON_RESERVED "reserved members must be 0, kinds among those that scene.h names\0"
    ON_RADIUS "radius of a model must reach each of its vertices\0"
    ON_FACE_BOUNDS "face_bounds of a face must be those of its vertices and its normal\0"
    ON_BSP "bsp_nodes must be a tree in pre-order, and no other instance may have its "
    "model, or a sorted model in its layer\0"
    ON_CLUSTER "an eye within a cluster's cone must not see the front of its faces\0"
    ON_PLACEMENT "the rows of each placement's orientation must be those of a rotation, to "
    "within 2^-28\0";

FXL_COLD const char *fxl_explain(const char *reasons, fxl_status status)
{
    while (reasons != NULL && *reasons != '\0') {
        const char *sentence = reasons + 1;
        if (fxl_bits_32(*reasons) == (uint32_t)status) {
            return sentence;
        }
        while (*sentence != '\0') {
            sentence++;
        }
        reasons = sentence + 1;
    }
    return NULL;
}
