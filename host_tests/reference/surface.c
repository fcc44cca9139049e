/* SPDX-License-Identifier: MIT */
#include "reference/surface.h"

#include <math.h>
#include <stdlib.h>

#include "reference/project.h"
#include "reference/transform.h"
#include "reference/turn.h"

/* --- the view of a face ----------------------------------------------------------------------- */

static ref_view_point corner_of(const ref_scene *scene, const ref_camera *camera,
                                const ref_instance *instance, const ref_face *face, int number)
{
    const ref_turn *turn = ref_turn_of(scene, instance);
    const ref_lattice_point corner = ref_face_corner(scene, instance, face, number);
    if (turn) {
        const ref_point at = ref_turn_point(turn, &instance->centre, &corner);
        return ref_transform_point(camera, &at);
    }
    const ref_lattice_point vertex = ref_face_vertex(scene, instance, face, number);
    const ref_point at = ref_point_from_lattice(&vertex);
    return ref_transform_point(camera, &at);
}

static ref_view_point difference(const ref_view_point *a, const ref_view_point *b)
{
    return (ref_view_point){a->x - b->x, a->y - b->y, a->z - b->z};
}

void ref_surface_look(const ref_scene *scene, const ref_camera *camera,
                      const ref_instance *instance, uint32_t face, ref_surface_view *view)
{
    const ref_surfaces *surfaces = scene->surfaces;
    const uint32_t number = scene->models[instance->model].first_face + face;
    *view = (ref_surface_view){.surface = NULL};
    if (!surfaces || surfaces->face_map[number] == 0) {
        return;
    }
    const ref_mapped_face *mapped = &surfaces->faces[surfaces->face_map[number] - 1];
    ref_view_point corners[3];
    for (int i = 0; i < 3; i++) {
        corners[i] = corner_of(scene, camera, instance, &scene->faces[number], mapped->corners[i]);
    }
    view->surface = &surfaces->surfaces[mapped->surface];
    view->texture = view->surface->texture ? &surfaces->textures[view->surface->texture - 1] : NULL;
    view->corner = corners[0];
    for (int i = 0; i < 2; i++) {
        view->sides[i] = difference(&corners[i + 1], &corners[0]);
        view->texel[i] = mapped->texels[0][i];
        for (int k = 0; k < 2; k++) {
            view->steps[i][k] = mapped->texels[i + 1][k] - mapped->texels[0][k];
        }
    }
}

/* --- texture coordinates ------------------------------------------------------------------------
 */

static long double product(const ref_view_point *a, const ref_view_point *b)
{
    return a->x * b->x + a->y * b->y + a->z * b->z;
}

static ref_view_point cross(const ref_view_point *a, const ref_view_point *b)
{
    return (ref_view_point){a->y * b->z - a->z * b->y, a->z * b->x - a->x * b->z,
                            a->x * b->y - a->y * b->x};
}

/* How many times each side leads from the corner to a point of the plane: the two equations that
 * the products with the sides give. */
static void solve(const ref_surface_view *view, const ref_view_point *from_corner,
                  long double times[2])
{
    const ref_view_point *a = &view->sides[0], *b = &view->sides[1];
    const long double aa = product(a, a), ab = product(a, b), bb = product(b, b);
    const long double pa = product(from_corner, a), pb = product(from_corner, b);
    const long double whole = aa * bb - ab * ab;
    times[0] = (pa * bb - pb * ab) / whole;
    times[1] = (pb * aa - pa * ab) / whole;
}

