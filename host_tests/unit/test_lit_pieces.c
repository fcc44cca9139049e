/* SPDX-License-Identifier: MIT */
/* Faces split by beams fit together: along every edge between two pieces, of one face or of
 * two, both have the same points. */
#include "../../lib/paint/lit_pieces.h"
#include "unit.h"

enum {
    CORNERS = 200,
    PIECES = 40,
    EDGES = 160
};

static fxl_point corners[CORNERS];
static uint16_t nexts[CORNERS];
static fxl_lit_piece table[PIECES];
static fxl_lit_pieces workspace = {corners, nexts, table, CORNERS, PIECES, 0, 0};

/* Directed edges of which no other goes the other way. */
static struct {
    fxl_point from, to;
} edges[EDGES];
static uint32_t edge_count;

static bool same(const fxl_point *a, const fxl_point *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

static void add_edge(const fxl_point *from, const fxl_point *to)
{
    if (same(from, to)) {
        return;
    }
    for (uint32_t i = 0; i < edge_count; i++) {
        if (same(&edges[i].from, to) && same(&edges[i].to, from)) {
            edges[i] = edges[--edge_count];
            return;
        }
    }
    TEST_ASSERT_TRUE(edge_count < EDGES);
    edges[edge_count].from = *from;
    edges[edge_count++].to = *to;
}

/* Splits a face and adds its pieces' edges; answers how many have an area. */
static uint32_t add_face(const fxl_beam *beams, uint32_t beam_count, const fxl_point *points,
                         uint32_t count)
{
    const fxl_direction normal = {0, 0, FXL_Q2_30_ONE};
    uint32_t solid = 0;
    TEST_ASSERT_TRUE(fxl_lit_split(&workspace, beams, beam_count, &normal, points, count));
    for (uint32_t i = 0; i < workspace.piece_count; i++) {
        fxl_point outline[FXL_POLYGON_CAPACITY];
        TEST_ASSERT_TRUE(fxl_lit_outline(&workspace, &workspace.pieces[i], outline));
        for (uint32_t k = 0, n = workspace.pieces[i].count; k < n; k++) {
            add_edge(&outline[k], &outline[(k + 1) % n]);
        }
        solid++;
    }
    return solid;
}

/* How far a point lies from the segment, squared, in units of 1/65536, in double. */
static double square_from(const fxl_point *p, const fxl_point *a, const fxl_point *b)
{
    double d[3] = {(double)b->x - a->x, (double)b->y - a->y, (double)b->z - a->z};
    double w[3] = {(double)p->x - a->x, (double)p->y - a->y, (double)p->z - a->z};
    double t =
        (w[0] * d[0] + w[1] * d[1] + w[2] * d[2]) / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += (w[i] - t * d[i]) * (w[i] - t * d[i]);
    }
    return sum;
}

/* What is left must run along the outline about everything. */
static void expect_outline(const fxl_point *outline, uint32_t count)
{
    for (uint32_t i = 0; i < edge_count; i++) {
        bool found = false;
        for (uint32_t k = 0; k < count; k++) {
            const fxl_point *a = &outline[k], *b = &outline[(k + 1) % count];
            found |= square_from(&edges[i].from, a, b) <= 9 && square_from(&edges[i].to, a, b) <= 9;
        }
        TEST_ASSERT_TRUE_MESSAGE(found, "an edge inside has no other that goes back along it");
    }
}

static fxl_beam shaft(const fxl_point *window, uint32_t count)
{
    const fxl_direction down = {0, 0, -FXL_Q2_30_ONE};
    fxl_beam beam;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_direction(&down, window, count, &beam));
    return beam;
}

static fxl_point at(int x, int y)
{
    return (fxl_point){x * 65536, y * 65536, 0};
}

static uint32_t lit_count(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < workspace.piece_count; i++) {
        count += workspace.pieces[i].is_lit;
    }
    return count;
}

/* Windows before the face: about the middle, and right of it. */
static const fxl_point middle[] = {{Q16(-1), Q16(-1), Q16(3)},
                                   {Q16(1), Q16(-1), Q16(3)},
                                   {Q16(1), Q16(1), Q16(3)},
                                   {Q16(-1), Q16(1), Q16(3)}};
static const fxl_point right[] = {{Q16(0), Q16(-1), Q16(3)},
                                  {Q16(2), Q16(-1), Q16(3)},
                                  {Q16(2), Q16(1), Q16(3)},
                                  {Q16(0), Q16(1), Q16(3)}};

