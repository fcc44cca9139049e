/* SPDX-License-Identifier: MIT */
#include "oracle/depth.h"

#include <math.h>

enum {
    PIXEL = ORACLE_SETUP_NUMBERS
};

int depth_sample_put(oracle_random *random, const double z[DEPTH_FACES], double most,
                     oracle_input *input)
{
    const int64_t *n = input->numbers;
    int inside = 1;
    oracle_put(input, oracle_between(random, 0, n[0] - 1));
    oracle_put(input, oracle_between(random, 0, n[1] - 1));
    for (int face = 0; face < DEPTH_FACES; face++) {
        double point[3], view[3][3];
        oracle_triangle_point(input, &n[PIXEL], z[face], point);
        oracle_triangle_about(random, point, most, view);
        for (int i = 0; i < 3; i++) {
            inside &= oracle_put_point(input, view[i]);
        }
    }
    return inside;
}

int depth_sample_read(const oracle_input *input, depth_sample *sample)
{
    const int64_t *n = input->numbers;
    if (input->count < DEPTH_NUMBERS || !oracle_setup_read(input, &sample->setup) ||
        !oracle_setup_lens(input, &sample->lens) || n[PIXEL] < 0 ||
        n[PIXEL] >= sample->lens.width || n[PIXEL + 1] < 0 || n[PIXEL + 1] >= sample->lens.height) {
        return 0;
    }
    sample->pixel[0] = n[PIXEL];
    sample->pixel[1] = n[PIXEL + 1];
    for (int i = DEPTH_CORNERS; i < DEPTH_NUMBERS; i++) {
        if (n[i] < -FXL_COORDINATE_MAX || n[i] > FXL_COORDINATE_MAX) {
            return 0;
        }
        (&sample->corners[(i - DEPTH_CORNERS) / 3].x)[(i - DEPTH_CORNERS) % 3] = (int32_t)n[i];
    }
    for (int i = 0; i < DEPTH_FACES; i++) {
        sample->faces[i] = (fxl_face){
            oracle_triangle_normal(&sample->corners[3 * i]), 3, (uint8_t)(i + 1), {0, 1, 2}};
        sample->models[i] = (fxl_model){.first_vertex = (uint32_t)(3 * i),
                                        .vertex_count = 3,
                                        .first_face = (uint32_t)i,
                                        .face_count = 1,
                                        .kind = FXL_MODEL_CONVEX,
                                        .radius = FXL_RADIUS_MAX};
        sample->instances[i] = (fxl_instance){{0, 0, 0}, (uint16_t)i, 0, 0};
    }
    for (int i = 0; i < 3 * DEPTH_FACES; i++) {
        sample->indices[i] = (uint16_t)(i % 3);
    }
    sample->scene = (fxl_scene){.vertices = sample->corners,
                                .indices = sample->indices,
                                .faces = sample->faces,
                                .models = sample->models,
                                .instances = sample->instances,
                                .vertex_count = 3 * DEPTH_FACES,
                                .index_count = 3 * DEPTH_FACES,
                                .face_count = DEPTH_FACES,
                                .model_count = DEPTH_FACES,
                                .instance_count = DEPTH_FACES};
    return fxl_scene_check(&sample->scene, NULL) == FXL_OK;
}

/* The colour of the pixel; 0 where neither face is drawn. */
static int colour_of(const depth_sample *sample, int wide)
{
    static fxl_renderer renderer;
    static uint8_t pixels[FXL_SCREEN_MAX];
    static uint64_t cells[FXL_DEPTH_BYTES(FXL_SCREEN_MAX, 1, 32) / 8];
    fxl_draw_entry order[2 * DEPTH_FACES];
    const fxl_memory memory = {order, 2 * DEPTH_FACES, NULL, 0, NULL, 0};
    const uint16_t width = sample->lens.width;
    const fxl_band band = {.pixels = pixels,
                           .width = width,
                           .stride = width,
                           .first_row = (uint16_t)sample->pixel[1],
                           .rows = 1};
    fxl_config config =
        fxl_config_for(width, 1, wide ? &fxl_palette_depth_32 : &fxl_palette_depth_16);
    config.depth = cells;
    config.depth_size = FXL_DEPTH_BYTES(width, 1, wide ? 32 : 16);
    if (fxl_renderer_init_with(&renderer, &sample->scene, &sample->lens, &memory) != FXL_OK ||
        fxl_renderer_choose(&renderer, &config) != FXL_OK) {
        return 0;
    }
    fxl_fill_band(&band, 0);
    return fxl_frame_begin(&renderer, &sample->setup.pose) == FXL_OK &&
                   fxl_frame_draw(&renderer, &band) == FXL_OK
               ? pixels[sample->pixel[0]]
               : 0;
}

