/* SPDX-License-Identifier: MIT */
/* frames SCENE.fxls OUT.fxld [--clipper NAME] [--hidden NAME] [--frames N] [--rows N]
 *     [--pixels palette|rgb565] [--list WORDS] [--cache ENTRIES] [--sliver UNITS] [--pieces BYTES]
 * [--light NAME]
 *
 * Draws a scene's path by a clipper and a visibility method into a frame dump, in bands of
 * --rows rows (0: whole frames), and prints the sums of the counters as JSON. The unit of
 * --sliver is 2^-16 unit of the world. Exit code 0: it ran; 2: it could not. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "frames/dump.h"
#include "frames/input.h"
#include "frames/methods.h"
#include "frames/session.h"
#include "reference/render.h"
#include "path.h"
#include "study/targets.h"

/* place pixel-format: the option pixels, the targets, frames as files */
typedef struct {
    const char *files[2]; /* the scene; the dump */
    const named_clipper *clipper;
    const named_visibility *visibility; /* null: that of the scene */
    const named_light *light;
    uint8_t pixel_bits; /* 0: as the scene asks */
    uint32_t frames, rows, list, cache, sliver, pieces;
    uint32_t cores, outlines, border; /* palette indices; NO_COLOUR: none */
    const char *picks;                /* where the names of what is picked go; null: nowhere */
} options;

enum {
    NO_COLOUR = 256
};

/* Sums over the frames. */
typedef struct {
    uint64_t drawn, clipped, refused, degenerate;
} sums;

static bool take_clipper(const char *value, void *to)
{
    return (*(const named_clipper **)to = find_clipper(value)) != NULL;
}

static bool take_visibility(const char *value, void *to)
{
    return (*(const named_visibility **)to = find_visibility(value)) != NULL;
}

static bool take_pixels(const char *value, void *to)
{
    const bool is_wide = strcmp(value, "rgb565") == 0;
    *(uint8_t *)to = is_wide ? 16 : 8;
    return is_wide || strcmp(value, "palette") == 0;
}

static bool parse(int count, char **arguments, options *wanted)
{
    *wanted = (options){.clipper = find_clipper("view"),
                        .list = 1u << 20,
                        .cache = 256,
                        .pieces = 1u << 20,
                        .outlines = NO_COLOUR,
                        .border = NO_COLOUR};
    const argument known[] = {{"--clipper", take_clipper, &wanted->clipper},
                              {"--hidden", take_visibility, &wanted->visibility},
                              {"--pixels", take_pixels, &wanted->pixel_bits},
                              {"--light", take_light, &wanted->light},
                              {"--picks", take_text, &wanted->picks},
                              {"--frames", take_number, &wanted->frames},
                              {"--rows", take_number, &wanted->rows},
                              {"--list", take_number, &wanted->list},
                              {"--cache", take_number, &wanted->cache},
                              {"--sliver", take_number, &wanted->sliver},
                              {"--pieces", take_number, &wanted->pieces},
                              {"--cores", take_number, &wanted->cores},
                              {"--outlines", take_number, &wanted->outlines},
                              {"--border", take_number, &wanted->border}};
    return read_arguments(count, arguments, known, sizeof known / sizeof *known, wanted->files, 2);
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
    const char *wrong = session_open(run, wanted->files[0]);
    if (wrong) {
        return wrong;
    }
    const fxl_lens *lens = &run->image.lens;
    session_settings settings = {.clipper = wanted->clipper->clipper,
                                 .pixel_bits = wanted->pixel_bits ? wanted->pixel_bits
                                                                  : run->image.pixel_bits,
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
        const fxl_outline_style style = {.line = (uint8_t)wanted->outlines,
                                         .keeps_colours = true,
                                         .code = &fxl_outlines_by_depth};
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
            *names++ =
                picked.instance == FXL_PICK_NONE ? 0 : ref_face_name(picked.instance, picked.face);
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
        return fail(
            "usage",
            "frames SCENE.fxls OUT.fxld [--clipper NAME] [--hidden NAME] "
            "[--pixels palette|rgb565] [--frames N] [--rows N] [--list WORDS] [--cache ENTRIES] "
            "[--sliver UNITS] [--pieces BYTES] [--cores 2] [--outlines COLOUR] "
            "[--border COLOUR] [--picks OUT.fxld]");
    }
    const char *wrong = open_scene(&wanted, &run);
    if (wrong) {
        return fail(wanted.files[0], wrong);
    }
    uint32_t frames = run.image.frame_count;
    frames = wanted.frames > 0 && wanted.frames < frames ? wanted.frames : frames;
    dump to, picks;
    sums counted = {0};
    if (!dump_begin(&to, wanted.files[1], &run.image, frames, session_pixel_bits(&run))) {
        return fail(wanted.files[1], "it cannot be written");
    }
    if (wanted.picks && !dump_begin(&picks, wanted.picks, &run.image, frames, 8)) {
        return fail(wanted.picks, "it cannot be written");
    }
    const fxl_status status =
        draw_all(&wanted, &run, &to, wanted.picks ? &picks : NULL, frames, &counted);
    if (status != FXL_OK) {
        return fail(wanted.files[0], fxl_status_text(status));
    }
    const bool is_saved = dump_end(&to);
    if ((wanted.picks && !dump_end(&picks)) || !is_saved) {
        return fail(wanted.files[1], "it cannot be written");
    }
    printf("{\"clipper\": \"%s\", \"hidden\": \"%s\", \"frames\": %" PRIu32 ", \"drawn\": %" PRIu64
           ", \"clipped\": %" PRIu64 ", \"refused\": %" PRIu64 ", \"degenerate\": %" PRIu64
           ", \"intersections\": %" PRIu32 ", \"distances\": %" PRIu32 "}\n",
           wanted.clipper->name, wanted.visibility ? wanted.visibility->name : "unasked", frames,
           counted.drawn, counted.clipped, counted.refused, counted.degenerate,
           run.clipper_workspace.stats.intersections, run.clipper_workspace.stats.distances);
    return fflush(stdout) == 0 ? 0 : 2;
}
