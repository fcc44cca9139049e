/* SPDX-License-Identifier: MIT */
/* The traversal of a scene, and what becomes of the faces that it submits. Internal. */
#ifndef FXL_SUBMIT_H
#define FXL_SUBMIT_H

#include "fixel/render.h"
#include "../scene/placement_code.h"
#include "../view/clusters.h"
#include "../view/cull.h"

/* Whether faces are walked (fxl_face_walk) where the shader takes them at once. A core without long products
 * would gain 1.7 % by 3 KB more, and a host draws no outlines at once. */
#define FXL_WALKS_FACES (!FXL_IS_COMPACT && FXL_HAS_LONG_PRODUCT && !FXL_HAS_LONG_DIVIDER)

/* Whether those of sorted models are walked in any case, since a kernel finds the next one. In C the loop
 * of fxl_submit_convex takes fewer instructions: on RV32IMC a smooth head 5 % fewer. */
#define FXL_WALKS_SORTED (FXL_KERNELS_ARMV7M && FXL_WALKS_FACES)

/* What becomes of a face of which the clipper gives one polygon at most. */
typedef enum {
    FXL_SUBMIT_ANY,     /* nothing is known: the clipper may give several, any target draws */
    FXL_SUBMIT_MEASURE, /* the same; it is only asked which rows it reaches */
    FXL_SUBMIT_APPEND   /* it is appended to the display list */
} fxl_submit_mode;

/* A traversal fills the display list (fxl_frame_begin), measures what the list had no room for, or
 * draws it into a band (fxl_frame_draw). */
struct fxl_traversal {
    const fxl_renderer *renderer;
    const fxl_clipper *clipper; /* the renderer's */
    fxl_workspace *workspace;
    fxl_display_list *display_list; /* the frame's, to be filled; null: a band is drawn */
    union {
        const fxl_band *band; /* to be drawn into, where there is no display list */
        fxl_rows *reached;    /* FXL_SUBMIT_MEASURE: grows by the rows that a face reaches */
    };
    fxl_resume_point *resume; /* where to go on; kept where the traversal is stopped */
    fxl_counters *counters;
    fxl_submit_mode mode;
    bool near_first; /* faces come near to far: as of fxl_draw_band_turned */
    bool draws_one;  /* a band is drawn, by a clipper that gives one polygon of a face at most */
    /* FXL_SUBMIT_ANY: draws a face at once, over what is there. Null: it goes the way of all. */
    bool (*draw)(fxl_workspace *workspace, const fxl_screen_polygon *polygon, const fxl_band *band);
};

/* One that fills no list and draws into no band yet, and counts in the workspace. */
static inline fxl_traversal fxl_traversal_of(const fxl_renderer *renderer, fxl_workspace *workspace,
                                             fxl_resume_point *resume)
{
    const fxl_traversal traversal = {.renderer = renderer,
                                     .clipper = renderer->clipper,
                                     .workspace = workspace,
                                     .display_list = NULL,
                                     .band = NULL,
                                     .resume = resume,
                                     .counters = &workspace->counters,
                                     .mode = FXL_SUBMIT_ANY,
                                     .near_first = renderer->near_first,
                                     .draws_one = false,
                                     .draw = NULL};
    return traversal;
}

/* transform -> clip -> project -> display list or band, for a face that faces the eye; by
 * model_view->shader before, where there is one. Counts it in everything but `in`. False where
 * there is no room, in the list or in the target's workspace: the face is then not counted, and
 * the list is as it was. */
bool fxl_submit_face(const fxl_model_view *model_view, const fxl_face *face,
                     const fxl_traversal *traversal);

/* The same without a shader: for what the shaders have made of a face. */
bool fxl_submit_shaded_face(const fxl_model_view *model_view, const fxl_face *face,
                            const fxl_traversal *traversal);

/* Whether faces of a sorted model that lie outside are taken out before the sort. They have to be
 * counted as the clipper and the beams would count them. It pays where faces share vertices, since
 * those of the others are looked at twice. The answer is the same for every workspace: a frame's
 * resume point is a place in the order. */
bool fxl_drops_outside(const fxl_traversal *traversal, const fxl_model_view *model_view,
                       const fxl_model *model);

/* Unless the workspace has done so for this instance: puts the faces of a sorted model that face
 * the eye into workspace->face_list, in the order of drawing, and sets the workspace's two counts
 * of them. Faces that the clipper would find outside may be left out of the order. */
void fxl_list_model(const fxl_traversal *traversal, const fxl_model_view *model_view,
                    const fxl_model *model);

#if FXL_WALKS_FACES

