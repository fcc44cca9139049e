/* SPDX-License-Identifier: MIT */
/* Semihosting: calls to the debugger or emulator that holds the core
 * ("Semihosting for AArch32 and AArch64", Arm). Without one listening, a call
 * ends in a lockup. */
#ifndef BOARD_SEMIHOSTING_H
#define BOARD_SEMIHOSTING_H

#include <stddef.h>
#include <stdint.h>

/* Prints a string on the host. Requires a string. */
void semihosting_text(const char *text);

/* Prints a number in decimal; in eight hexadecimal digits after 0x. */
void semihosting_decimal(uint32_t number);
void semihosting_hexadecimal(uint32_t number);

/* Ends the emulator with an exit code of 0..255; does not return. */
_Noreturn void semihosting_exit(int status);

/* The arguments given by the host, separated by blanks, ended by 0.
 * Null where there are none, or more than size - 1 bytes of them. */
const char *semihosting_arguments(char *buffer, size_t size);

/* Creates a file on the host, for binary writing; a handle, or negative. */
int semihosting_create(const char *name);

/* Opens a file of the host for binary reading; a handle, or negative. */
int semihosting_open(const char *name);

/* Goes to a byte of a file; 0 where the host did. */
int semihosting_seek(int handle, uint32_t offset);

/* How many of size bytes the host did NOT read. */
size_t semihosting_read(int handle, void *bytes, size_t size);

/* How many of size bytes the host did NOT write. */
size_t semihosting_write(int handle, const void *bytes, size_t size);

/* 0 where the host closed the file and kept what was written. */
int semihosting_close(int handle);

#endif
