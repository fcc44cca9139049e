/* SPDX-License-Identifier: MIT */
#include "equality.h"

static uint32_t state = 0x9E3779B9u;
static uint64_t of_shard; /* stays 0 in shard 0 */

/* Steele's splitmix64 makes seeds far apart of numbers that are near. */
void any_of_shard(uint32_t shard)
{
    uint64_t seed = shard * UINT64_C(0x9E3779B97F4A7C15); /* modulo 2^64, as the products below */
    seed = (seed ^ seed >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    seed = (seed ^ seed >> 27) * UINT64_C(0x94D049BB133111EB);
    of_shard = seed ^ seed >> 31;
}

/* Marsaglia's xorshift, 32 bits: period 2^32 - 1, so a test takes a run of them
 * that no other has. That of a shard has 64 bits and a period of 2^64 - 1. */
uint32_t any_32(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    of_shard ^= of_shard << 13;
    of_shard ^= of_shard >> 7;
    of_shard ^= of_shard << 17;
    return state ^ (uint32_t)(of_shard >> 32);
}

uint64_t any_64(void)
{
    static uint32_t weyl;
    weyl += 0x9E3779B9u;
    uint32_t upper = any_32() ^ weyl;
    return (uint64_t)upper << 32 | any_32();
}

uint64_t any_length(void)
{
    uint32_t length = any_32() >> 7 & 63u;
    uint64_t value = any_64();
    return length == 0 ? value : value >> length;
}

/* At most three halves of the extent, and four focal lengths. */
static int32_t any_offset(uint16_t extent, fxl_q16_16 focal)
{
    const int32_t far = extent * 98304, most = far < 4 * focal ? far : 4 * focal;
    return (int32_t)(any_32() % (2u * (uint32_t)most + 1u)) - most;
}

void any_centre(fxl_lens *lens)
{
    if ((any_32() & 0x180u) == 0) {
        lens->inset = 0;
        fxl_lens_set_centre(lens, lens->width * 32768 + any_offset(lens->width, lens->focal),
                            lens->height * 32768 + any_offset(lens->height, lens->focal));
    }
}

uint32_t boundary_32(uint32_t i)
{
    if (i == 0) {
        return 0;
    }
    return ((uint32_t)1 << ((i - 1u) / 3u)) + (i - 1u) % 3u - 1u;
}
