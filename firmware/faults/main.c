/* SPDX-License-Identifier: MIT */
/* Fails in the way that its last argument names, so a test can see what is reported from
 * outside. Also reads the clock, which is easy to get wrong. For every board but the host. */
#include <stdbool.h>
#include <stddef.h>

#include "cases.h"
#include "contract/system.h"
#include "parts/semihosting.h"

static bool is_equal(const char *a, const char *b)
{
    while (*a != '\0' && *a == *b) {
        a++;
        b++;
    }
    return *a == *b;
}

/* Of words separated by blanks. */
static const char *last_word(const char *words)
{
    const char *last = words;

    for (; *words != '\0'; words++) {
        if (*words == ' ') {
            last = words + 1;
        }
    }
    return last;
}

static const fault_case *find(const char *name)
{
    static const fault_case *const all[] = {core_cases, misaligned_cases, ending_cases,
                                            clock_cases};
    size_t i;

    for (i = 0; i < sizeof all / sizeof all[0]; i++) {
        const fault_case *each;

        for (each = all[i]; each->name != NULL; each++) {
            if (is_equal(each->name, name)) {
                return each;
            }
        }
    }
    return NULL;
}

void cannot_show(const char *why)
{
    semihosting_text("this board cannot show that: ");
    semihosting_text(why);
    semihosting_text("\n");
    semihosting_exit(SYSTEM_EXIT_BOARD);
}

int main(int argc, char **argv)
{
    char words[128];
    const fault_case *chosen = NULL;

    (void)argc;
    (void)argv;
    if (semihosting_arguments(words, sizeof words) != NULL) {
        chosen = find(last_word(words));
    }
    if (chosen == NULL) {
        semihosting_text("no such case\n");
        return SYSTEM_EXIT_ARGUMENT;
    }
    chosen->run();
    semihosting_text("nothing happened\n");
    return SYSTEM_EXIT_TEST;
}
