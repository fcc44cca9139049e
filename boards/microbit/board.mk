# SPDX-License-Identifier: MIT
# BBC micro:bit: an nRF51822, Cortex-M0 (no long multiplication, no division, no
# memory protection), 256 KiB of flash, 16 KiB of RAM.

BOARD_CPU := cortex-m0
BOARD_CORE := -mcpu=cortex-m0 -mthumb -mfloat-abi=soft
BOARD_CLOCK := 16
BOARD_QEMU := -M microbit
BOARD_OPENOCD := -f interface/cmsis-dap.cfg -f target/nrf51.cfg

# Of 16 KiB. The driver of a display in colour takes some 2 KiB of it: then a band has three rows of 320, which
# are sent one by one. One in black and white takes less, and wants eight rows of 128, in RGB565 too.
BOARD_BAND_BYTES := $(if $(DRIVER),$(if $(filter $(DRIVERS_OF_PAGES),$(DRIVER)),2048,1024),2560)
BOARD_ORDER_ENTRIES := 200
BOARD_LIST_BYTES := $(if $(DRIVER),$(if $(filter $(DRIVERS_OF_PAGES),$(DRIVER)),2648,3352),4096)
BOARD_DRIVER_ROWS := 1
BOARD_CACHE_ENTRIES := 8

# Speed is the library's: the programs are small so that the game, too, fits into its 128 KiB.
BOARD_OWN_FLAGS := -Os

# Beside the game and the driver of a display, RGB565 with a depth buffer would take 3 to 4 KiB of flash more than there is.
# Depth buffers of 32 bits a pixel would take 7 KiB of flash more than there is.
BOARD_SETTINGS := BOARD_SYSTICK_HZ=16000000u WALK_WITHOUT_ORTHOGRAPHIC WALK_WITHOUT_DEPTH_32 WALK_WITHOUT_LINES WALK_WITHOUT_HORIZON GAME_WITHOUT_RGB565_DEPTH

# Flash has pages of 1 KiB.
BOARD_MEMORY := flash_base=0x00000000 flash_size=256K flash_sector=1K program_size=194K \
    ram_base=0x20000000 ram_size=16K stack_size=3104 handler_stack_size=600

BOARD_PARTS := $(CORTEXM_PARTS) armv6m_fault