/* beams 1.2b, 2.3b, 3.2a-c */
void test_a_pool_of_light_in_the_middle(void)
{
    const fxl_point face[] = {at(-4, -4), at(-4, 4), at(4, 4), at(4, -4)};
    const fxl_beam beam = shaft(middle, 4);
    edge_count = 0;
    TEST_ASSERT_EQUAL(5, add_face(&beam, 1, face, 4));
    TEST_ASSERT_EQUAL(1, lit_count());
    expect_outline(face, 4);
}

/* beams 2.3c */
void test_a_face_that_no_plane_cuts_stays_whole(void)
{
    const fxl_point window[] = {
        {Q16(-9), Q16(-9), Q16(3)}, {Q16(9), Q16(-9), Q16(3)}, {Q16(0), Q16(9), Q16(3)}};
    const fxl_point inside[] = {at(-1, -1), at(-1, 1), at(1, 1), at(1, -1)};
    const fxl_point outside[] = {at(-20, 20), at(-20, 24), at(-16, 24), at(-16, 20)};
    const fxl_beam beam = shaft(window, 3);
    edge_count = 0;
    TEST_ASSERT_EQUAL(1, add_face(&beam, 1, inside, 4));
    TEST_ASSERT_EQUAL(1, lit_count());
    TEST_ASSERT_EQUAL(1, add_face(&beam, 1, outside, 4));
    TEST_ASSERT_EQUAL(0, lit_count());
}

/* The neighbours' common edge lies in a plane of the beam: the one that is behind must get
 * the points where the other planes cut the other. */
/* beams 3.1a, 3.5a */
void test_an_edge_in_a_plane_is_shared(void)
{
    const fxl_point behind[] = {at(-4, -4), at(-4, 4), at(0, 4), at(0, -4)};
    const fxl_point before[] = {at(0, -4), at(0, 4), at(4, 4), at(4, -4)};
    const fxl_point around[] = {at(-4, -4), at(-4, 4), at(4, 4), at(4, -4)};
    for (uint32_t turn = 0; turn < 4; turn++) {
        fxl_point turned[4];
        for (uint32_t i = 0; i < 4; i++) {
            turned[i] = right[(i + turn) % 4];
        }
        const fxl_beam beam = shaft(turned, 4);
        edge_count = 0;
        add_face(&beam, 1, behind, 4);
        TEST_ASSERT_EQUAL(0, lit_count());
        add_face(&beam, 1, before, 4);
        TEST_ASSERT_EQUAL(1, lit_count());
        expect_outline(around, 4);
    }
}

/* A face that reaches 4/65536 into a beam touches it; one that reaches farther has a lit piece. */
/* beams 3.1a */
void test_a_corner_near_a_plane_lies_on_it(void)
{
    const fxl_beam beam = shaft(right, 4);
    for (int32_t off = 1; off <= 6; off++) {
        const fxl_point behind[] = {
            at(-4, -4), at(-4, 4), {off, at(0, 4).y, at(0, 4).z}, {off, at(0, -4).y, at(0, -4).z}};
        add_face(&beam, 1, behind, 4);
        TEST_ASSERT_EQUAL(off > 4, lit_count());
    }
}

/* Faces that share an edge, in two planes or one, split by one beam or two. Coordinates are
 * mostly whole, so that corners and edges often lie in the planes. */
static void any_faces(uint32_t beam_count, int grid)
{
    int split = 0;
    for (int i = 0; i < UNIT_REPEAT / 8; i++) {
        fxl_beam beams[2];
        fxl_point shared[2], ends[2];
        bool made = true;
        for (uint32_t b = 0; b < beam_count; b++) {
            fxl_point window[3], light;
            for (int k = 0; k < 3; k++) {
                window[k] =
                    (fxl_point){unit_between(-4, 4) * grid, unit_between(-4, 4) * grid, 3 * grid};
            }
            light = (fxl_point){unit_between(-6, 6) * grid, unit_between(-6, 6) * grid, 8 * grid};
            made &= fxl_beam_from_point(&light, window, 3, &beams[b]) == FXL_OK;
        }
        for (int k = 0; k < 2; k++) {
            shared[k] = (fxl_point){unit_between(-6, 6) * grid, unit_between(-6, 6) * grid,
                                    unit_between(-3, 0) * grid};
            ends[k] = (fxl_point){unit_between(-6, 6) * grid, unit_between(-6, 6) * grid,
                                  unit_between(-3, 0) * grid};
        }
        if (!made || same(&shared[0], &shared[1])) {
            continue;
        }
        const fxl_point one[] = {shared[0], shared[1], ends[0]};
        const fxl_point other[] = {shared[1], shared[0], ends[1]};
        const fxl_point around[] = {shared[1], ends[0], shared[0], ends[1]};
        if (same(&ends[0], &shared[0]) || same(&ends[0], &shared[1]) ||
            same(&ends[1], &shared[0]) || same(&ends[1], &shared[1])) {
            continue;
        }
        edge_count = 0;
        uint32_t parts = add_face(beams, beam_count, one, 3);
        parts += add_face(beams, beam_count, other, 3);
        expect_outline(around, 4);
        split += parts > 2;
    }
    TEST_ASSERT_TRUE(split > UNIT_REPEAT / 100);
}

