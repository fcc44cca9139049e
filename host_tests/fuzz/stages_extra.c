/* SPDX-License-Identifier: MIT */
/* The other clippers and splitters, which work on records of their own, and the sort of faces. */
#include <string.h>

#include "answers.h"
#include "parts.h"
#include "study/clip_once.h"
#include "study/clip_world.h"
#include "study/half_space.h"
#include "study/rectangle.h"
#include "../unit/split_piece.h"
#include "study/triangle.h"

enum {
    ENTRIES = 300,
    CORNERS = 9
};

static fxl_view_point any_place(fuzz_input *in)
{
    const fxl_point point = fuzz_point(in, FXL_COORDINATE_MAX);
    return (fxl_view_point){point.x * (int64_t)FXL_Q2_30_ONE, point.y * (int64_t)FXL_Q2_30_ONE,
                            point.z * (int64_t)FXL_Q2_30_ONE};
}

/* Distances of any order, many of them equal: the sort must be stable. */
void fuzz_sort(fuzz_input *in)
{
    static fxl_draw_entry entries[ENTRIES];
    static uint64_t distances[ENTRIES];
    static fxl_sort_work work;
    uint32_t count = fuzz_below(in, ENTRIES), kind = fuzz_below(in, 6);
    uint64_t mask = kind < 3 ? 0xFFu >> kind : UINT64_MAX >> fuzz_below(in, 64);
    uint64_t at = 0;
    for (uint32_t i = 0; i < count; i++) {
        uint64_t next = fuzz_bits(in, kind < 3 ? 1 : 8);
        at = kind == 4 ? at + (next & 0xFFFF) : kind == 5 ? at - (next & 0xFFFF) : next & mask;
        distances[i] = at >> 2;
        entries[i] = fxl_draw_entry_of(distances[i], (uint16_t)i, 0);
    }
    fxl_sort_faces(entries, count, &work);
    for (uint32_t i = 0; i < count; i++) {
        record_number(entries[i].face);
    }
    for (uint32_t i = 1; i < count; i++) {
        uint32_t before = entries[i - 1].face, after = entries[i].face;
        DEMAND(before < count && after < count);
        DEMAND(distances[before] > distances[after] ||
               (distances[before] == distances[after] && before < after));
    }
}

/* A window in a plane or of any corners, and what a beam through it says of itself. */
void fuzz_beams(fuzz_input *in)
{
    fxl_point window[CORNERS];
    fxl_beam beam, before;
    const fxl_direction travel = {0, -FXL_Q2_30_ONE, 0};
    fxl_pose pose = fuzz_pose(in);
    fxl_camera camera;
    DEMAND(fxl_camera_from_pose(&pose, &camera) == FXL_OK);
    uint32_t count = fuzz_below(in, CORNERS + 1), kind = fuzz_below(in, 8);
    fxl_point light = fuzz_point(in, FXL_COORDINATE_MAX);
    for (uint32_t i = 0; i < CORNERS; i++) { /* corners of a kite: convex more often than not */
        static const int8_t x[CORNERS] = {-3, 0, 3, 0, -2, -3, -3, -4, -4};
        static const int8_t z[CORNERS] = {0, 3, 0, -3, -2, -1, -1, 0, 0};
        window[i].x = kind == 0 ? fuzz_any(in) : x[i] * 65536;
        window[i].y = kind < 2 ? fuzz_coordinate(in, FXL_COORDINATE_MAX) : 0;
        window[i].z = z[i] * 65536;
    }
    light.x = kind == 7 ? INT32_MAX : light.x;
    memset(&beam, 0x5A, sizeof beam);
    before = beam;
    fxl_direction way = fuzz_below(in, 2) ? camera.axes.forward : travel;
    way.x += kind == 6 ? 1 << 20 : 0;
    fxl_status status = fuzz_below(in, 2) ? fxl_beam_from_point(&light, window, count, &beam)
                                          : fxl_beam_from_direction(&way, window, count, &beam);
    if (status != FXL_OK) {
        DEMAND(memcmp(&before, &beam, sizeof beam) == 0);
        DEMAND(fxl_beam_from_point(NULL, window, 4, &beam) == FXL_E_ARGUMENT);
        DEMAND(fxl_beam_from_direction(NULL, window, 4, &beam) == FXL_E_ARGUMENT);
        DEMAND(fxl_beam_from_direction(&travel, NULL, 4, &beam) == FXL_E_ARGUMENT);
        return;
    }
    DEMAND(fxl_beam_check(&beam) == FXL_OK && beam.plane_count == count + 1);
    record_bytes(&beam, sizeof beam);
    for (uint32_t i = 0; i < count; i++) { /* the window lies within the beam: to 2^-12 unit */
        for (uint32_t k = 0; k < beam.plane_count - 1u; k++) {
            const fxl_plane plane = fxl_beam_plane_at(&beam, k);
            DEMAND(fxl_plane_distance(&plane, &window[i]) >= -((int64_t)1 << 34));
        }
        DEMAND(kind < 2 || fxl_beam_reaches(&beam, &window[i], 65536)); /* flat */
    }
    uint8_t *const spoilt = (uint8_t *)&beam + fuzz_below(in, sizeof beam);
    *spoilt ^= (uint8_t)fuzz_bits(in, 1);
    record_number(fxl_beam_check(&beam));
    DEMAND(fxl_beam_light_workspace_size(&beam, 0) == 0);
}

