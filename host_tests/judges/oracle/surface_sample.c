/* SPDX-License-Identifier: MIT */
#include "oracle/surface_sample.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference/light.h"
#include "stages/bridge.h"

/* --- random samples ------------------------------------------------------------------------- */

/* Appends a corner with its attributes. Returns whether it is in range. */
static int put_corner(oracle_random *random, oracle_input *input, const double view[3], double size,
                      const int64_t middle[2])
{
    const int inside = oracle_put_point(input, view);
    for (int k = 0; k < 2; k++) {
        oracle_put(input, middle[k] + (int64_t)oracle_uniform(random, -size, size));
    }
    oracle_put(input, oracle_between(random, 0, 63 << 16));
    return inside;
}

void surface_sample_generate(oracle_random *random, oracle_input *input)
{
    oracle_setup_generate(random, FXL_SCREEN_MAX, input);
    const int64_t *n = input->numbers;
    const double near = (double)(n[3] + 2 * n[5] + 2) / 65536;
    const double far = fmin((double)(n[4] - n[5]) / 65536, 8000);
    for (int tries = 0; tries < 64; tries++) {
        const double size = oracle_spread(random, 65536, 8000 * 65536.0);
        const double z = far > near ? oracle_spread(random, near, fmin(far, near * 4096)) : near;
        const int64_t middle[2] = {
            oracle_between(random, -8000 * 65536, 8000 * 65536) >> oracle_below(random, 12),
            oracle_between(random, -8000 * 65536, 8000 * 65536) >> oracle_below(random, 12)};
        double point[3], view[3][3];
        int inside = 1;
        input->count = ORACLE_SETUP_NUMBERS;
        oracle_put(input, oracle_between(random, 0, n[0] - 1));
        oracle_put(input, oracle_between(random, 0, n[1] - 1));
        oracle_triangle_point(input, &n[ORACLE_SETUP_NUMBERS], z, point);
        oracle_triangle_about(random, point, 20, view);
        for (int i = 0; i < 3; i++) {
            inside &= put_corner(random, input, view[i], size, middle);
        }
        if (inside) {
            return;
        }
    }
}

/* --- as a scene ------------------------------------------------------------------------------- */

int surface_sample_read(const oracle_input *input, surface_sample *sample)
{
    if (input->count < SURFACE_NUMBERS || !oracle_setup_read(input, &sample->setup)) {
        return 0;
    }
    const int64_t *n = &input->numbers[ORACLE_SETUP_NUMBERS];
    const fxl_lens *lens = &sample->lens;
    if (!oracle_setup_lens(input, &sample->lens)) {
        return 0;
    }
    sample->is_affine = 0;
    sample->x = n[0];
    sample->y = n[1];
    for (int i = 0; i < 3; i++) {
        const int64_t *at = &n[2 + (3 + SURFACE_ATTRIBUTES) * i];
        for (int k = 0; k < 3 + SURFACE_ATTRIBUTES; k++) {
            if (llabs(at[k]) > FXL_COORDINATE_MAX * (k < 3 ? 1 : 2)) {
                return 0;
            }
        }
        sample->corners[i] = (fxl_point){(int32_t)at[0], (int32_t)at[1], (int32_t)at[2]};
        for (int k = 0; k < SURFACE_ATTRIBUTES; k++) {
            sample->values[i][k] = at[3 + k];
        }
        sample->indices[i] = (uint16_t)i;
    }
    sample->face = (fxl_face){oracle_triangle_normal(sample->corners), 3, 7, {0, 1, 2}};
    sample->model = (fxl_model){
        .vertex_count = 3, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = FXL_RADIUS_MAX};
    sample->instance = (fxl_instance){{0, 0, 0}, 0, 0, 0};
    sample->scene = (fxl_scene){.vertices = sample->corners,
                                .indices = sample->indices,
                                .faces = &sample->face,
                                .models = &sample->model,
                                .instances = &sample->instance,
                                .vertex_count = 3,
                                .index_count = 3,
                                .face_count = 1,
                                .model_count = 1,
                                .instance_count = 1};
    return sample->x >= 0 && sample->x < lens->width && sample->y >= 0 &&
           sample->y < lens->height && fxl_scene_check(&sample->scene, NULL) == FXL_OK;
}

