/* SPDX-License-Identifier: MIT */
/* What the files of draw share beside submit.h. Internal. */
#ifndef FXL_RENDERER_H
#define FXL_RENDERER_H

#include "../raster/columns.h"
#include "../scene/lens.h"
#include "fixel/render.h"

/* Counts a call that is refused; answers its status. */
fxl_status fxl_refuse(fxl_workspace *workspace, fxl_status status);

/* Counts a change of the settings that workspaces of other cores are set up for. At the last number
 * it stays: fxl_frame_draw_with then takes no other workspace. */
#define FXL_COUNT_CHANGE(workspace) \
    ((workspace)->settings_number += (workspace)->settings_number < UINT32_MAX)

/* A workspace knows nothing of the frame yet. */
static inline void fxl_workspace_begin(fxl_workspace *workspace, bool counted)
{
    workspace->rest_counted = counted;
    workspace->screen.shade = 0;             /* a light may have been detached */
    workspace->sorted_instance = UINT16_MAX; /* none: instances in sight are fewer */
}

/* Whether a band's pixels are of the kind that the renderer draws. */
/* rgb565 3.2 */
static inline bool fxl_has_pixels_of(const fxl_renderer *renderer, const fxl_band *band)
{
    return fxl_kind_of_band(band).is_colour == fxl_kind_of_palette(renderer->palette).is_colour;
}

/* Gives a renderer that has another clipper, order or lens than before what its lens draws with. */
static inline void fxl_take_lens(fxl_renderer *renderer)
{
    const fxl_orthographic_code *code = fxl_orthographic_of(&renderer->frame.view.lens);
    if (code != NULL) {
        code->take(renderer);
    }
}

/* Draws a band in a workspace that was set up for the renderer, as fxl_frame_draw does. */
fxl_status fxl_draw_in_workspace(const fxl_renderer *renderer, fxl_workspace *workspace,
                                 const fxl_band *band);

/* fxl_frame_begin of a frame that is drawn in one band. It leaves the display list empty: to write
 * a polygon and read it once costs more instructions than to draw it at once. */
static inline fxl_status fxl_begin_one_band(fxl_renderer *renderer, const fxl_pose *pose)
{
    fxl_display_list *list = &renderer->frame.display_list;
    const uint32_t capacity = list->capacity;
    list->capacity = 0;
    const fxl_status status = fxl_frame_begin(renderer, pose);
    list->capacity = capacity;
    return status;
}

/* Sets whether faces are submitted near to far. A depth buffer then finds which face of a model is
 * seen, so they are not sorted. Without a list of them its memory is a part of the instances' order,
 * which keeps in it the rows that faces reach (extents.c). */
void fxl_set_direction(fxl_renderer *renderer, bool near_first);

/* fxl_target.choose, and what that of an order calls: gives a renderer the order, the target and
 * the memory of a configuration. Requires a target. FXL_E_ARGUMENT, FXL_E_ALIGNMENT,
 * FXL_E_CAPACITY: its order and target are untouched. */
fxl_status fxl_choose_with_memory(fxl_renderer *renderer, const fxl_config *config);

/* Whether a configuration has the palette that its target needs. FXL_E_ARGUMENT: a null palette.
 * FXL_E_ALIGNMENT: one at an odd address. */
static inline fxl_status fxl_check_palette(const fxl_config *config)
{
    if (!config->target->has_palette) {
        return FXL_OK;
    }
    if (config->palette == NULL) {
        return FXL_E_ARGUMENT;
    }
    return ((uintptr_t)config->palette & 1u) != 0 ? FXL_E_ALIGNMENT : FXL_OK;
}

/* The order that a configuration asks for. */
static inline const fxl_order *fxl_order_of(const fxl_config *config)
{
    return config->order != NULL ? config->order : &fxl_by_distance;
}

/* Entries of a scene's draw_list_needed that are for the instances, whatever instance_count becomes
 * in a world. The others are for the faces of one model. */
static inline uint32_t fxl_list_instances_most(const fxl_scene *scene)
{
    return scene->instance_capacity > 0 ? scene->instance_capacity : scene->instance_count;
}

/* Bytes, rounded up to what any table may begin at. */
static inline size_t fxl_aligned(size_t bytes)
{
    return (bytes + 7u) & ~(size_t)7u;
}

/* Entries of a vertex cache for the largest model of a scene, a power of two, or as many as fit so
 * many bytes. */
uint32_t fxl_cache_entries(const fxl_scene *scene, size_t bytes);

/* --- what goes together -------------------------------------------------------------------- */

/* place pixel-format: what cannot be drawn together */
/* Parts that a renderer has. conflict.c has the names. */
enum {
    FXL_HAS_TREE,       /* fxl_by_tree */
    FXL_HAS_MOVERS,     /* which the tree cuts */
    FXL_HAS_DEPTH,      /* the target has a depth buffer */
    FXL_HAS_STUDY,      /* the target is a span buffer, or scans bounding boxes */
    FXL_HAS_SURFACES,   /* these and what follows are attached */
    FXL_HAS_TEXELS_565, /* surfaces with textures of RGB565 */
    FXL_HAS_COLOURS,    /* surfaces with colours at corners */
    FXL_HAS_BILLBOARDS,
    FXL_HAS_BEAMS,
    FXL_HAS_OUTLINES,      /* and how they are drawn: */
    FXL_HAS_FLAT_OUTLINES, /* with their faces */
    FXL_HAS_DEEP_OUTLINES, /* over faces, by depth */
    FXL_HAS_ORTHOGRAPHIC,  /* the lens is orthographic */
    FXL_HAS_HORIZON,
    FXL_HAS_SPLIT,         /* surfaces, and beams that split their faces */
    FXL_HAS_OTHER_CLIPPER, /* than what the lens draws with */
    FXL_HAS_LINES,
    FXL_HAS_WORLD_CLIPPER, /* a clipper of the study that takes rounded points of the world */
    FXL_HAS_OTHER_PAINTER, /* surfaces or billboards of another target, or colours at corners by FXL_TEXTURES_OF */
    FXL_HAS_TARGET,        /* always */
    FXL_HAS_COUNT
};

/* Two things that do not go together. */
typedef struct {
    uint8_t first, second; /* FXL_HAS_... */
} fxl_conflict;

/* Returns the first conflict of the table that a renderer has; or null. */
const fxl_conflict *fxl_find_conflict(const fxl_renderer *renderer);

/* Returns a sentence that names the two things of that conflict, and the cure; or null: there is no
 * conflict, or the renderer has not been initialised. */
const char *fxl_conflict_sentence(const fxl_renderer *renderer);

#endif
