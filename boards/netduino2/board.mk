# SPDX-License-Identifier: MIT
# Netduino 2: an STM32F205, a Cortex-M3 without FPU, 128 KiB of RAM; of its flash
# the 512 KiB that are a power of two (the chip has 768, QEMU's 1024).

BOARD_CPU := cortex-m3
# For size, but not FXL_SMALL: this is the board that draws with the compact kernels.
BOARD_CORE := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -mno-unaligned-access -Os
BOARD_QEMU := -M netduino2
# place board: in the copy: flags of the core, arguments of QEMU, memory, parts
BOARD_OPENOCD := -f interface/stlink.cfg -f target/stm32f2x.cfg

# Of 128 KiB, the stacks taking 10: half of a 320 x 240 frame, objects for any
# scene that its flash can hold, and the polygons of a full frame.
BOARD_BAND_BYTES := 38400
BOARD_ORDER_ENTRIES := 2048
BOARD_LIST_BYTES := 32768
BOARD_CACHE_ENTRIES := 256

# QEMU's 120 MHz; the real chip runs at 16 MHz until it is told otherwise.
BOARD_SETTINGS := BOARD_SYSTICK_HZ=120000000u

BOARD_SOURCES := boards/netduino2/board.c \
    $(addprefix boards/parts/,cortexm_start.c cortexm_fault.c thumb.c armv7m_fault.c armv7m_protect.c stack.c \
        systick.c systick_clock.c systick_watchdog.c semihosting.c semihosting_system.c semihosting_sink.c \
        semihosting_keys.c display.c dump.c partition_store.c memory_functions.c board_note.c)
