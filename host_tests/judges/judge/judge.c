/* SPDX-License-Identifier: MIT */
/* judge SCENE.fxls DUMP.fxld --json OUT.json [--twin TWIN.fxld] [--distance D]
 *     [--names NAMES.fxld] [--clipper NAME] [--hidden NAME]
 *
 * --hidden names the visibility method. Without it, a scene that asks for a depth buffer is drawn
 * with one, else a scene that has a tree by it, and one that has surfaces with them.
 * --names writes a dump in which each pixel is the name of its face (ref_face_name), or 0.
 * Renders every frame of a board's dump with the reference renderer in double precision, from
 * the pose in the dump. Says how many pixels differ and how far from an edge. Exit code 0: the
 * judge ran, whatever it found. Exit code 2: an input is unusable, the dump is of another path,
 * or an output cannot be written. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frames/read_file.h"
#include "judge/explain.h"
#include "judge/verdict.h"
#include "lights/named.h"
/* place pixel-format: which colours a pixel may have */
#include "reference/light.h"
#include "judge/dump.h"

typedef struct {
    const char *scene, *dump, *json, *twin, *names, *shown;
    unsigned cuts; /* the planes that the board's clipper cuts by */
    bool by_points;
    bool by_bsp;    /* the board drew in the order of the scene's BSP */
    bool flat;      /* the board drew faces in their own colours */
    int depth_bits; /* the board drew by a depth buffer of so many; else 0 */
    bool unasked;   /* the board drew as the scene says */
    double distance;
    int line;                 /* the palette index of outlines that the board drew; below 0: none */
    const named_light *light; /* in which the board drew; or null */
} options;

typedef struct {
    ref_scene_image image;
    uint8_t *bytes; /* of the image */
    size_t size;
    judge_dump dump, twin, names, shown;
    judge_frame *frames;
    judge_walk walk;
    ref_light light;
} session;

/* A text that grows. */
typedef struct {
    char *text;
    size_t length, capacity;
    bool failed;
} report;

__attribute__((format(printf, 1, 2))) static int fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("error: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    return 2;
}

__attribute__((format(printf, 2, 3))) static void say(report *out, const char *format, ...)
{
    char piece[512];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(piece, sizeof piece, format, arguments);
    va_end(arguments);
    size_t needed = out->length + (size_t)length + 1;
    if (needed > out->capacity) {
        size_t capacity = 2 * needed;
        char *more = realloc(out->text, capacity);
        if (!more) {
            out->failed = true;
            return;
        }
        out->text = more;
        out->capacity = capacity;
    }
    memcpy(out->text + out->length, piece, (size_t)length + 1);
    out->length += (size_t)length;
}

/* null where there is no distance: no pixel differs, or no distance explains it */
static void say_distance(report *out, const char *name, double distance)
{
    if (distance >= 0 && isfinite(distance)) {
        say(out, "\"%s\": %.9g", name, distance);
    } else {
        say(out, "\"%s\": null", name);
    }
}

static void say_frame(report *out, uint32_t number, const judge_frame *frame)
{
    say(out,
        "    {\"frame\": %u, \"pixels_differing\": %u, \"pixels_tied\": %u, "
        "\"pixels_near_far\": %u, \"texel_pixels\": %u, \"pixels_unexplained\": %u, ",
        (unsigned)number, (unsigned)frame->differing, (unsigned)frame->tied,
        (unsigned)frame->near_far, (unsigned)frame->texels, (unsigned)frame->unexplained);
    say_distance(out, "max_edge_distance_px", frame->max_distance);
    if (frame->unexplained > 0) {
        say(out, ",\n     \"first_unexplained\": [");
        uint32_t shown = frame->unexplained < JUDGE_SAMPLES_MAX ? frame->unexplained
                                                                : (uint32_t)JUDGE_SAMPLES_MAX;
        for (uint32_t i = 0; i < shown; i++) {
            const judge_sample *pixel = &frame->samples[i];
            say(out, "%s{\"x\": %d, \"y\": %d, \"board\": %d, \"twin\": %d, ", i ? ", " : "",
                pixel->x, pixel->y, pixel->board, pixel->twin);
            say_distance(out, "distance_px", pixel->distance);
            say(out, "}");
        }
        say(out, "]");
    }
    say(out, "}");
}

