/* SPDX-License-Identifier: MIT */
/* What harnesses of proofs share. A name that begins with nondet_ is any value of its type. */
#ifndef PROOF_H
#define PROOF_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

bool nondet_bool(void);
uint8_t nondet_u8(void);
uint16_t nondet_u16(void);
uint32_t nondet_u32(void);
uint64_t nondet_u64(void);
int16_t nondet_s16(void);
int32_t nondet_s32(void);
int64_t nondet_s64(void);
size_t nondet_size(void);

#define ASSUME(...)           __CPROVER_assume(__VA_ARGS__)
#define ASSERT(text, ...)     __CPROVER_assert(__VA_ARGS__, text)
#define ANY_CONTENT(object)   __CPROVER_havoc_object(object)
#define WITHIN(value, limit)  ((value) >= -(limit) && (value) <= (limit))
/* The last line of each harness. It must fail: else the harness assumes what cannot be. */
#define PROOF_ENDS() __CPROVER_assert(0, "the harness ends")

#endif
