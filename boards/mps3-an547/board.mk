# SPDX-License-Identifier: MIT
# Arm MPS3 with image AN547: a Cortex-M55, as QEMU emulates it.
# All runs in the secure state.
# Fixel needs no FPU and does not use the vector extension (MVE), and the
# start-up code turns neither on: soft ABI, which keeps gcc from both.

BOARD_CPU := cortex-m55
BOARD_CORE := -mcpu=cortex-m55 -mthumb -mfloat-abi=soft -mno-unaligned-access
BOARD_CLOCK := 32
BOARD_QEMU := -M mps3-an547
BOARD_NOTE := window=2147483648
BOARD_BENCH := m55

# Of 512 KiB: 320x240 in one band, larger screens in a few.
BOARD_BAND_BYTES := 131072
BOARD_ORDER_ENTRIES := 16384
BOARD_LIST_BYTES := 65536
BOARD_CACHE_ENTRIES := 1024

# The watchdog on the NMI counts the board's slow clock.
BOARD_SETTINGS := BOARD_SYSTICK_HZ=32000000u CMSDK_WATCHDOG_BASE=0x5802E000u CMSDK_WATCHDOG_HZ=32768u

# Its code memory is RAM that the tools and the memory protection treat as flash; a sector of 4 KiB is what we made up.
# The scene lies in the flash behind the QSPI controller, of which the first 2 MiB are used. The window is the DDR4, which QEMU
# can share.
BOARD_MEMORY := flash_base=0x00000000 flash_size=512K flash_sector=4K scene_flash_base=0x28000000 scene_flash_size=2M program_size=512K \
    ram_base=0x20000000 ram_size=512K stack_size=64K handler_stack_size=2K window=0x60000000 window_size=2048M

BOARD_PARTS := $(CORTEXM_PARTS) armv7m_fault cmsdk_watchdog window
