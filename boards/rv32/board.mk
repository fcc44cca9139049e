# SPDX-License-Identifier: MIT
# QEMU's virt machine: a RISC-V core of 32 bits, as of an ESP32-C3, with a multiplier and compressed instructions, without FPU.

BOARD_CPU := rv32imc
BOARD_CORE := -march=rv32imc -mabi=ilp32 -mcmodel=medany -msmall-data-limit=0
BOARD_CROSS := riscv64-unknown-elf-
BOARD_QEMU := -M virt -bios none
BOARD_NOTE := emulator=qemu-system-riscv32
# make test installs none of its tools, and runs nothing on it: make run, boards and test with BOARD=rv32 do.
BOARD_SETUP := riscv
BOARD_BENCH := rv32
BOARD_LIBC := --specs=picolibc.specs
BOARD_OWN_FLAGS := $(BOARD_LIBC) # its headers; programs link none of it

# Of 4 MiB, like mps2-an500: any screen in one band.
BOARD_BAND_BYTES := 1048576
BOARD_ORDER_ENTRIES := 65536
BOARD_LIST_BYTES := 262144
BOARD_CACHE_ENTRIES := 1024

# RAM from 0x80000000 on, where the core begins. The tools treat the first 4 MiB as flash, with sectors of 4 KiB.
BOARD_MEMORY := flash_base=0x80000000 flash_size=4M flash_sector=4K program_size=512K \
    ram_base=0x80800000 ram_size=4M stack_size=64K handler_stack_size=2K

BOARD_PARTS := $(EMULATED_PARTS) riscv
BOARD_SOURCES := boards/rv32/board.c
