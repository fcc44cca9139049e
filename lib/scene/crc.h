/* SPDX-License-Identifier: MIT */
/* CRC-32 as in IEEE 802.3 and zlib. Internal. */
#ifndef FXL_CRC_H
#define FXL_CRC_H

#include <stddef.h>
#include <stdint.h>

uint32_t fxl_crc32(const uint8_t *bytes, size_t count);

#endif
