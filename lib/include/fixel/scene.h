/* SPDX-License-Identifier: MIT */
/* Scenes: models and instances, used in place from a scene image. The byte layout of an
 * image is docs/formats.md, section 1. These structures have that layout, so a scene may also be
 * written as C tables. */
#ifndef FXL_SCENE_H
#define FXL_SCENE_H

#include "fixel/tables.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The most elements of a scene. FXL_SCENE_PLACED_MAX limits the sum of the vertex counts of all
 * instances' models: it bounds the time of the checks. FXL_SCENE_IMAGE_MAX is in bytes. */
#define FXL_SCENE_IMAGE_MAX         (16u * 1024u * 1024u)
#define FXL_SCENE_VERTICES_MAX      1000000u
#define FXL_SCENE_INDICES_MAX       4000000u
#define FXL_SCENE_FACES_MAX         1000000u
#define FXL_SCENE_MODELS_MAX        65535u
#define FXL_SCENE_INSTANCES_MAX     65535u
#define FXL_SCENE_PATH_MAX          1000000u
#define FXL_SCENE_PLACED_MAX        4000000u
#define FXL_SCENE_FACE_VERTICES_MAX 24u
#define FXL_MODEL_VERTICES_MAX      65535u
#define FXL_MODEL_FACES_MAX         65535u
#define FXL_BSP_NODES_MAX           65535u
#define FXL_BSP_DEPTH_MAX           1023u /* of a node below the root */
#define FXL_SCENE_CLUSTERS_MAX      65535u
#define FXL_MOTION_KEYS_MAX         1000000u
#define FXL_SCENE_TABLE_MAX         65535u  /* textures, surfaces, mapped faces, corner normals */
#define FXL_SCENE_CORNERS_MAX       196605u /* three for each mapped face */
#define FXL_MOTION_DEPTH_MAX        8u      /* of a chain of parents */

/* The largest distance of a vertex of a BSP node's faces from its plane, in units of 1/65536. */
#define FXL_BSP_PLANARITY_MAX FXL_CAST(fxl_q16_16, 8)
#define FXL_BSP_NONE 0xFFFFu /* the number that stands for no BSP node */
#define FXL_CLUSTER_APEX_MAX FXL_CAST(fxl_q16_16, 2 * FXL_COORDINATE_MAX) /* of a coordinate */

/* A face of count vertices, clockwise as seen from the front; an index is the number of one within
 * the model. A triangle has its indices in itself. Any other face has the first of them, and all
 * are in the scene's table of indices, one behind the other: FXL_INDICES_AT. fxl_face_indices finds
 * both. The normal points to the front; it alone decides which side is the front. */
typedef struct {
    fxl_direction normal;
    uint8_t count;       /* 3..24; a build draws up to FXL_FACE_VERTICES_MAX */
    uint8_t material;    /* of a flat face: its palette index */
    uint16_t indices[3]; /* of a triangle; of another face the first one, and a number's halves */
} fxl_face;

/* The member indices of a face that is no triangle, as in a table of faces: vertex is the scene's
 * indices[number], its first one. */
#define FXL_INDICES_AT(vertex, number) \
    { \
        FXL_U16(vertex), FXL_U16(number), FXL_U16((number) >> 16) \
    }
#define FXL_U16(number) FXL_CAST(uint16_t, FXL_CAST(uint32_t, number) & 0xFFFFu)

/* The indices of a face: indices are those of its scene. */
static inline const uint16_t *fxl_face_indices(const uint16_t *indices, const fxl_face *face)
{
    return face->count == 3
               ? face->indices
               : indices + (face->indices[1] | FXL_CAST(uint32_t, face->indices[2]) << 16);
}

/* Gives a face of count vertices the scene's indices from number first on. */
static inline void fxl_face_take_indices(fxl_face *face, const uint16_t *indices, uint32_t first)
{
    const bool is_triangle = face->count == 3;
    face->indices[0] = indices[first];
    face->indices[1] = is_triangle ? indices[first + 1] : FXL_U16(first);
    face->indices[2] = is_triangle ? indices[first + 2] : FXL_U16(first >> 16);
}

