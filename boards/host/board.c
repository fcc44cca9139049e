/* SPDX-License-Identifier: MIT */
/* The host as a board: walk SCENE.fxls OUT.fxld [FRAMES [KEYS]].
 *
 * Like every program of the host it exits with 0 where it is done; its other
 * exit codes are those of system.h. OUT.fxld appears only when it is whole.
 *
 * With KEYS a player walks: OUT.fxld is a FIFO, into which frames go as somebody reads them, and
 * KEYS a file of one byte, the keys that are held. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contract/clock.h"
#include "contract/input.h"
#include "contract/panel.h"
#include "contract/store.h"
#include "contract/system.h"
#include "parts/dump.h"
#include "parts/wires.h"

#define FRAMES_MAX      1000000ul
#define LIVE_FRAMES_MAX 0xFFFFFFFFul         /* a live run has no end */
#define SCENE_BYTES_MAX (256l * 1024 * 1024) /* far above what the loader takes */
#define PART_SUFFIX     ".part"

static struct {
    const char *scene, *dump, *keys; /* keys: null, or a player walks */
    uint32_t frames;
} arguments;

static void *scene_bytes;
static char *part_name; /* the dump while it is being written */
static FILE *part;

static void fail(int status, const char *what, const char *name)
{
    fprintf(stderr, "%s %s: %s\n", what, name, strerror(errno));
    system_exit(status);
}

void system_start(int argc, char **argv)
{
    if (argc == 4 || argc == 5) {
        const unsigned long most = argc == 5 ? LIVE_FRAMES_MAX : FRAMES_MAX;
        char *end = NULL;
        const unsigned long frames = strtoul(argv[3], &end, 10);

        if (argv[3][0] < '0' || argv[3][0] > '9' || *end != '\0' || frames > most) {
            fprintf(stderr, "FRAMES is a number from 0 (the whole path) to %lu, not \"%s\"\n", most,
                    argv[3]);
            system_exit(SYSTEM_EXIT_ARGUMENT);
        }
        arguments.frames = (uint32_t)frames;
        arguments.keys = argv[4]; /* null after the last one */
    } else if (argc != 3) {
        fputs("usage: walk SCENE.fxls OUT.fxld [FRAMES [KEYS]]\n", stderr);
        system_exit(SYSTEM_EXIT_ARGUMENT);
    }
    arguments.scene = argv[1];
    arguments.dump = argv[2];
}

uint32_t system_frames(void)
{
    return arguments.frames;
}

bool system_live(void)
{
    return arguments.keys != NULL;
}

void system_alive(void)
{
}

void system_text(const char *text)
{
    fputs(text, stderr);
}

void system_exit(int status)
{
    if (part != NULL) {
        (void)fclose(part);
    }
    if (part_name != NULL) {
        (void)remove(part_name);
    }
    exit(status == SYSTEM_EXIT_DONE ? EXIT_SUCCESS : status);
}

const void *store_scene(size_t *size)
{
    FILE *file = fopen(arguments.scene, "rb");
    long length = -1;

    *size = 0;
    if (file != NULL && fseek(file, 0, SEEK_END) == 0) {
        length = ftell(file);
    }
    if (length < 0 || fseek(file, 0, SEEK_SET) != 0) {
        fail(SYSTEM_EXIT_STORE, "cannot read", arguments.scene);
    }
    if (length > SCENE_BYTES_MAX) {
        errno = EFBIG; /* a directory, for one, claims to be enormous */
        fail(SYSTEM_EXIT_STORE, "cannot read", arguments.scene);
    }
    scene_bytes = malloc((size_t)length + 1);
    if (scene_bytes == NULL || fread(scene_bytes, 1, (size_t)length, file) != (size_t)length) {
        fail(SYSTEM_EXIT_STORE, "cannot read", arguments.scene);
    }
    (void)fclose(file);
    *size = (size_t)length;
    return scene_bytes;
}

/* A FIFO: who reads it gets each byte at once, and may end before the walk does. */
static bool open_live(void)
{
    part = fopen(arguments.dump, "wb");
    if (part == NULL) {
        fail(SYSTEM_EXIT_DISPLAY, "cannot write", arguments.dump);
    }
    return setvbuf(part, NULL, _IONBF, 0) == 0;
}

bool sink_open(void)
{
    if (system_live()) {
        return open_live();
    }

    const size_t size = strlen(arguments.dump) + sizeof PART_SUFFIX;
    char *name = malloc(size);

    if (name == NULL) {
        return false;
    }
    (void)snprintf(name, size, "%s" PART_SUFFIX, arguments.dump);
    part = fopen(name, "wb");
    if (part == NULL) {
        fail(SYSTEM_EXIT_DISPLAY, "cannot write", name);
    }
    part_name = name;
    return true;
}

bool sink_write(const void *bytes, size_t size)
{
    if (fwrite(bytes, 1, size, part) != size) {
        fail(SYSTEM_EXIT_DISPLAY, "cannot write", arguments.dump);
    }
    return true;
}

bool sink_close(bool whole)
{
    const int closed = fclose(part);

    part = NULL;
    if (closed != 0) {
        fail(SYSTEM_EXIT_DISPLAY, "cannot write", arguments.dump);
    }
    if (!whole || system_live()) {
        return true;
    }
    if (rename(part_name, arguments.dump) != 0) {
        fail(SYSTEM_EXIT_DISPLAY, "cannot write", arguments.dump);
    }
    free(part_name);
    part_name = NULL;
    return true;
}

const panel *const *board_panels(void)
{
    static const panel *const panels[] = {&dump_panel, NULL};

    return panels;
}

uint64_t clock_instructions(void)
{
    return 0;
}

uint32_t input_keys(void)
{
    FILE *file = arguments.keys != NULL ? fopen(arguments.keys, "rb") : NULL;
    int keys = EOF;

    if (file != NULL) {
        keys = fgetc(file);
        (void)fclose(file);
    }
    return keys == EOF ? 0 : (uint32_t)keys;
}

/* --- the record of a display's wires ---------------------------------------------------------- */

static FILE *record;

bool record_open(void)
{
    record = fopen(RECORD_NAME, "wb");
    return record != NULL;
}

bool record_write(const void *bytes, size_t size)
{
    return fwrite(bytes, 1, size, record) == size;
}

bool record_close(void)
{
    return fclose(record) == 0;
}