/* beams 3.4, 3.2d, 3.3b-c, 3.5a, 3.6b, clippers 9.3a */
void test_neighbours_fit_on_a_coarse_grid(void)
{
    any_faces(1, 65536);
    any_faces(2, 65536);
}

/* beams 3.1, 3.4, 3.5, 2.3b, 3.3c, 3.6b, clippers 9.3a */
void test_neighbours_fit_anywhere(void)
{
    any_faces(1, 46341);
    any_faces(2, 31 * 65536 + 12345);
}

/* A plane cuts a piece through two points, and each may be a corner of three pieces: six corners a
 * cut at most, beside those of the face and 16 for edges that lie in a plane. */
void test_room_is_not_wasted(void)
{
    for (uint8_t planes = 1; planes <= FXL_BEAM_PLANES_MAX; planes++) {
        const fxl_beam beams[2] = {{.plane_count = planes}, {.plane_count = 1}};
        const uint32_t face = FXL_FACE_VERTICES_MAX - planes; /* the most vertices that fit */
        TEST_ASSERT_EQUAL_UINT32(planes + 1, fxl_lit_pieces_needed(beams, 1));
        TEST_ASSERT_TRUE(fxl_lit_corners_needed(beams, 1) <= face + 16 + 6 * planes);
        TEST_ASSERT_TRUE(fxl_lit_corners_needed(beams, 1) >= face + 4 * planes);
        /* Another plane may cut each of the pieces, and adds a vertex to either part. */
        TEST_ASSERT_EQUAL_UINT32(2 * (planes + 1), fxl_lit_pieces_needed(beams, 2));
        TEST_ASSERT_TRUE(fxl_lit_corners_needed(beams, 2) <=
                         face - 2 + 16 + 6 * (2 * (planes + 1u) - 1));
    }
}

/* beams 4.4 */
void test_too_little_room_is_said(void)
{
    const fxl_point face[] = {at(-4, -4), at(-4, 4), at(4, 4), at(4, -4)};
    const fxl_direction normal = {0, 0, FXL_Q2_30_ONE};
    const fxl_beam beam = shaft(middle, 4);
    bool done = false, before;
    uint32_t needed = fxl_lit_corners_needed(&beam, 1);
    for (uint32_t size = 0; size <= needed; size++) {
        fxl_lit_pieces small = {corners, nexts, table, size, PIECES, 0, 0};
        memset(corners, 0x5A, sizeof corners);
        before = done;
        done = fxl_lit_split(&small, &beam, 1, &normal, face, 4);
        TEST_ASSERT_TRUE(done || !before); /* more room is never too little */
        TEST_ASSERT_TRUE(!done || small.piece_count == 5);
        TEST_ASSERT_TRUE(!done || size >= 5 * 4); /* each piece has four corners at least */
        TEST_ASSERT_EQUAL_HEX32(0x5A5A5A5A, (uint32_t)corners[size].x);
    }
    TEST_ASSERT_TRUE(done);
    for (uint32_t size = 0; size <= fxl_lit_pieces_needed(&beam, 1); size++) {
        fxl_lit_pieces small = {corners, nexts, table, CORNERS, size, 0, 0};
        memset(table, 0x5A, sizeof table);
        done = fxl_lit_split(&small, &beam, 1, &normal, face, 4);
        TEST_ASSERT_EQUAL(size >= 5, done);
        TEST_ASSERT_EQUAL_HEX16(0x5A5A, table[size].count);
    }
    TEST_ASSERT_TRUE(done);
}