/* The whole face of the parts that a tool cut it into, as for a BSP tree: count indices of the
 * scene, 3..24, from number first on. Light at run time takes its middle for all parts. */
#define FXL_WHOLE(first, count) FXL_CAST(uint32_t, 32u * (first) + (count))

/* Plane and bounding box of a face of a sorted model: facing and order need them in every frame. */
typedef struct {
    uint32_t height_low, height_high; /* normal . first vertex, 18.46, two's complement */
    int32_t box_x, box_y, box_z;      /* minimum + maximum of the vertices, 16.16 */
} fxl_face_bounds;

enum {
    FXL_MODEL_CONVEX = 0, /* faces drawn by number */
    FXL_MODEL_SORTED = 1  /* faces drawn far to near */
};

/* A model: vertex_count vertices from vertices[first_vertex] on, and face_count faces from
 * faces[first_face] on. Models share neither vertices nor faces: the first model begins at 0, each
 * other model begins where the one before it ends, and the last ends with the tables.
 * Vertices are relative to the centre of the instance. No vertex is farther from the model's origin
 * than the radius. A smaller radius lets the sphere test reject more instances. */
typedef struct {
    uint32_t first_vertex, vertex_count; /* vertex_count 3..65535; 1..65535 without faces */
    uint32_t first_face, face_count;     /* face_count 0..65535; one without faces is convex */
    uint8_t kind;
    uint8_t reserved;           /* 0 */
    uint16_t first_cluster;     /* of a sorted model, counted from 1; 0: it has no clusters */
    fxl_q16_16 radius;          /* 0..FXL_RADIUS_MAX */
    uint32_t first_face_bounds; /* of a sorted model, if the scene has face bounds; else 0 */
} fxl_model;

/* An instance: a model at a place of the world. Instances of a lower layer are drawn first;
 * within a layer the order is far to near. */
typedef struct {
    fxl_point centre;
    uint16_t model;
    uint8_t layer;
    uint8_t recolour; /* 0; in a world, a table of colours, counted from 1 (fixel/world.h) */
} fxl_instance;

/* A node of a BSP tree over the faces of one instance (docs/extras/bsp.md): a plane relative to the
 * instance's centre, the faces on the plane, and the subtrees in front of it and behind it. The
 * table has the nodes in pre-order: a node, its front subtree, its back subtree.
 * A point is in front of the plane if normal . point > distance. */
typedef struct {
    fxl_direction normal;
    uint32_t distance_low, distance_high; /* 18.46, two's complement */
    uint16_t front, back, parent;    /* numbers of nodes, or FXL_BSP_NONE */
    uint16_t first_face, face_count; /* in the model; the nodes take its faces in turn */
    uint16_t reserved;               /* 0 */
    fxl_point centre;                /* of a sphere about the node's faces and its children's */
    fxl_q16_16 radius;               /* spheres; 0..FXL_RADIUS_MAX */
} fxl_bsp_node;

/* A cluster: a run of faces of a sorted model, which are left out together if none can be seen. The
 * clusters of a model take its faces in turn. Points are relative to the centre of the instance.
 * All vertices of the faces lie in the sphere. Its centre lies in the bounding box of the faces.
 * The cone: no face shows its front to an eye for which u = apex - eye has u . axis >= 0 and
 * (u . axis)^2 >= cutoff |u|^2. A cluster without a cone has axis, cutoff and apex 0. */
typedef struct {
    fxl_point centre;
    fxl_q16_16 radius;   /* 0..FXL_RADIUS_MAX */
    fxl_direction axis;  /* of unit length, with the tolerance of a face's normal */
    uint32_t cutoff;     /* in units of 2^-32 */
    fxl_point apex;      /* each coordinate within FXL_CLUSTER_APEX_MAX */
    uint16_t face_count; /* >= 1; the tool makes clusters of 16 to 32 faces */
    uint16_t reserved;   /* 0 */
} fxl_cluster;

/* The code that draws clusters, and that for instances that turn and scale. A scene that has some
 * names it, so that a program whose scenes have none does not link it. */
typedef struct fxl_cluster_code fxl_cluster_code;
typedef struct fxl_placement_code fxl_placement_code;
extern const fxl_cluster_code fxl_clusters;
extern const fxl_placement_code fxl_turned_instances;

