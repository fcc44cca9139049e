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

#include "counted_spans.h"
#include "path.h"

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
    const fxl_visibility *hidden;
    const fxl_clipper *clipper;
    uint32_t words, room_size, rows;
} way;

typedef struct {
    const fxl_scene_image *image;
    uint32_t width, height;
    uint8_t *frames[2], *covered, *writes;
    fxl_order_entry *order;
    fxl_cached_vertex *cache;
    uint32_t *list;
    void *room, *pieces, *light;
    uint32_t light_size; /* bytes: 0 where the scene has no beams */
    uint32_t walk_room;  /* bytes: what comes before the painter's room */
    uint64_t seed;
    bool tree;
} session;

static int fail(const char *what, const char *why)
{
    fprintf(stderr, "error: %s: %s\n", what, why);
    return 2;
}

/* splitmix64, public domain: below `end`. */
static uint32_t any(session *with, uint32_t end)
{
    uint64_t z = with->seed += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return (uint32_t)((z ^ z >> 31) >> 32) % end;
}

/* False where the library refuses what it should not. */
static bool draw(const session *with, const way *by, const fxl_pose *pose, uint8_t background,
                 uint8_t *frame, fxl_counters *counters)
{
    static fxl_renderer renderer;
    const fxl_scene *scene = &with->image->scene;
    const fxl_memory memory = {with->order, scene->order_needed, with->list,
                               by->words,   with->cache,         CACHE};
    if (fxl_renderer_init_with(&renderer, scene, &with->image->lens, &memory) != FXL_OK ||
        fxl_renderer_set_clipper(&renderer, by->clipper, NULL, 0) != FXL_OK ||
        fxl_renderer_set_visibility(&renderer, by->hidden, with->room, by->room_size) != FXL_OK) {
        return false;
    }
    if (with->light_size > 0 &&
        fxl_renderer_set_beams(&renderer, scene->beams, scene->beam_count, scene->lit, with->light,
                               with->light_size) != FXL_OK) {
        return false;
    }
    if (with->tree) {
        fxl_bsp_workspace *room = with->room;
        room->pieces = with->pieces;
        room->pieces_size = PIECES;
    }
    if (fxl_frame_begin(&renderer, pose) != FXL_OK) {
        return false;
    }
    for (uint32_t row = 0; row < with->height; row += by->rows) {
        uint32_t rows = row + by->rows > with->height ? with->height - row : by->rows;
        fxl_band band = {frame + (size_t)row * with->width, (uint16_t)with->width,
                         (uint16_t)with->width, (uint16_t)row, (uint16_t)rows};
        fxl_fill_band(&band, background);
        if (fxl_frame_draw(&renderer, &band) != FXL_OK) {
            return false;
        }
    }
    *counters = renderer.workspace.counters;
    return true;
}

