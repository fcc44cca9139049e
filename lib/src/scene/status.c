/* SPDX-License-Identifier: MIT */
#include "fixel/types.h"

#include <stddef.h>

static const char *const texts[FXL_STATUS_COUNT] = {
    [FXL_OK] = "no error",
    [FXL_E_ARGUMENT] = "a pointer is null or a count is zero",
    [FXL_E_RANGE] = "a number is outside its stated range",
    [FXL_E_CAPACITY] = "the caller's memory, or a capacity that the build sets, is too small",
    [FXL_E_DEGENERATE] = "a polygon has fewer than three vertices",
    [FXL_E_ORDER] = "a function was called before another that must come first",
    [FXL_E_ALIGNMENT] = "an address or an offset is not a multiple of four",
    [FXL_E_SIZE] = "the image is shorter than its header says, or longer than allowed",
    [FXL_E_MAGIC] = "this is not a scene image",
    [FXL_E_VERSION] = "this version of the scene image is not known",
    [FXL_E_CRC] = "the checksum does not match",
    [FXL_E_OFFSET] = "a table reaches outside the image",
    [FXL_E_COUNT] = "a count is outside its stated range",
    [FXL_E_INDEX] = "an index points past the end of its table",
    [FXL_E_NORMAL] = "a face normal is not of unit length",
    [FXL_E_PLANARITY] = "a face vertex lies off the plane of its face",
    [FXL_E_RESERVED] = "a reserved field or a kind has an unknown value",
    [FXL_E_RADIUS] = "a vertex lies farther from its model's origin than the model's radius",
    [FXL_E_FACE_BOUNDS] =
        "the stored bounds of a face differ from those of its vertices and its normal",
    [FXL_E_BSP] = "the nodes of the BSP tree do not form one tree, or the tree is too deep",
};

const char *fxl_status_text(fxl_status status)
{
    if ((unsigned)status >= FXL_STATUS_COUNT || texts[status] == NULL) {
        return "unknown status";
    }
    return texts[status];
}
