/* SPDX-License-Identifier: MIT */
#include "loader/rays.h"

#include <setjmp.h>

/* place field: images that all refuse alike */
#include "raycast/scene_sections.h"

/* The ray-cast judge refuses by `unusable`, which ends a program. The linker puts
 * __wrap_unusable in its place: it ends the reading of one image. */
static jmp_buf refused;

_Noreturn void __wrap_unusable(const char *format, ...);

_Noreturn void __wrap_unusable(const char *format, ...)
{
    (void)format;
    longjmp(refused, 1);
}

bool rays_take(uint8_t *image, uint32_t size)
{
    file_block block = {image, size};
    table sections[KINDS];
    if (setjmp(refused) != 0) {
        return false;
    }
    sections_read("image", &block, sections);
    return true;
}
