/* SPDX-License-Identifier: MIT */
/* What the claims about angles and orientations share. */
#ifndef ORACLE_ANGLE_H
#define ORACLE_ANGLE_H

#include <stdbool.h>

#include "oracle/claim.h"

/* Any angle, or one within a few units of a multiple of a sixteenth of a turn. */
uint32_t oracle_any_angle(oracle_random *random);

bool oracle_is_angle(int64_t number);

/* A number of the library beside the exact one, in its unit; words may be null. */
void oracle_report(FILE *words, const char *name, int32_t got, long double exact);

#endif