/* The part in front is in front, the part behind is behind: to within a unit. */
void fuzz_split(fuzz_input *in)
{
    static split_piece piece, front, back;
    fxl_pose pose = fuzz_pose(in);
    fxl_camera camera;
    DEMAND(fxl_camera_from_pose(&pose, &camera) == FXL_OK);
    const fxl_plane plane = fxl_plane_from_point(&pose.position, &camera.axes.forward, 0);
    piece.count = 2 + fuzz_below(in, FXL_POLYGON_CAPACITY - 1);
    uint32_t near_plane = fuzz_below(in, 4);
    for (uint32_t i = 0; i < piece.count; i++) {
        piece.points[i] = fuzz_point(in, FXL_COORDINATE_MAX);
        if (near_plane == 0 && i % 2 == 0) {
            piece.points[i] = pose.position;
        }
    }
    const split_result parts = split_by(&piece, &plane, &front, &back);
    record_number(parts);
    if (parts == SPLIT_BOTH) {
        record_bytes(front.points, front.count * sizeof front.points[0]);
        record_bytes(back.points, back.count * sizeof back.points[0]);
        for (uint32_t i = 0; i < front.count; i++) {
            DEMAND(fxl_plane_distance(&plane, &front.points[i]) >= -((int64_t)2 << 30));
        }
        for (uint32_t i = 0; i < back.count; i++) {
            DEMAND(fxl_plane_distance(&plane, &back.points[i]) <= (int64_t)2 << 30);
        }
    }
}

static fxl_varying_polygon any_varying(fuzz_input *in)
{
    fxl_varying_polygon polygon;
    memset(&polygon, 0, sizeof polygon);
    polygon.count = (uint8_t)(3 + fuzz_below(in, FXL_POLYGON_CAPACITY - 2));
    polygon.carried = (uint8_t)fuzz_below(in, FXL_CARRIED_MAX + 1);
    for (uint32_t i = 0; i < polygon.count; i++) {
        polygon.vertices[i].position = any_place(in);
        for (uint32_t k = 0; k < polygon.carried; k++) {
            polygon.vertices[i].carried[k] = fuzz_coordinate(in, 16383 * 65536);
        }
    }
    return polygon;
}

static void demand_window(fuzz_input *in, fxl_volume *volume)
{
    fxl_q16_16 sides[6];
    for (int i = 0; i < 6; i++) {
        sides[i] = fuzz_any(in);
    }
    sides[4] = fuzz_below(in, 2) ? sides[4] : 65536;
    fxl_status status =
        fxl_volume_from_window(sides[0], sides[1], sides[2], sides[3], sides[4], sides[5], volume);
    DEMAND(status == FXL_OK || status == FXL_E_RANGE);
    for (int i = 0; status == FXL_OK && i < FXL_PLANE_COUNT; i++) {
        record_bytes(&volume->planes[i].normal, sizeof volume->planes[i].normal);
        record_number(volume->planes[i].offset);
    }
    DEMAND(fxl_volume_from_window(0, 1, 0, 1, 256, 512, NULL) == FXL_E_ARGUMENT);
}