#define FXL_BEAM_PLANES_MAX 8 /* of a beam */
#define FXL_BEAMS_MAX       4 /* of a scene */

/* A plane of the world, as in a scene image. A point is inside if normal . point >= distance. */
typedef struct {
    fxl_direction normal; /* of unit length, with the tolerance of a face's normal */
    uint32_t distance_low, distance_high; /* 18.46, two's complement, below 2^61 */
} fxl_beam_plane;

enum {
    FXL_BEAM_POINT = 0,    /* the light comes from a point of the world */
    FXL_BEAM_DIRECTION = 1 /* the light travels along a direction */
};

/* A beam of light. Its planes cut in their order in the table (docs/extras/beams.md). */
typedef struct {
    int32_t from[3]; /* the point in 16.16, or the direction in 2.30 */
    uint8_t kind;
    uint8_t plane_count; /* 1..FXL_BEAM_PLANES_MAX; the planes after these are all 0 */
    uint16_t reserved;   /* 0 */
    fxl_beam_plane planes[FXL_BEAM_PLANES_MAX];
} fxl_beam;

/* A scene: tables that the caller owns and that must outlive it. Without face bounds the frames are
 * the same; sorting takes longer (with a depth buffer only surfaces that are mixed need it). */
typedef struct {
    const fxl_point *vertices;
    const uint16_t *indices;
    const fxl_face *faces;
    const fxl_model *models;
    const fxl_instance *instances;
    uint32_t vertex_count, index_count, face_count, model_count, instance_count;
    uint32_t draw_list_needed; /* entries that a renderer's draw_list needs; set by the checks */
    const fxl_face_bounds *face_bounds; /* a record a face, sorted models in turn; or null */
    uint32_t face_bounds_count;
    const fxl_bsp_node *bsp_nodes; /* a tree over the faces of one instance; or null */
    uint32_t bsp_node_count;
    uint32_t bsp_instance; /* the instance of the tree; no other has its model; 0 without a tree */
    const fxl_beam *beams; /* for fxl_attach_beams; or null */
    uint32_t beam_count;
    const uint8_t *lit; /* 256 entries: the colour that each colour has in a beam; or null */
    const fxl_cluster *clusters; /* of the models that have some, in turn; or null */
    uint32_t cluster_count;
    const fxl_cluster_code *cluster_code; /* &fxl_clusters, set by the checks; null: no clusters */
    const fxl_placement *placements; /* of instances from first_turned on; null: none is turned */
    uint32_t first_turned; /* where there are placements: the first instance that has one */
    const fxl_placement_code *placement_code; /* where there are some: &fxl_turned_instances */
    uint32_t instance_capacity; /* of a world (fixel/world.h): the most instances; else 0 */
    const uint32_t *wholes;     /* of each face: FXL_WHOLE of what it is a part of, or 0; or null */
} fxl_scene;

/* place pixel-format: pixel_bits of an image: what the scene asks for */
/* A scene image: the scene and the settings beside it. */
typedef struct {
    fxl_scene scene;
    /* With a scale: its screen, near and far, which fxl_lens_orthographic makes a lens of. No renderer
     * takes it as it is. */
    fxl_lens lens;
    fxl_q16_16 scale; /* pixels a world unit of an orthographic lens; 0: the lens has an eye */
    uint8_t background;
    /* What the scene asks for; a program may follow. Order: by its tree if it has one. */
    uint8_t pixel_bits;     /* 8: the palette; 16: RGB565 */
    uint8_t depth_bits;     /* of a depth buffer: 0, 16 or 32 */
    bool by_distance;       /* though it has a tree */
    const uint8_t *palette; /* 256 x red, green, blue */
    fxl_player start;       /* where the path begins */
    fxl_motion_limits motion_limits;
    const fxl_pose *poses;            /* one a frame; null if the path is segments */
    const fxl_path_segment *segments; /* null if the path is poses */
    uint32_t path_count;              /* poses or segments */
    uint32_t frame_count;             /* frames of the whole path */
    fxl_motion_set motion;            /* for fxl_motion_begin */
    fxl_scene_light light;            /* for fxl_light_settings_of */
    fxl_scene_surfaces surfaces;      /* for fxl_surfaces_open, which checks them */
    fxl_scene_billboards billboards;  /* for fxl_billboards_open, which checks them */
    fxl_line_set lines; /* for fxl_attach_lines, which checks them; without lines line_map is null */
    fxl_horizon horizon; /* for fxl_attach_horizon, which checks it; without one sines is null */
} fxl_scene_image;

