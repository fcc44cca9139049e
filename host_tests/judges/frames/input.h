/* SPDX-License-Identifier: MIT */
/* The input of the host's programs that draw and judge: arguments and whole files. */
#ifndef FRAMES_INPUT_H
#define FRAMES_INPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The file's bytes, aligned for a scene image; the caller frees them. Null if the file cannot
 * be read; then *size is not written. An empty file gives a pointer and a size of 0. */
uint8_t *read_file(const char *path, size_t *size);

/* Says "error: where: what" on stderr. Returns 2, the exit code of a program that could not run. */
int fail(const char *where, const char *what);

/* Says "error: why" on stderr and ends the program with 2: there is not enough room to go on. */
void give_up(const char *why);

/* An option with a value: what takes that, and where it goes. */
typedef struct {
    const char *name;
    bool (*take)(const char *value, void *to); /* false: it is no such value */
    void *to;
} argument;

/* Takes a text into a const char *, and a whole number into a uint32_t or a uint64_t. */
bool take_text(const char *value, void *to);
bool take_number(const char *value, void *to);
bool take_count(const char *value, void *to);

/* Reads options in any order between exactly so many words. Returns false where an option is
 * unknown or lacks its value, or where a word lacks or is one too many. */
bool read_arguments(int count, char **arguments, const argument *options, size_t option_count,
                    const char **words, size_t word_count);

#endif
