/* SPDX-License-Identifier: MIT */
/* Compares the kernels that a core has with the portable ones, on that core. */
#ifndef EQUALITY_H
#define EQUALITY_H

#include <stdbool.h>
#include <stdint.h>

/* A kernel's test: all its boundary inputs, then `rounds` random ones. */
typedef struct {
    const char *name;
    void (*run)(uint32_t rounds);
} equality_test;

/* Ends with a name that is null. */
extern const equality_test equality_tests[];

/* One input: whether both sides gave the same. */
void equality_case(bool same);

/* How many there were in this test. */
uint32_t equality_cases(void);

/* Random bits; the same in every run. */
uint32_t any_32(void);
uint64_t any_64(void);

/* A number of 0 to 64 bits, every length as likely. */
uint64_t any_length(void);

/* Numbers about powers of two, where kernels go wrong: number i of BOUNDARY_32_COUNT. */
uint32_t boundary_32(uint32_t i);
#define BOUNDARY_32_COUNT (3u * 32u + 1u)

#endif
