/* SPDX-License-Identifier: MIT */
/* The frame dump as a file of the host, in the directory in which the emulator was started. The
 * tools rename it when it is complete. */
#include "parts/semihosting.h"
#include "parts/sink.h"

#define DUMP_NAME "frames.fxld"

static int handle;

bool sink_open(void)
{
    handle = semihosting_create(DUMP_NAME);
    return handle >= 0;
}

bool sink_write(const void *bytes, size_t size)
{
    return semihosting_write(handle, bytes, size) == 0;
}

bool sink_close(bool whole)
{
    (void)whole; /* the exit code tells the tools */
    return semihosting_close(handle) == 0;
}