static void volume_of(const fxl_lens *lens, uint32_t screen, fxl_volume *volume)
{
    fxl_view_frustum sides;
    fxl_view_frustum_from_lens(lens, &sides);
    fxl_volume_from_sides(&sides, lens->focal, screen, volume);
}

/* Polygons, lines and triangles in the volume of a lens, with slivers and without. */
void fuzz_volumes(fuzz_input *in)
{
    static fxl_clip_workspace work;
    static fxl_triangle_workspace triangles;
    const fxl_varying_polygon *result;
    fxl_volume volume;
    fxl_lens lens = fuzz_lens(in, FXL_SCREEN_MAX * FXL_SCREEN_MAX);
    demand_window(in, &volume);
    volume_of(&lens, fuzz_below(in, 2) ? FXL_PLANES_ALL : 3u, &volume);
    fxl_varying_polygon polygon = any_varying(in);
    memset(&work.stats, 0, sizeof work.stats);
    work.stats.sliver = fuzz_below(in, 2) ? 0 : (fxl_q18_46)fuzz_bits(in, 5);
    fxl_clip_result cut = fxl_clip_to_volume(&polygon, &volume, &work, &result);
    DEMAND((result == &polygon) == (cut == FXL_CLIP_INSIDE));
    record_number(cut);
    record_varying(result);
    bool inside = true;
    for (uint32_t i = 0; i < polygon.count; i++) {
        inside = inside && fxl_volume_code(&volume, &polygon.vertices[i].position) == 0;
    }
    DEMAND(inside == (cut == FXL_CLIP_INSIDE));
    const fxl_clip_triangle solid = {
        {polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]}};
    fxl_status status;
    volume_of(&lens, 3u, &volume);
    triangles.stats = work.stats;
    triangles.screen_sliver = fuzz_below(in, 2) ? 0 : (fxl_q16_16)fuzz_bits(in, 2);
    cut = fxl_triangle_begin(&solid, polygon.carried, &volume, &triangles);
    if (cut != FXL_CLIP_INSIDE && cut != FXL_CLIP_CUT) {
        return;
    }
    for (const fxl_screen_triangle *flat;
         (flat = fxl_triangle_next(&volume, &lens, &triangles, &status)) != NULL;) {
        for (int i = 0; i < 3; i++) {
            DEMAND(triangles.screen_sliver > 0 ||
                   (flat->corners[i].at.x >= 0 && flat->corners[i].at.x <= lens.width * 65536));
            record_bytes(&flat->corners[i].at, sizeof flat->corners[i].at);
            record_bytes(flat->corners[i].carried,
                         polygon.carried * sizeof flat->corners[i].carried[0]);
        }
    }
    DEMAND(status == FXL_OK);
}

/* Polygons in the normalised frustum: in one pass, and plane by plane. */
void fuzz_normalised(fuzz_input *in)
{
    static fxl_clip_once_workspace once;
    static fxl_clip_workspace work;
    const fxl_varying_polygon *by_once, *by_planes;
    fxl_normalised frustum;
    fxl_camera camera;
    fxl_pose pose = fuzz_pose(in);
    fxl_lens lens = fuzz_lens(in, FXL_SCREEN_MAX * FXL_SCREEN_MAX);
    DEMAND(fxl_camera_from_pose(&pose, &camera) == FXL_OK);
    fxl_normalised_from_camera(&camera, &lens, &frustum);
    fxl_varying_polygon polygon = any_varying(in);
    polygon.count = fuzz_below(in, 2) ? 3 : polygon.count; /* a triangle is flat and convex */
    memset(&once.stats, 0, sizeof once.stats);
    once.stats.sliver = fuzz_below(in, 4) ? 0 : (fxl_q18_46)fuzz_bits(in, 5);
    work.stats = once.stats;
    fxl_clip_result cut = fxl_clip_once(&polygon, &frustum, &once, &by_once);
    fxl_clip_result planes = fxl_clip_normalised(&polygon, &frustum, &work, &by_planes);
    DEMAND((cut == FXL_CLIP_INSIDE) == (planes == FXL_CLIP_INSIDE));
    record_number(cut);
    record_varying(by_once);
    record_number(planes);
    record_varying(by_planes);
    DEMAND(cut != FXL_CLIP_CUT || (by_once->count >= 3 && by_once->count <= FXL_POLYGON_CAPACITY));
    fxl_screen_point screen = {1, 2};
    fxl_status status = fxl_normalised_project(&frustum, &polygon.vertices[0].position, &screen);
    DEMAND(status == FXL_OK || (screen.x == 1 && screen.y == 2));
    record_bytes(&screen, sizeof screen);
}

