/* SPDX-License-Identifier: MIT */
/* What the core for which a file is compiled has, and so which texts and kernels. Only kernels use
 * this, in C and in assembly. The compiler's own macros decide, so every file of lib/ may be
 * compiled for any core: of each kernel exactly one file has contents, and of each inline kernel one
 * text. All texts give the same bits.
 *
 * A text in C asks for properties, each of which is 0 or 1:
 *
 *   FXL_HAS_LONG_PRODUCT   a product of 32 by 32 bits into 64 takes an instruction, or two
 *   FXL_HAS_DIVIDER        a division of 32 bits is an instruction
 *   FXL_HAS_LONG_DIVIDER   so is one of 64 bits
 *   FXL_HAS_LEADING_ZEROS  so is the count of leading zeros
 *   FXL_HAS_MVE            vectors: Arm's Helium
 *
 * FXL_CORE_HAS is the sum of what a core has. A test may define it, and so have the text of another
 * core.
 *
 * Assembly, inline too, asks for the instruction set, each 0 or 1:
 *
 *   FXL_CORE_ARMV6M  Thumb-1 (Cortex-M0, M0+, M1, M23)
 *   FXL_CORE_ARMV7M  Thumb-2 (Cortex-M3, M4, M7, M33 and above)
 *
 * Inline kernels depend on these, and on this one, which is 0 in a library built with FXL_SMALL:
 *
 *   FXL_ESTIMATES  what takes more bytes in place to save long products
 *
 * Kernels in assembly are fast and take many bytes, so a library built with FXL_SMALL has none;
 * nor has one of FXL_WITHOUT_ASSEMBLY, which is one file. They depend on these:
 *
 *   FXL_KERNELS_ARMV6M, FXL_KERNELS_ARMV7M
 *   FXL_KERNELS_MVE  vectors (M55, M85) instead of some kernels of Armv7-M, if the ABI passes
 *                    floats in registers: then the program has turned on the vector unit */
#ifndef FXL_FAMILY_H
#define FXL_FAMILY_H

#include "../include/fixel/config.h"

#define FXL_LONG_PRODUCT  1
#define FXL_DIVIDER       2
#define FXL_LONG_DIVIDER  4
#define FXL_LEADING_ZEROS 8
#define FXL_MVE           16

/* Of an Arm core of 32 bits the compiler says most. Thumb-1 alone has no long product. */
#if defined __thumb__ && defined __ARM_ARCH_ISA_THUMB && __ARM_ARCH_ISA_THUMB == 1
#define FXL_ARM_LONG_PRODUCT 0
#else
#define FXL_ARM_LONG_PRODUCT FXL_LONG_PRODUCT
#endif
#ifdef __ARM_FEATURE_IDIV
#define FXL_ARM_DIVIDER FXL_DIVIDER
#else
#define FXL_ARM_DIVIDER 0
#endif
#ifdef __ARM_FEATURE_CLZ
#define FXL_ARM_LEADING_ZEROS FXL_LEADING_ZEROS
#else
#define FXL_ARM_LEADING_ZEROS 0
#endif
#ifdef __ARM_FEATURE_MVE
#define FXL_ARM_MVE FXL_MVE
#else
#define FXL_ARM_MVE 0
#endif

#ifndef FXL_CORE_HAS
#if defined FXL_PORTABLE_KERNELS || defined __LP64__ || defined _WIN64 || defined __wasm__
#define FXL_CORE_HAS (FXL_LONG_PRODUCT + FXL_DIVIDER + FXL_LONG_DIVIDER + FXL_LEADING_ZEROS)
#elif defined __arm__ /* an ARM7 or ARM9 has no divider, and no count before Armv5 */
#define FXL_CORE_HAS (FXL_ARM_LONG_PRODUCT + FXL_ARM_DIVIDER + FXL_ARM_LEADING_ZEROS + FXL_ARM_MVE)
#elif defined __riscv && defined __riscv_mul && defined __riscv_zbb /* rv32imc_zba_zbb: RP2350 */
#define FXL_CORE_HAS (FXL_LONG_PRODUCT + FXL_DIVIDER + FXL_LEADING_ZEROS)
#elif defined __riscv && defined __riscv_mul /* rv32imc: ESP32-C3 */
#define FXL_CORE_HAS (FXL_LONG_PRODUCT + FXL_DIVIDER)
#elif defined __riscv /* rv32i */
#define FXL_CORE_HAS 0
#elif defined __XTENSA__ && !defined __XTENSA_WINDOWED_ABI__ /* LX106: ESP8266 */
#define FXL_CORE_HAS FXL_LEADING_ZEROS
#else /* Xtensa LX6 and LX7 (ESP32, S2, S3), x86 of 32 bits */
#define FXL_CORE_HAS (FXL_LONG_PRODUCT + FXL_DIVIDER + FXL_LEADING_ZEROS)
#endif
#endif

#define FXL_HAS_LONG_PRODUCT  ((FXL_CORE_HAS & FXL_LONG_PRODUCT) != 0)
#define FXL_HAS_DIVIDER       ((FXL_CORE_HAS & FXL_DIVIDER) != 0)
#define FXL_HAS_LONG_DIVIDER  ((FXL_CORE_HAS & FXL_LONG_DIVIDER) != 0)
#define FXL_HAS_LEADING_ZEROS ((FXL_CORE_HAS & FXL_LEADING_ZEROS) != 0)
#define FXL_HAS_MVE           ((FXL_CORE_HAS & FXL_MVE) != 0)

