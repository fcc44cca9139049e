/* SPDX-License-Identifier: MIT */
/* SysTick as a clock that does not wrap, and as an alarm for a watchdog. */
#ifndef BOARD_SYSTICK_H
#define BOARD_SYSTICK_H

#include <stdbool.h>
#include <stdint.h>

#define SYSTICK_RELOAD_MAX 0x00FFFFFFu

/* Starts counting core clock ticks from 0, with an interrupt every reload + 1
 * ticks, and without an alarm. Requires 1 <= reload <= SYSTICK_RELOAD_MAX. */
void systick_start(uint32_t reload);

/* Sleeps until that many ticks have passed, or any interrupt has come. They
 * count. Requires systick_start called, 1000 <= ticks <= SYSTICK_RELOAD_MAX. */
void systick_nap(uint32_t ticks);

/* Ticks from one wrap to the next. */
uint32_t systick_period(void);

/* Ticks since systick_start. Right at any moment, in handlers and across
 * wraps, provided that interrupts are not held off for a whole period. */
uint64_t systick_ticks(void);

/* Lets the interrupt of the wrap that comes after so many others end in
 * cortexm_fault; 0: never. Replaces the alarm before. */
void systick_alarm(uint32_t wraps);

/* Whether the alarm has gone off. */
bool systick_alarmed(void);

#endif
