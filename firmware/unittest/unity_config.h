/* SPDX-License-Identifier: MIT */
/* Unity on a board: what it prints goes to the host. */
#ifndef UNITTEST_UNITY_CONFIG_H
#define UNITTEST_UNITY_CONFIG_H

#include "unittest.h"

#define UNITY_OUTPUT_CHAR(character) unittest_put(character)
#define UNITY_OUTPUT_FLUSH()         unittest_flush()
#define UNITY_EXCLUDE_FLOAT
#define UNITY_SUPPORT_64

#endif
