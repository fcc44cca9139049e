/* SPDX-License-Identifier: MIT */
/* Compares the kernels of a core with the portable ones, on that core. */
#ifndef EQUALITY_H
#define EQUALITY_H

#include <stdbool.h>
#include <stdint.h>

#include "draw/stages.h"

/* A kernel's test: all its boundary inputs, then `rounds` random ones. */
typedef struct {
    const char *name;
    void (*run)(uint32_t rounds);
} equality_test;

/* The list ends with a name that is null. */
extern const equality_test equality_tests[];

/* Counts one input, and whether both sides gave the same result. */
void equality_case(bool same);

/* Returns the number of inputs in this test. */
uint32_t equality_cases(void);

/* Begins the random inputs of a shard, which no other has. */
void any_of_shard(uint32_t shard);

/* Returns random bits; the same in every run of a shard. */
uint32_t any_32(void);
uint64_t any_64(void);

/* Returns a number of 0 to 64 bits; every length is equally likely. */
uint64_t any_length(void);

/* Takes the inset from a quarter of the lenses, and moves their centre anywhere in its range. */
void any_centre(fxl_lens *lens);

/* Returns number i of BOUNDARY_32_COUNT near powers of two, where kernels tend to fail. */
uint32_t boundary_32(uint32_t i);
#define BOUNDARY_32_COUNT (3u * 32u + 1u)

#endif
