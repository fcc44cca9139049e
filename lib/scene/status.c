/* SPDX-License-Identifier: MIT */
#include "fixel/types.h"

const char *fxl_status_text(fxl_status status)
{
    switch (status) {
    case FXL_OK:
        return "no error";
    case FXL_E_ARGUMENT:
        return "a pointer is null or a count is zero";
    case FXL_E_RANGE:
        return "a number is outside its stated range";
    case FXL_E_CAPACITY:
        return "the caller's memory, or a capacity that the build sets, is too small";
    case FXL_E_DEGENERATE:
        return "a polygon has fewer than three vertices";
    case FXL_E_ORDER:
        return "a function was called before another that must come first";
    case FXL_E_ALIGNMENT:
        return "an address or an offset is not aligned as it must be: to 4 or 8 bytes";
    case FXL_E_SIZE:
        return "the image is cut off, or its size is not that of its sections";
    case FXL_E_MAGIC:
        return "this is not a scene image";
    case FXL_E_VERSION:
        return "the scene image is of another version, or needs a section of another version: "
               "build it again";
    case FXL_E_CRC:
        return "the checksum does not match";
    case FXL_E_OFFSET:
        return "a table does not begin where it must, or reaches outside the image";
    case FXL_E_COUNT:
        return "a count is outside its stated range";
    case FXL_E_INDEX:
        return "an index is past the end of its table, or is not that of the entry that must "
               "follow";
    case FXL_E_NORMAL:
        return "a normal is not of unit length";
    case FXL_E_PLANARITY:
        return "a face vertex lies off the plane of its face or of its BSP node";
    case FXL_E_RESERVED:
        return "a reserved field or a kind has an unknown value";
    case FXL_E_RADIUS:
        return "a vertex, or the sphere of a BSP node, lies outside the sphere that must hold it";
    case FXL_E_FACE_BOUNDS:
        return "the stored bounds of a face differ from those of its vertices and its normal";
    case FXL_E_BSP:
        return "the BSP nodes form no tree or one that is too deep, or an instance may not have "
               "the tree's model or layer, or that model has clusters";
    case FXL_E_CLUSTER:
        return "a cluster's face may show its front to an eye in the cluster's cone";
    case FXL_E_PLACEMENT:
        return "the orientation of an instance is not a rotation";
    case FXL_E_DISPLAY:
        return "a display, or the wires to it, failed";
    case FXL_E_STALE:
        return "the handle is that of an instance that was removed, or that never was";
    case FXL_E_COMBINATION:
        return "two things that the renderer has do not go together: fxl_renderer_conflict names "
               "them";
    case FXL_STATUS_COUNT:
        break;
    }
    return "unknown status";
}
