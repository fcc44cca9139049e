/* SPDX-License-Identifier: MIT */
/* What a public function answers. The world's fault is a status and changes
 * nothing; our own bug is an assertion. */
#ifndef FXL_STATUS_H
#define FXL_STATUS_H

typedef enum {
    FXL_OK = 0,
    FXL_E_ARGUMENT,   /* a null pointer, or a count of zero where one is needed */
    FXL_E_RANGE,      /* a number outside its stated range */
    FXL_E_CAPACITY,   /* memory handed in, or a capacity set at build, does not suffice */
    FXL_E_DEGENERATE, /* fewer than three vertices */
    FXL_E_ORDER,      /* a call out of order: draw before begin */
    FXL_E_ALIGNMENT,  /* image or offset not a multiple of four bytes */
    FXL_E_SIZE,       /* image shorter than it says, or longer than allowed */
    FXL_E_MAGIC,      /* not a scene image */
    FXL_E_VERSION,    /* a scene image of another version */
    FXL_E_CRC,        /* the checksum does not match */
    FXL_E_OFFSET,     /* a table that reaches outside the image */
    FXL_E_COUNT,      /* a count outside its stated range */
    FXL_E_INDEX,      /* an index past the end of the table it points into */
    FXL_E_NORMAL,     /* a face normal that is not of unit length */
    FXL_E_PLANARITY,  /* a face vertex off the plane of its face */
    FXL_E_RESERVED,   /* a reserved field or an enumeration holds an unknown value */
    FXL_E_RADIUS,     /* a vertex farther from its model's origin than the model's radius */
    FXL_E_KEY,        /* a face's key that is not what its vertices and its normal say */
    FXL_E_TREE,       /* nodes of a tree that do not hang together, or lie too deep */
    FXL_STATUS_COUNT
} fxl_status;

/* One clear sentence for a status, never null; unknown values included. */
const char *fxl_status_text(fxl_status status);

#endif
