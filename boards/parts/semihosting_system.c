/* SPDX-License-Identifier: MIT */
/* system.h with semihosting. The arguments are words: the program's name, then frames=N, live
 * and hold in any order. */
#include "contract/system.h"

#include <stddef.h>

#include "parts/cortexm.h"
#include "parts/semihosting.h"
#include "parts/stack.h"
#include "parts/watchdog.h"

#define FRAMES_MAX UINT32_MAX /* the frames of a live run have no end */

static struct {
    uint32_t frames;
    bool live;
    bool hold; /* stay on when done, so that the screen can be looked at */
} arguments;

static void refuse(const char *word)
{
    semihosting_text("argument not understood: ");
    semihosting_text(word);
    semihosting_text("\n");
    semihosting_exit(SYSTEM_EXIT_ARGUMENT);
}

/* Tells whether a word begins with a prefix, and where the rest of it is. */
static const char *after(const char *word, const char *prefix)
{
    while (*prefix != '\0') {
        if (*word != *prefix) {
            return NULL;
        }
        word++;
        prefix++;
    }
    return word;
}

static bool is(const char *word, const char *expected)
{
    const char *rest = after(word, expected);

    return rest != NULL && *rest == '\0';
}

static bool read_frames(const char *digits, uint32_t *frames)
{
    uint64_t value = 0;

    if (*digits == '\0') {
        return false;
    }
    for (; *digits != '\0'; digits++) {
        if (*digits < '0' || *digits > '9') {
            return false;
        }
        value = value * 10u + (uint64_t)(*digits - '0'); /* <= 10 FRAMES_MAX + 9 */
        if (value > FRAMES_MAX) {
            return false;
        }
    }
    *frames = (uint32_t)value;
    return true;
}

static void take(const char *word)
{
    const char *digits = after(word, "frames=");
    if (digits != NULL && read_frames(digits, &arguments.frames)) {
        return;
    }
    if (is(word, "live")) {
        arguments.live = true;
        return;
    }
    if (is(word, "hold")) {
        arguments.hold = true;
        return;
    }
    refuse(word);
}

void system_start(int argc, char **argv)
{
    char line[128];
    char *word = line;
    bool named = false;

    (void)argc;
    (void)argv;
    if (semihosting_arguments(line, sizeof line) == NULL) {
        return; /* no argument: the whole path */
    }
    while (*word != '\0') {
        char *end = word;
        bool last;

        while (*end != '\0' && *end != ' ') {
            end++;
        }
        last = *end == '\0';
        *end = '\0';
        if (end != word) {
            if (named) {
                take(word);
            }
            named = true;
        }
        word = last ? end : end + 1;
    }
}

uint32_t system_frames(void)
{
    return arguments.frames;
}

bool system_live(void)
{
    return arguments.live;
}

void system_text(const char *text)
{
    semihosting_text(text);
}

/* On a core with memory protection an overflow would have been a fault. */
static void check_stack(const void *caller)
{
    if (!cortexm_protected() && stack_is_spent()) {
        semihosting_text("fault: stack overflow: its last bytes are used, and nothing guards "
                         "them\n  address ");
        semihosting_hexadecimal((uint32_t)(uintptr_t)fxl_stack_limit);
        semihosting_text("\n  from ");
        semihosting_hexadecimal((uint32_t)(uintptr_t)caller);
        semihosting_text("\n");
        stack_print();
        semihosting_exit(SYSTEM_EXIT_STACK);
    }
}

void system_alive(void)
{
    static bool watched;

    check_stack(__builtin_return_address(0));
    if (!watched) {
        watched = true;
        watchdog_start(BOARD_WATCHDOG_MILLISECONDS);
    }
    watchdog_feed();
}

void system_exit(int status)
{
    check_stack(__builtin_return_address(0));
    stack_print();
    if (arguments.hold && status == SYSTEM_EXIT_DONE) {
        for (;;) {
            system_alive();
            __asm__ volatile("wfi"); /* until SysTick wraps */
        }
    }
    semihosting_exit(status);
}
