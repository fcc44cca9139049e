/* SPDX-License-Identifier: MIT */
/* frames SCENE.fxls OUT.fxld [--clipper NAME] [--hidden NAME] [--frames N] [--rows N]
 *     [--list WORDS] [--cache ENTRIES] [--sliver UNITS] [--pieces BYTES]
 *
 * Draws a scene's path by a clipper and a hidden-surface method into a frame dump, in
 * bands of so many rows (0: whole frames), and prints what was counted as JSON. The sliver
 * rule's unit is 2^-16 of the world. Exit code 0: it ran; 2: it could not. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "frames/dump.h"
#include "frames/methods.h"
#include "path.h"

typedef struct {
    const char *scene, *out;
    const named_clipper *clipper;
    const named_hidden *hidden;
    uint32_t frames, rows, list, cache, sliver, pieces;
} options;

typedef struct {
    fxl_scene_image image;
    fxl_renderer renderer;
    fxl_visibility hidden; /* with the clipper's own painter */
    uint8_t *pixels;
    fxl_clipper_workspace room;
    uint64_t drawn, clipped, refused, degenerate;
} session;

static int fail(const char *what, const char *why)
{
    fprintf(stderr, "error: %s: %s\n", what, why);
    return 2;
}

static bool parse_number(const char *text, uint32_t *number)
{
    char *end;
    errno = 0;
    unsigned long value = strtoul(text, &end, 10);
    *number = (uint32_t)value;
    return *text >= '0' && *text <= '9' && *end == '\0' && errno == 0 && value <= UINT32_MAX;
}

static bool parse(int count, char **arguments, options *wanted)
{
    *wanted = (options){.clipper = find_clipper("view"),
                        .hidden = find_hidden("sorted"),
                        .list = 1u << 20,
                        .cache = 256,
                        .pieces = 1u << 20};
    for (int i = 1; i < count; i++) {
        const char *name = arguments[i];
        if (strncmp(name, "--", 2) != 0) {
            if (wanted->out) {
                return false;
            }
            *(wanted->scene ? &wanted->out : &wanted->scene) = name;
            continue;
        }
        if (++i == count) {
            return false;
        }
        const char *value = arguments[i];
        if (strcmp(name, "--clipper") == 0) {
            wanted->clipper = find_clipper(value);
        } else if (strcmp(name, "--hidden") == 0) {
            wanted->hidden = find_hidden(value);
        } else {
            uint32_t *number = strcmp(name, "--frames") == 0   ? &wanted->frames
                               : strcmp(name, "--rows") == 0   ? &wanted->rows
                               : strcmp(name, "--list") == 0   ? &wanted->list
                               : strcmp(name, "--cache") == 0  ? &wanted->cache
                               : strcmp(name, "--sliver") == 0 ? &wanted->sliver
                               : strcmp(name, "--pieces") == 0 ? &wanted->pieces
                                                               : NULL;
            if (!number || !parse_number(value, number)) {
                return false;
            }
        }
    }
    return wanted->out && wanted->clipper && wanted->hidden;
}

static void *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    uint8_t *bytes = NULL;
    long length = file && fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    if (length > 0 && fseek(file, 0, SEEK_SET) == 0) {
        bytes = malloc((size_t)length);
        if (bytes && fread(bytes, 1, (size_t)length, file) != (size_t)length) {
            free(bytes);
            bytes = NULL;
        }
        *size = (size_t)length;
    }
    if (file) {
        fclose(file);
    }
    return bytes;
}

/* Memory that lives until the program ends. */
static void *need(size_t size)
{
    void *memory = calloc(size > 0 ? size : 1, 1);
    if (!memory) {
        fprintf(stderr, "error: there is not enough memory\n");
        exit(2);
    }
    return memory;
}

