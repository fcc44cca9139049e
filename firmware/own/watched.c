/* SPDX-License-Identifier: MIT */
/* A program of your own that is watched on this machine (make view PROGRAM=my.c). It draws a frame
 * each time that the viewer wants one, and says which face is at a pixel of the frame that it drew.
 * Both come through a socket, whose number is the program's last argument. The program may move
 * its scene as soon as a frame is drawn, so a copy of the process keeps the frame and answers. */
#define _POSIX_C_SOURCE 200809L

#include <stdlib.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fixel/pick.h"
#include "own.h"

#define WATCHED_ARGUMENTS 6 /* those of boards/host/board.c, and the socket */
#define NO_ANSWER         0xFFFFu

/* What the viewer sends, and what it gets for WANT_FACE. tools/fixel/view/view_own.py */
enum {
    WANT_FRAME = 1,
    WANT_FACE = 2
};

typedef struct {
    uint16_t wants, x, y, unused;
} request;

typedef struct {
    uint16_t status; /* of fxl_pick_face, or NO_ANSWER: the copy has ended */
    uint16_t instance, face, unused;
} answer;

static int viewer = -1; /* the socket */
static int keeper = -1; /* a socket to the copy that keeps the frame; -1: there is none */
static pid_t keeper_process;

static bool receive(int from, void *bytes, size_t size)
{
    return recv(from, bytes, size, MSG_WAITALL) == (ssize_t)size;
}

static bool transmit(int to, const void *bytes, size_t size)
{
    return send(to, bytes, size, MSG_NOSIGNAL) == (ssize_t)size;
}

/* The copy: answers until the program closes its end, or ends. */
static void answer_requests(fxl_renderer *renderer, int program)
{
    request asked;

    while (receive(program, &asked, sizeof asked)) {
        fxl_picked picked = {FXL_PICK_NONE, 0, 0};
        const fxl_status status = fxl_pick_face(renderer, asked.x, asked.y, &picked);
        const answer found = {(uint16_t)status, picked.instance, picked.face, 0};

        if (!transmit(program, &found, sizeof found)) {
            break;
        }
    }
    _exit(EXIT_SUCCESS);
}

static void end_copy(void)
{
    if (keeper >= 0) {
        (void)close(keeper);
        (void)waitpid(keeper_process, NULL, 0);
        keeper = -1;
    }
}

int own_arguments(int argc, char **argv)
{
    if (argc != WATCHED_ARGUMENTS) {
        return argc;
    }
    viewer = atoi(argv[WATCHED_ARGUMENTS - 1]);
    argv[WATCHED_ARGUMENTS - 1] = NULL;
    return WATCHED_ARGUMENTS - 1;
}

void own_keep(fxl_renderer *renderer)
{
    int ends[2];

    if (viewer < 0) {
        return;
    }
    end_copy();
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
        return; /* the viewer is told that nobody answers */
    }
    keeper_process = fork();
    if (keeper_process == 0) {
        (void)close(ends[0]);
        (void)close(viewer);
        answer_requests(renderer, ends[1]);
    }
    (void)close(ends[1]);
    keeper = ends[0];
    if (keeper_process < 0) {
        (void)close(keeper);
        keeper = -1;
    }
}

void own_wait(void)
{
    request asked;

    if (viewer < 0) {
        return;
    }
    do {
        answer found = {NO_ANSWER, 0, 0, 0};

        if (!receive(viewer, &asked, sizeof asked)) {
            _exit(EXIT_SUCCESS); /* nobody watches */
        }
        if (asked.wants == WANT_FACE) {
            if (keeper < 0 || !transmit(keeper, &asked, sizeof asked) ||
                !receive(keeper, &found, sizeof found)) {
                found.status = NO_ANSWER;
            }
            (void)transmit(viewer, &found, sizeof found);
        }
    } while (asked.wants != WANT_FRAME);
}
