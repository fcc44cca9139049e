/* SPDX-License-Identifier: MIT */
/* What the loader says of many images: reads a file of images, each a u32 size and then so many
 * bytes, and prints a line for each: the status's number, its index, what is at fault. With
 * --three: "ok" or "no" by header and sections, of the loader, the reference and the ray-cast
 * judge. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fixel/billboards.h"
#include "fixel/horizon.h"
#include "fixel/lines.h"
#include "fixel/surfaces.h"
#include "fixel/scene.h"
#include "frames/input.h"
#include "loader/rays.h"
#include "reference/sections.h"
#include "scene/scene_sections.h"

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

/* The status of an image that lies in memory of its own, aligned and no longer than it. */
static fxl_status open_all(const uint8_t *image, uint32_t size, fxl_scene_fault *fault)
{
    fxl_scene_image opened;
    fxl_status status = fxl_scene_open(image, size, &opened, fault);
    if (status == FXL_OK) {
        status = open_surfaces(&opened, fault);
    }
    if (status == FXL_OK) {
        status = open_billboards(&opened, fault);
    }
    if (status == FXL_OK && opened.lines.line_map != NULL) {
        status = fxl_lines_check(&opened.lines, &opened.scene, fault);
    }
    if (status == FXL_OK && opened.horizon.sines != NULL) {
        *fault = (fxl_scene_fault){"horizon", 0};
        status = fxl_horizon_check(&opened.horizon);
    }
    return status;
}

/* place field: images that all refuse alike */
static bool library_takes(const uint8_t *image, uint32_t size)
{
    const fxl_image_header *head = (const fxl_image_header *)(const void *)image;
    return fxl_scene_sections_check(head, size, NULL) == FXL_OK;
}

static int judge(const uint8_t *bytes, uint32_t size, bool by_three)
{
    uint8_t *image = malloc(size > 0 ? size : 1);
    fxl_scene_fault fault = {"-", 0};
    if (!image) {
        return 1;
    }
    memcpy(image, bytes, size);
    if (by_three) {
        printf("%s %s %s\n", library_takes(image, size) ? "ok" : "no",
               ref_sections_check(image, size) == NULL ? "ok" : "no",
               rays_take(image, size) ? "ok" : "no");
    } else {
        const fxl_status status = open_all(image, size, &fault);
        printf("%d %u %s\n", (int)status, (unsigned)fault.index, fault.what);
    }
    free(image);
    return 0;
}

int main(int count, char **arguments)
{
    size_t size = 0, at = 0;
    const bool by_three = count == 3 && strcmp(arguments[1], "--three") == 0;
    const char *path = arguments[count - 1];
    uint8_t *bytes = count == 2 || by_three ? read_file(path, &size) : NULL;
    if (!bytes) {
        fprintf(stderr, "error: usage: loader [--three] FILE of images\n");
        return 2;
    }
    while (at < size) {
        uint32_t length = 0;
        if (size - at >= sizeof length) {
            memcpy(&length, bytes + at, sizeof length);
            at += sizeof length;
        }
        if (length == 0 || length > size - at || judge(bytes + at, length, by_three)) {
            fprintf(stderr, "error: %s: not a file of images at byte %zu\n", path, at);
            return 2;
        }
        at += length;
    }
    free(bytes);
    return 0;
}
