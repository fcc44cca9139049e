/* SPDX-License-Identifier: MIT */
#include "judge/light.h"

/* place pixel-format: which colours a pixel may have */
#include "reference/rgb565.h"

static double q16(int32_t value)
{
    return value / 65536.0;
}

static double q30(int32_t value)
{
    return value / 1073741824.0;
}

/* place light: a new setting: who judges by settings by name */
void judge_light(ref_scene_image *image, const named_light *named, ref_light *light)
{
    *light = (ref_light){
        .ambient = q30(named->ambient),
        .strength = q30(named->strength),
        .direction = {q30(named->direction[0]), q30(named->direction[1]), q30(named->direction[2])},
        .point_count = named->point_count,
        .fog_near = q16(named->fog_near),
        .fog_far = q16(named->fog_far),
        .levels = named->levels};
    for (int i = 0; i < named->point_count; i++) {
        const int32_t *at = named->points[i].position;
        light->points[i] = (ref_point_light){{q16(at[0]), q16(at[1]), q16(at[2])},
                                             q16(named->points[i].range),
                                             q30(named->points[i].strength)};
    }
    ref_light_make_ramp(light, image->palette, named->dark);
    const int dark[REF_CHANNELS] = {named->dark[0] / 8, named->dark[1] / 4, named->dark[2] / 8};
    image->dark = ref_colour_of(dark);
    image->scene.light = light;
}
