/* SPDX-License-Identifier: MIT */
/* An exported scene that sets itself up: one call for the renderer and all that the scene has,
 * another for each frame. docs/setup.md. */
#ifndef FXL_SETUP_H
#define FXL_SETUP_H

#include "fixel/beams.h"
#include "fixel/billboards.h"
#include "fixel/horizon.h"
#include "fixel/lines.h"
#include "fixel/motion.h"
#include "fixel/surfaces.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a scene has, and the functions of the library that set each part up. A header that
 * tools/scene.py export --c writes has one, NAME_setup. A member is null where the scene lacks the
 * part, so a program links no code for it. All that it points to must outlive the setup, but for
 * the records of scene, configuration, motions and light, which are copied. */
typedef struct {
    const fxl_scene *scene;   /* checked */
    const fxl_config *config; /* the scene's lens, background, target and palette of RGB565 */
    const fxl_order *order;   /* null: fxl_by_distance */
    /* fxl_renderer_init. Or a function of the program's own, which is given what the other shares
     * leave of the memory: with has_tables it needs none of it, and has a draw list elsewhere. */
    fxl_status (*init_renderer)(fxl_renderer *renderer, const fxl_scene *scene,
                                const fxl_config *config, void *memory, size_t memory_size);
    bool has_tables;
    const uint8_t *palette;   /* 256 x red, green, blue, for a display or a picture */
    const fxl_pose *start;    /* the scene's first pose */
    const fxl_pose *path;     /* a pose for each frame; null: there is no path */
    uint32_t path_count;      /* poses of the path; 0 without */
    uint32_t pieces_size;     /* bytes: of the memory of fxl_by_tree for pieces of what moves */
    fxl_q16_16 centre_x, centre_y; /* of an off-centre lens, in pixels */
    fxl_status (*set_centre)(fxl_renderer *renderer, fxl_q16_16 x, fxl_q16_16 y);
    fxl_q16_16 scale; /* of an orthographic lens, pixels a world unit */
    fxl_status (*set_orthographic)(fxl_renderer *renderer, fxl_q16_16 scale);
    const fxl_motion_set *motions;
    fxl_status (*begin_motions)(fxl_motion_player *player, const fxl_motion_set *set,
                                fxl_scene *scene, const fxl_motion_memory *memory);
    void (*play_motions)(const fxl_motion_player *player, uint32_t frame);
    uint32_t (*beam_memory_size)(const fxl_beam *beams, uint32_t beam_count);
    fxl_status (*attach_beams)(fxl_renderer *renderer, const fxl_beam_set *set, void *memory,
                               uint32_t size);
    const fxl_light_settings *light;
    fxl_status (*attach_light)(fxl_renderer *renderer, fxl_light *light,
                               const fxl_light_settings *settings);
    const fxl_surface_set *surfaces;
    const fxl_painter *painter; /* of the configuration's target */
    fxl_status (*attach_surfaces)(fxl_renderer *renderer, fxl_surfaces *surfaces,
                                  const fxl_surface_set *set, const fxl_painter *painter);
    fxl_status (*attach_lit)(fxl_renderer *renderer, fxl_lit_surfaces *lit);
    const fxl_billboard_set *billboards;
    const fxl_sprite_painter *sprite_painter; /* of the configuration's target */
    fxl_status (*attach_billboards)(fxl_renderer *renderer, fxl_billboards *billboards,
                                    const fxl_billboard_set *set,
                                    const fxl_sprite_painter *painter);
    const fxl_line_set *lines;
    fxl_status (*attach_lines)(fxl_renderer *renderer, fxl_lines *lines, const fxl_line_set *set);
    const fxl_horizon *horizon;
    fxl_status (*attach_horizon)(fxl_renderer *renderer, const fxl_horizon *horizon);
} fxl_setup_plan;

