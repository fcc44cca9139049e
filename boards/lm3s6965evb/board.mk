# SPDX-License-Identifier: MIT
# Luminary Micro (now TI) EK-LM3S6965: a Cortex-M3 with an OLED and five keys.

BOARD_CPU := cortex-m3
BOARD_CORE := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -mno-unaligned-access
BOARD_QEMU := -M lm3s6965evb

# Of 64 KiB: the OLED's frame in one band, other screens in several.
BOARD_BAND_BYTES := 8192
BOARD_ORDER_ENTRIES := 1024
BOARD_LIST_BYTES := 16384

BOARD_SOURCES := boards/lm3s6965evb/board.c \
    $(addprefix boards/parts/,armv7m_start.c armv7m_fault.c armv7m_protect.c systick.c \
        semihosting.c semihosting_system.c semihosting_sink.c display.c dump.c partition_store.c \
        ssd0323.c grey.c pl022.c memory_functions.c board_note.c)