/* Null, or what is wrong. */
static const char *open_session(const options *wanted, session *run)
{
    size_t size;
    void *bytes = read_file(wanted->scene, &size);
    if (!bytes) {
        return "it cannot be read";
    }
    fxl_status status = fxl_scene_open(bytes, size, &run->image, NULL);
    if (status != FXL_OK) {
        return fxl_status_text(status);
    }
    const fxl_scene *scene = &run->image.scene;
    const fxl_lens *lens = &run->image.lens;
    fxl_memory memory = {need(scene->order_needed * sizeof(fxl_order_entry)),
                         scene->order_needed,
                         need(4 * (size_t)wanted->list),
                         wanted->list,
                         need(wanted->cache * sizeof(fxl_cached_vertex)),
                         wanted->cache};
    run->pixels = need((size_t)lens->width * lens->height);
    status = fxl_renderer_init_with(&run->renderer, scene, lens, &memory);
    if (status == FXL_OK) {
        status = fxl_renderer_set_clipper(&run->renderer, wanted->clipper->clipper, &run->room,
                                          sizeof run->room);
    }
    if (status == FXL_OK) {
        run->hidden = *wanted->hidden->hidden;
        if (wanted->clipper->painter) {
            run->hidden.backend = run->hidden.backend == &fxl_raster_spans
                                      ? &fxl_raster_spans_box
                                      : wanted->clipper->painter;
        }
        const uint32_t room =
            (run->hidden.submit_workspace_size ? run->hidden.submit_workspace_size(scene) + 8 : 0) +
            (run->hidden.backend->workspace_size ? run->hidden.backend->workspace_size(lens) * 16
                                                 : 0);
        status = fxl_renderer_set_visibility(&run->renderer, &run->hidden, need(room), room);
    }
    if (status == FXL_OK && scene->beam_count > 0) {
        const uint32_t room = fxl_beam_light_workspace_size(scene->beams, scene->beam_count);
        status = fxl_renderer_set_beams(&run->renderer, scene->beams, scene->beam_count, scene->lit,
                                        need(room), room);
    }
    if (status == FXL_OK &&
        run->renderer.visibility->submit_workspace_size ==
            fxl_visibility_bsp.submit_workspace_size &&
        scene->bsp_nodes != NULL) {
        fxl_bsp_workspace *tree = run->renderer.submit_workspace;
        tree->pieces = need(wanted->pieces);
        tree->pieces_size = wanted->pieces;
    }
    run->room.stats.sliver = (fxl_q18_46)wanted->sliver << 30;
    return status == FXL_OK ? NULL : fxl_status_text(status);
}

static fxl_status draw_frame(const options *wanted, session *run, const fxl_pose *pose)
{
    const fxl_lens *lens = &run->image.lens;
    uint32_t rows = wanted->rows > 0 ? wanted->rows : lens->height;
    fxl_status status = fxl_frame_begin(&run->renderer, pose);
    for (uint32_t row = 0; status == FXL_OK && row < lens->height; row += rows) {
        uint32_t left = lens->height - row;
        fxl_band band = {run->pixels + (size_t)row * lens->width, lens->width, lens->width,
                         (uint16_t)row, (uint16_t)(rows < left ? rows : left)};
        fxl_fill_band(&band, run->image.background);
        status = fxl_frame_draw(&run->renderer, &band);
    }
    return status;
}

static fxl_status draw_all(const options *wanted, session *run, dump *to, uint32_t frames)
{
    const fxl_lens *lens = &run->image.lens;
    const fxl_counters *counters = &run->renderer.workspace.counters;
    walk_path path;
    walk_path_begin(&path, &run->image, false);
    for (uint32_t i = 0; i < frames; i++) {
        fxl_status status = walk_path_next(&path, 0);
        if (status == FXL_OK) {
            status = draw_frame(wanted, run, &path.viewer.pose);
        }
        if (status != FXL_OK) {
            return status;
        }
        dump_frame(to, &path.viewer.pose, run->pixels, (size_t)lens->width * lens->height, counters,
                   path.viewer.clamped);
        run->drawn += counters->drawn;
        run->clipped += counters->clipped;
        run->refused += counters->refused;
        run->degenerate += counters->degenerate;
    }
    return FXL_OK;
}

int main(int count, char **arguments)
{
    static session run;
    options wanted;
    if (!parse(count, arguments, &wanted)) {
        return fail("usage", "frames SCENE.fxls OUT.fxld [--clipper NAME] [--hidden NAME] "
                             "[--frames N] [--rows N] [--list WORDS] [--cache ENTRIES] "
                             "[--sliver UNITS] [--pieces BYTES]");
    }
    const char *wrong = open_session(&wanted, &run);
    if (wrong) {
        return fail(wanted.scene, wrong);
    }
    uint32_t frames = run.image.frame_count;
    frames = wanted.frames > 0 && wanted.frames < frames ? wanted.frames : frames;
    FILE *file = fopen(wanted.out, "wb");
    if (!file) {
        return fail(wanted.out, "it cannot be written");
    }
    dump to;
    dump_begin(&to, file, &run.image, frames);
    fxl_status status = draw_all(&wanted, &run, &to, frames);
    if (status != FXL_OK) {
        fclose(file);
        return fail(wanted.scene, fxl_status_text(status));
    }
    bool saved = dump_end(&to);
    if (fclose(file) != 0 || !saved) {
        return fail(wanted.out, "it cannot be written");
    }
    printf("{\"clipper\": \"%s\", \"hidden\": \"%s\", \"frames\": %" PRIu32 ", \"drawn\": %" PRIu64
           ", \"clipped\": %" PRIu64 ", \"refused\": %" PRIu64 ", \"degenerate\": %" PRIu64
           ", \"intersections\": %" PRIu32 ", \"distances\": %" PRIu32 "}\n",
           wanted.clipper->name, wanted.hidden->name, frames, run.drawn, run.clipped, run.refused,
           run.degenerate, run.room.stats.intersections, run.room.stats.distances);
    return fflush(stdout) == 0 ? 0 : 2;
}
