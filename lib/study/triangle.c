/* SPDX-License-Identifier: MIT */
#include "../clip/volume.h"
#include "triangle.h"

#include "../clip/intersection.h"
#include "../math/arith.h"
#include "../view/project.h"
#include "clip_polygon.h"

static void copy_corner(const fxl_screen_corner *from, uint32_t carried, fxl_screen_corner *to)
{
    to->at = from->at;
    to->depth = from->depth;
    for (uint32_t i = 0; i < carried; i++) {
        to->carried[i] = from->carried[i];
    }
}

/* How the vertices of a triangle lie to a plane: how many are inside, and which one is alone on
 * its side. That one is first; second and third follow in the triangle's order. */
typedef struct {
    uint32_t inside;
    uint32_t first, second, third;
} sides;

static sides sides_of(const fxl_q18_46 *distances, fxl_q18_46 sliver)
{
    static const uint8_t alone[8] = {0, 0, 1, 2, 2, 1, 0, 0};
    static const uint8_t count[8] = {0, 1, 1, 2, 1, 2, 2, 3};
    uint32_t bits = fxl_inside_bits(distances, 3, sliver);
    sides of = {count[bits], alone[bits], 0, 0};
    of.second = of.first == 2 ? 0 : of.first + 1;
    of.third = of.second == 2 ? 0 : of.second + 1;
    return of;
}

/* Computes the intersection of an edge with the plane, from its inside to its outside vertex. */
static void intersect_solid(const fxl_clip_triangle *in, const fxl_q18_46 *distances,
                            uint32_t inside, uint32_t outside, uint32_t carried,
                            fxl_clip_stats *stats, fxl_varying_vertex *to)
{
    if (distances[inside] == 0 || distances[outside] >= 0) {
        fxl_copy_vertex(&in->corners[distances[inside] == 0 ? inside : outside], carried, to);
        return;
    }
    stats->intersections += 1;
    fxl_intersection_vertex(&in->corners[inside], &in->corners[outside],
                            fxl_intersection_fraction(distances[inside], distances[outside]),
                            carried, to);
}

static void set_solid(const fxl_varying_vertex *a, const fxl_varying_vertex *b,
                      const fxl_varying_vertex *c, uint32_t carried, fxl_clip_triangle *to)
{
    fxl_copy_vertex(a, carried, &to->corners[0]);
    fxl_copy_vertex(b, carried, &to->corners[1]);
    fxl_copy_vertex(c, carried, &to->corners[2]);
}

uint32_t fxl_triangle_cut(const fxl_clip_triangle *in, const fxl_half_space *plane,
                          uint32_t carried, fxl_clip_stats *stats, fxl_clip_triangle out[2])
{
    fxl_q18_46 distances[3];
    fxl_varying_vertex low, high;
    uint32_t made = 0;
    stats->distances += 3;
    for (int i = 0; i < 3; i++) {
        distances[i] = fxl_half_space_distance(plane, &in->corners[i].position);
    }
    sides of = sides_of(distances, stats->sliver);
    const fxl_varying_vertex *first = &in->corners[of.first];
    const fxl_varying_vertex *second = &in->corners[of.second], *third = &in->corners[of.third];
    if (of.inside == 3) {
        set_solid(first, second, third, carried, &out[0]);
        return 1;
    }
    if (of.inside == 1 && distances[of.first] > 0) {
        intersect_solid(in, distances, of.first, of.second, carried, stats, &low);
        intersect_solid(in, distances, of.first, of.third, carried, stats, &high);
        set_solid(first, &low, &high, carried, &out[made++]);
    } else if (of.inside == 2) { /* left: second, third and the two intersections */
        intersect_solid(in, distances, of.third, of.first, carried, stats, &low);
        intersect_solid(in, distances, of.second, of.first, carried, stats, &high);
        if (distances[of.third] > 0) {
            set_solid(second, third, &low, carried, &out[made++]);
        }
        if (distances[of.second] > 0) {
            set_solid(second, &low, &high, carried, &out[made++]);
        }
    }
    return made;
}

/* Returns how far a point is inside a border. Coordinates are below 2^28, and a border is at
 * most 2^26. */
static fxl_q18_46 border_distance(const fxl_screen_point *at, int border, uint16_t extent)
{
    switch (border) {
    case FXL_BORDER_LEFT:
        return at->x;
    case FXL_BORDER_RIGHT:
        return extent * 65536 - at->x;
    case FXL_BORDER_TOP:
        return at->y;
    default:
        FXL_ASSERT(border == FXL_BORDER_BOTTOM);
        return extent * 65536 - at->y;
    }
}

/* part * depth as 2^32 high + low; high has at most 58 bits and low 32. */
typedef struct {
    uint64_t high, low;
} weight;

static weight weigh(uint64_t part, fxl_q18_46 depth)
{
    uint64_t low = part * (uint32_t)depth;
    weight of = {part * ((uint64_t)depth >> 32) + (low >> 32), (uint32_t)low};
    return of;
}

