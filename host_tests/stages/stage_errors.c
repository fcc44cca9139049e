/* SPDX-License-Identifier: MIT */
/* stage_errors [SCENE.fxls] [--samples N] [--seed S]
 *
 * Feeds every stage of the library and of the reference renderer the same input, from a scene
 * along its path and at random. Prints how far the results differ, as JSON. Exit code 0: it ran;
 * 2: it could not. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "draw/stages.h"
#include "fixel/all.h"
#include "frames/input.h"
#include "stages/measure.h"
#include "stages/random.h"

enum {
    FRAMES_MAX = 240, /* of a longer path, frames at equal steps are taken */
    FILL_SHARE = 20,  /* a filled polygon costs about as much as this many points */
    RANDOM_SCREEN_MAX = 1024 * 1024,
    COVERED_MAX = 24, /* polygons through a span buffer */
    COVERED_ROWS =
        6,           /* and rows: the reference renderer tests every pixel of them for every span */
    LISTED_MAX = 256 /* polygons of a frame that are appended to the list: the last ones */
};

typedef struct {
    const char *scene;
    uint64_t samples, seed;
} options;

typedef struct {
    stages_tally sphere, clip, clip_world, transform, project, list, fill, cover, split, light,
        placement;
} tallies;

static uint8_t pixels[RANDOM_SCREEN_MAX]; /* all 0 between two polygons */
static fxl_screen_polygon listed[LISTED_MAX];
static uint32_t listed_count;

enum {
    TALLIES = 11
};

static void list_tallies(tallies *of, stages_tally *all[TALLIES])
{
    stages_tally *const in_order[TALLIES] = {
        &of->sphere, &of->clip,  &of->clip_world, &of->transform, &of->project,  &of->list,
        &of->fill,   &of->cover, &of->split,      &of->light,     &of->placement};
    memcpy(all, in_order, sizeof in_order);
}

static tallies tallies_for(const char *input)
{
    tallies made = {stages_sphere_tally,    stages_clip_tally,     stages_clip_world_tally,
                    stages_transform_tally, stages_project_tally,  stages_list_tally,
                    stages_fill_tally,      stages_cover_tally,    stages_split_tally,
                    stages_light_tally,     stages_placement_tally};
    stages_tally *all[TALLIES];
    list_tallies(&made, all);
    for (int i = 0; i < TALLIES; i++) {
        all[i]->input = input;
    }
    return made;
}

static void progress(const char *what, uint64_t done, uint64_t all)
{
    static time_t reported;
    time_t now = time(NULL);
    if (reported == 0) {
        reported = now;
    }
    if (now - reported >= 2) {
        reported = now;
        fprintf(stderr, "stage_errors: %s %llu of %llu\n", what, (unsigned long long)done,
                (unsigned long long)all);
    }
}

/* What the stages of a frame share. */
static int view_from(const fxl_pose *pose, const fxl_lens *lens, fxl_view *view)
{
    fxl_view_set_lens(view, lens);
    if (fxl_view_set_pose(view, pose) != FXL_OK) {
        return 0;
    }
    fxl_view_set_world_frustum(view);
    return 1;
}

/* Transforms every vertex into the view. */
static void take_vertices(stages_tally *transform, const fxl_camera *camera,
                          const fxl_polygon *polygon, fxl_view_polygon *seen)
{
    seen->colour = polygon->colour;
    seen->count = polygon->count;
    for (int i = 0; i < polygon->count; i++) {
        const fxl_vertex *vertex = &polygon->vertices[i];
        stages_measure_transform(transform, camera, &vertex->position, &seen->vertices[i].position);
    }
}

/* Clips by the planes of the frustum in the world, and by one plane through a vertex. */
static void take_split(stages_tally *split, const fxl_frustum *frustum, const fxl_polygon *polygon)
{
    split_piece piece = {.count = polygon->count};
    for (uint32_t i = 0; i < piece.count; i++) {
        piece.points[i] = polygon->vertices[i].position;
    }
    for (int i = 0; i < FXL_PLANE_COUNT; i++) {
        fxl_plane through = fxl_plane_from_point(&piece.points[0], &frustum->planes[i].normal, 0);
        stages_measure_split(split, &frustum->planes[i], &piece);
        stages_measure_split(split, &through, &piece);
    }
}

