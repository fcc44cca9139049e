/* SPDX-License-Identifier: MIT */
#include "reference/render.h"

#include <stdlib.h>
#include <string.h>

#include "reference/billboard.h"
#include "reference/clip.h"
#include "reference/cull.h"
#include "reference/camera.h"
#include "reference/depth.h"
#include "reference/light.h"
#include "reference/scan.h"
#include "reference/submit_by_bsp.h"
#include "reference/placement.h"
#include "reference/wire.h"

bool ref_renderer_init(ref_renderer *renderer, const ref_scene *scene, const ref_lens *lens)
{
    uint32_t faces = 0;
    for (uint32_t i = 0; i < scene->model_count; i++) {
        faces = scene->models[i].face_count > faces ? scene->models[i].face_count : faces;
    }
    memset(renderer, 0, sizeof *renderer);
    renderer->scene = scene;
    renderer->lens = *lens;
    renderer->method.cuts = REF_CUT_ALL;
    renderer->order = calloc(scene->instance_count, sizeof *renderer->order);
    renderer->faces = calloc((size_t)faces + 1, sizeof *renderer->faces);
    renderer->nearness =
        calloc((size_t)lens->width * (size_t)lens->height, sizeof *renderer->nearness);
    if (!renderer->order || !renderer->faces || !renderer->nearness) {
        ref_renderer_close(renderer);
        return false;
    }
    return true;
}

void ref_renderer_close(ref_renderer *renderer)
{
    free(renderer->order);
    free(renderer->faces);
    free(renderer->nearness);
    ref_display_list_close(&renderer->display_list);
    memset(renderer, 0, sizeof *renderer);
}

/* Tells whether all vertices lie outside one plane of the view. Every clipper rejects such a
 * face, also a clipper that leaves that plane's side to the scan. */
static bool is_outside(const ref_camera *camera, const ref_view_frustum *frustum,
                       const ref_polygon *polygon)
{
    unsigned all = REF_CUT_ALL;
    for (int i = 0; i < polygon->count; i++) {
        ref_view_point view_point = ref_transform_point(camera, &polygon->vertices[i].position);
        all &= ref_outcode(frustum, &view_point);
    }
    return all != 0;
}

/* Clips and projects a polygon. Near and far are moved apart by `moved` first. The outline has
 * no points unless something is left. */
static ref_clip_result clip_and_project(const ref_renderer *renderer, const ref_polygon *whole,
                                        double moved, ref_screen_polygon *screen)
{
    ref_frustum frustum = renderer->frustum;
    ref_view_frustum view_frustum = renderer->view_frustum;
    ref_polygon clipped;
    ref_view_polygon view;
    ref_depth_move_frustum(&frustum, moved);
    ref_depth_move_view_frustum(&view_frustum, moved);
    *screen = (ref_screen_polygon){.colour = whole->colour};
    if (renderer->method.cuts != REF_CUT_ALL &&
        is_outside(&renderer->camera, &view_frustum, whole)) {
        return REF_CLIP_OUTSIDE;
    }
    ref_clip_result result = ref_clip_world_to_frustum(whole, &frustum, &clipped);
    if (result == REF_CLIP_CUT || result == REF_CLIP_INSIDE) {
        ref_transform_polygon(&renderer->camera, &clipped, &view);
        ref_project_polygon(&renderer->lens, &view, screen);
    }
    return result;
}

static void count(ref_clip_result result, ref_counters *counters)
{
    switch (result) {
    case REF_CLIP_OUTSIDE:
        counters->outside++;
        break;
    case REF_CLIP_DEGENERATE:
        counters->degenerate++;
        break;
    case REF_CLIP_CAPACITY:
        counters->refused++;
        break;
    case REF_CLIP_CUT:
        counters->clipped++;
        counters->drawn++;
        break;
    case REF_CLIP_INSIDE:
        counters->drawn++;
        break;
    }
}

/* Notes what the rounding of depths may make of the polygon, if it may change it. */
static void note_doubt(const ref_renderer *renderer, const ref_polygon *whole, ref_drawn *drawn)
{
    double bound =
        ref_depth_bound(whole, &renderer->camera.position, &renderer->lens) +
        ref_placement_depth_bound(renderer->scene, &renderer->scene->instances[drawn->instance]);
    if (ref_depth_is_in_doubt(&renderer->view_frustum, &renderer->camera, whole, bound)) {
        drawn->in_doubt = true;
        clip_and_project(renderer, whole, -bound, &drawn->least);
        clip_and_project(renderer, whole, bound, &drawn->most);
    }
}

