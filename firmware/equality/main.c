/* SPDX-License-Identifier: MIT */
/* The argument frames=N asks for N mod 2^10 thousand random inputs a kernel, of kernel N / 2^26
 * alone, counted from 1, or of all where that is 0. N / 2^10 mod 2^16 is the number of the shard:
 * each has random inputs of its own, after all boundary inputs. Prints for each kernel
 *   equality: NAME CASES
 *   equality: differences DIFFERENCES
 * and ends with SYSTEM_EXIT_TEST where there was a difference. */
#include "contract/system.h"
#include "equality.h"
#include "program.h"

#include <stddef.h>

#define ROUNDS       1000u
#define SHARD_SHIFT  10u
#define KERNEL_SHIFT 26u

static uint32_t cases, differences;

/* What an assertion of the library calls; equality.mk gives each its number in the file. */
void fxl_assert_failed(const char *file, int number);
void fxl_assert_failed(const char *file, int number)
{
    text_with_number("equality: assertion failed in ", file, ": number ", (uint32_t)number);
    system_exit(SYSTEM_EXIT_ASSERTION);
}

void equality_case(bool same)
{
    cases += 1;
    differences += !same;
}

typedef uint32_t __attribute__((may_alias)) word;

/* By memcmp, which goes by bytes, some kernels' tests took half of their time. */
bool equality_same_words(const void *a, const void *b, uint32_t bytes)
{
    const word *left = a, *right = b;
    word differ = 0;
    for (uint32_t i = 0; i < bytes / sizeof(word); i++) {
        differ |= left[i] ^ right[i];
    }
    return differ == 0;
}

uint32_t equality_cases(void)
{
    return cases;
}

static void run(const equality_test *test, uint32_t rounds)
{
    cases = 0;
    differences = 0;
    test->run(rounds);
    text_with_number("equality: ", test->name, " ", cases);
    text_with_number("equality: ", "differences", " ", differences);
}

int main(int argc, char **argv)
{
    bool failed = false;
    bench_start(argc, argv);
    const uint32_t asked = system_frames(), only = asked >> KERNEL_SHIFT;
    const uint32_t thousands = asked & ((1u << SHARD_SHIFT) - 1u);
    uint32_t number = 1;
    any_of_shard(asked >> SHARD_SHIFT & ((1u << (KERNEL_SHIFT - SHARD_SHIFT)) - 1u));
    for (const equality_test *each = equality_tests; each->name != NULL; each++, number++) {
        if (only == 0 || only == number) {
            run(each, thousands * ROUNDS);
            failed |= differences != 0;
        }
    }
    system_text("equality: done\n");
    system_exit(failed ? SYSTEM_EXIT_TEST : SYSTEM_EXIT_DONE);
    return SYSTEM_EXIT_DONE; /* not reached */
}