/* Takes one polygon through the library's stages, and measures every one; also takes it through
 * the clipper in the world. */
static void take_polygon(tallies *to, const fxl_view *view, fxl_polygon *polygon)
{
    fxl_view_polygon seen;
    take_vertices(&to->transform, &view->camera, polygon, &seen);
    take_split(&to->split, &view->frustum, polygon);
    stages_measure_clip_world(&to->clip_world, &view->frustum, polygon);
    if (!stages_measure_clip(&to->clip, &view->view_frustum, &seen)) {
        return;
    }
    fxl_screen_polygon screen = {.colour = seen.colour, .count = seen.count};
    const fxl_lens drawn = fxl_view_drawn_lens(view);
    for (int i = 0; i < seen.count; i++) {
        if (!stages_measure_project(&to->project, &drawn, &seen.vertices[i].position,
                                    &screen.points[i])) {
            return;
        }
    }
    listed[listed_count++ % LISTED_MAX] = screen;
    fxl_band band = {.pixels = pixels,
                     .width = view->lens.width,
                     .stride = view->lens.width,
                     .first_row = 0,
                     .rows = view->lens.height};
    stages_measure_fill(&to->fill, &screen, &band);
}

/* Puts the polygons into a list that is mostly too small, for some band, and some of them
 * through a span buffer, for a few rows of the band. */
static void take_list(tallies *to, stages_random *random, uint16_t width, uint16_t height)
{
    uint32_t count = listed_count < LISTED_MAX ? listed_count : LISTED_MAX;
    uint32_t words = stages_random_below(random, count * FXL_DISPLAY_LIST_WORDS(6) + 1);
    fxl_rows wanted = {(uint16_t)stages_random_below(random, height), height};
    wanted.end =
        (uint16_t)(wanted.first + 1 + stages_random_below(random, (uint32_t)height - wanted.first));
    stages_measure_list(&to->list, listed, count, height, words, wanted);
    if (wanted.end - wanted.first > COVERED_ROWS) {
        wanted.end = (uint16_t)(wanted.first + COVERED_ROWS);
    }
    stages_measure_cover(&to->cover, listed, count < COVERED_MAX ? count : COVERED_MAX, width,
                         wanted, 1 + stages_random_below(random, 8 * COVERED_ROWS));
    listed_count = 0;
}

static void take_frame(tallies *to, const fxl_scene_image *image, const fxl_pose *pose)
{
    const fxl_scene *scene = &image->scene;
    fxl_view view;
    if (!view_from(pose, &image->lens, &view)) {
        return;
    }
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const fxl_instance *instance = &scene->instances[i];
        const fxl_model *model = &scene->models[instance->model];
        fxl_cached_vertex none;
        fxl_vertex_cache cache;
        fxl_model_view model_view;
        fxl_vertex_cache_init(&cache, &none, 1);
        fxl_model_view_of_instance(&model_view, scene, instance, &view, &cache);
        uint32_t planes = stages_measure_sphere(&to->sphere, &view.camera, &view.view_frustum,
                                                &instance->centre, model->radius);
        uint32_t by_box = stages_measure_box(&to->sphere, &view.frustum, scene, instance);
        for (uint32_t k = 0; k < model->face_count; k++) {
            const fxl_face *face = &scene->faces[model->first_face + k];
            fxl_polygon polygon;
            fxl_face_to_polygon(&model_view, face, &polygon);
            stages_check_left_out(&to->sphere, &view.camera, &view.view_frustum, planes, &polygon);
            stages_check_left_out(&to->sphere, &view.camera, &view.view_frustum, by_box, &polygon);
            if (fxl_face_is_front(scene, instance, face, &pose->position)) {
                take_polygon(to, &view, &polygon);
            }
        }
    }
    stages_random random = stages_random_start(listed_count, (uint32_t)pose->position.x);
    take_list(to, &random, image->lens.width, image->lens.height);
}

