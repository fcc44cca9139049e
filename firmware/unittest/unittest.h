/* SPDX-License-Identifier: MIT */
/* The output of a unit test. */
#ifndef UNITTEST_H
#define UNITTEST_H

/* Writes one character. Lines are sent whole. */
void unittest_put(int character);

/* Sends the rest of a line. */
void unittest_flush(void);

/* Switches off the checks that the C library of the tests cannot work with. */
void unittest_allow_library(void);

#endif
