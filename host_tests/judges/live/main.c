/* SPDX-License-Identifier: MIT */
/* live SCENE.fxls [--clipper NAME] [--hidden NAME]
 *
 * Draws with the reference renderer, pose by pose. A request on standard
 * input is 36 bytes, and the board's pixels where it wants the verdict. An answer
 * on standard output is a head of 24 bytes and the parts that the request wants.
 * All is little-endian, as in docs/formats.md, section 1:
 *
 *   request  bytes A S K S; u8 wants (1 frame, 2 outlines, 4 faces, 8 verdict);
 *            u8 x 3, 0; pose; u32 number of the frame, which says where things
 *            are that move; with 8: the board's frame, width x height pixels
 *   answer   bytes T W I N; u32 number of the request, from 0; u32 x 4: bytes of
 *            each of the four parts, 0 for a part that is not wanted; the parts
 *
 * The parts. Frame, faces and verdict have an entry for each pixel, rows downward:
 *
 *   frame     u8 palette index; or u16 of RGB565, as the board's pixels are then
 *   outlines  in the order of drawing: u16 points, u8 colour, u8 0, then for each
 *             point f32 x, f32 y in pixels
 *   faces     what the frame shows: u16 instance, u16 face within its model, or FFFF FFFF where
 *             that is the background; f32 how far away, along the view's axis; of its texel u16
 *             column and row, then u16 width and height of the level, 0 without a texture
 *   verdict   u8: 0 the board's pixel equals the frame's, 1 it is explained within
 *             the bound by which `make run` judges, 2 it is not
 *
 * Ends with 0 at the end of its input; with 2 and a sentence where a file or a
 * request is not what it should be, or nobody reads. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frames/input.h"
#include "live/answer.h"
#include "reference/frustum.h"

enum {
    ANSWER_HEAD = 24
};

/* 0, or 2 after saying why. */
static int write_answer(uint32_t number, const live_answer *answer)
{
    uint8_t head[ANSWER_HEAD];
    memcpy(head, "TWIN", 4);
    live_put_u32(head + 4, number);
    for (int i = 0; i < LIVE_PARTS; i++) {
        live_put_u32(head + 8 + 4 * i, (uint32_t)answer->sizes[i]);
    }
    bool written = fwrite(head, 1, sizeof head, stdout) == sizeof head;
    for (int i = 0; i < LIVE_PARTS && written; i++) {
        const size_t size = answer->sizes[i];
        written = size == 0 || fwrite(answer->bytes[i], 1, size, stdout) == size;
    }
    return written && fflush(stdout) == 0 ? 0 : fail("standard output", "nobody reads it");
}

static int serve(live_session *run)
{
    uint8_t request[LIVE_REQUEST_SIZE];
    for (uint32_t number = 0;; number++) {
        const size_t got = fread(request, 1, sizeof request, stdin);
        if (got == 0) {
            return 0;
        }
        const bool judges = got == sizeof request && (request[4] & LIVE_WANT_VERDICT) != 0;
        if (got != sizeof request ||
            (judges && fread(run->board, 1, run->frame_bytes, stdin) != run->frame_bytes)) {
            return fail("standard input", "it ends within a request");
        }
        live_answer answer;
        const char *wrong = live_ask(run, request, &answer);
        const int code = wrong ? fail("standard input", wrong) : write_answer(number, &answer);
        if (code != 0) {
            return code;
        }
    }
}

int main(int count, char **arguments)
{
    ref_method method = REF_METHOD_OF_SCENE;
    const char *scene;
    const argument known[] = {{"--clipper", ref_take_clipper, &method},
                              {"--hidden", ref_take_visibility, &method}};
    if (!read_arguments(count, arguments, known, 2, &scene, 1)) {
        return fail("live: usage", "live SCENE.fxls [--clipper NAME] [--hidden NAME]");
    }
    size_t size;
    uint8_t *bytes = read_file(scene, &size);
    if (!bytes) {
        return fail(scene, "it cannot be read");
    }
    static live_session run;
    const char *wrong = live_open(&run, bytes, size, method);
    const int code = wrong ? fail(scene, wrong) : serve(&run);
    live_close(&run);
    free(bytes);
    return code;
}
