/* SPDX-License-Identifier: MIT */
/* The bare work of a few kernels, as a limit for them: without rounding, range or rule. Filling
 * is assembly, with the fewest instructions for a frame. The others are plain products, as the
 * compiler translates them. */
#include "kernels.h"

#define FILL_BYTES (SURFACE_WIDTH * SURFACE_HEIGHT)

static int32_t products[KERNEL_COUNT];
static fxl_view_point sums[KERNEL_COUNT];

/* Makes the compiler assume that the results are read. */
static inline void keep(const void *results)
{
    __asm__ volatile("" ::"r"(results) : "memory");
}

/* A frame by multiple stores: 96 bytes in four, and two for the loop. Only
 * registers that Armv6-M can use; 76,800 is 800 times 96. */
__attribute__((naked)) static void fill(const kernel_inputs *in)
{
    (void)in;
    __asm__ volatile(".syntax unified\n\t"
                     "push {r4, r5, r6, r7, lr}\n\t"
                     "ldr r6, 2f\n\t"
                     "ldr r7, 3f\n\t"
                     "add r7, r6\n\t"
                     "movs r0, #0\n\tmovs r1, #0\n\tmovs r2, #0\n\t"
                     "movs r3, #0\n\tmovs r4, #0\n\tmovs r5, #0\n"
                     "1:\tstmia r6!, {r0, r1, r2, r3, r4, r5}\n\t"
                     "stmia r6!, {r0, r1, r2, r3, r4, r5}\n\t"
                     "stmia r6!, {r0, r1, r2, r3, r4, r5}\n\t"
                     "stmia r6!, {r0, r1, r2, r3, r4, r5}\n\t"
                     "cmp r6, r7\n\t"
                     "bne 1b\n\t"
                     "pop {r4, r5, r6, r7, pc}\n\t"
                     ".align 2\n"
                     "2:\t.word %c0\n"
                     "3:\t.word %c1" ::"i"(kernel_screen),
                     "i"(FILL_BYTES));
}

/* 16.16 by 16.16, truncated. */
static void multiply(const kernel_inputs *in)
{
    for (uint32_t i = 0; i < KERNEL_COUNT; i++) {
        products[i] = (int32_t)(((int64_t)in->points[i].x * in->points[i].y) >> 16);
    }
    keep(products);
}

/* Nine products in 64 bits and their sums. */
static void transform(const kernel_inputs *in)
{
    const fxl_direction *right = &in->view.camera.axes.right, *up = &in->view.camera.axes.up;
    const fxl_direction *forward = &in->view.camera.axes.forward;
    for (uint32_t i = 0; i < KERNEL_COUNT; i++) {
        const int64_t x = in->points[i].x, y = in->points[i].y, z = in->points[i].z;
        sums[i].x = right->x * x + right->y * y + right->z * z;
        sums[i].y = up->x * x + up->y * y + up->z * z;
        sums[i].z = forward->x * x + forward->y * y + forward->z * z;
    }
    keep(sums);
}

const bench_kernel limit_list[] = {
    {"limit-fill", fill, FILL_BYTES},
    {"limit-multiply", multiply, KERNEL_COUNT},
    {"limit-transform", transform, KERNEL_COUNT},
    {NULL, NULL, 0},
};
