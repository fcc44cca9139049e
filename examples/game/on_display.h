/* SPDX-License-Identifier: MIT */
#ifndef ON_DISPLAY_H
#define ON_DISPLAY_H

#include "game.h"

/* Plays the game on a display until next_keys answers false. scene: the image that
 * tools/scene.py build made of game.toml, aligned to 4 bytes. module: its glass has at least the
 * screen of the scene, which is at most 320 wide. next_keys is called once before each frame: an
 * OR of FXL_KEY_... Returns what failed, or FXL_OK. */
fxl_status game_on_display(const void *scene, size_t scene_size, const fxl_display_config *module,
                           const fxl_display_port *port, bool (*next_keys)(uint32_t *keys));

#endif
