/* SPDX-License-Identifier: MIT */
/* Each stage fed the same input on both sides of its boundary. */
#ifndef STAGES_MEASURE_H
#define STAGES_MEASURE_H

#include "fixel/all.h"
#include "stages/random.h"
#include "stages/tally.h"

/* The tally of each stage, named and empty. */
stages_tally stages_sphere_tally(const char *input);
stages_tally stages_clip_tally(const char *input);
stages_tally stages_clip_world_tally(const char *input);
stages_tally stages_transform_tally(const char *input);
stages_tally stages_project_tally(const char *input);
stages_tally stages_list_tally(const char *input);
stages_tally stages_fill_tally(const char *input);
stages_tally stages_cover_tally(const char *input);
stages_tally stages_split_tally(const char *input);
stages_tally stages_light_tally(const char *input);

/* A sphere on both sides; answers what the library does. */
uint32_t stages_measure_sphere(stages_tally *tally, const fxl_camera *camera,
                               const fxl_view_frustum *frustum, const fxl_point *centre,
                               fxl_q16_16 radius);

/* An object's box on both sides: the same answer, which it gives. */
uint32_t stages_measure_box(stages_tally *tally, const fxl_frustum *frustum, const fxl_scene *scene,
                            const fxl_instance *instance);

/* A face of an object of which the library's sphere or box said `planes`, by the twin's
 * distances of its vertices. Where it is not so, a mismatch. */
void stages_check_left_out(stages_tally *tally, const fxl_camera *camera,
                           const fxl_view_frustum *frustum, uint32_t planes,
                           const fxl_polygon *polygon);

/* Clips plane by plane; before each plane both sides start from the library's
 * polygon, so that one plane's rounding is not counted for the next. Samples
 * are the vertices that a plane made. *polygon becomes what is left; false
 * where nothing is. The first is the view's clipper, the second the world's. The
 * first leaves out a plane that a vertex lies inside of by less than 2^-46: there
 * the library's verdict, on the plane, is as good as the twin's. */
int stages_measure_clip(stages_tally *tally, const fxl_view_frustum *frustum,
                        fxl_view_polygon *polygon);
int stages_measure_clip_world(stages_tally *tally, const fxl_frustum *frustum,
                              fxl_polygon *polygon);

/* The library's frustum of the view against the twin's of the same lens: where a
 * component of a normal is more than 1.5 units of 2^-30 off, or a depth or the
 * inset at all, the clip's input was another, and that is a mismatch. */
void stages_check_view_frustum(stages_tally *clip, const fxl_lens *lens,
                               const fxl_view_frustum *frustum);

void stages_measure_transform(stages_tally *tally, const fxl_camera *camera, const fxl_point *point,
                              fxl_view_point *view);

/* False where the library refused the point. */
int stages_measure_project(stages_tally *tally, const fxl_lens *lens, const fxl_view_point *view,
                           fxl_screen_point *screen);

/* A frame's polygons in both lists, the library's of so many words, and what each
 * gives back for the rows wanted. Samples are the polygons' rows. */
void stages_measure_list(stages_tally *tally, const fxl_screen_polygon *polygons, uint32_t count,
                         uint16_t height, uint32_t words, fxl_rows wanted);

/* Pixels of one polygon within a band that differ. The band's pixels must be 0
 * and are 0 again afterwards. */
void stages_measure_fill(stages_tally *tally, const fxl_screen_polygon *polygon,
                         const fxl_band *band);

/* Polygons front to back through a span buffer of so many intervals, for rows of a screen;
 * it ends where the pool is full. Samples are the polygons. */
void stages_measure_cover(stages_tally *tally, const fxl_screen_polygon *polygons, uint32_t count,
                          uint16_t width, fxl_rows rows, uint32_t intervals);

/* Splits a piece of the world on both sides. Samples are the parts. */
void stages_measure_split(stages_tally *tally, const fxl_plane *plane, const fxl_piece *piece);

/* Splits a random face by one or two random beams on both sides. Samples are the pieces. */
void stages_measure_light(stages_tally *tally, stages_random *random);

#endif
