/* SPDX-License-Identifier: MIT */
/* clipper_errors [--samples N] [--seed S] [--only CLIPPER]
 *
 * Gives every clipper of the family and the twin the same polygons and prints how
 * far their outlines are apart, as JSON. Exit code 0: it ran; 2: it could not. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clippers/measure.h"
#include "frames/input.h"

typedef struct {
    clipper_tally tally;
    void (*measure)(clipper_tally *tally, const clipper_case *of);
} clipper;

/* place clipper: the error of each clipper against the reference */
static clipper clippers[] = {
    {{.clipper = "normalised", .claimed = 1.25}, measure_normalised},
    {{.clipper = "once", .claimed = 1.25}, measure_once},
    {{.clipper = "once_triangle", .claimed = 1.25}, measure_once_triangle},
    {{.clipper = "normalised_without_slivers", .claimed = 1.25}, measure_sliver},
    {{.clipper = "half_spaces", .claimed = 1.25}, measure_half_spaces},
    {{.clipper = "near_and_guard", .claimed = 1.25}, measure_near_and_guard},
    {{.clipper = "left_and_guard", .claimed = 1.25}, measure_left_and_guard},
    {{.clipper = "triangle", .claimed = 2}, measure_triangle},
    {{.clipper = "line_by_planes", .claimed = 6}, measure_line_by_planes},
    {{.clipper = "line_by_codes", .claimed = 6}, measure_line_by_codes},
    {{.clipper = "line_and_plane", .claimed = 1.25}, measure_line_and_plane},
    {{.clipper = "plane_from_points", .claimed = 2.5}, measure_plane_from_points},
    {{.clipper = "rectangle", .claimed = 2}, measure_rectangle},
};

enum {
    CLIPPERS = sizeof clippers / sizeof clippers[0]
};

/* Flat to within what a scene's faces may be off. */
static int is_flat(const fxl_polygon *polygon)
{
    double n[3] = {0, 0, 0};
    const fxl_vertex *first = polygon->vertices;
    for (int i = 0; i < polygon->count; i++) {
        const fxl_point *a = &polygon->vertices[i].position;
        const fxl_point *b = &polygon->vertices[(i + 1) % polygon->count].position;
        n[0] += ((double)a->y - b->y) * ((double)a->z + b->z);
        n[1] += ((double)a->z - b->z) * ((double)a->x + b->x);
        n[2] += ((double)a->x - b->x) * ((double)a->y + b->y);
    }
    double length = hypot(n[0], hypot(n[1], n[2]));
    int flat = length > 0;
    for (int i = 0; i < polygon->count; i++) {
        const fxl_point *p = &polygon->vertices[i].position;
        double away = n[0] * ((double)p->x - first->position.x) +
                      n[1] * ((double)p->y - first->position.y) +
                      n[2] * ((double)p->z - first->position.z);
        flat = flat && fabs(away) <= FXL_PLANARITY_MAX * length;
    }
    return flat;
}

/* Strictly: a spike, as the world's borders make them, is none. */
static bool is_convex(const fxl_polygon *polygon)
{
    double normal[3], turns = 0;
    for (int i = 0; i < polygon->count; i++) {
        const fxl_point *a = &polygon->vertices[i].position;
        const fxl_point *b = &polygon->vertices[(i + 1) % polygon->count].position;
        const fxl_point *c = &polygon->vertices[(i + 2) % polygon->count].position;
        double in[3] = {(double)b->x - a->x, (double)b->y - a->y, (double)b->z - a->z};
        double out[3] = {(double)c->x - b->x, (double)c->y - b->y, (double)c->z - b->z};
        double turn[3] = {in[1] * out[2] - in[2] * out[1], in[2] * out[0] - in[0] * out[2],
                          in[0] * out[1] - in[1] * out[0]};
        if (i == 0) {
            memcpy(normal, turn, sizeof normal);
        }
        if (turn[0] * normal[0] + turn[1] * normal[1] + turn[2] * normal[2] <= 0) {
            return false;
        }
        double along = in[0] * out[0] + in[1] * out[1] + in[2] * out[2];
        turns += atan2(hypot(turn[0], hypot(turn[1], turn[2])), along);
    }
    return turns < 7; /* once round */
}

static clipper_case random_case(stages_random *random)
{
    clipper_case made;
    fxl_pose pose = stages_random_pose(random);
    do {
        made.lens = stages_random_lens(random);
    } while (made.lens.height > 2 * made.lens.width || made.lens.width > 4 * made.lens.height);
    if (fxl_camera_from_pose(&pose, &made.camera) != FXL_OK) {
        abort(); /* every random pose is in range */
    }
    do {
        made.polygon = stages_random_polygon(random, &made.camera);
    } while (!is_flat(&made.polygon) || made.polygon.count > FXL_FACE_VERTICES_MAX);
    made.convex = is_convex(&made.polygon);
    return made;
}

static void print(const clipper_tally *of, const char *end)
{
    printf("  {\"clipper\": \"%s\", \"cut\": %" PRIu64 ", \"max_outline_units\": %.6g, "
           "\"claimed_units\": %.6g, \"beyond\": %" PRIu64 ", \"beyond_and_parallel\": %" PRIu64
           ",\n   \"max_outline_units_at_all\": %.6g, \"max_carried_units\": %.6g, "
           "\"mean_outline_units\": %.6g, "
           "\"verdicts\": %" PRIu64 ", \"refused\": %" PRIu64 ", \"crossings\": %" PRIu64
           ", \"made\": %" PRIu64 ", \"plain_crossings\": %" PRIu64 ", \"plain_made\": %" PRIu64
           "}%s\n",
           of->clipper, of->cut, of->outline, of->claimed, of->beyond, of->parallel, of->at_all,
           of->carried, of->cut ? of->moved / (double)of->cut : 0, of->verdicts, of->refused,
           of->crossings, of->made, of->plain_crossings, of->plain_made, end);
}

int main(int count, char **arguments)
{
    uint64_t samples = 100000, seed = 1;
    const char *only = NULL;
    const argument options[] = {{"--samples", take_count, &samples},
                                {"--seed", take_count, &seed},
                                {"--only", take_text, &only}};
    if (!read_arguments(count, arguments, options, 3, NULL, 0)) {
        return fail("usage", "clipper_errors [--samples N] [--seed S] [--only CLIPPER]");
    }
    stages_random random = stages_random_start(seed, 0);
    for (uint64_t i = 0; i < samples; i++) {
        clipper_case one = random_case(&random);
        for (int k = 0; k < CLIPPERS; k++) {
            if (!only || strcmp(only, clippers[k].tally.clipper) == 0) {
                clippers[k].measure(&clippers[k].tally, &one);
            }
        }
    }
    printf("{\"seed\": %" PRIu64 ", \"samples\": %" PRIu64 ", \"clippers\": [\n", seed, samples);
    for (int k = 0; k < CLIPPERS; k++) {
        print(&clippers[k].tally, k + 1 < CLIPPERS ? "," : "");
    }
    printf("]}\n");
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : 2;
}
