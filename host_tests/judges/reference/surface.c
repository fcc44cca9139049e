/* SPDX-License-Identifier: MIT */
#include "reference/surface.h"

#include <math.h>

#include "reference/light.h"
#include "reference/camera.h"
#include "reference/placement.h"

/* --- the corners of a face ---------------------------------------------------------------------
 */

static ref_view_point vertex_in_view(const ref_scene *scene, const ref_camera *camera,
                                     const ref_instance *instance, uint32_t number)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    const ref_lattice_point corner = ref_model_vertex(scene, instance, number);
    const ref_lattice_point vertex = ref_instance_vertex(scene, instance, number);
    const ref_point at = placement ? ref_placement_point(placement, &instance->centre, &corner)
                                   : ref_point_from_lattice(&vertex);
    return ref_transform_point(camera, &at);
}

/* The light at a corner, in levels of the ramp, so that the nearest is what is below. */
static double light_at(const ref_scene *scene, const ref_camera *camera,
                       const ref_instance *instance, uint32_t number, const int32_t normal[3])
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    const ref_lattice_point vertex = ref_instance_vertex(scene, instance, number);
    int32_t turned[3] = {normal[0], normal[1], normal[2]};
    if (placement) {
        ref_placement_normal(placement, normal, turned);
    }
    const ref_point way = {ldexp(turned[0], -30), ldexp(turned[1], -30), ldexp(turned[2], -30)};
    return ref_light_brightness(scene->light, camera, ref_point_from_lattice(&vertex), way) *
               (scene->light->levels - 1) +
           0.5;
}

static ref_view_point difference(const ref_view_point *a, const ref_view_point *b)
{
    return (ref_view_point){a->x - b->x, a->y - b->y, a->z - b->z};
}

static long double product(const ref_view_point *a, const ref_view_point *b)
{
    return a->x * b->x + a->y * b->y + a->z * b->z;
}

static ref_view_point cross(const ref_view_point *a, const ref_view_point *b)
{
    return (ref_view_point){a->y * b->z - a->z * b->y, a->z * b->x - a->x * b->z,
                            a->x * b->y - a->y * b->x};
}

/* --- the look of a face -------------------------------------------------------------------------
 */

static bool is_on_screen(const ref_lens *lens, const ref_view_point *corner,
                         ref_screen_point *point)
{
    if (!(corner->z > 0) && lens->scale == 0) {
        return false;
    }
    *point = ref_project_point(lens, corner);
    return point->x >= 0 && point->x <= lens->width && point->y >= 0 && point->y <= lens->height;
}

/* The area of a triangle of the screen, times two. */
static double area_of(const ref_screen_point points[3])
{
    return (points[1].x - points[0].x) * (points[2].y - points[0].y) -
           (points[2].x - points[0].x) * (points[1].y - points[0].y);
}

/* Texels a pixel, by area, at the face's least depth. With n, the cross
 * product of two sides: |n| units of area have so many texels, and one of them, seen at depth z
 * along a ray of the length r and of depth 1, is focal^2 (n . ray) / |n| / z^2 / 1 pixels. */
static double texels_a_pixel(const ref_surface_view *view, const ref_lens *lens,
                             const ref_view_point corners[3], double near)
{
    const double texels = fabs(view->steps[0][REF_U] * view->steps[1][REF_V] -
                               view->steps[1][REF_U] * view->steps[0][REF_V]);
    if (view->is_affine) {
        return texels / fabs(area_of(view->points));
    }
    const double focal = lens->scale != 0 ? lens->scale : lens->focal;
    const ref_view_point normal = cross(&view->sides[0], &view->sides[1]);
    const double volume = (double)fabsl(product(&normal, &corners[0]));
    return near > 0 && volume > 0
               ? texels * near * near * near / (focal * focal * volume)
               : 0;
}

/* What part of itself the library's texels a pixel may be off by: those of a face whose corners are
 * all in front of the eye may be found by its area on the screen, whose corners are off by up to
 * 0.55/65536 pixel along each axis. */
