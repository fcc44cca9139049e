/* SPDX-License-Identifier: MIT */
/* fxl_draw_depth_face_16: a triangle from its vertices to its pixels. lib/paint/depth_outline.h states
 * what it requires and does. It is a part of fxl_draw_depth_outline_16, whose rows it has: small
 * triangles continue at .Lsmall_box, and come back for the plane where they cover a centre. */

/* In the stack frame, until a centre is covered. */
#define FACE_BAND       SMALL_POINTS /* and 1 */
#define FACE_MODEL_VIEW SMALL_BAND
#define FACE_FACE       (SMALL_BAND + 4)
#define FACE_OUTLINE    FACE_FACE /* until the vertices are known */
#define FACE_SCREEN     (FRAME_SIZE + 36) /* above what is pushed */

half        .req r4         /* 0x7FFF */
entries     .req r5
mask        .req r6
tag         .req r7
points      .req r8
face        .req r9

/* place fill-rule: the first centres of a vertex of a small face for Armv7-M, which adds 0x7FFF itself */
/* The next vertex, on the screen, and its flags. r0-r3 after both calls: as transform_vertex_armv7m.S and
 * project_inside_armv7m.S say. */
    .macro  face_vertex number, flags
    ldrh    r1, [face, #FACE_INDICES + 2 * \number]
    and     r2, r1, mask
    add     r2, r2, r2, lsl #2              /* 40 bytes each */
    add     r2, entries, r2, lsl #3
    ldrd    r0, \flags, [r2]
    add     r3, r1, tag
    cmp     r0, r3
    beq     .Lface_cached\number
    ldr     r0, [sp, #FACE_MODEL_VIEW]
    bl      fxl_transform_and_project       /* returns flags of r0 */
    bne     .Lface_not_placed
.Lface_placed\number:
    add     \flags, r1, half
    add     r0, r3, half
    lsr     \flags, \flags, #16
    lsrs    r0, r0, #16
    lsls    r0, r0, #20
    orr     \flags, r0, \flags, lsl #8
    str     \flags, [r2, #CACHED_VERTEX_CLIP_FLAGS - CACHED_VERTEX_SCREEN]
.Lface_ready\number:
    strd    r1, r3, [points, #8 * \number]
    .endm

/* A vertex that is in the cache. */
    .macro  cached_vertex number, flags
.Lface_cached\number:
    ldrd    r1, r3, [r2, #CACHED_VERTEX_SCREEN]
    lsls    r0, \flags, #24
    beq     .Lface_ready\number
    cmp     \flags, #VERTEX_UNPROJECTED
    bne     .Lface_other
    bl      .Lface_project
    b       .Lface_placed\number
    .endm

    /* What the survey of its outline wants, whose plane is found. */
    .macro  face_survey
    ldr     r0, [sp, #FACE_SCREEN]
    ldr     r2, [sp, #FACE_BAND]
    str     r0, [r3, #DEPTH_OUTLINE_ZEROS]  /* above 32 */
    adds    r0, r0, #SCREEN_POLYGON_POINTS
    subs    r2, r2, #1
    begin_survey
    .endm

/* The least and the greatest of three words, unsigned, and three words at most. */
    .macro  ends a, b, c, least, most
    cmp     \a, \b
    ittee   lo
    movlo   \least, \a
    movlo   \most, \b
    movhs   \least, \b
    movhs   \most, \a
    cmp     \c, \least
    it      lo
    movlo   \least, \c
    cmp     \c, \most
    it      hi
    movhi   \most, \c
    .endm

    .global fxl_draw_depth_face_16
    .type fxl_draw_depth_face_16, %function
    .thumb_func

/* r0: model_view, r1: face, r2: outline, r3: band; on the stack: screen */
fxl_draw_depth_face_16:
    push    {r4-r11, lr}
    sub     sp, sp, #FRAME_SIZE
    adds    r3, r3, #1
    strd    r3, r0, [sp, #FACE_BAND]
    str     r2, [sp, #FACE_OUTLINE]
    ldr     r2, [sp, #FACE_SCREEN]
    ldm     r0, {r4-r7}                     /* -, entries, mask, tag */
    add     points, r2, #SCREEN_POLYGON_POINTS
    mov     face, r1
    movw    half, #0x7FFF
    face_vertex 0, r10
    face_vertex 1, r11
    face_vertex 2, r12

    ldr     r3, [sp, #FACE_OUTLINE]
    str     face, [sp, #FACE_FACE]
    mov     r0, points
    ends    r10, r11, r12, r1, r2
    lsr     r6, r1, #20                     /* the first row */
    rsb     r8, r6, r2, lsr #20             /* rows */
    cmp     r8, #SMALL_ROWS
    bhi     .Lface_high
    lsl     r10, r10, #12
    lsl     r11, r11, #12
    lsl     r12, r12, #12
    ends    r10, r11, r12, r1, r2
    lsr     r10, r1, #20                    /* the first column */
    rsb     r12, r10, r2, lsr #20           /* columns */
    mul     r1, r8, r12
    sub     r1, r1, #1                      /* 2^32 - 1: no centre */
    cmp     r12, #SMALL_COLUMNS
    it      ls
    cmpls   r1, #SMALL_CENTRES - 1
    bhi     .Lface_wide
    ldr     r2, [sp, #FACE_BAND]
    ldrh    r1, [r2, #BAND_FIRST_ROW - 1]
    ldrh    r7, [r2, #BAND_ROWS - 1]
    ldrh    r5, [r2, #BAND_WIDTH - 1]
    sub     r1, r6, r1                      /* the first row in the band */
    add     r9, r1, r8
    cmp     r1, r7
    bhs     .Lface_whole
    cmp     r9, r7
    bhi     .Lface_whole
    mla     lr, r1, r5, r10
    b       .Lsmall_box

    /* It is drawn as outlines are. */
.Lface_whole:
    movs    r1, #0
    str     r1, [sp, #SMALL_BEGIN]
    /* The plane through the first vertex, unless another one has taken its place in the cache. */
.Lface_plane:
    ldrd    r4, r0, [sp, #FACE_MODEL_VIEW]
    ldm     r4, {r5-r8}                     /* view, entries, mask, tag */
    ldrh    r1, [r0, #FACE_INDICES]
    and     r2, r1, r7
    add     r2, r2, r2, lsl #2
    add     r2, r6, r2, lsl #3
    ldr     r6, [r2], #CACHED_VERTEX_POSITION
    add     r8, r8, r1
    cmp     r6, r8
    bne     .Lface_other
    ldr     r1, [r4, #MODEL_VIEW_AXES]
    push    {r3, r4}
    mov     r3, r5
    bl      fxl_find_depth_plane
    pop     {r3, r4}
    ldr     r0, [r3, #DEPTH_PLANE_ONE]
    ldr     r2, [r3, #DEPTH_OUTLINE_CELLS]
    ldrb    r1, [r2, #DEPTH_HEAD_OCTAVES - DEPTH_HEAD_SIZE]
    ldrb    r2, [r2, #DEPTH_HEAD_MANTISSA - DEPTH_HEAD_SIZE]
    add     r4, r1, #32
    cmp     r0, r4
    blt     .Lface_other
    add     r4, r3, #DEPTH_OUTLINE_ONE
    stm     r4, {r0, r1, r2}
    ldr     r4, [sp, #SMALL_BEGIN]
    cmp     r4, #0
    bne     .Lsmall_codes
    face_survey
    b       .Ltriangle
    /* It has more than one octave. */
.Lface_several:
    face_survey
    b       .Lsurvey

    /* r10, r11, r12: flags; then columns alone */
.Lface_high:
    lsl     r10, r10, #12
    lsl     r11, r11, #12
    lsl     r12, r12, #12
    eor     r1, r10, r11
    eor     r12, r12, r11
    orrs    r1, r1, r12
    bne     .Lface_whole
.Lface_between:
    movs    r0, #DEPTH_FACE_IS_BETWEEN
.Lface_returns:
    add     sp, sp, #FRAME_SIZE
    pop     {r4-r11, pc}
.Lface_wide:
    adds    r1, r1, #1
    beq     .Lface_between
    b       .Lface_whole

    cached_vertex 0, r10
    cached_vertex 1, r11
    cached_vertex 2, r12

    /* Returns what fxl_project_inside gives of the entry at r2. */
.Lface_project:
    str     lr, [sp]
    ldr     r0, [sp, #FACE_MODEL_VIEW]
    ldr     r0, [r0, #MODEL_VIEW_VIEW]
    adds    r0, r0, #VIEW_PROJECTION
    add     r1, r2, #CACHED_VERTEX_POSITION
    adds    r2, r2, #CACHED_VERTEX_SCREEN
    bl      fxl_project_inside
    cmp     r0, #0
    bne     .Lface_other
    ldr     pc, [sp]

    /* Out of range, the vertex has no flags yet. */
.Lface_not_placed:
    adds    r0, r0, #1
    itt     ne
    movne   r1, #VERTEX_UNPROJECTED
    strne   r1, [r2, #CACHED_VERTEX_CLIP_FLAGS - CACHED_VERTEX_SCREEN]
.Lface_other:
    movs    r0, #DEPTH_FACE_IS_OTHER
    b       .Lface_returns
