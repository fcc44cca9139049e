/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_CHAIN_WALKS_H
#define EQUALITY_CHAIN_WALKS_H

#include <stdint.h>

void test_chains(uint32_t rounds);

#endif
