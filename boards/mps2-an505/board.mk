# SPDX-License-Identifier: MIT
# Arm MPS2 with image AN505: a Cortex-M33 with FPU, DSP
# instructions and TrustZone, as QEMU emulates it. All runs in the secure state.
# Fixel needs no FPU, and the start-up code does not turn it on: soft ABI.

BOARD_CPU := cortex-m33
# For size: this is the board that has room for every test of the small library.
BOARD_CORE := -mcpu=cortex-m33 -mthumb -mfloat-abi=soft -mno-unaligned-access -Os \
    -DFXL_SMALL
BOARD_QEMU := -M mps2-an505
BOARD_NOTE := window=16777216

# Of 4 MiB: any screen in one band, and as many objects as an image can name.
BOARD_BAND_BYTES := 1048576
BOARD_ORDER_ENTRIES := 65536
BOARD_LIST_BYTES := 262144
BOARD_CACHE_ENTRIES := 1024

# The watchdog on the NMI counts the board's slow clock.
BOARD_SETTINGS := BOARD_SYSTICK_HZ=20000000u CMSDK_WATCHDOG_BASE=0x5002E000u CMSDK_WATCHDOG_HZ=32768u

BOARD_SOURCES := boards/mps2-an505/board.c \
    $(addprefix boards/parts/,cortexm_start.c cortexm_fault.c thumb.c armv7m_fault.c armv8m_protect.c stack.c \
        systick.c systick_clock.c cmsdk_watchdog.c semihosting.c semihosting_system.c semihosting_sink.c \
        display.c dump.c window.c window_input.c window_panels.c partition_store.c memory_functions.c board_note.c)
