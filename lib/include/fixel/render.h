/* SPDX-License-Identifier: MIT */
/* The renderer (Listing 65.3, UpdateWorld).
 *
 * A first program calls fxl_renderer_init and fxl_render. The second level is beneath: the
 * caller's own tables of memory (fxl_renderer_init_with), frames drawn in bands
 * (fxl_frame_begin, fxl_frame_fill, fxl_frame_draw), another clipper, order or target
 * (fxl_renderer_set_clipper, fxl_renderer_choose). */
#ifndef FXL_RENDER_H
#define FXL_RENDER_H

#include "fixel/order.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- records -------------------------------------------------------------------------- */

/* What a first program chooses; fxl_config_default fills it in. */
typedef struct fxl_config {
    uint16_t width, height;   /* pixels, 1..FXL_SCREEN_MAX */
    fxl_angle fov;            /* horizontal field of view, FXL_FOV_MIN..FXL_FOV_MAX */
    fxl_q16_16 near_z, far_z; /* world units: what is nearer, or farther, is clipped away */
    fxl_q16_16 inset;         /* how far every plane of the frustum moves inward; 0 */
    uint8_t background;       /* palette index that fxl_render clears to */
    const fxl_target *target; /* what pixels are, and whether there is a depth buffer */
    const fxl_order *order;   /* null: fxl_by_distance */
    const uint16_t *palette;  /* of RGB565 targets: 256 colours; others do not take it */
    void *depth;              /* memory of the target's depth buffer, aligned to 8 bytes; or null */
    uint32_t depth_size;      /* bytes: FXL_DEPTH_BYTES of one row at least */
    void *tree;               /* of fxl_by_tree, aligned to 8 bytes; else null */
    uint32_t tree_size;       /* bytes: what the tree needs at least; the rest is for pieces */
} fxl_config;

/* Memory of the caller that a renderer works in for as long as it lives. */
typedef struct {
    fxl_draw_entry *draw_list;      /* at least scene->draw_list_needed entries */
    uint32_t draw_list_capacity;    /* entries */
    uint32_t *display_list;         /* may be null where display_list_capacity is 0 */
    uint32_t display_list_capacity; /* words; see FXL_DISPLAY_LIST_WORDS */
    fxl_cached_vertex *cache;       /* may be null where cache_capacity is 0 */
    uint32_t cache_capacity;        /* entries; the largest power of two of them is used */
} fxl_memory;

/* How far a traversal of the scene has come: so many instances of the frame's order are
 * done, and so many faces of the next instance. */
typedef struct {
    uint16_t instances, faces;
} fxl_resume_point;

FXL_STATIC_ASSERT(FXL_SCENE_INSTANCES_MAX <= 65535 && FXL_MODEL_FACES_MAX <= 65535,
                  "fxl_resume_point");

enum {
    FXL_FRAME_NONE = 0, /* no frame has begun */
    FXL_FRAME_BEGUN = 1,
    FXL_FRAME_MEASURED = 2, /* it has begun, and the order has the rows that each instance from
                               resume on reaches */
    FXL_FRAME_RELEASED = 3  /* it has begun, and is drawn from the display list alone */
};

/* What fxl_frame_begin works out, and drawing only reads. An instruction of Thumb reaches only the
 * first words of a record in 16 bits: the members that are used most come first. */
typedef struct {
    uint16_t visible_count;    /* instances in sight */
    uint8_t background;        /* palette index that fxl_render clears to */
    uint8_t state;             /* FXL_FRAME_... */
    fxl_draw_entry *draw_list; /* instances in sight, in the order of drawing; the caller's */
    fxl_display_list display_list;
    fxl_resume_point resume; /* the first face that the display list had no room for */
    fxl_view view;
} fxl_frame;

/* What is done with a face before it is clipped: it is split by light beams, or gets another
 * colour. Its maker puts it first in a record of its own, which the caller owns. Members are
 * internal. */
typedef struct fxl_shader fxl_shader;
struct fxl_shader {
    const fxl_shader *next; /* of the renderer; null: it is the last */
    uint32_t rank;          /* FXL_SHADER_...: they come in rising order, at most one of each */
    const struct fxl_shader_code *code;
};