int depth_sample_drawn(const depth_sample *sample, int wide)
{
    return colour_of(sample, wide) - 1;
}

int depth_sample_covers(const depth_sample *sample, int face)
{
    depth_sample alone = *sample;
    alone.instances[0] = alone.instances[face];
    alone.scene.vertices = alone.corners;
    alone.scene.indices = alone.indices;
    alone.scene.faces = alone.faces;
    alone.scene.models = alone.models;
    alone.scene.instances = alone.instances;
    alone.scene.instance_count = 1;
    return colour_of(&alone, 0) == face + 1;
}

/* --- exact distances ------------------------------------------------------------------------ */

/* A face along the ray of the pixel: its distance is volume / weight; both are positive. */
typedef struct {
    mpz_t volume, weight;
    double slack; /* what SPEC.md, sections 10.1 and 10.2, allow, relative to the distance */
} ray_hit;

static double length_of(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* The plane may be off by 2^-26 of the face's size along its normal. Along the ray that is divided
 * by the cosine between both. The corners have units of 2^-46, the way those of 2^-16. */
static double slack_of(const oracle_view_point corners[3], const oracle_vector *normal,
                       double weight, double distance)
{
    const double n[3] = {mpz_get_d(normal->c[0]), mpz_get_d(normal->c[1]), mpz_get_d(normal->c[2])};
    double size = 0;
    for (int i = 1; i < 3; i++) {
        const double edge[3] = {(double)(corners[i].x - corners[0].x),
                                (double)(corners[i].y - corners[0].y),
                                (double)(corners[i].z - corners[0].z)};
        size = fmax(size, length_of(edge));
    }
    /* distance: how often the way leads to the face */
    return 0x1p-26 * size * length_of(n) / (weight * distance) + 0x1p-27;
}

/* Returns 0 where the ray does not meet the front of the plane. */
static int hit(const depth_sample *sample, int face, ray_hit *result)
{
    oracle_view_point corners[3];
    oracle_vector planes[3];
    int64_t way[3];
    for (int i = 0; i < 3; i++) {
        const fxl_point *p = &sample->corners[3 * face + i];
        const int64_t point[3] = {p->x, p->y, p->z};
        corners[i] = oracle_transform(&sample->setup.view.camera, point);
    }
    oracle_vectors_init(planes, 3);
    oracle_triangle_planes(corners, planes);
    oracle_pixel_way(&sample->setup.view, sample->pixel[0], sample->pixel[1], way);
    const int64_t first[3] = {corners[0].x, corners[0].y, corners[0].z};
    oracle_vector_dot(result->volume, &planes[0], first);
    oracle_vector_dot(result->weight, &planes[0], way);
    mpz_abs(result->volume, result->volume);
    const int there = mpz_sgn(result->weight) != 0;
    mpz_abs(result->weight, result->weight);
    if (there) {
        const double weight = mpz_get_d(result->weight);
        result->slack = slack_of(corners, &planes[0], weight, mpz_get_d(result->volume) / weight);
    }
    oracle_vectors_clear(planes, 3);
    return there;
}

static double gap_of(const ray_hit hits[DEPTH_FACES])
{
    mpz_t first, second;
    mpz_init(first);
    mpz_init(second);
    mpz_mul(first, hits[0].volume, hits[1].weight);
    mpz_mul(second, hits[1].volume, hits[0].weight);
    mpz_sub(second, second, first);
    const double gap = mpz_get_d(second) / mpz_get_d(first);
    mpz_clear(first);
    mpz_clear(second);
    return gap;
}

int depth_sample_gap(const depth_sample *sample, double *gap, double *slack)
{
    ray_hit hits[DEPTH_FACES];
    int there = 1;
    for (int i = 0; i < DEPTH_FACES; i++) {
        mpz_init(hits[i].volume);
        mpz_init(hits[i].weight);
        there = there && hit(sample, i, &hits[i]);
    }
    there = there && mpz_sgn(hits[0].volume) != 0;
    if (there) {
        *gap = gap_of(hits);
        *slack = hits[0].slack + hits[1].slack;
    }
    for (int i = 0; i < DEPTH_FACES; i++) {
        mpz_clear(hits[i].volume);
        mpz_clear(hits[i].weight);
    }
    return there;
}

/* depth_16 and depth_32: two triangles seen through one pixel, drawn with a depth buffer. Which one
 * shows, against the exact distances of both. */

enum {
    WIDE_BITS = 5 /* what 32 bits resolve more (SPEC.md, section 10.6) */
};

/* --- samples -------------------------------------------------------------------------------- */

/* m of SPEC.md, section 10.3. */
static int mantissa_of(const fxl_lens *lens)
{
    const int64_t most = (int64_t)lens->far_z * 257 / 256 + 1;
    int e = 1, m = 15;
    while ((int64_t)lens->near_z << e < most) {
        e++;
    }
    while (e << m >= 65536) {
        m--;
    }
    return m;
}

/* The distances differ by 2^-20 to 2^-9 of themselves, or by 2^-5 of that with 32 bits. */
static void generate(oracle_random *random, oracle_input *input)
{
    const int wide = input->variant;
    oracle_setup_generate(random, FXL_SCREEN_MAX, input);
    const int64_t *n = input->numbers;
    const double near = (double)(n[3] + 2 * n[5] + 2) / 65536;
    const double far = fmin((double)(n[4] - n[5]) / 65536, 8000);
    for (int tries = 0; tries < 64; tries++) {
        const double z = far > near ? oracle_spread(random, near, far) : near;
        const double gap = ldexp(oracle_spread(random, 0x1p-20, 0x1p-9), wide ? -WIDE_BITS : 0);
        const int flat = oracle_below(random, 2) == 0; /* as large as few pixels */
        const double depths[DEPTH_FACES] = {z, z * (1 + gap)};
        input->count = ORACLE_SETUP_NUMBERS;
        if (depth_sample_put(random, depths, flat ? 0.5 : 20, input)) {
            return;
        }
    }
}

/* --- the claims ----------------------------------------------------------------------------- */

/* accuracy 5.4 */
static oracle_outcome judge(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    static depth_sample sample;
    const int wide = input->variant;
    double gap, slack;
    if (input->count != DEPTH_NUMBERS) {
        return ORACLE_UNUSABLE;
    }
    if (!depth_sample_read(input, &sample) || !depth_sample_gap(&sample, &gap, &slack)) {
        return ORACLE_SKIPPED;
    }
    const int m = mantissa_of(&sample.setup.view.lens) + (wide ? WIDE_BITS : 0);
    const double allowed = (1 + 1.0 / 32) * ldexp(1, -m) + slack;
    const int nearer = gap > 0 ? 0 : 1, shown = depth_sample_drawn(&sample, wide);
    if (shown < 0 || !depth_sample_covers(&sample, nearer)) {
        return ORACLE_SKIPPED;
    }
    verdict->value = shown != nearer ? fabs(gap) / allowed : 0;
    verdict->extras[0] = shown != nearer;
    if (words) {
        fprintf(words,
                "the %s face is nearer, by %.9g of the distance; the %s one shows; "
                "the resolution is %.9g\n",
                nearer ? "second" : "first", fabs(gap), shown ? "second" : "first", allowed);
    }
    return ORACLE_COUNTED;
}

/* Of a buffer of 16 bits a pixel or, where wide, 32. */
#define DEPTH_CLAIM(bits, wide) \
    const oracle_claim oracle_depth_##bits = { \
        .id = "depth_" #bits, \
        .unit = "of its bound", \
        .numbers = DEPTH_TEXT, \
        .kinds = {"two faces through a pixel"}, \
        .extras = {"farther_one_shown"}, \
        .variant = wide, \
        .generate = generate, \
        .judge = judge, \
    }

DEPTH_CLAIM(16, 0);
DEPTH_CLAIM(32, 1);
