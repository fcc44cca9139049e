/* SPDX-License-Identifier: MIT */
/* Transfers in the background, as unkind as the contract allows: the bytes are copied out at the
 * last moment, and whoever changes them before is caught. With AddressSanitizer whoever reads them
 * is caught too: they are poisoned while they are sent. */
#ifndef TRANSFER_H
#define TRANSFER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Where bytes go that have been sent. */
typedef void (*transfer_taker)(void *user, const uint8_t *bytes, size_t size);

typedef struct {
    transfer_taker take;
    void *user;
    const uint8_t *bytes; /* being sent, or null */
    size_t size;
    uint32_t crc;
    uint32_t count; /* transfers so far */
} transfer;

/* Begins a transfer. It is an error if one is under way. */
void transfer_start(transfer *of, const uint8_t *bytes, size_t size);

/* Ends the transfer under way, if there is one. */
void transfer_wait(transfer *of);

#endif
