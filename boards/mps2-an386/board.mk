# SPDX-License-Identifier: MIT
# Arm MPS2 with image AN386: a Cortex-M4 with FPU and DSP
# instructions, as QEMU emulates it.
# Fixel needs no FPU, and the start-up code does not turn it on: soft ABI.

BOARD_CPU := cortex-m4
BOARD_CORE := -mcpu=cortex-m4 -mthumb -mfloat-abi=soft -mno-unaligned-access
BOARD_QEMU := -M mps2-an386
BOARD_NOTE := window=16777216
BOARD_BENCH := m4f

# Of 4 MiB: any screen in one band, and as many objects as an image can name.
BOARD_BAND_BYTES := 1048576
BOARD_ORDER_ENTRIES := 65536
BOARD_LIST_BYTES := 262144
BOARD_CACHE_ENTRIES := 1024

BOARD_SETTINGS := BOARD_SYSTICK_HZ=25000000u CMSDK_WATCHDOG_BASE=0x40008000u CMSDK_WATCHDOG_HZ=25000000u

BOARD_SOURCES := boards/mps2-an386/board.c \
    $(addprefix boards/parts/,cortexm_start.c cortexm_fault.c thumb.c armv7m_fault.c armv7m_protect.c stack.c \
        systick.c systick_clock.c cmsdk_watchdog.c semihosting.c semihosting_system.c semihosting_sink.c \
        display.c dump.c window.c window_input.c window_panels.c partition_store.c memory_functions.c board_note.c)
