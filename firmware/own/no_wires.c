/* SPDX-License-Identifier: MIT */
/* display_send and display_pause, for a program with a driver of a display that leaves the wires to
 * whoever runs it: nothing is sent here. own.c shows the bands as they are drawn, and with DRIVER= a
 * panel sends them. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

bool display_send(void *user, bool is_data, const uint8_t *bytes, size_t size);
void display_pause(void *user, uint32_t milliseconds);

bool display_send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    (void)user;
    (void)is_data;
    (void)bytes;
    (void)size;
    return true;
}

void display_pause(void *user, uint32_t milliseconds)
{
    (void)user;
    (void)milliseconds;
}
