/* SPDX-License-Identifier: MIT */
#include "diary.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PIXEL_BYTES (2u * 320u * 240u)
#define FRAMES      3u

static struct {
    const uint8_t *bytes; /* null: nothing is sent */
    uint8_t *copy;
    size_t size;
} transfer;
static size_t sent; /* bytes of long messages, which are pixels */

static void put(const char *word, const uint8_t *bytes, size_t size)
{
    size_t i;

    printf("%s ", word);
    for (i = 0; i < size; i++) {
        printf("%02x", bytes[i]);
    }
    printf("\n");
}

/* The first frame comes after the glass was filled with black, which is a frame's bytes too. */
static void count(size_t size)
{
    sent += size > 16u ? size : 0;
    if (sent >= (FRAMES + 1u) * PIXEL_BYTES) {
        exit(0);
    }
}

void diary_pin(unsigned number, bool level)
{
    printf("pin %u %d\n", number, level);
}

void diary_bytes(const uint8_t *bytes, size_t size)
{
    put("bytes", bytes, size);
    count(size);
}

void diary_start(const uint8_t *bytes, size_t size)
{
    if (transfer.bytes != NULL) {
        printf("fault a transfer is started while another one is under way\n");
        exit(1);
    }
    transfer.bytes = bytes;
    transfer.size = size;
    transfer.copy = malloc(size);
    memcpy(transfer.copy, bytes, size);
    printf("start %zu\n", size);
}

void diary_finish(void)
{
    if (transfer.bytes == NULL) {
        return;
    }
    if (memcmp(transfer.copy, transfer.bytes, transfer.size) != 0) {
        printf("fault bytes were touched while they were sent\n");
        exit(1);
    }
    put("done", transfer.bytes, transfer.size);
    free(transfer.copy);
    transfer.bytes = NULL;
    count(transfer.size);
}

static bool is_time_for(const char *fault)
{
    const char *wanted = getenv("FAULT");

    return wanted != NULL && strcmp(wanted, fault) == 0 && sent > PIXEL_BYTES;
}

bool diary_hangs(void)
{
    return is_time_for("hang");
}

bool diary_fails(void)
{
    return is_time_for("error");
}

bool diary_is_sending(void)
{
    return transfer.bytes != NULL;
}

void diary_sleep(unsigned milliseconds)
{
    printf("sleep %u\n", milliseconds);
}

void diary_setup(const char *text)
{
    printf("setup %s\n", text);
}
