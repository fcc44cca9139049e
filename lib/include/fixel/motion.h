/* SPDX-License-Identifier: MIT */
/* Plays the motions of a scene: from the number of a frame to centres and placements in the
 * caller's memory. docs/extras/motion.md. */
#ifndef FXL_MOTION_H
#define FXL_MOTION_H

#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Memory for what moves: a record for each instance of the scene, and one for each placement. The
 * caller owns it. */
typedef struct {
    fxl_instance *instances;
    uint32_t instance_capacity; /* at least the scene's instance_count */
    fxl_placement *placements;
    uint32_t placement_capacity; /* at least instance_count - first_turned */
} fxl_motion_memory;

/* Set by fxl_motion_begin; for reading only. */
typedef struct {
    fxl_motion_set set;
    fxl_instance *instances;   /* of the motions, in turn: set.motion_count */
    fxl_placement *placements; /* of the same */
} fxl_motion_player;

/* Copies the scene's instances and placements to the memory, points *scene to the copies, and plays
 * frame 0. Call it before fxl_renderer_init takes the scene.
 * Requires a scene that was checked, and a set that fxl_motion_check or tools/scene.py checked with
 * it. Set and memory must outlive the player and the scene.
 * The motions move the instances of *scene. A world (fixel/world.h) has copies of the instances,
 * which the program moves (docs/extras/motion.md, section 5).
 * FXL_E_ARGUMENT: a null pointer, also in the memory; a scene without placements; a set that lacks
 * a table that it counts.
 * FXL_E_ORDER: the scene is that of a world.
 * FXL_E_ALIGNMENT: a table of the memory or of the set is not aligned to 4 bytes.
 * FXL_E_COUNT: more motions than placements.
 * FXL_E_CAPACITY: too little memory.
 * With each of these statuses: *player, *scene and the memory are untouched. */
fxl_status fxl_motion_begin(fxl_motion_player *player, const fxl_motion_set *set, fxl_scene *scene,
                            const fxl_motion_memory *memory);

/* Writes the centres and placements of a frame. Frames may be played in any order: a frame depends
 * on its number alone. The time is linear in the number of motions, times the logarithm of the keys
 * of one. Call it between two frames of the renderer, not while bands of one are drawn, unless
 * fxl_frame_release_scene released that frame.
 * Requires a player that fxl_motion_begin set.
 * Error: that of fxl_orientation_from_angles, fxl_orientation_from_axis and fxl_placement_attach,
 * and of a centre 0.5 unit of 1/65536 for the keys and 0.76 for the circle. */
void fxl_motion_play(const fxl_motion_player *player, uint32_t frame);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_motion_reasons[];

#ifdef __cplusplus
}
#endif

#endif
