/* SPDX-License-Identifier: MIT */
#include "parts/semihosting.h"

#include "contract/input.h"
#include "parts/dump.h"
#include "parts/wires.h"

enum {
    SYS_OPEN = 0x01,
    SYS_CLOSE = 0x02,
    SYS_WRITE0 = 0x04,
    SYS_WRITE = 0x05,
    SYS_READ = 0x06,
    SYS_SEEK = 0x0A,
    SYS_GET_CMDLINE = 0x15,
    SYS_EXIT_EXTENDED = 0x20,
    SYS_ELAPSED = 0x30,

    OPEN_READ_BINARY = 1,      /* as fopen's "rb" */
    OPEN_WRITE_BINARY = 5,     /* as fopen's "wb" */
    APPLICATION_EXIT = 0x20026 /* ADP_Stopped_ApplicationExit */
};

/* The host may read and write any memory that the parameters point to. */
#if defined __riscv
/* Three instructions that mean nothing else, uncompressed and on one page. */
static int32_t call(uint32_t operation, const void *parameter)
{
    register uint32_t a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = parameter;

    __asm__ volatile(".balign 16\n\t"
                     ".option push\n\t"
                     ".option norvc\n\t"
                     "slli zero, zero, 0x1f\n\t"
                     "ebreak\n\t"
                     "srai zero, zero, 7\n\t"
                     ".option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
    return (int32_t)a0;
}
#elif defined SEMIHOSTING_ALONE
/* A program that runs without a debugger (make flash DRIVER=): SEMIHOSTING_ALONE is the function
 * that takes its text. No file can be opened, there are no arguments, and nothing is counted. */
void SEMIHOSTING_ALONE(const char *text);

static int32_t call(uint32_t operation, const void *parameter)
{
    if (operation != SYS_WRITE0) {
        return -1;
    }
    SEMIHOSTING_ALONE(parameter);
    return 0;
}
#else
static int32_t call(uint32_t operation, const void *parameter)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = parameter;

    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return (int32_t)r0;
}
#endif

static size_t length(const char *text)
{
    size_t count = 0;

    while (text[count] != '\0') {
        count++;
    }
    return count;
}

void semihosting_text(const char *text)
{
    (void)call(SYS_WRITE0, text);
}

void semihosting_decimal(uint32_t number)
{
    char digits[11]; /* 4294967295 and the 0 that ends it */
    char *first = &digits[sizeof digits - 1];

    *first = '\0';
    do {
        first--;
        *first = (char)('0' + number % 10u);
        number /= 10u;
    } while (number != 0);
    semihosting_text(first);
}

void semihosting_hexadecimal(uint32_t number)
{
    char digits[11] = "0x";
    int i;

    for (i = 0; i < 8; i++) {
        digits[2 + i] = "0123456789abcdef"[(number >> (28 - 4 * i)) & 15u];
    }
    digits[10] = '\0';
    semihosting_text(digits);
}

_Noreturn void semihosting_exit(int status)
{
#if defined SEMIHOSTING_ALONE
    semihosting_text("exit ");
    semihosting_decimal((uint32_t)status);
    semihosting_text("\n");
    for (;;) {
        __asm__ volatile("cpsid i\n\twfi"); /* no interrupt, not even the watchdog's */
    }
#else
    const uint32_t parameters[2] = {APPLICATION_EXIT, (uint32_t)status};

    for (;;) {
        (void)call(SYS_EXIT_EXTENDED, parameters);
    }
#endif
}

uint64_t semihosting_elapsed(void)
{
    uint32_t ticks[2] = {0, 0};

    return call(SYS_ELAPSED, ticks) == 0 ? (uint64_t)ticks[1] << 32 | ticks[0] : 0;
}

const char *semihosting_arguments(char *buffer, size_t size)
{
    /* The host writes the length back into the second word. */
    uint32_t parameters[2] = {(uint32_t)(uintptr_t)buffer, (uint32_t)size};

    return call(SYS_GET_CMDLINE, parameters) == 0 ? buffer : NULL;
}

static int open_file(const char *name, uint32_t mode)
{
    const uint32_t parameters[3] = {(uint32_t)(uintptr_t)name, mode, (uint32_t)length(name)};

    return (int)call(SYS_OPEN, parameters);
}

int semihosting_create(const char *name)
{
    return open_file(name, OPEN_WRITE_BINARY);
}

int semihosting_open(const char *name)
{
    return open_file(name, OPEN_READ_BINARY);
}

int semihosting_seek(int handle, uint32_t offset)
{
    const uint32_t parameters[2] = {(uint32_t)handle, offset};

    return (int)call(SYS_SEEK, parameters);
}

/* Read and write have the same parameters, and return how many bytes are missing. */
static size_t transfer(uint32_t operation, int handle, const void *bytes, size_t size)
{
    const uint32_t parameters[3] = {(uint32_t)handle, (uint32_t)(uintptr_t)bytes, (uint32_t)size};
    const int32_t missing = call(operation, parameters);

    return missing < 0 ? size : (size_t)missing;
}

size_t semihosting_read(int handle, void *bytes, size_t size)
{
    return transfer(SYS_READ, handle, bytes, size);
}

size_t semihosting_write(int handle, const void *bytes, size_t size)
{
    return transfer(SYS_WRITE, handle, bytes, size);
}

int semihosting_close(int handle)
{
    const uint32_t parameters[1] = {(uint32_t)handle};

    return (int)call(SYS_CLOSE, parameters);
}

/* Files of the host, in the directory in which the emulator was started: the frame dump, the record
 * of a display's wires, and the keys that a player holds. */

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
