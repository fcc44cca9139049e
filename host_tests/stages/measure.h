/* SPDX-License-Identifier: MIT */
/* Feeds each stage of the library and of the reference renderer the same input: the largest, the mean and a
 * histogram of differences. */
#ifndef STAGES_MEASURE_H
#define STAGES_MEASURE_H

#include "draw/stages.h"
#include "fixel/all.h"
#include "stages/random.h"
#include "unit/split_piece.h"

/* Bin k counts differences <= 2^(k + TALLY_FIRST_POWER). The first bin also counts 0, the last
 * everything larger. */
enum {
    TALLY_BINS = 56,
    TALLY_FIRST_POWER = -36
};

enum {
    TALLY_EXTRAS = 3
};

typedef struct {
    const char *stage, *input; /* "clip", "scene" and so on */
    const char *unit, *measure, *bound;
    uint64_t samples;
    double max, sum;
    uint64_t beyond_bound; /* samples beyond the bound of docs/accuracy.md */
    uint64_t mismatched;   /* the two sides gave results of different kinds */
    uint64_t bins[TALLY_BINS];
    const char *extra_names[TALLY_EXTRAS]; /* more maxima; null where there are none */
    double extras[TALLY_EXTRAS];
} stages_tally;

void stages_count(stages_tally *tally, double difference, int within_bound);
void stages_extra(stages_tally *tally, int which, double difference);

/* Prints the tally as one JSON object on stdout. */
void stages_print(const stages_tally *tally);

/* The tally of each stage, empty and without an input. */
extern const stages_tally stages_sphere_tally;
extern const stages_tally stages_clip_tally;
extern const stages_tally stages_clip_world_tally;
extern const stages_tally stages_transform_tally;
extern const stages_tally stages_project_tally;
extern const stages_tally stages_list_tally;
extern const stages_tally stages_fill_tally;
extern const stages_tally stages_cover_tally;
extern const stages_tally stages_split_tally;
extern const stages_tally stages_light_tally;
extern const stages_tally stages_placement_tally;

/* Tests a sphere on both sides. Returns the result of the library. */
uint32_t stages_measure_sphere(stages_tally *tally, const fxl_camera *camera,
                               const fxl_view_frustum *frustum, const fxl_point *centre,
                               fxl_q16_16 radius);

/* Tests an instance's box on both sides; the results must be equal. Returns the result. */
uint32_t stages_measure_box(stages_tally *tally, const fxl_frustum *frustum, const fxl_scene *scene,
                            const fxl_instance *instance);

/* Checks a face of an instance against the `planes` that the library's sphere or box test
 * returned, by the reference renderer's distances of its vertices. A contradiction is a
 * mismatch. */
void stages_check_left_out(stages_tally *tally, const fxl_camera *camera,
                           const fxl_view_frustum *frustum, uint32_t planes,
                           const fxl_polygon *polygon);

/* Clips plane by plane. Before each plane both sides start from the library's polygon, so that
 * one plane's rounding is not counted for the next. Samples are the vertices that a plane made.
 * *polygon becomes the result. Returns false where nothing is left. The first function tests the
 * clipper in the view, the second the clipper in the world. The first skips a plane that a
 * vertex lies inside of by less than 2^-46: there the library's result, that the vertex is on
 * the plane, is as good as the reference renderer's. */
int stages_measure_clip(stages_tally *tally, const fxl_view_frustum *frustum,
                        fxl_view_polygon *polygon);
int stages_measure_clip_world(stages_tally *tally, const fxl_frustum *frustum,
                              fxl_polygon *polygon);

/* Compares the library's frustum in the view with that of the reference renderer. If a component
 * of a normal is more than 1.5 units of 2^-30 off, or a depth or the inset is off at all, the
 * clipper's input differs, and that is a mismatch. */
void stages_check_view_frustum(stages_tally *clip, const fxl_lens *lens,
                               const fxl_view_frustum *frustum);

void stages_measure_transform(stages_tally *tally, const fxl_camera *camera, const fxl_point *point,
                              fxl_view_point *view);

/* Returns false where the library refused the point. */
int stages_measure_project(stages_tally *tally, const fxl_lens *lens, const fxl_view_point *view,
                           fxl_screen_point *screen);

/* Appends a frame's polygons to both lists; the library's has this many words. Compares the
 * polygons that each returns for the wanted rows. Samples are the polygons' rows. */
void stages_measure_list(stages_tally *tally, const fxl_screen_polygon *polygons, uint32_t count,
                         uint16_t height, uint32_t words, fxl_rows wanted);

/* Counts the pixels of one polygon within a band that differ. The band's pixels must be 0 and
 * are 0 again afterwards. */
void stages_measure_fill(stages_tally *tally, const fxl_screen_polygon *polygon,
                         const fxl_band *band);

/* Draws polygons front to back through a span buffer of this many intervals, for rows of a
 * screen. It ends where the pool is full. Samples are the polygons. */
void stages_measure_cover(stages_tally *tally, const fxl_screen_polygon *polygons, uint32_t count,
                          uint16_t width, fxl_rows rows, uint32_t intervals);

/* Splits a piece of the world on both sides. Samples are the parts. */
void stages_measure_split(stages_tally *tally, const fxl_plane *plane, const split_piece *piece);

/* Splits a random face by one or two random beams on both sides. Samples are the pieces. */
void stages_measure_light(stages_tally *tally, stages_random *random);

/* Looks at a random vertex of a random turned instance on both sides. */
void stages_measure_placement(stages_tally *tally, stages_random *random);

#endif
