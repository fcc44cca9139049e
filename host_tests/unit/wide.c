/* SPDX-License-Identifier: MIT */
#include "wide.h"

static wide negative(wide a)
{
    uint64_t high = ~(uint64_t)a.high + (a.low == 0);
    return (wide){(int64_t)high, 0 - a.low};
}

static uint64_t magnitude(int64_t a)
{
    return a < 0 ? 0 - (uint64_t)a : (uint64_t)a;
}

/* Magnitudes are at most 2^63. */
wide wide_product(int64_t a, int64_t b)
{
    uint64_t x = magnitude(a), y = magnitude(b);
    uint64_t low = (x & 0xFFFFFFFFu) * (y & 0xFFFFFFFFu);
    uint64_t cross = (x >> 32) * (y & 0xFFFFFFFFu), other = (x & 0xFFFFFFFFu) * (y >> 32);
    uint64_t high = (x >> 32) * (y >> 32) + (cross >> 32) + (other >> 32);
    uint64_t sum = low + (cross << 32);
    high += sum < low;
    low = sum + (other << 32);
    high += low < sum;
    wide product = {(int64_t)high, low};
    return (a < 0) != (b < 0) ? negative(product) : product;
}

wide wide_sum(wide a, wide b)
{
    uint64_t low = a.low + b.low;
    uint64_t high = (uint64_t)a.high + (uint64_t)b.high + (low < a.low);
    return (wide){(int64_t)high, low};
}

wide wide_difference(wide a, wide b)
{
    return wide_sum(a, negative(b));
}

int wide_compare(wide a, wide b)
{
    if (a.high != b.high) {
        return a.high < b.high ? -1 : 1;
    }
    return a.low < b.low ? -1 : a.low > b.low;
}

bool wide_narrow(wide a, int64_t *narrow)
{
    *narrow = (int64_t)a.low;
    return a.high == (*narrow < 0 ? -1 : 0);
}