/* The element at which a check failed, for messages: what it is, and its number, counted from 0. */
typedef struct {
    const char *what; /* "vertex", "face", "instance" and so on; never null */
    uint32_t index;
} fxl_scene_fault;

/* Checks a scene written as tables, and sets scene->draw_list_needed. It checks every count, index,
 * range, normal, planarity and face bounds; that no vertex lies outside its model's radius; and
 * that every vertex of every instance lies within FXL_COORDINATE_MAX.
 * Requires tables as long as their counts; fault may be null.
 * FXL_E_ARGUMENT: a null pointer; clusters, a BSP tree or beams: fxl_scene_check_all checks these.
 * FXL_E_ALIGNMENT: a table of 32-bit members is not aligned to 4 bytes, or indices to 2.
 * FXL_E_COUNT: a count is out of its range.
 * FXL_E_INDEX: an index is past the end of its table.
 * FXL_E_RANGE: a number is out of its range.
 * FXL_E_RADIUS: a vertex is outside the sphere that must hold it.
 * FXL_E_NORMAL: a normal is not of unit length.
 * FXL_E_PLANARITY: a vertex is off the plane of its face.
 * FXL_E_FACE_BOUNDS: a face's bounds are not those of its vertices and its normal.
 * FXL_E_RESERVED: a reserved field or an enumeration has an unknown value.
 * FXL_E_CAPACITY: a face's vertices exceed FXL_FACE_VERTICES_MAX, by this FXL_POLYGON_CAPACITY.
 * FXL_E_PLACEMENT: an orientation is no rotation; fxl_placement_check checks a turned instance,
 * instead of its vertices.
 * With each of these statuses: scene untouched, *fault written. On FXL_OK *fault is untouched. */
fxl_status fxl_scene_check(fxl_scene *scene, fxl_scene_fault *fault);

/* As fxl_scene_check, but of a scene that may have clusters, a BSP tree and beams: these too.
 * On FXL_OK cluster_code of the scene is set too, and where there are placements placement_code.
 * FXL_E_CLUSTER: a face of a cluster may be seen from within the cluster's cone.
 * FXL_E_BSP: the tree is too deep, or an instance may not be with it (docs/extras/bsp.md).
 * The statuses of fxl_scene_check and fxl_beam_check.
 * With each of these statuses: scene untouched, *fault written. On FXL_OK *fault is untouched. */
fxl_status fxl_scene_check_all(fxl_scene *scene, fxl_scene_fault *fault);

/* Checks the motions of a scene that fxl_scene_check_all has checked: every count, index and range,
 * and that no frame takes an instance out of the world or a scale out of range. fault may be null.
 * The time is linear in the counts.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ALIGNMENT: a table is not aligned to 4 bytes.
 * FXL_E_COUNT: a count is out of its range.
 * FXL_E_INDEX: an index is past the end of its table.
 * FXL_E_RANGE: a number is out of its range.
 * FXL_E_RESERVED: a reserved field or an enumeration has an unknown value.
 * With each of these statuses: *fault written. On FXL_OK *fault is untouched. */
fxl_status fxl_motion_check(const fxl_motion_set *set, const fxl_scene *scene,
                            fxl_scene_fault *fault);

/* Checks the settings of a light: counts, ranges, the length of the direction. fault may be null.
 * FXL_E_ARGUMENT: settings is null.
 * FXL_E_COUNT: point_count or levels is out of range.
 * FXL_E_RANGE: a number is out of its range.
 * FXL_E_NORMAL: the direction is not of unit length.
 * With each of these statuses: *fault written. On FXL_OK *fault is untouched. */
fxl_status fxl_light_check(const fxl_light_settings *settings, fxl_scene_fault *fault);

