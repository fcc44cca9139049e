/* SPDX-License-Identifier: MIT */
/* Light by name, for the reference renderer. */
#ifndef JUDGE_LIGHT_H
#define JUDGE_LIGHT_H

#include "lights/named.h"
#include "reference/light.h"

/* Has the image's scene be lit; *light is where the light is kept. */
void judge_light(ref_scene_image *image, const named_light *named, ref_light *light);

#endif
