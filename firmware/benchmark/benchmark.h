/* SPDX-License-Identifier: MIT */
/* What a board draws in how many microseconds. It needs the library, a clock and a way to print,
 * and no other part of this checkout: docs/results.md says how to run it on a real board. */
#ifndef BENCHMARK_H
#define BENCHMARK_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    const char *board; /* its name, without a comma */
    uint32_t hertz;    /* of the core; 0: unknown */
    /* Returns the microseconds since any moment, modulo 2^32. */
    uint32_t (*microseconds)(void);
    /* Prints a line, which ends with a line feed. */
    void (*print)(const char *line);
} benchmark_port;

/* Draws eight frames of each scene and prints a line for each scene,
 *     FIXEL,board,clock,scene,microseconds,crc
 * with the mean time of a frame and the CRC-32 of all frames, and then the line FIXEL,end. The time
 * has the background, the scene and all bands in it, and neither the CRC nor a display. Returns
 * false if the library refused a call. */
bool benchmark_run(const benchmark_port *port);

#ifdef __cplusplus
}
#endif

#endif
