/* SPDX-License-Identifier: MIT */
/* What the harnesses consist of: a checked scene drawn every way there is, and compared; and single
 * stages, fed with any record that their contracts allow, and with some that they must refuse. */
#ifndef PARTS_H
#define PARTS_H

#include "input.h"

enum {
    DRAW_BACKGROUND = 0x11
};

/* place pixel-format: the list of targets */
/* The targets that a scene is drawn into. */
enum {
    DRAW_TARGETS = 5
};
extern const fxl_target *const draw_targets[DRAW_TARGETS];

/* Memory that ends where it should: so many bytes of 0x5A. Free it. */
void *draw_memory(size_t size);

/* Rows of a screen without bytes between them. */
fxl_band draw_band(const fxl_lens *lens, void *pixels, uint32_t first_row, uint32_t rows);

/* The first rows of the frame that a renderer has begun, over the background, so many at a time. */
void draw_bands(fxl_renderer *renderer, uint8_t *pixels, uint32_t rows, uint32_t step);

/* The boxes that changed of the frame that a renderer has begun, over the background, into a picture of the
 * whole screen. */
void draw_changed_boxes(fxl_renderer *renderer, const fxl_changed *changed, uint8_t *picture,
                        uint8_t background);

/* The faces that a frame looked at are all accounted for. */
bool draw_accounted(const fxl_counters *counters);

/* Attaches the beams of the renderer's scene, if it has some: their memory, to be freed, or null. */
void *draw_beams(fxl_renderer *renderer);

/* How many clippers there are. */
uint32_t draw_clipper_count(void);

/* Which clipper, and which rows of the screen are looked at. */
typedef struct {
    uint32_t clipper; /* 0 .. draw_clipper_count() - 1 */
    uint16_t first_row, rows;
} draw_choice;

/* Draws the rows in one band without a list and in several with a list of any
 * size, with bytes between width and stride, and once more with no object left
 * out by its sphere and without keys, and front to back by a span buffer, and demands: equal
 * pixels, nothing written outside, every face accounted for, outlines within the screen. Cuts,
 * stride and the list's size come from in. */
void draw_scene(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                const draw_choice *choice, fuzz_input *in);

/* Opens the surfaces of an image; draws some rows with them, if nothing is wrong. */
void open_billboards(const fxl_scene_image *opened, const fxl_pose *pose);
void open_surfaces(const fxl_scene_image *opened, const fxl_pose *pose);
void open_horizon(const fxl_scene_image *opened, const fxl_pose *pose);

/* What is attached beside a set of surfaces: the light has settings. */
typedef struct {
    fxl_surfaces surfaces;
    fxl_lit_surfaces lit;
    fxl_light light;
} draw_parts;

/* Attaches the light and a set of surfaces, whose corners the light reaches if is_lit. */
void draw_attach(fxl_renderer *renderer, draw_parts *parts, const fxl_surface_set *set,
                 const fxl_painter *painter, bool is_lit);
void draw_detach(fxl_renderer *renderer);

/* Frames of 16 bits a pixel of a renderer's scene, with a set of surfaces and what only such frames
 * have: whole, in bands, and in another workspace. The renderer has no attachments before and after. */
void draw_rgb565(fxl_renderer *renderer, draw_parts *parts, const fxl_surface_set *from,
                 fuzz_input *in);

/* Faces that a frame looks at. */
uint64_t draw_model_view(const fxl_scene *scene);

/* The first rows of a frame by the scene's tree, if it has one: whole, in bands, near to far. */
void draw_by_bsp(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                 fuzz_input *in);

/* The first rows of a frame as a wireframe: whole and in bands. */
void draw_wireframe(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                    fuzz_input *in);

/* The first rows of a frame in which some models show billboards: whole, and in bands with any
 * list.
 */
void draw_billboards(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                     fuzz_input *in);

/* What the boxes about objects say, against every vertex. */
void draw_boxes(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose);

/* Some pixels of a band that was drawn of the renderer's frame, by fxl_pick_face. */
void draw_picks(fxl_renderer *renderer, const fxl_band *band, fuzz_input *in);

/* What is picked at some places of the renderer's frame: it is in the scene, and, where the pixels of
 * the frame are given, which show faces of one colour, it is what they show. Takes no input. */
void draw_all_picks(fxl_renderer *renderer, const void *pixels);

/* A point on the screen, a segment from the eye, and a sphere that slides away from there. */
void draw_hits(const fxl_scene *scene, const fxl_view *view, fuzz_input *in);

/* Gives a renderer without attachments a target of palette indices, by distance. What the library answers. */
fxl_status draw_choose(fxl_renderer *renderer, const fxl_target *target, void *memory, uint32_t size);

/* A frame that has begun, in another workspace: as it is in `whole`, over the background. */
void draw_in_another(const fxl_renderer *renderer, const uint8_t *whole, uint8_t background,
                     fuzz_input *in);

/* A frame into each target, with whatever may be attached, or a refusal that names two things. */
void draw_attached(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose);

/* Frames with lines or an orthographic lens, into each target, and with the surfaces of a set, if there is
 * one; and without a set draw_changes. Takes no byte of the input. */
void draw_lines(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                const fxl_surface_set *set, const fuzz_input *in);

/* Frames of a world over a scene of at most MADE_MODELS models, by what changed. Goes on with the chance of
 * draw_lines. */
void draw_changes(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose);

/* Setups of a scene, in exactly the memory that they ask for. */
void draw_setup(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose);

/* Any sequence of set-up calls of a renderer and of two workspaces of other cores. */
void draw_sequences(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                    fuzz_input *in);

/* --- stages ------------------------------------------------------------------- */

void fuzz_project(fuzz_input *in);
void fuzz_scan(fuzz_input *in);
void fuzz_clip_world(fuzz_input *in);
void fuzz_clip_view(fuzz_input *in);
void fuzz_viewer(fuzz_input *in);
void fuzz_lenses(fuzz_input *in);
void fuzz_misuse(fuzz_input *in);
void fuzz_sort(fuzz_input *in);
void fuzz_beams(fuzz_input *in);
void fuzz_split(fuzz_input *in);
void fuzz_volumes(fuzz_input *in);
void fuzz_normalised(fuzz_input *in);
void fuzz_first_program(fuzz_input *in);
void fuzz_planes(fuzz_input *in);
void fuzz_orientations(fuzz_input *in);
void fuzz_overlay(fuzz_input *in);
void fuzz_geometry(fuzz_input *in);
void fuzz_world(fuzz_input *in);
void fuzz_surfaces(fuzz_input *in);

/* Lights a renderer, or not: settings of any kind. */
void fuzz_set_light(fxl_renderer *renderer, fxl_light *light, fuzz_input *in);

/* Shows frames of a renderer whose screen is 24 x 16, and feeds formats, pump and drivers with what
 * they must refuse. */
void fuzz_show(fuzz_input *in, fxl_renderer *renderer, const fxl_pose *eye);

#endif