static void take_path(tallies *to, const fxl_scene_image *image)
{
    fxl_player viewer = image->start;
    uint32_t every = 1 + (image->frame_count - 1) / FRAMES_MAX;
    uint32_t stride = 0, done = 0; /* frames of this segment */
    for (uint32_t frame = 0; frame < image->frame_count; frame++) {
        fxl_pose pose;
        if (image->poses) {
            pose = image->poses[frame];
        } else {
            if (done == image->segments[stride].frames) {
                stride++;
                done = 0;
            }
            fxl_player_step(&viewer, image->segments[stride].keys, &image->motion_limits, NULL);
            done++;
            pose = viewer.pose;
        }
        if (frame % every == 0) {
            take_frame(to, image, &pose);
            progress("frame", frame, image->frame_count);
        }
    }
}

/* Returns 0, or 2 after it said why. */
static int take_scene(tallies *to, const char *path)
{
    size_t size;
    uint8_t *memory = read_file(path, &size);
    if (!memory) {
        return fail(path, "it cannot be read");
    }
    fxl_scene_image image;
    fxl_scene_fault fault;
    fxl_status status = fxl_scene_open(memory, size, &image, &fault);
    if (status == FXL_OK) {
        take_path(to, &image);
    }
    free(memory);
    return status == FXL_OK ? 0 : fail(path, fxl_status_text(status));
}

/* Gives both clippers the same polygon; sometimes one with a vertex exactly on a plane. A side
 * plane of the view passes exactly through almost no integer point, so in the view that plane is
 * near or far. */
static void take_random_polygon(tallies *to, stages_random *random)
{
    fxl_pose pose = stages_random_pose(random);
    fxl_lens lens = stages_random_moved_lens(random);
    fxl_view view;
    if (!view_from(&pose, &lens, &view)) {
        to->clip.mismatched++; /* every random pose is in range */
        return;
    }
    if (lens.off_centre == NULL) {
        stages_check_view_frustum(&to->clip, &lens, &view.view_frustum);
    }
    fxl_polygon polygon = stages_random_polygon(random, &view.camera);
    fxl_view_polygon seen = {.colour = polygon.colour, .count = polygon.count};
    for (int i = 0; i < polygon.count; i++) {
        fxl_transform_point(&view.camera, &polygon.vertices[i].position,
                            &seen.vertices[i].position);
    }
    if (stages_random_below(random, 8) == 0) {
        fxl_plane *plane = &view.frustum.planes[stages_random_below(random, FXL_PLANE_COUNT)];
        uint32_t on = stages_random_below(random, polygon.count);
        *plane = fxl_plane_from_point(&polygon.vertices[on].position, &plane->normal, 0);
        fxl_q18_46 depth = seen.vertices[on].position.z;
        if (stages_random_below(random, 2)) {
            view.view_frustum.near_z = depth;
        } else {
            view.view_frustum.far_z = depth;
        }
    }
    stages_measure_clip(&to->clip, &view.view_frustum, &seen);
    take_split(&to->split, &view.frustum, &polygon);
    stages_measure_clip_world(&to->clip_world, &view.frustum, &polygon);
}

static void take_random_sphere(stages_tally *sphere, stages_random *random)
{
    fxl_pose pose = stages_random_pose(random);
    fxl_lens lens = stages_random_moved_lens(random);
    fxl_view view;
    if (!view_from(&pose, &lens, &view)) {
        sphere->mismatched++;
        return;
    }
    fxl_point centre = stages_random_point(random, &pose.position);
    fxl_q16_16 radius = stages_random_radius(random, &view.camera, &view.view_frustum, &centre);
    stages_measure_sphere(sphere, &view.camera, &view.view_frustum, &centre, radius);
}