static void say_all(report *out, const options *wanted, const session *run)
{
    uint32_t count = run->dump.frame_count;
    uint64_t pixels = (uint64_t)run->dump.width * (uint64_t)run->dump.height * count;
    uint64_t differing = 0, tied = 0, near_far = 0, texels = 0, unexplained = 0, inexplicable = 0;
    double farthest = -1;
    for (uint32_t i = 0; i < count; i++) {
        differing += run->frames[i].differing;
        tied += run->frames[i].tied;
        near_far += run->frames[i].near_far;
        texels += run->frames[i].texels;
        unexplained += run->frames[i].unexplained;
        inexplicable += run->frames[i].inexplicable;
        farthest = fmax(farthest, run->frames[i].max_distance);
    }
    say(out, "{\n  \"distance\": %.9g,\n  \"pixels\": %llu,\n  \"pixels_differing\": %llu,\n",
        wanted->distance, (unsigned long long)pixels, (unsigned long long)differing);
    say(out, "  \"pixels_tied\": %llu,\n", (unsigned long long)tied);
    say(out, "  \"pixels_near_far\": %llu,\n", (unsigned long long)near_far);
    say(out, "  \"texel_pixels\": %llu,\n", (unsigned long long)texels);
    say(out, "  \"pixels_unexplained\": %llu,\n  \"pixels_inexplicable\": %llu,\n  ",
        (unsigned long long)unexplained, (unsigned long long)inexplicable);
    say_distance(out, "max_edge_distance_px", farthest);
    say(out, ",\n  \"walk\": {\"frames\": %u, \"path\": \"%s\", ", (unsigned)run->walk.frames,
        run->image.poses ? "poses" : "strides");
    say(out, "\"max_position_error_units\": %.9g, \"position_bound_units\": %.9g, ",
        run->walk.max_error, run->walk.max_bound);
    say(out, "\"frames_beyond_bound\": %u},\n  \"frames\": [\n",
        (unsigned)run->walk.frames_beyond_bound);
    for (uint32_t i = 0; i < count; i++) {
        say_frame(out, i, &run->frames[i]);
        say(out, i + 1 < count ? ",\n" : "\n");
    }
    say(out, "  ]\n}\n");
}

static bool parse_options(int count, char **arguments, options *wanted)
{
    *wanted =
        (options){.distance = JUDGE_DISTANCE, .cuts = REF_CUT_ALL, .by_bsp = true, .unasked = true,
                  .line = -1};
    for (int i = 1; i < count; i++) {
        const char *name = arguments[i];
        const char *value = i + 1 < count ? arguments[i + 1] : NULL;
        if (strncmp(name, "--", 2) != 0) {
            if (wanted->dump) {
                return false;
            }
            *(wanted->scene ? &wanted->dump : &wanted->scene) = name;
            continue;
        }
        if (!value) {
            return false;
        }
        i++;
        if (strcmp(name, "--json") == 0) {
            wanted->json = value;
        } else if (strcmp(name, "--twin") == 0) {
            wanted->twin = value;
        } else if (strcmp(name, "--names") == 0) {
            wanted->names = value;
        } else if (strcmp(name, "--outlines") == 0) {
            wanted->line = atoi(value) & 255;
        } else if (strcmp(name, "--shown") == 0) {
            wanted->shown = value;
        } else if (strcmp(name, "--clipper") == 0) {
            if (!ref_clipper_cuts(value, &wanted->cuts, &wanted->by_points)) {
                return false;
            }
        } else if (strcmp(name, "--hidden") == 0) {
            if (!ref_visibility_draws(value, &wanted->by_bsp, &wanted->flat, &wanted->depth_bits)) {
                return false;
            }
            wanted->unasked = false;
        } else if (strcmp(name, "--light") == 0) {
            wanted->light = find_light(value);
            if (!wanted->light) {
                return false;
            }
        } else if (strcmp(name, "--distance") == 0) {
            char *end;
            wanted->distance = strtod(value, &end);
            if (end == value || *end || !(wanted->distance >= 0) || !isfinite(wanted->distance)) {
                return false;
            }
        } else {
            return false;
        }
    }
    return wanted->scene && wanted->dump && wanted->json;
}

static double q16(int32_t value)
{
    return value / 65536.0;
}

static double q30(int32_t value)
{
    return value / 1073741824.0;
}

/* place light: a new setting: who judges by settings by name */
/* Has the image's scene be lit; *light is where the light is kept. */
static void light_scene(ref_scene_image *image, const named_light *named, ref_light *light)
{
    *light = (ref_light){
        .ambient = q30(named->ambient),
        .strength = q30(named->strength),
        .direction = {q30(named->direction[0]), q30(named->direction[1]), q30(named->direction[2])},
        .point_count = named->point_count,
        .fog_near = q16(named->fog_near),
        .fog_far = q16(named->fog_far),
        .levels = named->levels};
    for (int i = 0; i < named->point_count; i++) {
        const int32_t *at = named->points[i].position;
        light->points[i] = (ref_point_light){{q16(at[0]), q16(at[1]), q16(at[2])},
                                             q16(named->points[i].range),
                                             q30(named->points[i].strength)};
    }
    ref_light_make_ramp(light, image->palette, named->dark);
    const int dark[REF_CHANNELS] = {named->dark[0] / 8, named->dark[1] / 4, named->dark[2] / 8};
    image->dark = ref_colour_of(dark);
    image->scene.light = light;
}

