/* SPDX-License-Identifier: MIT */
#include "exact_placement.h"

#include <math.h>
#include <string.h>

void exact_entries(const fxl_orientation *o, fxl_q2_30 out[3][3])
{
    memcpy(out, o, sizeof *o);
}

long double exact_distance(const exact_placement *wanted, const fxl_orientation *actual)
{
    fxl_q2_30 found[3][3];
    long double most = 0;
    exact_entries(actual, found);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            most = fmaxl(most, fabsl(wanted->at[i][j] * EXACT_ONE - found[i][j]));
        }
    }
    return most;
}

exact_placement exact_angles(fxl_angle yaw, fxl_angle pitch, fxl_angle roll)
{
    const long double turn = EXACT_PI / 2147483648.0L;
    const long double sy = sinl(yaw * turn), cy = cosl(yaw * turn);
    const long double sp = sinl(pitch * turn), cp = cosl(pitch * turn);
    const long double sr = sinl(roll * turn), cr = cosl(roll * turn);
    return (exact_placement){{{cr * cy - sr * sp * sy, -sr * cy - cr * sp * sy, cp * sy},
                              {sr * cp, cr * cp, sp},
                              {-cr * sy - sr * sp * cy, sr * sy - cr * sp * cy, cp * cy}}};
}

exact_placement exact_axis(fxl_point axis, fxl_angle angle)
{
    const long double length = sqrtl((long double)axis.x * axis.x + (long double)axis.y * axis.y +
                                     (long double)axis.z * axis.z);
    const long double a[3] = {axis.x / length, axis.y / length, axis.z / length};
    const long double s = sinl(angle * EXACT_PI / 2147483648.0L),
                      c = cosl(angle * EXACT_PI / 2147483648.0L);
    exact_placement result;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        result.at[i][i] = c + (1 - c) * a[i] * a[i];
        result.at[i][j] = (1 - c) * a[i] * a[j] - s * a[k];
        result.at[j][i] = (1 - c) * a[i] * a[j] + s * a[k];
    }
    return result;
}

exact_placement exact_product(const exact_placement *a, const exact_placement *b)
{
    exact_placement product;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            product.at[i][j] =
                a->at[i][0] * b->at[0][j] + a->at[i][1] * b->at[1][j] + a->at[i][2] * b->at[2][j];
        }
    }
    return product;
}

static void cross(const long double a[3], const long double b[3], long double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
}

static long double length_of(const long double v[3])
{
    return sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void unit_vector(long double v[3])
{
    const long double length = length_of(v);
    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

exact_placement exact_look(fxl_point direction, fxl_point up)
{
    long double forward[3] = {direction.x, direction.y, direction.z};
    long double above[3] = {up.x, up.y, up.z}, right[3], top[3];
    exact_placement result;
    cross(above, forward, right);
    unit_vector(forward);
    unit_vector(right);
    cross(forward, right, top);
    for (int i = 0; i < 3; i++) {
        result.at[i][0] = right[i];
        result.at[i][1] = top[i];
        result.at[i][2] = forward[i];
    }
    return result;
}

static exact_placement exact_rows(const fxl_orientation *of)
{
    fxl_q2_30 entries[3][3];
    exact_placement rows;
    exact_entries(of, entries);
    for (int i = 0; i < 9; i++) {
        rows.at[i / 3][i % 3] = entries[i / 3][i % 3] / EXACT_ONE;
    }
    return rows;
}

/* Newton's method, X + (I - X X^T) X / 2, converges by squares: from an error below 2^-26 two steps
 * leave no more than the last bits. */
exact_placement exact_nearest_to_product(const fxl_orientation *a, const fxl_orientation *b)
{
    const exact_placement first = exact_rows(a), second = exact_rows(b);
    exact_placement nearest = exact_product(&first, &second);
    for (int step = 0; step < 3; step++) {
        const exact_placement before = nearest;
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                long double off = i == j;
                for (int k = 0; k < 3; k++) {
                    off -= before.at[i][k] * before.at[j][k];
                }
                for (int k = 0; k < 3; k++) {
                    nearest.at[i][k] += off * before.at[j][k] / 2;
                }
            }
        }
    }
    return nearest;
}

exact_place exact_place_of(const fxl_point *centre, const fxl_placement *placement)
{
    return (exact_place){{centre->x, centre->y, centre->z},
                         placement->scale / 65536.0L,
                         exact_rows(&placement->orientation)};
}

exact_place exact_attached(const exact_place *parent, const exact_place *child)
{
    exact_place at = *parent;
    at.scale *= child->scale;
    at.turn = exact_product(&parent->turn, &child->turn);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            at.centre[i] += parent->scale * parent->turn.at[i][j] * child->centre[j];
        }
    }
    return at;
}

exact_bounds exact_bounds_of_child(const exact_bounds *of_parent, const exact_place *parent,
                                   const exact_place *child)
{
    const long double reach = length_of(child->centre);
    return (exact_bounds){
        of_parent->centre + 0.5L +
            reach * (parent->scale * of_parent->turn / EXACT_ONE + of_parent->scale / 65536),
        of_parent->scale * child->scale + 0.5L, of_parent->turn + 4.5L};
}

exact_quaternion exact_hamilton(const exact_quaternion *a, const exact_quaternion *b)
{
    const long double *p = a->at, *q = b->at;
    return (exact_quaternion){{p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
                               p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
                               p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
                               p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]}};
}

static long double norm_of(const exact_quaternion *q)
{
    return q->at[0] * q->at[0] + q->at[1] * q->at[1] + q->at[2] * q->at[2] + q->at[3] * q->at[3];
}

/* Its columns are where the axes go. */
exact_placement exact_turn_of(const exact_quaternion *q)
{
    const exact_quaternion back = {{q->at[0], -q->at[1], -q->at[2], -q->at[3]}};
    const long double norm = norm_of(q);
    exact_placement turn;
    for (int axis = 0; axis < 3; axis++) {
        exact_quaternion v = {{0, axis == 0, axis == 1, axis == 2}};
        v = exact_hamilton(q, &v);
        v = exact_hamilton(&v, &back);
        for (int row = 0; row < 3; row++) {
            turn.at[row][axis] = v.at[1 + row] / norm;
        }
    }
    return turn;
}

/* What is left to turn, R Q', is nearly I + [d], and its quaternion nearly 1 + d / 2. */
exact_quaternion exact_quaternion_of(const exact_placement *turn, const exact_quaternion *about)
{
    exact_quaternion q = *about;
    for (int round = 0; round < 6; round++) {
        const exact_placement now = exact_turn_of(&q);
        exact_placement back;
        for (int i = 0; i < 9; i++) {
            back.at[i % 3][i / 3] = now.at[i / 3][i % 3];
        }
        const exact_placement rest = exact_product(turn, &back);
        const exact_quaternion step = {{1, (rest.at[2][1] - rest.at[1][2]) / 4,
                                        (rest.at[0][2] - rest.at[2][0]) / 4,
                                        (rest.at[1][0] - rest.at[0][1]) / 4}};
        q = exact_hamilton(&step, &q);
        const long double length = sqrtl(norm_of(&q));
        for (int i = 0; i < 4; i++) {
            q.at[i] /= length;
        }
    }
    return q;
}