/* As many corners and pieces as a face took are enough for it, and one less is not. */
static void expect_exact_room(const fxl_beam *beam, const fxl_point *face, uint32_t count)
{
    const fxl_direction normal = {0, 0, FXL_Q2_30_ONE};
    TEST_ASSERT_TRUE(fxl_lit_split(&workspace, beam, 1, &normal, face, count));
    const uint32_t used = workspace.corner_count, made = workspace.piece_count;
    for (uint32_t less = 0; less <= used; less++) {
        fxl_lit_pieces small = {corners, nexts, table, used - less, PIECES, 0, 0};
        TEST_ASSERT_EQUAL(less == 0, fxl_lit_split(&small, beam, 1, &normal, face, count));
    }
    for (uint32_t less = 0; less <= made; less++) {
        fxl_lit_pieces small = {corners, nexts, table, CORNERS, made - less, 0, 0};
        TEST_ASSERT_EQUAL(less == 0, fxl_lit_split(&small, beam, 1, &normal, face, count));
    }
}

void test_the_room_that_a_face_took_is_the_least(void)
{
    const fxl_point behind[] = {at(-4, -4), at(-4, 4), at(0, 4),
                                at(0, -4)}; /* an edge in a plane */
    const fxl_point around[] = {at(-4, -4), at(-4, 4), at(4, 4), at(4, -4)};
    const fxl_point across[] = {at(-3, 0), at(1, 3), at(3, -3)};
    for (uint32_t turn = 0; turn < 4; turn++) {
        fxl_point turned[4];
        for (uint32_t i = 0; i < 4; i++) {
            turned[i] = right[(i + turn) % 4];
        }
        const fxl_beam beam = shaft(turned, 4);
        expect_exact_room(&beam, behind, 4);
        expect_exact_room(&beam, around, 4);
        expect_exact_room(&beam, across, 3);
    }
}

/* Rounding leaves outlines with corners in a row on a plane, here on x = 0: they go to the part
 * that they lie beside, and between two parts one of them goes to both. An outline is then convex
 * only to within two units of 1/65536. */
/* beams 3.3b */
void test_corners_in_a_row_on_a_plane(void)
{
    enum {
        FAR = 3 * 65536,
        ONE = 65536
    };
    static const int32_t faces[][7][2] = {
        {{-FAR, -FAR}, {0, FAR}, {0, FAR - 2}, {FAR, -FAR}}, /* to the front */
        {{-FAR, FAR}, {FAR, FAR}, {0, -FAR + 2}, {0, -FAR}}, /* to behind */
        {{-FAR, 0}, {0, FAR}, {0, FAR - 1}, {0, FAR - 2}, {FAR, 0}, {0, -FAR + 2}, {0, -FAR}},
        {{-FAR, -FAR}, {-FAR, FAR}, {5, FAR}, {3, ONE}, {3, 0}, {5, -ONE}}, /* beside the front */
        {{FAR, FAR}, {FAR, -FAR}, {-5, -FAR}, {-3, -ONE}, {-3, 0}, {-5, ONE}}}; /* beside what is
                                                                                   behind */
    static const uint32_t counts[] = {4, 4, 7, 6, 6};
    for (uint32_t turn = 0; turn < 4; turn++) {
        fxl_point turned[4];
        for (uint32_t i = 0; i < 4; i++) {
            turned[i] = right[(i + turn) % 4];
        }
        const fxl_beam beam = shaft(turned, 4);
        for (uint32_t i = 0; i < sizeof faces / sizeof faces[0]; i++) {
            fxl_point face[7];
            for (uint32_t k = 0; k < counts[i]; k++) {
                face[k] = (fxl_point){faces[i][k][0], faces[i][k][1], 0};
            }
            edge_count = 0;
            TEST_ASSERT_GREATER_THAN_UINT32(0, add_face(&beam, 1, face, counts[i]));
            expect_outline(face, counts[i]);
            expect_exact_room(&beam, face, counts[i]);
        }
    }
}

/* An outline has room for as many corners as a polygon may have, and one more is refused. */
void test_an_outline_of_too_many_corners_is_refused(void)
{
    fxl_point outline[FXL_POLYGON_CAPACITY + 1];
    for (uint16_t count = 3; count <= FXL_POLYGON_CAPACITY + 1; count++) {
        const fxl_lit_piece piece = {.last = (uint16_t)(count - 1), .count = count};
        for (uint16_t i = 0; i < count; i++) {
            corners[i] = at(i, -i);
            nexts[i] = (uint16_t)(i + 1 < count ? i + 1 : 0);
        }
        memset(outline, 0x5A, sizeof outline);
        const bool fits = count <= FXL_POLYGON_CAPACITY;
        TEST_ASSERT_EQUAL(fits, fxl_lit_outline(&workspace, &piece, outline));
        for (uint16_t i = 0; i < FXL_POLYGON_CAPACITY + 1; i++) {
            TEST_ASSERT_EQUAL_HEX32(fits && i < count ? corners[i].x : 0x5A5A5A5A, outline[i].x);
        }
    }
}