typedef struct fxl_billboards fxl_billboards; /* fixel/billboards.h */

enum {
    FXL_SHADERS_MAX = 8 /* of a renderer: one of each rank */
};

/* The tables of a scene, and what they need of a workspace. Members are internal. */
typedef struct {
    const fxl_model *models;
    uint32_t tree_size, face_room; /* bytes; faces of one sorted model */
} fxl_workspace_room;

/* What the workspace of another core was set up for, and the frame that it last drew. Members are
 * internal. */
typedef struct {
    const fxl_scene *scene;
    const fxl_clipper *clipper;
    const fxl_order *order;
    const fxl_target *target;
    const fxl_billboards *billboards;
    const fxl_shader *shaders[FXL_SHADERS_MAX]; /* by rank; null: none */
    fxl_lens lens;
    uint32_t beam_size, clipper_size; /* bytes of memory that these need */
    fxl_workspace_room room;
    uint32_t frame; /* fxl_view.frame */
    fxl_camera camera;
} fxl_workspace_setup;

/* What drawing works in, and may change: each core that draws has its own. The renderer's own is
 * within it; fxl_workspace_init sets up others. */
typedef struct fxl_workspace {
    bool face_rows_known; /* face_list has the rows that the faces reach */
    bool rest_counted;    /* faces that are not in the display list have been counted */
    uint16_t dark;        /* the renderer's, while an RGB565 band is drawn */
    fxl_counters counters;
    uint32_t settings_number;  /* changes of the renderer's settings: at UINT32_MAX it stays */
    fxl_draw_entry *face_list; /* front faces of one sorted model, in the order of drawing */
    uint16_t sorted_instance;  /* whose they are, as fxl_resume_point counts instances */
    uint16_t front_count;      /* how many of its faces face the eye */
    uint16_t sorted_count;     /* how many are in the order: fewer, where some were dropped */
    bool draws_outlines;       /* kernels draw outlines with a depth into the band */
    void *target_memory;       /* the target's, of the caller's memory; or null */
    fxl_vertex_cache cache;
    uint32_t target_memory_size;
    fxl_screen_polygon screen;
    union { /* faces are sorted before any is clipped; a clipped polygon is then scanned */
        fxl_workspace_setup setup; /* of another core, while it does not draw */
        fxl_sort_work sort;
        fxl_clipper_work clip;
        fxl_scan scan;
        fxl_point points[FXL_FACE_VERTICES_MAX]; /* of a face, until beams have copied them */
    } work;
} fxl_workspace;

enum {
    FXL_FACES_SORTED = 0,
    FXL_FACES_AT_ONCE = 1, /* by number, without a list of them */
    FXL_FACES_LISTED = 2   /* by number */
};

/* A renderer, which the caller owns. On a core of 32 bits it takes 528 bytes and
 * 64 for each vertex of FXL_POLYGON_CAPACITY: 2576 where that is 32, 1296 where
 * it is 12. Several may live at once; none knows of another. Members are for
 * reading only. A renderer may be moved: no pointer in it leads into it. Two copies share the
 * caller's memory, so that only one of them may be used. */
struct fxl_renderer {
    const fxl_scene *scene;
    const fxl_clipper *clipper; /* fxl_clipper_view, or another */
    const fxl_order *order;     /* fxl_by_distance, or another */
    const fxl_target *target;   /* fxl_palette, or another */
    /* Clears a band: the target's, or that of a horizon. */
    void (*fill)(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour);
    const struct fxl_horizon *horizon; /* null: none */
    const fxl_shader *shader;   /* the first; null: faces are drawn as they are */
    fxl_billboards *billboards; /* null: instances show their faces */
    const uint16_t *palette;    /* of frames of 16 bits a pixel */
    void *order_memory;         /* the order's, of the caller's memory; or null */
    bool (*draw_display_list)(const fxl_traversal *traversal); /* null: all its records are flat */
    union {
        uint32_t instance_capacity; /* instances that the order has room for */
        uint32_t memory_missing;    /* bytes, if fxl_renderer_init answers FXL_E_CAPACITY */
    };
    /* Looks whether all that is attached goes together, before a frame begins. Null: it has. */
    fxl_status (*check)(fxl_renderer *renderer);
    bool near_first;   /* faces are submitted near to far, the reverse of the order of drawing */
    uint8_t by_number; /* FXL_FACES_...: whether faces of sorted models come by number */
    uint16_t dark;     /* RGB565: what light leaves at least */
    fxl_frame frame;
    fxl_workspace workspace;
};