/* Makes the settings of an image's light, for fxl_attach_light, with the image's ramp. Requires a
 * base that is not null and at most FXL_LIGHT_POINTS_MAX point lights: as fxl_scene_open checks. */
void fxl_light_settings_of(const fxl_scene_light *light, fxl_light_settings *settings);

/* Opens a scene image of size bytes, in place. It checks everything before it uses anything: magic,
 * version, size, checksum, every table, every count, index and range. Of surfaces it checks the
 * tables, and fxl_surfaces_open checks the rest. Nothing is copied: the image must outlive *opened.
 * size may exceed the size that the image states: a flash partition is longer than the image in it.
 * Requires memory aligned to four bytes and a little-endian machine; fault may be null.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ALIGNMENT: the image is not aligned to 4 bytes.
 * FXL_E_SIZE: the image is cut off, or its size is not that of its sections.
 * FXL_E_MAGIC: not a scene image.
 * FXL_E_VERSION: the image is of another version, or needs a section that is not known.
 * FXL_E_CRC: the checksum does not match.
 * FXL_E_OFFSET: a table does not begin where the one before it ends, or reaches outside the image.
 * The statuses of fxl_scene_check_all.
 * With each of these statuses: *opened untouched, *fault written. On FXL_OK *fault is untouched. */
fxl_status fxl_scene_open(const void *image, size_t size, fxl_scene_image *opened,
                          fxl_scene_fault *fault);

/* Whether an instance at a centre, whose model has a radius, may have this placement. Its time does
 * not depend on the model.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: a scale outside FXL_SCALE_MIN..FXL_SCALE_MAX; a radius outside 0..FXL_RADIUS_MAX;
 * or |c| + r > FXL_COORDINATE_MAX for a coordinate c of the centre, where r is scale * radius,
 * rounded up to 1/65536 unit, and 32/65536 unit more.
 * FXL_E_PLACEMENT: rows that are no rotation.
 * All six products of two rows may differ from those of a rotation by less than 2^-28; SPEC.md,
 * section 8.1, has the exact test. A mirror image is no rotation. */
fxl_status fxl_placement_check(const fxl_placement *placement, const fxl_point *centre,
                               fxl_q16_16 radius);

/* Makes the beam that falls through a window from a light at a point, or from a direction. The
 * window is a convex polygon of 3 to FXL_BEAM_PLANES_MAX - 1 corners, in either winding. The beam
 * has a plane for each side, from a corner to the next, in order. After them comes the window's own
 * plane, through its first three corners; the beam begins there, on the side away from the light.
 * Each plane passes exactly through its side's first corner (the window's own through the first).
 * Requires a window of count points. Light and window are in world units, travel is in 2.30.
 * Error: a component of a normal is at most 2 units of 2^-30 from the exact one.
 * Source: "Realtime 3D Clipping" (C6).
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_COUNT: a count outside 3..FXL_BEAM_PLANES_MAX - 1.
 * FXL_E_RANGE: a corner or a point beyond FXL_COORDINATE_MAX, a direction not of unit length.
 * FXL_E_DEGENERATE: the light lies in the plane of the window or of one of its sides, or the
 * window is not convex; all to within 2^-12 unit.
 * With each of these statuses: *beam untouched. */
fxl_status fxl_beam_from_point(const fxl_point *light, const fxl_point *window, uint32_t count,
                               fxl_beam *beam);
fxl_status fxl_beam_from_direction(const fxl_direction *travel, const fxl_point *window,
                                   uint32_t count, fxl_beam *beam);

/* Checks a beam that was written as a table, and changes nothing.
 * FXL_E_ARGUMENT: it is null.
 * FXL_E_RESERVED: its kind is unknown, or an unused member is not 0.
 * FXL_E_COUNT: plane_count is outside 1..FXL_BEAM_PLANES_MAX.
 * FXL_E_RANGE: its point is beyond FXL_COORDINATE_MAX, or a distance is 2^61 or more in magnitude.
 * FXL_E_NORMAL: a normal or a direction is not of unit length. */
fxl_status fxl_beam_check(const fxl_beam *beam);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_scene_reasons[];

#ifdef __cplusplus
}
#endif

#endif
