/* SPDX-License-Identifier: MIT */
/* Runs files of Unity tests on a board, then prints the end marker and ends with an agreed exit
 * code. There may be one argument after the program's name: "after=NAME" begins behind that file,
 * "NAME" runs that file alone. */
#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/semihosting.h"
#include "parts/stack.h"
#include "unittest.h"

#include <stddef.h>
#include <string.h>

#define LINE_MAX  256
#define WORDS_MAX 96

void fxl_assert_failed(const char *file, int at); /* lib/math/arith.h */

/* The linker defines them. */
extern const unittest_entry __start_unittest_entries[], __stop_unittest_entries[];
extern char fxl_unit_data_start[], fxl_unit_data_end[], fxl_unit_bss_start[], fxl_unit_bss_end[];

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

/* Called by the library's assertions. */
void fxl_assert_failed(const char *file, int at)
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

/* Each file finds the memory of tests and helpers as a program of its own would. */
static void begin_anew(void)
{
    (void)memcpy(fxl_unit_data_start, (const char *)fxl_data_load + (fxl_unit_data_start - (char *)fxl_data_start),
                 (size_t)(fxl_unit_data_end - fxl_unit_data_start));
    (void)memset(fxl_unit_bss_start, 0, (size_t)(fxl_unit_bss_end - fxl_unit_bss_start));
}

/* Returns how many tests of a file failed. A stack that overflowed unguarded ends the program
 * here, so that the file is known. */
static int run(const unittest_entry *entry)
{
    int failed;

    put_text("unittest: ");
    put_text(entry->name);
    unittest_put('\n');
    begin_anew();
    failed = entry->run();
    unittest_flush();
    if (!cortexm_protected() && stack_is_spent()) {
        system_exit(SYSTEM_EXIT_STACK);
    }
    put_text("unittest: ");
    put_text(entry->name);
    put_text(" done\n");
    return failed;
}

int main(int argc, char **argv)
{
    static const char after[] = "after=";
    static char words[WORDS_MAX];
    const char *first = NULL;
    const char *only = NULL;
    int failed = 0;

    (void)argc;
    (void)argv;
    unittest_allow_library();
    if (semihosting_arguments(words, sizeof words) != NULL) {
        only = strchr(words, ' ');
    }
    if (only != NULL) {
        only++;
        if (strncmp(only, after, sizeof after - 1) == 0) {
            first = only + sizeof after - 1;
            only = NULL;
        }
    }
    for (const unittest_entry *entry = __start_unittest_entries; entry != __stop_unittest_entries; entry++) {
        if (first != NULL) {
            first = strcmp(first, entry->name) == 0 ? NULL : first;
        } else if (only == NULL || strcmp(only, entry->name) == 0) {
            failed += run(entry);
        }
    }
    system_text("unittest: done\n");
    return failed == 0 ? SYSTEM_EXIT_DONE : SYSTEM_EXIT_TEST;
}
