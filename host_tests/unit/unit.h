/* SPDX-License-Identifier: MIT */
/* What every test of the library shares. The same sources run on the host and
 * on an emulated core: no files, no heap, and fewer rounds there. */
#ifndef UNIT_H
#define UNIT_H

#include <string.h>

#include "draw/stages.h"
#include "fixel/all.h"
#include "unity.h"

#if (defined(__ARM_ARCH) || defined(__riscv)) && !defined(__linux__) && !defined(UNIT_ON_TARGET)
#define UNIT_ON_TARGET
#endif

/* Rounds of a random test. */
#ifdef UNIT_ON_TARGET
#define UNIT_REPEAT 3000
#else
#define UNIT_REPEAT 100000
#endif

/* A constant in 16.16 or 2.30, rounded towards zero. */
#define Q16(value) ((fxl_q16_16)((value)*65536.0))
#define Q30(value) ((fxl_q2_30)((value)*1073741824.0))

/* A binary angle from whole degrees. */
#define DEGREES(value) ((fxl_angle)((int64_t)(value)*4294967296 / 360))

/* A band of so many whole rows, which stand one behind the other. */
#define UNIT_BAND(pixels_of, columns_of, first, count) \
    { \
        .pixels = (pixels_of), .width = (columns_of), .stride = (columns_of), \
        .first_row = (first), .rows = (count) \
    }

/* The same numbers in every run. Each test begins with the first one, so its inputs do not depend on
 * the tests before it. */
uint32_t unit_random(void);

/* Other numbers for the rest of the test, by a seed above 0. */
void unit_seed(uint32_t seed);

/* A random number of low..high, both included. */
int32_t unit_between(int32_t low, int32_t high);

/* A random number of so many bits at most, 1..62, and either sign; one in
 * eight is at an end or within two of it. */
int64_t unit_wide(unsigned bits);

/* Random points |c| <= limit, some of them at the range's ends. */
fxl_point unit_point(fxl_q16_16 limit);

/* A random unit vector, to within 1 unit of 2^-30 a component. */
fxl_direction unit_direction(void);

/* A pose anywhere, turned any way. */
fxl_pose unit_pose(void);

/* A random rotation: each entry is rounded to the nearest 2^-30. */
fxl_orientation unit_orientation(void);

/* A random placement; one in four has scale 1, and one in eight a scale at an end of the range. */
fxl_placement unit_placement(void);

/* Standard lens of the tests: 90 degrees, near 1/16, far 1000, inset 4/65536. */
fxl_lens unit_lens(uint16_t width, uint16_t height);

/* Any lens there is; far is 200 at least. */
fxl_lens unit_any_lens(void);

/* CRC-32 of IEEE 802.3. */
uint32_t unit_crc32(const uint8_t *bytes, uint32_t size);

/* A hash of what was hashed before and a number. */
uint32_t unit_mix(uint32_t hash, int64_t value);

/* 1, and a message with the row's number from 1 on and both hashes, where the hash is not the one on
 * record; else 0. row: of the record, below 99. The message names the line of the test. */
uint32_t unit_tell_hash(size_t row, uint32_t hash, uint32_t on_record);

/* A hash on record of a kind of frames. */
typedef struct {
    uint8_t division; /* FXL_DIVIDE_..., FXL_AFFINE; 0 where frames have no surfaces */
    uint8_t with;     /* bits of the test's own: what the kind has */
    uint32_t hash;
} unit_hash;

/* Tells each hash that is not the one on record; there must be none. */
void unit_expect_hashes(const unit_hash *record, size_t count,
                        uint32_t (*hash_of)(uint8_t division, uint32_t with));

/* A member of a record that becomes another value, and what a check says then. */
typedef struct {
    const char *change; /* what a failure prints */
    void *member;
    size_t bytes;
    int64_t value;
    fxl_status status;
    const char *what; /* of the fault */
    uint32_t index;
} unit_field;
#define UNIT_FIELD(member, value) #member " = " #value, &(member), sizeof(member), (value)

/* Makes each change alone. expect asks the check, and puts the record back. */
void unit_expect_fields(const unit_field *fields, size_t count,
                        void (*expect)(fxl_status status, const char *what, uint32_t index));

/* |a - b| <= bound, in double; Unity's own floats are off on the target. */
#define TEST_ASSERT_NEAR(a, b, bound) \
    TEST_ASSERT_TRUE_MESSAGE(unit_near((double)(a), (double)(b), (double)(bound)), \
                             #a " is too far from " #b)
bool unit_near(double a, double b, double bound);

#endif
