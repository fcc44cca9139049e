/* SPDX-License-Identifier: MIT */
#include "oracle/clip.h"

#include <stdio.h>
#include <stdlib.h>
#include <gmp.h>
#include <string.h>

#include "study/normalised.h"
#include "frames/methods.h"
#include "unit/polygon_face.h"
#include "study/clippers.h"

static void set_screen(const fxl_lens *lens, oracle_space *space)
{
    space->centre_x = (int64_t)lens->width << 15;
    space->centre_y = (int64_t)lens->height << 15;
}

oracle_space oracle_space_of_view(const fxl_view *view)
{
    const fxl_view_frustum *f = &view->view_frustum;
    oracle_space space = {.camera = view->camera,
                          .planes = {[FXL_PLANE_NEAR] = {0, 0, 1, -f->near_z, 0},
                                     [FXL_PLANE_FAR] = {0, 0, -1, f->far_z, 0},
                                     [FXL_PLANE_LEFT] = {f->x_side, 0, f->x_depth, -f->inset, 30},
                                     [FXL_PLANE_RIGHT] = {-f->x_side, 0, f->x_depth, -f->inset, 30},
                                     [FXL_PLANE_BOTTOM] = {0, f->y_side, f->y_depth, -f->inset, 30},
                                     [FXL_PLANE_TOP] = {0, -f->y_side, f->y_depth, -f->inset, 30}},
                          .x_scale = view->lens.focal,
                          .y_scale = view->lens.focal};
    set_screen(&view->lens, &space);
    return space;
}

/* The integers of the normalised frustum, docs/extras/clippers.md, section 2.2: the matrix
 * includes the field of view. */
static oracle_space space_of_normalised(const fxl_view *view)
{
    fxl_normalised f;
    fxl_normalised_from_camera(&view->camera, &view->lens, &f);
    oracle_space space = {.camera = {f.eye, {f.x.direction, f.y.direction, f.z.direction}},
                          .x_shift = f.x.shift,
                          .y_shift = f.y.shift,
                          .z_shift = f.z.shift,
                          .planes = {[FXL_PLANE_NEAR] = {0, 0, 1, -f.near_z, 0},
                                     [FXL_PLANE_FAR] = {0, 0, -1, f.far_z, 0},
                                     [FXL_PLANE_LEFT] = {1, 0, 1, -f.x_inset, 0},
                                     [FXL_PLANE_RIGHT] = {-1, 0, 1, -f.x_inset, 0},
                                     [FXL_PLANE_BOTTOM] = {0, 1, 1, -f.y_inset, 0},
                                     [FXL_PLANE_TOP] = {0, -1, 1, -f.y_inset, 0}},
                          .x_scale = (int64_t)view->lens.width << 15,
                          .y_scale = (int64_t)view->lens.height << 15};
    set_screen(&view->lens, &space);
    return space;
}

/* The point (x, y, z) / w of the view in units of 2^-46, w > 0. */
typedef struct {
    mpz_t x, y, z, w;
} exact_point;

/* A vertex, and the line on which its edge lies. The line goes through two points, in the edge's
 * direction, that do not lie within the edge. Every cut keeps the line, so numbers do not grow
 * with each cut. */
typedef struct {
    const exact_point *point, *from, *to;
    int origin;
    int opens; /* its edge was made by this plane, and runs to the next vertex */
} exact_vertex;

typedef struct {
    int count;
    exact_vertex vertices[ORACLE_OUTLINE_MAX];
} exact_polygon;

/* The library's numbers make no sense, or the oracle's do not. */
static void give_up(const char *sentence)
{
    fprintf(stderr, "oracle: %s\n", sentence);
    exit(3);
}

enum {
    POOL = FXL_FACE_VERTICES_MAX + FXL_PLANE_COUNT * ORACLE_OUTLINE_MAX
};

static exact_point pool[POOL];
static int pool_used, is_ready;
/* Of the functions below, each of one alone. */
static mpz_t term, from_a, from_b, from_plane, quotient;

static exact_point *new_point(void)
{
    if (pool_used == POOL) {
        give_up("more cuts than six planes can make");
    }
    return &pool[pool_used++];
}

/* w times the distance from a plane, times a factor of that plane. For one plane only the ratios
 * matter. */
