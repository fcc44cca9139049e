/* SPDX-License-Identifier: MIT */
/* frames SCENE.fxls OUT.fxld [--clipper NAME] [--hidden NAME] [--frames N] [--rows N]
 *     [--pixels palette|rgb565] [--list WORDS] [--cache ENTRIES] [--sliver UNITS] [--pieces BYTES] [--light NAME]
 *
 * Draws a scene's path by a clipper and a visibility method into a frame dump, in bands of
 * --rows rows (0: whole frames), and prints the sums of the counters as JSON. The unit of
 * --sliver is 2^-16 unit of the world. Exit code 0: it ran; 2: it could not. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "frames/dump.h"
#include "frames/methods.h"
#include "frames/session.h"
#include "reference/render.h"
#include "path.h"
#include "study/targets.h"

/* place pixel-format: the option pixels, the targets, frames as files */
typedef struct {
    const char *scene, *out;
    const named_clipper *clipper;
    const named_visibility *visibility; /* null: that of the scene */
    const named_light *light;
    uint8_t pixel_bits; /* 0: as the scene asks */
    uint32_t frames, rows, list, cache, sliver, pieces;
    uint32_t cores, outlines, border; /* palette indices; NO_COLOUR: none */
    const char *picks; /* where the names of what is picked go; null: nowhere */
} options;

enum {
    NO_COLOUR = 256
};

/* Sums over the frames. */
typedef struct {
    uint64_t drawn, clipped, refused, degenerate;
} sums;

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
    *wanted = (options){
        .clipper = find_clipper("view"), .list = 1u << 20, .cache = 256, .pieces = 1u << 20,
        .outlines = NO_COLOUR, .border = NO_COLOUR};
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
            wanted->visibility = find_visibility(value);
            if (!wanted->visibility) {
                return false;
            }
        } else if (strcmp(name, "--pixels") == 0) {
            wanted->pixel_bits = strcmp(value, "rgb565") == 0    ? 16
                                 : strcmp(value, "palette") == 0 ? 8
                                                                 : 0;
            if (wanted->pixel_bits == 0) {
                return false;
            }
        } else if (strcmp(name, "--picks") == 0) {
            wanted->picks = value;
        } else if (strcmp(name, "--light") == 0) {
            wanted->light = find_light(value);
            if (!wanted->light) {
                return false;
            }
        } else {
            uint32_t *number = strcmp(name, "--frames") == 0   ? &wanted->frames
                               : strcmp(name, "--rows") == 0   ? &wanted->rows
                               : strcmp(name, "--list") == 0   ? &wanted->list
                               : strcmp(name, "--cache") == 0  ? &wanted->cache
                               : strcmp(name, "--sliver") == 0 ? &wanted->sliver
                               : strcmp(name, "--pieces") == 0 ? &wanted->pieces
                               : strcmp(name, "--cores") == 0  ? &wanted->cores
                               : strcmp(name, "--outlines") == 0 ? &wanted->outlines
                               : strcmp(name, "--border") == 0   ? &wanted->border
                                                                 : NULL;
            if (!number || !parse_number(value, number)) {
                return false;
            }
        }
    }
    return wanted->out && wanted->clipper;
}

/* A target that goes with the clipper replaces that of the visibility method. */
static void choose_method(const options *wanted, const session *run, session_settings *settings)
{
    session_follow_scene(run, settings);
    if (wanted->visibility) {
        settings->order = wanted->visibility->order;
        settings->target = wanted->visibility->target;
        settings->without_surfaces = !wanted->visibility->draws_surfaces;
    }
    if (wanted->clipper->target) {
        settings->target = settings->target == &fxl_palette_spans ? &fxl_palette_spans_box
                                                                  : wanted->clipper->target;
    }
}

/* Null, or what is wrong. */
static const char *open_scene(const options *wanted, session *run)
{
    const char *wrong = session_open(run, wanted->scene);
    if (wrong) {
        return wrong;
    }
    const fxl_lens *lens = &run->image.lens;
    session_settings settings = {
        .clipper = wanted->clipper->clipper,
        .pixel_bits = wanted->pixel_bits ? wanted->pixel_bits : run->image.pixel_bits,
        .display_list_words = wanted->list,
        .cache_entries = wanted->cache,
        .pieces_bytes = wanted->pieces};
    choose_method(wanted, run, &settings);
    settings.raster_bytes =
        settings.target->memory_size ? settings.target->memory_size(lens) * 16 : 0;
    session_reserve(run, &settings);
    fxl_status status = session_set_up(run, &settings);
    run->clipper_workspace.stats.sliver = (fxl_q18_46)wanted->sliver << 30;
    if (status == FXL_OK && wanted->light) {
        status = session_light(run, wanted->light);
    }
    if (status == FXL_OK && wanted->outlines < NO_COLOUR) {
        const fxl_outline_style style = {.line = (uint8_t)wanted->outlines, .keeps_colours = true};
        status = fxl_attach_outlines(&run->renderer, &run->outlines, &style);
    }
    run->border = wanted->border < NO_COLOUR ? wanted->border + 1 : 0;
    if (status == FXL_OK && wanted->cores == 2) {
        status = session_add_core(run);
    }
    return status == FXL_OK ? NULL : fxl_status_text(status);
}