/* A plane through three points, a line that meets it, and polygons by the sides alone and by a
 * rectangle of the screen. */
void fuzz_planes(fuzz_input *in)
{
    static fxl_rectangle_work work;
    static fxl_clip_world_work world;
    fxl_point points[3];
    fxl_plane plane = {{1, 2, 3}, 4};
    for (int i = 0; i < 3; i++) {
        points[i] = fuzz_point(in, FXL_COORDINATE_MAX);
    }
    const uint32_t kind = fuzz_below(in, 8);
    points[0].x = kind == 0 ? INT32_MIN : points[0].x;
    points[2] = kind == 1 ? points[1] : points[2];
    fxl_status status = fxl_plane_from_points(&points[0], &points[1], &points[2], &plane);
    DEMAND(status == FXL_OK || (plane.normal.x == 1 && plane.distance == 4));
    record_bytes(&plane.normal, sizeof plane.normal);
    record_number(plane.distance);
    DEMAND(fxl_plane_from_points(NULL, &points[1], &points[2], &plane) == FXL_E_ARGUMENT);
    DEMAND(fxl_plane_from_points(&points[0], NULL, &points[2], &plane) == FXL_E_ARGUMENT);
    DEMAND(fxl_plane_from_points(&points[0], &points[1], NULL, &plane) == FXL_E_ARGUMENT);
    DEMAND(fxl_plane_from_points(&points[0], &points[1], &points[2], NULL) == FXL_E_ARGUMENT);
    if (status == FXL_OK) {
        fxl_line_meeting at;
        fxl_half_space space;
        fxl_half_space_from_plane(&plane, &space);
        space.normal = kind < 4 ? space.normal : (fxl_direction){0, 0, FXL_Q2_30_ONE}; /* no rest */
        space.offset = kind < 6 ? space.offset : 0;
        const fxl_view_point from = any_place(in), to = kind == 2 ? from : any_place(in);
        if (fxl_line_meet_plane(&from, &to, &space, &at) == FXL_LINE_MEETS) {
            const fxl_q18_46 off = fxl_half_space_distance(&space, &at.point);
            record_bytes(&at, sizeof at);
            DEMAND(off >= -4 && off <= 3); /* 1.25 times the sum of a unit vector's components */
        }
    }
    fxl_screen_polygon flat = {.count = (uint8_t)(3 + fuzz_below(in, FXL_POLYGON_CAPACITY - 2))};
    for (uint32_t i = 0; i < flat.count; i++) {
        flat.points[i].x = fuzz_between(in, -FXL_SCREEN_COORDINATE_MAX, FXL_SCREEN_COORDINATE_MAX);
        flat.points[i].y = fuzz_between(in, -FXL_SCREEN_COORDINATE_MAX, FXL_SCREEN_COORDINATE_MAX);
    }
    fxl_rectangle to = {0, 0, 0, 0};
    to.right = fuzz_between(in, 0, FXL_SCREEN_COORDINATE_MAX);
    to.bottom = fuzz_between(in, 0, FXL_SCREEN_COORDINATE_MAX);
    const fxl_screen_polygon *clipped;
    fxl_clip_result cut = fxl_clip_to_rectangle(&flat, &to, &work, &clipped);
    DEMAND((clipped == &flat) == (cut == FXL_CLIP_INSIDE));
    DEMAND((clipped != NULL) == (cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT));
    record_number(cut);
    if (clipped != NULL) {
        record_points(clipped);
    }
    for (uint32_t i = 0; clipped != NULL && i < clipped->count; i++) {
        DEMAND(clipped->points[i].x >= 0 && clipped->points[i].x <= to.right);
        DEMAND(clipped->points[i].y >= 0 && clipped->points[i].y <= to.bottom);
    }
    fxl_view view;
    const fxl_pose pose = fuzz_pose(in);
    const fxl_lens lens = fuzz_lens(in, FXL_SCREEN_MAX * FXL_SCREEN_MAX);
    fxl_view_set_lens(&view, &lens);
    DEMAND(fxl_view_set_pose(&view, &pose) == FXL_OK);
    fxl_view_set_world_frustum(&view);
    fxl_polygon polygon = {.count = 3};
    for (int i = 0; i < 3; i++) {
        polygon.vertices[i].position = fuzz_point(in, FXL_COORDINATE_MAX);
    }
    const fxl_polygon *result;
    cut = fxl_clip_world_to_planes(&polygon, &view.frustum,
                                   (fxl_planes)fuzz_below(in, FXL_PLANES_ALL + 1), &world, &result);
    DEMAND((result != NULL) == (cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT));
    record_number(cut);
    for (uint32_t i = 0; result != NULL && i < result->count; i++) {
        record_bytes(&result->vertices[i].position, sizeof result->vertices[i].position);
    }
}

