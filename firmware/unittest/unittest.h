/* SPDX-License-Identifier: MIT */
/* What the parts of a program of unit tests share. */
#ifndef UNITTEST_H
#define UNITTEST_H

/* A file of tests. The linker puts the entries of a program side by side, in the section
 * unittest_entries. */
typedef struct unittest_entry {
    const char *name; /* "test_angle" */
    int (*run)(void); /* the generated runner; returns how many tests failed */
} unittest_entry;

/* Writes one character. Lines are sent whole. */
void unittest_put(int character);

/* Sends the rest of a line. */
void unittest_flush(void);

/* Switches off the checks that the C library of the tests cannot work with. */
void unittest_allow_library(void);

#endif
