# SPDX-License-Identifier: MIT
# Netduino Plus 2: an STM32F405, Cortex-M4 with FPU (which Fixel does not use),
# 1 MiB of flash, 128 KiB of RAM at 0x20000000 (64 KiB more, elsewhere, stay unused).

BOARD_CPU := cortex-m4
BOARD_CORE := -mcpu=cortex-m4 -mthumb -mfloat-abi=soft -mno-unaligned-access
BOARD_CLOCK := 168
BOARD_QEMU := -M netduinoplus2
BOARD_OPENOCD := -f interface/stlink.cfg -f target/stm32f4x.cfg

# Of 128 KiB, the stacks taking 10: half of a 320 x 240 frame, objects for any
# scene that its flash can hold, and the polygons of a full frame.
BOARD_BAND_BYTES := 38400
BOARD_ORDER_ENTRIES := 2048
BOARD_LIST_BYTES := 32768
BOARD_CACHE_ENTRIES := 256

# Beside the game and the driver of a display, RGB565 with a depth buffer would take 3 to 4 KiB of flash more than there is.
# QEMU's 168 MHz; the real chip runs at 16 MHz until it is told otherwise.
BOARD_SETTINGS := BOARD_SYSTICK_HZ=168000000u GAME_WITHOUT_RGB565_DEPTH

# Flash has sectors of 16, 64 and 128 KiB; the small ones, the first five, together make up one of the large size: all of the
# program's.
BOARD_MEMORY := flash_base=0x08000000 flash_size=1M flash_sector=128K program_size=256K \
    ram_base=0x20000000 ram_size=128K stack_size=8K handler_stack_size=2K
# Count and size of each run of equal sectors.
BOARD_SECTORS := 4,16384 1,65536 7,131072

BOARD_PARTS := $(CORTEXM_PARTS) armv7m_fault