static void distance(const oracle_plane *plane, const exact_point *p, mpz_t d)
{
    mpz_mul_si(d, p->w, plane->offset);
    mpz_mul_2exp(d, d, plane->up);
    const mpz_t *sides[3] = {&p->x, &p->y, &p->z};
    const int64_t factors[3] = {plane->x, plane->y, plane->z};
    for (int i = 0; i < 3; i++) {
        mpz_mul_si(term, *sides[i], factors[i]);
        mpz_add(d, d, term);
    }
}

/* The point where the line from a to b meets the plane: d(a) b - d(b) a, in homogeneous
 * coordinates, with w > 0. */
static const exact_point *cross(const oracle_plane *plane, const exact_point *a,
                                const exact_point *b)
{
    exact_point *p = new_point();
    distance(plane, a, from_a);
    distance(plane, b, from_b);
    if (mpz_sgn(from_a) < 0) {
        mpz_neg(from_a, from_a);
        mpz_neg(from_b, from_b);
    }
    const mpz_t *ends[4][2] = {{&a->x, &b->x}, {&a->y, &b->y}, {&a->z, &b->z}, {&a->w, &b->w}};
    mpz_t *sums[4] = {&p->x, &p->y, &p->z, &p->w};
    for (int i = 0; i < 4; i++) {
        mpz_mul(*sums[i], from_a, *ends[i][1]);
        mpz_submul(*sums[i], from_b, *ends[i][0]);
    }
    return p;
}

static void append(exact_polygon *polygon, exact_vertex vertex)
{
    if (polygon->count == ORACLE_OUTLINE_MAX) {
        give_up("a clipped polygon has more vertices than its array");
    }
    polygon->vertices[polygon->count++] = vertex;
}

/* Clips to one plane. A vertex on the plane is inside, and is not repeated. */
static void clip_to_plane(const oracle_plane *plane, int number, const exact_polygon *in,
                          exact_polygon *out)
{
    int signs[ORACLE_OUTLINE_MAX];
    for (int i = 0; i < in->count; i++) {
        distance(plane, in->vertices[i].point, from_plane);
        signs[i] = mpz_sgn(from_plane);
    }
    out->count = 0;
    for (int i = 0; i < in->count; i++) {
        int next = i + 1 == in->count ? 0 : i + 1;
        exact_vertex vertex = in->vertices[i];
        if (signs[i] >= 0) {
            vertex.opens = signs[i] == 0 && signs[next] < 0;
            append(out, vertex);
        }
        if ((signs[i] > 0 && signs[next] < 0) || (signs[i] < 0 && signs[next] > 0)) {
            vertex.point = cross(plane, vertex.from, vertex.to);
            vertex.opens = signs[i] > 0;
            append(out, vertex);
        }
    }
    for (int i = 0; i < out->count; i++) {
        exact_vertex *vertex = &out->vertices[i];
        if (vertex->opens) {
            vertex->from = vertex->point;
            vertex->to = out->vertices[(i + 1) % out->count].point;
            vertex->origin = -1 - number;
        }
    }
}

/* floor(scale * side 2^32 / depth) */
static int64_t project(int64_t scale, const mpz_t side, const mpz_t depth)
{
    mpz_mul_si(quotient, side, scale);
    mpz_mul_2exp(quotient, quotient, ORACLE_SPOT_BITS);
    mpz_fdiv_q(quotient, quotient, depth);
    if (!mpz_fits_slong_p(quotient)) {
        give_up("a vertex inside the frustum lies far off the screen");
    }
    return mpz_get_si(quotient);
}

/* floor(value / 2^shift + 1/2); value is below 2^61. */
static int64_t rounded(int64_t value, unsigned shift)
{
    return shift == 0 ? value : (value + ((int64_t)1 << (shift - 1))) >> shift;
}

static void make_numbers(void)
{
    for (int i = 0; i < POOL && !is_ready; i++) {
        mpz_inits(pool[i].x, pool[i].y, pool[i].z, pool[i].w, NULL);
    }
    if (!is_ready) {
        mpz_inits(term, from_a, from_b, from_plane, quotient, NULL);
    }
    is_ready = 1;
}

