# SPDX-License-Identifier: MIT
# Luminary Micro (now TI) EK-LM3S6965: a Cortex-M3 with an OLED and five keys.

BOARD_CPU := cortex-m3
BOARD_CORE := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -mno-unaligned-access
BOARD_CLOCK := 50
BOARD_QEMU := -M lm3s6965evb
BOARD_OPENOCD := -f board/ek-lm3s6965.cfg
# Which of its keys a viewer's bits of fixel/player.h are.
BOARD_NOTE := keys=1:up,2:down,4:left,8:right,16:ctrl+up,32:ctrl+down,64:ctrl+left,128:ctrl+right

# Of 64 KiB: the OLED's frame in one band, other screens in several.
BOARD_BAND_BYTES := 8192
BOARD_ORDER_ENTRIES := 1024
BOARD_LIST_BYTES := 16384
BOARD_CACHE_ENTRIES := 64

# Speed is the library's: the programs are small so that the driver of a display, too, fits beside the scenes' 58 KiB.
BOARD_OWN_FLAGS := -Os

# Beside the game and the driver of a display, RGB565 with a depth buffer would take 3 to 4 KiB of flash more than there is.
# Beside the driver of a display depth buffers of 32 bits a pixel would take 5 KiB of flash more than there is.
# After reset the core runs at 12.5 MHz, and the watchdog with it; its interrupt
# is number 18.
BOARD_SETTINGS := BOARD_SYSTICK_HZ=12500000u CMSDK_WATCHDOG_BASE=0x40000000u CMSDK_WATCHDOG_HZ=12500000u \
    CMSDK_WATCHDOG_INTERRUPT=18u WALK_WITHOUT_ORTHOGRAPHIC WALK_WITHOUT_DEPTH_32 WALK_WITHOUT_LINES WALK_WITHOUT_HORIZON GAME_WITHOUT_RGB565_DEPTH

# Flash has pages of 1 KiB.
BOARD_MEMORY := flash_base=0x00000000 flash_size=256K flash_sector=1K program_size=198K \
    ram_base=0x20000000 ram_size=64K stack_size=4K handler_stack_size=1K

BOARD_PARTS := $(CORTEXM_PARTS) armv7m_fault cmsdk_watchdog ssd0323 pl022 keys
BOARD_SOURCES := boards/lm3s6965evb/board.c