static double part_off(const ref_surface_view *view, const ref_view_point corners[3])
{
    const ref_screen_point *p = view->points;
    const double area = fabs(area_of(p));
    double sides = 0;
    for (int i = 0; i < 3; i++) {
        const ref_screen_point *next = &p[(i + 1) % 3];
        sides += fabs(next->x - p[i].x) + fabs(next->y - p[i].y);
        if (!(corners[i].z > 0)) {
            return 0x1p-26;
        }
    }
    return 0x1p-26 + (area > 0 ? fmin(0.55 / 65536 * sides / area, 1) : 0);
}

ref_surface_view ref_surface_with_level(const ref_surface_view *view,
                                        const ref_texture_level *level)
{
    ref_surface_view changed = *view;
    changed.level = level;
    changed.scales[0] = (double)level->width / view->texture->levels[0].width;
    changed.scales[1] = (double)level->height / view->texture->levels[0].height;
    return changed;
}

static int level_of(const ref_texture *texture, double twice)
{
    int level = 0;
    while (level + 1 < texture->level_count && ldexp(1, 2 * (level + 1)) <= twice) {
        level++;
    }
    return level;
}

/* The least depth of the corners and of the vertices of the whole face. */
static double least_depth(const ref_scene *scene, const ref_camera *camera,
                          const ref_instance *instance, const ref_face *face,
                          const ref_view_point corners[3])
{
    const bool is_part = face->whole_count != 0;
    const uint16_t *indices = scene->indices + face->first_index + (is_part ? face->count : 0);
    const uint32_t count = is_part ? face->whole_count : face->count;
    long double least = fminl(corners[0].z, fminl(corners[1].z, corners[2].z));
    for (uint32_t i = 0; i < count; i++) {
        least = fminl(least, vertex_in_view(scene, camera, instance, indices[i]).z);
    }
    return (double)least;
}

static void choose_level(ref_surface_view *view, const ref_lens *lens,
                         const ref_view_point corners[3], double near)
{
    const ref_texture *texture = view->texture;
    const double twice = 2 * texels_a_pixel(view, lens, corners, near);
    const double off = part_off(view, corners) * twice;
    const int level = level_of(texture, twice), least = level_of(texture, twice - off),
              most = level_of(texture, twice + off);
    *view = ref_surface_with_level(view, &texture->levels[level]);
    view->other = least != most ? &texture->levels[least < level ? least : most] : NULL;
}

static void spread_values(ref_surface_view *view, double at[3][REF_VALUES])
{
    for (int k = 0; k < REF_VALUES; k++) {
        view->values[k] = at[0][k];
        view->steps[0][k] = at[1][k] - at[0][k];
        view->steps[1][k] = at[2][k] - at[0][k];
    }
}

/* A channel of a corner's colour, of 8 bits and a half, of which light leaves a part; the rest is the
 * middle of what is dark. */
static void find_colours(const ref_surface_view *view, const ref_mapped_face *mapped, int corner,
                         double values[REF_VALUES])
{
    const double part = view->light ? ref_rgb565_part(view->light, values[REF_BRIGHTNESS]) : 1;
    for (int i = 0; i < REF_CHANNELS; i++) {
        const double full =
            (mapped->colours[corner][i] + 0.5) * (ref_channel_most(i) + 1) / 256;
        const double dark = view->rgb565 ? ref_channel(view->rgb565->dark, i) + 0.5 : 0;
        values[i] = dark + (full - dark) * part;
    }
}

void ref_surface_channels(const double values[REF_CHANNELS], int channels[REF_CHANNELS])
{
    for (int i = 0; i < REF_CHANNELS; i++) {
        channels[i] = (int)fmin(fmax(floor(values[i]), 0), ref_channel_most(i));
    }
}

static void find_values(const ref_scene *scene, const ref_camera *camera,
                        const ref_instance *instance, const ref_mapped_face *mapped,
                        ref_surface_view *view)
{
    double at[3][REF_VALUES] = {{0}};
    for (int i = 0; i < 3; i++) {
        at[i][REF_U] = mapped->texels[i][0];
        at[i][REF_V] = mapped->texels[i][1];
        if (view->light) {
            at[i][REF_BRIGHTNESS] = light_at(scene, camera, instance, (uint32_t)mapped->vertices[i],
                                             scene->surfaces->normals[mapped->normals[i]]);
        }
        if (view->surface->has_colours) {
            find_colours(view, mapped, i, at[i]);
        }
    }
    if (view->surface->has_colours) {
        view->light = NULL; /* it is in the colours */
    }
    spread_values(view, at);
}

