/* SPDX-License-Identifier: MIT */
/* Billboards: sprites at points of the world, upright on the screen, smaller where they are farther
 * away, and drawn in the order of the instances. docs/extras/billboards.md. */
#ifndef FXL_BILLBOARDS_H
#define FXL_BILLBOARDS_H

#include "fixel/overlay.h"
#include "fixel/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The largest side of a billboard: 8191 world units. */
#define FXL_BILLBOARD_SIDE_MAX FXL_COORDINATE_MAX

/* What the instances of a model show instead of their face. */
typedef struct {
    const fxl_sprite *sprite;
    fxl_q16_16 width, height;      /* world units, 1/65536..FXL_BILLBOARD_SIDE_MAX */
    fxl_q16_16 anchor_x, anchor_y; /* the centre of the instance, from the left and from the lower
                                      side: 0..width, 0..height */
} fxl_billboard;

/* The billboards of a scene: tables that the caller owns and that must outlive it. */
typedef struct {
    const fxl_billboard *billboards;
    uint32_t count;            /* 0..65535 */
    const uint16_t *model_map; /* one for each model of the scene: 0, or the number of its
                                  billboard, counted from 1 */
} fxl_billboard_set;

/* What paints billboards into a target: FXL_SPRITES_OF. Members are internal. */
typedef struct fxl_sprite_painter fxl_sprite_painter;

/* place pixel-format: the records of painters of billboards */
/* Those of each target. FXL_SPRITES_OF(fxl_palette) is the address of one. */
extern const fxl_sprite_painter fxl_palette_sprites, fxl_palette_depth_16_sprites,
    fxl_palette_depth_32_sprites, fxl_rgb565_sprites, fxl_rgb565_depth_16_sprites,
    fxl_rgb565_depth_32_sprites;
#define FXL_SPRITES_OF(target) (&target##_sprites)

/* How an order submits instances that may show a billboard, and where one is on the screen. */
typedef struct {
    bool (*all)(const fxl_traversal *traversal); /* by distance */
    bool (*instance)(const fxl_traversal *traversal, const fxl_draw_entry *entry);
    fxl_clip_result (*place)(const fxl_view *view, const fxl_scene *scene, uint32_t number,
                             const fxl_billboard *billboard, fxl_view_point *centre,
                             fxl_screen_point *corners);
    const fxl_order *order; /* by distance, whose submit is `all` */
} fxl_billboard_code;

/* The billboards of a renderer, which the caller owns. Members are internal. */
struct fxl_billboards {
    const fxl_billboard_set *set;
    const fxl_sprite_painter *painter;
    const fxl_billboard_code *code;
};

/* Checks the billboards of a scene: that each has a sprite of 1, 4 or 8 bits with pixels and sides
 * of 1..65535; every number and range; and of a model with a billboard that it is convex, has one
 * face, and has a radius that holds all corners of the billboard about the anchor. Requires a
 * checked scene and tables as long as their counts; fault may be null.
 * FXL_E_ARGUMENT: a null pointer, also in a record.
 * FXL_E_ALIGNMENT: billboards or sprites are not aligned to a pointer's size, or model_map to 2
 * bytes.
 * FXL_E_COUNT: the set's count, or the faces of a model.
 * FXL_E_RANGE: a number is out of its range.
 * FXL_E_INDEX: model_map has a number past the end of a table.
 * FXL_E_RADIUS: a vertex is outside the sphere that must hold it.
 * With each of these statuses: *fault written.
 * On FXL_OK *fault is untouched. */
fxl_status fxl_billboards_check(const fxl_billboard_set *set, const fxl_scene *scene,
                                fxl_scene_fault *fault);

/* Makes a set of the billboards of a scene image. sprites and boards: memory for its records, so
 * many of each; they must outlive *set, as the image must. Checks that each sprite lies within the
 * image's sprite pixels, and as fxl_billboards_check.
 * Requires an image that fxl_scene_open has opened; fault may be null.
 * FXL_E_ARGUMENT: a null pointer; an image without billboards.
 * FXL_E_ALIGNMENT: sprites or boards are not aligned.
 * FXL_E_CAPACITY: more billboards than capacity.
 * FXL_E_RANGE: a number is out of its range.
 * FXL_E_OFFSET: a table reaches outside the image.
 * FXL_E_RESERVED: a reserved field or an enumeration has an unknown value.
 * The statuses of fxl_billboards_check.
 * With each of these statuses: *set untouched, *fault written; sprites and boards may be
 * overwritten.
 * On FXL_OK *fault is untouched. */
fxl_status fxl_billboards_open(const fxl_scene_image *image, fxl_sprite *sprites,
                               fxl_billboard *boards, uint32_t capacity, fxl_billboard_set *set,
                               fxl_scene_fault *fault);

/* Attaches the billboards of a set to a renderer, or, where set is null, detaches them. painter is
 * FXL_SPRITES_OF the renderer's target. The renderer keeps a pointer to *billboards, and that one
 * to *set. What else is attached, before or after, does not matter. A sprite may change between
 * frames, and so may model_map. With a depth buffer each pixel of a billboard has the distance of
 * its instance's centre, to a relative error below 2^-28; one with the colour key keeps no depth.
 * In the display list a billboard takes 32 bytes, or 40 with a depth buffer. The next frame must
 * begin anew; where set is null and there are none, a frame that has begun stays.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the renderer was never initialised.
 * FXL_E_ALIGNMENT: billboards is not aligned to a pointer's size.
 * The statuses of fxl_billboards_check.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_attach_billboards(fxl_renderer *renderer, fxl_billboards *billboards,
                                 const fxl_billboard_set *set, const fxl_sprite_painter *painter);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_billboards_reasons[];

#ifdef __cplusplus
}
#endif

#endif
