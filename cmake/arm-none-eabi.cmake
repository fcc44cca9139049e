# SPDX-License-Identifier: MIT
# A toolchain file of CMake for Arm Cortex-M, with Debian's gcc-arm-none-eabi or any other arm-none-eabi-gcc:
#
#   cmake -DCMAKE_TOOLCHAIN_FILE=path/to/cmake/arm-none-eabi.cmake -DFIXEL_CPU=cortex-m0plus ...
#
# FIXEL_CPU is the core, FIXEL_CPU_FLAGS are flags of an ABI of your own, say "-mfloat-abi=hard -mfpu=fpv4-sp-d16".
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(FIXEL_CPU cortex-m3 CACHE STRING "the core, as -mcpu= names it")
set(FIXEL_CPU_FLAGS "" CACHE STRING "more flags of the core")
# CMake tries the compiler in a project of its own, which has no start code to link.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FIXEL_CPU FIXEL_CPU_FLAGS)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# The core is a part of the compiler's name, so that -DCMAKE_C_FLAGS=-Os adds to it for C, and does not take it away.
separate_arguments(FIXEL_CORE UNIX_COMMAND "-mcpu=${FIXEL_CPU} -mthumb ${FIXEL_CPU_FLAGS}")
set(CMAKE_C_COMPILER arm-none-eabi-gcc ${FIXEL_CORE})
set(CMAKE_CXX_COMPILER arm-none-eabi-g++ ${FIXEL_CORE})
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc ${FIXEL_CORE})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