static way any_way(session *with, const fxl_clipper *clipper, uint32_t number, tally *to)
{
    static fxl_visibility hidden;
    const uint32_t least = with->walk_room + FXL_SPAN_BUFFER_BYTES_LEAST(with->width, with->height);
    const uint32_t most = with->walk_room + FXL_SPAN_BUFFER_BYTES(with->height, INTERVALS);
    way by = {.hidden = &hidden, .clipper = clipper};
    hidden = with->tree ? fxl_visibility_bsp_spans : fxl_visibility_spans;
    if (number == 0) { /* each pixel counted as it is written */
        hidden.backend =
            counted_begin(with->writes, with->frames[1], with->width * with->height)->backend;
    } else if (number == 1) {
        hidden.backend = &fxl_raster_spans_box;
    }
    uint32_t list = any(with, 3), pool = number == 0 ? 2 : any(with, 3), bands = any(with, 4);
    by.words = list == 0 ? 0 : list == 1 ? any(with, 4000) : PLENTY;
    by.room_size = pool == 0 ? least : pool == 1 ? least + any(with, 12 * with->height) : most;
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

static void count_writes(const session *with, const fxl_counters *counters, tally *to)
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

static bool take_frame(session *with, const fxl_pose *pose, tally *to)
{
    const fxl_clipper *clipper = to->frames % 4 == 3 ? &fxl_clipper_world : &fxl_clipper_view;
    const way painted = {.hidden = with->tree ? &fxl_visibility_bsp : &fxl_visibility_sorted,
                         .clipper = clipper,
                         .room_size = with->walk_room,
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

/* Null where it cannot be read. Lives until the program ends. */
static void *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    void *bytes = NULL;
    long length = file && fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    if (length > 0 && fseek(file, 0, SEEK_SET) == 0) {
        bytes = malloc((size_t)length);
        *size = bytes ? fread(bytes, 1, (size_t)length, file) : 0;
    }
    if (file) {
        fclose(file);
    }
    return bytes;
}

static bool need(void *memory)
{
    return memory != NULL;
}

static bool open_session(session *with, const fxl_scene_image *image, uint64_t seed, bool tree)
{
    with->image = image;
    with->seed = seed;
    with->tree = tree;
    with->light_size =
        image->scene.beams != NULL
            ? fxl_beam_light_workspace_size(image->scene.beams, image->scene.beam_count)
            : 0;
    with->walk_room =
        tree ? (fxl_visibility_bsp.submit_workspace_size(&image->scene) + 7u) & ~7u : 0;
    with->width = image->lens.width;
    with->height = image->lens.height;
    const size_t pixels = (size_t)with->width * with->height;
    return need(with->frames[0] = malloc(pixels)) && need(with->frames[1] = malloc(pixels)) &&
           need(with->writes = malloc(pixels)) && need(with->covered = malloc(pixels)) &&
           need(with->order = calloc(image->scene.order_needed, sizeof *with->order)) &&
           need(with->cache = calloc(CACHE, sizeof *with->cache)) &&
           need(with->list = malloc(PLENTY * sizeof *with->list)) &&
           need(with->pieces = malloc(PIECES)) &&
           need(with->light = malloc(with->light_size + 8)) &&
           need(with->room =
                    malloc(with->walk_room + FXL_SPAN_BUFFER_BYTES(with->height, INTERVALS)));
}

static int run(const char *path, uint32_t frames, uint64_t seed, bool tree)
{
    size_t size = 0;
    void *bytes = read_file(path, &size);
    if (bytes == NULL) {
        return fail(path, "it cannot be read");
    }
    fxl_scene_image image;
    fxl_status status = fxl_scene_open(bytes, size, &image, NULL);
    if (status != FXL_OK) {
        return fail(path, fxl_status_text(status));
    }
    if (tree && image.scene.bsp_nodes == NULL) {
        return fail(path, "it has no tree");
    }
    session with;
    if (!open_session(&with, &image, seed, tree)) {
        return fail(path, "there is not enough memory");
    }
    tally found = {0};
    walk_path walked;
    walk_path_begin(&walked, &image, false);
    for (uint32_t number = 0; number < image.frame_count; number++) {
        if (walk_path_next(&walked, 0) != FXL_OK) {
            return fail(path, "its path is no path");
        }
        /* The frames-th part that this frame opens: of all as many as were asked for. */
        bool taken = (uint64_t)number * frames / image.frame_count !=
                     ((uint64_t)number + 1) * frames / image.frame_count;
        if (taken && !take_frame(&with, &walked.viewer.pose, &found)) {
            return fail(path, "a frame was refused");
        }
    }
    print(&found);
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : fail("stdout", strerror(errno));
}

static bool parse_number(const char *text, uint32_t *number)
{
    char *end;
    errno = 0;
    unsigned long value = strtoul(text, &end, 10);
    *number = (uint32_t)value;
    return *text >= '0' && *text <= '9' && *end == '\0' && errno == 0 && value <= UINT32_MAX;
}

int main(int count, char **arguments)
{
    const char *scene = NULL;
    uint32_t frames = 20, seed = 1, tree = 0;
    bool sound = true;
    for (int i = 1; i < count && sound; i++) {
        uint32_t *number = strcmp(arguments[i], "--frames") == 0 ? &frames
                           : strcmp(arguments[i], "--seed") == 0 ? &seed
                           : strcmp(arguments[i], "--tree") == 0 ? &tree
                                                                 : NULL;
        if (number != NULL) {
            sound = ++i < count && parse_number(arguments[i], number);
        } else {
            sound = scene == NULL && arguments[i][0] != '-';
            scene = arguments[i];
        }
    }
    if (!sound || scene == NULL) {
        return fail("usage", "hidden SCENE.fxls [--frames N] [--seed S] [--tree 1]");
    }
    return run(scene, frames, seed, tree != 0);
}
