/* SPDX-License-Identifier: MIT */
/* Light and fog at run time: each flat face gets one level of a ramp of its colour, in RGB565 a
 * part of it. docs/extras/light.md. The settings, and their check, are in fixel/scene.h: an image
 * may have a light. */
#ifndef FXL_LIGHT_H
#define FXL_LIGHT_H

#include "fixel/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes of a ramp of so many levels. */
#define FXL_LIGHT_RAMP_BYTES(levels) (256u * (levels))

/* place light: FXL_LIGHT_ERROR_MAX */
/* The bound of a face's brightness, in units of 2^-30: it is this near to the exact value of
 * docs/extras/light.md, section 2. So a face has another level than the exact one only where the
 * exact brightness is this near to the boundary between two levels. */
#define FXL_LIGHT_ERROR_MAX 164

/* The light of a renderer, which the caller owns. Members are internal. */
typedef struct {
    fxl_shader shader;
    fxl_light_settings settings;
} fxl_light;

/* Attaches a light to a renderer, in any sequence with what else is attached, or, where settings is
 * null, detaches it. The settings are copied into *light, to which the renderer keeps a pointer,
 * and the pointer to the ramp; each renderer has a record of its own. A frame must begin anew, so
 * call it between frames for light that changes. Faces are lit after fxl_world_recolour and before
 * beams: a beam's lit colours are those of the colours that the ramp gives.
 * FXL_E_ARGUMENT: renderer is null; or light or ramp, if there are settings.
 * FXL_E_ORDER: the renderer was never initialised.
 * FXL_E_COUNT: point_count is above FXL_LIGHT_POINTS_MAX, or levels is outside
 * FXL_LIGHT_LEVELS_MIN..FXL_LIGHT_LEVELS_MAX: 2..64.
 * FXL_E_NORMAL: the direction is not of unit length.
 * FXL_E_RANGE: another number is out of the range of fxl_light_settings.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_attach_light(fxl_renderer *renderer, fxl_light *light,
                            const fxl_light_settings *settings);

/* Makes a ramp for a palette of 256 colours of three bytes, red, green, blue. Level l of colour c
 * is the entry of the palette that is nearest to dark + (c - dark) * l / (levels - 1), each of the
 * three rounded to nearest, halves upward; nearest by the sum of the squared differences, and of
 * those at the same distance the one of the lowest number. The top level of a colour is the colour
 * itself. dark is what black, or fog, is: three bytes. It looks at 65536 * (levels - 1) pairs of
 * colours; a program with little time computes the ramp on the host, and keeps it in flash.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_COUNT: levels is outside FXL_LIGHT_LEVELS_MIN..FXL_LIGHT_LEVELS_MAX: 2..64.
 * With each of these statuses: ramp untouched. */
fxl_status fxl_light_make_ramp(const uint8_t *palette, const uint8_t *dark, uint32_t levels,
                               uint8_t *ramp);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_light_reasons[];

#ifdef __cplusplus
}
#endif

#endif
