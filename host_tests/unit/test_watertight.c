/* SPDX-License-Identifier: MIT */
/* Two polygons that share an edge leave no gap and draw no pixel twice: on the
 * screen at any 16.16 position, and through the whole pipeline where the
 * frustum cuts the shared edge. */
#include <math.h>
#include <string.h>

#include "picture.h"
#include "polygon_face.h"

enum {
    WIDTH = 24,
    HEIGHT = 20,
    PIECES = 24 /* of a triangle, by the clipper that gives triangles */
};

/* What a clipper gives for a polygon. */
typedef struct {
    int count;
    fxl_screen_polygon polygons[PIECES];
} pieces;

/* The outline around both: all edges but those that one walks one way and the
 * other the other. Its winding number says what the two must cover. */
typedef struct {
    fxl_screen_point from[6 * PIECES], to[6 * PIECES];
    int count, shared;
} outline;

static bool same_point(fxl_screen_point a, fxl_screen_point b)
{
    return a.x == b.x && a.y == b.y;
}

static void outline_add(outline *around, const fxl_screen_polygon *polygon)
{
    for (int i = 0; i < polygon->count; i++) {
        fxl_screen_point from = polygon->points[i];
        fxl_screen_point to = polygon->points[(i + 1) % polygon->count];
        int other = 0;
        while (other < around->count &&
               !(same_point(around->from[other], to) && same_point(around->to[other], from))) {
            other++;
        }
        if (other < around->count) {
            around->count--;
            around->from[other] = around->from[around->count];
            around->to[other] = around->to[around->count];
            around->shared++;
        } else {
            around->from[around->count] = from;
            around->to[around->count] = to;
            around->count++;
        }
    }
}

/* As picture_winding, but of edges in any order. */
static int outline_winding(const outline *around, int column, int row)
{
    int64_t cx = (int64_t)column * 65536 + 32768, cy = (int64_t)row * 65536 + 32768;
    int winding = 0;
    for (int i = 0; i < around->count; i++) {
        fxl_screen_point a = around->from[i], b = around->to[i];
        if ((a.y <= cy) == (b.y <= cy)) {
            continue;
        }
        int64_t height = (int64_t)b.y - a.y;
        int64_t side = (cy - a.y) * ((int64_t)b.x - a.x) - (cx - a.x) * height;
        if (height > 0 ? side <= 0 : side >= 0) {
            winding += height > 0 ? 1 : -1;
        }
    }
    return winding;
}

/* The canvas fails by itself where a pixel is drawn twice. */
static void expect_pieces_watertight(const pieces *first, const pieces *second)
{
    static picture canvas;
    static outline around;
    around.count = 0;
    around.shared = 0;
    picture_clear(&canvas, WIDTH, HEIGHT);
    for (int i = 0; i < first->count + second->count; i++) {
        bool of_first = i < first->count;
        const fxl_screen_polygon *polygon =
            of_first ? &first->polygons[i] : &second->polygons[i - first->count];
        outline_add(&around, polygon);
        picture_add(&canvas, polygon, of_first ? 'a' : 'b');
    }
    TEST_ASSERT_TRUE_MESSAGE(around.shared >= 1, "the shared edge is not the same for both");
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            bool inside = outline_winding(&around, x, y) != 0;
            if (inside != (canvas.pixels[y][x] != '.')) {
                TEST_FAIL_MESSAGE(inside ? "a gap" : "a pixel outside both");
            }
        }
    }
}

static void expect_watertight(const fxl_screen_polygon *first, const fxl_screen_polygon *second)
{
    static pieces of[2];
    of[0].count = of[1].count = 1;
    of[0].polygons[0] = *first;
    of[1].polygons[0] = *second;
    expect_pieces_watertight(&of[0], &of[1]);
}

/* Twice the signed area, in units of 2^-32; positive clockwise on the screen.
 * Coordinates below 2^28: the sum stays below 2^62. */
static int64_t area_of(const fxl_screen_polygon *polygon)
{
    int64_t area = 0;
    for (int i = 0; i < polygon->count; i++) {
        fxl_screen_point a = polygon->points[i], b = polygon->points[(i + 1) % polygon->count];
        area += (int64_t)a.x * b.y - (int64_t)b.x * a.y;
    }
    return area;
}

/* Anywhere, on a centre, on a half pixel, on a quarter. */
static fxl_screen_point random_point(void)
{
    static const int32_t grids[] = {1, 1, 1, 65536, 32768, 16384};
    int32_t grid = grids[unit_random() % 6];
    int32_t offset = grid == 65536 ? 32768 : 0;
    return (fxl_screen_point){
        unit_between(-4 * 65536 / grid, (WIDTH + 4) * 65536 / grid) * grid + offset,
        unit_between(-4 * 65536 / grid, (HEIGHT + 4) * 65536 / grid) * grid + offset};
}

