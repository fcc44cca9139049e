/* SPDX-License-Identifier: MIT */
/* The benchmark on a Raspberry Pi Pico, without an SDK: it prints on UART0, pin GPIO 0, at 115,200
 * baud, every five seconds. */
#include "benchmark.h"
#include "parts/cortexm.h"
#include "pico/rp2040.h"

#define PAUSE_MICROSECONDS 5000000u

int main(int argc, char **argv)
{
    static const benchmark_port port = {"pico", RP2040_HZ, rp2040_microseconds, rp2040_uart_text};

    (void)argc;
    (void)argv;
    for (;;) {
        const uint32_t begun = rp2040_microseconds();

        if (!benchmark_run(&port)) {
            rp2040_uart_text("FIXEL,refused\n");
        }
        while (rp2040_microseconds() - begun < PAUSE_MICROSECONDS) {
        }
    }
}
