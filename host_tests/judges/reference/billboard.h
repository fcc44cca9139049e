/* SPDX-License-Identifier: MIT */
/* Billboards (docs/extras/billboards.md) from their definition: a rectangle that is parallel to the
 * screen, at the place of an instance, with a picture on it. */
#ifndef REF_BILLBOARD_H
#define REF_BILLBOARD_H

#include "reference/order.h"

typedef struct {
    ref_texture texture; /* of one level */
    double width, height, anchor_x, anchor_y;
} ref_billboard;

struct ref_billboards {
    ref_billboard *boards;
    uint16_t *model_map; /* for each model of the scene 0, or 1 + the number of its billboard */
    uint32_t count;
};

/* Reads the billboards of an image into its scene. Returns true also where there are none. */
bool ref_billboards_read(const uint8_t *bytes, ref_scene *scene);
void ref_billboards_close(ref_billboards *billboards);

/* The billboard of an instance; null: it shows its faces. */
const ref_billboard *ref_billboard_of(const ref_scene *scene, const ref_instance *instance);

/* What becomes of a billboard. */
typedef enum {
    REF_BILLBOARD_DRAWN,
    REF_BILLBOARD_OUTSIDE,
    REF_BILLBOARD_REFUSED /* a corner is beyond 4095 pixels */
} ref_billboard_result;

/* Finds the outline on the screen, the look and the depth. Where the distance is near enough to a
 * plane of near or far for rounding to decide, drawn->in_doubt is set. Of what is not drawn the
 * outline has no points. */
ref_billboard_result ref_billboard_look(const ref_scene *scene, const ref_camera *camera,
                                        const ref_lens *lens, const ref_instance *instance,
                                        ref_drawn *drawn);

#endif
