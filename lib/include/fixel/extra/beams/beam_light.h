/* SPDX-License-Identifier: MIT */
/* Beams for a renderer: its faces are split by them, the lit parts drawn lit. */
#ifndef FXL_BEAM_LIGHT_H
#define FXL_BEAM_LIGHT_H

#include "fixel/extra/beams/beam.h"
#include "fixel/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes that beams want of the caller's memory, aligned to 8. With one beam of 4, 5 or 8
 * planes 1,320, 1,408 or 1,624 on a core of 32 bits. 0 where they are out of what fxl_beams_fit
 * allows. Requires checked beams. */
uint32_t fxl_beam_light_workspace_size(const fxl_beam *beams, uint32_t beam_count);

/* Has a renderer draw by the light of 1..FXL_BEAMS_MAX beams; none, with whatever else, puts
 * the light out. lit[c] is the colour of what is drawn in colour c and lies in a beam. beams,
 * lit and room are kept hold of. Then a frame must begin anew.
 * FXL_E_ARGUMENT; FXL_E_COUNT; what fxl_beam_check says; FXL_E_CAPACITY where the room does
 * not suffice, or a face of the renderer's scene has too many vertices (fxl_beams_fit):
 * renderer untouched but for refused_calls. */
fxl_status fxl_renderer_set_beams(fxl_renderer *renderer, const fxl_beam *beams,
                                  uint32_t beam_count, const uint8_t *lit, void *workspace,
                                  uint32_t workspace_size);

#ifdef __cplusplus
}
#endif

#endif
