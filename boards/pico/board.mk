# SPDX-License-Identifier: MIT
# Raspberry Pi Pico: an RP2040, of which one Cortex-M0+ is used (a multiplier of one cycle, no division, no memory protection),
# 2 MiB of flash, 264 KiB of RAM. rp2040js emulates it, under Node.

BOARD_CPU := cortex-m0plus
BOARD_CORE := -mcpu=cortex-m0plus -mthumb -mfloat-abi=soft
BOARD_CLOCK := 125
BOARD_OPENOCD := -f interface/cmsis-dap.cfg -f target/rp2040.cfg
BOARD_NOTE := emulator=rp2040js counts=cycles uf2=e48bff56
# make test installs none of its tools, and runs nothing on it: make run, boards and test with BOARD=pico do.
BOARD_SETUP := pico
BOARD_UNITS_APART := yes # half an hour

# Of 264 KiB, the stacks taking 9: 40 rows of 320, objects for any scene that its flash can hold, and the polygons of a full frame.
BOARD_BAND_BYTES := 25600
BOARD_ORDER_ENTRIES := 2048
BOARD_LIST_BYTES := 131072
BOARD_CACHE_ENTRIES := 256

# A driver of DRIVER= sends by SPI and DMA.
BOARD_WIRES := boards/pico/spi_wires
BOARD_DRIVER_ROWS := 20 10
BOARD_ALONE := rp2040_uart_text

# The boot ROM copies the first 256 bytes of flash to RAM and runs them: boot2.c. The vector table follows.
BOARD_MEMORY := flash_base=0x10000000 flash_size=2M flash_sector=4K program_size=512K boot_size=256 \
    ram_base=0x20000000 ram_size=264K stack_size=8K handler_stack_size=1K

BOARD_PARTS := $(filter-out systick,$(CORTEXM_PARTS)) armv6m_fault
BOARD_SOURCES := $(addprefix boards/pico/,board.c boot2.c rp2040.c)
