/* SPDX-License-Identifier: MIT */
/* hidden SCENE.fxls [--frames N] [--seed S] [--tree 1]
 *
 * Draws frames of a scene's path, N of them evenly spread, painted far to near, in the order by
 * distance or by the scene's tree, in the light of its beams if it has any, and then by the span
 * buffer: in whole frames and bands of any height, with lists and pools of any size, by both scans.
 * Prints how many pixels differ, and how often pixels were written, as JSON. Exit code 0: it ran;
 * 2: it could not. */
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "painters.h"
#include "frames/input.h"
#include "frames/session.h"
#include "path.h"
#include "study/clippers.h"
#include "study/targets.h"
#include "study/span_buffer.h"

enum {
    BACKGROUND = 0,
    OTHERS = 24,                 /* ways beside the painter's, for each frame */
    PLENTY = 1u << 20,           /* words of a list that holds any frame here */
    INTERVALS = FXL_COVERED_END, /* of the largest pool */
    CACHE = 256,
    PIECES = 1 << 20 /* bytes, for what moves about in a tree */
};

typedef struct {
    uint64_t frames, draws, covered, drawn;
    uint64_t differing;  /* pixels */
    uint64_t miscounted; /* draws whose counters are not the painter's */
    uint64_t in_bands, with_small_list, with_least_pool, by_box;
    uint64_t split_draws, split_bands; /* draws in which a band was split; how often */
    uint64_t counted_draws, counted_writes, counted_covered, most_writes;
} tally;

/* How a frame is drawn. */
typedef struct {
    session_settings settings;
    uint32_t rows;
} way;

typedef struct {
    session run;
    uint32_t width, height;
    uint8_t *frames[2], *covered, *writes;
    uint64_t seed;
    bool bsp;
} comparison;

/* splitmix64, public domain: below `end`. */
static uint32_t any(comparison *with, uint32_t end)
{
    uint64_t z = with->seed += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return (uint32_t)((z ^ z >> 31) >> 32) % end;
}

/* False if the library refuses what it must not refuse. */
static bool draw(comparison *with, const way *by, const fxl_pose *pose, uint8_t background,
                 uint8_t *frame, fxl_counters *counters)
{
    if (session_set_up(&with->run, &by->settings) != FXL_OK ||
        session_draw(&with->run, pose, by->rows, background, frame) != FXL_OK) {
        return false;
    }
    *counters = with->run.renderer.workspace.counters;
    return true;
}

/* No display list; where there is one, what any_way says. */
static session_settings settings_of(const comparison *with, const fxl_target *target,
                                    const fxl_clipper *clipper)
{
    return (session_settings){.without_surfaces = true,
                              .clipper = clipper,
                              .order = with->bsp ? &fxl_by_tree : &fxl_by_distance,
                              .target = target,
                              .cache_entries = CACHE,
                              .pieces_bytes = PIECES};
}

static way any_way(comparison *with, const fxl_clipper *clipper, uint32_t number, tally *to)
{
    const uint32_t least = FXL_SPAN_BUFFER_BYTES_LEAST(with->width, with->height);
    const uint32_t most = FXL_SPAN_BUFFER_BYTES(with->height, INTERVALS);
    way by = {.settings = settings_of(with, &fxl_palette_spans, clipper)};
    if (number == 0) { /* each pixel counted as it is written */
        by.settings.target =
            counted_begin(with->writes, with->frames[1], with->width * with->height)->target;
    } else if (number == 1) {
        by.settings.target = &fxl_palette_spans_box;
    }
    uint32_t list = any(with, 3), pool = number == 0 ? 2 : any(with, 3), bands = any(with, 4);
    by.settings.display_list_words = list == 0 ? 0 : list == 1 ? any(with, 4000) : PLENTY;
    by.settings.raster_bytes = pool == 0   ? least
                               : pool == 1 ? least + any(with, 12 * with->height)
                                           : most;
    by.rows = bands == 0   ? with->height
              : bands == 1 ? 1 + any(with, with->height)
              : bands == 2 ? 8
                           : 1 + any(with, 40);
    to->in_bands += by.rows < with->height;
    to->with_small_list += list == 1;
    to->with_least_pool += pool == 0;
    to->by_box += number == 1;
    return by;
}

static void count_writes(const comparison *with, const fxl_counters *counters, tally *to)
{
    if (counters->split_bands > 0) {
        return; /* then some are written again, as stated */
    }
    to->counted_draws++;
    for (uint32_t i = 0; i < with->width * with->height; i++) {
        to->counted_writes += with->writes[i];
        to->counted_covered += with->covered[i];
        to->most_writes = with->writes[i] > to->most_writes ? with->writes[i] : to->most_writes;
    }
}