bool ref_surface_place(const ref_surface_view *view, const ref_lens *lens, double x, double y,
                       ref_place *place)
{
    const ref_screen_point at = {x, y};
    const ref_view_point ray = ref_ray_through(lens, &at);
    const ref_view_point normal = cross(&view->sides[0], &view->sides[1]);
    const long double height = product(&normal, &view->corner), slope = product(&normal, &ray);
    if (!(height * slope > 0)) {
        return false;
    }
    const long double reach = height / slope;
    const ref_view_point hit = {ray.x * reach, ray.y * reach, ray.z * reach};
    const ref_view_point from_corner = difference(&hit, &view->corner);
    long double times[2];
    solve(view, &from_corner, times);
    place->u =
        (double)(view->texel[0] + times[0] * view->steps[0][0] + times[1] * view->steps[1][0]);
    place->v =
        (double)(view->texel[1] + times[0] * view->steps[0][1] + times[1] * view->steps[1][1]);
    place->slack = view->surface->division == REF_DIVIDE_1 ? 1.0 / 256 : 0.5 + 1.0 / 256;
    return fabs(place->u) < 0x1p40 && fabs(place->v) < 0x1p40;
}

/* --- colours ------------------------------------------------------------------------------------
 */

static int64_t within(int64_t number, int count, bool clamps)
{
    if (clamps) {
        return number < 0 ? 0 : number >= count ? count - 1 : number;
    }
    return (number % count + count) % count;
}

int ref_texture_colour(const ref_texture *texture, int64_t column, int64_t row)
{
    const int64_t x = within(column, texture->width, texture->clamps);
    const int64_t y = within(row, texture->height, texture->clamps);
    const uint8_t colour = texture->colours[y * texture->width + x];
    return texture->is_keyed && colour == texture->key ? REF_CLEAR : colour;
}

/* The ordered dither matrix of 4 x 4, as docs/formats.md, section 4, defines that of 8 x 8. */
bool ref_stipple_draws(int opacity, int x, int y)
{
    int number = 0;
    for (int k = 0; k < 2; k++) {
        const int in_x = x >> k & 1, in_y = y >> k & 1;
        number += (2 * (in_x ^ in_y) + in_y) << 2 * (1 - k);
    }
    return number < opacity;
}

int ref_surface_colour(const ref_surface_view *view, const ref_lens *lens, int x, int y,
                       uint8_t own)
{
    ref_place place;
    if (!ref_stipple_draws(view->surface->opacity, x, y)) {
        return REF_CLEAR;
    }
    if (!view->texture) {
        return own;
    }
    return ref_surface_place(view, lens, x + 0.5, y + 0.5, &place)
               ? ref_texture_colour(view->texture, (int64_t)floor(place.u), (int64_t)floor(place.v))
               : REF_CLEAR;
}

/* --- reading an image
 * ----------------------------------------------------------------------------- */

enum {
    TEXTURES_AT = 232, /* in the header */
    TEXELS_AT = 240,
    SURFACES_AT = 248,
    MAPPED_AT = 256,
    MAP_AT = 264
};

static bool read_texture(const uint8_t *p, const uint8_t *texels, uint32_t bytes,
                         ref_texture *texture)
{
    const uint32_t at = ref_u32(p), colours = ref_u32(p + 4);
    const bool is_4 = p[10] == 1;
    if (p[8] > 8 || p[9] > 8 || p[10] > 1 || (is_4 && p[8] == 0)) {
        return false;
    }
    *texture = (ref_texture){.width = 1 << p[8],
                             .height = 1 << p[9],
                             .clamps = p[11] & 1,
                             .is_keyed = p[11] >> 1 & 1,
                             .key = p[12]};
    const uint32_t count = (uint32_t)texture->width * (uint32_t)texture->height;
    if ((uint64_t)at + (is_4 ? count / 2 : count) > bytes || (is_4 && colours + 16ull > bytes)) {
        return false;
    }
    texture->colours = malloc(count);
    for (uint32_t i = 0; texture->colours && i < count; i++) {
        texture->colours[i] =
            is_4 ? texels[colours + (texels[at + i / 2] >> 4 * (i % 2) & 15)] : texels[at + i];
    }
    return texture->colours != NULL;
}

