/* SPDX-License-Identifier: MIT */
#ifndef PRODUCTS_H
#define PRODUCTS_H

#include <stdint.h>

void test_products(uint32_t rounds);
void test_short_products(uint32_t rounds);
void test_wide_products(uint32_t rounds);
void test_high_products(uint32_t rounds);
void test_leading_zeros(uint32_t rounds);

#endif
