/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv7m.h: which lengths the segments of a row have, and where a run of
 * segments of one length begins and ends. Assembly. */
#ifndef FXL_PLAIN_LENGTHS_ARMV7M_H
#define FXL_PLAIN_LENGTHS_ARMV7M_H

/* clang-format off */

/* Which segments the columns r2 to r3 have. r10, r11: the weight at the first 16 columns, r6, r7: its step;
 * r8, r9: the least weights for 16 and for 8. The weight is linear: where it falls, that at the end of the
 * last 16 columns, in lr, is the least one. */
    .align  2
.Lface_weights:
    ldrd    r1, r0, [sp, #.LF_ROW]
    str     r3, [sp, #.LF_X_END]
    lsrs    r4, r2, #4
    ldrd    r6, r7, [r0, #SEGMENT_FACE_WEIGHT_STEP]
    weight_of_16 r10, r11, r4
    cmp     r7, #0
    blt     .Lfalling_weights
    ldrd    r8, r9, [r0, #SEGMENT_FACE_LEAST]
    cmp     r11, r8
    bge     .Lall_16
    ldrd    r12, lr, [r0, #SEGMENT_FACE_LEAST + 8]
    cmp     r11, lr
    bge     .Lrising
.Lnot_ours:
    movs    r0, #1
    b       .Lleave
.Lfalling_weights:
    add     r5, r3, #15
    lsrs    r5, r5, #4
    weight_of_16 r12, lr, r5
    ldrd    r8, r9, [r0, #SEGMENT_FACE_LEAST]
    cmp     lr, r8
    bge     .Lall_16
    ldr     r12, [r0, #SEGMENT_FACE_LEAST + 12]
    cmp     lr, r12
    blt     .Lnot_ours
    ldr     r12, [r0, #SEGMENT_FACE_LEAST + 8]
    b       .Lfalling
.Lall_16:
    movs    r4, #4
.Lto_end:
    str     r3, [sp, #.LF_X]

/* A run of segments of 2^r4 columns: the columns r2 to r3 of the row in r1; r0: face. */
.Lrun:
    ldr     r5, [sp, #.LF_LOG]
    cmp     r4, r5
    bne     .Lother_log
.Lsame_log:
    lsr     r12, r2, r4                 /* the first segment's number */
    lsl     r5, r12, r4                 /* its first column */
    subs    r6, r2, r5                  /* columns that are skipped */
    ldr     r8, [sp, #.LF_SHORT]
    ldr     r7, [r1, #PAINT_ROW_PIXELS]
    rsb     r8, r8, #16
    sub     r7, r7, #(1 << WIDE)
    add     r3, r7, r3, lsl #WIDE
    sub     r8, r3, r8, lsl #WIDE
    strd    r8, r3, [sp, #.LF_LAST]
    str     r6, [sp, #.LF_SKIP]
    add     pixels, r7, r5, lsl #WIDE
    cmp     pixels, r8
    adr     r3, .Lonly + 1
    bhi     1f
    ldr     r3, [sp, #.LF_FULL]
    cbz     r6, 1f
    adr     r3, .Lskipping + 1
1:  str     r3, [sp, #.LF_GO]
    ldr     pc, [sp, #.LF_BEGIN]

/* u and v, which are not divided, where segment r12 begins, and the weight in column 0; r2, r3: its step.
 * r1: row. Overwrites r4 and r5. */
    .macro  begin_coordinates
    ldm     r1, {r6-r11}                /* weight, u, v */
    ldm     sp, {r2-r5}
    umlal   u_low, u, r4, r12
    mla     u, r5, r12, u
    ldr     r4, [sp, #16]
    ldr     r5, [sp, #.LF_V_HIGH]
    umlal   v_low, v, r4, r12
    mla     v, r5, r12, v
    .endm

/* Divides u and v by w; r3 becomes the reciprocal. Goes to far where a drop is below 0. low: takes the lower
 * word of the second product; it may be u_drop. */
    .macro  divide u_at, v_at, u_drop, v_drop, zeros, low, far
    mvn     r3, #0x80000000
    reciprocal r3, \zeros, w, r3, \u_drop, \v_drop
    ldrd    \u_drop, \v_drop, [sp, #.LF_U_DROP]
    subs    \u_drop, \u_drop, \zeros
    subs    \v_drop, \v_drop, \zeros
    orrs    \zeros, \u_drop, \v_drop
    bmi     \far
    smull   \zeros, \u_at, u, r3
    asrs    \u_at, \u_at, \u_drop
    smull   \low, \v_at, v, r3
    asrs    \v_at, \v_at, \v_drop
    .endm

/* The same, and goes on with the segment. Overwrites r1 to r5. */
    .macro  divide_and_resume
    divide  u_0, v_0, r4, r5, r1, r1, .Lfar_start
    ldr     pc, [sp, #.LF_RESUME]
    .endm

    .align  2
.Lbegin:
    begin_coordinates
    umlal   w_low, w, r2, r12
    mla     w, r3, r12, w
    str     w_low, [sp, #.LF_W_LOW]
    divide_and_resume
.Lfar_start:
    smull   r1, r2, u, r3
    shift_down r2, r1, r4
    mov     u_0, r2
    smull   r1, r2, v, r3
    shift_down r2, r1, r5
    mov     v_0, r2
    ldr     pc, [sp, #.LF_RESUME]

/* A word of 64 bits in high:low is shifted to the right by less than 32. */
    .macro  shift_step low, high, by
    .if     \by
    lsr     \low, \low, #\by
    orr     \low, \low, \high, lsl #(32 - \by)
    asr     \high, \high, #\by
    .endif
    .endm

/* The frame for segments of 2^log columns: a step is that of 16, shifted. Keeps r0 to r4. */
    .macro  set_log log, resume
    ldm     r0, {r6-r11}
    shift_step r6, r7, (4 - \log)
    shift_step r8, r9, (4 - \log)
    shift_step r10, r11, (4 - \log)
    stm     sp, {r6-r10}
    str     r11, [sp, #.LF_V_HIGH]
    movs    r6, #(16 - (1 << \log))
    strd    r6, r6, [sp, #.LF_SHORT]
    ldrb    r9, [r0, #SEGMENT_FACE_KIND]
    ldrd    r7, r8, [sp, #.LF_CODE]
    cmp     r9, #4
    .if     \log == 0
    it      eq
    ldrdeq  r7, r8, [sp, #.LF_PLAIN]
    mla     r7, r6, r8, r7
    add     r5, r8, r9, lsl #8
    ite     eq
    adreq   r9, .Lclamped_each + 1
    adrne   r9, \resume + 1
    .if     WIDE
    cmp     r5, #PIXEL_PLAIN
    bne     1f
    ldrb    r9, [r0, #SEGMENT_FACE_LOG_WIDTH]
    rsb     r9, r9, #20                 /* from U to the column */
    lsl     r8, r9, #1
    subs    r8, #20                     /* from V to the row */
    ldrd    r10, r11, [sp, #.LF_U_DROP]
    add     r10, r10, r9
    add     r11, r11, r8
    strd    r10, r11, [sp, #.LF_U_DROP]
    ldrd    r10, r11, [sp, #(.LF_SAVED + 20)] /* u_0 and v_0, if they are kept */
    asr     r10, r10, r9
    asr     r11, r11, r8
    strd    r10, r11, [sp, #(.LF_SAVED + 20)]
    adr     r9, .Leach_colour + 1
1:
    .endif
    adr     r8, .Lsegment_\log + 1
    .else
    mla     r7, r6, r8, r7
    ittee   eq
    adreq   r8, .Lclamped_segment_\log + 1
    adreq   r9, .Lclamped_resume_\log + 1
    adrne   r8, .Lsegment_\log + 1
    adrne   r9, \resume + 1
    .endif
    str     r7, [sp, #.LF_FULL]
    strd    r8, r9, [sp, #.LF_NEXT]
    b       .Lsame_log
    .endm

/* The frame of another logarithm, r4. */
.Lother_log:
    str     r4, [sp, #.LF_LOG]
    .if     WIDE
    ldrd    r10, r11, [r0, #SEGMENT_FACE_U_DROP]
    strd    r10, r11, [sp, #.LF_U_DROP]
    .endif
    cmp     r4, #3
    beq     .Lset_3
    blo     .Lset_less
    set_log 4, .Lresume_4
.Lset_3:
    set_log 3, .Lresume_3
.Lset_less:
    cmp     r4, #0
    beq     .Lset_0
    set_log 2, .Lresume_2
.Lset_0:
    set_log 0, .Leach

/* The run of 16 columns that have the same segments, from r2 on, up to r3 at most; registers as above.
 * Where the weight rises segments do not become shorter. */
.Lfind:
    ldr     r12, [r0, #SEGMENT_FACE_LEAST + 8]
    cmp     r7, #0
    blt     .Lfalling
    cmp     r11, r8
    bge     .Lall_16
.Lrising:
    bic     r5, r2, #15
    movs    r4, #3
    mov     lr, r8
    cmp     r11, r9
    bge     1f
    movs    r4, #2
    mov     lr, r9
    cmp     r11, r12
    bge     1f
    movs    r4, #0
    mov     lr, r12
1:  adds    r5, #16
    cmp     r5, r3
    bge     .Lto_end
    adds    r10, r10, r6
    adc     r11, r11, r7
    cmp     r11, lr
    blt     1b
    b       .Lfound
.Lfalling:
    bic     r5, r2, #15
    adds    r10, r10, r6
    adc     r11, r11, r7
    movs    r4, #4
    mov     lr, r8
    cmp     r11, r8
    bge     1f
    movs    r4, #3
    mov     lr, r9
    cmp     r11, r9
    bge     1f
    movs    r4, #2
    mov     lr, r12
    cmp     r11, r12
    bge     1f
    movs    r4, #0
    b       .Lto_end
1:  adds    r5, #16
    cmp     r5, r3
    bge     .Lto_end
    adds    r10, r10, r6
    adc     r11, r11, r7
    cmp     r11, lr
    bge     1b
.Lfound:
    mov     r3, r5
    b       .Lto_end

/* A run has ended. If segments have come to an end of 16 columns, all registers are those at the
 * beginning of the next run. */
    .align  2
.Lrun_end:
    ldrd    r2, r3, [sp, #.LF_X]
    cmp     r2, r3
    it      eq
    ldreq   pc, [sp, #.LF_DONE]
    ldr     r4, [sp, #.LF_LOG]
    ldrd    r1, r0, [sp, #.LF_ROW]
    cbz     r4, 1f
    ldrb    r4, [r0, #SEGMENT_FACE_KIND]
    cmp     r4, #3
    beq     1f
    ldr     w_low, [sp, #.LF_W_LOW]
    adr     r4, .Lkept + 1
    str     r4, [sp, #.LF_BEGIN]
    add     r4, sp, #.LF_SAVED
    stm     r4, {r7-r12, lr}
    mov     r10, w_low
    mov     r11, w
    ldrd    r6, r7, [r0, #SEGMENT_FACE_WEIGHT_STEP]
    ldrd    r8, r9, [r0, #SEGMENT_FACE_LEAST]
    b       .Lfind
1:  lsr     r4, r2, #4
    ldrd    r6, r7, [r0, #SEGMENT_FACE_WEIGHT_STEP]
    weight_of_16 r10, r11, r4
    ldrd    r8, r9, [r0, #SEGMENT_FACE_LEAST]
    b       .Lfind

    .align  2
.Lkept:
    ldr     r3, [sp, #.LF_FIRST]
    str     r3, [sp, #.LF_BEGIN]
    add     r3, sp, #.LF_SAVED
    ldm     r3, {r7-r12, lr}
    ldr     pc, [sp, #.LF_RESUME]

/* clang-format on */

#endif
