/* SPDX-License-Identifier: MIT */
/* Planes, and the view frustum in the world, in double. */
#ifndef REF_FRUSTUM_H
#define REF_FRUSTUM_H

#include <stdbool.h>

#include "reference/camera.h"

/* Makes the plane through a point, with a normal that points inside, moved inside by inset. */
ref_plane ref_plane_from_point(const ref_point *point, const ref_point *normal, double inset);

/* Returns how far a point lies inside; negative outside. Summed in 64 bits: exact where normal
 * and point are the library's integers. */
long double ref_plane_distance(const ref_plane *plane, const ref_point *point);

/* Makes the plane through three points. Its normal points to where they run clockwise. Returns
 * false where they lie on one line. */
bool ref_plane_from_points(const ref_point *a, const ref_point *b, const ref_point *c,
                           ref_plane *plane);

/* The view frustum (SPEC.md, section 4.3), in double. */

enum {
    REF_PLANE_NEAR,
    REF_PLANE_FAR,
    REF_PLANE_LEFT,
    REF_PLANE_RIGHT,
    REF_PLANE_BOTTOM,
    REF_PLANE_TOP,
    REF_PLANE_COUNT
};

typedef struct {
    ref_plane planes[REF_PLANE_COUNT];
} ref_frustum;

ref_frustum ref_frustum_from_camera(const ref_camera *camera, const ref_lens *lens);

/* Makes the same frustum, except for the sides without a bit in cuts: they lie at this many
 * pixels from the middle of the screen, without an inset (docs/extras/clippers.md, section 2.3). */
ref_frustum ref_frustum_with_guard(const ref_camera *camera, const ref_lens *lens, unsigned cuts,
                                   double pixels);

/* --- clippers ----------------------------------------------------------------------------------- */

/* The planes that each clipper of the library cuts by, and those that it leaves to the scan
 * (docs/extras/clippers.md). */

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