static fxl_screen_polygon triangle(fxl_screen_point a, fxl_screen_point b, fxl_screen_point c)
{
    return (fxl_screen_polygon){.colour = 1, .count = 3, .points = {a, b, c}};
}

void test_two_triangles(void)
{
    int judged = 0;
    while (judged < UNIT_REPEAT) {
        fxl_screen_point a = random_point(), b = random_point();
        fxl_screen_polygon first = triangle(a, b, random_point());
        fxl_screen_polygon second = triangle(b, a, random_point());
        int64_t areas[2] = {area_of(&first), area_of(&second)};
        if ((areas[0] <= 0 || areas[1] <= 0) && (areas[0] >= 0 || areas[1] >= 0)) {
            continue; /* the same side of the edge, or no area at all */
        }
        expect_watertight(&first, &second);
        judged++;
    }
}

/* A convex polygon, rounded to 16.16 and so perhaps slightly concave, cut from
 * corner to corner. */
void test_a_polygon_cut_by_a_chord(void)
{
    for (int round = 0; round < UNIT_REPEAT; round++) {
        fxl_screen_polygon first = {.colour = 1}, second = {.colour = 2};
        int count = unit_between(4, FXL_POLYGON_CAPACITY < 16 ? FXL_POLYGON_CAPACITY : 16);
        int chord = unit_between(2, count - 2);
        double x = unit_between(0, WIDTH * 1000) / 1000.0;
        double y = unit_between(0, HEIGHT * 1000) / 1000.0;
        double wide = unit_between(1, 12000) / 1000.0, high = unit_between(1, 12000) / 1000.0;
        double turn = unit_between(0, 6283) / 1000.0;
        for (int i = 0; i < count; i++) {
            double angle = turn + i * 6.283185307179586 / count;
            fxl_screen_point corner = {(fxl_q16_16)floor((x + wide * cos(angle)) * 65536.0 + 0.5),
                                       (fxl_q16_16)floor((y + high * sin(angle)) * 65536.0 + 0.5)};
            if (i <= chord) {
                first.points[first.count++] = corner;
            }
            if (i == 0 || i >= chord) {
                second.points[second.count++] = corner;
            }
        }
        expect_watertight(&first, &second);
    }
}

/* From world to screen, as the frame loop does it. */
static bool to_screen(const fxl_clipper *clipper, const fxl_polygon *polygon, fxl_view *view,
                      pieces *screen, bool *cut)
{
    static fxl_clipper_work work;
    static polygon_face face;
    polygon_face_set(&face, polygon, view, FXL_POLYGON_CAPACITY);
    screen->count = 0;
    fxl_clip_result result =
        clipper->clip(&face.placed, &face.face, &work, &screen->polygons[screen->count]);
    *cut = result == FXL_CLIP_CUT;
    while (result == FXL_CLIP_CUT || result == FXL_CLIP_INSIDE || result == FXL_CLIP_BETWEEN) {
        screen->count++;
        TEST_ASSERT_TRUE(screen->count < PIECES);
        result = clipper->next != NULL
                     ? clipper->next(&face.placed, &work, &screen->polygons[screen->count])
                     : FXL_CLIP_OUTSIDE;
    }
    return screen->count > 0;
}

static void random_view(fxl_view *view)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(100));
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    fxl_view_set_lens(view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(view, &pose));
}

static fxl_q16_16 mix(fxl_q2_30 right, fxl_q2_30 up, fxl_q2_30 forward, const double view[3])
{
    double sum = right * view[0] + up * view[1] + forward * view[2];
    return (fxl_q16_16)floor(sum / 16384.0 + 0.5);
}

/* A vertex from coordinates of the view, each below about 200 units. */
static fxl_vertex vertex_at(const fxl_camera *camera, double x, double y, double z)
{
    const double at[3] = {x, y, z};
    const fxl_direction *r = &camera->right, *u = &camera->up, *f = &camera->forward;
    fxl_point p = {camera->position.x + mix(r->x, u->x, f->x, at),
                   camera->position.y + mix(r->y, u->y, f->y, at),
                   camera->position.z + mix(r->z, u->z, f->z, at)};
    return (fxl_vertex){p, unit_between(0, Q16(64)), unit_between(0, Q16(64))};
}

/* Four points around a middle in the view, in the order of a convex quad that
 * leans at most about 45 degrees; its corners may be off any side, also
 * behind the eye. */
