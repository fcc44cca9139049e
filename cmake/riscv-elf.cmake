# SPDX-License-Identifier: MIT
# A toolchain file of CMake for RISC-V of 32 bits without an operating system, with Debian's gcc-riscv64-unknown-elf:
#
#   cmake -DCMAKE_TOOLCHAIN_FILE=path/to/cmake/riscv-elf.cmake -DFIXEL_ARCH=rv32imc ...
#
# FIXEL_ARCH is the instruction set, FIXEL_ABI the ABI. Another compiler: -DFIXEL_CROSS=riscv32-esp-elf-
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(FIXEL_ARCH rv32imc CACHE STRING "the instruction set, as -march= names it")
set(FIXEL_ABI ilp32 CACHE STRING "the ABI, as -mabi= names it")
set(FIXEL_CROSS riscv64-unknown-elf- CACHE STRING "how the names of the compilers begin")
# CMake tries the compiler in a project of its own, which has no start code to link.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FIXEL_ARCH FIXEL_ABI FIXEL_CROSS)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Debian's compiler has no C library, and no stdint.h without -ffreestanding; with a library, FIXEL_LIBC is what chooses it.
set(FIXEL_LIBC -ffreestanding CACHE STRING "flags of the C library, such as --specs=picolibc.specs")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FIXEL_LIBC)
# The small data section would need a register that start code sets up; medany reaches RAM from 0x80000000 on. All this is a part of the
# compiler's name, so that -DCMAKE_C_FLAGS=-Os adds to it.
separate_arguments(FIXEL_CORE UNIX_COMMAND "-march=${FIXEL_ARCH} -mabi=${FIXEL_ABI} -mcmodel=medany -msmall-data-limit=0 ${FIXEL_LIBC}")
set(CMAKE_C_COMPILER ${FIXEL_CROSS}gcc ${FIXEL_CORE})
set(CMAKE_CXX_COMPILER ${FIXEL_CROSS}g++ ${FIXEL_CORE})
set(CMAKE_ASM_COMPILER ${FIXEL_CROSS}gcc ${FIXEL_CORE})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