/* What a first program does, with less memory than it needs, just that much, or more; and a display
 * for its frames. */
void fuzz_first_program(fuzz_input *in)
{
    static const fxl_point vertices[] = {
        {-65536, -65536, 0}, {-65536, 65536, 0}, {65536, 65536, 0}, {65536, -65536, 0}};
    static const uint16_t corners[] = {0, 1, 2, 3};
    static const fxl_face faces[] = {{{0, 0, -FXL_Q2_30_ONE}, 4, 7, FXL_INDICES_AT(0, 0)}};
    static const fxl_model models[] = {{0, 4, 0, 1, FXL_MODEL_CONVEX, 0, 0, 65536 * 2, 0}};
    static const fxl_instance instances[1];
    static uint64_t memory[64];
    static uint8_t pixels[24 * 16];
    static fxl_renderer renderer;
    fxl_scene scene = SCENE_OF(vertices, corners, faces, models, instances);
    fxl_config config = fxl_config_default(24, 16);
    fxl_pose eye = fuzz_pose(in);
    uint32_t kind = fuzz_below(in, 16);
    size_t size = fuzz_below(in, sizeof memory + 1);
    DEMAND(fxl_renderer_init(&renderer, &scene, &config, memory, size) == FXL_E_ORDER);
    DEMAND(fxl_scene_check(&scene, NULL) == FXL_OK);
    DEMAND(fxl_renderer_init(NULL, &scene, &config, memory, size) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init(&renderer, NULL, &config, memory, size) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init(&renderer, &scene, NULL, memory, size) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init(&renderer, &scene, &config, NULL, size) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_init(&renderer, &scene, &config, (uint8_t *)memory + 4, size) ==
           FXL_E_ALIGNMENT);
    config.near_z = kind == 0 ? 0 : config.near_z;
    fxl_status status = fxl_renderer_init(&renderer, &scene, &config, memory, size);
    size_t least = (scene.draw_list_needed * sizeof(fxl_draw_entry) + 7) & ~(size_t)7;
    DEMAND(status == (kind == 0 ? FXL_E_RANGE : size < least ? FXL_E_CAPACITY : FXL_OK));
    DEMAND(fxl_render(NULL, &eye, pixels, 24) == FXL_E_ARGUMENT);
    if (status != FXL_OK) {
        return;
    }
    DEMAND(fxl_render(&renderer, NULL, pixels, 24) == FXL_E_ARGUMENT);
    DEMAND(fxl_render(&renderer, &eye, NULL, 24) == FXL_E_ARGUMENT);
    DEMAND(fxl_render(&renderer, &eye, pixels, 23) == FXL_E_RANGE);
    DEMAND(fxl_render(&renderer, &eye, pixels, 24) == FXL_OK);
    record_bytes(pixels, sizeof pixels);
    fuzz_show(in, &renderer, &eye);
    eye.position.x = INT32_MAX;
    DEMAND(fxl_render(&renderer, &eye, pixels, 24) == FXL_E_RANGE);
    for (int i = -1; i <= FXL_STATUS_COUNT; i++) {
        DEMAND(fxl_status_text((fxl_status)i) != NULL);
    }
}
