/* SPDX-License-Identifier: MIT */
#include "equality.h"
#include "divisions.h"
#include "products.h"
#include "project.h"

#include <stddef.h>

const equality_test equality_tests[] = {
    {"multiply", test_products},
    {"multiply-short", test_short_products},
    {"multiply-wide", test_wide_products},
    {"leading-zeros", test_leading_zeros},
    {"divide", test_divide},
    {"divide-half", test_divide_half},
    {"divide-wide", test_divide_wide},
    {"fraction", test_fraction},
    {"project", test_project},
    {NULL, NULL},
};
