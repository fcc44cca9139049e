/* SPDX-License-Identifier: MIT */
/* The leading zeros of a word, and the reciprocal of 16 bits of core.h, for kernels of Armv6-M. */
#ifndef FXL_RECIPROCAL_ARMV6M_H
#define FXL_RECIPROCAL_ARMV6M_H

/* Shifts \value, which is not 0, until its highest bit is 1; \zeros: by how many bits. Overwrites \spare. */
    .macro  normalise value, zeros, spare
    movs    \zeros, #0
    lsrs    \spare, \value, #16
    bne     1f
    adds    \zeros, \zeros, #16
    lsls    \value, \value, #16
1:  lsrs    \spare, \value, #24
    bne     1f
    adds    \zeros, \zeros, #8
    lsls    \value, \value, #8
1:  lsrs    \spare, \value, #28
    bne     1f
    adds    \zeros, \zeros, #4
    lsls    \value, \value, #4
1:  lsrs    \spare, \value, #30
    bne     1f
    adds    \zeros, \zeros, #2
    lsls    \value, \value, #2
1:  cmp     \value, #0
    blt     1f
    adds    \zeros, \zeros, #1
    lsls    \value, \value, #1
1:
    .endm

/* r4 = the reciprocal of r6 = D, which is from 2^15 to 2^16 - 1: r from the table, then 2 r - r^2 D twice.
 * Overwrites r2 and r7. */
    .macro  reciprocal
    lsrs    r7, r6, #9
    subs    r7, r7, #64
    ldr     r4, =fxl_reciprocals_armv6m
    ldrb    r4, [r4, r7]
    movs    r7, r4
    muls    r7, r4
    muls    r7, r6
    lsrs    r7, r7, #15
    lsls    r4, r4, #9
    subs    r4, r4, r7
    movs    r7, r4
    muls    r7, r6
    movs    r2, #1
    lsls    r2, r2, #31
    subs    r2, r2, r7
    asrs    r2, r2, #4
    muls    r2, r4
    asrs    r2, r2, #27
    adds    r4, r4, r2
    .endm

#endif
