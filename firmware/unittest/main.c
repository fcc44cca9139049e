/* SPDX-License-Identifier: MIT */
/* Runs one Unity test file on a board: its generated runner, then the end
 * marker and an agreed exit code. */
#include "contract/system.h"
#include "unittest.h"

#define LINE_MAX 256

void fxl_assert_failed(const char *file, int at); /* lib/src/math/arith.h */
int unittest_run(void); /* the generated runner; returns how many tests failed */

static char line[LINE_MAX];
static unsigned length;

void unittest_flush(void)
{
    line[length] = '\0';
    length = 0;
    system_text(line);
}

void unittest_put(int character)
{
    line[length] = (char)character;
    length++;
    if (character == '\n' || length == LINE_MAX - 1) {
        unittest_flush();
    }
}

static void put_text(const char *text)
{
    for (; *text != '\0'; text++) {
        unittest_put(*text);
    }
}

/* Called by the library's assertions. A test may define its own. */
__attribute__((weak)) void fxl_assert_failed(const char *file, int at)
{
    char digits[11]; /* 2147483647 and the 0 that ends it */
    char *first = &digits[sizeof digits - 1];

    *first = '\0';
    do {
        first--;
        *first = (char)('0' + at % 10);
        at /= 10;
    } while (at != 0);
    put_text(file);
    unittest_put(':');
    put_text(first);
    put_text(": assertion failed\n");
    system_exit(SYSTEM_EXIT_ASSERTION);
}

int main(int argc, char **argv)
{
    int failed;

    (void)argc;
    (void)argv;
    unittest_allow_library();
    failed = unittest_run();
    unittest_flush();
    system_text("unittest: done\n");
    return failed == 0 ? SYSTEM_EXIT_DONE : SYSTEM_EXIT_TEST;
}
