/* SPDX-License-Identifier: MIT */
/* The planes that each clipper of the library cuts by, and those that it leaves to the scan
 * (docs/extras/clippers.md). */
#ifndef REF_CLIPPER_H
#define REF_CLIPPER_H

#include <stdbool.h>

#include "reference/frustum.h"

/* The bits of all planes. A clipper cuts by the planes whose bit, 1 << REF_PLANE_..., it has. On
 * the other sides it cuts only what is beyond the guard band. */
#define REF_CUT_ALL ((1u << REF_PLANE_COUNT) - 1)

/* How far the guard band reaches from the centre of the screen, in pixels. */
#define REF_GUARD_PIXELS 3500

/* How frames are drawn. */
typedef struct {
    unsigned cuts;  /* bits of the planes that cut */
    bool by_points; /* the clipper works from rounded points */
    bool by_bsp;    /* by the BSP, if the scene has one */
    bool flat;      /* faces in their own colours, whatever surfaces they have */
    int depth_bits; /* 16 or 32: by a depth buffer; else 0 */
    bool is_asked;  /* a visibility method was named; else the scene's image chooses */
} ref_method;

/* By a clipper that cuts by all planes, and by the BSP. */
#define REF_METHOD_OF_SCENE ((ref_method){.cuts = REF_CUT_ALL, .by_bsp = true})

/* Sets what a clipper or a visibility method of this name sets of a ref_method. Returns false where
 * none has that name. A span buffer gives the same picture as drawing over. */
bool ref_take_clipper(const char *name, void *method);
bool ref_take_visibility(const char *name, void *method);

#endif