int surface_sample_make_affine(surface_sample *sample)
{
    const fxl_view *view = &sample->setup.view;
    const fxl_projection *projection = &view->projection;
    for (int i = 0; i < 3; i++) {
        fxl_view_point at;
        fxl_screen_point point;
        fxl_transform_point(&view->camera, &sample->corners[i], &at);
        if (fxl_project_visible(projection, &at, &point) != FXL_OK || point.x < 0 || point.y < 0 ||
            point.x > view->lens.width * 65536 || point.y > view->lens.height * 65536) {
            return 0;
        }
        sample->on_screen[i] = (oracle_view_point){(int64_t)point.x - projection->centre_x,
                                                   (int64_t)projection->centre_y - point.y,
                                                   fxl_view_drawn_focal(view)};
    }
    const oracle_view_point *p = sample->on_screen;
    sample->is_affine =
        (p[1].x - p[0].x) * (p[2].y - p[0].y) != (p[2].x - p[0].x) * (p[1].y - p[0].y);
    return sample->is_affine;
}

/* Of RGB565. The colour of the sample's face is that of the background, so a face that is drawn
 * without its surface counts as one that is not drawn. */
static uint16_t palette[256] = {[255] = 0xFFFF};

/* The pixel over a background of 0 or 255 in each byte; or that background where the library refuses to draw. */
static int draw_over(fxl_renderer *renderer, const surface_sample *sample, uint8_t background)
{
    static uint16_t pixels[FXL_SCREEN_MAX];
    const uint16_t width = renderer->frame.view.lens.width;
    const int is_wide = renderer->target->pixel_bits == 16;
    const fxl_band band = {.pixels = (uint8_t *)pixels,
                           .width = width,
                           .stride = width,
                           .first_row = (uint16_t)sample->y,
                           .rows = 1,
                           .palette = is_wide ? palette : NULL};
    palette[sample->face.material] = palette[background];
    memset(pixels, background, sizeof pixels);
    if (fxl_frame_begin(renderer, &sample->setup.pose) != FXL_OK ||
        fxl_frame_draw(renderer, &band) != FXL_OK) {
        return background != 0 && is_wide ? 0xFFFF : background;
    }
    return is_wide ? pixels[sample->x] : band.pixels[sample->x];
}

/* The set's faces: that of the sample. */
static int draw(surface_sample *sample, fxl_surface_set *set, const fxl_light_settings *light,
                const fxl_config *config, const fxl_painter *painter)
{
    static fxl_renderer renderer;
    static fxl_surfaces surfaces;
    static fxl_light lamp;
    static fxl_lit_surfaces lit;
    static const uint16_t face_map[1] = {1};
    static const fxl_mapped_face mapped = {.corners = {0, 1, 2}};
    fxl_draw_entry order[2];
    const fxl_memory memory = {order, 2, NULL, 0, NULL, 0};
    set->face_map = face_map;
    set->faces = &mapped;
    set->surface_count = set->face_count = 1;
    set->corner_count = 3;
    if (fxl_renderer_init_with(&renderer, &sample->scene, &sample->lens, &memory) != FXL_OK ||
        fxl_renderer_choose(&renderer, config) != FXL_OK ||
        fxl_attach_surfaces(&renderer, &surfaces, set, painter) != FXL_OK ||
        (light && (fxl_attach_light(&renderer, &lamp, light) != FXL_OK ||
                   fxl_attach_lit(&renderer, &lit) != FXL_OK))) {
        return -1;
    }
    const int shown = draw_over(&renderer, sample, 0);
    return shown == draw_over(&renderer, sample, 255) ? shown : -1;
}

