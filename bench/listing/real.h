/* SPDX-License-Identifier: MIT */
/* The listing's numbers: LISTING_double or LISTING_float chooses. */
#ifndef LISTING_REAL_H
#define LISTING_REAL_H

#include <math.h>

#ifdef LISTING_double
typedef double real;
#define REAL(function) function
#else
typedef float real;
#define REAL(function) function##f
#endif

#endif
