/* SPDX-License-Identifier: MIT */
#include "frames/input.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

uint8_t *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        return NULL;
    }
    uint8_t *bytes = NULL;
    long length = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    if (length >= 0 && length < LONG_MAX && fseek(file, 0, SEEK_SET) == 0) {
        bytes = malloc((size_t)length + 1);
        if (bytes && fread(bytes, 1, (size_t)length, file) != (size_t)length) {
            free(bytes);
            bytes = NULL;
        }
    }
    fclose(file);
    if (bytes) {
        *size = (size_t)length;
    }
    return bytes;
}

int fail(const char *where, const char *what)
{
    fprintf(stderr, "error: %s: %s\n", where, what);
    return 2;
}

void give_up(const char *why)
{
    fprintf(stderr, "error: %s\n", why);
    exit(2);
}

bool take_text(const char *value, void *to)
{
    *(const char **)to = value;
    return true;
}

bool take_count(const char *value, void *to)
{
    char *end;
    errno = 0;
    *(uint64_t *)to = strtoull(value, &end, 10);
    return *value >= '0' && *value <= '9' && *end == '\0' && errno == 0;
}

bool take_number(const char *value, void *to)
{
    uint64_t number;
    const bool is_number = take_count(value, &number);
    *(uint32_t *)to = (uint32_t)number;
    return is_number && number <= UINT32_MAX;
}

bool read_arguments(int count, char **arguments, const argument *options, size_t option_count,
                    const char **words, size_t word_count)
{
    size_t found = 0;
    for (int i = 1; i < count; i++) {
        if (strncmp(arguments[i], "--", 2) != 0) {
            if (found == word_count) {
                return false;
            }
            words[found++] = arguments[i];
            continue;
        }
        size_t number = 0;
        while (number < option_count && strcmp(options[number].name, arguments[i]) != 0) {
            number++;
        }
        if (number == option_count || ++i == count ||
            !options[number].take(arguments[i], options[number].to)) {
            return false;
        }
    }
    return found == word_count;
}