static bool take_frame(comparison *with, const fxl_pose *pose, tally *to)
{
    const fxl_clipper *clipper = to->frames % 4 == 3 ? &fxl_clipper_world : &fxl_clipper_view;
    const way painted = {.settings = settings_of(with, &fxl_palette, clipper),
                         .rows = with->height};
    const uint32_t pixels = with->width * with->height;
    fxl_counters expected, found;
    if (!draw(with, &painted, pose, BACKGROUND, with->frames[0], &expected)) {
        return false;
    }
    to->frames++;
    to->drawn += expected.drawn;
    /* Covered is what no background shows through. */
    if (!draw(with, &painted, pose, BACKGROUND + 1, with->frames[1], &found)) {
        return false;
    }
    for (uint32_t i = 0; i < pixels; i++) {
        with->covered[i] = with->frames[0][i] == with->frames[1][i];
        to->covered += with->covered[i];
    }
    for (uint32_t number = 0; number < OTHERS; number++) {
        const way by = any_way(with, clipper, number, to);
        if (!draw(with, &by, pose, BACKGROUND, with->frames[1], &found)) {
            return false;
        }
        to->draws++;
        to->split_draws += found.split_bands > 0;
        to->split_bands += found.split_bands;
        for (uint32_t i = 0; i < pixels; i++) {
            to->differing += with->frames[0][i] != with->frames[1][i];
        }
        if (number == 0) {
            count_writes(with, &found, to);
        }
        found.split_bands = 0;
        found.spilled = expected.spilled;
        to->miscounted += memcmp(&expected, &found, sizeof found) != 0;
    }
    return true;
}

static void print(const tally *of)
{
    const struct {
        const char *name;
        uint64_t value;
    } all[] = {{"frames", of->frames},
               {"draws", of->draws},
               {"drawn", of->drawn},
               {"covered", of->covered},
               {"differing", of->differing},
               {"miscounted", of->miscounted},
               {"in_bands", of->in_bands},
               {"with_small_list", of->with_small_list},
               {"with_least_pool", of->with_least_pool},
               {"by_box", of->by_box},
               {"split_draws", of->split_draws},
               {"split_bands", of->split_bands},
               {"counted_draws", of->counted_draws},
               {"counted_covered", of->counted_covered},
               {"counted_writes", of->counted_writes},
               {"most_writes", of->most_writes}};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        printf("%c\"%s\": %" PRIu64, i == 0 ? '{' : ',', all[i].name, all[i].value);
    }
    puts("}");
}

static void reserve(comparison *with)
{
    session_settings most = settings_of(with, &fxl_palette_spans, &fxl_clipper_view);
    with->width = with->run.image.lens.width;
    with->height = with->run.image.lens.height;
    const size_t pixels = (size_t)with->width * with->height;
    most.display_list_words = PLENTY;
    most.raster_bytes = FXL_SPAN_BUFFER_BYTES(with->height, INTERVALS);
    session_reserve(&with->run, &most);
    with->frames[0] = session_memory(pixels);
    with->frames[1] = session_memory(pixels);
    with->writes = session_memory(pixels);
    with->covered = session_memory(pixels);
}

static int run(const char *path, uint32_t frames, uint64_t seed, bool bsp)
{
    static comparison with;
    const fxl_scene_image *image = &with.run.image;
    const char *wrong = session_open(&with.run, path);
    if (wrong) {
        return fail(path, wrong);
    }
    if (bsp && image->scene.bsp_nodes == NULL) {
        return fail(path, "it has no BSP tree");
    }
    with.seed = seed;
    with.bsp = bsp;
    reserve(&with);
    tally found = {0};
    walk_path walked;
    walk_path_begin(&walked, image, false);
    for (uint32_t number = 0; number < image->frame_count; number++) {
        if (walk_path_next(&walked, 0) != FXL_OK) {
            return fail(path, "its path leaves the world");
        }
        session_play(&with.run, number);
        /* The frames-th part that this frame opens: of all as many as were asked for. */
        bool taken = (uint64_t)number * frames / image->frame_count !=
                     ((uint64_t)number + 1) * frames / image->frame_count;
        if (taken && !take_frame(&with, &walked.viewer.pose, &found)) {
            return fail(path, "a frame was refused");
        }
    }
    print(&found);
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : fail("stdout", strerror(errno));
}

int main(int count, char **arguments)
{
    const char *scene;
    uint32_t frames = 20, seed = 1, tree = 0;
    const argument known[] = {{"--frames", take_number, &frames},
                              {"--seed", take_number, &seed},
                              {"--tree", take_number, &tree}};
    if (!read_arguments(count, arguments, known, sizeof known / sizeof *known, &scene, 1)) {
        return fail("usage", "hidden SCENE.fxls [--frames N] [--seed S] [--tree 1]");
    }
    return run(scene, frames, seed, tree != 0);
}
