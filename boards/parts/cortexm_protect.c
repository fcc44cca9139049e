/* SPDX-License-Identifier: MIT */
/* Memory protection: what a stray pointer or an overflowing stack must hit. Each architecture has
 * its own; Armv6-M has none. */
#include "parts/cortexm.h"

#define MPU_RBAR         CORTEXM_REGISTER(0xE000ED9Cu)
#define MPU_TYPE_REGIONS (0xFFu << 8)
#define CTRL_ENABLE      1u

#if defined(__ARM_ARCH_8M_MAIN__) || defined(__ARM_ARCH_8_1M_MAIN__)

/* PMSAv8, and the stack limits.
 *
 * PMSAv8 has no region without access; an address outside all regions is out of bounds. So the
 * regions are what a program may use: its flash, the RAM, and the rest of the address space
 * except the code space. The guard is, among others, the memory below the RAM in its own eighth
 * of the address space. */
#define MPU_RNR         CORTEXM_REGISTER(0xE000ED98u)
#define MPU_RLAR        CORTEXM_REGISTER(0xE000EDA0u)
#define MPU_MAIR0       CORTEXM_REGISTER(0xE000EDC0u)
#define RBAR_XN         1u
#define RBAR_READ_WRITE (0u << 1) /* privileged only; all code here is privileged */
#define RBAR_READ_ONLY  (2u << 1)
#define RLAR_ENABLE     1u
#define RLAR_ATTRIBUTE  1u /* shift of the number of an attribute of MAIR0 */

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

#elif defined(__ARM_ARCH_7M__) || defined(__ARM_ARCH_7EM__)

/* PMSAv7. A chip may lack it, though QEMU's model of the chip has it. On such a chip only the paint
 * of the stack shows an overflow. */
#define MPU_RASR        CORTEXM_REGISTER(0xE000EDA0u)
#define CTRL_PRIVDEFENA 4u /* all other addresses: as without protection */
#define RBAR_VALID      (1u << 4)
#define RASR_ENABLE     1u
#define RASR_XN         (1u << 28)
#define RASR_NO_ACCESS  (0u << 24)
#define RASR_READ_ONLY  (6u << 24)
/* Normal memory, write-through: TEX 0, C 1, B 0. */
#define RASR_NORMAL     (1u << 17)

/* Sets region `number` to size bytes, a power of two from 32, from an address that is a multiple
 * of size. Where regions overlap, the higher number has priority. */
static void set_region(uint32_t number, uintptr_t address, uint32_t size, uint32_t attributes)
{
    uint32_t exponent = 0;

    while ((1u << (exponent + 1u)) < size) {
        exponent++;
    }
    MPU_RBAR = (uint32_t)address | RBAR_VALID | number;
    MPU_RASR = attributes | RASR_NORMAL | (exponent << 1) | RASR_ENABLE;
}

bool cortexm_protect(void)
{
    const uintptr_t guard = (uintptr_t)fxl_stack_guard;
    const uint32_t guard_size = (uint32_t)((uintptr_t)fxl_stack_limit - guard);

    if ((MPU_TYPE & MPU_TYPE_REGIONS) == 0) {
        return false;
    }
    set_region(0, CORTEXM_CODE_BASE, CORTEXM_CODE_SIZE, RASR_NO_ACCESS | RASR_XN);
    set_region(1, (uintptr_t)fxl_flash_base, (uint32_t)(uintptr_t)fxl_flash_size, RASR_READ_ONLY);
    set_region(2, 0, CORTEXM_NULL_BYTES, RASR_NO_ACCESS | RASR_XN);
    set_region(3, guard, guard_size, RASR_NO_ACCESS | RASR_XN);
    MPU_CTRL = CTRL_ENABLE | CTRL_PRIVDEFENA;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    return true;
}

#elif defined(__ARM_ARCH_6M__)

/* The stack is the lowest memory, so an overflow leaves the RAM. The stack is painted, too. */
bool cortexm_protect(void)
{
    return false;
}

#else
#error "no memory protection is known for this architecture"
#endif
