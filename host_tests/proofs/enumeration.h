/* SPDX-License-Identifier: MIT */
/* What programs share that run a function of the library on every input. A row's harness is a
 * function of the program; the rows choose it by HARNESS. It calls TRY for each input, and the
 * program prints how many there were. */
#ifndef ENUMERATION_H
#define ENUMERATION_H

#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef CASE
#define CASE 1 /* of a row with cases */
#endif

/* With -std=gnu11 GCC has integers of 128 bits. */
typedef __int128 wide;
typedef unsigned __int128 wide_unsigned;

static uint64_t tried;

/* An input, and what must hold of it. */
#define TRY(input, ...) \
    do { \
        tried += 1; \
        if (!(__VA_ARGS__)) { \
            printf("input %" PRId64 ": %s does not hold", (int64_t)(input), #__VA_ARGS__); \
            exit(1); \
        } \
    } while (0)

void HARNESS(void);

int main(void)
{
    HARNESS();
    printf("%" PRIu64 " inputs\n", tried);
    return 0;
}

#endif
