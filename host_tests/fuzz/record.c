/* SPDX-License-Identifier: MIT */
#include "record.h"

#include <string.h>

/* FNV-1a of 64 bits. */
static const uint64_t basis = 0xCBF29CE484222325u, prime = 0x100000001B3u;
static uint64_t hash = 0xCBF29CE484222325u;

void record_bytes(const void *bytes, size_t size)
{
    const uint8_t *at = bytes;
    for (size_t i = 0; i < size; i++) {
        hash = (hash ^ at[i]) * prime;
    }
}

void record_number(int64_t number)
{
    record_bytes(&number, sizeof number);
}

void record_text(const char *text)
{
    record_bytes(text, text != NULL ? strlen(text) + 1 : 0);
}

void record_band(const fxl_band *band)
{
    for (uint32_t row = 0; row < band->rows; row++) {
        record_bytes(band->pixels + (size_t)row * band->stride, band->width);
    }
}

void record_points(const fxl_screen_polygon *polygon)
{
    record_number(polygon->count);
    record_bytes(polygon->points, polygon->count * sizeof polygon->points[0]);
}

void record_varying(const fxl_varying_polygon *polygon)
{
    record_number(polygon != NULL ? polygon->count : 0);
    for (uint32_t i = 0; polygon != NULL && i < polygon->count; i++) {
        const fxl_varying_vertex *vertex = &polygon->vertices[i];
        record_bytes(&vertex->position, sizeof vertex->position);
        record_bytes(vertex->carried, polygon->carried * sizeof vertex->carried[0]);
    }
}

uint64_t record_end(void)
{
    const uint64_t all = hash;
    hash = basis;
    return all;
}
