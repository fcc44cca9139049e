/* SPDX-License-Identifier: MIT */
/* What the loader says of many images: reads a file of images, each a u32 size and then so many
 * bytes, and prints a line for each: the status's number, what is at fault, its index. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fixel/billboards.h"
#include "fixel/surfaces.h"
#include "fixel/scene.h"
#include "frames/read_file.h"

/* Opens the surfaces of an image, if it has some. */
static fxl_status open_surfaces(const fxl_scene_image *opened, fxl_scene_fault *fault)
{
    const uint32_t count = opened->surfaces.texture_count;
    fxl_surface_set set;
    if (opened->surfaces.face_map == NULL) {
        return FXL_OK;
    }
    fxl_texture *textures = malloc((count + 1u) * sizeof *textures);
    fxl_status status =
        textures ? fxl_surfaces_open(opened, textures, count, &set, fault) : FXL_E_CAPACITY;
    free(textures);
    return status;
}

/* Opens the billboards of an image, if it has some. */
static fxl_status open_billboards(const fxl_scene_image *opened, fxl_scene_fault *fault)
{
    const uint32_t count = opened->billboards.count;
    fxl_billboard_set set;
    if (opened->billboards.model_map == NULL) {
        return FXL_OK;
    }
    fxl_sprite *sprites = malloc((count + 1u) * sizeof *sprites);
    fxl_billboard *boards = malloc((count + 1u) * sizeof *boards);
    fxl_status status = sprites && boards
                            ? fxl_billboards_open(opened, sprites, boards, count, &set, fault)
                            : FXL_E_CAPACITY;
    free(sprites);
    free(boards);
    return status;
}

/* Copies an image to memory of its own, aligned and no longer than it, and opens it there. */
static int judge(const uint8_t *bytes, uint32_t size)
{
    uint8_t *image = malloc(size > 0 ? size : 1);
    fxl_scene_image opened;
    fxl_scene_fault fault = {"-", 0};
    if (!image) {
        return 1;
    }
    memcpy(image, bytes, size);
    fxl_status status = fxl_scene_open(image, size, &opened, &fault);
    if (status == FXL_OK) {
        status = open_surfaces(&opened, &fault);
    }
    if (status == FXL_OK) {
        status = open_billboards(&opened, &fault);
    }
    printf("%d %u %s\n", (int)status, (unsigned)fault.index, fault.what);
    free(image);
    return 0;
}

int main(int count, char **arguments)
{
    size_t size = 0, at = 0;
    uint8_t *bytes = count == 2 ? read_file(arguments[1], &size) : NULL;
    if (!bytes) {
        fprintf(stderr, "error: usage: loader FILE of images\n");
        return 2;
    }
    while (at < size) {
        uint32_t length = 0;
        if (size - at >= sizeof length) {
            memcpy(&length, bytes + at, sizeof length);
            at += sizeof length;
        }
        if (length == 0 || length > size - at || judge(bytes + at, length)) {
            fprintf(stderr, "error: %s: not a file of images at byte %zu\n", arguments[1], at);
            return 2;
        }
        at += length;
    }
    free(bytes);
    return 0;
}
