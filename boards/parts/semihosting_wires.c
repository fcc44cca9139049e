/* SPDX-License-Identifier: MIT */
/* The record of a display's wires as a file of the host. */
#include "parts/semihosting.h"
#include "parts/record.h"

static int handle;

bool record_open(void)
{
    handle = semihosting_create(RECORD_NAME);
    return handle >= 0;
}

bool record_write(const void *bytes, size_t size)
{
    return semihosting_write(handle, bytes, size) == 0;
}

bool record_close(void)
{
    return semihosting_close(handle) == 0;
}