/* Whether a face of an instance shows a surface. */
static bool shows_surface(const ref_renderer *renderer, const ref_instance *instance, uint32_t face)
{
    const ref_scene *scene = renderer->scene;
    return scene->surfaces && !renderer->method.flat &&
           scene->surfaces->face_map[scene->models[instance->model].first_face + face] != 0;
}

/* 1 less the brightness of a flat face, in RGB565. */
static double shade_of(const ref_renderer *renderer, const ref_instance *instance,
                       const ref_face *face)
{
    const ref_light *light = renderer->scene->light;
    return light && renderer->rgb565
               ? 1 - ref_light_of_face(light, &renderer->camera, renderer->scene, instance, face)
               : 0;
}

static bool submit_polygon(ref_renderer *renderer, const ref_polygon *whole, uint32_t instance,
                           uint32_t face, bool is_in_beam, ref_counters *counters)
{
    ref_drawn drawn = {.instance = instance, .face = face};
    count(clip_and_project(renderer, whole, 0, &drawn.polygon), counters);
    if (face == REF_NO_FACE) {
        return true;
    }
    if (renderer->keeps_doubt) {
        note_doubt(renderer, whole, &drawn);
    }
    if (drawn.polygon.count == 0 && drawn.most.count == 0) {
        return true;
    }
    const ref_instance *of = &renderer->scene->instances[instance];
    const ref_face *shown = ref_face_of(renderer->scene, of, face);
    if (!shows_surface(renderer, of, face)) {
        drawn.shade = shade_of(renderer, of, shown);
    } else {
        ref_surface_look(renderer->scene, &renderer->camera, &renderer->lens, renderer->rgb565, of,
                         face, &drawn.look);
        drawn.look.in_beam = is_in_beam ? renderer->scene->lit : NULL;
        drawn.look.is_light_coarse = renderer->method.depth_bits == 16;
    }
    if (renderer->method.depth_bits != 0) {
        ref_depth_plane_find(renderer->scene, &renderer->camera, of, shown, &drawn.depth);
        if (renderer->lens.scale != 0) {
            ref_depth_plane_take_eye(&drawn.depth, &renderer->lens);
        }
    }
    drawn.rows = ref_scan_rows(&drawn.polygon, renderer->lens.height);
    return ref_display_list_append(&renderer->display_list, &drawn);
}

bool ref_submit_polygon(ref_renderer *renderer, const ref_polygon *whole, uint32_t instance,
                        uint32_t face, ref_counters *counters)
{
    return submit_polygon(renderer, whole, instance, face, false, counters);
}

/* Counts one face, from the counts of its pieces. */
static void count_once(const ref_counters *pieces, ref_counters *counters)
{
    if (pieces->refused) {
        counters->refused++;
    } else if (pieces->drawn) {
        counters->drawn++;
        counters->clipped += pieces->clipped > 0;
    } else if (pieces->degenerate) {
        counters->degenerate++;
    } else {
        counters->outside++;
    }
}

/* The colour of a face in the frame. */
static uint8_t face_colour(const ref_renderer *renderer, const ref_instance *instance,
                           const ref_face *face)
{
    const ref_scene *scene = renderer->scene;
    return scene->light && !renderer->rgb565
               ? ref_light_colour(scene->light, &renderer->camera, scene, instance, face)
               : face->material;
}

static bool is_lit_by_beams(const ref_scene *scene, const ref_instance *instance)
{
    return ref_beam_light_reaches(scene, &instance->centre, ref_instance_radius(scene, instance));
}

bool ref_submit_piece(ref_renderer *renderer, const ref_piece *whole, uint32_t instance_number,
                      uint32_t face_number, ref_counters *counters)
{
    ref_lit_pieces pieces; /* not static: judges run in threads */
    const ref_scene *scene = renderer->scene;
    const ref_instance *instance = &scene->instances[instance_number];
    const ref_face *face = ref_face_of(scene, instance, face_number);
    const uint8_t colour = face_colour(renderer, instance, face);
    const ref_placement *placement = ref_placement_of(scene, instance);
    int32_t normal[3];
    memcpy(normal, face->normal, sizeof normal);
    if (placement) {
        ref_placement_normal(placement, face->normal, normal);
    }
    if (!is_lit_by_beams(scene, instance) || !ref_beam_light_split(scene, whole, normal, &pieces)) {
        pieces.count = 1;
        pieces.pieces[0] = (ref_lit_piece){*whole, false};
    }
    for (int i = 0; i < pieces.count; i++) {
        const ref_lit_piece *piece = &pieces.pieces[i];
        ref_polygon polygon = {.colour = piece->lit ? scene->lit[colour] : colour,
                               .count = piece->shape.count};
        for (int k = 0; k < polygon.count; k++) {
            polygon.vertices[k].position = ref_point_from_lattice(&piece->shape.points[k]);
        }
        if (!submit_polygon(renderer, &polygon, instance_number, face_number, piece->lit,
                            counters)) {
            return false;
        }
    }
    return true;
}

