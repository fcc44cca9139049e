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

#include "frames/input.h"
#include "judge/explain.h"
#include "judge/verdict.h"
#include "lights/named.h"
#include "reference/light.h"
#include "judge/dump.h"

typedef struct {
    const char *files[2]; /* the scene; the dump */
    const char *json, *twin, *names, *shown;
    ref_method method; /* how the board drew */
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

__attribute__((format(printf, 1, 2))) static int refuse(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("error: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    return 2;
}

/* null where there is no distance: no pixel differs, or no distance explains it */
static void print_distance(FILE *out, const char *name, double distance)
{
    if (distance >= 0 && isfinite(distance)) {
        fprintf(out, "\"%s\": %.9g", name, distance);
    } else {
        fprintf(out, "\"%s\": null", name);
    }
}

static void print_frame(FILE *out, uint32_t number, const judge_frame *frame)
{
    fprintf(out,
            "    {\"frame\": %u, \"pixels_differing\": %u, \"pixels_tied\": %u, "
            "\"pixels_near_far\": %u, \"texel_pixels\": %u, \"pixels_unexplained\": %u, ",
            (unsigned)number, (unsigned)frame->differing, (unsigned)frame->tied,
            (unsigned)frame->near_far, (unsigned)frame->texels, (unsigned)frame->unexplained);
    print_distance(out, "max_edge_distance_px", frame->max_distance);
    if (frame->unexplained > 0) {
        fprintf(out, ",\n     \"first_unexplained\": [");
        uint32_t shown = frame->unexplained < JUDGE_SAMPLES_MAX ? frame->unexplained
                                                                : (uint32_t)JUDGE_SAMPLES_MAX;
        for (uint32_t i = 0; i < shown; i++) {
            const judge_sample *pixel = &frame->samples[i];
            fprintf(out, "%s{\"x\": %d, \"y\": %d, \"board\": %d, \"twin\": %d, ", i ? ", " : "",
                    pixel->x, pixel->y, pixel->board, pixel->twin);
            print_distance(out, "distance_px", pixel->distance);
            fprintf(out, "}");
        }
        fprintf(out, "]");
    }
    fprintf(out, "}");
}

static void print_all(FILE *out, const options *wanted, const session *run)
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
    fprintf(out, "{\n  \"distance\": %.9g,\n  \"pixels\": %llu,\n  \"pixels_differing\": %llu,\n",
            wanted->distance, (unsigned long long)pixels, (unsigned long long)differing);
    fprintf(out, "  \"pixels_tied\": %llu,\n", (unsigned long long)tied);
    fprintf(out, "  \"pixels_near_far\": %llu,\n", (unsigned long long)near_far);
    fprintf(out, "  \"texel_pixels\": %llu,\n", (unsigned long long)texels);
    fprintf(out, "  \"pixels_unexplained\": %llu,\n  \"pixels_inexplicable\": %llu,\n  ",
            (unsigned long long)unexplained, (unsigned long long)inexplicable);
    print_distance(out, "max_edge_distance_px", farthest);
    fprintf(out, ",\n  \"walk\": {\"frames\": %u, \"path\": \"%s\", ", (unsigned)run->walk.frames,
            run->image.poses ? "poses" : "strides");
    fprintf(out, "\"max_position_error_units\": %.9g, \"position_bound_units\": %.9g, ",
            run->walk.max_error, run->walk.max_bound);
    fprintf(out, "\"frames_beyond_bound\": %u},\n  \"frames\": [\n",
            (unsigned)run->walk.frames_beyond_bound);
    for (uint32_t i = 0; i < count; i++) {
        print_frame(out, i, &run->frames[i]);
        fprintf(out, i + 1 < count ? ",\n" : "\n");
    }
    fprintf(out, "  ]\n}\n");
}

static bool take_outlines(const char *value, void *to)
{
    *(int *)to = atoi(value) & 255;
    return true;
}

static bool take_distance(const char *value, void *to)
{
    char *end;
    const double distance = strtod(value, &end);
    *(double *)to = distance;
    return end != value && !*end && distance >= 0 && isfinite(distance);
}

static bool parse_options(int count, char **arguments, options *wanted)
{
    *wanted = (options){.distance = JUDGE_DISTANCE, .method = REF_METHOD_OF_SCENE, .line = -1};
    const argument known[] = {{"--json", take_text, &wanted->json},
                              {"--twin", take_text, &wanted->twin},
                              {"--names", take_text, &wanted->names},
                              {"--shown", take_text, &wanted->shown},
                              {"--outlines", take_outlines, &wanted->line},
                              {"--clipper", ref_take_clipper, &wanted->method},
                              {"--hidden", ref_take_visibility, &wanted->method},
                              {"--light", take_light, &wanted->light},
                              {"--distance", take_distance, &wanted->distance}};
    return read_arguments(count, arguments, known, sizeof known / sizeof *known, wanted->files,
                          2) &&
           wanted->json;
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
    run->bytes = read_file(wanted->files[0], &run->size);
    if (!run->bytes) {
        return refuse("%s: it cannot be read", wanted->files[0]);
    }
    const char *wrong = ref_scene_open(run->bytes, run->size, &run->image);
    if (wrong) {
        return refuse("%s: %s", wanted->files[0], wrong);
    }
    wrong = judge_dump_open(wanted->files[1], &run->dump);
    if (wrong) {
        return refuse("%s: %s", wanted->files[1], wrong);
    }
    if (run->dump.width != run->image.lens.width || run->dump.height != run->image.lens.height ||
        run->dump.frame_count > run->image.frame_count ||
        memcmp(judge_dump_palette(&run->dump), run->image.palette, 768) != 0) {
        return refuse("%s: its screen, palette or number of frames is not that of %s",
                      wanted->files[1], wanted->files[0]);
    }
    uint32_t frame;
    wrong = judge_walk_compare(&run->image, &run->dump, &run->walk, &frame);
    if (wrong) {
        return refuse("%s: frame %u: %s (%s)", wanted->files[1], (unsigned)frame, wrong,
                      wanted->files[0]);
    }
    return 0;
}

static int judge(options *wanted, session *run)
{
    int code = open_inputs(wanted, run);
    if (code != 0) {
        return code;
    }
    if (!wanted->method.is_asked) {
        wanted->method.by_bsp = !run->image.by_distance;
        wanted->method.depth_bits = run->image.depth_bits;
    }
    if (wanted->light) {
        light_scene(&run->image, wanted->light, &run->light);
    }
    run->image.scene.has_outlines = wanted->line >= 0;
    run->image.scene.outline = (uint8_t)wanted->line;
    run->frames = calloc(run->dump.frame_count, sizeof *run->frames);
    const struct {
        const char *path;
        judge_dump *dump;
        int pixel_bits;
    } wishes[] = {{wanted->twin, &run->twin, run->dump.pixel_bits},
                  {wanted->names, &run->names, 8},
                  {wanted->shown, &run->shown, 8}};
    bool has_room = run->frames != NULL;
    for (int i = 0; i < 3 && has_room; i++) {
        has_room =
            !wishes[i].path || judge_dump_like(&run->dump, wishes[i].pixel_bits, wishes[i].dump);
    }
    const judge_task question = {.image = &run->image,
                                 .bytes = run->bytes,
                                 .size = run->size,
                                 .dump = &run->dump,
                                 .method = wanted->method,
                                 .distance = wanted->distance,
                                 .line = wanted->line,
                                 .frames = run->frames,
                                 .twin = wanted->twin ? &run->twin : NULL,
                                 .names = wanted->names ? &run->names : NULL,
                                 .shown = wanted->shown ? &run->shown : NULL};
    if (!has_room || !judge_frames(&question)) {
        return refuse("there is not enough memory to judge %s, or the library refuses its scene",
                      wanted->files[1]);
    }
    for (int i = 0; i < 3; i++) {
        if (wishes[i].path && !judge_dump_save(wishes[i].dump, wishes[i].path)) {
            return refuse("%s: it cannot be written", wishes[i].path);
        }
    }
    char *text = NULL;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    bool saved = out != NULL;
    if (out) {
        print_all(out, wanted, run);
        saved = fclose(out) == 0 && judge_save_file(wanted->json, text, length);
    }
    free(text);
    return saved ? 0 : refuse("%s: it cannot be written", wanted->json);
}

int main(int count, char **arguments)
{
    options wanted;
    if (!parse_options(count, arguments, &wanted)) {
        return refuse("usage: judge SCENE.fxls DUMP.fxld --json OUT.json [--twin TWIN.fxld] "
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