/* Draws the pixel by a surface. Returns -1 if the face does not cover it. light may be null. */
static int draw_by_surface(surface_sample *sample, const fxl_texture *texture,
                           const fxl_surface *surface, const fxl_direction normals[3],
                           const fxl_light_settings *light)
{
    const fxl_config config = fxl_config_default(1, 1); /* its target and its order alone */
    fxl_corner corners[3];
    for (uint16_t i = 0; i < 3; i++) {
        corners[i] =
            (fxl_corner){{(int32_t)sample->values[i][0], (int32_t)sample->values[i][1]}, i, i};
    }
    fxl_surface_set set = {.textures = texture,
                           .surfaces = surface,
                           .corners = corners,
                           .normals = normals,
                           .texture_count = texture ? 1 : 0,
                           .normal_count = normals ? 3 : 0};
    return draw(sample, &set, light, &config, FXL_SURFACES_OF(fxl_palette));
}

int surface_sample_draw_colours(surface_sample *sample, const uint32_t colours[3])
{
    const fxl_surface surface = {.flags = FXL_SURFACE_COLOURS, .opacity = 16};
    fxl_config config = fxl_config_for(1, 1, &fxl_rgb565);
    fxl_corner corners[3];
    config.palette = palette;
    for (uint16_t i = 0; i < 3; i++) {
        corners[i] = (fxl_corner){{(int32_t)colours[i], 0}, i, 0};
    }
    fxl_surface_set set = {.surfaces = &surface, .corners = corners};
    return draw(sample, &set, NULL, &config, FXL_SURFACES_OF(fxl_rgb565));
}

/* --- exact arithmetic ------------------------------------------------------------------------- */

/* The largest |v . D| at the four corners of the screen, whose width is rounded up. */
static double largest_on_screen(const surface_sample *sample, const oracle_vector *v)
{
    const fxl_lens *lens = &sample->setup.view.lens;
    double largest = 0;
    mpz_t value;
    mpz_init(value);
    for (int i = 0; i < 4; i++) {
        int64_t way[3];
        oracle_pixel_way(&sample->setup.view, i & 1 ? (lens->width + 15) & ~15 : 0,
                         i & 2 ? lens->height : 0, way);
        oracle_vector_dot(value, v, way);
        largest = fmax(largest, fabs(mpz_get_d(value)));
    }
    mpz_clear(value);
    return largest;
}

/* n, E2 x P0, P0 x E1, and with the attribute A. */
static void find_planes(const surface_sample *sample, int attribute, oracle_vector planes[4])
{
    oracle_view_point corners[3];
    for (int i = 0; i < 3; i++) {
        const int64_t point[3] = {sample->corners[i].x, sample->corners[i].y, sample->corners[i].z};
        corners[i] = oracle_transform(&sample->setup.view.camera, point);
    }
    oracle_triangle_planes(sample->is_affine ? sample->on_screen : corners, planes);
    const int64_t first = sample->values[0][attribute];
    mpz_t change;
    mpz_init(change);
    for (int k = 0; k < 3; k++) {
        mpz_mul_si(planes[3].c[k], planes[0].c[k], first);
        for (int i = 1; i < 3; i++) {
            mpz_set_si(change, sample->values[i][attribute] - first);
            mpz_addmul(planes[3].c[k], planes[i].c[k], change);
        }
    }
    mpz_clear(change);
}

/* accuracy 5.3 */
static double bound_of(const surface_sample *sample, int attribute, const oracle_vector planes[4],
                       double weight, double value)
{
    const double first = (double)sample->values[0][attribute] / 65536;
    int64_t way[3];
    oracle_pixel_way(&sample->setup.view, sample->x, sample->y, way);
    const double length = (double)(llabs(way[0]) + llabs(way[1]) + llabs(way[2]));
    double k = (fabs(first) + fabs(value)) * oracle_vector_size(&planes[0]);
    for (int i = 1; i < 3; i++) {
        k += fabs((double)sample->values[i][attribute] / 65536 - first) *
             oracle_vector_size(&planes[i]);
    }
    const double largest = largest_on_screen(sample, &planes[3]) / 65536 +
                           fabs(value) * largest_on_screen(sample, &planes[0]);
    return 0x1p-28 * k * length / weight + 0x1p-29 * largest / weight + 0x1p-28 * fabs(value) +
           0x1p-16;
}