/* fxl_submit_convex (lib/draw/submit_instance.h) of an instance whose faces are walked. next: null is
 * fxl_next_front_face. */
bool fxl_submit_walk(const fxl_traversal *traversal, const fxl_model_view *model_view,
                     const fxl_model *model, fxl_next_face *next);

#endif

/* The faces of an instance that are left, from traversal->resume->faces on: all of them counted, by
 * number or by distance, in the order of the method. False where the traversal was stopped. */
bool fxl_submit_instance(const fxl_traversal *traversal, const fxl_draw_entry *entry);

/* fxl_submit_instance of an instance that may be turned. */
static inline bool fxl_submit_any_instance(const fxl_traversal *traversal,
                                           const fxl_draw_entry *entry)
{
    const fxl_placement_code *turned =
        fxl_placement_code_of(traversal->renderer->scene, entry->index);
    return turned != NULL ? turned->submit_instance(traversal, entry, NULL)
                          : fxl_submit_instance(traversal, entry);
}

/* fxl_order.submit of fxl_by_distance: the instances in sight by layer and distance. */
bool fxl_submit_by_distance(const fxl_traversal *traversal);

/* An instance of the order in the view of this frame, with the first shader that reaches it.
 * Answers the instance. */
const fxl_instance *fxl_view_instance(const fxl_traversal *traversal, const fxl_draw_entry *entry,
                                      fxl_model_view *model_view);

/* The display list, then the rest of the scene, into a band of a frame: fxl_target.draw_band of a
 * target whose `flat` always returns true. FXL_E_CAPACITY: the target's memory is full; what was
 * counted must then be forgotten. */
fxl_status fxl_draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                         const fxl_band *band);

/* The same; if it is turned, of all faces of the scene, and in the other direction than the frame's. */
fxl_status fxl_draw_band_turned(const fxl_renderer *renderer, fxl_workspace *workspace,
                                const fxl_band *band, bool is_turned);

/* What draws models with clusters. */
struct fxl_cluster_code {
    /* What fxl_list_model does before the sort, for a model with clusters. Clusters outside the
     * frustum, and clusters turned away from the eye, are left out with all their faces. */
    void (*find_faces)(const fxl_traversal *traversal, const fxl_model_view *model_view,
                       const fxl_model *model);
    /* The same for a turned instance, by its tests. */
    void (*find_faces_by)(const fxl_traversal *traversal, const fxl_model_view *model_view,
                          const fxl_model *model, const fxl_cluster_tests *tests);
    /* fxl_cluster_is_surely_turned_away, for such tests. */
    fxl_cluster_cone *is_turned_away;
    /* fxl_still_cluster_planes, for tests of an orthographic lens. */
    fxl_cluster_planes *planes;
};

/* --- a face in several pieces ---------------------------------------------- */

/* What became of a face's polygons, piece by piece: bits, 1 << fxl_clip_result and these. */
typedef uint32_t fxl_outcome;
#define FXL_OUTCOME_SPILLED ((fxl_outcome)1 << 30) /* one was drawn that is not in the list */
#define FXL_OUTCOME_FULL    ((fxl_outcome)1 << 31) /* no room: all else must be forgotten */

/* transform -> clip -> project: a face's first polygon, into workspace->screen where one is left.
 */
static inline fxl_clip_result fxl_first_polygon(const fxl_model_view *model_view,
                                                const fxl_face *face,
                                                const fxl_traversal *traversal)
{
    fxl_workspace *workspace = traversal->workspace;
    return traversal->clipper->clip(model_view, face, &workspace->work.clip, &workspace->screen);
}

/* The next one, of a clipper that has `next`. */
static inline fxl_clip_result fxl_next_polygon(const fxl_model_view *model_view,
                                               const fxl_traversal *traversal)
{
    fxl_workspace *workspace = traversal->workspace;
    return traversal->clipper->next(model_view, &workspace->work.clip, &workspace->screen);
}

/* transform -> clip -> project -> display list or band, for every polygon that a face gives. */
fxl_outcome fxl_submit_polygons(const fxl_model_view *model_view, const fxl_face *face,
                                const fxl_traversal *traversal);

/* Counts a face in everything but `in`: refused where one of its polygons was, else drawn where
 * one was. False where there was no room: then nothing is counted, and the display list is cut
 * back to `used` words. */
bool fxl_count_outcome(const fxl_traversal *traversal, fxl_outcome outcome, uint32_t used);

/* The same of a face that is drawn at once, of which `cut` is what the clipper answered. has_rows: a
 * row of the screen has some of it. */
