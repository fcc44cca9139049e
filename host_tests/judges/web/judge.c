/* SPDX-License-Identifier: MIT */
/* The reference renderer and its verdict as a WebAssembly module, for the site's page. It imports nothing; its host
 * (tools/templates/judge.mjs) writes a scene image and requests of live/main.c into the module's memory. */
#include <stdlib.h>

#include "frames/input.h"
#include "live/answer.h"

#define EXPORTED(name) __attribute__((export_name(name)))

static live_session run;
static uint8_t request[LIVE_REQUEST_SIZE];
static live_answer answer;
static uint8_t *bytes; /* of the image */

/* Before open: where the host writes the scene image; null: there is not enough memory. */
EXPORTED("scene") uint8_t *scene_room(size_t size)
{
    bytes = malloc(size + 1);
    return bytes;
}

/* Returns null, or a clause that says what is wrong. A module opens one scene. */
EXPORTED("open") const char *open_scene(size_t size)
{
    return live_open(&run, bytes, size, REF_METHOD_OF_SCENE);
}

/* Where the host writes a request, and the board's frame. */
EXPORTED("request") uint8_t *request_room(void)
{
    return request;
}

EXPORTED("board") uint8_t *board_room(void)
{
    return run.board;
}

/* Answers the request. Returns null, or a clause that says what is wrong. */
EXPORTED("ask") const char *ask(void)
{
    return live_ask(&run, request, &answer);
}

/* The pointers of the four parts, and then their sizes, in words of 32 bits. */
EXPORTED("answer") const void *what_was_answered(void)
{
    return &answer;
}

/* The host sees a trap. */
void give_up(const char *why)
{
    (void)why;
    __builtin_trap();
}
