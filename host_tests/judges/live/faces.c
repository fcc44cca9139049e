/* SPDX-License-Identifier: MIT */
#include "live/faces.h"

#include <string.h>

#include "reference/billboard.h"

void put_u32(uint8_t *to, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        to[i] = (uint8_t)(value >> 8 * i);
    }
}

void put_u16(uint8_t *to, uint32_t value)
{
    to[0] = (uint8_t)value;
    to[1] = (uint8_t)(value >> 8);
}

void put_f32(uint8_t *to, double value)
{
    float narrow = (float)value;
    uint32_t bits;
    memcpy(&bits, &narrow, sizeof bits);
    put_u32(to, bits);
}

/* How far away a polygon is at a pixel. The renderer knows the planes if it draws by depth. */
static double distance_at(const ref_renderer *renderer, const ref_drawn *drawn, double x, double y)
{
    const ref_scene *scene = renderer->scene;
    const ref_instance *instance = &scene->instances[drawn->instance];
    ref_depth_plane plane = drawn->depth;
    if (renderer->depth_bits == 0 && !ref_billboard_of(scene, instance)) {
        const ref_face *faces = &scene->faces[scene->models[instance->model].first_face];
        ref_depth_plane_find(scene, &renderer->camera, instance, &faces[drawn->face], &plane);
    }
    return 1 / ref_nearness(&plane, &renderer->lens, x, y);
}

/* place sampling: the texel under the mouse */
static void put_face(const ref_renderer *renderer, const ref_drawn *drawn, double x, double y,
                     uint8_t *to)
{
    int texel[2];
    put_u16(to, drawn->instance);
    put_u16(to + 2, drawn->face);
    put_f32(to + 4, distance_at(renderer, drawn, x, y));
    if (ref_surface_texel_at(&drawn->look, &renderer->lens, x, y, texel)) {
        put_u16(to + 8, (uint32_t)texel[0]);
        put_u16(to + 10, (uint32_t)texel[1]);
        put_u16(to + 12, (uint32_t)drawn->look.level->width);
        put_u16(to + 14, (uint32_t)drawn->look.level->height);
    }
}

void collect_faces(const ref_renderer *renderer, uint8_t *to)
{
    const int width = renderer->lens.width, area = width * renderer->lens.height;
    for (int i = 0; i < area; i++, to += FACE_SIZE) {
        const uint32_t number = renderer->shown[i];
        memset(to, 0, FACE_SIZE);
        if (number == 0) {
            put_u32(to, UINT32_MAX);
        } else {
            put_face(renderer, &renderer->display_list.drawn[number - 1], i % width + 0.5,
                     i / width + 0.5, to);
        }
    }
}
