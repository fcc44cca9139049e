/* SPDX-License-Identifier: MIT */
/* Light beams: convex parts of the world in which faces are drawn lit. If a face is turned to the
 * light, the part of it within a beam is drawn in the lit variant of its colour, and the rest in
 * its own colour. Nothing casts a shadow within a beam. Beams, and the functions that make one, are
 * in fixel/scene.h: a scene may have some. Source: "Realtime 3D Clipping" (C6). */
#ifndef FXL_BEAMS_H
#define FXL_BEAMS_H

#include "fixel/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Returns the bytes of workspace that the beams need, aligned to 8. One beam of 4, 5 or 8 planes
 * needs 1,296, 1,384 or 1,600 on a 32-bit core. Another workspace (fxl_workspace_init) needs 40
 * less for it. Returns 0 if beams is null, if beam_count is outside 1..FXL_BEAMS_MAX, or if not
 * even a triangle fits: the vertices of a face, the planes of the first beam and twice the planes
 * of each further beam may come to FXL_FACE_VERTICES_MAX. Requires checked beams. */
uint32_t fxl_beam_light_workspace_size(const fxl_beam *beams, uint32_t beam_count);

/* Beams, and what they make of colours. The caller's tables; they must outlive the renderer's use.
 */
typedef struct {
    const fxl_beam *beams;
    uint32_t count;     /* 1..FXL_BEAMS_MAX */
    const uint8_t *lit; /* lit[c]: the lit variant of colour c, also of a texel */
} fxl_beam_set;

/* Attaches the beams of a set to a renderer, in any sequence with what else is attached, or, where
 * set is null, detaches them: then memory and size are ignored. memory has at least
 * fxl_beam_light_workspace_size bytes, aligned to 8. The renderer keeps pointers to memory and to
 * the set's tables. The caller must begin a frame anew: fxl_frame_begin refuses beams beside
 * textures of the format FXL_TEXTURE_565 and surfaces FXL_SURFACE_COLOURS, whose colours `lit` does
 * not know.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ALIGNMENT: memory is not aligned to 8 bytes, or beams to 4.
 * FXL_E_ORDER: the renderer was never initialised.
 * FXL_E_COUNT: a count is out of its range.
 * The statuses of fxl_beam_check.
 * FXL_E_CAPACITY: memory is too small; or the vertices of a face of the renderer's scene, the
 * planes of the first beam and twice the planes of each further beam come to more than
 * FXL_FACE_VERTICES_MAX.
 * With each of these statuses: the renderer is untouched, except for refused_calls. */
fxl_status fxl_attach_beams(fxl_renderer *renderer, const fxl_beam_set *set, void *memory,
                            uint32_t size);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_beams_reasons[];

#ifdef __cplusplus
}
#endif

#endif
