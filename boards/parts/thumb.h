/* SPDX-License-Identifier: MIT */
/* Finds the memory that a Thumb instruction was about to access, for faults whose address the
 * core does not report. */
#ifndef BOARD_THUMB_H
#define BOARD_THUMB_H

#include <stdbool.h>
#include <stdint.h>

#define THUMB_SP 13u
#define THUMB_PC 15u

/* The lowest address of an access, the alignment that every core requires for it (4 for several
 * words), and its direction. */
typedef struct {
    uint32_t address;
    uint32_t alignment;
    bool is_write;
} thumb_access;

/* Decodes the instruction at code, with the sixteen registers as they were
 * before it; registers[THUMB_PC] is its own address. Both halves must be
 * readable where the first announces a second one.
 * False where it is no load or store of one or more core registers: everything
 * else, and the exclusive ones. */
bool thumb_decode(const uint16_t *code, const uint32_t registers[16], thumb_access *access);

#endif
