/* SPDX-License-Identifier: MIT */
#include "fixel/types.h"

#include <stddef.h>

static const char *const texts[FXL_STATUS_COUNT] = {
    [FXL_OK] = "no error",
    [FXL_E_ARGUMENT] = "a pointer is null or a count is zero",
    [FXL_E_RANGE] = "a number is outside its stated range",
    [FXL_E_CAPACITY] = "the memory handed in, or a capacity set at build, does not suffice",
    [FXL_E_DEGENERATE] = "a polygon has fewer than three vertices",
    [FXL_E_ORDER] = "a call came out of order",
    [FXL_E_ALIGNMENT] = "an address or offset is not a multiple of four",
    [FXL_E_SIZE] = "the image is shorter than it says, or longer than allowed",
    [FXL_E_MAGIC] = "this is not a scene image",
    [FXL_E_VERSION] = "the scene image has another version",
    [FXL_E_CRC] = "the checksum does not match",
    [FXL_E_OFFSET] = "a table reaches outside the image",
    [FXL_E_COUNT] = "a count is outside its stated range",
    [FXL_E_INDEX] = "an index points past the end of its table",
    [FXL_E_NORMAL] = "a face normal is not of unit length",
    [FXL_E_PLANARITY] = "a face vertex lies off the plane of its face",
    [FXL_E_RESERVED] = "a reserved field or a kind holds an unknown value",
    [FXL_E_RADIUS] = "a vertex lies farther from its model's origin than the model's radius",
    [FXL_E_FACE_BOUNDS] = "a face's key is not what its vertices and its normal say",
    [FXL_E_BSP] = "the nodes of a tree do not hang together, or lie too deep",
};

const char *fxl_status_text(fxl_status status)
{
    if ((unsigned)status >= FXL_STATUS_COUNT || texts[status] == NULL) {
        return "unknown status";
    }
    return texts[status];
}
