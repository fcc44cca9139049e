/* SPDX-License-Identifier: MIT */
/* What the claims about angles and orientations share. */
#ifndef ORACLE_ANGLE_H
#define ORACLE_ANGLE_H

#include <stdbool.h>

#include "oracle/claim.h"

/* Any angle, or one within a few units of a multiple of a sixteenth of a turn. */
uint32_t oracle_any_angle(oracle_random *random);

bool oracle_are_angles(const int64_t *numbers, int count);

/* Whether numbers are words of 32 bits with a sign. */
bool oracle_are_words(const int64_t *numbers, int count);

/* Appends so many angles of any kind. */
void oracle_put_angles(oracle_random *random, int count, oracle_input *input);

/* A number of the library beside the exact one, in its unit; words may be null. */
void oracle_report(FILE *words, const char *name, int32_t got, long double exact);

#endif
