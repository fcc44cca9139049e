/* SPDX-License-Identifier: MIT */
#include "oracle/surface_sample.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>

/* --- random samples ------------------------------------------------------------------------- */

static void direction(oracle_random *random, double way[3])
{
    double length;
    do {
        length = 0;
        for (int i = 0; i < 3; i++) {
            way[i] = oracle_uniform(random, -1, 1);
            length += way[i] * way[i];
        }
    } while (length < 0.01 || length > 1);
    for (int i = 0; i < 3; i++) {
        way[i] /= sqrt(length);
    }
}

/* Three corners in the view about the pixel's point at a depth. */
static void corners_about(oracle_random *random, const double point[3], double view[3][3])
{
    double edges[2][3], part[2];
    for (int i = 0; i < 2; i++) {
        const double length = point[2] * oracle_spread(random, 0.02, 20);
        direction(random, edges[i]);
        part[i] = oracle_uniform(random, 0.05, 0.45);
        for (int k = 0; k < 3; k++) {
            edges[i][k] *= length;
        }
    }
    for (int k = 0; k < 3; k++) {
        view[0][k] = point[k] - part[0] * edges[0][k] - part[1] * edges[1][k];
        view[1][k] = view[0][k] + edges[0][k];
        view[2][k] = view[0][k] + edges[1][k];
    }
}

/* Whether the corners are clockwise as the eye sees them. */
static int is_clockwise(double view[3][3])
{
    const double *p = view[0];
    double a[3], b[3];
    for (int k = 0; k < 3; k++) {
        a[k] = view[1][k] - p[k];
        b[k] = view[2][k] - p[k];
    }
    return (a[1] * b[2] - a[2] * b[1]) * p[0] + (a[2] * b[0] - a[0] * b[2]) * p[1] +
               (a[0] * b[1] - a[1] * b[0]) * p[2] <
           0;
}

/* Appends a corner. Returns whether it is in range. */
static int put_corner(oracle_random *random, oracle_input *input, const double view[3], double size,
                      const int64_t middle[2])
{
    double world[3];
    int inside = 1;
    oracle_to_world(input, view, world);
    for (int k = 0; k < 3; k++) {
        const int64_t coordinate = input->numbers[6 + k] + (int64_t)floor(world[k] * 65536 + 0.5);
        inside = inside && llabs(coordinate) <= FXL_COORDINATE_MAX;
        oracle_put(input, coordinate);
    }
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
    const double focal = (double)n[0] / 2 / tan(ldexp((double)n[2], -32) * 3.141592653589793);
    const double near = (double)(n[3] + 2 * n[5] + 2) / 65536;
    const double far = fmin((double)(n[4] - n[5]) / 65536, 8000);
    for (int tries = 0; tries < 64; tries++) {
        const double size = oracle_spread(random, 65536, 8000 * 65536.0);
        const double z = far > near ? oracle_spread(random, near, fmin(far, near * 4096)) : near;
        const int64_t middle[2] = {
            oracle_between(random, -8000 * 65536, 8000 * 65536) >> oracle_below(random, 12),
            oracle_between(random, -8000 * 65536, 8000 * 65536) >> oracle_below(random, 12)};
        double view[3][3];
        int inside = 1;
        input->count = ORACLE_SETUP_NUMBERS;
        oracle_put(input, oracle_between(random, 0, n[0] - 1));
        oracle_put(input, oracle_between(random, 0, n[1] - 1));
        const double point[3] = {
            ((double)n[ORACLE_SETUP_NUMBERS] + 0.5 - (double)n[0] / 2) * z / focal,
            ((double)n[1] / 2 - (double)n[ORACLE_SETUP_NUMBERS + 1] - 0.5) * z / focal, z};
        corners_about(random, point, view);
        const int swapped = !is_clockwise(view);
        for (int i = 0; i < 3; i++) {
            inside &= put_corner(random, input, view[swapped && i ? 3 - i : i], size, middle);
        }
        if (inside) {
            return;
        }
    }
}

/* --- as a scene ------------------------------------------------------------------------------- */

/* The unit normal of the corners, each component to nearest; coordinates are below 2^30, so
 * products are below 2^63. */
