/* SPDX-License-Identifier: MIT */
#include "fixel/crc.h"

/* The remainders of the 16 values of four bits, for the reflected polynomial 0xEDB88320. The table
 * takes 64 bytes. One of 1,024 bytes, for eight bits at a time, would save three of the 10
 * instructions a byte. */
static const uint32_t remainders[16] = {
    0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u,
    0x4DB26158u, 0x5005713Cu, 0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
    0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu,
};

uint32_t fxl_crc(uint32_t crc, const void *bytes, size_t count)
{
    const uint8_t *next = (const uint8_t *)bytes;
    uint32_t remainder = ~crc;
    for (size_t i = 0; i < count; i++) {
        remainder ^= next[i];
        remainder = (remainder >> 4) ^ remainders[remainder & 15u];
        remainder = (remainder >> 4) ^ remainders[remainder & 15u];
    }
    return ~remainder;
}