#if defined __ARM_ARCH_PROFILE && !defined FXL_PORTABLE_KERNELS
#if __ARM_ARCH_PROFILE == 'M' && __ARM_ARCH_ISA_THUMB == 1
#define FXL_CORE_ARMV6M 1
#elif __ARM_ARCH_PROFILE == 'M' && __ARM_ARCH_ISA_THUMB == 2
#define FXL_CORE_ARMV7M 1
#endif
#endif

#ifndef FXL_CORE_ARMV6M
#define FXL_CORE_ARMV6M 0
#endif
#ifndef FXL_CORE_ARMV7M
#define FXL_CORE_ARMV7M 0
#endif

#define FXL_ESTIMATES (!FXL_HAS_LONG_PRODUCT && !FXL_IS_SMALL)

#ifdef FXL_WITHOUT_ASSEMBLY
#define FXL_KERNELS_ARMV6M 0
#define FXL_KERNELS_ARMV7M 0
#else
#define FXL_KERNELS_ARMV6M (FXL_CORE_ARMV6M && !FXL_IS_SMALL)
#define FXL_KERNELS_ARMV7M (FXL_CORE_ARMV7M && !FXL_IS_SMALL)
#endif

#if FXL_KERNELS_ARMV7M && FXL_HAS_MVE && defined __ARM_PCS_VFP
#define FXL_KERNELS_MVE 1
#else
#define FXL_KERNELS_MVE 0
#endif

/* Assembly without an -O cannot know how the C files are compiled. */
#if defined __ASSEMBLER__ && !defined FXL_COMPACT && !defined __OPTIMIZE__ && FXL_KERNELS_ARMV7M
#error "define FXL_COMPACT, 0 or 1, for C and assembly, or give both the same -O"
#endif

/* Compact, Armv7-M has an edge's intersection in C. */
#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT
#define FXL_INTERSECTS_IN_ASSEMBLY 1
#else
#define FXL_INTERSECTS_IN_ASSEMBLY 0
#endif

/* So is the matrix of a turned instance. */
#define FXL_PLACEMENTS_IN_ASSEMBLY FXL_INTERSECTS_IN_ASSEMBLY

/* And it paints the texels of segments and divided pixels in C. */
#define FXL_TEXELS_IN_ASSEMBLY FXL_INTERSECTS_IN_ASSEMBLY

/* Whether outlines that are painted row by row are scanned between two chains where they can be,
 * or else all by active edges. Compact, Armv7-M has chains only in its kernel for outlines of one
 * colour. */
#if FXL_IS_SMALL || (FXL_KERNELS_ARMV7M && FXL_IS_COMPACT)
#define FXL_SCANS_BY_CHAINS 0
#else
#define FXL_SCANS_BY_CHAINS 1
#endif

/* Compact, segments of textures are painted one by one where no kernel paints a run of them. */
#if FXL_IS_COMPACT && !FXL_KERNELS_ARMV6M
#define FXL_SEGMENTS_ONE_BY_ONE 1
#else
#define FXL_SEGMENTS_ONE_BY_ONE 0
#endif

/* Compact, it fills rows by a text of a sixth of the bytes. */
#if FXL_KERNELS_ARMV7M && !FXL_KERNELS_MVE && FXL_IS_COMPACT
#define FXL_FILLS_COMPACT 1
#else
#define FXL_FILLS_COMPACT 0
#endif

/* Before a function that is in place wherever it is called, but on an Armv6-M, where what it has on
 * the stack would stay there below the kernels that the caller goes on to. */
#if FXL_KERNELS_ARMV6M
#define FXL_APART static __attribute__((noinline, unused))
#else
#define FXL_APART static inline
#endif

/* Before a function that is in place wherever it is called, but in a library for size, which has it
 * once. */
#if FXL_IS_COMPACT
#define FXL_ONCE static __attribute__((noinline, unused))
#else
#define FXL_ONCE static inline __attribute__((always_inline))
#endif

/* Before the type of a static inline function; a library for size has one copy in a file. */
#if FXL_IS_COMPACT
#define FXL_ONE_COPY __attribute__((noinline))
#else
#define FXL_ONE_COPY inline
#endif

/* Before a loop over three values. It is written out, so that they may be in registers, but not in
 * a library for size. */
#if FXL_IS_COMPACT
#define FXL_EACH_OF_THREE
#else
#define FXL_EACH_OF_THREE _Pragma("GCC unroll 3")
#endif

/* The same before a loop that needs more registers than Thumb-1 has. */
#if FXL_CORE_ARMV6M
#define FXL_EACH_CORNER
#else
#define FXL_EACH_CORNER FXL_EACH_OF_THREE
#endif

/* On a host the files in assembly have no code. This section states that they need no
 * executable stack. */
#if defined __ASSEMBLER__ && defined __ELF__ && defined __linux__
/* clang-format off */
    .section .note.GNU-stack, "", %progbits
    .text
/* clang-format on */
#endif

#endif