int64_t surface_sample_exact(const surface_sample *sample, int attribute, double *bound)
{
    oracle_vector planes[4];
    int64_t way[3];
    mpz_t value, weight;
    mpz_init(value);
    mpz_init(weight);
    oracle_vectors_init(planes, 4);
    find_planes(sample, attribute, planes);
    oracle_pixel_way(&sample->setup.view, sample->x, sample->y, way);
    oracle_vector_dot(weight, &planes[0], way);
    oracle_vector_dot(value, &planes[3], way);
    *bound = INFINITY;
    int64_t exact = 0;
    if (mpz_sgn(weight) != 0) {
        const double w = fabs(mpz_get_d(weight));
        mpz_mul_2exp(value, value, 16);
        mpz_fdiv_q(value, value, weight);
        if (mpz_fits_slong_p(value)) {
            exact = mpz_get_si(value);
            *bound = bound_of(sample, attribute, planes, w, ldexp((double)exact, -32));
        }
    }
    oracle_vectors_clear(planes, 4);
    mpz_clear(value);
    mpz_clear(weight);
    return exact;
}

/* --- what a pixel shows --------------------------------------------------------------------- */

/* u on a texture whose columns differ, v on one whose rows differ, of 1 to 128 of them. */
static uint8_t texels[2][128 * 128];

/* place sampling: the claims of texels */
int surface_sample_texel(surface_sample *sample, int attribute, int log, uint8_t division)
{
    const int other = log < 4 ? 0 : 4; /* as the kernel for most textures takes them */
    const int columns = attribute == 0 ? log : other, rows = attribute == 0 ? other : log;
    const fxl_texture texture = {.texels = texels[attribute],
                                 .log_width = (uint8_t)columns,
                                 .log_height = (uint8_t)rows,
                                 .levels = 1};
    const fxl_surface surface = {.texture = 1, .division = division, .opacity = 16};
    for (int i = 0; i < 1 << (columns + rows); i++) {
        texels[attribute][i] =
            (uint8_t)(100 + (attribute == 0 ? i & ((1 << columns) - 1) : i >> columns));
    }
    const int shown = draw_by_surface(sample, &texture, &surface, NULL, NULL);
    return shown < 0 ? shown : shown - 100;
}

double surface_texel_distance(int64_t exact, int texel, int log)
{
    const double size = ldexp(1, log);
    double at = fmod(ldexp((double)exact, -32) - texel, size);
    at = at < 0 ? at + size : at;
    return at <= 1 ? 0 : fmin(at - 1, size - at);
}

int surface_sample_level(surface_sample *sample, const fxl_direction normals[3],
                         const fxl_light_settings *settings)
{
    const fxl_surface surface = {.division = FXL_DIVIDE_1, .flags = FXL_SURFACE_LIT, .opacity = 16};
    const int shown = draw_by_surface(sample, NULL, &surface, normals, settings);
    return shown < 0 ? shown : shown - 100;
}

double surface_level_distance(double exact, int level)
{
    const double held = fmax(0.5, fmin(exact, SURFACE_LEVELS - 0.5));
    return fmax(0, fmax(level - held, held - level - 1));
}

/* --- light ---------------------------------------------------------------------------------- */

static void put_direction(oracle_random *random, oracle_input *input)
{
    const double turn = oracle_uniform(random, 0, 6.283185307179586);
    const double up = oracle_uniform(random, -1, 1), level = sqrt(1 - up * up);
    oracle_put(input, (int64_t)floor(level * cos(turn) * FXL_Q2_30_ONE + 0.5));
    oracle_put(input, (int64_t)floor(up * FXL_Q2_30_ONE + 0.5));
    oracle_put(input, (int64_t)floor(level * sin(turn) * FXL_Q2_30_ONE + 0.5));
}

