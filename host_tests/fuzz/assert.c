/* SPDX-License-Identifier: MIT */
/* The library's assertions: one that fails is a finding. */
#include <stdio.h>
#include <stdlib.h>

void fxl_assert_failed(const char *file, int line);

void fxl_assert_failed(const char *file, int line)
{
    fprintf(stderr, "%s:%d: the library's assertion does not hold\n", file, line);
    abort();
}
