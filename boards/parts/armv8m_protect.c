/* SPDX-License-Identifier: MIT */
/* Memory protection of Armv8-M Mainline (PMSAv8) and the stack limits: what a stray pointer or
 * an overflowing stack must hit.
 *
 * PMSAv8 has no region without access; an address outside all regions is out of bounds. So the
 * regions are what a program may use: its flash, the RAM, and the rest of the address space
 * except the code space. The guard is, among others, the memory below the RAM in its own eighth
 * of the address space. */
#include "parts/cortexm.h"

#define MPU_RNR          CORTEXM_REGISTER(0xE000ED98u)
#define MPU_RBAR         CORTEXM_REGISTER(0xE000ED9Cu)
#define MPU_RLAR         CORTEXM_REGISTER(0xE000EDA0u)
#define MPU_MAIR0        CORTEXM_REGISTER(0xE000EDC0u)
#define MPU_TYPE_REGIONS (0xFFu << 8)
#define CTRL_ENABLE      1u
#define RBAR_XN          1u
#define RBAR_READ_WRITE  (0u << 1) /* privileged only; all code here is privileged */
#define RBAR_READ_ONLY   (2u << 1)
#define RLAR_ENABLE      1u
#define RLAR_ATTRIBUTE   1u /* shift of the number of an attribute of MAIR0 */

/* Attributes: 0, normal memory, write-through; 1, device. */
#define NORMAL           0u
#define DEVICE           1u
#define MAIR0_ATTRIBUTES 0x000004AAu

/* Bounds of the address space: SRAM, devices, external RAM, external devices. */
#define SRAM_LAST     0x3FFFFFFFu
#define DEVICE_BASE   0x40000000u
#define DEVICE_LAST   0x5FFFFFFFu
#define EXTERNAL_BASE 0x60000000u
#define EXTERNAL_LAST 0x9FFFFFFFu
#define OTHER_BASE    0xA0000000u
#define OTHER_LAST    0xFFFFFFFFu

/* Sets region `number` to first..last. Both are rounded down to 32 bytes, and the region
 * includes all of last's 32 bytes. */
static void set_region(uint32_t number, uint32_t first, uint32_t last, uint32_t access,
                       uint32_t attribute)
{
    MPU_RNR = number;
    MPU_RBAR = (first & ~31u) | access;
    MPU_RLAR = (last & ~31u) | (attribute << RLAR_ATTRIBUTE) | RLAR_ENABLE;
}

static uint32_t first_of_flash(void)
{
    const uint32_t base = (uint32_t)(uintptr_t)fxl_flash_base;

    return base < CORTEXM_NULL_BYTES ? CORTEXM_NULL_BYTES : base;
}

/* The RAM, and what is above it in its eighth of the address space: where a flash of the scene's
 * own is in its midst, that is read only. */
static void set_ram_regions(void)
{
    const uint32_t first = (uint32_t)(uintptr_t)fxl_stack_limit;
    const uint32_t flash = (uint32_t)(uintptr_t)fxl_scene_flash_base;
    const uint32_t flash_end = flash + (uint32_t)(uintptr_t)fxl_scene_flash_size;

    if (flash == flash_end) {
        set_region(1, first, SRAM_LAST, RBAR_READ_WRITE | RBAR_XN, NORMAL);
        return;
    }
    set_region(1, first, flash - 1u, RBAR_READ_WRITE | RBAR_XN, NORMAL);
    set_region(5, flash, flash_end - 1u, RBAR_READ_ONLY | RBAR_XN, NORMAL);
    set_region(6, flash_end, SRAM_LAST, RBAR_READ_WRITE | RBAR_XN, NORMAL);
}

bool cortexm_protect(void)
{
    const uint32_t flash_end =
        (uint32_t)(uintptr_t)fxl_flash_base + (uint32_t)(uintptr_t)fxl_flash_size;

    __asm__ volatile("msr psplim, %0" ::"r"(fxl_stack_limit));
    __asm__ volatile("msr msplim, %0" ::"r"(fxl_stack_top));
    if ((MPU_TYPE & MPU_TYPE_REGIONS) == 0) {
        return false;
    }
    MPU_MAIR0 = MAIR0_ATTRIBUTES;
    set_region(0, first_of_flash(), flash_end - 1u, RBAR_READ_ONLY, NORMAL);
    set_ram_regions();
    set_region(2, DEVICE_BASE, DEVICE_LAST, RBAR_READ_WRITE | RBAR_XN, DEVICE);
    set_region(3, EXTERNAL_BASE, EXTERNAL_LAST, RBAR_READ_WRITE | RBAR_XN, NORMAL);
    set_region(4, OTHER_BASE, OTHER_LAST, RBAR_READ_WRITE | RBAR_XN, DEVICE);
    MPU_CTRL = CTRL_ENABLE;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    return true;
}
