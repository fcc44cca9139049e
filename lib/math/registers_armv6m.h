/* SPDX-License-Identifier: MIT */
/* How a kernel of Armv6-M keeps the registers of its caller, r4 to r11, which it overwrites. */
#ifndef FXL_REGISTERS_ARMV6M_H
#define FXL_REGISTERS_ARMV6M_H

/* Pushes r4 to r7 and lr, and below them r8 to r11. Overwrites r4 to r7. */
    .macro  save_registers
    push    {r4-r7, lr}
    mov     r4, r8
    mov     r5, r9
    mov     r6, r10
    mov     r7, r11
    push    {r4-r7}
    .endm

/* Returns to the caller; the stack is as save_registers has left it. */
    .macro  restore_and_return
    pop     {r4-r7}
    mov     r8, r4
    mov     r9, r5
    mov     r10, r6
    mov     r11, r7
    pop     {r4-r7, pc}
    .endm

#endif
