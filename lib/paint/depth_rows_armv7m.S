/* SPDX-License-Identifier: MIT */
/* fxl_find_depth_runs and fxl_find_visible_runs for Armv7-M and Armv8-M Mainline: lib/paint/depth_rows.h
 * states what they require and do. The first one keeps what lib/paint/depth_row.h keeps. A row takes
 * about 65 instructions before its pixels, with its run. A visible pixel takes 3 where nothing was
 * drawn before, and 6 elsewhere; a hidden one 4. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

    .syntax unified
    .thumb

/* The frame */
#define F_ROWS 0 /* the fxl_depth_rows */
#define F_REST 4 /* pixels of the row that are in octaves after this one */
#define F_RUNS 8 /* where the next run goes; then the end */
#define F_SIZE 16

#define HAS_REST 0x40000000 /* of r12 */
#define OF_OCTAVE(member) (member - DEPTH_ROWS_ZEROS)

/* Results: \low, \high: the 32 lowest bits of (\high:\low) >> \drop, in \low. drop: 1 to 34. */
    .macro shift_by drop, low, high, spare
    rsbs    \spare, \drop, #32
    itee    pl
    lslpl   \high, \high, \spare
    rsbmi   \spare, \spare, #0
    asrmi   \high, \high, \spare
    lsr     \low, \low, \drop
    add     \low, \low, \high
    .endm