/* The steps of a set-up, in their order. */
enum {
    FXL_SETUP_NOTHING, /* the arguments were refused before the first step */
    FXL_SETUP_MOTIONS,
    FXL_SETUP_RENDERER,
    FXL_SETUP_CENTRE,
    FXL_SETUP_BEAMS,
    FXL_SETUP_LIGHT,
    FXL_SETUP_SURFACES,
    FXL_SETUP_LIT,
    FXL_SETUP_BILLBOARDS,
    FXL_SETUP_LINES,
    FXL_SETUP_HORIZON,
    FXL_SETUP_DONE
};

/* A scene that is set up, which the caller owns. The renderer keeps pointers into the record, so it
 * may not be moved. A program may call any function with the renderer, and attach other records in
 * the place of these. Other members are for reading only. */
typedef struct {
    fxl_renderer renderer;
    fxl_scene scene;   /* the plan's; what motions move is a copy in the memory */
    fxl_config config; /* the plan's, with order and memory */
    fxl_motion_player motion;
    fxl_light light;
    fxl_surfaces surfaces;
    fxl_lit_surfaces lit;
    fxl_billboards billboards;
    const fxl_setup_plan *plan; /* null: it was not set up */
    size_t memory_missing;      /* bytes, if fxl_setup_init answers FXL_E_CAPACITY */
    fxl_status status;          /* of the step */
    uint8_t step;               /* FXL_SETUP_...: the one that was refused, or the last */
} fxl_setup;

/* Sets a renderer up with all that a scene has: copies of the instances that its motions move, its
 * lens, order, target, beams, light, surfaces, billboards, lines and horizon. memory is one block of the caller's,
 * aligned to 8 bytes, to which the setup keeps pointers. NAME_SETUP_MEMORY(rows) of the exported
 * header is a size for it, in units of uint64_t. The block is divided: copies of what moves, beams,
 * the tree, a depth buffer of so many rows; all that is left is the renderer's, as
 * fxl_renderer_init divides it. rows is read where the target has a depth buffer, and is at least
 * the rows of the largest band that is not to be drawn in parts.
 * Requires tables as NAME_setup has them; none is changed.
 * FXL_E_ARGUMENT: a null pointer, also to the scene, the configuration, its target or the function
 * init_renderer.
 * FXL_E_ALIGNMENT: memory is not aligned.
 * FXL_E_ORDER: the scene was not checked: its draw_list_needed is 0.
 * FXL_E_RANGE: rows is not 1..config->height, or width or height is above FXL_SCREEN_MAX.
 * FXL_E_CAPACITY: memory_size is too small, and setup->memory_missing has the missing bytes.
 * With each of these statuses: nothing else is written.
 * Any other status is that of a step, which setup->step names: fxl_motion_begin, init_renderer,
 * fxl_renderer_set_centre, fxl_renderer_set_orthographic or an attach function refused the plan's tables. Then the setup cannot
 * draw. */
fxl_status fxl_setup_init(fxl_setup *setup, const fxl_setup_plan *plan, uint16_t rows, void *memory,
                          size_t memory_size);

/* Moves what the scene's motions move to where it is in a frame, and returns the eye's pose in it:
 * that of the path, which begins again after its last frame; without a path the scene's first pose.
 * Call it between two frames of the renderer (fxl_motion_play). Returns null if setup is null or
 * was not set up: then nothing is changed, and fxl_render refuses the pose. */
const fxl_pose *fxl_setup_frame(fxl_setup *setup, uint32_t frame);

/* What was wrong with a call of fxl_setup_init that was refused: an English sentence that names the
 * argument or the part of the plan, and its range. Null: the call was not refused, and no two parts
 * of the setup exclude each other; with has_tables that is not looked at. The arguments are those of
 * the call; none is changed. */
const char *fxl_setup_explain(const fxl_setup *setup, const fxl_setup_plan *plan, uint16_t rows,
                              const void *memory, size_t memory_size);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_setup_reasons[];

#ifdef __cplusplus
}
#endif

#endif
