/* SPDX-License-Identifier: MIT */
/* Compares the kernel with the portable one, and both with the long division that defines the
 * result. */
#include "view/project.h"

#include "equality.h"
#include "sides.h"

#define SIDE_MAX (((int64_t)1 << 61) - 1)

/* The value that must be unchanged where nothing is to be written. */
static const fxl_screen_point untouched = {0x5A5A5A5A, 0x5A5A5A5A};

static bool same(fxl_screen_point a, fxl_screen_point b)
{
    return a.x == b.x && a.y == b.y;
}

static bool is_within(int64_t side, int64_t limit)
{
    return side >= -limit && side <= limit;
}

static void compare(const fxl_projection *projection, const fxl_view_point *view)
{
    fxl_screen_point core = untouched, portable = untouched, any = untouched;
    fxl_status by_any = fxl_project_any(projection, view, &any);
    fxl_status by_seen = fxl_project_visible(projection, view, &core);
    bool equal = by_seen == by_any && same(core, any);
    if (view->z > 0 && is_within(view->x, 2 * view->z) && is_within(view->y, 2 * view->z)) {
        core = untouched;
        fxl_status by_core = fxl_project_inside(projection, view, &core);
        fxl_status by_portable = portable_project_inside(projection, view, &portable);
        equal = equal && by_core == by_any && by_portable == by_any && same(core, any) &&
                same(portable, any);
    }
    equality_case(equal);
}

static int64_t held(int64_t side)
{
    return side > SIDE_MAX ? SIDE_MAX : side < -SIDE_MAX ? -SIDE_MAX : side;
}

/* A side whose offset lies within a hair of whole + 1/2 units: the nearest to
 * (2 whole + 1) z / (2 focal), in parts that fit: below 2 z. */
static int64_t beside_half(uint32_t focal, int64_t z, uint32_t whole, int32_t little)
{
    int64_t twice = 2 * (int64_t)focal, odd = 2 * (int64_t)whole + 1;
    return held(z / twice * odd + z % twice * odd / twice + little);
}

static int64_t any_side(uint32_t focal, int64_t z)
{
    switch (any_32() >> 9 & 7u) {
    case 0: /* anything */
        return held((int64_t)any_64() >> (3 + (any_32() >> 5 & 31u)));
    case 1: /* beside the bound of the short way */
        return held((any_32() & 256u ? 2 : -2) * z + (int64_t)(any_32() & 0xFFu) - 128);
    case 2:
        return beside_half(focal, z, any_32() % (2u * focal), (int32_t)(any_32() >> 28) - 8);
    case 3:
        return -beside_half(focal, z, any_32() % (2u * focal), (int32_t)(any_32() >> 28) - 8);
    default: /* in sight, or nearly: up to 2 z */
        return held((int64_t)((uint64_t)z >> 30) * ((int32_t)any_32() / 2) +
                    (int64_t)(any_32() & 0xFFFFu));
    }
}

static int64_t any_depth(void)
{
    if ((any_32() >> 11 & 7u) == 0) {
        return ((int64_t)1 << (36 + any_32() % 25u)) + (int32_t)(any_32() >> 28) - 8;
    }
    return (int64_t)(any_64() >> (3 + any_32() % 24u));
}

static uint32_t any_focal(void)
{
    /* 8780 to 5852.2 pixels: SPEC.md, section 3. */
    uint32_t focal = any_32() >> (3u + (any_32() >> 9) % 16u);
    return focal < 8780u ? 8780u + focal : focal > 383529779u ? 383529779u : focal;
}

static void set_lens(uint32_t focal, fxl_projection *projection)
{
    fxl_lens lens = {0};
    lens.width = (uint16_t)(1u + (any_32() >> 3) % 1024u);
    lens.height = (uint16_t)(1u + (any_32() >> 3) % 1024u);
    lens.focal = (fxl_q16_16)focal;
    portable_projection_from_lens(&lens, projection); /* all that any side reads */
}

static void boundaries(void)
{
    static const uint32_t focals[] = {8780u,      10485760u,  (1u << 25),      (1u << 26) - 1u,
                                      (1u << 26), 383529779u, (1u << 24) + 1u, (1u << 25) - 1u};
    fxl_projection projection;
    for (uint32_t f = 0; f < sizeof focals / sizeof focals[0]; f++) {
        set_lens(focals[f], &projection);
        for (uint32_t bits = 35; bits <= 61; bits++) {
            for (int32_t little = -2; little <= 2; little++) {
                int64_t z = ((int64_t)1 << bits) + little;
                if (z > SIDE_MAX) {
                    continue;
                }
                const int64_t sides[] = {0,
                                         1,
                                         -1,
                                         z,
                                         -z,
                                         2 * (z / 2),
                                         z / 2,
                                         -z / 2,
                                         held(2 * z),
                                         held(-2 * z),
                                         SIDE_MAX,
                                         -SIDE_MAX,
                                         held(2 * z - 1),
                                         held(1 - 2 * z),
                                         held(2 * z + 1),
                                         z + 1};
                for (uint32_t x = 0; x < 16; x++) {
                    for (uint32_t y = 0; y < 16; y++) {
                        fxl_view_point view = {sides[x], sides[y], z};
                        compare(&projection, &view);
                    }
                }
            }
        }
    }
}

void test_project(uint32_t rounds)
{
    fxl_projection projection;
    uint32_t focal = 10485760u;
    boundaries();
    for (uint32_t i = 0; i < rounds; i++) {
        if (i % 16u == 0) {
            focal = any_focal();
            set_lens(focal, &projection);
        }
        fxl_view_point view;
        view.z = any_depth();
        view.x = any_side(focal, view.z);
        view.y = any_side(focal, view.z);
        compare(&projection, &view);
    }
}