/* The symbols of the functions that set a renderer up end in FXL_POLYGON_CAPACITY (config.h). */
#define FXL_WITH_CAPACITY(name, capacity) name##_for_polygons_of_##capacity
#define FXL_NAME_WITH(name, capacity)     FXL_WITH_CAPACITY(name, capacity)
#define fxl_renderer_init                 FXL_NAME_WITH(fxl_renderer_init, FXL_POLYGON_CAPACITY)
#define fxl_renderer_init_with            FXL_NAME_WITH(fxl_renderer_init_with, FXL_POLYGON_CAPACITY)
#define fxl_renderer_init_bare            FXL_NAME_WITH(fxl_renderer_init_bare, FXL_POLYGON_CAPACITY)

/* --- a first program -------------------------------------------------------------------- */

/* A configuration for a screen and a target: a field of view of 60 degrees, near at 1/4, far at 256
 * world units, no inset, background 0, by distance. Nothing is checked: fxl_renderer_init does. The
 * memory that the target needs, and its palette, must be set. */
fxl_config fxl_config_for(uint16_t width, uint16_t height, const fxl_target *target);

/* The same for a palette without a depth buffer. */
static inline fxl_config fxl_config_default(uint16_t width, uint16_t height)
{
    return fxl_config_for(width, height, &fxl_palette);
}

/* Ties a renderer to a scene (an exported one, or one that was checked by fxl_scene_open or
 * fxl_scene_check), a screen, and one block of memory of the caller's, aligned to 8 bytes; the
 * renderer keeps the pointer. The block is divided: first the order of drawing, which must fit;
 * of the rest a quarter at most, and no more than the largest model needs, keeps vertices that
 * faces share; what is left is the display list. The block changes no pixel. For fxl_render a
 * larger block takes fewer instructions until it holds all vertices of the largest model, because
 * fxl_render uses no display list. For a frame in several bands it takes fewer until the list holds
 * every polygon. fxl_frame_begin with one band as large as the screen takes up to 20 % more
 * instructions with a display list than without: use fxl_render, or fxl_renderer_init_with and no
 * list.
 * FXL_E_ARGUMENT: a null pointer; also a palette, a depth buffer or a tree that is needed.
 * FXL_E_ALIGNMENT: memory, depth or tree is not aligned to 8 bytes, or palette to 2.
 * FXL_E_RANGE: a member of config is out of range.
 * FXL_E_ORDER: the scene was not checked: its draw_list_needed is 0.
 * FXL_E_CAPACITY: memory_size, depth_size or tree_size is too small, or instance_count was raised
 * after the check.
 * What a refused call leaves depends on the argument that is wrong:
 *   palette, depth or tree    the renderer is initialised, but without an order and a target
 *   memory_size               only renderer->memory_missing is written: the missing bytes
 *   any other                 renderer untouched
 * In the first two cases the renderer cannot draw until it is initialised. */
fxl_status fxl_renderer_init(fxl_renderer *renderer, const fxl_scene *scene,
                             const fxl_config *config, void *memory, size_t memory_size);

/* Draws a whole frame as the eye sees it: clears pixels to the background, then draws. One
 * byte a pixel, or a uint16_t in RGB565, rows downward, row y at pixel y * stride. Requires memory
 * for height rows.
 * The display list is left empty, because one band is drawn in fewer instructions without it.
 * docs/accuracy.md, section 1, has the bound of each stage.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the eye is beyond FXL_COORDINATE_MAX; stride is less than the width of the screen;
 * or the centre or the scale of an instance's placement is out of range.
 * FXL_E_PLACEMENT: the orientation of an instance in sight is no rotation.
 * FXL_E_ALIGNMENT: an RGB565 target, and pixels at an odd address.
 * FXL_E_ORDER: the renderer has no clipper or no target, or placements without a placement_code. A
 * renderer that is all zeros has none of them.
 * FXL_E_CAPACITY: scene->instance_count has grown beyond draw_list's room.
 * FXL_E_COMBINATION: two things that the renderer has do not go together.
 * With each of these statuses: pixels untouched; counted in refused_calls. The frame before ends
 * where fxl_frame_begin ends it, and where only the address of pixels is wrong. */