static inline void fxl_count_drawn(fxl_counters *counters, fxl_clip_result cut, bool has_rows)
{
    if (has_rows) {
        counters->spilled += 1;
    }
    counters->drawn += 1;
    if (cut == FXL_CLIP_CUT) {
        counters->clipped += 1;
    }
}

/* A face that is submitted piece by piece. It is counted once, and is in the display list whole
 * or not at all. The caller owns it. */
typedef struct fxl_pieces fxl_pieces;

/* Takes a piece that beams made, in place of the shader after them: that it is dark or lit. False
 * where there is no room. */
typedef bool fxl_piece_taker(fxl_pieces *pieces, const fxl_point *points, uint32_t count,
                             bool is_lit);

struct fxl_pieces {
    const fxl_traversal *traversal;
    const fxl_instance *instance; /* whose face it is, and the face: of shaded pieces */
    const fxl_face *face;
    fxl_piece_taker *take; /* of a shader that has beams split its faces, and its data; else null */
    const void *taker;
    fxl_planes planes; /* that pieces may cross; begin sets all, narrowing it saves time */
    fxl_outcome outcome;
    uint32_t used; /* words of the display list before the face */
};

void fxl_pieces_begin(fxl_pieces *pieces, const fxl_traversal *traversal);

/* A piece: a convex polygon of the world, 3 <= count <= FXL_POLYGON_CAPACITY vertices, each
 * within FXL_COORDINATE_MAX. A piece that the clipper has no room for is refused.
 * False where there is no room: no more pieces need be submitted. */
bool fxl_submit_piece(fxl_pieces *pieces, const fxl_point *points, uint32_t count, uint8_t colour);

/* Counts the face: drawn where a piece was, refused where one was refused, else outside or
 * degenerate; clipped where the clipper cut a piece. False where there was no room: then
 * nothing is counted, and the display list is as it was. */
bool fxl_pieces_end(fxl_pieces *pieces);

/* --- shaders ---------------------------------------------------------------- */

/* The ranks: a shader gets the face that those of a lower rank made. */
enum {
    FXL_SHADER_SURFACES, /* faces with surfaces, which go no further */
    FXL_SHADER_LIT,      /* takes no face: surfaces are lit at their corners */
    FXL_SHADER_OUTLINES, /* with a depth buffer it may fill faces, and draws over them (fxl_overdraw);
                            without one it takes no face: it is drawn with outlines */
    FXL_SHADER_LINES,    /* takes no face: lines are drawn beside it (fxl_overdraw) */
    FXL_SHADER_RECOLOUR, /* an instance's own colours */
    FXL_SHADER_LIGHT,    /* light and fog */
    FXL_SHADER_BEAMS,
    FXL_SHADER_TARGET /* that of the target: faces and pieces get a depth, and go no further */
};

/* What a shader does. It either splits faces or colours them. */
typedef struct fxl_shader_code {
    /* Whether it may change the faces of an instance. */
    bool (*reaches)(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance);
    /* Takes the faces of an instance that it reaches: fxl_submit_split_face,
     * fxl_submit_coloured_face, or another. */
    bool (*face)(const fxl_model_view *model_view, const fxl_face *face,
                 const fxl_traversal *traversal, const fxl_shader *shader);
    /* Splits a polygon of the world, a piece or all of a face, and gives what it makes of it
     * to fxl_submit_piece. False where that answers false. Null: it colours. */
    bool (*split)(const fxl_shader *shader, fxl_pieces *pieces, const fxl_face *face,
                  const fxl_point *points, uint32_t count);
    /* The colour of a face of the model that would have `colour`. It may set the shade of
     * traversal->workspace->screen, which every polygon of the face has then. Null: it splits. */
    uint8_t (*colour)(const fxl_shader *shader, const fxl_traversal *traversal,
                      const fxl_instance *instance, const fxl_face *face, uint8_t colour);
    /* fxl_rounded_faces, if it takes a face of a turned instance only as a polygon of the world,
     * whose points are rounded; else null. */
    const struct fxl_shader_code *in_world;
    /* Whether it splits a face of the model. Null: it splits each. */
    bool (*takes)(const fxl_shader *shader, const fxl_renderer *renderer, const fxl_face *face);
#if FXL_WALKS_FACES
    /* Takes all faces of a walk, or returns false: then it has taken none. Null: it never takes them. */
    bool (*faces)(const fxl_model_view *model_view, const fxl_traversal *traversal,
                  fxl_face_walk *walk);
    /* fxl_submit_walk, if it is the last shader of a target with a depth buffer. Flat programs do
     * not link it. */
    bool (*walk)(const fxl_traversal *traversal, const fxl_model_view *model_view,
                 const fxl_model *model, fxl_next_face *next);
#endif
} fxl_shader_code;

