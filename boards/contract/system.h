/* SPDX-License-Identifier: MIT */
/* Board contract: arguments, text for people, and how a program ends. */
#ifndef BOARD_SYSTEM_H
#define BOARD_SYSTEM_H

#include <stdbool.h>
#include <stdint.h>

/* How a program ends. The tools read this table: one line each, a sentence in
 * the comment. A program has succeeded only with SYSTEM_EXIT_DONE, and only if
 * it also printed its end marker: an emulator answers 0 for a reset and for
 * its own death. */
enum {
    SYSTEM_EXIT_DONE = 93,       /* everything was done */
    SYSTEM_EXIT_ARGUMENT = 10,   /* an argument was not understood */
    SYSTEM_EXIT_STORE = 11,      /* the board has no scene partition, or could not read it */
    SYSTEM_EXIT_SCENE = 12,      /* the scene image was refused */
    SYSTEM_EXIT_CAPACITY = 13,   /* the scene needs more memory than the board has set aside */
    SYSTEM_EXIT_RENDER = 14,     /* the renderer refused a call */
    SYSTEM_EXIT_DISPLAY = 15,    /* the display could not be opened, or did not take every pixel */
    SYSTEM_EXIT_JOURNAL = 16,    /* what is told about a frame could not be written */
    SYSTEM_EXIT_INPUT = 17,      /* the keys that are held make no sense */
    SYSTEM_EXIT_PROGRAM = 18,    /* the program of PROGRAM=FILE failed by itself */
    SYSTEM_EXIT_ASSERTION = 20,  /* an assertion failed: a bug of the program */
    SYSTEM_EXIT_TEST = 21,       /* a unit test failed */
    SYSTEM_EXIT_BOARD = 22,      /* the core or the board lacks what the program needs */
    SYSTEM_EXIT_STACK = 40,      /* fault: the stack overflowed */
    SYSTEM_EXIT_DIVIDE = 41,     /* fault: division by zero */
    SYSTEM_EXIT_UNALIGNED = 42,  /* fault: access to a misaligned address */
    SYSTEM_EXIT_FLASH = 43,      /* fault: write to flash */
    SYSTEM_EXIT_NULL = 44,       /* fault: access through a null pointer */
    SYSTEM_EXIT_PROTECTION = 45, /* fault: access that the memory protection forbids */
    SYSTEM_EXIT_BUS = 46,        /* fault: access to an address where nothing answers */
    SYSTEM_EXIT_USAGE = 47,      /* fault: an instruction that the core cannot execute */
    SYSTEM_EXIT_HARD = 48,       /* fault: a hard fault of unknown cause */
    SYSTEM_EXIT_INTERRUPT = 49,  /* fault: an interrupt that nobody asked for */
    SYSTEM_EXIT_HANG = 50        /* fault: the program hung: the watchdog was not fed */
};

/* Reads the arguments. The first call of every program. argc and argv are those of main, 0 and
 * null where main gets none. Ends the program with SYSTEM_EXIT_ARGUMENT, and a sentence, where
 * it does not understand them. */
void system_start(int argc, char **argv);

/* Returns how many frames the arguments ask for; 0: the whole path. */
uint32_t system_frames(void);

/* Tells whether the player's keys replace the scene's path from the first frame on. */
bool system_live(void);

/* A sign of life, which a program gives at least once a frame. The first one starts the board's
 * watchdog, where it has one. If signs of life then stay away, the watchdog ends the program
 * with SYSTEM_EXIT_HANG. Ends the program with SYSTEM_EXIT_STACK where the board detects that
 * the stack has overflowed. */
void system_alive(void);

/* Prints text unchanged, for people. Requires a string. */
void system_text(const char *text);

/* Ends the program; does not return. */
void system_exit(int status);

#endif
