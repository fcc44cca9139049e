/* SPDX-License-Identifier: MIT */
#include "put_text.h"

#include <stdio.h>

void put_text(const char *text)
{
    (void)fputs(text, stdout);
}
