/* SPDX-License-Identifier: MIT */
#include "watertight.h"

#include <math.h>

#include "picture.h"
#include "polygon_face.h"
#include "view/placement.h"

/* place fill-rule: definition: outline_winding */
/* The outline around both: all edges but those that one walks one way and the
 * other the other. Its winding number says what the two must cover. */
typedef struct {
    fxl_screen_point from[6 * WATERTIGHT_PIECES], to[6 * WATERTIGHT_PIECES];
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
void watertight_expect(const fxl_screen_polygon *polygons, int first, int count)
{
    static picture canvas;
    static outline around;
    around.count = 0;
    around.shared = 0;
    picture_clear(&canvas, WATERTIGHT_WIDTH, WATERTIGHT_HEIGHT);
    for (int i = 0; i < count; i++) {
        outline_add(&around, &polygons[i]);
        picture_add(&canvas, &polygons[i], i < first ? 'a' : 'b');
    }
    TEST_ASSERT_TRUE_MESSAGE(around.shared >= 1, "the shared edge is not the same for both");
    for (int y = 0; y < WATERTIGHT_HEIGHT; y++) {
        for (int x = 0; x < WATERTIGHT_WIDTH; x++) {
            bool inside = outline_winding(&around, x, y) != 0;
            if (inside != (canvas.pixels[y][x] != '.')) {
                TEST_FAIL_MESSAGE(inside ? "a gap" : "a pixel outside both");
            }
        }
    }
}

/* Twice the signed area, in units of 2^-32; positive clockwise on the screen.
 * Coordinates below 2^28: the sum stays below 2^62. */
int64_t watertight_area(const fxl_screen_polygon *polygon)
{
    int64_t area = 0;
    for (int i = 0; i < polygon->count; i++) {
        fxl_screen_point a = polygon->points[i], b = polygon->points[(i + 1) % polygon->count];
        area += (int64_t)a.x * b.y - (int64_t)b.x * a.y;
    }
    return area;
}

/* The placement of the instance that the polygons belong to, about its centre; null: none. */
static fxl_placement *the_placement;
static fxl_point turned_centre;

/* The vertex of the turned instance that lies at a point of the world, as near as can be. */
static fxl_point in_the_model(const fxl_point *point)
{
    const fxl_direction *x = &the_placement->orientation.x, *y = &the_placement->orientation.y,
                        *z = &the_placement->orientation.z;
    const double at[3] = {point->x - turned_centre.x, point->y - turned_centre.y,
                          point->z - turned_centre.z};
    const double unit = (double)FXL_Q2_30_ONE * the_placement->scale / 65536.0;
    return (fxl_point){
        (fxl_q16_16)floor((x->x * at[0] + y->x * at[1] + z->x * at[2]) / unit + 0.5),
        (fxl_q16_16)floor((x->y * at[0] + y->y * at[1] + z->y * at[2]) / unit + 0.5),
        (fxl_q16_16)floor((x->z * at[0] + y->z * at[1] + z->z * at[2]) / unit + 0.5)};
}

/* The face as one of a turned instance. */
static const fxl_model_view *turned_view_of(polygon_face *face, const fxl_view *view)
{
    static fxl_turned_view turned;
    const fxl_model model = {.vertex_count = face->face.count,
                             .face_count = 1,
                             .radius = Q16(1) /* its vertices' limits are the test's own */};
    const fxl_instance instance = {turned_centre, 0, 0, 0};
    const fxl_scene scene = {.vertices = face->vertices,
                             .indices = face->corners,
                             .models = &model,
                             .instances = &instance,
                             .placements = the_placement};
    for (uint32_t i = 0; i < face->face.count; i++) {
        face->vertices[i] = in_the_model(&face->vertices[i]);
    }
    fxl_turned_view_of_instance(&turned, &scene, 0, view, &face->cache, FXL_PLANES_ALL);
    return &turned.model_view;
}

/* From world to screen, as the frame loop does it. */
static int to_screen(const fxl_clipper *clipper, fxl_clipper_workspace *workspace,
                     const fxl_polygon *polygon, fxl_view *view, fxl_screen_polygon *screens,
                     int workspace_for, bool *cut)
{
    static fxl_clipper_work work;
    static polygon_face face;
    const fxl_model_view *model_view = &face.model_view;
    int count = 0;
    polygon_face_set(&face, polygon, view, FXL_POLYGON_CAPACITY);
    face.model_view.clipper_workspace = workspace;
    if (the_placement != NULL) {
        model_view = turned_view_of(&face, view);
    }
    fxl_clip_result result = clipper->clip(model_view, &face.face, &work, &screens[0]);
    *cut = result == FXL_CLIP_CUT;
    while (result == FXL_CLIP_CUT || result == FXL_CLIP_INSIDE || result == FXL_CLIP_BETWEEN) {
        count++;
        if (clipper->next == NULL) {
            break;
        }
        TEST_ASSERT_TRUE(count < workspace_for);
        result = clipper->next(model_view, &work, &screens[count]);
    }
    return count;
}

static void random_view(fxl_view *view)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(100));
    fxl_lens lens = unit_lens(WATERTIGHT_WIDTH, WATERTIGHT_HEIGHT);
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
    const fxl_direction *r = &camera->axes.right, *u = &camera->axes.up, *f = &camera->axes.forward;
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
static bool has_area(const fxl_screen_polygon *polygons, int count)
{
    int64_t area = 0;
    for (int i = 0; i < count; i++) {
        area += watertight_area(&polygons[i]);
    }
    return area > (int64_t)1 << 26 || area < -((int64_t)1 << 26);
}

