/* SPDX-License-Identifier: MIT */
#include "equality.h"
#include "paint/depth_outline.h"

#include <stddef.h>

#define BOTH(name, test) {name, test},
#ifdef FXL_SMALL
#define SMALL(name, test) {name, test},
#define LARGE(name, test)
#define OUTLINES(name, test)
#define SMOOTH(name, test)
#define WORDS(name, test)
#else
#define SMALL(name, test)
#define LARGE(name, test) {name, test},
#if FXL_DRAWS_DEPTH_OUTLINES
#define OUTLINES(name, test) {name, test},
#else
#define OUTLINES(name, test)
#endif
#if FXL_DRAWS_SMOOTH_OUTLINES
#define SMOOTH(name, test) {name, test},
#else
#define SMOOTH(name, test)
#endif
#if FXL_DRAWS_SMOOTH_WORDS
#define WORDS(name, test) {name, test},
#else
#define WORDS(name, test)
#endif
#endif

#define EQUALITY_TEST(name, test, library) library(name, test)

const equality_test equality_tests[] = {EQUALITY_TESTS(EQUALITY_TEST){NULL, NULL}};
