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

# Flash has sectors of 16, 64 and 128 KiB; the small ones, the first five, together make up one of the large size: they and the
# next one are the program's.
BOARD_MEMORY := flash_base=0x08000000 flash_size=512K flash_sector=128K program_size=256K \
    ram_base=0x20000000 ram_size=128K stack_size=8K handler_stack_size=2K
# Count and size of each run of equal sectors.
BOARD_SECTORS := 4,16384 1,65536 3,131072

BOARD_PARTS := $(CORTEXM_PARTS) armv7m_fault
