# SPDX-License-Identifier: MIT
# Arm MPS3 with image AN547: a Cortex-M55, as QEMU emulates it.
# All runs in the secure state.
# Fixel needs no FPU and does not use the vector extension (MVE), and the
# start-up code turns neither on: soft ABI, which keeps gcc from both.

BOARD_CPU := cortex-m55
BOARD_CORE := -mcpu=cortex-m55 -mthumb -mfloat-abi=soft -mno-unaligned-access
BOARD_QEMU := -M mps3-an547
BOARD_NOTE := window=2147483648
BOARD_BENCH := m55

# Of 512 KiB: 320x240 in one band, larger screens in a few.
BOARD_BAND_BYTES := 131072
BOARD_ORDER_ENTRIES := 16384
BOARD_LIST_BYTES := 65536
BOARD_CACHE_ENTRIES := 1024

# The watchdog on the NMI counts the board's slow clock.
BOARD_SETTINGS := BOARD_SYSTICK_HZ=32000000u CMSDK_WATCHDOG_BASE=0x5802E000u CMSDK_WATCHDOG_HZ=32768u

BOARD_SOURCES := boards/mps3-an547/board.c \
    $(addprefix boards/parts/,cortexm_start.c cortexm_fault.c thumb.c armv7m_fault.c armv8m_protect.c stack.c \
        systick.c systick_clock.c cmsdk_watchdog.c semihosting.c semihosting_system.c semihosting_sink.c \
        display.c dump.c window.c window_input.c window_panels.c partition_store.c memory_functions.c board_note.c)
