/* SPDX-License-Identifier: MIT */
/* show of docs/examples.md, for a program that leaves it to whoever runs it: own.c shows the frames as
 * they are drawn, and ends the program. */
int show(const void *pixels);

int show(const void *pixels)
{
    (void)pixels;
    return 0; /* another frame, please */
}