static fxl_direction normal_of(const fxl_point *p)
{
    const int64_t a[3] = {(int64_t)p[1].x - p[0].x, (int64_t)p[1].y - p[0].y,
                          (int64_t)p[1].z - p[0].z};
    const int64_t b[3] = {(int64_t)p[2].x - p[0].x, (int64_t)p[2].y - p[0].y,
                          (int64_t)p[2].z - p[0].z};
    const long double n[3] = {(long double)((oracle_wide)a[1] * b[2] - (oracle_wide)a[2] * b[1]),
                              (long double)((oracle_wide)a[2] * b[0] - (oracle_wide)a[0] * b[2]),
                              (long double)((oracle_wide)a[0] * b[1] - (oracle_wide)a[1] * b[0])};
    const long double length = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length == 0) {
        return (fxl_direction){0, 0, 0};
    }
    return (fxl_direction){(int32_t)floorl(n[0] / length * FXL_Q2_30_ONE + 0.5L),
                           (int32_t)floorl(n[1] / length * FXL_Q2_30_ONE + 0.5L),
                           (int32_t)floorl(n[2] / length * FXL_Q2_30_ONE + 0.5L)};
}

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
    sample->face = (fxl_face){normal_of(sample->corners), 0, 3, 7, 0};
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

/* The pixel over a background; or a background of its own where the library refuses to draw. */
static int draw_over(fxl_renderer *renderer, const surface_sample *sample, uint8_t background)
{
    static uint8_t pixels[FXL_SCREEN_MAX];
    const uint16_t width = renderer->frame.view.lens.width;
    const fxl_band band = {pixels, width, width, (uint16_t)sample->y, 1};
    fxl_fill_band(&band, background);
    return fxl_frame_begin(renderer, &sample->setup.pose) == FXL_OK &&
                   fxl_frame_draw(renderer, &band) == FXL_OK
               ? pixels[sample->x]
               : background;
}

int surface_sample_draw(surface_sample *sample, const fxl_texture *texture,
                        const fxl_surface *surface, const fxl_direction normals[3],
                        const fxl_light_settings *light)
{
    static fxl_renderer renderer;
    static fxl_surfaces surfaces;
    static fxl_light lamp;
    static const uint16_t face_map[1] = {1};
    fxl_order_entry order[2];
    const fxl_memory memory = {order, 2, NULL, 0, NULL, 0};
    fxl_mapped_face mapped = {.corners = {0, 1, 2}, .normals = {0, 1, 2}};
    for (int i = 0; i < 3; i++) {
        mapped.texels[i] =
            (fxl_texel){(int32_t)sample->values[i][0], (int32_t)sample->values[i][1]};
    }
    const fxl_surface_set set = {.textures = texture,
                                 .surfaces = surface,
                                 .faces = &mapped,
                                 .face_map = face_map,
                                 .normals = normals,
                                 .texture_count = texture ? 1 : 0,
                                 .surface_count = 1,
                                 .face_count = 1,
                                 .normal_count = normals ? 3 : 0};
    if (fxl_renderer_init_with(&renderer, &sample->scene, &sample->lens, &memory) != FXL_OK ||
        fxl_renderer_set_surfaces(&renderer, &surfaces, &set) != FXL_OK ||
        (light && (fxl_renderer_set_light(&renderer, &lamp, light) != FXL_OK ||
                   fxl_renderer_light_surfaces(&renderer, &lamp) != FXL_OK))) {
        return -1;
    }
    const int shown = draw_over(&renderer, sample, 0);
    return shown == draw_over(&renderer, sample, 255) ? shown : -1;
}

/* --- exact arithmetic ------------------------------------------------------------------------- */

typedef struct {
    mpz_t c[3];
} vector;

static void init(vector *v)
{
    for (int k = 0; k < 3; k++) {
        mpz_init(v->c[k]);
    }
}

static void clear(vector *v)
{
    for (int k = 0; k < 3; k++) {
        mpz_clear(v->c[k]);
    }
}

static void set_cross(vector *to, const vector *a, const vector *b)
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        mpz_mul(to->c[k], a->c[i], b->c[j]);
        mpz_submul(to->c[k], a->c[j], b->c[i]);
    }
}

static void set_dot(mpz_t to, const vector *a, const int64_t way[3])
{
    mpz_set_si(to, 0);
    for (int k = 0; k < 3; k++) {
        mpz_t factor;
        mpz_init_set_si(factor, way[k]);
        mpz_addmul(to, a->c[k], factor);
        mpz_clear(factor);
    }
}

