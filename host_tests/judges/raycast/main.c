/* SPDX-License-Identifier: MIT */
/* The ray-cast oracle (docs/accuracy.md, section 4). Casts a ray through every pixel of the
 * reference renderer's frames and says where the nearest polygon is a different one. */
#define _DEFAULT_SOURCE
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "file.h"
#include "judge_frame.h"

#define WORKERS_MAX 2

typedef struct {
    const char *scene, *dump, *json, *draw;
    uint32_t every;
    scene_names names;
} options;

/* What the workers share. */
typedef struct {
    verdict *verdicts;
    uint8_t *pixels; /* null unless the picture of the rays is written */
    const scene *s;
    const dump *d;
    uint32_t every, judged;
} work;

static const char usage[] =
    "use: raycast SCENE.fxls TWIN.fxld --json OUT.json [--every K] [--names all|opaque] [--draw "
    "FOLDER]\n"
    "  --names WHICH   the dump has names of faces (judge --names) instead of colours: of all, or "
    "of\n"
    "                  those through which nothing is seen\n"
    "  --every K       judge every Kth frame\n"
    "  --draw FOLDER   write what the rays see as PGM files of palette indices";

static options options_of(int count, char **words)
{
    options o = {.every = 1};
    for (int i = 1; i < count; i++) {
        bool more = i + 1 < count;
        if (strcmp(words[i], "--json") == 0 && more) {
            o.json = words[++i];
        } else if (strcmp(words[i], "--draw") == 0 && more) {
            o.draw = words[++i];
        } else if (strcmp(words[i], "--names") == 0 && more) {
            const bool is_all = strcmp(words[++i], "all") == 0;
            if (!is_all && strcmp(words[i], "opaque") != 0)
                unusable("--names takes all or opaque, not %s", words[i]);
            o.names = is_all ? SCENE_NAMES_ALL : SCENE_NAMES_OPAQUE;
        } else if (strcmp(words[i], "--every") == 0 && more) {
            char *end;
            unsigned long every = strtoul(words[++i], &end, 10);
            if (*end || every < 1 || every > 1000000)
                unusable("--every takes a number from 1 on, not %s", words[i]);
            o.every = (uint32_t)every;
        } else if (words[i][0] == '-' || o.dump) {
            unusable("cannot make sense of %s\n%s", words[i], usage);
        } else if (o.scene) {
            o.dump = words[i];
        } else {
            o.scene = words[i];
        }
    }
    if (!o.dump || !o.json)
        unusable("a scene, a dump and --json are needed\n%s", usage);
    return o;
}

static void *shared(size_t size)
{
    void *block = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (block == MAP_FAILED)
        unusable("no shared memory: %s", strerror(errno));
    return block;
}

static void judge_share(const work *w, uint32_t worker, uint32_t workers, int done)
{
    size_t size = (size_t)w->s->width * w->s->height;
    scene own = *w->s; /* of this process */
    for (uint32_t i = worker; i < w->judged; i += workers) {
        uint8_t *pixels = w->pixels ? w->pixels + i * size : NULL;
        if (own.moves)
            scene_play(&own, w->d->frames[i * w->every].number);
        judge_frame(&own, &w->d->frames[i * w->every], &w->verdicts[i], pixels);
        if (write(done, "", 1) != 1)
            _exit(1);
    }
    _exit(0);
}

static void show_progress(uint32_t judged, uint32_t total)
{
    static time_t last;
    bool terminal = isatty(STDERR_FILENO);
    time_t now = time(NULL);
    if (!last)
        last = now;
    if (judged == total ? !terminal : now - last < (terminal ? 1 : 2))
        return;
    last = now;
    fprintf(stderr, "%srays: %u of %u frames%s", terminal ? "\r" : "", judged, total,
            terminal ? "" : "\n");
    if (terminal && judged == total)
        fputc('\n', stderr);
}

/* A byte in the pipe means that a frame is done; the end of the pipe, that all workers have
 * ended. */
