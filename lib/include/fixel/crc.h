/* SPDX-License-Identifier: MIT */
/* A picture as one number: CRC-32 of IEEE 802.3, which zlib, PNG, the DMA sniffer of an RP2040 and
 * the CRC unit of an STM32 compute too. A frame has the same pixels on every core, so a test of a
 * firmware compares this number, without a tolerance (docs/crc.md). Nothing in the library computes
 * it unless a program asks. */
#ifndef FXL_CRC_H
#define FXL_CRC_H

#include <stddef.h>

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The CRC of no bytes, from which every CRC begins. */
#define FXL_CRC_START 0u

/* Continues a CRC by count bytes, and returns the CRC of all bytes so far: that of a, followed by
 * b, is fxl_crc(fxl_crc(FXL_CRC_START, a, sizeof a), b, sizeof b). Takes 10 instructions a byte on
 * a Cortex-M3, and a table of 64 bytes.
 * Requires bytes not null, unless count is 0. */
uint32_t fxl_crc(uint32_t crc, const void *bytes, size_t count);

/* Continues *crc by the pixels of a band: rows downward, in each its columns from the left, without
 * what lies between the rows. A pixel of RGB565 has two bytes, the high one first, on every core.
 * The bands of a frame, downward, give the CRC of the frame, however the frame is cut into bands.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the width is 0 or above FXL_SCREEN_MAX, the columns are beyond the width or the
 *     stride, or the band has no rows or rows beyond FXL_SCREEN_MAX.
 * FXL_E_ALIGNMENT: a band of RGB565 with pixels or a palette at an odd address.
 * With each of these statuses: *crc unchanged. */
fxl_status fxl_band_crc(uint32_t *crc, const fxl_band *band);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_crc_reasons[];

#ifdef __cplusplus
}
#endif

#endif