fxl_status fxl_render(fxl_renderer *renderer, const fxl_pose *eye, void *pixels, uint16_t stride);

/* Finds two things that do not go together: of a renderer's order, its target and what is attached
 * to it (docs/extras/combinations.md). If there are such,
 * fxl_frame_begin answers FXL_E_COMBINATION.
 * Returns false if there are none: names untouched. Otherwise names[0] and names[1] are English,
 * and never null. */
bool fxl_renderer_conflict(const fxl_renderer *renderer, const char *names[2]);

/* What was wrong with a call that was refused: an English sentence that names the argument and its
 * range. Null: no argument is wrong. The arguments are those of fxl_renderer_init, of fxl_render
 * and of fxl_frame_draw; none is changed, and the sentence is constant. If a renderer has two things
 * that do not go together, the sentence of the first two functions names both, and the cure. A
 * program that does not call these functions does not link them. Requires that the call was the last
 * one with this renderer, or after fxl_renderer_init an attach function, and that the scene is still
 * the one that the call saw.
 * number: if the sentence is about the placement of an instance, *number becomes the number of that
 * instance, the first that is wrong. May be null. */
const char *fxl_renderer_explain(const fxl_renderer *renderer, const fxl_scene *scene,
                                 const fxl_config *config, const void *memory, size_t memory_size);
const char *fxl_render_explain(const fxl_renderer *renderer, const fxl_pose *eye,
                               const void *pixels, uint16_t stride, uint32_t *number);
const char *fxl_frame_explain(const fxl_renderer *renderer, const fxl_band *band);

/* --- the second level -------------------------------------------------------------------- */

/* Initialises a renderer with a lens made by its function, and with tables of the caller's own.
 * Zeroes the counters. A display list that holds every polygon of a frame lets bands be drawn
 * without reading the scene. If the list has no room for some polygons, each band computes those of
 * them that lie in its rows. Without a list every band traverses the scene, which is best where a
 * frame is one band. The pixels are the same.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ALIGNMENT: draw_list or display_list is not aligned to 4 bytes, or cache to 8.
 * FXL_E_RANGE: a lens that is not valid.
 * FXL_E_ORDER: the scene was not checked: its draw_list_needed is 0.
 * FXL_E_CAPACITY: draw_list_capacity is too small, or instance_count was raised after the check.
 * With each of these statuses: renderer untouched. */
fxl_status fxl_renderer_init_with(fxl_renderer *renderer, const fxl_scene *scene,
                                  const fxl_lens *lens, const fxl_memory *memory);

/* The same, with neither a clipper nor a target: where a program sets both itself, the default ones
 * are not linked. fxl_frame_begin answers FXL_E_ORDER until both are set. */
fxl_status fxl_renderer_init_bare(fxl_renderer *renderer, const fxl_scene *scene,
                                  const fxl_lens *lens, const fxl_memory *memory);

/* Gives a renderer that fxl_renderer_init_with or fxl_renderer_init_bare has initialised the order
 * and the target of a configuration, with its palette, depth and tree. Other members are not read.
 * Then a frame must begin anew, and workspaces of other cores must be initialised again.
 * FXL_E_ARGUMENT: a null pointer: also a target, a palette or memory that is needed.
 * FXL_E_ORDER: the renderer was never initialised, or something is attached to it.
 * FXL_E_ALIGNMENT: memory that is needed is not aligned to 8 bytes, or the palette to 2.
 * FXL_E_CAPACITY: depth_size or tree_size is too small.
 * With each of these statuses: renderer untouched but for refused_calls. */
fxl_status fxl_renderer_choose(fxl_renderer *renderer, const fxl_config *config);

