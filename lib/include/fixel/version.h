/* SPDX-License-Identifier: MIT */
/* The version of the library. This is the one place that states it: the tools and every package
 * read it here. Versions are semantic: a program that compiles with 1.2.3 compiles with 1.3.0. While
 * the first number is 0, the second one counts changes that may break a program. */
#ifndef FXL_VERSION_H
#define FXL_VERSION_H

#define FXL_VERSION_MAJOR 0
#define FXL_VERSION_MINOR 9
#define FXL_VERSION_PATCH 0

/* "0.9.0" */
#define FXL_VERSION FXL_VERSION_OF(FXL_VERSION_MAJOR, FXL_VERSION_MINOR, FXL_VERSION_PATCH)

/* A number to compare in #if: 900 for 0.9.0, 10203 for 1.2.3. */
#define FXL_VERSION_NUMBER \
    (FXL_VERSION_MAJOR * 10000 + FXL_VERSION_MINOR * 100 + FXL_VERSION_PATCH)

/* The text of three numbers, which may be macros. */
#define FXL_VERSION_OF(major, minor, patch)   FXL_VERSION_TEXT(major, minor, patch)
#define FXL_VERSION_TEXT(major, minor, patch) #major "." #minor "." #patch

#endif