static fxl_q18_46 shifted(const weight *of, unsigned shift)
{
    return (fxl_q18_46)((of->high << (32 - shift)) + (of->low >> shift));
}

/* The fraction in space of an edge that is cut at a given fraction on the screen. With s counted
 * from the inside end on the screen, it is s z0 / (s z0 + (1 - s) z1). Both weights are brought
 * to 62 bits. The outside weight keeps at least one bit, because a distance is at least a unit
 * and a depth 2^37. */
/* clippers 3.2 */
static uint64_t fraction_in_space(fxl_q18_46 inside, fxl_q18_46 z_inside, fxl_q18_46 outside,
                                  fxl_q18_46 z_outside)
{
    weight to = weigh((uint64_t)inside, z_inside);
    weight from = weigh(fxl_magnitude(outside), z_outside);
    unsigned bits = fxl_bit_length(to.high | from.high);
    unsigned shift = bits > 30 ? bits - 30 : 0;
    return fxl_intersection_fraction(shifted(&to, shift), -shifted(&from, shift));
}

/* Always from the inside to the outside vertex, so both triangles that share the edge get the
 * same bits. */
static void intersect_flat(const fxl_screen_triangle *in, const fxl_q18_46 *distances, int border,
                           uint16_t extent, uint32_t inside, uint32_t outside, uint32_t carried,
                           fxl_clip_stats *stats, fxl_screen_corner *corner)
{
    const fxl_screen_corner *from = &in->corners[inside], *to = &in->corners[outside];
    if (distances[inside] == 0 || distances[outside] >= 0) {
        copy_corner(distances[inside] == 0 ? from : to, carried, corner);
        return;
    }
    bool upright = border == FXL_BORDER_LEFT || border == FXL_BORDER_RIGHT;
    bool far_side = border == FXL_BORDER_RIGHT || border == FXL_BORDER_BOTTOM;
    fxl_q16_16 limit = far_side ? extent * 65536 : 0;
    stats->intersections += 1;
    corner->at.x = upright ? limit
                           : fxl_intersection_screen(from->at.x, to->at.x, distances[inside],
                                                     distances[outside]);
    corner->at.y = upright ? fxl_intersection_screen(from->at.y, to->at.y, distances[inside],
                                                     distances[outside])
                           : limit;
    uint64_t fraction =
        fraction_in_space(distances[inside], from->depth, distances[outside], to->depth);
    corner->depth = fxl_intersection_part(from->depth, to->depth, fraction);
    for (uint32_t i = 0; i < carried; i++) {
        corner->carried[i] = fxl_intersection_varying(from->carried[i], to->carried[i], fraction);
    }
}

/* Writes a triangle to `to` if it has any area. Returns how many it wrote. Differences are below
 * 2^29, so each product is below 2^58. */
static uint32_t set_flat(const fxl_screen_corner *a, const fxl_screen_corner *b,
                         const fxl_screen_corner *c, uint32_t carried, fxl_screen_triangle *to)
{
    int64_t across = (int64_t)(b->at.x - a->at.x) * (c->at.y - a->at.y);
    int64_t down = (int64_t)(c->at.x - a->at.x) * (b->at.y - a->at.y);
    if (across == down) {
        return 0;
    }
    copy_corner(a, carried, &to->corners[0]);
    copy_corner(b, carried, &to->corners[1]);
    copy_corner(c, carried, &to->corners[2]);
    return 1;
}

uint32_t fxl_triangle_cut_screen(const fxl_screen_triangle *in, int border, uint16_t extent,
                                 uint32_t carried, fxl_clip_stats *stats,
                                 fxl_screen_triangle out[2])
{
    fxl_q18_46 distances[3];
    fxl_screen_corner low, high;
    for (int i = 0; i < 3; i++) {
        distances[i] = border_distance(&in->corners[i].at, border, extent);
    }
    sides of = sides_of(distances, stats->sliver);
    const fxl_screen_corner *first = &in->corners[of.first];
    const fxl_screen_corner *second = &in->corners[of.second], *third = &in->corners[of.third];
    if (of.inside == 0) {
        return 0;
    }
    if (of.inside == 3) {
        return set_flat(first, second, third, carried, &out[0]);
    }
    if (of.inside == 1) {
        intersect_flat(in, distances, border, extent, of.first, of.second, carried, stats, &low);
        intersect_flat(in, distances, border, extent, of.first, of.third, carried, stats, &high);
        return set_flat(first, &low, &high, carried, &out[0]);
    }
    intersect_flat(in, distances, border, extent, of.third, of.first, carried, stats, &low);
    intersect_flat(in, distances, border, extent, of.second, of.first, carried, stats, &high);
    uint32_t made = set_flat(second, third, &low, carried, &out[0]);
    return made + set_flat(second, &low, &high, carried, &out[made]);
}

/* --- the queue of the triangles that wait ----------------------------------------------------- */

#define MASK (FXL_TRIANGLE_QUEUE - 1u)

