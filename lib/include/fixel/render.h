/* SPDX-License-Identifier: MIT */
/* The frame loop (Listing 65.3, UpdateWorld): every stage, in order. */
#ifndef FXL_RENDER_H
#define FXL_RENDER_H

#include "fixel/clipper.h"
#include "fixel/hidden.h"
#include "fixel/list.h"
#include "fixel/order.h"
#include "fixel/scan.h"

/* Memory of the caller that a renderer works in for as long as it lives. */
typedef struct {
    fxl_order_entry *order;  /* at least scene->order_needed entries */
    uint32_t order_capacity; /* entries */
    uint32_t *list;          /* may be null where list_capacity is 0 */
    uint32_t list_capacity;  /* words; see FXL_LIST_WORDS */
    fxl_seen_vertex *cache;  /* may be null where cache_capacity is 0 */
    uint32_t cache_capacity; /* entries: a power of two, or what is more lies idle */
} fxl_memory;

/* How far a walk over the scene has come: so many objects in the order of
 * drawing are done, and of the next object so many faces. */
typedef struct {
    uint16_t objects, faces;
} fxl_place;

_Static_assert(FXL_SCENE_OBJECTS_MAX <= 65535 && FXL_MODEL_FACES_MAX <= 65535, "fxl_place");

typedef struct fxl_light fxl_light;

/* A renderer, which the caller owns. On a core of 32 bits it takes 472 bytes and
 * 64 for each vertex of FXL_POLYGON_CAPACITY: 2520 where that is 32, 1240 where
 * it is 12. Several may live at once; none knows of another. Members are for
 * reading only, but for light. */
struct fxl_renderer {
    const fxl_scene *scene;
    fxl_order_entry *order;     /* objects; from scene->object_count on, one model's faces */
    const fxl_clipper *clipper; /* fxl_clipper_view, or another */
    const fxl_hidden *hidden;   /* fxl_hidden_sorted, or another */
    const fxl_light *light;     /* null, or what splits faces; set between two frames */
    bool ready;                 /* a frame has begun */
    bool counted;               /* a band was drawn: what is not in the list is counted */
    uint16_t in_sight;          /* objects in order: those that the frame looks into */
    uint16_t sorted, front;     /* whose faces are in order, as fxl_place counts; how many */
    fxl_list list;
    uint32_t object_capacity; /* what scene->object_count may grow to: order has room for so many */
    fxl_place rest;           /* where the list was full */
    fxl_counters counters;
    void *walk_room; /* what the caller gave for hidden, in two parts */
    fxl_view view;
    fxl_vertex_cache cache;
    void *paint_room;      /* the other */
    fxl_seen_vertex spare; /* all of the cache where the caller gave none */
    uint32_t paint_room_size;
    fxl_screen_polygon screen;
    union { /* a polygon is scanned when its clipping is over */
        fxl_clipper_work clip;
        fxl_scan scan;
    } work;
};

/* The symbols of fxl_renderer_init... end in FXL_POLYGON_CAPACITY (format.h). */
#define FXL_WITH_CAPACITY(name, capacity) name##_for_polygons_of_##capacity
#define FXL_NAME_WITH(name, capacity)     FXL_WITH_CAPACITY(name, capacity)
#define fxl_renderer_init                 FXL_NAME_WITH(fxl_renderer_init, FXL_POLYGON_CAPACITY)
#define fxl_renderer_init_bare            FXL_NAME_WITH(fxl_renderer_init_bare, FXL_POLYGON_CAPACITY)

/* Ties a renderer to a scene (checked by fxl_scene_open or fxl_scene_check), a
 * lens, and memory. Zeroes the counters.
 * A list that holds every polygon of a frame lets bands be drawn without a look
 * at the scene; one that is full leaves the rest to every band, and without one
 * every band walks the scene. The pixels are the same.
 * FXL_E_ARGUMENT, FXL_E_ORDER (the scene was not checked: its order_needed is 0),
 * FXL_E_CAPACITY (order; or an object_count that was raised after the check): renderer
 * untouched. */
fxl_status fxl_renderer_init(fxl_renderer *renderer, const fxl_scene *scene, const fxl_lens *lens,
                             const fxl_memory *memory);

/* The same, but with no clipper and nothing that hides what: where others are set than
 * fxl_renderer_init would, those it would are not linked. fxl_frame_begin answers
 * FXL_E_ORDER until both are set. */
fxl_status fxl_renderer_init_bare(fxl_renderer *renderer, const fxl_scene *scene,
                                  const fxl_lens *lens, const fxl_memory *memory);

/* Sets the clipper, and room of the caller's for it: clipper->room bytes aligned to 8, of
 * which it keeps hold; may be null where that is 0. Then a frame must begin anew.
 * FXL_E_ARGUMENT, FXL_E_CAPACITY (room_size): renderer untouched but for
 * refused_calls. */
fxl_status fxl_renderer_set_clipper(fxl_renderer *renderer, const fxl_clipper *clipper, void *room,
                                    uint32_t room_size);

/* Sets what hides what, and room of the caller's for it, aligned to 8, of which it keeps
 * hold; may be null where the method wants none. Then a frame must begin anew.
 * FXL_E_ARGUMENT, FXL_E_CAPACITY (room_size is less than the method wants for this scene and
 * this lens): renderer untouched but for refused_calls. */
fxl_status fxl_renderer_set_hidden(fxl_renderer *renderer, const fxl_hidden *hidden, void *room,
                                   uint32_t room_size);

/* Begins a frame: camera, frustum, order of the objects in sight; then every polygon on
 * its way to the screen, as far as the list reaches. Zeroes the counters except
 * refused_calls, and counts the polygons that it came to. Then draw the frame
 * whole or in bands. scene->object_count may change between the last band of a frame and
 * fxl_frame_begin, as far as the order table has room.
 * FXL_E_ARGUMENT, FXL_E_ORDER (no clipper, or nothing that hides what), FXL_E_RANGE (pose),
 * FXL_E_CAPACITY (scene->object_count has grown beyond the order table): the frame before
 * stays current; counted in refused_calls. */
fxl_status fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose);

/* Draws the frame's polygons over a band that the caller has cleared
 * (fxl_fill_band): those of the list that reach it, then the rest of the scene
 * where the list was full. The pixels are the same whatever bands a frame is cut
 * into. The first band after fxl_frame_begin counts that rest, so that each
 * polygon is counted once.
 * FXL_E_ARGUMENT, FXL_E_ORDER (no frame begun), FXL_E_RANGE (a band that is
 * not of this screen): band untouched; counted in refused_calls. */
fxl_status fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band);

#endif
