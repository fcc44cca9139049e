/* SPDX-License-Identifier: MIT */
/* The records that the stages hand on, and keep in a renderer. A renderer's members are for reading
 * only: the functions that write these records stand beside the code of their stage. */
#ifndef FXL_RECORDS_H
#define FXL_RECORDS_H

#include "fixel/camera.h"
#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- the view ------------------------------------------------------------------------- */

/* The planes, in the order of clipping. Near and far come first. So a polygon that is
 * nearly parallel to them is cut by its exact distances, before the side planes have
 * rounded any vertex. */
enum {
    FXL_PLANE_NEAR,
    FXL_PLANE_FAR,
    FXL_PLANE_LEFT,
    FXL_PLANE_RIGHT,
    FXL_PLANE_BOTTOM,
    FXL_PLANE_TOP,
    FXL_PLANE_COUNT
};

/* The frustum in the world, for clippers in the world. */
typedef struct {
    fxl_plane planes[FXL_PLANE_COUNT];
} fxl_frustum;

/* The frustum in the view. A point (x, y, z) is inside
 *   left, right   if  +-x_side x + x_depth z >= inset,
 *   bottom, top   if  +-y_side y + y_depth z >= inset,
 *   near          if  z >= near_z,
 *   far           if  z <= far_z.
 * These integers are the planes: every clipper in the view clips to them exactly.
 * near_z and far_z include the inset. (x_side, x_depth) and (y_side, y_depth) have unit length, or
 * half the square of it in the sheared view of an off-centre lens. */
typedef struct fxl_view_frustum {
    fxl_q2_30 x_side, x_depth;
    fxl_q2_30 y_side, y_depth;
    fxl_q2_30 x_slope,
        y_slope; /* |x| <= x_slope z is inside left and right, |y| <= y_slope z bottom
                                 * and top, if z >= near_z; less than the greatest such, or 0 */
    fxl_q18_46 near_z, far_z, inset;
} fxl_view_frustum;

/* A set of planes: bit n stands for plane n (FXL_PLANE_...). */
typedef uint8_t fxl_planes;

#define FXL_PLANES_ALL FXL_CAST(fxl_planes, (1u << FXL_PLANE_COUNT) - 1u)

/* What project needs of a lens, set up once. The members belong to project. */
typedef struct {
    uint32_t factor;   /* 4 focal */
    int32_t depth_min; /* the least upper word of Z for the kernels' fast path */
    uint32_t factor_less_1;
    uint32_t factor_2;  /* 2^2 factor, modulo 2^32 */
    uint32_t factor_17; /* 2^17 factor, modulo 2^32 */
    fxl_q16_16 centre_x, centre_y;
} fxl_projection;

/* A view. The caller owns it, and sets first the lens, then the pose of each frame.
 *
 * The view of an off-centre lens is that of a centred lens with a larger focal length: the camera's
 * right and up are sheared along forward, so that the middle of the screen is straight ahead
 * (SPEC.md, section 4.2). Camera, projection and frusta are those of the sheared view. */
typedef struct {
    fxl_camera camera;
    fxl_lens lens; /* as it was set */
    fxl_projection projection;
    uint32_t frame; /* counts poses, skipping 0; 0: no pose yet */
    fxl_view_frustum view_frustum;
    fxl_frustum frustum; /* in the world; valid after fxl_view_set_world_frustum */
} fxl_view;

/* --- the vertices of an instance ------------------------------------------------------ */

/* A vertex in the view. */
typedef struct {
    uint32_t tag;        /* the instance, in the cache's count, and the vertex; 0: no vertex */
    uint32_t clip_flags; /* its outcode and FXL_VERTEX_UNPROJECTED; if both are 0, its first pixel
                            centre (lib/clip/clip_by_view.h) */
    fxl_screen_point screen;
    fxl_view_point position;
} fxl_cached_vertex;

/* A direct-mapped cache of vertices: vertex n is in entry n & mask. Two vertices of one entry
 * displace each other, which costs only time. */
typedef struct {
    fxl_cached_vertex *entries; /* of the caller's memory; null: only the entry below */
    uint32_t mask;              /* number of entries - 1; the number is a power of two */
    uint32_t count;             /* model views made, from 1, in units of 2^16 */
    void *clipper_workspace;    /* what the clipper keeps beside the vertices; or null */
    fxl_cached_vertex own;      /* all of the cache where the caller gave no memory */
} fxl_vertex_cache;

struct fxl_shader;

