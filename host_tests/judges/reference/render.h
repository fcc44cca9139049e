/* SPDX-License-Identifier: MIT */
/* The frame loop (SPEC.md, section 4), in double. */
#ifndef REF_RENDER_H
#define REF_RENDER_H

#include "reference/frustum.h"
#include "reference/order.h"
#include "reference/cull.h"

typedef struct {
    const ref_scene *scene;
    ref_lens lens;
    ref_camera camera;
    ref_frustum frustum; /* the planes that cut */
    ref_view_frustum view_frustum;
    ref_lattice_point eye;
    ref_order_entry *order, *faces;
    ref_method method; /* set before a frame */
    ref_counters counters;
    ref_display_list display_list; /* the frame's polygons */
    bool keeps_doubt;              /* set before a frame: the list says what depends on rounding */
    double *nearness;              /* of each pixel, while it draws by one */
    uint32_t *shown; /* set before drawing, or null: receives for each pixel 1 + the number in the
                        display list of the polygon that changed it last; the caller clears it */
    const ref_rgb565 *rgb565;      /* set before a frame of 16 bits a pixel; else null */
    bool draws_names;              /* set before drawing: a pixel shows the name of its face */
    uint32_t unsplit;              /* instances of the frame that were not cut to the BSP */
} ref_renderer;

/* A pixel that shows a colour of the palette. */
uint16_t ref_pixel_of(const ref_renderer *renderer, uint8_t colour);

/* Initialises a renderer. Returns false where memory is short. The scene must outlive the
 * renderer. */
bool ref_renderer_init(ref_renderer *renderer, const ref_scene *scene, const ref_lens *lens);
void ref_renderer_close(ref_renderer *renderer);

/* Computes all that the frame draws: fills display_list and counters. Returns false where memory
 * is short. */
bool ref_frame_begin(ref_renderer *renderer, const ref_pose *pose);

/* Whether a polygon is blended with those beneath it. */
bool ref_is_blended(const ref_drawn *drawn);

/* Whether what is behind a polygon may be seen through it: it is blended, has a pattern of holes or
 * a texture with a key. */
bool ref_lets_through(const ref_drawn *drawn);

/* The name of a face of an instance: 1..255, by both numbers, the same name for few of them. */
uint8_t ref_face_name(uint32_t instance, uint32_t face);

/* Draws the frame's polygons that reach a band over it. The caller clears the band first. */
void ref_frame_draw(const ref_renderer *renderer, const ref_band *band);

#endif
