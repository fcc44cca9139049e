/* SPDX-License-Identifier: MIT */
/* What fxl_scene_open answers to an image that differs from tiny_image_make's
 * in one place, sealed after the change; a refusal must leave *opened alone. */
#ifndef EXPECT_SCENE_H
#define EXPECT_SCENE_H

#include "tiny.h"

/* Bytes of an entry of each table. */
enum {
    VERTEX = 12,
    CORNER = 2,
    FACE = 20,
    MODEL = 28,
    KEY = 20,
    INSTANCE = 16,
    POSE = 24,
    STRIDE = 4
};

/* Opens the bytes as they are. */
void expect_status(fxl_status status, const void *bytes, size_t size);

/* Seals what the test has changed, and opens it. */
void expect_opening(fxl_status status, tiny_image *image);

/* The same for any image: a word or half of it that is something else, or a word of the bytes of a
 * table. */
void expect_image_word(fxl_status status, tiny_image *image, uint32_t at, uint32_t value);
void expect_image_half(fxl_status status, tiny_image *image, uint32_t at, uint16_t value);
void expect_image_entry_word(fxl_status status, tiny_image *image, uint32_t table, uint32_t at,
                             uint32_t value);

/* A word or half of the header that is something else. */
void expect_word(fxl_status status, uint32_t at, uint32_t value);
void expect_half(fxl_status status, uint32_t at, uint16_t value);

/* A word or byte of an entry that is something else. */
void expect_entry_word(fxl_status status, uint32_t table, uint32_t number, uint32_t size,
                       uint32_t at, uint32_t value);
void expect_entry_byte(fxl_status status, uint32_t table, uint32_t number, uint32_t size,
                       uint32_t at, uint8_t value);

#endif