/* A model view. The caller owns it. */
typedef struct fxl_model_view {
    const fxl_view *view;
    fxl_cached_vertex *entries; /* of the cache */
    uint32_t mask;              /* of the cache */
    uint32_t tag;               /* of vertex 0 */
    const fxl_point *vertices;  /* of the model */
    const uint16_t *indices;    /* of the scene */
    const fxl_axes *axes;       /* rows of the rotation from the model to the view */
    fxl_planes planes;          /* those that a vertex may lie outside of; FXL_MODEL_VIEW_SCALED */
    uint8_t shift;              /* with FXL_MODEL_VIEW_SCALED: of the axes, 1..8 */
    fxl_view_point translation; /* where the model's origin is in the view */
    fxl_point offset;           /* the instance's centre - the eye; each coordinate below 2^30 */
    const struct fxl_shader *shader; /* the first that takes the instance's faces; null: none */
    void *clipper_workspace;         /* the clipper's, of the caller's memory; or null */
    /* With FXL_MODEL_VIEW_SCALED: makes a vertex that was transformed without the shift one with
     * the shift, with its clip flags, which it returns. */
    uint32_t (*scale_vertex)(const struct fxl_model_view *model_view, fxl_cached_vertex *entry);
    const fxl_instance *instance; /* of the model view, where there is a shader */
} fxl_model_view;

/* --- clipping ------------------------------------------------------------------------- */

/* The workspace of fxl_clip_view_by_planes. The caller owns it. It keeps nothing from
 * one call to the next. */
typedef struct {
    fxl_view_polygon polygons[2];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
} fxl_clip_view_work;

/* The workspace of fxl_clip_world_to_planes (study/clip_world.h). The caller
 * owns it. It keeps nothing from one call to the next. */
typedef struct {
    fxl_polygon polygons[2];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
} fxl_clip_world_work;

/* A scratch area for any clipper: 16 bytes, and 56 bytes a vertex of the capacity. */
typedef union {
    fxl_clip_view_work by_view;
    fxl_clip_world_work by_world;
} fxl_clipper_work;

/* A clipper. Its functions require a model view of an instance of a checked scene, or of a
 * polygon. model_view->planes may omit a plane that all vertices are inside of.
 * work keeps nothing from one call to the next. A clipper keeps what must last in
 * model_view->clipper_workspace, which is zeroed when the clipper is set.
 * model_view->view->frame differs from one frame to the next, and is never 0. */
typedef struct {
    /* Clips a face of the instance and projects it. *screen is the result for
     * FXL_CLIP_INSIDE, FXL_CLIP_CUT and FXL_CLIP_BETWEEN; otherwise its points have no meaning. */
    fxl_clip_result (*clip)(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen);
    /* Null if a face gives at most one polygon. Otherwise the renderer calls it after clip
     * returned FXL_CLIP_INSIDE or FXL_CLIP_CUT, and again while it returns one of these two: then
     * *screen is the face's next polygon. Any other result means that the face has no more
     * polygons. After FXL_CLIP_CAPACITY or FXL_CLIP_RANGE the face is counted as refused, even if
     * some of it is drawn. */
    fxl_clip_result (*next)(const fxl_model_view *model_view, fxl_clipper_work *work,
                            fxl_screen_polygon *screen);
    uint32_t workspace_size; /* bytes of the caller's memory that it needs, aligned to 8 */
    /* Sets up what the clipper needs of a frame, once the view has its pose. Null: nothing. */
    void (*begin)(fxl_view *view);
    /* clip answers FXL_CLIP_OUTSIDE for each face whose vertices, as fxl_fetch_vertex gives them,
     * all have the clip flag of one plane. Then the renderer may leave such faces out. */
    bool by_clip_flags;
    /* &fxl_rounded_faces, if clip works from the points of the world, and not from vertices that
     * fxl_fetch_vertex gives; else null. Then the points of turned instances are rounded in the
     * world (SPEC.md, section 8.5). */
    const struct fxl_shader_code *by_points;
} fxl_clipper;

/* What takes faces of turned instances whose points are rounded in the world: for by_points. */
extern const struct fxl_shader_code fxl_rounded_faces;

/* fxl_clip_by_view: the default. It needs no workspace. If the caller gives it an fxl_clip_stats,
 * and its size, as its workspace, it counts in it. */
extern const fxl_clipper fxl_clipper_view;

/* --- scanning ------------------------------------------------------------------------- */

