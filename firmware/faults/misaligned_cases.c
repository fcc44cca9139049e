/* SPDX-License-Identifier: MIT */
/* Misaligned access by every kind of instruction. On each, the report must
 * name the address of the access, which is misaligned_target. */
#include <stddef.h>
#include <stdint.h>

#include "cases.h"

/* What r1 must hold so that the access meets an odd address. */
#define TARGET ((uintptr_t)misaligned_words + 65u)

uint32_t misaligned_words[32]; /* the test knows its address from the symbol */

/* The instruction, with base, offset 4 in r2, and r3 in place of sp. */
#define MISALIGNED(name, instruction, distance) \
    static void name(void) \
    { \
        register uintptr_t base __asm__("r1") = TARGET - (uintptr_t)(distance); \
        register uint32_t four __asm__("r2") = 4; \
\
        __asm__ volatile(instruction : "+r"(base) : "r"(four) : "r3", "r4", "memory"); \
    }

MISALIGNED(load, "ldr r3, [r1]", 0)
MISALIGNED(load_offset, "ldr r3, [r1, #20]", 20)
MISALIGNED(load_register, "ldr r3, [r1, r2]", 4)
MISALIGNED(load_half, "ldrh r3, [r1, #6]", 6)
MISALIGNED(load_half_register, "ldrsh r3, [r1, r2]", 4)
MISALIGNED(load_several, "ldmia r1!, {r3, r4}", 0)
MISALIGNED(store, "str r3, [r1, #8]", 8)
MISALIGNED(store_register, "str r3, [r1, r2]", 4)
MISALIGNED(store_half, "strh r3, [r1, #2]", 2)
MISALIGNED(store_half_register, "strh r3, [r1, r2]", 4)
MISALIGNED(store_several, "stmia r1!, {r3, r4}", 0)

#if __ARM_ARCH >= 7
MISALIGNED(wide_load, "ldr.w r3, [r1, #260]", 260)
MISALIGNED(wide_load_down, "ldr.w r3, [r1, #-8]", -8)
MISALIGNED(wide_load_before, "ldr.w r3, [r1, #12]!", 12)
MISALIGNED(wide_load_after, "ldr.w r3, [r1], #12", 0)
MISALIGNED(wide_load_shifted, "ldr.w r3, [r1, r2, lsl #2]", 16)
MISALIGNED(wide_load_half, "ldrsh.w r3, [r1, #32]", 32)
MISALIGNED(wide_store, "str.w r3, [r1, #-4]", -4)
MISALIGNED(wide_store_half, "strh.w r3, [r1, r2, lsl #1]", 8)
MISALIGNED(load_two, "ldrd r3, r4, [r1, #16]", 16)
MISALIGNED(store_two, "strd r3, r4, [r1, #-8]!", -8)
MISALIGNED(load_several_down, "ldmdb r1, {r3, r4}", -8)
MISALIGNED(store_several_down, "stmdb r1!, {r3, r4}", -8)
#endif

const fault_case misaligned_cases[] = {
    {"misaligned-load", load},
    {"misaligned-load-offset", load_offset},
    {"misaligned-load-register", load_register},
    {"misaligned-load-half", load_half},
    {"misaligned-load-half-register", load_half_register},
    {"misaligned-load-several", load_several},
    {"misaligned-store", store},
    {"misaligned-store-register", store_register},
    {"misaligned-store-half", store_half},
    {"misaligned-store-half-register", store_half_register},
    {"misaligned-store-several", store_several},
#if __ARM_ARCH >= 7
    {"misaligned-wide-load", wide_load},
    {"misaligned-wide-load-down", wide_load_down},
    {"misaligned-wide-load-before", wide_load_before},
    {"misaligned-wide-load-after", wide_load_after},
    {"misaligned-wide-load-shifted", wide_load_shifted},
    {"misaligned-wide-load-half", wide_load_half},
    {"misaligned-wide-store", wide_store},
    {"misaligned-wide-store-half", wide_store_half},
    {"misaligned-load-two", load_two},
    {"misaligned-store-two", store_two},
    {"misaligned-load-several-down", load_several_down},
    {"misaligned-store-several-down", store_several_down},
#endif
    {NULL, NULL},
};
