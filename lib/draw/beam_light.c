/* SPDX-License-Identifier: MIT */
#include "../scene/scene_check.h"
#include "../scene/placement_code.h"
#include "fixel/beams.h"

#include "../math/arith.h"
#include "../paint/lit_pieces.h"
#include "renderer.h"
#include "scratch.h"
#include "submit.h"

/* The light of a renderer, at the beginning of the workspace. */
typedef struct {
    fxl_beam_shader shader;
    const fxl_beam *beams;
    uint8_t *tables; /* after this record */
    uint32_t beam_count, corner_capacity, piece_capacity;
} lighting;

/* A face that is split, in tables of a workspace. */
typedef struct {
    fxl_lit_pieces pieces;
    fxl_point *outline; /* outline of one piece; not on the stack, which is small on some boards */
} lit_face;

#define REFUSED ((fxl_outcome)1 << FXL_CLIP_CAPACITY)

static uint32_t rounded_up(size_t size)
{
    return ((uint32_t)size + 7u) & ~7u;
}

static uint32_t table_bytes(uint32_t corners, uint32_t pieces)
{
    return rounded_up(corners * sizeof(fxl_point)) + rounded_up(corners * sizeof(uint16_t)) +
           rounded_up(pieces * sizeof(fxl_lit_piece)) +
           rounded_up(FXL_POLYGON_CAPACITY * sizeof(fxl_point));
}

FXL_COLD uint32_t fxl_beam_light_workspace_size(const fxl_beam *beams, uint32_t beam_count)
{
    if (beams == NULL || beam_count < 1 || beam_count > FXL_BEAMS_MAX ||
        !fxl_beams_fit(beams, beam_count, 3)) {
        return 0;
    }
    return rounded_up(sizeof(lighting)) + table_bytes(fxl_lit_corners_needed(beams, beam_count),
                                                      fxl_lit_pieces_needed(beams, beam_count));
}

/* The tables of the workspace that draws. */
static void lay_out(const lighting *of, const fxl_traversal *traversal, lit_face *face)
{
    uint8_t *at = fxl_is_own_workspace(traversal)
                      ? of->tables
                      : (uint8_t *)fxl_beam_scratch(traversal, of->shader.scratch_size);
    fxl_lit_pieces *pieces = &face->pieces;
    pieces->corner_capacity = of->corner_capacity;
    pieces->points = (fxl_point *)(void *)at;
    at += rounded_up(pieces->corner_capacity * sizeof *pieces->points);
    pieces->next = (uint16_t *)(void *)at;
    at += rounded_up(pieces->corner_capacity * sizeof *pieces->next);
    pieces->piece_capacity = of->piece_capacity;
    pieces->pieces = (fxl_lit_piece *)(void *)at;
    at += rounded_up(pieces->piece_capacity * sizeof *pieces->pieces);
    face->outline = (fxl_point *)(void *)at;
}

static bool reaches(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    const lighting *of = (const lighting *)shader;
    const fxl_q16_16 radius = fxl_instance_radius(scene, instance);
    for (uint32_t i = 0; i < of->beam_count; i++) {
        if (fxl_beam_reaches(&of->beams[i], &instance->centre, radius)) {
            return true;
        }
    }
    return false;
}

/* A piece, or a face that is dark as a whole, to the shader that has its faces split, or to the
 * next one. */
/* beams 4.1 */
static bool emit(const lighting *of, fxl_pieces *pieces, const fxl_face *face,
                 const fxl_point *points, uint32_t count, bool is_lit)
{
    if (pieces->take != NULL) {
        return pieces->take(pieces, points, count, is_lit);
    }
    const uint8_t colour = is_lit ? of->shader.lit[face->material] : face->material;
    return fxl_submit_split_piece(&of->shader.shader, pieces, face, points, count, colour);
}

/* Front to back, the pieces come in reverse order. If rounding has made the pieces need more
 * memory than there is, the face is drawn whole and dark, and counts as refused. */