void surface_sample_put_light(oracle_random *random, oracle_input *input)
{
    const int64_t *corner = &input->numbers[ORACLE_SETUP_NUMBERS + 2];
    const double depth = oracle_spread(random, 65536, 1000 * 65536);
    for (int i = 0; i < 4; i++) { /* the normals, and the way of the directional light */
        put_direction(random, input);
    }
    oracle_put(input, oracle_between(random, 0, FXL_Q2_30_ONE / 4)); /* ambient */
    oracle_put(input, oracle_between(random, 0, FXL_Q2_30_ONE));     /* strength */
    for (int k = 0; k < 3; k++) {
        const double at = (double)corner[k] + oracle_signed_spread(random, 1, depth);
        oracle_put(input, (int64_t)fmax(fmin(at, FXL_COORDINATE_MAX), -FXL_COORDINATE_MAX));
    }
    oracle_put(input, (int64_t)fmin(2 * depth, FXL_COORDINATE_MAX)); /* range */
    oracle_put(input, oracle_below(random, 2)
                          ? 0
                          : (int64_t)oracle_spread(random, 65536, depth * 4 + 65537));
}

/* place light: the claim light_level: pixels of lit surfaces */
/* place light: a new setting: the settings of the claim */
/* The settings of the library and of the reference: from 10 numbers, a direction first. */
static void read_light(const int64_t *n, fxl_light_settings *settings, ref_light *light)
{
    static uint8_t ramp[256 * SURFACE_LEVELS];
    *settings = (fxl_light_settings){.ramp = ramp, .levels = SURFACE_LEVELS, .point_count = 1};
    for (int i = 0; i < 256 * SURFACE_LEVELS; i++) {
        ramp[i] = (uint8_t)(100 + i / 256);
    }
    settings->direction = (fxl_direction){(int32_t)n[0], (int32_t)n[1], (int32_t)n[2]};
    settings->ambient = (int32_t)n[3];
    settings->strength = (int32_t)n[4];
    settings->points[0].position = (fxl_point){(int32_t)n[5], (int32_t)n[6], (int32_t)n[7]};
    settings->points[0].range = (int32_t)n[8];
    settings->points[0].strength = FXL_Q2_30_ONE;
    settings->fog_far = (int32_t)n[9];
    light->ambient = ldexp((double)n[3], -30);
    light->strength = ldexp((double)n[4], -30);
    light->direction =
        (ref_point){ldexp((double)n[0], -30), ldexp((double)n[1], -30), ldexp((double)n[2], -30)};
    light->point_count = 1;
    light->points[0].position = bridge_point(&settings->points[0].position);
    light->points[0].range = ldexp((double)n[8], -16);
    light->points[0].strength = 1;
    light->fog_near = 0;
    light->fog_far = ldexp((double)n[9], -16);
    light->levels = SURFACE_LEVELS;
}

void surface_sample_light(const oracle_input *input, surface_sample *sample,
                          fxl_direction normals[3], fxl_light_settings *settings)
{
    static ref_light light;
    read_light(&input->numbers[SURFACE_NUMBERS + 9], settings, &light);
    const ref_camera camera = bridge_camera(&sample->setup.view.camera);
    for (int i = 0; i < 3; i++) {
        const int64_t *n = &input->numbers[SURFACE_NUMBERS + 3 * i];
        const ref_point normal = {ldexp((double)n[0], -30), ldexp((double)n[1], -30),
                                  ldexp((double)n[2], -30)};
        normals[i] = (fxl_direction){(int32_t)n[0], (int32_t)n[1], (int32_t)n[2]};
        const double level =
            ref_light_brightness(&light, &camera, bridge_point(&sample->corners[i]), normal) *
                (SURFACE_LEVELS - 1) +
            0.5;
        sample->values[i][2] = (int64_t)floor(ldexp(level, 32) + 0.5);
    }
}

double surface_sample_exact_level(const surface_sample *sample, double *bound)
{
    /* Values in 2^-32: so is the result in 2^-48, and the bound in 2^-16. */
    const double exact = ldexp((double)(surface_sample_exact(sample, 2, bound) >> 16), -32);
    *bound *= 0x1p-16;
    return exact;
}
