/* SPDX-License-Identifier: MIT */
/* Whole numbers of 128 bits, for exact checks on cores whose compiler has none. */
#ifndef WIDE_H
#define WIDE_H

#include <stdbool.h>
#include <stdint.h>

/* 2^64 high + low. */
typedef struct {
    int64_t high;
    uint64_t low;
} wide;

/* Exact. */
wide wide_product(int64_t a, int64_t b);

/* Exact below 2^127. */
wide wide_sum(wide a, wide b);
wide wide_difference(wide a, wide b);

/* Below 0, 0 or above 0, as a is less than, equal to or greater than b. */
int wide_compare(wide a, wide b);

/* Whether it fits 64 bits; then *narrow is the same number. */
bool wide_narrow(wide a, int64_t *narrow);

#endif
