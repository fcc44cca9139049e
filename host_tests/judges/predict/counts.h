/* SPDX-License-Identifier: MIT */
/* What the library did in a frame: calls of its functions, and how much each was given. */
#ifndef PREDICT_COUNTS_H
#define PREDICT_COUNTS(X) \
    X(frames) \
    X(instances) \
    X(instances_seen) \
    X(instances_viewed) \
    X(instances_passed) \
    X(turned_checked) \
    X(turned_viewed) \
    X(faces_tested) \
    X(faces_facing) \
    X(faces_sorted) \
    X(faces_clipped) \
    X(faces_outside) \
    X(faces_between) \
    X(corners) \
    X(vertices) \
    X(projections) \
    X(assembled) \
    X(cut_edges) \
    X(list_polygons) \
    X(list_words) \
    X(list_reads) \
    X(list_scanned) \
    X(spilled_faces) \
    X(row_searches) \
    X(polygons) \
    X(polygons_drawn) \
    X(trapezoids) \
    X(edges) \
    X(rows) \
    X(pixels) \
    X(bands) \
    X(cleared) \
    X(brightnesses) \
    X(lamps) \
    X(in_fog) \
    X(surfaces_found) \
    X(surfaces_listed) \
    X(surfaces_read) \
    X(surfaces_painted) \
    X(painted_edges) \
    X(painted_rows) \
    X(segment_rows) \
    X(segments) \
    X(segment_pixels) \
    X(lit_segments) \
    X(lit_segment_pixels) \
    X(slow_rows) \
    X(slow_segments) \
    X(slow_pixels) \
    X(loop_pixels) \
    X(divided_pixels)

typedef struct {
#define X(name) double name;
    PREDICT_COUNTS(X)
#undef X
} predict_counts;

/* Of the frame under way. */
extern predict_counts counted;

#endif
