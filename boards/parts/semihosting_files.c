/* SPDX-License-Identifier: MIT */
/* Files of the host, in the directory in which the emulator was started: the frame dump, the record
 * of a display's wires, and the keys that a player holds. */
#include "contract/input.h"
#include "parts/dump.h"
#include "parts/semihosting.h"
#include "parts/wires.h"

#define DUMP_NAME "frames.fxld"
#define KEYS_NAME "keys"

/* --- the frame dump, which the tools rename when it is complete ------------------------------- */

static int dump;

bool sink_open(void)
{
    dump = semihosting_create(DUMP_NAME);
    return dump >= 0;
}

bool sink_write(const void *bytes, size_t size)
{
    return semihosting_write(dump, bytes, size) == 0;
}

bool sink_close(bool whole)
{
    (void)whole; /* the exit code tells the tools */
    return semihosting_close(dump) == 0;
}

/* --- the record of the wires ------------------------------------------------------------------ */

static int record;

bool record_open(void)
{
    record = semihosting_create(RECORD_NAME);
    return record >= 0;
}

bool record_write(const void *bytes, size_t size)
{
    return semihosting_write(record, bytes, size) == 0;
}

bool record_close(void)
{
    return semihosting_close(record) == 0;
}

/* --- keys, for boards without keys of their own: one byte, those that the player holds -------- */

__attribute__((weak)) uint32_t input_keys(void)
{
    static enum {
        UNOPENED,
        OPEN,
        ABSENT
    } state;
    static int handle;
    uint8_t keys = 0;

    if (state == UNOPENED) {
        handle = semihosting_open(KEYS_NAME);
        state = handle >= 0 ? OPEN : ABSENT;
    }
    if (state == OPEN &&
        (semihosting_seek(handle, 0) != 0 || semihosting_read(handle, &keys, sizeof keys) != 0)) {
        keys = 0; /* no file yet */
    }
    return keys;
}
