/* SPDX-License-Identifier: MIT */
/* floor and ceil for the tests on a RISC-V core: those of picolibc 1.8 (Debian 12) lose a carry for
 * some numbers. floor of the double with the words C1BBF286 FF58E44C gives C1BBF286 00000000
 * instead of C1BBF287 00000000. Elsewhere this file has no contents. */
#if defined __riscv
#include <stdint.h>

#define WHOLE_FROM 4503599627370496.0 /* 2^52: there every number is whole, or none is one */

double floor(double value);
double ceil(double value);

double floor(double value)
{
    double whole;

    if (!(value > -WHOLE_FROM && value < WHOLE_FROM)) {
        return value;
    }
    whole = (double)(int64_t)value;
    return whole > value ? whole - 1.0 : whole;
}

double ceil(double value)
{
    return -floor(-value);
}
#else
extern int unittest_has_no_picolibc; /* a source without any declaration is none */
#endif