/* Sets the clipper and its workspace: at least clipper->workspace_size bytes of the caller's,
 * aligned to 8; the renderer keeps the pointer. A clipper that needs none may be given size 0, or
 * an fxl_clip_stats to count in. Then a frame must begin anew.
 * FXL_E_ARGUMENT: a null pointer, or a clipper of zeros.
 * FXL_E_ALIGNMENT: workspace is not aligned to 8 bytes.
 * FXL_E_ORDER: the renderer was never initialised: it is all zeros.
 * FXL_E_CAPACITY: workspace_size is too small.
 * With each of these statuses: renderer untouched but for refused_calls. */
fxl_status fxl_renderer_set_clipper(fxl_renderer *renderer, const fxl_clipper *clipper,
                                    void *workspace, uint32_t workspace_size);

/* Moves the centre of the lens (fxl_lens_set_centre), as a window needs in front of a viewer who
 * moves. Then a frame must begin anew.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the renderer was never initialised.
 * FXL_E_RANGE: the lens has an inset, or the centre is farther from the middle of the screen than
 * fxl_lens_set_centre allows.
 * With each of these statuses: renderer untouched but for refused_calls. */
fxl_status fxl_renderer_set_centre(fxl_renderer *renderer, fxl_q16_16 x, fxl_q16_16 y);

/* Makes the lens orthographic (fxl_lens_orthographic), with so many pixels a world unit in 16.16,
 * on the same screen, between the same near and far, without an inset. Then a frame must begin anew,
 * and workspaces of other cores must be initialised again. The lens of this renderer stays
 * orthographic; its centre becomes the middle of the screen.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the renderer was never initialised, or something is attached to it.
 * FXL_E_RANGE: scale is not in FXL_ORTHOGRAPHIC_SCALE_MIN..FXL_ORTHOGRAPHIC_SCALE_MAX.
 * With each of these statuses: renderer untouched but for refused_calls. */
fxl_status fxl_renderer_set_orthographic(fxl_renderer *renderer, fxl_q16_16 scale);

/* Begins a frame: camera; cull and sort the instances; then every face is transformed,
 * clipped, projected and appended to the display list, as far as that has room. Zeroes the
 * counters except refused_calls, and counts the faces that it came to. Then draw the frame
 * whole or in bands. scene->instance_count may change between the last band of a frame, or
 * fxl_frame_release_scene, and fxl_frame_begin, as far as draw_list has room; so may the
 * placements, and the centres of instances that have one. They are checked in constant time each:
 * the scales and centres of all, and the orientations of the instances in sight. fxl_scene_check
 * checks all orientations. Requires that a scene with placements keeps its placement_code, and that
 * a scene gets no placements without one.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: no clipper, no target, or placements without a placement_code.
 * FXL_E_RANGE: the pose is beyond FXL_COORDINATE_MAX, as is the eye that an orthographic lens moves
 * to the middle of the screen (fxl_lens_set_centre), or the centre or the scale of an instance's
 * placement is out of range.
 * FXL_E_PLACEMENT: the orientation of an instance in sight is no rotation.
 * FXL_E_CAPACITY: scene->instance_count has grown beyond draw_list's room.
 * FXL_E_COMBINATION: two things that the renderer has do not go together (fxl_renderer_conflict).
 * With each of these statuses: counted in refused_calls.
 * A refused call leaves the frame before current if the scene has no placements. If it has
 * placements, the frame before ends as by fxl_frame_end, because drawing would read placements and
 * centres that are not checked. */
fxl_status fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose);

/* Sets every pixel of a band to a colour of the palette, in the format that the renderer draws.
 * What lies between width and stride is untouched. If pixels or palette of RGB565 are at an odd address, it
 * sets none: fxl_frame_draw then answers FXL_E_ALIGNMENT. Exact.
 * Requires a renderer with a target and a band that fxl_frame_draw takes, neither of them null. */
void fxl_frame_fill(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour);

