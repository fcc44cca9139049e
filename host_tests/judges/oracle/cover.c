/* SPDX-License-Identifier: MIT */
#include "oracle/cover.h"

#include "oracle/setup.h"

/* place fill-rule: definition: the claims coverage and watertight */
typedef struct {
    int column; /* the first column whose centre is at or right of the edge */
    int winding;
} crossing;

static oracle_wide divide_up(oracle_wide numerator, oracle_wide denominator)
{
    oracle_wide quotient = numerator / denominator; /* towards zero */
    return quotient + (numerator % denominator > 0);
}

/* Returns the first column 0..width whose centre is at or right of the point where the edge
 * crosses the row. Coordinates are below 2^61 and differences below 2^62, so the numerator is
 * below 2^124. */
static int first_column(const oracle_spot *a, const oracle_spot *b, int64_t centre, int bits,
                        int width)
{
    const oracle_spot *top = a->y < b->y ? a : b, *bottom = a->y < b->y ? b : a;
    int64_t half = (int64_t)1 << (15 + bits);
    oracle_wide height = (oracle_wide)bottom->y - top->y;
    oracle_wide x = (oracle_wide)(top->x - half) * height +
                    (oracle_wide)(centre - top->y) * ((oracle_wide)bottom->x - top->x);
    oracle_wide column = divide_up(x, height * 2 * half);
    return column < 0 ? 0 : column > width ? width : (int)column;
}

static void insert(crossing *crossings, int count, crossing added)
{
    while (count > 0 && crossings[count - 1].column > added.column) {
        crossings[count] = crossings[count - 1];
        count--;
    }
    crossings[count] = added;
}

void oracle_cover_row(const oracle_spot *points, int count, int bits, int y, int width,
                      uint8_t *row)
{
    crossing crossings[ORACLE_COVER_EDGES];
    int crossed = 0;
    int64_t centre = (2 * (int64_t)y + 1) << (15 + bits);
    for (int i = 0; i < count; i++) {
        const oracle_spot *a = &points[i], *b = &points[i + 1 == count ? 0 : i + 1];
        int winding = a->y <= centre && centre < b->y   ? 1
                      : b->y <= centre && centre < a->y ? -1
                                                        : 0;
        if (winding != 0) {
            crossing added = {first_column(a, b, centre, bits, width), winding};
            insert(crossings, crossed++, added);
        }
    }
    int winding = 0;
    for (int i = 0; i < crossed; i++) {
        winding += crossings[i].winding;
        int end = i + 1 < crossed ? crossings[i + 1].column : width;
        for (int x = crossings[i].column; winding != 0 && x < end; x++) {
            row[x]++;
        }
    }
}

int oracle_winding(const oracle_spot *points, int count, int bits, int x, int y)
{
    oracle_wide cx = (oracle_wide)(2 * x + 1) << (15 + bits);
    oracle_wide cy = (oracle_wide)(2 * y + 1) << (15 + bits);
    int winding = 0;
    for (int i = 0; i < count; i++) {
        const oracle_spot *a = &points[i], *b = &points[(i + 1) % count];
        /* x at cy = a.x + (cy - a.y) (b.x - a.x) / (b.y - a.y) <= cx, times b.y - a.y */
        oracle_wide height = (oracle_wide)b->y - a->y;
        oracle_wide left = (cy - a->y) * ((oracle_wide)b->x - a->x), right = (cx - a->x) * height;
        if (a->y <= cy && cy < b->y && left <= right) {
            winding += 1;
        } else if (b->y <= cy && cy < a->y && left >= right) {
            winding -= 1;
        }
    }
    return winding;
}