static bool read_textures(const uint8_t *bytes, size_t size, ref_surfaces *surfaces)
{
    uint32_t texel_bytes;
    const uint8_t *textures =
        ref_image_table(bytes, size, TEXTURES_AT, 16, 65535, &surfaces->texture_count);
    const uint8_t *texels = ref_image_table(bytes, size, TEXELS_AT, 1, 16u << 20, &texel_bytes);
    surfaces->textures = calloc(surfaces->texture_count + 1u, sizeof *surfaces->textures);
    if (!surfaces->textures || (textures && !texels)) {
        return false;
    }
    for (uint32_t i = 0; textures && i < surfaces->texture_count; i++) {
        if (!read_texture(textures + 16 * (size_t)i, texels, texel_bytes, &surfaces->textures[i])) {
            return false;
        }
    }
    return true;
}

static bool read_surfaces(const uint8_t *bytes, size_t size, ref_surfaces *surfaces)
{
    const uint8_t *p =
        ref_image_table(bytes, size, SURFACES_AT, 8, 65535, &surfaces->surface_count);
    surfaces->surfaces = calloc(surfaces->surface_count + 1u, sizeof *surfaces->surfaces);
    if (!p || !surfaces->surfaces) {
        return false;
    }
    for (uint32_t i = 0; i < surfaces->surface_count; i++, p += 8) {
        surfaces->surfaces[i] = (ref_surface){ref_u16(p), p[2], p[4]};
        if (ref_u16(p) > surfaces->texture_count || p[4] < 1 || p[4] > REF_OPAQUE) {
            return false;
        }
    }
    return true;
}

static bool read_faces(const uint8_t *bytes, size_t size, ref_surfaces *surfaces)
{
    const uint8_t *p = ref_image_table(bytes, size, MAPPED_AT, 36, 65535, &surfaces->face_count);
    surfaces->faces = calloc(surfaces->face_count + 1u, sizeof *surfaces->faces);
    if (!p || !surfaces->faces) {
        return false;
    }
    for (uint32_t i = 0; i < surfaces->face_count; i++, p += 36) {
        ref_mapped_face *face = &surfaces->faces[i];
        face->surface = ref_u16(p);
        for (int k = 0; k < 3; k++) {
            face->corners[k] = p[8 + k];
            face->texels[k][0] = ref_i32(p + 12 + 8 * k) / REF_ONE;
            face->texels[k][1] = ref_i32(p + 16 + 8 * k) / REF_ONE;
        }
        if ((uint32_t)face->surface >= surfaces->surface_count) {
            return false;
        }
    }
    return true;
}

static bool read_map(const uint8_t *bytes, size_t size, const ref_scene *scene,
                     ref_surfaces *surfaces)
{
    uint32_t count;
    const uint8_t *p = ref_image_table(bytes, size, MAP_AT, 2, 1000000, &count);
    surfaces->face_map = calloc(scene->face_count, sizeof *surfaces->face_map);
    if (!p || count != scene->face_count || !surfaces->face_map) {
        return false;
    }
    for (uint32_t i = 0; i < count; i++) {
        const uint16_t number = ref_u16(p + 2 * (size_t)i);
        if (number > surfaces->face_count) {
            return false;
        }
        for (int k = 0; number && k < 3; k++) {
            if (surfaces->faces[number - 1].corners[k] >= scene->faces[i].count) {
                return false;
            }
        }
        surfaces->face_map[i] = number;
    }
    return true;
}

bool ref_surfaces_read(const uint8_t *bytes, size_t size, ref_scene *scene)
{
    if (ref_u16(bytes + 6) <= MAP_AT) {
        return true;
    }
    ref_surfaces *surfaces = calloc(1, sizeof *surfaces);
    scene->surfaces = surfaces;
    return surfaces && read_textures(bytes, size, surfaces) &&
           read_surfaces(bytes, size, surfaces) && read_faces(bytes, size, surfaces) &&
           read_map(bytes, size, scene, surfaces);
}

void ref_surfaces_close(ref_surfaces *surfaces)
{
    for (uint32_t i = 0; surfaces && surfaces->textures && i < surfaces->texture_count; i++) {
        free(surfaces->textures[i].colours);
    }
    if (surfaces) {
        free(surfaces->textures);
        free(surfaces->surfaces);
        free(surfaces->faces);
        free(surfaces->face_map);
    }
    free(surfaces);
}