/* Returns 0, or 2 after it said why. */
static int open_inputs(const options *wanted, session *run)
{
    run->bytes = read_file(wanted->scene, &run->size);
    if (!run->bytes) {
        return fail("%s: it cannot be read", wanted->scene);
    }
    const char *wrong = ref_scene_open(run->bytes, run->size, &run->image);
    if (wrong) {
        return fail("%s: %s", wanted->scene, wrong);
    }
    wrong = judge_dump_open(wanted->dump, &run->dump);
    if (wrong) {
        return fail("%s: %s", wanted->dump, wrong);
    }
    if (run->dump.width != run->image.lens.width || run->dump.height != run->image.lens.height ||
        run->dump.frame_count > run->image.frame_count ||
        memcmp(judge_dump_palette(&run->dump), run->image.palette, 768) != 0) {
        return fail("%s: its screen, palette or number of frames is not that of %s", wanted->dump,
                    wanted->scene);
    }
    uint32_t frame;
    wrong = judge_walk_compare(&run->image, &run->dump, &run->walk, &frame);
    if (wrong) {
        return fail("%s: frame %u: %s (%s)", wanted->dump, (unsigned)frame, wrong, wanted->scene);
    }
    return 0;
}

/* place pixel-format: frames as files, and their twins */
static int judge(options *wanted, session *run)
{
    int code = open_inputs(wanted, run);
    if (code != 0) {
        return code;
    }
    const judge_scene scene = {&run->image, run->bytes, run->size};
    if (wanted->unasked) {
        wanted->by_bsp = !run->image.by_distance;
        wanted->depth_bits = run->image.depth_bits;
    }
    if (wanted->light) {
        light_scene(&run->image, wanted->light, &run->light);
    }
    run->frames = calloc(run->dump.frame_count, sizeof *run->frames);
    if (!run->frames || (wanted->twin && !judge_dump_like(&run->dump, run->dump.pixel_bits, &run->twin)) ||
        (wanted->names && !judge_dump_like(&run->dump, 8, &run->names)) ||
        (wanted->shown && !judge_dump_like(&run->dump, 8, &run->shown)) ||
        !judge_frames(&scene, &run->dump, wanted->cuts, wanted->by_points, wanted->by_bsp,
                      wanted->flat, wanted->depth_bits, wanted->distance, wanted->line, run->frames,
                      wanted->twin ? &run->twin : NULL, wanted->names ? &run->names : NULL,
                      wanted->shown ? &run->shown : NULL)) {
        return fail("there is not enough memory to judge %s, or the library refuses its scene",
                    wanted->dump);
    }
    if (wanted->twin && !judge_dump_save(&run->twin, wanted->twin)) {
        return fail("%s: it cannot be written", wanted->twin);
    }
    if (wanted->names && !judge_dump_save(&run->names, wanted->names)) {
        return fail("%s: it cannot be written", wanted->names);
    }
    if (wanted->shown && !judge_dump_save(&run->shown, wanted->shown)) {
        return fail("%s: it cannot be written", wanted->shown);
    }
    report out = {0};
    say_all(&out, wanted, run);
    bool saved = !out.failed && judge_save_file(wanted->json, out.text, out.length);
    free(out.text);
    return saved ? 0 : fail("%s: it cannot be written", wanted->json);
}

int main(int count, char **arguments)
{
    options wanted;
    if (!parse_options(count, arguments, &wanted)) {
        return fail("usage: judge SCENE.fxls DUMP.fxld --json OUT.json [--twin TWIN.fxld] "
                    "[--names NAMES.fxld] [--shown NAMES.fxld] [--outlines COLOUR] "
                    "[--distance PIXELS] [--clipper NAME] [--hidden NAME] [--light NAME]");
    }
    static session run;
    int code = judge(&wanted, &run);
    free(run.frames);
    free(run.bytes);
    judge_dump_close(&run.twin);
    judge_dump_close(&run.names);
    judge_dump_close(&run.shown);
    judge_dump_close(&run.dump);
    ref_scene_close(&run.image);
    return code;
}