/* The largest component. */
static double size_of(const vector *v)
{
    double largest = 0;
    for (int k = 0; k < 3; k++) {
        largest = fmax(largest, fabs(mpz_get_d(v->c[k])));
    }
    return largest;
}

static void way_of(const surface_sample *sample, int64_t x, int64_t y, int64_t way[3])
{
    const fxl_view *view = &sample->setup.view;
    way[0] = x * 65536 + 32768 - view->projection.centre_x;
    way[1] = view->projection.centre_y - 32768 - y * 65536;
    way[2] = fxl_view_drawn_focal(view);
}

/* The largest |v . D| at the four corners of the screen, whose width is rounded up. */
static double largest_on_screen(const surface_sample *sample, const vector *v)
{
    const fxl_lens *lens = &sample->setup.view.lens;
    double largest = 0;
    for (int i = 0; i < 4; i++) {
        int64_t way[3];
        mpz_t value;
        mpz_init(value);
        way_of(sample, i & 1 ? (lens->width + 15) & ~15 : 0, i & 2 ? lens->height : 0, way);
        set_dot(value, v, way);
        largest = fmax(largest, fabs(mpz_get_d(value)));
        mpz_clear(value);
    }
    return largest;
}

/* n, E2 x P0, P0 x E1, and with the attribute A. */
static void find_planes(const surface_sample *sample, int attribute, vector planes[4])
{
    vector p, e1, e2;
    init(&p);
    init(&e1);
    init(&e2);
    for (int i = 2; i >= 0; i--) {
        const int64_t point[3] = {sample->corners[i].x, sample->corners[i].y, sample->corners[i].z};
        const oracle_view_point at = oracle_transform(&sample->setup.view.camera, point);
        vector *to = i == 2 ? &e2 : i == 1 ? &e1 : &p;
        mpz_set_si(to->c[0], at.x);
        mpz_set_si(to->c[1], at.y);
        mpz_set_si(to->c[2], at.z);
    }
    for (int k = 0; k < 3; k++) {
        mpz_sub(e1.c[k], e1.c[k], p.c[k]);
        mpz_sub(e2.c[k], e2.c[k], p.c[k]);
    }
    set_cross(&planes[0], &e1, &e2);
    set_cross(&planes[1], &e2, &p);
    set_cross(&planes[2], &p, &e1);
    const int64_t first = sample->values[0][attribute];
    for (int k = 0; k < 3; k++) {
        mpz_mul_si(planes[3].c[k], planes[0].c[k], first);
        for (int i = 1; i < 3; i++) {
            mpz_t change;
            mpz_init_set_si(change, sample->values[i][attribute] - first);
            mpz_addmul(planes[3].c[k], planes[i].c[k], change);
            mpz_clear(change);
        }
    }
    clear(&p);
    clear(&e1);
    clear(&e2);
}

static double bound_of(const surface_sample *sample, int attribute, const vector planes[4],
                       double weight, double value)
{
    const double first = (double)sample->values[0][attribute] / 65536;
    int64_t way[3];
    way_of(sample, sample->x, sample->y, way);
    const double length = (double)(llabs(way[0]) + llabs(way[1]) + llabs(way[2]));
    double k = (fabs(first) + fabs(value)) * size_of(&planes[0]);
    for (int i = 1; i < 3; i++) {
        k += fabs((double)sample->values[i][attribute] / 65536 - first) * size_of(&planes[i]);
    }
    const double largest = largest_on_screen(sample, &planes[3]) / 65536 +
                           fabs(value) * largest_on_screen(sample, &planes[0]);
    return 0x1p-28 * k * length / weight + 0x1p-29 * largest / weight + 0x1p-28 * fabs(value) +
           0x1p-16;
}

int64_t surface_sample_exact(const surface_sample *sample, int attribute, double *bound)
{
    vector planes[4];
    int64_t way[3];
    mpz_t value, weight;
    mpz_init(value);
    mpz_init(weight);
    for (int i = 0; i < 4; i++) {
        init(&planes[i]);
    }
    find_planes(sample, attribute, planes);
    way_of(sample, sample->x, sample->y, way);
    set_dot(weight, &planes[0], way);
    set_dot(value, &planes[3], way);
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
    for (int i = 0; i < 4; i++) {
        clear(&planes[i]);
    }
    mpz_clear(value);
    mpz_clear(weight);
    return exact;
}
