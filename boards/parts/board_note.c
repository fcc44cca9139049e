/* SPDX-License-Identifier: MIT */
/* The board that a program was built for, in a section of its own, for the tools: lines of
 * key=value, ended by 0. The tools have no other table of boards. */

__attribute__((section(".fxl_board"), used)) static const char board_note[] =
    "board=" BOARD_NAME "\ncpu=" BOARD_CPU "\nqemu=" BOARD_QEMU "\nopenocd=" BOARD_OPENOCD
    "\n" BOARD_NOTE;

#ifdef BOARD_SECTORS
/* The count and the size of each run of equal sectors of the flash, where they differ; no board
 * loads it. */
__attribute__((section(".fxl_sectors"), used)) static const unsigned board_sectors[] = {
    BOARD_SECTORS};
#endif
