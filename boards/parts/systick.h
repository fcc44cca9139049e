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

/* Sleeps until that many ticks have passed, or any interrupt has come. The ticks count. Requires
 * systick_start called, 1000 <= ticks <= SYSTICK_RELOAD_MAX. */
void systick_nap(uint32_t ticks);

/* Returns the ticks from one wrap to the next. */
uint32_t systick_period(void);

/* Returns the ticks since systick_start. Correct at any moment, in handlers and across wraps, if
 * interrupts are never masked for a whole period. */
uint64_t systick_ticks(void);

/* Sets the alarm: the interrupt of the wrap that follows this many others ends in cortexm_fault;
 * 0: never. Replaces the previous alarm. */
void systick_alarm(uint32_t wraps);

/* Tells whether the alarm has gone off. */
bool systick_alarmed(void);

#endif
