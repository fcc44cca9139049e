/* SPDX-License-Identifier: MIT */
/* Which core a file is compiled for, and so which kernels it has: for lib/kernels alone, in C
 * and in assembly. The compiler's own macros decide, so every file of lib/ may be compiled for
 * any core: of each kernel exactly one file has contents.
 *
 *   FXL_CORE_ARMV6M  Thumb alone (Cortex-M0, M0+, M1, M23): no long product, no division
 *   FXL_CORE_ARMV7M  Thumb-2 (Cortex-M3, M4, M7, M33 and above): long products, UDIV, CLZ
 *
 * Each is 0 or 1. Inline kernels go by these. Kernels in assembly are quick and take many
 * bytes, so a library built with FXL_SMALL has none:
 *
 *   FXL_KERNELS_ARMV6M, FXL_KERNELS_ARMV7M
 *   FXL_KERNELS_MVE  vectors (M55, M85) in place of some of Armv7-M's, where the ABI passes
 *                    floats in registers: then the program has turned the unit on */
#ifndef FXL_FAMILY_H
#define FXL_FAMILY_H

#include "../include/fixel/config.h"

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

#define FXL_KERNELS_ARMV6M (FXL_CORE_ARMV6M && !FXL_IS_SMALL)
#define FXL_KERNELS_ARMV7M (FXL_CORE_ARMV7M && !FXL_IS_SMALL)

#if FXL_KERNELS_ARMV7M && defined __ARM_FEATURE_MVE && defined __ARM_PCS_VFP
#define FXL_KERNELS_MVE 1
#else
#define FXL_KERNELS_MVE 0
#endif

/* On a host these files are empty, and say that they need no executable stack. */
#if defined __ASSEMBLER__ && defined __ELF__ && defined __linux__
/* clang-format off */
    .section .note.GNU-stack, "", %progbits
    .text
/* clang-format on */
#endif

#endif
