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

/* Prints a number: in decimal; or as 0x and eight hexadecimal digits. */
void semihosting_decimal(uint32_t number);
void semihosting_hexadecimal(uint32_t number);

/* Ends the emulator with an exit code of 0..255; does not return. */
_Noreturn void semihosting_exit(int status);

/* Returns the ticks since the start, 0 where the host does not count. The host says what a tick is.
 */
uint64_t semihosting_elapsed(void);

/* Reads the arguments from the host, separated by blanks, ended by 0. Returns null where there
 * are none, or more than size - 1 bytes of them. */
const char *semihosting_arguments(char *buffer, size_t size);

/* Creates a file on the host, for binary writing. Returns a handle, or a negative number. */
int semihosting_create(const char *name);

/* Opens a file of the host for binary reading. Returns a handle, or a negative number. */
int semihosting_open(const char *name);

/* Goes to a byte of a file. Returns 0 on success. */
int semihosting_seek(int handle, uint32_t offset);

/* Reads size bytes. Returns how many of them the host did NOT read. */
size_t semihosting_read(int handle, void *bytes, size_t size);

/* Writes size bytes. Returns how many of them the host did NOT write. */
size_t semihosting_write(int handle, const void *bytes, size_t size);

/* Closes a file. Returns 0 where the host closed it and kept the data. */
int semihosting_close(int handle);

#endif
