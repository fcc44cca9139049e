/* SPDX-License-Identifier: MIT */
/* What the C library of the tests needs: the system calls of newlib, for tests that print or allocate. Output goes to the same
 * place as Unity's. The heap is the memory that the program left free. There are no files. Only
 * test programs link this. */
#include <stddef.h>
#include <stdint.h>

#include "contract/system.h"
#include "parts/cortexm.h"
#include "unittest.h"

extern char fxl_ram_free[], fxl_ram_end[]; /* linker/sections.ld */

int _write(int file, const char *text, int size);
int _read(int file, char *text, int size);
int _close(int file);
int _lseek(int file, int offset, int from);
int _fstat(int file, void *status);
int _isatty(int file);
void *_sbrk(ptrdiff_t size);
void _exit(int status);
int _kill(int process, int signal);
int _getpid(void);

/* newlib is compiled for cores that allow misaligned words, and uses them. */
void unittest_allow_library(void)
{
#if defined __arm__
    SCB_CCR &= ~CCR_UNALIGN_TRP;
#endif
}

int _write(int file, const char *text, int size)
{
    int i;

    (void)file;
    for (i = 0; i < size; i++) {
        unittest_put(text[i]);
    }
    return size;
}

int _read(int file, char *text, int size)
{
    (void)file;
    (void)text;
    (void)size;
    return 0;
}

int _close(int file)
{
    (void)file;
    return -1;
}

int _lseek(int file, int offset, int from)
{
    (void)file;
    (void)offset;
    (void)from;
    return 0;
}

/* Fails, so that newlib takes the output for a plain file. */
int _fstat(int file, void *status)
{
    (void)file;
    (void)status;
    return -1;
}

int _isatty(int file)
{
    (void)file;
    return 1;
}

void *_sbrk(ptrdiff_t size)
{
    static char *end = fxl_ram_free;
    char *const before = end;

    if (size > fxl_ram_end - end || size < fxl_ram_free - end) {
        return (void *)(intptr_t)-1;
    }
    end += size;
    return before;
}

/* abort and failed assertions end here. */
void _exit(int status)
{
    (void)status;
    unittest_flush();
    system_exit(SYSTEM_EXIT_ASSERTION);
    for (;;) {
    }
}

int _kill(int process, int signal)
{
    (void)process;
    (void)signal;
    return -1;
}

int _getpid(void)
{
    return 1;
}

#if defined __riscv

/* floor and ceil for the tests on a RISC-V core: those of picolibc 1.8 (Debian 12) lose a carry for
 * some numbers. floor of the double with the words C1BBF286 FF58E44C gives C1BBF286 00000000
 * instead of C1BBF287 00000000. */
#define WHOLE_FROM 4503599627370496.0 /* 2^52: there every number is whole, or none is one */

double floor(double value);
double ceil(double value);

double floor(double value)
{
    double whole;

    if (!(value > -WHOLE_FROM && value < WHOLE_FROM)) {
        return value;
    }
    whole = (double)(int64_t)value;
    return whole > value ? whole - 1.0 : whole;
}

double ceil(double value)
{
    return -floor(-value);
}

#endif
