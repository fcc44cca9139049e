/* SPDX-License-Identifier: MIT */
#include "equality.h"
#include "products.h"
#include "project.h"

#include <stddef.h>

const equality_test equality_tests[] = {
    {"multiply", test_products},
    {"multiply-wide", test_wide_products},
    {"leading-zeros", test_leading_zeros},
    {"project", test_project},
    {NULL, NULL},
};