/* Submits a face of an instance that a beam may reach: in pieces, lit and dark. */
static bool submit_lit_face(ref_renderer *renderer, uint32_t instance_number, uint32_t face_number)
{
    const ref_scene *scene = renderer->scene;
    const ref_instance *instance = &scene->instances[instance_number];
    const ref_face *face = ref_face_of(scene, instance, face_number);
    ref_piece whole = {.count = face->count};
    ref_counters counted = {0};
    for (int i = 0; i < whole.count; i++) {
        whole.points[i] = ref_face_vertex(scene, instance, face, i);
    }
    if (!ref_submit_piece(renderer, &whole, instance_number, face_number, &counted)) {
        return false;
    }
    count_once(&counted, &renderer->counters);
    return true;
}

bool ref_submit_face(ref_renderer *renderer, uint32_t instance_number, uint32_t face_number)
{
    const ref_instance *instance = &renderer->scene->instances[instance_number];
    if (is_lit_by_beams(renderer->scene, instance)) {
        return submit_lit_face(renderer, instance_number, face_number);
    }
    ref_polygon whole;
    const ref_face *face = ref_face_of(renderer->scene, instance, face_number);
    ref_face_to_polygon(renderer->scene, instance, face, renderer->method.by_points, &whole);
    whole.colour = shows_surface(renderer, instance, face_number)
                       ? face->material
                       : face_colour(renderer, instance, face);
    return ref_submit_polygon(renderer, &whole, instance_number, face_number, &renderer->counters);
}

/* The one face of an instance that shows a billboard. */
static bool submit_billboard(ref_renderer *renderer, uint32_t number)
{
    const ref_scene *scene = renderer->scene;
    ref_drawn drawn = {.instance = number};
    const ref_billboard_result result = ref_billboard_look(
        scene, &renderer->camera, &renderer->lens, &scene->instances[number], &drawn);
    renderer->counters.in++;
    renderer->counters.outside += result == REF_BILLBOARD_OUTSIDE;
    renderer->counters.refused += result == REF_BILLBOARD_REFUSED;
    renderer->counters.drawn += result == REF_BILLBOARD_DRAWN;
    drawn.look.rgb565 = renderer->rgb565;
    drawn.in_doubt = drawn.in_doubt && renderer->keeps_doubt;
    if (drawn.polygon.count == 0 && !drawn.in_doubt) {
        return true;
    }
    drawn.rows = ref_scan_rows(&drawn.polygon, renderer->lens.height);
    return ref_display_list_append(&renderer->display_list, &drawn);
}

/* Whether the faces of a sorted model come by number: with a depth buffer, and nothing blended. */
static bool is_by_number(const ref_renderer *renderer)
{
    const ref_surfaces *surfaces = renderer->scene->surfaces;
    for (uint32_t i = 0; surfaces && !renderer->method.flat && i < surfaces->surface_count; i++) {
        if (ref_surface_mixes(&surfaces->surfaces[i])) {
            return false;
        }
    }
    return renderer->method.depth_bits != 0;
}

static bool submit_line(ref_renderer *renderer, uint32_t number, const ref_line *line)
{
    const ref_line_view view = {renderer->scene,
                                &renderer->camera,
                                &renderer->lens,
                                &renderer->view_frustum,
                                &renderer->eye,
                                renderer->keeps_doubt};
    ref_drawn drawn = {.instance = number};
    if (!ref_line_find(&view, line, &drawn)) {
        return true;
    }
    drawn.rows = ref_scan_rows(&drawn.polygon, renderer->lens.height);
    return ref_display_list_append(&renderer->display_list, &drawn);
}

/* The lines of an instance, after its faces. */
static bool submit_lines(ref_renderer *renderer, uint32_t number)
{
    const ref_scene *scene = renderer->scene;
    const uint32_t *map = scene->line_map + scene->instances[number].model;
    for (uint32_t i = map[0]; i < map[1]; i++) {
        if (!submit_line(renderer, number, &scene->lines[i])) {
            return false;
        }
    }
    return true;
}

