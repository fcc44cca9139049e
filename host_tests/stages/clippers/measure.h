/* SPDX-License-Identifier: MIT */
/* Each clipper of the family against the twin, given the same polygon: how far apart two outlines on the
 * screen are. */
#ifndef CLIPPERS_MEASURE_H
#define CLIPPERS_MEASURE_H

#include "draw/stages.h"
#include "fixel/all.h"
#include "reference/clip.h"
#include "stages/bridge.h"
#include "stages/random.h"

enum {
    OUTLINE_MAX = REF_VOLUME_CAPACITY
};

/* In pixels. */
typedef struct {
    int count;
    long double x[OUTLINE_MAX], y[OUTLINE_MAX];
} outline;

/* The volume of a lens. */
static inline void volume_of(const fxl_lens *lens, uint32_t screen, fxl_volume *volume)
{
    fxl_view_frustum sides;
    fxl_view_frustum_from_lens(lens, &sides);
    fxl_volume_from_sides(&sides, lens->focal, screen, volume);
}

outline outline_of_screen(const fxl_screen_point *points, int count);

/* x = centre + x_factor X / Z, y = centre - y_factor Y / Z. */
outline outline_of_volume(const ref_volume_polygon *polygon, double half_width, double half_height,
                          double x_factor, double y_factor);

/* The largest distance of a vertex of the one from the other's outline, both ways,
 * in units of 1/65536 pixel. */
double outline_distance(const outline *a, const outline *b);

/* How far a point lies beyond the worst of a convex outline's edges, prolonged; in
 * units. At the tip of a wedge that is less than to the outline. */
double outline_beyond(const outline *of, long double x, long double y);

/* In pixels. */
double outline_length(const outline *of);

/* In square pixels; negative where it goes the other way round. */
double outline_area(const outline *of);

/* --- cases -------------------------------------------------------------------- */

/* A convex, flat polygon of the world; where it is seen from, and through what. */
typedef struct {
    fxl_camera camera;
    fxl_lens lens;
    fxl_polygon polygon;
    bool convex; /* each vertex turns the outline the same way */
} clipper_case;

typedef struct {
    const char *clipper;
    double claimed;           /* largest distance of outlines in docs/extras/clippers.md */
    uint64_t cut;             /* polygons that a plane cut and that are seen */
    uint64_t beyond;          /* of those, outlines further apart than claimed */
    uint64_t parallel;        /* of those beyond: nearly parallel to a plane that cut them */
    uint64_t verdicts;        /* twin and library disagree about there being anything to see */
    uint64_t refused;         /* by the capacity */
    uint64_t crossings, made; /* intersections; vertices that are none of the input's */
    uint64_t plain_crossings, plain_made; /* the same where no corner is enclosed */
    double moved;                         /* the sum of all distances */
    double outline;                       /* largest distance, those nearly parallel left out */
    double at_all;                        /* largest distance */
    double carried;                       /* what rides along, in 1/65536 */
} clipper_tally;

/* place clipper: the error of each clipper against the reference */
/* Each counts one case. */
void measure_normalised(clipper_tally *tally, const clipper_case *of);
/* A face is flat to within units, and so are its corners: a triangle is flat. */
void measure_once(clipper_tally *tally, const clipper_case *of);
void measure_once_triangle(clipper_tally *tally, const clipper_case *of);
/* With the sliver rule at 1/256 of a unit: what it saves and what it moves. */
void measure_sliver(clipper_tally *tally, const clipper_case *of);
void measure_half_spaces(clipper_tally *tally, const clipper_case *of);
void measure_near_and_guard(clipper_tally *tally, const clipper_case *of);
void measure_left_and_guard(clipper_tally *tally, const clipper_case *of);

/* The pieces of a triangle against the screen's borders without their inset: no piece
 * reaches further out, no corner is missed, and the areas are the same. */
void measure_triangle(clipper_tally *tally, const clipper_case *of);

/* Lines, in a lopsided frustum: outline is an end's distance from the line and at_all
 * from the volume, both in units of 2^-46. */
void measure_line_by_planes(clipper_tally *tally, const clipper_case *of);
void measure_line_by_codes(clipper_tally *tally, const clipper_case *of);

/* A line and a plane through three vertices: at_all is the common point's distance from the twin's,
 * in units of 2^-46 a coordinate, and outline the same. */
void measure_line_and_plane(clipper_tally *tally, const clipper_case *of);

/* The plane through three vertices: outline is the error of a component of its normal, in units of
 * 2^-30. */
void measure_plane_from_points(clipper_tally *tally, const clipper_case *of);

/* The polygon as a map seen from above, and a rectangle about some of it. */
void measure_rectangle(clipper_tally *tally, const clipper_case *of);

/* The vertices of a case, exact, along right, up and forward. The first three
 * numbers that ride along are the vertex's own place in the world. */
ref_volume_polygon case_seen(const clipper_case *of);
void case_carry(const clipper_case *of, int vertex, fxl_varying_vertex *into);

/* How far what rides along is from where the vertex lies, in 1/65536. */
double case_carried_error(const clipper_case *of, const fxl_varying_vertex *vertex, double x,
                          double y, double z);

/* The twin's answer on the screen; false where nothing is seen. *parallel: whether
 * the polygon is nearly parallel to a plane that cuts it. */
bool case_expected(const clipper_case *of, const ref_half_space *planes, outline *expected,
                   bool *parallel);
/* The same for a polygon that is seen so. */
bool case_expected_of(const ref_volume_polygon *seen, const fxl_lens *lens,
                      const ref_half_space *planes, outline *expected, bool *parallel);

/* Counts the library's outline, null where there is none, against the twin's. */
void case_compare(clipper_tally *tally, const outline *got, const outline *expected, bool parallel);

#endif