/* Lists the run in r0; goes to \full if no room is left. Overwrites r6, r7. */
    .macro  put_run full
    bic     r12, r12, #0x80000000
    ldrd    r6, r7, [sp, #F_RUNS]
    str     r0, [r6], #4
    str     r6, [sp, #F_RUNS]
    cmp     r6, r7
    beq     \full
    .endm

/* The same of the run from r1 to \end, of cells. */
    .macro  list_run end, full
    sub     r0, r1, r10
    sub     r6, \end, r10
    and     r7, r12, #0x80000000
    orr     r0, r7, r0, lsr #1
    orr     r0, r0, r6, lsl #15
    put_run \full
    .endm

/* Where codes are kept a cell hides what is as near as it; elsewhere it does not. */
    .macro  if_hidden keeps, label
    .if     \keeps
    bls     \label
    .else
    blo     \label
    .endif
    .endm
    .macro  if_visible keeps, label
    .if     \keeps
    blo     \label
    .else
    bls     \label
    .endif
    .endm

/* Keeps the code of r0 in the cell of r4, if at all, and goes on to the next cell. */
    .macro  keep_code keeps
    .if     \keeps
    strh    r0, [r4], #2
    .else
    adds    r4, r4, #2
    .endif
    .endm

/* r0: rows; returns whether there is more to do. keeps: whether codes of visible pixels are kept. */
    .macro  find_runs name, keeps
    .section .text.\name, "ax", %progbits
    .type \name, %function
    .thumb_func
\name:
    push    {r4-r11, lr}
    sub     sp, #F_SIZE
    ldrd    r4, r5, [r0, #DEPTH_ROWS_RUNS]
    strd    r4, r5, [sp, #F_RUNS]
    movs    r6, #0
    strd    r0, r6, [sp, #F_ROWS]
    ldr     r5, [r0, #DEPTH_ROWS_RESUMED]
    ldr     r12, [r0, #DEPTH_ROWS_ROWS]
    cmp     r5, #0
    beq     .Lrow\@
    str     r6, [r0, #DEPTH_ROWS_RESUMED]
    ldr     r6, [r0, #DEPTH_ROWS_REST + 24]
    str     r6, [sp, #F_REST]
    add     r0, r0, #(DEPTH_ROWS_RESUMED + 4)
    ldm     r0, {r1-r4, r10-r12, lr}
    bx      r5

/* No room is left. r0: where to go on. */
.Lfull\@:
    ldrd    r5, r6, [sp, #F_ROWS]
    str     r6, [r5, #DEPTH_ROWS_REST + 24]
    ldr     r6, [sp, #F_RUNS]
    str     r6, [r5, #DEPTH_ROWS_RUNS]
    add     r5, r5, #DEPTH_ROWS_RESUMED
    stm     r5, {r0-r4, r10-r12, lr}
    movs    r0, #1
    add     sp, #F_SIZE
    pop     {r4-r11, pc}
.Lfull_end\@:
    adr     r0, .Lpart_done\@ + 1
    b       .Lfull\@
.Lfull_hidden\@:
    adr     r0, .Lhide\@ + 1
    b       .Lfull\@
.Lfull_each\@:
    adr     r0, .Leach_hide\@ + 1
    b       .Lfull\@

    /* A drop above 32. */
.Lfar_code\@:
    sub     r6, r7, #32
    asr     r4, r5, r6
    b       .Lfirst_code\@

    /* The right edge is not right of the left one. */
.Lno_pixel\@:
    beq     .Lempty\@
    mov     r2, r6
    rsb     r0, r0, #0
    b       .Lspan\@
.Lempty\@:
    ldm     r1!, {r4-r11}
    adds    r8, r4, r8
    adc     r9, r5, r9
    add     r11, r10, r11
    strd    r8, r9, [r1, #OF_OCTAVE(DEPTH_ROWS_VALUE)]
    str     r11, [r1, #OF_OCTAVE(DEPTH_ROWS_CELLS)]
    b       .Lpart_done\@

/* --- rows ------------------------------------------------------------------------------------- */

/* r0: rows, r12: how many, and in the uppermost bit whether the next run is in the row below; HAS_REST:
 * whether pixels of this row are in octaves after this one. */
.Lrow_below\@:
    orr     r12, r12, #0x80000000
.Lrow\@:
    ldm     r0, {r2-r9}
    adds    r3, r3, r5
    adc     r10, r2, r4
    adds    r7, r7, r9
    adc     r11, r6, r8
    strd    r10, r3, [r0]
    strd    r11, r7, [r0, #EDGE_SIZE]
    add     r1, r0, #DEPTH_ROWS_VALUE
    subs    r0, r6, r2
    ble     .Lno_pixel\@
.Lspan\@:                                 /* r0: pixels, r2: the first column */
    ldm     r1!, {r4-r11}               /* value, along, down, the row's cells and their bytes */
    adds    r8, r4, r8
    adc     r9, r5, r9
    add     r11, r10, r11
    strd    r8, r9, [r1, #OF_OCTAVE(DEPTH_ROWS_VALUE)]
    str     r11, [r1, #OF_OCTAVE(DEPTH_ROWS_CELLS)]

    /* r4, r5: the value in column 0, r6, r7: along. Whether the first pixel and the last are in the
     * octave that is known: then all are, as the value is linear. */
.Lpart\@:
    umull   r9, r8, r6, r2
    mla     r8, r7, r2, r8
    adds    r9, r9, r4
    adc     r8, r8, r5
    clz     r11, r8
    subs    r3, r0, #1
    umlal   r9, r8, r6, r3
    mla     r8, r7, r3, r8
    clz     r3, r8
    ldm     r1, {r6-r9, lr}             /* zeros, drop, bias, is_last, step */
    cmp     r11, r6
    it      eq
    cmpeq   r3, r6
    bne     .Loctave\@
.Lcode\@:
    mla     r3, lr, r2, r8
    rsbs    r6, r7, #32
    bmi     .Lfar_code\@
    lsls    r5, r5, r6
    lsrs    r4, r4, r7
    adds    r4, r4, r5
.Lfirst_code\@:
    add     r3, r3, r4

/* The pixels of a row that are in one octave: r0: how many, r2: their first column, r3: the code of
 * the first, lr: the step, r10: the cell of column 0. */
.Lcells\@:
    add     r4, r10, r2, lsl #1
    mov     r1, r4                      /* where the run begins that is not listed */
    add     r2, r4, r0, lsl #1          /* the end */
    sub     r11, r2, #16                /* the last cell at which eight begin */
    cmp     r4, r11
    bhi     .Lfew\@
    cmp     r9, #0
    bne     .Llast_octave\@

.Leight_or_seven\@:
    tst     r4, #2
    beq     .Leight\@
    ldrh    r6, [r4]
    lsrs    r0, r3, #16
    cmp     r0, r6
    if_hidden \keeps, .Lhidden\@
    keep_code \keeps
    add     r3, r3, lr
    cmp     r4, r11
    bhi     .Lfew\@

    /* Eight pixels. Where nothing was drawn, all are visible. */
.Leight\@:
    ldm     r4, {r6-r9}
    orr     r0, r6, r7
    orr     r0, r0, r8
    orrs    r0, r0, r9
    bne     .Leach_of_eight\@
    .if     \keeps
    .irp    two, r6, r7, r8, r9
    lsrs    r0, r3, #16
    add     \two, r3, lr
    bfi     \two, r0, #0, #16
    add     r3, r3, lr, lsl #1
    .endr
    stm     r4!, {r6-r9}
    .else
    add     r3, r3, lr, lsl #3
    adds    r4, r4, #16
    .endif
    cmp     r4, r11
    bls     .Leight\@

    /* Fewer than eight pixels, each tested for itself. */
.Lfew\@:
    subs    r0, r2, r4
    tbb     [pc, r0]
.Lfews\@:
    .irp    length, 0, 1, 2, 3, 4, 5, 6, 7
    .byte   (.Lfew\@_\length - .Lfews\@) / 2, 0
    .endr
    .irp    length, 7, 6, 5, 4, 3, 2, 1
.Lfew\@_\length:
    ldrh    r6, [r2, #-2 * \length]
    lsrs    r0, r3, #16
    cmp     r0, r6
    if_hidden \keeps, .Lfew_hidden\@_\length
    .if     \keeps
    strh    r0, [r2, #-2 * \length]
    .endif
    .if     \length > 1
    add     r3, r3, lr
    .endif
    .endr
.Lfew\@_0:
.Llist_last\@:
    list_run r2, .Lfull_end\@

    .align  2
.Lpart_done\@:
    ldr     r0, [sp, #F_ROWS]
    tst     r12, #(0x80000000 | HAS_REST)
    bne     .Lno_run\@
.Lrow_done\@:
    subs    r12, r12, #1
    bne     .Lrow_below\@
    ldr     r6, [sp, #F_RUNS]
    str     r6, [r0, #DEPTH_ROWS_RUNS]
    movs    r0, #0
    add     sp, #F_SIZE
    pop     {r4-r11, pc}

    /* Unless there are more octaves, a row of no visible pixel has an empty run. */
.Lno_run\@:
    tst     r12, #HAS_REST
    bne     .Lrest\@
    mov     r0, #0x80000000
    put_run .Lfull_end\@
    ldr     r0, [sp, #F_ROWS]
    b       .Lrow_done\@

    .irp    length, 7, 6, 5, 4, 3, 2, 1
.Lfew_hidden\@_\length:
    .if     \length > 1
    sub     r4, r2, #2 * \length
    b       .Lhidden\@
    .else
    subs    r4, r2, #2
    .endif
    .endr

    /* The pixel of r4 is hidden: on to the first that is not. */
.Lhidden\@:
    cmp     r1, r4
    beq     .Lhide\@
    list_run r4, .Lfull_hidden\@
    .align  2
.Lhide\@:
    adds    r4, r4, #2
    add     r3, r3, lr
    cmp     r4, r11
    bhi     .Lfew_to_hide\@
.Leight_hidden\@:
    .rept   8
    ldrh    r6, [r4], #2
    cmp     r6, r3, lsr #16
    if_visible \keeps, .Lvisible\@
    add     r3, r3, lr
    .endr
    cmp     r4, r11
    bls     .Leight_hidden\@
.Lfew_to_hide\@:
    cmp     r4, r2
    bhs     .Lpart_done\@
1:  ldrh    r6, [r4], #2
    cmp     r6, r3, lsr #16
    if_visible \keeps, .Lvisible\@
    add     r3, r3, lr
    cmp     r4, r2
    blo     1b
    b       .Lpart_done\@
.Lvisible\@:
    subs    r4, r4, #2
    mov     r1, r4
    cmp     r4, r11
    bls     .Leight_or_seven\@
    b       .Lfew\@

    /* Some of eight pixels may be hidden. r6-r9: their cells */
.Leach_of_eight\@:
    .if     \keeps
    .rept   8
    ldrh    r6, [r4]
    lsrs    r0, r3, #16
    cmp     r0, r6
    if_hidden \keeps, .Lhidden\@
    keep_code \keeps
    add     r3, r3, lr
    .endr
    .else
    .irp    two, r6, r7, r8, r9
    cmp     r3, \two, lsl #16           /* a code's part below 1 hides nothing */
    blo     .Lfirst\@_\two
    add     r3, r3, lr
    lsrs    r0, r3, #16
    cmp     r0, \two, lsr #16
    blo     .Lsecond\@_\two
    add     r3, r3, lr
    .endr
    adds    r4, r4, #16
    .endif
    cmp     r4, r11
    bls     .Leight\@
    b       .Lfew\@
    .if     !\keeps
    .irp    two, r9, r8, r7, r6
.Lsecond\@_\two:
    adds    r4, r4, #2
.Lfirst\@_\two:
    .ifnc   \two, r6
    adds    r4, r4, #2
    .endif
    .endr
    b       .Lhidden\@
    .endif

/* --- octaves ---------------------------------------------------------------------------------- */

    /* Rounded down, a code of the last octave may be below 1 as the cell of a pixel where nothing was
     * drawn. */
.Llast_octave\@:
    mla     r6, lr, r0, r3
    sub     r6, r6, lr
    cmp     r3, #65536
    it      hs
    cmphs   r6, #65536
    bhs     .Leight_or_seven\@

    /* Any number of pixels, without regard to speed. */
.Leach\@:
    cmp     r4, r2
    bhs     .Leach_end\@
    ldrh    r6, [r4]
    lsrs    r0, r3, #16
    cmp     r0, r6
    if_hidden \keeps, .Leach_hidden\@
    keep_code \keeps
    add     r3, r3, lr
    b       .Leach\@
.Leach_hidden\@:
    cmp     r1, r4
    beq     .Leach_hide\@
    list_run r4, .Lfull_each\@
    .align  2
.Leach_hide\@:
    adds    r4, r4, #2
    add     r3, r3, lr
    mov     r1, r4
    b       .Leach\@
.Leach_end\@:
    cmp     r1, r2
    bne     .Llist_last\@
    b       .Lpart_done\@

    /* Another octave than that of the pixels before: that of r11 leading zeros. r3: those of the
     * last pixel. */
.Loctave\@:
    cmp     r11, r3
    bne     .Lsplit\@
.Lone_octave\@:
    cmp     r11, #0                     /* below 0 */
    beq     .Lfarther\@
    ldrd    r9, r3, [r1, #OF_OCTAVE(DEPTH_ROWS_ONE)]
    rsb     r6, r11, #64                /* the value's length in bits */
    subs    r6, r9, r6                  /* the octave's number */
    bmi     .Lnearer\@
    cmp     r6, r3
    bge     .Lfarther\@
    ldr     r9, [r1, #OF_OCTAVE(DEPTH_ROWS_MANTISSA)]
    subs    r3, r3, r6
    subs    r3, r3, #2
    rsb     r7, r11, #47
    sub     r7, r7, r9                  /* drop */
    add     r9, r9, #16
    lsl     r8, r3, r9
    add     r8, r8, #65536              /* bias */
    ldrd    r9, lr, [r1, #OF_OCTAVE(DEPTH_ROWS_ALONG)]
    shift_by r7, r9, lr, r6
    mov     lr, r9                      /* step */
    lsr     r9, r3, #31
    mov     r6, r11
    stm     r1, {r6-r9, lr}
    b       .Lcode\@
.Lnearer\@:
    mov     r3, #-1
    b       .Lconstant\@
.Lfarther\@:
    mov     r3, #65536
.Lconstant\@:
    mov     lr, #0
    mov     r9, #0
    b       .Lcells\@

    /* The columns until r9 are in the octave of the first: found by halving. */
.Lsplit\@:
    str     r10, [r1, #OF_OCTAVE(DEPTH_ROWS_REST)]
    strd    r4, r5, [r1, #OF_OCTAVE(DEPTH_ROWS_REST + 8)]
    ldrd    r6, r7, [r1, #OF_OCTAVE(DEPTH_ROWS_ALONG)]
    mov     r8, r2
    add     r9, r2, r0
    sub     r9, r9, #1
.Lhalve\@:
    sub     r3, r9, r8
    cmp     r3, #1
    bls     .Lhalved\@
    add     r3, r8, r3, lsr #1
    umull   lr, r10, r6, r3
    mla     r10, r7, r3, r10
    adds    lr, lr, r4
    adc     r10, r10, r5
    clz     r10, r10
    cmp     r10, r11
    ite     eq
    moveq   r8, r3
    movne   r9, r3
    b       .Lhalve\@
.Lhalved\@:
    ldr     r10, [r1, #OF_OCTAVE(DEPTH_ROWS_REST)]
    str     r9, [r1, #OF_OCTAVE(DEPTH_ROWS_REST + 4)]
    add     r3, r2, r0
    sub     r3, r3, r9
    str     r3, [sp, #F_REST]
    orr     r12, r12, #HAS_REST
    sub     r0, r9, r2                  /* pixels of the first octave */
    b       .Lone_octave\@

    /* The rest of a row, r6 pixels. */
.Lrest\@:
    ldr     r6, [sp, #F_REST]
    bic     r12, r12, #HAS_REST
    add     r1, r0, #DEPTH_ROWS_ZEROS
    mov     r0, r6
    ldrd    r10, r2, [r1, #OF_OCTAVE(DEPTH_ROWS_REST)]
    ldrd    r4, r5, [r1, #OF_OCTAVE(DEPTH_ROWS_REST + 8)]
    ldrd    r6, r7, [r1, #OF_OCTAVE(DEPTH_ROWS_ALONG)]
    b       .Lpart\@

    .size \name, . - \name
    .endm

    .global fxl_find_depth_runs
    .global fxl_find_visible_runs
    find_runs fxl_find_depth_runs, 1
    find_runs fxl_find_visible_runs, 0

#endif
