/* SPDX-License-Identifier: MIT */
#include "text.h"

#include "contract/system.h"

void text_with_number(const char *before, const char *name, const char *between, uint32_t number)
{
    char digits[12]; /* 4294967295, the line's end and the 0 */
    char *first = &digits[sizeof digits - 1];

    *first-- = '\0';
    *first = '\n';
    do {
        first--;
        *first = (char)('0' + number % 10u);
        number /= 10u;
    } while (number != 0);
    system_text(before);
    system_text(name);
    system_text(between);
    system_text(first);
}
