/* SPDX-License-Identifier: MIT */
/* A file of tests, UNIT_TEST, with its generated runner, UNIT_RUNNER, as one object. The makefile
 * makes every name in it local but UNIT_ENTRY, so files with equal names can share a program. */
#include UNIT_TEST
#include UNIT_RUNNER

#include "unittest.h"

extern const unittest_entry UNIT_ENTRY;

__attribute__((section("unittest_entries"))) const unittest_entry UNIT_ENTRY = {UNIT_NAME, unittest_run};