static void judge_all(const work *w)
{
    int ends[2];
    if (pipe(ends) != 0)
        unusable("no pipe: %s", strerror(errno));
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    uint32_t workers = processors > 1 ? WORKERS_MAX : 1;
    for (uint32_t worker = 0; worker < workers; worker++) {
        pid_t child = fork();
        if (child < 0)
            unusable("cannot start a process: %s", strerror(errno));
        if (child == 0) {
            close(ends[0]);
            judge_share(w, worker, workers, ends[1]);
        }
    }
    close(ends[1]);
    char byte;
    for (uint32_t judged = 0; read(ends[0], &byte, 1) == 1;)
        show_progress(++judged, w->judged);
    close(ends[0]);
    for (uint32_t worker = 0; worker < workers; worker++) {
        int status;
        if (wait(&status) < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
            unusable("a worker process failed");
    }
}

static void print_frame(FILE *out, const work *w, uint32_t i)
{
    const verdict *v = &w->verdicts[i];
    fprintf(out, "    {\"frame\": %u, \"pixels_differing\": %u, \"pixels_unexplained\": %u",
            w->d->frames[i * w->every].number, v->differing, v->unexplained);
    for (uint32_t e = 0; e < v->unexplained && e < EXAMPLES; e++)
        fprintf(out, "%s{\"x\": %u, \"y\": %u, \"twin\": %u, \"ray\": %u}",
                e ? ", " : ", \"examples\": [", v->examples[e].x, v->examples[e].y,
                v->examples[e].reference, v->examples[e].ray);
    fprintf(out, "%s}%s\n", v->unexplained ? "]" : "", i + 1 < w->judged ? "," : "");
}

static void print_all(FILE *out, const work *w)
{
    uint64_t differing = 0, unexplained = 0;
    for (uint32_t i = 0; i < w->judged; i++) {
        differing += w->verdicts[i].differing;
        unexplained += w->verdicts[i].unexplained;
    }
    fprintf(out, "{\n  \"frames_judged\": %u,\n  \"pixels\": %llu,\n", w->judged,
            (unsigned long long)w->judged * w->s->width * w->s->height);
    fprintf(out, "  \"pixels_differing\": %llu,\n  \"pixels_unexplained\": %llu,\n",
            (unsigned long long)differing, (unsigned long long)unexplained);
    fprintf(out, "  \"frames\": [\n");
    for (uint32_t i = 0; i < w->judged; i++)
        print_frame(out, w, i);
    fprintf(out, "  ]\n}\n");
}

static char part[4104]; /* the file being written; empty if there is none */

static void remove_part(void)
{
    if (part[0])
        remove(part);
}

/* Opens NAME.part. close_whole renames it to NAME once it is complete. If the program ends
 * before that, the exit handler removes it. */
static FILE *open_part(const char *name)
{
    if (strlen(name) + sizeof ".part" > sizeof part)
        unusable("the name %s is too long", name);
    sprintf(part, "%s.part", name);
    FILE *out = fopen(part, "wb");
    if (!out)
        unusable("cannot write %s: %s", name, strerror(errno));
    return out;
}

static void close_whole(FILE *out, const char *name)
{
    bool bad = ferror(out) != 0;
    bad = fclose(out) != 0 || bad;
    if (bad || rename(part, name) != 0)
        unusable("cannot write %s: %s", name, strerror(errno));
    part[0] = '\0';
}

static void draw_frames(const char *folder, const work *w)
{
    char name[4096];
    size_t size = (size_t)w->s->width * w->s->height;
    for (uint32_t i = 0; i < w->judged; i++) {
        int length = snprintf(name, sizeof name, "%s/rays_%04u.pgm", folder,
                              w->d->frames[i * w->every].number);
        if (length >= (int)sizeof name)
            unusable("the name %s is too long", folder);
        FILE *out = open_part(name);
        fprintf(out, "P5\n%u %u\n255\n", w->s->width, w->s->height);
        fwrite(w->pixels + i * size, 1, size, out);
        close_whole(out, name);
    }
}

int main(int count, char **words)
{
    options o = options_of(count, words);
    scene s = scene_read(o.scene, o.names);
    dump d = dump_read(o.dump);
    if (d.width != s.width || d.height != s.height)
        unusable("%s is %ux%u, but %s says %ux%u", o.dump, d.width, d.height, o.scene, s.width,
                 s.height);
    work w = {.s = &s, .d = &d, .every = o.every};
    w.judged = (d.frame_count - 1) / o.every + 1;
    w.verdicts = shared(w.judged * sizeof *w.verdicts);
    if (o.draw)
        w.pixels = shared((size_t)w.judged * s.width * s.height);
    atexit(remove_part);
    FILE *probe = open_part(o.json); /* fails before the work rather than after it */
    fclose(probe);
    remove_part();
    judge_all(&w);
    if (o.draw)
        draw_frames(o.draw, &w);
    FILE *out = open_part(o.json);
    print_all(out, &w);
    close_whole(out, o.json);
    return 0;
}
