/* SPDX-License-Identifier: MIT */
/* The argument frames=N asks for N thousand random inputs a kernel. Prints for
 * each kernel
 *   equality: NAME CASES DIFFERENCES
 * and ends with SYSTEM_EXIT_TEST where there was a difference. */
#include "contract/system.h"
#include "equality.h"
#include "start.h"
#include "text.h"

#include <stddef.h>

#define ROUNDS 1000u

static uint32_t cases, differences;

/* What an assertion of the library calls. */
void fxl_assert_failed(const char *file, int line);
void fxl_assert_failed(const char *file, int line)
{
    text_with_number("equality: assertion failed in ", file, " ", (uint32_t)line);
    system_exit(SYSTEM_EXIT_ASSERTION);
}

void equality_case(bool same)
{
    cases += 1;
    differences += !same;
}

int main(int argc, char **argv)
{
    bool failed = false;
    bench_start(argc, argv);
    for (const equality_test *each = equality_tests; each->name != NULL; each++) {
        cases = 0;
        differences = 0;
        each->run(system_frames() * ROUNDS);
        text_with_number("equality: ", each->name, " ", cases);
        text_with_number("equality: ", "differences", " ", differences);
        failed |= differences != 0;
    }
    system_text("equality: done\n");
    system_exit(failed ? SYSTEM_EXIT_TEST : SYSTEM_EXIT_DONE);
    return SYSTEM_EXIT_DONE; /* not reached */
}
