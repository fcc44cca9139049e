# SPDX-License-Identifier: MIT
# Arm MPS2 with image AN500: a Cortex-M7 with FPU and DSP
# instructions, as QEMU emulates it.
# Fixel needs no FPU, and the start-up code does not turn it on: soft ABI.

BOARD_CPU := cortex-m7
BOARD_CORE := -mcpu=cortex-m7 -mthumb -mfloat-abi=soft -mno-unaligned-access
BOARD_CLOCK := 25
BOARD_QEMU := -M mps2-an500
BOARD_NOTE := window=16777216

# Of 4 MiB: any screen in one band, and as many objects as an image can name.
BOARD_BAND_BYTES := 1048576
BOARD_ORDER_ENTRIES := 65536
BOARD_LIST_BYTES := 262144
BOARD_CACHE_ENTRIES := 1024

BOARD_SETTINGS := BOARD_SYSTICK_HZ=25000000u CMSDK_WATCHDOG_BASE=0x40008000u CMSDK_WATCHDOG_HZ=25000000u

# Its code memory is RAM that the tools and the memory protection treat as flash; a sector of 4 KiB is what we made up.
# The window is the PSRAM, which QEMU can share.
BOARD_MEMORY := flash_base=0x00000000 flash_size=4M flash_sector=4K program_size=512K \
    ram_base=0x20000000 ram_size=4M stack_size=64K handler_stack_size=2K window=0x60000000 window_size=16M

BOARD_PARTS := $(CORTEXM_PARTS) armv7m_fault cmsdk_watchdog window
