# SPDX-License-Identifier: MIT
# Arm MPS2 with image AN385: a Cortex-M3 without FPU, as QEMU emulates it.

BOARD_CPU := cortex-m3
BOARD_CORE := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -mno-unaligned-access
BOARD_QEMU := -M mps2-an385
BOARD_NOTE := window=16777216
BOARD_BENCH := m0 m3

# Of 4 MiB: any screen in one band, and as many objects as an image can name.
BOARD_BAND_BYTES := 1048576
BOARD_ORDER_ENTRIES := 65536
BOARD_LIST_BYTES := 262144
BOARD_CACHE_ENTRIES := 1024

BOARD_SETTINGS := BOARD_SYSTICK_HZ=25000000u CMSDK_WATCHDOG_BASE=0x40008000u CMSDK_WATCHDOG_HZ=25000000u

BOARD_SOURCES := boards/mps2-an385/board.c \
    $(addprefix boards/parts/,cortexm_start.c cortexm_fault.c thumb.c armv7m_fault.c armv7m_protect.c stack.c \
        systick.c systick_clock.c cmsdk_watchdog.c semihosting.c semihosting_system.c semihosting_sink.c \
        display.c dump.c window.c window_input.c ssd0303.c sbcon.c partition_store.c memory_functions.c \
        board_note.c)
