/* SPDX-License-Identifier: MIT */
/* What the library asks of a lens, and what an off-centre or an orthographic one needs: a lens points
 * to it, so that a program whose lenses all have their centre in the middle of the screen does not
 * link it. Internal. */
#ifndef FXL_LENS_H
#define FXL_LENS_H

#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whether a lens may have been made by the functions of fixel/camera.h: all members within their
 * ranges, and a focal length of a field of view within FXL_FOV_MIN..FXL_FOV_MAX, or beyond it by
 * less than 2/1000. False if lens is null. */
bool fxl_lens_is_valid(const fxl_lens *lens);

struct fxl_depth_plane;
struct fxl_order;
struct fxl_renderer;
struct fxl_traversal;
struct fxl_orthographic_code;

struct fxl_off_centre_code {
    /* Whether focal length, inset and centre are in their ranges, for a lens whose other members
     * are. */
    bool (*is_valid)(const fxl_lens *lens);
    /* Turns frustum and projection, made for a centred lens, into those of the lens. */
    void (*set_lens)(fxl_view *view);
    /* fxl_view_set_pose: sets camera and frame, and shears the axes or moves the eye. */
    fxl_status (*set_pose)(fxl_view *view, const fxl_pose *pose);
    const struct fxl_orthographic_code *orthographic; /* null: the lens has an eye */
};

/* How a point of a view is projected: as fxl_project_inside does, or another function. */
typedef fxl_status fxl_projector(const fxl_view *view, const fxl_view_point *point,
                                 fxl_screen_point *screen);

/* What an orthographic lens is drawn with (docs/extras/orthographic.md). */
typedef struct fxl_orthographic_code {
    fxl_projector *project; /* fxl_project_orthographic */
    /* Whether a renderer has the default clipper in a form of this lens, and the order by distance. */
    bool (*has_clipper)(const struct fxl_renderer *renderer);
    const struct fxl_order *order;
    /* Gives a renderer these two in the place of those of other lenses. */
    void (*take)(struct fxl_renderer *renderer);
    /* Puts the instances in sight in order, when a frame begins. */
    void (*begin)(const struct fxl_traversal *traversal);
    /* Whether a face of an instance is seen from its front. */
    bool (*face_is_front)(const fxl_view *view, const fxl_scene *scene, uint32_t number,
                          const fxl_face *face);
    /* fxl_submit_any_instance. */
    bool (*submit)(const struct fxl_traversal *traversal, const struct fxl_draw_entry *entry);
    /* fxl_find_depth_by_normal */
    void (*find_depth)(const fxl_model_view *model_view, const fxl_face *face,
                       struct fxl_depth_plane *plane);
    /* For billboards: the distance of a lens with an eye that has the depth of this one. */
    fxl_q18_46 (*distance_of)(const fxl_view *view, fxl_q18_46 depth);
} fxl_orthographic_code;

/* That of a lens; null: it has an eye. */
static inline const fxl_orthographic_code *fxl_orthographic_of(const fxl_lens *lens)
{
    return lens->off_centre != NULL ? lens->off_centre->orthographic : NULL;
}

/* lib/view/off_centre.c */
extern const fxl_off_centre_code fxl_off_centre;

/* Whether the focal length is that of a field of view, the centre no farther from the middle of the
 * screen than fxl_lens_set_centre says, and the inset 0. */
bool fxl_off_centre_is_valid(const fxl_lens *lens);

/* lib/draw/orthographic.c */
extern const fxl_off_centre_code fxl_orthographic;

/* Projects a point (X, Y, Z) of the view: x = centre_x + scale X, y = centre_y - scale Y, with X and Y
 * from the pose's eye, each product rounded once, to the nearest 1/65536 pixel (halves upward, before
 * the centre is added). Requires |X|, |Y| < 2^61 units and a view with an orthographic lens.
 * FXL_E_RANGE: a coordinate would exceed FXL_SCREEN_COORDINATE_MAX; screen untouched.
 * Error, given the view point: half a unit of 1/65536 pixel. */
fxl_projector fxl_project_orthographic;

#ifdef __cplusplus
}
#endif

#endif