void ref_surface_look(const ref_scene *scene, const ref_camera *camera, const ref_lens *lens,
                      const ref_rgb565 *rgb565, const ref_instance *instance, uint32_t number,
                      ref_surface_view *view)
{
    const ref_surfaces *surfaces = scene->surfaces;
    number += scene->models[instance->model].first_face;
    *view = (ref_surface_view){.surface = NULL, .rgb565 = rgb565};
    if (!surfaces || surfaces->face_map[number] == 0) {
        return;
    }
    const ref_mapped_face *mapped = &surfaces->faces[surfaces->face_map[number] - 1];
    ref_view_point corners[3];
    bool on_screen = true;
    view->is_in_front = true;
    view->surfaces = surfaces;
    view->surface = &surfaces->surfaces[mapped->surface];
    view->own = scene->faces[number].material;
    view->light = view->surface->is_lit ? scene->light : NULL;
    for (int i = 0; i < 3; i++) {
        corners[i] = vertex_in_view(scene, camera, instance, (uint32_t)mapped->vertices[i]);
        on_screen = is_on_screen(lens, &corners[i], &view->points[i]) && on_screen;
        view->is_in_front = view->is_in_front && (corners[i].z > 0 || lens->scale != 0);
    }
    for (int i = 0; i < 3 && lens->scale != 0; i++) {
        corners[i].z = 1;
    }
    view->corner = corners[0];
    view->sides[0] = difference(&corners[1], &corners[0]);
    view->sides[1] = difference(&corners[2], &corners[0]);
    view->is_affine =
        view->surface->division == REF_AFFINE && on_screen && area_of(view->points) != 0;
    find_values(scene, camera, instance, mapped, view);
    if (view->surface->texture) {
        view->texture = &surfaces->textures[view->surface->texture - 1];
        choose_level(view, lens, corners,
                     lens->scale != 0
                         ? 1
                         : least_depth(scene, camera, instance, &scene->faces[number], corners));
    }
}

/* --- values -------------------------------------------------------------------------------------
 */

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

/* The same on the screen, by areas. */
static void solve_affine(const ref_surface_view *view, double x, double y, long double times[2])
{
    const ref_screen_point at = {x, y};
    const ref_screen_point *points = view->points;
    const ref_screen_point to_second[3] = {points[0], at, points[2]};
    const ref_screen_point to_third[3] = {points[0], points[1], at};
    const long double whole = area_of(points);
    times[0] = area_of(to_second) / whole;
    times[1] = area_of(to_third) / whole;
}

/* Where the ray through a point of the screen meets the plane. */
static bool solve_ray(const ref_surface_view *view, const ref_lens *lens, double x, double y,
                      long double times[2])
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
    solve(view, &from_corner, times);
    return true;
}

bool ref_surface_place(const ref_surface_view *view, const ref_lens *lens, double x, double y,
                       ref_place *place)
{
    long double times[2];
    bool found = true;
    if (view->is_affine) {
        solve_affine(view, x, y, times);
    } else if (!solve_ray(view, lens, x, y, times)) {
        return false;
    }
    for (int k = 0; k < REF_VALUES; k++) {
        const double scale = view->texture && k < REF_BRIGHTNESS ? view->scales[k] : 1;
        place->values[k] = (double)(view->values[k] + times[0] * view->steps[0][k] +
                                    times[1] * view->steps[1][k]) *
                           scale;
        found = found && fabs(place->values[k]) < 0x1p40;
    }
    return found;
}

/* --- colours ------------------------------------------------------------------------------------
 */

static int64_t within(int64_t number, int64_t count, bool clamps)
{
    if (clamps) {
        return number < 0 ? 0 : number >= count ? count - 1 : number;
    }
    return (number % count + count) % count;
}