/* Draws the frame's polygons over a band that the caller has cleared
 * (fxl_frame_fill): those of the display list that reach it, then the rest of the scene
 * where the list was full. The pixels are the same whatever bands a frame is cut
 * into. Faces that the list had no room for are counted by the first band alone.
 * docs/accuracy.md, section 1, has the bound of each stage.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: no frame begun; or a band whose pixels are not the target's: without a palette where
 * that is RGB565, or with one where it is not.
 * FXL_E_RANGE: a band that is not of this screen.
 * FXL_E_ALIGNMENT: an RGB565 target, and pixels or a palette at an odd address.
 * With each of these statuses: band untouched; counted in refused_calls. */
fxl_status fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band);

/* Releases the scene before the frame is drawn: from here on fxl_frame_draw reads the display list
 * and nothing of the scene, whatever core draws and whatever is attached. The scene's
 * instances and placements may then change, and a world (fixel/world.h) may. So one core draws a
 * frame while another core changes the scene and begins the next frame in a second renderer.
 * Textures, sprites, palettes and ramps are still read, and must stay. Until the next frame begins,
 * fxl_pick_face answers FXL_E_ORDER. Call it while no core draws a band of the frame. A second call
 * changes nothing.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: no frame begun.
 * FXL_E_CAPACITY: the display list had no room for all polygons of the frame.
 * With each of these statuses: the frame still reads the scene; counted in refused_calls. */
fxl_status fxl_frame_release_scene(fxl_renderer *renderer);

/* Ends the frame: its last band is drawn, on every core. fxl_frame_draw then answers FXL_E_ORDER
 * until a frame begins. If no frame has begun, it changes nothing. A world (fixel/world.h) that the
 * renderer is attached to may then change again; no other program needs this call, nor does one
 * that calls fxl_frame_release_scene.
 * FXL_E_ARGUMENT: a null pointer; nothing is changed. */
fxl_status fxl_frame_end(fxl_renderer *renderer);

/* --- several cores ------------------------------------------------------------------------ */

/* Returns the bytes of memory that another workspace needs at least, for the renderer's scene,
 * clipper, order, target and beams. Returns 0 if the renderer is null, or lacks a clipper, an order
 * or a target. */
size_t fxl_workspace_size(const fxl_renderer *renderer);

/* Sets up a workspace beside the renderer's own, in one block of the caller's memory, aligned to 8
 * bytes; the workspace keeps the pointer. Bytes beyond fxl_workspace_size become a vertex cache and
 * memory for the target. The workspace must be set up anew after the renderer was initialised, or got
 * another clipper, order, target, centre of the lens or attachment. The same record attached again
 * is no other one, unless it is of outlines or beams.
 * FXL_E_ARGUMENT: a null pointer; also the renderer's own workspace.
 * FXL_E_ALIGNMENT: memory is not aligned to 8 bytes.
 * FXL_E_ORDER: the renderer lacks a clipper, an order or a target.
 * FXL_E_CAPACITY: too little memory.
 * With each of these statuses: workspace untouched. */
fxl_status fxl_workspace_init(fxl_workspace *workspace, const fxl_renderer *renderer, void *memory,
                              size_t memory_size);

/* fxl_frame_draw in another workspace. It changes neither the renderer nor the frame, so each core
 * may draw a band of its own at the same time, each in its own workspace, with any clipper, order
 * and target and all that is attached, whether the display list holds the whole frame or not.
 * Requires a workspace that fxl_workspace_init has set up, or one of zeros. The faces of a frame are
 * counted in the renderer's own workspace; another's counters have split_bands and refused_calls.
 * If a band reads the scene, another workspace sorts the faces of a model anew.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: no frame begun; a band whose pixels are not the target's; the workspace was set up
 * for another scene, lens, clipper, order, target or attachment, or never: it is all zeros. Also
 * where the settings have changed 2^32 - 2 times since fxl_renderer_init.
 * FXL_E_RANGE: a band that is not of this screen.
 * FXL_E_ALIGNMENT: an RGB565 target, and pixels or a palette at an odd address.
 * With each of these statuses: band untouched; counted in refused_calls of the workspace. */
fxl_status fxl_frame_draw_with(const fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_band *band);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_render_reasons[];

#ifdef __cplusplus
}
#endif

#endif