static bool edge_is_seen(fxl_view *view, const fxl_vertex *a, const fxl_vertex *b, bool *cut)
{
    double enter = 0, leave = 1;
    fxl_view_set_world_frustum(view);
    const fxl_plane *planes = view->frustum.planes;
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

/* A placement for which the vertices of a random quad are in range: it lies within 200 units of the
 * eye, so scale * radius is below 500, and the eye is near enough. */
static void random_placement(fxl_placement *random, const fxl_camera *camera)
{
    *random = unit_placement();
    if (random->scale < Q16(0.25)) {
        random->scale = Q16(0.25);
    }
    turned_centre = camera->position;
    turned_centre.x += unit_between(-Q16(20), Q16(20));
    turned_centre.y += unit_between(-Q16(20), Q16(20));
    turned_centre.z += unit_between(-Q16(20), Q16(20));
}

void watertight_expect_through(const fxl_clipper *clipper, fxl_clipper_workspace *workspace,
                               int few, fxl_screen_polygon *screens, int workspace_for)
{
    int judged = 0, edges_cut = 0, both_cut = 0;
    static fxl_view view;
    fxl_vertex corners[4];
    while (judged < UNIT_REPEAT) {
        if (judged % 16 == 0) {
            uint32_t frame = view.frame;
            random_view(&view);
            view.frame += frame;
        }
        if (the_placement != NULL && judged % 4 == 0) {
            random_placement(the_placement, &view.camera);
        }
        random_quad(&view.camera, corners);
        fxl_polygon first = world_triangle(corners[0], corners[1], corners[2]);
        fxl_polygon second = world_triangle(corners[2], corners[3], corners[0]);
        bool cuts[2], edge_cut;
        if (!edge_is_seen(&view, &corners[0], &corners[2], &edge_cut)) {
            continue;
        }
        int ones = to_screen(clipper, workspace, &first, &view, screens, workspace_for, &cuts[0]);
        fxl_screen_polygon *others = screens + ones;
        int count =
            to_screen(clipper, workspace, &second, &view, others, workspace_for - ones, &cuts[1]);
        if (!has_area(screens, ones) || !has_area(others, count) ||
            (watertight_area(screens) > 0) != (watertight_area(others) > 0)) {
            continue; /* the last: the quad was folded about its chord */
        }
        watertight_expect(screens, ones, ones + count);
        judged++;
        edges_cut += edge_cut;
        both_cut += cuts[0] && cuts[1];
    }
    TEST_ASSERT_TRUE_MESSAGE(edges_cut > UNIT_REPEAT / 4, "too few shared edges were cut");
    TEST_ASSERT_TRUE_MESSAGE(both_cut > few, "too few pairs were cut");
}

void watertight_expect_turned(const fxl_clipper *clipper, int few, fxl_screen_polygon *screens,
                              int workspace_for)
{
    static fxl_placement random;
    the_placement = &random;
    watertight_expect_through(clipper, NULL, few, screens, workspace_for);
    the_placement = NULL;
}