static void take_random_points(tallies *to, stages_random *random)
{
    fxl_pose pose = stages_random_pose(random);
    fxl_camera camera;
    if (fxl_camera_from_pose(&pose, &camera) != FXL_OK) {
        to->transform.mismatched++;
        return;
    }
    fxl_point point = stages_random_point(random, &pose.position);
    fxl_view_point view;
    stages_measure_transform(&to->transform, &camera, &point, &view);

    fxl_lens lens = stages_random_lens(random);
    fxl_screen_point screen;
    view = stages_random_view_point(random, &lens);
    stages_measure_project(&to->project, &lens, &view, &screen);
}

/* A band at a random place, on a screen that is mostly small. */
static void take_random_outline(stages_tally *fill, stages_random *random)
{
    uint32_t large = stages_random_below(random, 64) == 0 ? FXL_SCREEN_MAX : 48;
    uint16_t width = (uint16_t)(1 + stages_random_below(random, large));
    uint16_t height = (uint16_t)(1 + stages_random_below(random, large));
    fxl_band band = {
        .pixels = pixels, .width = width, .stride = width, .first_row = 0, .rows = height};
    band.first_row = (uint16_t)stages_random_below(random, height);
    band.rows = (uint16_t)(1 + stages_random_below(random, (uint32_t)height - band.first_row));
    fxl_screen_polygon outline = stages_random_outline(random, width, height);
    stages_measure_fill(fill, &outline, &band);
}

static void take_random_list(tallies *to, stages_random *random)
{
    uint16_t width = (uint16_t)(1 + stages_random_below(random, FXL_SCREEN_MAX));
    uint16_t height = (uint16_t)(1 + stages_random_below(random, FXL_SCREEN_MAX));
    for (uint32_t left = 1 + stages_random_below(random, FILL_SHARE); left > 0; left--) {
        listed[listed_count] = stages_random_outline(random, width, height);
        listed[listed_count++].colour = (uint8_t)stages_random_below(random, 256);
    }
    take_list(to, random, width, height);
}

static void take_random(tallies *to, const options *wanted)
{
    /* Each stage has a shard of its own, so its input does not depend on another's. */
    stages_random polygons = stages_random_start(wanted->seed, 1);
    stages_random points = stages_random_start(wanted->seed, 2);
    stages_random outlines = stages_random_start(wanted->seed, 3);
    stages_random lists = stages_random_start(wanted->seed, 4);
    stages_random spheres = stages_random_start(wanted->seed, 5);
    stages_random lights = stages_random_start(wanted->seed, 6);
    stages_random placements = stages_random_start(wanted->seed, 7);
    for (uint64_t i = 0; i < wanted->samples; i++) {
        stages_measure_placement(&to->placement, &placements);
        stages_measure_light(&to->light, &lights);
        take_random_polygon(to, &polygons);
        take_random_points(to, &points);
        take_random_sphere(&to->sphere, &spheres);
        if (i % FILL_SHARE == 0) {
            take_random_outline(&to->fill, &outlines);
            take_random_list(to, &lists);
        }
        progress("random sample", i, wanted->samples);
    }
}

static void print_tallies(tallies *of, const char *end)
{
    stages_tally *all[TALLIES];
    list_tallies(of, all);
    for (int i = 0; i < TALLIES; i++) {
        stages_print(all[i]);
        puts(i < TALLIES - 1 ? "," : end);
    }
}

int main(int count, char **arguments)
{
    options wanted = {.samples = 200000, .seed = 1};
    const argument known[] = {{"--samples", take_count, &wanted.samples},
                              {"--seed", take_count, &wanted.seed}};
    if (!read_arguments(count, arguments, known, 2, &wanted.scene, 1) &&
        !read_arguments(count, arguments, known, 2, NULL, 0)) {
        return fail("usage", "stage_errors [SCENE.fxls] [--samples N] [--seed S]");
    }
    tallies scene = tallies_for("scene"), random = tallies_for("random");
    if (wanted.scene && take_scene(&scene, wanted.scene) != 0) {
        return 2;
    }
    take_random(&random, &wanted);
    printf("{\"seed\": %llu, \"stages\": [\n", (unsigned long long)wanted.seed);
    if (wanted.scene) {
        print_tallies(&scene, ",");
    }
    print_tallies(&random, "");
    printf("]}\n");
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : fail("stdout", strerror(errno));
}