/* The first of a list of shaders that reaches an instance; or null. */
static inline const fxl_shader *
fxl_shader_reaching(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    while (shader != NULL && !shader->code->reaches(shader, scene, instance)) {
        shader = shader->next;
    }
    return shader;
}

/* Puts a shader among those of a renderer, in place of the one of its rank; null: only takes that
 * one out. The frame must begin anew. */
void fxl_renderer_set_shader(fxl_renderer *renderer, uint32_t rank, fxl_shader *shader);

/* The same for what an attach function was given: whether all goes together is looked at before the
 * next frame begins. A shader of the code fxl_mark takes no face. */
void fxl_renderer_attach(fxl_renderer *renderer, uint32_t rank, fxl_shader *shader);
extern const fxl_shader_code fxl_mark;

/* The shader of a rank that a renderer has; or null. */
static inline const fxl_shader *fxl_renderer_shader(const fxl_renderer *renderer, uint32_t rank)
{
    const fxl_shader *shader = renderer->shader;
    while (shader != NULL && shader->rank != rank) {
        shader = shader->next;
    }
    return shader;
}

/* The first shader from one on that draws over the faces of a target with a depth buffer, an
 * fxl_overdraw; or null. A pick has none: its own shader stands before all others. */
static inline const fxl_shader *fxl_overdraw_from(const fxl_shader *shader)
{
    while (shader != NULL && shader->rank < FXL_SHADER_OUTLINES) {
        shader = shader->next;
    }
    return shader != NULL && shader->rank <= FXL_SHADER_LINES ? shader : NULL;
}

/* Whether something is attached to a renderer. */
static inline bool fxl_has_attachments(const fxl_renderer *renderer)
{
    return renderer->billboards != NULL ||
           (renderer->shader != NULL && renderer->shader->rank != FXL_SHADER_TARGET);
}

/* fxl_renderer.check: finds two things that do not go together, and lets what is attached know of
 * the rest. */
fxl_status fxl_check_combination(fxl_renderer *renderer);

/* A piece of a face of the model, by all shaders that reach the instance. The normal is the face's
 * in the world: it decides whether the piece is turned to a light. */
void fxl_submit_shaded_piece(fxl_pieces *pieces, const fxl_instance *instance,
                             const fxl_face *whole, const fxl_direction *normal,
                             const fxl_point *points, uint32_t count);

/* The same by a shader, if it reaches the instance, and those after it. *piece has the colour, the
 * normal and the count of points. False where there is no room. */
bool fxl_submit_piece_by(fxl_pieces *pieces, const fxl_shader *shader, const fxl_face *piece,
                         const fxl_point *points);

/* A piece that a shader made of a face, to the shader after it, or as fxl_submit_piece. The normal
 * of the face is the whole's in the world. */
bool fxl_submit_split_piece(const fxl_shader *by, fxl_pieces *pieces, const fxl_face *face,
                            const fxl_point *points, uint32_t count, uint8_t colour);

/* fxl_shader_code.face, of beams, or of a shader that has beams split its faces: the face's polygon
 * of the world, split, counted once. */
bool fxl_submit_split_face(const fxl_model_view *model_view, const fxl_face *face,
                           const fxl_traversal *traversal, const fxl_shader *shader);

/* fxl_shader_code.face: the face in another colour, to the next shader or to the clipper. */
bool fxl_submit_coloured_face(const fxl_model_view *model_view, const fxl_face *face,
                              const fxl_traversal *traversal, const fxl_shader *shader);

/* --- the rows that faces reach ------------------------------------------------------------- */

/* Which rows of the screen the instances reach that are not in the display list, and which rows
 * their faces reach. They are found once, when a frame begins, and kept where the sort has left
 * memory that nobody needs any more: in the entries of the order, and behind the last of them. A
 * band then passes over what does not reach it. What is left of that memory becomes a cache of
 * vertices, if the caller gave none. A library for size keeps the rows of instances and those of a
 * sorted model's faces, not those of other faces. */

/* Goes on where `filling`, the traversal that filled the display list, had no more room: measures
 * the rows, and counts the faces. Requires that the traversal was fxl_submit_by_distance's. */
void fxl_extents_measure(const fxl_traversal *filling, fxl_frame *frame);

/* Takes back the memory of the order that a frame before has lent to the workspace as a cache of
 * vertices. */
void fxl_extents_take_back(const fxl_renderer *renderer, fxl_workspace *workspace);

/* fxl_submit_by_distance into a band, of a frame whose rows were measured. It counts nothing that
 * the measuring has counted: traversal->counters are thrown away. */
bool fxl_extents_submit(const fxl_traversal *traversal);

#endif
