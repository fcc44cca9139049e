/* SPDX-License-Identifier: MIT */
/* The second boot stage, the first 256 bytes of flash (RP2040 data sheet, section 2.8.1). The boot
 * ROM copies them to RAM, checks the CRC in the last four, and calls them. They set up the flash
 * for plain reads, command 03h, which every flash of this kind knows: 32 bits for each command and
 * address, at a quarter of the system's clock. Then they go to the vector table behind them, or
 * return if the boot ROM or a debugger left a return address.
 *
 * The CRC is CRC-32/MPEG-2 of the first 252 bytes: polynomial 04C11DB7h, first value FFFFFFFFh,
 * nothing reflected or inverted. If the code changes, host_tests/anywhere/pico/test_pico.py says
 * what it is now. */

__asm__(".section .boot2, \"ax\", %progbits\n"
        "pico_boot2:\n\t"
        "push {lr}\n\t"
        "ldr r3, =0x18000000\n\t" /* the registers of the flash's serial interface, SSI */
        "movs r1, #0\n\t"
        "str r1, [r3, #0x08]\n\t" /* SSIENR: off, so that it may be set up */
        "movs r1, #4\n\t"
        "str r1, [r3, #0x14]\n\t" /* BAUDR: the divisor of the clock */
        "ldr r1, =0x001F0300\n\t" /* one wire, 32 bits a frame, send then receive */
        "str r1, [r3, #0x00]\n\t" /* CTRLR0 */
        "movs r1, #0\n\t"
        "str r1, [r3, #0x04]\n\t" /* CTRLR1: one frame a read */
        "ldr r1, =0x03000218\n\t" /* command 03h of 8 bits, an address of 24 bits, no wait cycles */
        "movs r0, #0xF4\n\t"
        "str r1, [r3, r0]\n\t" /* SPI_CTRLR0 */
        "movs r1, #1\n\t"
        "str r1, [r3, #0x08]\n\t" /* SSIENR: on */
        "pop {r0}\n\t"
        "cmp r0, #0\n\t"
        "beq 1f\n\t"
        "bx r0\n"
        "1:\n\t"
        "ldr r0, =0x10000100\n\t" /* the vector table */
        "ldr r1, =0xE000ED08\n\t" /* VTOR */
        "str r0, [r1]\n\t"
        "ldmia r0!, {r1, r2}\n\t"
        "msr msp, r1\n\t"
        "bx r2\n\t"
        ".ltorg\n\t"
        ".space 252 - (. - pico_boot2)\n\t"
        ".word 0xF6A447D6\n\t"
        ".text");