/* A border at most doubles the triangles that wait, so four borders make at most 16. */
/* clippers 3.2 */
static void cut_flats(fxl_triangle_workspace *workspace, int border, uint16_t extent)
{
    fxl_clip_stats stats = workspace->stats;
    stats.sliver = workspace->screen_sliver;
    for (uint32_t left = workspace->flat_count; left > 0; left--) {
        fxl_screen_triangle cut[2];
        uint32_t made = fxl_triangle_cut_screen(&workspace->flats[workspace->flat_first & MASK],
                                                border, extent, workspace->carried, &stats, cut);
        workspace->flat_first += 1;
        workspace->flat_count -= 1;
        for (uint32_t i = 0; i < made; i++) {
            FXL_ASSERT(workspace->flat_count < FXL_TRIANGLE_QUEUE);
            workspace->flats[(workspace->flat_first + workspace->flat_count++) & MASK] = cut[i];
        }
    }
    workspace->stats.intersections = stats.intersections;
}

fxl_clip_result fxl_triangle_begin(const fxl_clip_triangle *in, uint32_t carried,
                                   const fxl_volume *volume, fxl_triangle_workspace *workspace)
{
    uint32_t any = 0, all = UINT32_MAX;
    for (int i = 0; i < 3; i++) {
        uint32_t code = fxl_volume_code(volume, &in->corners[i].position);
        any |= code;
        all &= code;
    }
    workspace->stats.distances += 3 * FXL_PLANE_COUNT;
    workspace->planes = any;
    workspace->carried = (uint8_t)carried;
    workspace->flat_first = workspace->flat_count = workspace->solid_count = 0;
    if (all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    workspace->solids[0] = *in;
    workspace->next_plane[0] = 0;
    workspace->solid_count = 1;
    return any == 0 ? FXL_CLIP_INSIDE : FXL_CLIP_CUT;
}

/* Cuts the triangle on top of the stack by the planes that have not cut it yet. Where a plane
 * leaves two triangles, the second is pushed, to be cut by the planes that follow. So no two
 * triangles that wait have the same next plane. Returns null where nothing is left. */
static const fxl_clip_triangle *pop_solid(const fxl_volume *volume,
                                          fxl_triangle_workspace *workspace)
{
    uint32_t top = --workspace->solid_count;
    for (uint32_t plane = workspace->next_plane[top]; workspace->planes >> plane != 0; plane++) {
        fxl_clip_triangle cut[2];
        if ((workspace->planes >> plane & 1u) == 0) {
            continue;
        }
        /* The result replaces its source on the stack; the next triangle goes above it. */
        uint32_t made = fxl_triangle_cut(&workspace->solids[top], &volume->planes[plane],
                                         workspace->carried, &workspace->stats, cut);
        if (made == 0) {
            workspace->solid_count = top;
            return NULL;
        }
        if (made == 2) {
            workspace->solids[top] = cut[1];
            workspace->next_plane[top] = (uint8_t)(plane + 1);
            top += 1;
            FXL_ASSERT(top < FXL_TRIANGLE_STACK);
        }
        workspace->solids[top] = cut[0];
    }
    workspace->solid_count = top;
    return &workspace->solids[top];
}

/* Projects a triangle, and keeps the depth of each vertex. */
static fxl_status project(const fxl_lens *lens, const fxl_clip_triangle *solid, uint32_t carried,
                          fxl_screen_triangle *flat)
{
    for (int i = 0; i < 3; i++) {
        const fxl_varying_vertex *from = &solid->corners[i];
        fxl_screen_corner *to = &flat->corners[i];
        fxl_status status = fxl_project_point(lens, &from->position, &to->at);
        if (status != FXL_OK) {
            return status;
        }
        to->depth = from->position.z;
        for (uint32_t k = 0; k < carried; k++) {
            to->carried[k] = from->carried[k];
        }
    }
    return FXL_OK;
}

const fxl_screen_triangle *fxl_triangle_next(const fxl_volume *volume, const fxl_lens *lens,
                                             fxl_triangle_workspace *workspace, fxl_status *status)
{
    *status = FXL_OK;
    while (workspace->flat_count == 0) {
        if (workspace->solid_count == 0) {
            return NULL;
        }
        const fxl_clip_triangle *solid = pop_solid(volume, workspace);
        if (solid == NULL) {
            continue;
        }
        *status = project(lens, solid, workspace->carried, &workspace->flats[0]);
        if (*status != FXL_OK) {
            workspace->solid_count = 0;
            return NULL;
        }
        workspace->flat_first = 0;
        workspace->flat_count = 1;
        cut_flats(workspace, FXL_BORDER_LEFT, lens->width);
        cut_flats(workspace, FXL_BORDER_RIGHT, lens->width);
        cut_flats(workspace, FXL_BORDER_TOP, lens->height);
        cut_flats(workspace, FXL_BORDER_BOTTOM, lens->height);
    }
    workspace->flat_count -= 1;
    return &workspace->flats[workspace->flat_first++ & MASK];
}
