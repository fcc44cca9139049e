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

/* What must hold of an input. */
#define HOLDS(input, ...) \
    do { \
        if (!(__VA_ARGS__)) { \
            printf("input %" PRId64 ": %s does not hold", (int64_t)(input), #__VA_ARGS__); \
            exit(1); \
        } \
    } while (0)

/* The same of another input. */
#define TRY(input, ...) \
    do { \
        tried += 1; \
        HOLDS(input, __VA_ARGS__); \
    } while (0)

static inline wide floor_of(wide numerator, wide denominator)
{
    return numerator / denominator - (numerator % denominator != 0 && (numerator < 0) != (denominator < 0));
}

static inline wide floor_rest(wide numerator, wide denominator)
{
    return numerator - denominator * floor_of(numerator, denominator);
}

/* --- inputs that a generator draws ---------------------------------------------------------------- */

#define SAMPLES 1000000

static uint64_t drawn = 1;

/* xorshift64: any number of 64 bits but 0. */
static inline uint64_t draw(void)
{
    drawn ^= drawn << 13;
    drawn ^= drawn >> 7;
    drawn ^= drawn << 17;
    return drawn;
}

/* 0 to most: often of few bits, or one of the ends. */
static inline uint64_t up_to(uint64_t most)
{
    const uint64_t how = draw() >> 40, value = draw() >> (how & 63);
    const uint64_t end = most < 3 ? (how >> 11) % (most + 1) : how >> 11 & 3;
    return how >> 6 & 15 ? (most == UINT64_MAX ? value : value % (most + 1)) : how >> 10 & 1 ? most - end : end;
}

static inline int64_t between(int64_t limit)
{
    const int64_t value = (int64_t)up_to((uint64_t)limit);
    return draw() >> 40 & 1 ? -value : value;
}

/* Of all lengths and both signs, or near an end. */
static inline int32_t any_word(void)
{
    return draw() >> 40 & 1 ? (int32_t)between(INT32_MAX) : (int32_t)(INT32_MIN + (int64_t)up_to(UINT32_MAX));
}

/* --- reals of formulas, with 113 bits ------------------------------------------------------------- */

typedef __float128 real;

static inline real round_down(real value)
{
    const wide whole = (wide)value;
    return whole > value ? whole - 1 : whole;
}

static inline real round_up(real value)
{
    return -round_down(-value);
}

static inline real magnitude_of(real value)
{
    return value < 0 ? -value : value;
}

void HARNESS(void);

int main(void)
{
    HARNESS();
    printf("%" PRIu64 " inputs\n", tried);
    return 0;
}

#endif