/* place sampling: the reference */
int ref_surface_texel(const ref_surface_view *view, int64_t column, int64_t row)
{
    const ref_texture *texture = view->texture;
    if (!texture) {
        return view->own;
    }
    const ref_texture_level *level = view->level;
    const int64_t x = within(column, level->width, texture->clamps);
    const int64_t y = within(row, level->height, texture->clamps);
    const uint16_t colour = level->colours[y * level->width + x];
    return texture->is_keyed && colour == texture->key ? REF_CLEAR : colour;
}

bool ref_surface_texel_at(const ref_surface_view *view, const ref_lens *lens, double x, double y,
                          int texel[2])
{
    ref_place place;
    if (!view->surface || !view->texture || !ref_surface_place(view, lens, x, y, &place)) {
        return false;
    }
    const bool clamps = view->texture->clamps;
    texel[0] = (int)within((int64_t)floor(place.values[REF_U]), view->level->width, clamps);
    texel[1] = (int)within((int64_t)floor(place.values[REF_V]), view->level->height, clamps);
    return true;
}

static uint8_t in_beam(const ref_surface_view *view, uint8_t colour)
{
    return view->in_beam ? view->in_beam[colour] : colour;
}

uint8_t ref_surface_lit(const ref_surface_view *view, int64_t level, uint8_t colour)
{
    return in_beam(view, view->light
                             ? view->light->ramp[within(level, view->light->levels, true)][colour]
                             : colour);
}

uint16_t ref_surface_full(const ref_surface_view *view, int texel)
{
    return view->texture && view->texture->is_565
               ? (uint16_t)texel
               : view->rgb565->palette[in_beam(view, (uint8_t)texel)];
}

/* place stipple: definition: the pattern, and what a blend shows */
bool ref_surface_mixes(const ref_surface *surface)
{
    return surface->blends || surface->adds;
}

uint8_t ref_surface_over(const ref_surface_view *view, uint8_t colour, uint8_t beneath)
{
    const ref_surfaces *surfaces = view->surfaces;
    const uint32_t first = surfaces->blend_first;
    if (!view->surface->blends || colour < first || colour >= first + surfaces->blend_count) {
        return colour;
    }
    return surfaces->blend[256 * (colour - first) + beneath];
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

/* The same in RGB565: docs/extras/rgb565.md, section 2. */
static uint16_t colour_565(const ref_surface_view *view, const ref_place *place, int texel,
                           uint16_t beneath)
{
    const double part =
        view->light ? ref_rgb565_part(view->light, place->values[REF_BRIGHTNESS]) : 1;
    uint16_t lit = ref_rgb565_shown(view->rgb565, ref_surface_full(view, texel), part);
    if (view->surface->has_colours) {
        int shown[REF_CHANNELS];
        ref_surface_channels(place->values, shown);
        lit = ref_colour_of(shown);
    }
    const int own = view->surface->blends ? view->surface->sixteenths : 16;
    int channels[REF_CHANNELS];
    for (int i = 0; i < REF_CHANNELS; i++) {
        const int mine = ref_channel(lit, i), other = ref_channel(beneath, i);
        channels[i] = view->surface->adds ? (int)fmin(mine + other, ref_channel_most(i))
                                          : (own * mine + (16 - own) * other) / 16;
    }
    return ref_colour_of(channels);
}

int ref_surface_colour(const ref_surface_view *view, const ref_lens *lens, int x, int y,
                       uint16_t beneath)
{
    ref_place place;
    if (!ref_stipple_draws(view->surface->opacity, x, y) ||
        !ref_surface_place(view, lens, x + 0.5, y + 0.5, &place)) {
        return REF_CLEAR;
    }
    const int texel = ref_surface_texel(view, (int64_t)floor(place.values[REF_U]),
                                        (int64_t)floor(place.values[REF_V]));
    if (texel == REF_CLEAR) {
        return REF_CLEAR;
    }
    if (view->rgb565) {
        return colour_565(view, &place, texel, beneath);
    }
    const uint8_t lit =
        ref_surface_lit(view, (int64_t)floor(place.values[REF_BRIGHTNESS]), (uint8_t)texel);
    return ref_surface_over(view, lit, (uint8_t)beneath);
}