/* The names of what is picked at each pixel of the frame, as the reference has them; 0: nothing. */
static fxl_status pick_all(session *run, uint8_t *names)
{
    const fxl_lens *lens = &run->image.lens;
    fxl_status status = FXL_OK;
    for (uint16_t y = 0; y < lens->height; y++) {
        for (uint16_t x = 0; x < lens->width && status == FXL_OK; x++) {
            fxl_picked picked;
            status = fxl_pick_face(&run->renderer, x, y, &picked);
            *names++ = picked.instance == FXL_PICK_NONE
                           ? 0
                           : ref_face_name(picked.instance, picked.face);
        }
    }
    return status;
}

/* picks: where their names go; or null. */
static fxl_status draw_all(const options *wanted, session *run, dump *to, dump *picks,
                           uint32_t frames, sums *counted)
{
    const size_t area = (size_t)run->image.lens.width * run->image.lens.height;
    const fxl_counters *counters = &run->renderer.workspace.counters;
    void *pixels = session_memory(2 * area);
    walk_path path;
    walk_path_begin(&path, &run->image, false);
    for (uint32_t i = 0; i < frames; i++) {
        fxl_status status = walk_path_next(&path, 0);
        session_play(run, i);
        if (status == FXL_OK) {
            status =
                session_draw(run, &path.viewer.pose, wanted->rows, run->image.background, pixels);
        }
        if (status != FXL_OK) {
            return status;
        }
        dump_frame(to, &path.viewer.pose, pixels, area, counters, path.viewer.clamped);
        if (picks) {
            status = pick_all(run, pixels);
            dump_frame(picks, &path.viewer.pose, pixels, area, counters, path.viewer.clamped);
        }
        if (status != FXL_OK) {
            return status;
        }
        counted->drawn += counters->drawn;
        counted->clipped += counters->clipped;
        counted->refused += counters->refused;
        counted->degenerate += counters->degenerate;
    }
    return FXL_OK;
}

int main(int count, char **arguments)
{
    static session run;
    options wanted;
    if (!parse(count, arguments, &wanted)) {
        return fail("usage", "frames SCENE.fxls OUT.fxld [--clipper NAME] [--hidden NAME] "
                             "[--pixels palette|rgb565] [--frames N] [--rows N] [--list WORDS] [--cache ENTRIES] "
                             "[--sliver UNITS] [--pieces BYTES] [--cores 2] [--outlines COLOUR] "
                             "[--border COLOUR] [--picks OUT.fxld]");
    }
    const char *wrong = open_scene(&wanted, &run);
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
    sums counted = {0};
    dump_begin(&to, file, &run.image, frames, session_pixel_bits(&run));
    dump picks;
    FILE *pick_file = wanted.picks ? fopen(wanted.picks, "wb") : NULL;
    if (wanted.picks && !pick_file) {
        return fail(wanted.picks, "it cannot be written");
    }
    if (pick_file) {
        dump_begin(&picks, pick_file, &run.image, frames, 8);
    }
    fxl_status status =
        draw_all(&wanted, &run, &to, pick_file ? &picks : NULL, frames, &counted);
    if (status != FXL_OK) {
        fclose(file);
        return fail(wanted.scene, fxl_status_text(status));
    }
    bool saved = dump_end(&to);
    if (pick_file) {
        saved = dump_end(&picks) && fclose(pick_file) == 0 && saved;
    }
    if (fclose(file) != 0 || !saved) {
        return fail(wanted.out, "it cannot be written");
    }
    printf("{\"clipper\": \"%s\", \"hidden\": \"%s\", \"frames\": %" PRIu32 ", \"drawn\": %" PRIu64
           ", \"clipped\": %" PRIu64 ", \"refused\": %" PRIu64 ", \"degenerate\": %" PRIu64
           ", \"intersections\": %" PRIu32 ", \"distances\": %" PRIu32 "}\n",
           wanted.clipper->name, wanted.visibility ? wanted.visibility->name : "unasked", frames,
           counted.drawn, counted.clipped, counted.refused, counted.degenerate,
           run.clipper_workspace.stats.intersections, run.clipper_workspace.stats.distances);
    return fflush(stdout) == 0 ? 0 : 2;
}