static void random_quad(const fxl_camera *camera, fxl_vertex corners[4])
{
    double depth = unit_between(100, 20000) / 1000.0;
    double radius = unit_between(500, 20000) / 1000.0;
    double x = unit_between(-1500, 1500) / 1000.0 * depth;
    double y = unit_between(-1500, 1500) / 1000.0 * depth;
    double lean_x = unit_between(-1000, 1000) / 1000.0, lean_y = unit_between(-1000, 1000) / 1000.0;
    double turn = unit_between(0, 6283) / 1000.0;
    for (int i = 0; i < 4; i++) {
        double angle = turn + i * 1.5707963 + unit_between(-500, 500) / 1000.0;
        double dx = radius * cos(angle), dy = radius * sin(angle);
        corners[i] = vertex_at(camera, x + dx, y + dy, depth + lean_x * dx + lean_y * dy);
    }
}

static fxl_polygon world_triangle(fxl_vertex a, fxl_vertex b, fxl_vertex c)
{
    return (fxl_polygon){.colour = 1, .count = 3, .vertices = {a, b, c}};
}

/* Below this area in square pixels the rounding to 16.16 could turn a polygon
 * over, and then it is another polygon. */
static bool has_area(const pieces *of)
{
    int64_t area = 0;
    for (int i = 0; i < of->count; i++) {
        area += area_of(&of->polygons[i]);
    }
    return area > (int64_t)1 << 26 || area < -((int64_t)1 << 26);
}

static bool edge_is_seen(fxl_view *view, const fxl_vertex *a, const fxl_vertex *b, bool *cut)
{
    double enter = 0, leave = 1;
    const fxl_plane *planes = fxl_view_world_frustum(view)->planes;
    for (int i = 0; i < FXL_PLANE_COUNT; i++) {
        double from = (double)fxl_plane_distance(&planes[i], &a->position);
        double to = (double)fxl_plane_distance(&planes[i], &b->position);
        if (from < 0 && to < 0) {
            return false;
        }
        if (from < 0) {
            enter = fmax(enter, from / (from - to));
        } else if (to < 0) {
            leave = fmin(leave, from / (from - to));
        }
    }
    *cut = enter > 0 || leave < 1;
    return leave - enter > 0.01;
}

/* few: how many of the pairs must be cut, both. */
static void expect_watertight_through(const fxl_clipper *clipper, int few)
{
    int judged = 0, edges_cut = 0, both_cut = 0;
    static fxl_view view;
    static fxl_clipper_room room;
    static pieces screens[2];
    fxl_vertex corners[4];
    memset(&room, 0, sizeof room);
    while (judged < UNIT_REPEAT) {
        if (judged % 16 == 0) {
            uint32_t frame = view.frame;
            random_view(&view);
            view.frame += frame;
            view.room = &room;
        }
        random_quad(&view.camera, corners);
        fxl_polygon first = world_triangle(corners[0], corners[1], corners[2]);
        fxl_polygon second = world_triangle(corners[2], corners[3], corners[0]);
        bool cuts[2], edge_cut;
        if (!edge_is_seen(&view, &corners[0], &corners[2], &edge_cut) ||
            !to_screen(clipper, &first, &view, &screens[0], &cuts[0]) ||
            !to_screen(clipper, &second, &view, &screens[1], &cuts[1]) || !has_area(&screens[0]) ||
            !has_area(&screens[1])) {
            continue;
        }
        if ((area_of(&screens[0].polygons[0]) > 0) != (area_of(&screens[1].polygons[0]) > 0)) {
            continue; /* the quad was folded about its chord */
        }
        expect_pieces_watertight(&screens[0], &screens[1]);
        judged++;
        edges_cut += edge_cut;
        both_cut += cuts[0] && cuts[1];
    }
    TEST_ASSERT_TRUE_MESSAGE(edges_cut > UNIT_REPEAT / 4, "too few shared edges were cut");
    TEST_ASSERT_TRUE_MESSAGE(both_cut > few, "too few pairs were cut");
}

void test_through_the_frustum_of_the_view(void)
{
    expect_watertight_through(&fxl_clipper_view, UNIT_REPEAT / 4);
}

void test_through_the_frustum_of_the_world(void)
{
    expect_watertight_through(&fxl_clipper_world, UNIT_REPEAT / 4);
}

void test_through_the_normalised_frustum(void)
{
    expect_watertight_through(&fxl_clipper_normalised, UNIT_REPEAT / 4);
}

void test_through_all_planes_at_once(void)
{
    expect_watertight_through(&fxl_clipper_once, UNIT_REPEAT / 4);
}

void test_through_half_spaces(void)
{
    expect_watertight_through(&fxl_clipper_half_spaces, UNIT_REPEAT / 4);
}

void test_in_triangles(void)
{
    expect_watertight_through(&fxl_clipper_triangles, UNIT_REPEAT / 4);
}

void test_before_the_scan_cuts_what_near_leaves(void)
{
    expect_watertight_through(&fxl_clipper_near, UNIT_REPEAT / 20);
}

void test_before_the_scan_cuts_what_left_leaves(void)
{
    expect_watertight_through(&fxl_clipper_left, UNIT_REPEAT / 4);
}