/* A chain: the edges on one side of an outline, from its top to its bottom. */
typedef struct {
    uint8_t vertex;  /* at which the next edge begins */
    uint8_t onward;  /* step from a vertex to the next of the chain, modulo the count */
    int16_t end_row; /* one past the last row for which the trapezoid's edge holds */
} fxl_chain;

/* An edge on a row and its step to the next row, as integers with remainders. */
typedef struct {
    int32_t x;           /* first pixel whose centre is not left of the edge */
    uint32_t error;      /* remainder, < height */
    int32_t step;        /* whole pixels a row */
    uint32_t error_step; /* remainder, < height */
    uint32_t height;     /* in 1/65536 pixel */
} fxl_slope;

/* place fill-rule: the winding of an edge's record */
/* An edge that crosses the current row. */
typedef struct {
    fxl_slope slope;
    int32_t winding; /* +1 downward, -1 upward */
} fxl_active_edge;

/* The scan of an outline that goes up and down more than once, or leaves the band at a
 * side. With FXL_SMALL (config.h) every outline is scanned so. */
typedef struct {
    const fxl_screen_point *points;
    int16_t row, end_row; /* the current row; one past the last row */
    int16_t steady_end;   /* no edge begins or ends above this row */
    int16_t right;        /* one past the last column of the band */
    uint8_t count;        /* points */
    uint8_t found_count;  /* edges that cross the row */
    int16_t left;         /* the first column of the band */
    int32_t x;            /* on the row, where the next stretch of pixels may begin */
    fxl_active_edge found[FXL_POLYGON_CAPACITY];
} fxl_active_edges;

/* A polygon that is being scanned. The caller owns it; all members belong to scan. */
typedef struct {
    const fxl_screen_point *points;
    uint8_t count;
    bool by_chains;  /* if false, by active edges */
    int16_t end_row; /* one past the last row by chains; above all rows by active edges */
    fxl_chain chains[2];
    int16_t row; /* of the next span */
    fxl_trapezoid trapezoid;
    int16_t outline_first, outline_end; /* rows of the whole outline, as fxl_scan_rows says */
    fxl_active_edges active_edges;
} fxl_scan;

/* --- the order of drawing ------------------------------------------------------------- */

/* Where an instance comes in the order of drawing, and what it may cross. */
typedef struct {
    uint8_t layer;
    uint8_t planes; /* that the instance may cross (fxl_sphere_planes) */
} fxl_draw_instance;

/* An instance or a face, with its key. The squared distance is an integer, in units of
 * 2^-32 (instances) or 2^-34 (faces). It has two halves because a member of 64 bits
 * would make the entry 16 bytes instead of 12. */
typedef struct fxl_draw_entry {
    union {
        uint32_t distance_low;
        uint32_t face;  /* after fxl_sort_faces: the face at this place of the order */
        uint32_t faces; /* of an instance, once a frame has begun: lib/draw/extents.c */
    };
    union {
        uint32_t distance_high;
        fxl_rows rows; /* once a frame has begun: those of the screen that it reaches */
    };
    uint16_t index; /* of an instance of the scene, or of a face of its model */
    union {
        fxl_draw_instance instance;
        uint16_t next; /* of faces, while they are sorted: the next entry of a chain */
    };
} fxl_draw_entry;

FXL_STATIC_ASSERT(FXL_SCENE_INSTANCES_MAX <= 65535 && FXL_MODEL_FACES_MAX <= 65535, "index");

/* How many chains sort faces: so few that their memory is smaller than the scratch area of a
 * clipper, with which it is shared. */
#define FXL_ORDER_CHAINS (FXL_POLYGON_CAPACITY >= 19 ? 512 : FXL_POLYGON_CAPACITY >= 9 ? 256 : 128)

/* A scratch area of fxl_sort_faces, which keeps nothing from one call to the next. */
typedef struct {
    uint16_t chains[FXL_ORDER_CHAINS];
} fxl_sort_work;

/* --- the display list ----------------------------------------------------------------- */

/* The words of 32 bits that a polygon of so many vertices takes in a display list: one for its
 * rows, one for its kind, colour and count, and two for each point, unchanged. */
#define FXL_DISPLAY_LIST_WORDS(vertices) (2u + 2u * (vertices))

/* A display list. The first `used` of `capacity` words hold records. */
typedef struct {
    uint32_t *words; /* the caller's; may be null where capacity is 0 */
    uint32_t capacity, used;
} fxl_display_list;

#ifdef __cplusplus
}
#endif

#endif
