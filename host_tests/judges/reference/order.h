/* SPDX-License-Identifier: MIT */
/* The order of drawing, and the list of what is drawn. */
#ifndef REF_ORDER_H
#define REF_ORDER_H

#include "reference/cull.h"
#include "reference/depth.h"
#include "reference/surface.h"

/* The order of drawing (SPEC.md, section 6), exact in 128 bits. */

__extension__ typedef unsigned __int128 ref_square;

typedef struct {
    ref_square distance;
    uint32_t index, layer;
} ref_order_entry;

/* Write the entries of the instances that the sphere test does not reject, and of the faces of
 * an instance that face the eye and lie in no cluster that the sphere test rejects. entries must
 * have room for all of them. Both return how many they wrote. *left_out becomes the number of faces
 * in rejected clusters. */
uint32_t ref_order_instances(const ref_scene *scene, const ref_lattice_point *eye,
                             const ref_camera *camera, const ref_view_frustum *frustum,
                             ref_order_entry *entries);
uint32_t ref_order_faces(const ref_scene *scene, const ref_instance *instance,
                         const ref_lattice_point *eye, const ref_camera *camera,
                         const ref_view_frustum *frustum, bool by_number, ref_order_entry *entries,
                         uint32_t *left_out);

/* The display list of a frame (SPEC.md, section 7), in double and of any length. */

/* What a line or a point that was drawn has, beside the outline of its pixels. */
typedef struct {
    bool is_line, upright;
    int plane_count; /* of the faces on which it lies, and which face the eye */
    uint32_t faces[2];
    ref_depth_plane planes[2];
    ref_screen_point corners[2]; /* of each face, on the screen */
    double heights[2];           /* how thin each face is there, in pixels; 0: not known */
    double octaves[2][2];        /* the least power of two above the least and above the greatest
                                    depth near / z of each face */
    double from, to, nearness[2]; /* of one on no face: both ends along its major axis */
} ref_line_look;

/* A polygon that was drawn: its outline in the reference renderer, the rows that it reaches, and
 * the face that it came from. */
typedef struct {
    ref_screen_polygon
        polygon;  /* no points: the reference renderer leaves it out; but see in_doubt */
    double shade; /* RGB565: 1 less the brightness of a flat face; 0 with a surface */
    ref_rows rows;
    uint32_t instance, face; /* numbers in the scene and in the model */
    ref_surface_view look;   /* of the face */
    ref_depth_plane depth;   /* of the face, where the renderer's depth_bits is not 0 */
    ref_line_look line;      /* where it is a line, whose outline is that of its pixels */

    /* Whether the rounding of depths may decide what near and far leave of the polygon
     * (docs/accuracy.md, section 4). If so, least and most are the least and the most that they
     * leave; either may have no points. Set only if the renderer's keeps_doubt is. */
    bool in_doubt;
    ref_screen_polygon least, most;
} ref_drawn;

/* The polygons in the order of drawing. Unlike the library's list it keeps the polygons that
 * reach no row, because a judge needs all polygons that the library may have drawn. */
typedef struct {
    ref_drawn *drawn;
    size_t count, capacity;
} ref_display_list;

/* Appends a polygon. Returns false where memory is short. A list of zeroes is empty. */
bool ref_display_list_append(ref_display_list *list, const ref_drawn *drawn);

/* Returns the next polygon, from *place on, that reaches one of the given rows, and moves *place
 * behind it. Returns null when there are no more. */
const ref_drawn *ref_display_list_next(const ref_display_list *list, ref_rows rows, size_t *place);

void ref_display_list_close(ref_display_list *list);

#endif
