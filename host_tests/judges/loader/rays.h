/* SPDX-License-Identifier: MIT */
#ifndef LOADER_RAYS_H
#define LOADER_RAYS_H

#include <stdbool.h>
#include <stdint.h>

/* Whether the ray-cast judge takes the header and the sections of an image. */
bool rays_take(uint8_t *image, uint32_t size);

#endif
