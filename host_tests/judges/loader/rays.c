/* SPDX-License-Identifier: MIT */
#include "loader/rays.h"

#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

#include "raycast/scene_sections.h"

/* The judge ends its process where it refuses: so it has one of its own. */
bool rays_take(uint8_t *image, uint32_t size)
{
    int ended = 1;
    const pid_t child = fork();
    if (child == 0) {
        file_block block = {image, size};
        table sections[KINDS];
        (void)freopen("/dev/null", "w", stderr);
        sections_read("image", &block, sections);
        _exit(0);
    }
    return child > 0 && waitpid(child, &ended, 0) == child && ended == 0;
}
