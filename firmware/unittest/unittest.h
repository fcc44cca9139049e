/* SPDX-License-Identifier: MIT */
/* Where the text of a unit test goes. */
#ifndef UNITTEST_H
#define UNITTEST_H

/* One character; lines go out whole. */
void unittest_put(int character);

/* What is left of a line. */
void unittest_flush(void);

/* Lifts what the C library of the tests cannot live with. */
void unittest_allow_library(void);

#endif
