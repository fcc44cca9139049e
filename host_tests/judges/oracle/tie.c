/* SPDX-License-Identifier: MIT */
#include "oracle/tie.h"

#include <math.h>

__extension__ typedef __int128 wide;

#define QUARTER UINT32_C(0x40000000)

/* A coefficient times the cosine of an angle below a quarter turn. */
typedef struct {
    uint32_t angle;
    wide coefficient;
} term;

/* One product in an entry of the matrix. */
typedef enum {
    ONE,
    SINE,
    COSINE
} factor;

typedef struct {
    int row, column, sign; /* row 0 right, 1 up, 2 forward */
    factor roll, pitch, yaw;
} product;

/* SPEC.md, section 1.3. */
static const product products[] = {
    {0, 0, 1, COSINE, ONE, COSINE},   {0, 0, -1, SINE, SINE, SINE},   {0, 1, 1, SINE, COSINE, ONE},
    {0, 2, -1, COSINE, ONE, SINE},    {0, 2, -1, SINE, SINE, COSINE}, {1, 0, -1, SINE, ONE, COSINE},
    {1, 0, -1, COSINE, SINE, SINE},   {1, 1, 1, COSINE, COSINE, ONE}, {1, 2, 1, SINE, ONE, SINE},
    {1, 2, -1, COSINE, SINE, COSINE}, {2, 0, 1, ONE, COSINE, SINE},   {2, 1, 1, ONE, SINE, ONE},
    {2, 2, 1, ONE, COSINE, COSINE},
};

enum {
    PRODUCTS = sizeof products / sizeof products[0],
    TERMS = 4 * PRODUCTS
};

/* The factor as the cosine of an angle. */
static uint32_t as_cosine(factor what, uint32_t angle)
{
    return what == ONE ? 0 : what == SINE ? angle - QUARTER : angle;
}

/* Folds the angle into 0..quarter; the cosine of a quarter turn is 0. */
static void add_term(term *terms, int *count, uint32_t angle, wide coefficient)
{
    if (angle > 2 * QUARTER) {
        angle = 0u - angle;
    }
    if (angle > QUARTER) {
        angle = 2 * QUARTER - angle;
        coefficient = -coefficient;
    }
    if (angle == QUARTER) {
        return;
    }
    for (int i = 0; i < *count; i++) {
        if (terms[i].angle == angle) {
            terms[i].coefficient += coefficient;
            return;
        }
    }
    terms[(*count)++] = (term){angle, coefficient};
}

/* Tells whether the sum of weights[row][column] m over the entries m of the matrix is 0. Weights
 * are below 2^91, so sums of 52 terms stay below 2^97. cos a cos b cos c is a quarter of the sum
 * of the four cosines of a +- b +- c. */
static bool is_zero(const oracle_tie_view *view, wide weights[3][3])
{
    term terms[TERMS];
    int count = 0;
    for (int i = 0; i < PRODUCTS; i++) {
        const product *p = &products[i];
        wide weight = p->sign * weights[p->row][p->column];
        uint32_t a = as_cosine(p->roll, view->roll), b = as_cosine(p->pitch, view->pitch);
        uint32_t c = as_cosine(p->yaw, view->yaw);
        add_term(terms, &count, a + b + c, weight);
        add_term(terms, &count, a + b - c, weight);
        add_term(terms, &count, a - b + c, weight);
        add_term(terms, &count, a - b - c, weight);
    }
    for (int i = 0; i < count; i++) {
        if (terms[i].coefficient != 0) {
            return false;
        }
    }
    return true;
}

/* Rows right, up, forward. */
static void set_matrix(const oracle_tie_view *view, long double matrix[3][3])
{
    const uint32_t angles[3] = {view->roll, view->pitch, view->yaw};
    long double values[3][3]; /* by angle, then by factor */
    for (int i = 0; i < 3; i++) {
        long double radians = ldexpl(angles[i], -32) * 6.28318530717958647692528676655900577L;
        values[i][ONE] = 1;
        values[i][SINE] = sinl(radians);
        values[i][COSINE] = cosl(radians);
    }
    for (int i = 0; i < 9; i++) {
        matrix[i / 3][i % 3] = 0;
    }
    for (int i = 0; i < PRODUCTS; i++) {
        const product *p = &products[i];
        matrix[p->row][p->column] +=
            p->sign * values[0][p->roll] * values[1][p->pitch] * values[2][p->yaw];
    }
}

