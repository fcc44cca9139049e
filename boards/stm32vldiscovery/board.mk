# SPDX-License-Identifier: MIT
# ST's STM32VLDISCOVERY: an STM32F100, a Cortex-M3 without FPU, 128 KiB of
# flash, 8 KiB of RAM.

BOARD_CPU := cortex-m3
BOARD_CORE := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -mno-unaligned-access
BOARD_CLOCK := 24
BOARD_QEMU := -M stm32vldiscovery
BOARD_OPENOCD := -f board/stm32vldiscovery.cfg

# How 8192 bytes are shared out: BOARD_MEMORY has the program's stack and the
# handlers'; the renderer takes 2576, and these take the rest: eight rows of 128, or one
# of the widest screen; the 174 objects of the plaza, or what scenes/landscape.toml sorts; a list of
# 14 polygons of four vertices, in which most frames of scenes/tiny.toml fit; no vertices are kept.
# A program with surfaces has a larger stack and fewer entries. What else the walk is made of
# knows nothing of the entries, so only its own object differs.
BOARD_BAND_BYTES := 1024
BOARD_ORDER_ENTRIES := $(if $(filter surfaces,$(VISIBILITY)),106,178)
BOARD_LIST_BYTES := 560
BOARD_CACHE_ENTRIES := 0

# The game would take 6 KiB of flash more than there is.
BOARD_PROGRAM_OMIT := game
# These programs would take 1 to 23 KiB of flash more than there is.
BOARD_VISIBILITY_OMIT := box spans spans-box tree tree-spans depth depth-32
# The driver of a display would take 2 KiB of each that there are not.
BOARD_DRIVER_ROWS := 0

# Speed is the library's: the program is small so that it fits into its 64 KiB.
BOARD_OWN_FLAGS := -Os

# A BSP tree would take 4 KiB of flash more than the program has, and of stack more than there is. Surfaces take
# 36 KiB of flash: the program of VISIBILITY=surfaces has them, and scenes have 36 KiB less. Billboards
# would take 4 KiB, RGB565 more.
BOARD_SETTINGS := BOARD_SYSTICK_HZ=24000000u WALK_WITHOUT_ORTHOGRAPHIC WALK_WITHOUT_BSP WALK_WITHOUT_SURFACES WALK_WITHOUT_BILLBOARDS WALK_WITHOUT_LINES WALK_WITHOUT_HORIZON WALK_WITHOUT_DEPTH WALK_WITHOUT_RGB565

# Flash has pages of 1 KiB. A program with surfaces takes 36 of the 61 KiB that scenes have beside others.
BOARD_MEMORY := flash_base=0x08000000 flash_size=128K flash_sector=1K program_size=67K \
    ram_base=0x20000000 ram_size=8K stack_size=1048 handler_stack_size=216
BOARD_MEMORY_FOR_SURFACES := program_size=103K stack_size=1912

BOARD_PARTS := $(CORTEXM_PARTS) armv7m_fault