static void start(const oracle_space *space, const fxl_polygon *polygon, exact_polygon *exact)
{
    make_numbers();
    pool_used = 0;
    exact->count = polygon->count;
    for (int i = 0; i < polygon->count; i++) {
        const fxl_point *p = &polygon->vertices[i].position;
        oracle_view_point v = oracle_transform(&space->camera, (int64_t[3]){p->x, p->y, p->z});
        exact_point *point = new_point();
        mpz_set_si(point->x, rounded(v.x, space->x_shift));
        mpz_set_si(point->y, rounded(v.y, space->y_shift));
        mpz_set_si(point->z, rounded(v.z, space->z_shift));
        mpz_set_si(point->w, 1);
        exact->vertices[i].point = exact->vertices[i].from = point;
        exact->vertices[i].origin = i;
    }
    for (int i = 0; i < exact->count; i++) {
        exact->vertices[i].to = exact->vertices[(i + 1) % exact->count].point;
    }
}

void oracle_clip(const oracle_space *space, const fxl_polygon *polygon, oracle_outline *outline)
{
    static exact_polygon polygons[2];
    /* The order of SPEC.md, section 4.3. If a polygon is not quite flat, the order changes the
     * result. */
    static const int order[] = {FXL_PLANE_NEAR,  FXL_PLANE_FAR,    FXL_PLANE_LEFT,
                                FXL_PLANE_RIGHT, FXL_PLANE_BOTTOM, FXL_PLANE_TOP};
    exact_polygon *current = &polygons[0], *other = &polygons[1];
    start(space, polygon, current);
    for (int i = 0; i < FXL_PLANE_COUNT && current->count >= 3; i++) {
        clip_to_plane(&space->planes[order[i]], order[i], current, other);
        exact_polygon *swap = current;
        current = other;
        other = swap;
    }
    outline->count = current->count < 3 ? 0 : current->count;
    for (int i = 0; i < outline->count; i++) {
        const exact_vertex *vertex = &current->vertices[i];
        outline->spots[i].x = space->centre_x * ((int64_t)1 << ORACLE_SPOT_BITS) +
                              project(space->x_scale, vertex->point->x, vertex->point->z);
        outline->spots[i].y = space->centre_y * ((int64_t)1 << ORACLE_SPOT_BITS) -
                              project(space->y_scale, vertex->point->y, vertex->point->z);
        outline->origins[i] = vertex->origin;
    }
}

static const fxl_clipper *chosen = &fxl_clipper_view;
static int own_integers;

int oracle_clipper_choose(const char *name)
{
    const named_clipper *found = find_clipper(name);
    chosen = found ? found->clipper : chosen;
    return found != NULL;
}

void oracle_clipper_own_integers(void)
{
    own_integers = 1;
}

static int is_normalised(void)
{
    return chosen == &fxl_clipper_normalised || chosen == &fxl_clipper_once;
}

oracle_space oracle_clipper_space(const fxl_view *view)
{
    return own_integers && is_normalised() ? space_of_normalised(view) : oracle_space_of_view(view);
}

double oracle_clipper_bound(const fxl_lens *lens)
{
    if (chosen == &fxl_clipper_world) { /* two units of the world at the near plane */
        return 1.25 + 2.0 * lens->focal / lens->near_z;
    }
    if (own_integers && is_normalised()) {
        return 1.25;
    }
    return chosen == &fxl_clipper_normalised || oracle_clipper_wants_triangles() ? 2 : 1.25;
}

int oracle_clipper_wants_triangles(void)
{
    return chosen == &fxl_clipper_once || chosen == &fxl_clipper_triangles;
}

fxl_clip_result oracle_clipper_take(fxl_view *view, const fxl_polygon *polygon,
                                    fxl_screen_polygon *screens, int room_for, int *count)
{
    static fxl_clipper_work work;
    static fxl_clipper_workspace room;
    static polygon_face face;
    memset(&room, 0, sizeof room);
    view->frame += 1;
    if (chosen->begin != NULL) {
        chosen->begin(view);
    }
    polygon_face_set(&face, polygon, view, FXL_POLYGON_CAPACITY);
    face.model_view.clipper_workspace = &room;
    fxl_clip_result result = chosen->clip(&face.model_view, &face.face, &work, &screens[0]);
    fxl_clip_result now = result;
    *count = 0;
    while (now == FXL_CLIP_INSIDE || now == FXL_CLIP_CUT || now == FXL_CLIP_BETWEEN) {
        *count += 1;
        if (chosen->next == NULL) {
            break;
        }
        if (*count == room_for) {
            abort(); /* the caller's array is too small */
        }
        now = chosen->next(&face.model_view, &work, &screens[*count]);
    }
    return result;
}
