/* SPDX-License-Identifier: MIT */
/* Memory protection of Armv7-M (PMSAv7): the regions that a stray pointer or an overflowing
 * stack must hit. A chip may lack it, though QEMU's model of the chip has it. On such a chip
 * only the paint of the stack shows an overflow. */
#include "parts/cortexm.h"

#define MPU_RBAR         CORTEXM_REGISTER(0xE000ED9Cu)
#define MPU_RASR         CORTEXM_REGISTER(0xE000EDA0u)
#define MPU_TYPE_REGIONS (0xFFu << 8)
#define CTRL_ENABLE      1u
#define CTRL_PRIVDEFENA  4u /* all other addresses: as without protection */
#define RBAR_VALID       (1u << 4)
#define RASR_ENABLE      1u
#define RASR_XN          (1u << 28)
#define RASR_NO_ACCESS   (0u << 24)
#define RASR_READ_ONLY   (6u << 24)
/* Normal memory, write-through: TEX 0, C 1, B 0. */
#define RASR_NORMAL (1u << 17)

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