/* beams 4.1, 4.4 */
static bool split(const fxl_shader *shader, fxl_pieces *pieces, const fxl_face *face,
                  const fxl_point *points, uint32_t count)
{
    const lighting *of = (const lighting *)shader;
    lit_face lit;
    fxl_lit_pieces *made = &lit.pieces;
    lay_out(of, pieces->traversal, &lit);
    if (!fxl_lit_split(made, of->beams, of->beam_count, &face->normal, points, count)) {
        pieces->outcome |= REFUSED;
        for (uint32_t i = 0; i < count; i++) {
            lit.outline[i] = points[i]; /* the clipper works where points may be */
        }
        return emit(of, pieces, face, lit.outline, count, false);
    }
    const bool reverse = pieces->traversal->near_first;
    for (uint32_t i = 0; i < made->piece_count; i++) {
        const fxl_lit_piece *piece = &made->pieces[reverse ? made->piece_count - 1 - i : i];
        if (!fxl_lit_outline(made, piece, lit.outline)) {
            pieces->outcome |= REFUSED;
            continue;
        }
        if (!emit(of, pieces, face, lit.outline, piece->count, piece->is_lit)) {
            return false;
        }
    }
    return true;
}

static const fxl_shader_code code = {.reaches = reaches,
                                     .face = fxl_submit_split_face,
                                     .split = split,
                                     .in_world = &fxl_rounded_faces};

/* Builds the record in the workspace; its tables follow. */
static fxl_shader *build(const fxl_beam_set *set, uint8_t *workspace)
{
    const fxl_beam *beams = set->beams;
    const uint32_t beam_count = set->count;
    lighting *of = (lighting *)(void *)workspace;
    of->corner_capacity = fxl_lit_corners_needed(beams, beam_count);
    of->piece_capacity = fxl_lit_pieces_needed(beams, beam_count);
    of->tables = workspace + rounded_up(sizeof *of);
    of->shader.scratch_size = table_bytes(of->corner_capacity, of->piece_capacity);
    of->shader.shader.code = &code;
    of->beams = beams;
    of->beam_count = beam_count;
    of->shader.lit = set->lit;
    return &of->shader.shader;
}

/* beams 4.3 */
static fxl_status check(const fxl_scene *scene, const fxl_beam *beams, uint32_t beam_count)
{
    if (beam_count < 1 || beam_count > FXL_BEAMS_MAX) {
        return FXL_E_COUNT;
    }
    for (uint32_t i = 0; i < beam_count; i++) {
        fxl_status status = fxl_beam_check(&beams[i]);
        if (status != FXL_OK) {
            return status;
        }
    }
    for (uint32_t i = 0; i < scene->face_count; i++) {
        if (!fxl_beams_fit(beams, beam_count, scene->faces[i].count)) {
            return FXL_E_CAPACITY;
        }
    }
    return FXL_OK;
}

FXL_COLD fxl_status fxl_attach_beams(fxl_renderer *renderer, const fxl_beam_set *set, void *memory,
                                     uint32_t size)
{
    fxl_shader *shader = NULL;
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->scene == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ORDER);
    }
    if (set != NULL) {
        fxl_status status = FXL_E_ARGUMENT;
        if (set->beams != NULL && set->lit != NULL && memory != NULL) {
            status = ((uintptr_t)memory & 7u) != 0 || ((uintptr_t)set->beams & 3u) != 0
                         ? FXL_E_ALIGNMENT
                         : check(renderer->scene, set->beams, set->count);
        }
        if (status == FXL_OK && size < fxl_beam_light_workspace_size(set->beams, set->count)) {
            status = FXL_E_CAPACITY;
        }
        if (status != FXL_OK) {
            return fxl_refuse(&renderer->workspace, status);
        }
        shader = build(set, (uint8_t *)memory);
    }
    fxl_renderer_attach(renderer, FXL_SHADER_BEAMS, shader);
    FXL_COUNT_CHANGE(&renderer->workspace); /* other workspaces have no room for these beams */
    return FXL_OK;
}
