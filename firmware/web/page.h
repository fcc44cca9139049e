/* SPDX-License-Identifier: MIT */
/* What the programs of a page share. Internal. */
#ifndef WEB_PAGE_H
#define WEB_PAGE_H

#include <stdbool.h>
#include <stdint.h>

#define EXPORTED(name) __attribute__((export_name(name)))

/* The first byte behind data and stack, at a multiple of 8. */
uint8_t *page_heap(void);

/* Has the memory reach to before `end`. False: there is not so much. */
bool page_reach(const uint8_t *end);

/* What was said so far is not told. */
void page_says_nothing(void);

#endif
