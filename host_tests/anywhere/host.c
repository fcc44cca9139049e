/* SPDX-License-Identifier: MIT */
/* Runs the first program, main.c, on this machine and prints the CRC of its picture. */
#define main first_program
#include "main.c"
#undef main

#include <fixel/crc.h>
#include <stdio.h>

int main(void)
{
    if (first_program() != 0) {
        return 1;
    }
    printf("crc %08lx\n", (unsigned long)fxl_crc(FXL_CRC_START, pixels, sizeof pixels));
    return 0;
}