/* The edges of each face of an instance that shows no billboard, as lines on that face. */
static bool submit_outlines(ref_renderer *renderer, uint32_t number)
{
    const ref_scene *scene = renderer->scene;
    const ref_instance *instance = &scene->instances[number];
    const ref_model *model = &scene->models[instance->model];
    for (uint32_t i = 0; i < model->face_count && !ref_billboard_of(scene, instance); i++) {
        const ref_face *face = &scene->faces[model->first_face + i];
        const uint16_t *corners = &scene->indices[face->first_index];
        for (int k = 0; k < face->count; k++) {
            const ref_line edge = {corners[k], corners[(k + 1) % face->count],
                                   {(uint16_t)(i + 1), 0}, scene->outline, 1};
            if (!submit_line(renderer, number, &edge)) {
                return false;
            }
        }
    }
    return true;
}

static bool submit_faces(ref_renderer *renderer, uint32_t number)
{
    const ref_scene *scene = renderer->scene;
    const ref_instance *instance = &scene->instances[number];
    if (ref_billboard_of(scene, instance)) {
        return submit_billboard(renderer, number);
    }
    const ref_model *model = &scene->models[instance->model];
    uint32_t count = 0, left_out = 0;
    if (model->kind == REF_MODEL_SORTED) {
        count = ref_order_faces(scene, instance, &renderer->eye, &renderer->camera,
                                &renderer->view_frustum, is_by_number(renderer), renderer->faces,
                                &left_out);
    } else {
        for (uint32_t i = 0; i < model->face_count; i++) {
            const ref_face *face = &scene->faces[model->first_face + i];
            if (ref_face_shows_front(scene, instance, face, &renderer->eye, &renderer->camera)) {
                renderer->faces[count++].index = i;
            }
        }
    }
    renderer->counters.in += model->face_count;
    renderer->counters.outside += left_out;
    renderer->counters.backfacing += model->face_count - left_out - count;
    for (uint32_t i = 0; i < count; i++) {
        if (!ref_submit_face(renderer, number, renderer->faces[i].index)) {
            return false;
        }
    }
    return true;
}

bool ref_submit_instance(ref_renderer *renderer, uint32_t number)
{
    const bool has_outlines = renderer->scene->has_outlines && renderer->method.depth_bits != 0;
    return submit_faces(renderer, number) &&
           (!has_outlines || submit_outlines(renderer, number)) &&
           (!renderer->scene->lines || submit_lines(renderer, number));
}

static bool submit_by_distance(ref_renderer *renderer, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        if (!ref_submit_instance(renderer, renderer->order[i].index)) {
            return false;
        }
    }
    return true;
}

/* Counts the faces of the instances that are not visible: all are outside. */
static void count_invisible(ref_renderer *renderer)
{
    uint32_t faces = 0;
    for (uint32_t i = 0; i < renderer->scene->instance_count; i++) {
        faces += renderer->scene->models[renderer->scene->instances[i].model].face_count;
    }
    renderer->counters.outside += faces - renderer->counters.in;
    renderer->counters.in = faces;
}

/* Sets the planes that cut. The sides are those of the screen, without the inset. An inset that
 * takes something from the picture is a fault of the scene, which a judge must see
 * (docs/accuracy.md, section 4). */
static void set_frusta(ref_renderer *renderer)
{
    ref_lens screen = renderer->lens;
    screen.inset = 0;
    ref_view_frustum view_sides = ref_view_frustum_from_lens(&screen);
    ref_frustum sides =
        ref_frustum_with_guard(&renderer->camera, &screen, renderer->method.cuts, REF_GUARD_PIXELS);
    renderer->view_frustum = ref_view_frustum_from_lens(&renderer->lens);
    renderer->frustum = ref_frustum_from_camera(&renderer->camera, &renderer->lens);
    for (int plane = REF_PLANE_LEFT; plane <= REF_PLANE_TOP; plane++) {
        renderer->view_frustum.planes[plane] = view_sides.planes[plane];
        renderer->frustum.planes[plane] = sides.planes[plane];
    }
}

bool ref_frame_begin(ref_renderer *renderer, const ref_pose *pose)
{
    renderer->eye = pose->position;
    renderer->camera = ref_camera_from_pose(pose);
    if (renderer->lens.scale != 0) {
        ref_camera_take_eye(&renderer->camera);
    }
    set_frusta(renderer);
    renderer->counters = (ref_counters){0};
    renderer->display_list.count = 0;
    uint32_t count = ref_order_instances(renderer->scene, &renderer->eye, &renderer->camera,
                                         &renderer->view_frustum, renderer->order);
    const bool by_bsp = renderer->method.by_bsp && renderer->scene->bsp_nodes;
    if (!(by_bsp ? ref_submit_by_bsp(renderer, renderer->order, count)
                 : submit_by_distance(renderer, count))) {
        return false;
    }
    count_invisible(renderer);
    return true;
}