static bool at_least(long double value, long double limit, long double scale)
{
    return value >= limit - 1e-9L * scale;
}

/* Tells whether a point of the view, in 1/65536, lies in the frustum. */
static bool in_frustum(const oracle_tie_view *view, const long double p[3])
{
    long double inset = view->inset, scale = fabsl(p[2]) + 1;
    /* How far the borders are from the centre, towards -x, -y up and towards +x, +y up. */
    long double low[2] = {view->centre[0], view->height * 65536.0L - view->centre[1]};
    long double high[2] = {view->width * 65536.0L - view->centre[0], view->centre[1]};
    if (!at_least(p[2], view->near + inset, scale) || !at_least(view->far - inset, p[2], scale)) {
        return false;
    }
    for (int i = 0; i < 2; i++) {
        long double border[2] = {low[i], high[i]};
        for (int side = 0; side < 2; side++) {
            long double length = hypotl(view->focal, border[side]);
            long double across = view->focal * (side == 0 ? p[i] : -p[i]);
            if (!at_least(border[side] * p[2] + across, inset * length, scale * length)) {
                return false;
            }
        }
    }
    return true;
}

/* Tells whether the visible part of the edge passes the centre, given that its line does. Tests
 * the point a + t (b - a) that is nearest to the ray, 0 <= t <= 1. */
static bool passes_in_sight(const oracle_tie_view *view, const int64_t a[3], const int64_t b[3],
                            const int64_t ray[3])
{
    long double matrix[3][3], va[3], vb[3];
    set_matrix(view, matrix);
    for (int i = 0; i < 3; i++) {
        va[i] = vb[i] = 0;
        for (int k = 0; k < 3; k++) {
            va[i] += matrix[i][k] * a[k];
            vb[i] += matrix[i][k] * b[k];
        }
    }
    /* On the screen, times focal: p z = focal (x, y), so focal x - px z = 0. */
    long double at_a = 0, at_b = 0;
    for (int i = 0; i < 2; i++) {
        long double off_a = ray[2] * va[i] - ray[i] * va[2];
        long double off_b = ray[2] * vb[i] - ray[i] * vb[2];
        if (fabsl(off_a - off_b) > fabsl(at_a - at_b)) {
            at_a = off_a;
            at_b = off_b;
        }
    }
    /* An edge parallel to the ray meets it nowhere. */
    long double apart = at_a - at_b, t = apart != 0 ? at_a / apart : -1, p[3];
    if (!(t >= -1e-9L && t <= 1 + 1e-9L)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        p[i] = va[i] + t * (vb[i] - va[i]);
    }
    return in_frustum(view, p);
}

static bool edge_tied(const oracle_tie_view *view, const int32_t *from, const int32_t *to,
                      const int64_t ray[3])
{
    int64_t a[3], b[3];
    for (int i = 0; i < 3; i++) {
        a[i] = (int64_t)from[i] - view->eye[i];
        b[i] = (int64_t)to[i] - view->eye[i];
    }
    wide weights[3][3];
    bool any = false;
    for (int k = 0; k < 3; k++) {
        /* Differences are below 2^30, so the product is below 2^61. */
        int64_t normal = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        any = any || normal != 0;
        for (int row = 0; row < 3; row++) {
            weights[row][k] = (wide)normal * ray[row];
        }
    }
    /* An edge that points at the eye appears as a point, and a repeated vertex does not appear. */
    return any && is_zero(view, weights) && passes_in_sight(view, a, b, ray);
}

/* place fill-rule: definition: whether a centre is on a tie */
bool oracle_tied(const oracle_tie_view *view, const int32_t *vertices, int count, int column,
                 int row)
{
    const int64_t ray[3] = {(2 * (int64_t)column + 1) * 32768 - view->centre[0],
                            view->centre[1] - (2 * (int64_t)row + 1) * 32768, view->focal};
    for (int i = 0; i < count; i++) {
        if (edge_tied(view, &vertices[3 * i], &vertices[3 * ((i + 1) % count)], ray)) {
            return true;
        }
    }
    return false;
}
