/* SPDX-License-Identifier: MIT */
/* The calls of a port to its SDK, a line each on standard output: test_ports.py reads them.
 *     pin NUMBER LEVEL     bytes HEX     start SIZE     done HEX     sleep MILLISECONDS     setup
 * TEXT A transfer by DMA reads its bytes at the last moment, and they must be those that it was
 * started with. */
#ifndef PORTS_DIARY_H
#define PORTS_DIARY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

void diary_pin(unsigned number, bool level);
void diary_bytes(const uint8_t *bytes, size_t size);
void diary_start(const uint8_t *bytes, size_t size);
/* Ends the transfer that was started. Ends the program after a few frames. */
void diary_finish(void);
bool diary_is_sending(void);
/* Whether FAULT=hang or FAULT=error of the environment is to happen now: after a frame of pixels, so that the display was opened. */
bool diary_hangs(void);
bool diary_fails(void);
void diary_sleep(unsigned milliseconds);
void diary_setup(const char *text);

#ifdef __cplusplus
}
#endif

#endif
