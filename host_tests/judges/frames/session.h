/* SPDX-License-Identifier: MIT */
/* A scene image and a renderer for it with all the memory that it wants: what the programs
 * share that draw frames on the host. */
#ifndef FRAMES_SESSION_H
#define FRAMES_SESSION_H

#include "draw/stages.h"
#include "fixel/all.h"
#include "lights/named.h"
#include "study/clippers.h"

/* place pixel-format: the option pixels, the targets, frames as files */
/* How frames are drawn. In session_reserve: the largest that session_set_up is given. */
typedef struct {
    const fxl_clipper *clipper;
    const fxl_order *order;
    const fxl_target *target; /* where the pixels are a palette's */
    uint8_t pixel_bits;       /* 16: the target of RGB565 with the same depth; else 0 or 8 */
    bool without_surfaces;    /* faces are drawn in their own colours, as by a tree */
    uint32_t display_list_words, cache_entries;
    uint32_t raster_bytes; /* memory of the target */
    uint32_t pieces_bytes; /* for the pieces of movers, if the scene has a BSP tree; a multiple of 8 */
} session_settings;

typedef struct {
    fxl_scene_image image;
    fxl_motion_player motion; /* if the image has motions */
    fxl_renderer renderer;
    fxl_clipper_workspace clipper_workspace;
    fxl_memory memory;
    fxl_surface_set surface_set; /* if the image has surfaces */
    fxl_surfaces surfaces;
    fxl_light light;
    fxl_lit_surfaces lit;
    fxl_billboard_set billboard_set; /* if the image has billboards */
    fxl_billboards billboards;
    fxl_lines lines;
    uint8_t ramp[FXL_LIGHT_RAMP_BYTES(FXL_LIGHT_LEVELS_MAX)];
    void *tree, *depth, *beam_light; /* memory of the order, the target, the beams */
    fxl_outlines outlines;
    fxl_workspace second; /* of another core, which draws every second band, if there is one */
    bool has_second;
    uint32_t bands;       /* drawn since the frame began */
    uint32_t border;      /* 1 + the palette index of a border that is drawn over each frame; 0: none */
    uint16_t palette[256];           /* in RGB565 */
} session;

/* Zeroed memory that lives until the program ends. Without memory, the program ends with 2. */
void *session_memory(size_t size);

/* The order and the target of a scene for which none is asked. */
void session_follow_scene(const session *run, session_settings *settings);

/* Reads and opens a scene image, which stays open until the program ends; what moves is as in
 * frame 0. Null, or what is wrong. */
const char *session_open(session *run, const char *path);

/* The same of an image that is read, aligned to four. */
const char *session_open_bytes(session *run, const uint8_t *bytes, size_t size);

/* Moves what moves to where it is in a frame. */
void session_play(const session *run, uint32_t frame);

/* Allocates the memory of a renderer that is set up with these settings or smaller ones, and
 * with any order if theirs is fxl_by_tree. */
void session_reserve(session *run, const session_settings *most);

/* Sets the renderer up anew. What the library answers. */
fxl_status session_set_up(session *run, const session_settings *settings);

/* Has the renderer, which is set up, draw in a light. What the library answers. */
fxl_status session_light(session *run, const named_light *light);

/* Has the renderer, which is set up with all that is attached, draw every second band as another core
 * does. What the library answers. */
fxl_status session_add_core(session *run);

/* Makes the lens of an image with a scale orthographic: once. */
fxl_status session_take_scale(fxl_scene_image *image);

/* Draws a frame into pixels, uint8_t or uint16_t, as large as the lens says: begins it, fills each band of
 * so many rows (0: the whole frame) with the background, and draws the band. Ends at the first
 * status that is not FXL_OK. */
fxl_status session_draw(session *run, const fxl_pose *pose, uint32_t rows, uint8_t background,
                        void *pixels);

/* The bands alone, drawn by any function: with the renderer of a frame that has begun,
 * session_draw_band; with a wire, fxl_wire_draw. */
typedef fxl_status session_band_drawer(void *with, const fxl_band *band);
fxl_status session_draw_band(void *renderer, const fxl_band *band);
fxl_status session_draw_bands(const fxl_lens *lens, uint32_t rows, uint8_t background,
                              uint8_t *pixels, session_band_drawer *draw, void *with);

/* Bits of a pixel that the renderer draws. */
uint8_t session_pixel_bits(const session *run);

#endif
