/* SPDX-License-Identifier: MIT */
/* Runs a fuzz target on files, without a fuzzer: the corpus as a test, on any compiler.
 *
 *   replay_TARGET FILE...                  prints a line for each file: its name, and the hash of
 *                                          what the library answered (answers.h)
 *   replay_TARGET --record RECORD FILE...  compares them with the lines of a file such as this
 *
 * Exit: 0, or 1 an answer is not that on record, or 2 a file cannot be read. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "answers.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum {
    FILE_MAX = 1 << 20,
    RECORD_MAX = 4096,
    NAME_MAX = 63
};

typedef struct {
    char name[NAME_MAX + 1];
    uint64_t hash;
} answer;

static answer recorded[RECORD_MAX];
static size_t recorded_count;

static FILE *open_file(const char *name)
{
    FILE *file = fopen(name, "rb");
    if (file == NULL) {
        fprintf(stderr, "error: %s: cannot be read\n", name);
        exit(2);
    }
    return file;
}

static void read_record(const char *name)
{
    FILE *file = open_file(name);
    while (recorded_count < RECORD_MAX &&
           fscanf(file, "%63s %" SCNx64, recorded[recorded_count].name,
                  &recorded[recorded_count].hash) == 2) {
        recorded_count++;
    }
    fclose(file);
}

/* The name of a file without its folder. */
static const char *base(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

static bool is_on_record(const char *name, uint64_t hash)
{
    for (size_t i = 0; i < recorded_count; i++) {
        if (strcmp(recorded[i].name, name) == 0) {
            return recorded[i].hash == hash;
        }
    }
    return false;
}

static uint64_t replay(const char *name)
{
    static uint8_t bytes[FILE_MAX];
    FILE *file = open_file(name);
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    fprintf(stderr, "%s: %zu bytes\n", name, size);
    LLVMFuzzerTestOneInput(bytes, size);
    return record_end();
}

int main(int count, char **names)
{
    int first = 1, others = 0;
    if (count > 2 && strcmp(names[1], "--record") == 0) {
        read_record(names[2]);
        first = 3;
    }
    for (int i = first; i < count; i++) {
        const uint64_t hash = replay(names[i]);
        if (first == 1) {
            printf("%s %016" PRIx64 "\n", base(names[i]), hash);
        } else if (!is_on_record(base(names[i]), hash)) {
            printf("error: %s: the answers are %016" PRIx64 ", which is not on record\n", names[i],
                   hash);
            others++;
        }
    }
    return others > 0;
}
