/* SPDX-License-Identifier: MIT */
/* The record of a display's wires. */
#include "parts/record.h"

#include <stdio.h>

static FILE *file;

bool record_open(void)
{
    file = fopen(RECORD_NAME, "wb");
    return file != NULL;
}

bool record_write(const void *bytes, size_t size)
{
    return fwrite(bytes, 1, size, file) == size;
}

bool record_close(void)
{
    return fclose(file) == 0;
}
