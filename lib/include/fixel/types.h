/* SPDX-License-Identifier: MIT */
/* Number formats, ranges, statuses, and the records between the stages. */
#ifndef FXL_TYPES_H
#define FXL_TYPES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fixel/config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Number formats and the ranges of every public input.
 *
 * The name of a type states its format: fxl_q16_16 has 16 bits before and
 * 16 after the binary point. Signed types are two's complement. Rounding is to
 * nearest with halves upward, floor(x + 1/2), unless a bound says otherwise.
 * SPEC.md, section 3, gives the reasons for the ranges.
 */

/* A cast, an assertion of the compiler's, and an object's alignment to 8 bytes, as C and C++
 * each have them. */
#ifdef __cplusplus
#define FXL_CAST(type, value) static_cast<type>(value)
#define FXL_STATIC_ASSERT     static_assert
#define FXL_ALIGN_8           alignas(8)
#else
#define FXL_CAST(type, value) ((type)(value))
#define FXL_STATIC_ASSERT     _Static_assert
#define FXL_ALIGN_8           _Alignas(8)
#endif

/* Here, so that it is the first thing that a compiler for AVR says. Shifts such as 1u << 30,
 * 1 << 26 and width << 16, and products such as width * 32768u, are computed in int or unsigned. */
FXL_STATIC_ASSERT(sizeof(int) >= 4, "needs an int of at least 32 bits");

/* Stands before the definition of a table in a header that the tools wrote. Each file that includes
 * the header defines the table, and the linker keeps one of them. With another compiler exactly one
 * file of a program may define the tables; the header says how the others declare them. */
#if defined __GNUC__ && defined __cplusplus
#define FXL_SHARED \
    extern __attribute__((weak)) /* without extern, C++ keeps a constant to its file */
#elif defined __GNUC__
#define FXL_SHARED __attribute__((weak))
#elif defined _MSC_VER
#define FXL_SHARED __declspec(selectany)
#elif defined __IAR_SYSTEMS_ICC__
#define FXL_SHARED __weak
#else
#define FXL_SHARED
#endif

/* Stands before the definition of a function that no frame calls, such as a check of a scene, or
 * calls once, such as a player's step, or once for an object that moves: the compiler makes it, and
 * what it alone calls, for few bytes. */
#if defined __GNUC__ && !defined __OPTIMIZE_SIZE__
#define FXL_COLD __attribute__((cold))
#else
#define FXL_COLD
#endif

typedef int32_t fxl_q16_16; /* world units, pixels, texels; unit 1/65536 */
typedef int32_t fxl_q2_30;  /* components of unit vectors, sines; unit 2^-30 */
typedef uint32_t fxl_q1_31; /* fractions 0..1 inclusive; unit 2^-31 */
typedef int64_t fxl_q18_46; /* exact products q16_16 x q2_30 and their sums */
typedef uint32_t fxl_angle; /* binary angle; a full turn is 2^32, wraps */

#define FXL_Q16_16_ONE FXL_CAST(fxl_q16_16, 65536)
#define FXL_Q2_30_ONE  FXL_CAST(fxl_q2_30, 1073741824)
#define FXL_Q1_31_ONE  FXL_CAST(fxl_q1_31, 2147483648u)

/* 90 degrees. */
#define FXL_ANGLE_QUARTER FXL_CAST(fxl_angle, 0x40000000u)

/* Constants of a program. They are integer constant expressions if their arguments are, and use no
 * floating-point number. They evaluate an argument more than once.
 *
 * n world units, |n| <= 32767. Exact. */
#define FXL_UNITS(n) FXL_CAST(fxl_q16_16, FXL_CAST(int32_t, n) * 65536)
/* n / d world units, to the nearest 1/65536, halves upward. Requires d > 0, |n|, d < 2^31 and
 * a result within +-32767. */
#define FXL_RATIO(n, d) \
    FXL_CAST(fxl_q16_16, \
             FXL_DIVIDE_FLOOR(131072 * FXL_CAST(int64_t, n) + (d), 2 * FXL_CAST(int64_t, d)))
/* n degrees as a binary angle, to the nearest 2^-32 turn, halves upward. Requires |n| < 2^29. */
#define FXL_DEGREES(n) \
    FXL_CAST(fxl_angle, \
             FXL_CAST(uint64_t, FXL_DIVIDE_FLOOR(FXL_CAST(int64_t, n) * 8589934592 + 360, 720)) & \
                 0xFFFFFFFFu)
/* floor(n / d). Requires d > 0. */
#define FXL_DIVIDE_FLOOR(n, d) ((n) >= 0 ? (n) / (d) : -((-(n) + (d)-1) / (d)))

/* World coordinates of vertices, centres of instances and the eye: |c| <= 8191.
 * Then a difference of two is below 2^30 units, a sum of three products with
 * a unit vector is below 2^61, and a squared distance is below 2^62. */
#define FXL_COORDINATE_MAX FXL_CAST(fxl_q16_16, 8191 * 65536)

/* A model's vertices lie within 2 * 8191 of its origin in each coordinate, so
 * no radius needs to be larger than sqrt(3) * 16382 = 28374.5. */
#define FXL_RADIUS_MAX FXL_CAST(fxl_q16_16, 28375 * 65536)

/* Screen width and height in pixels: 1..1024. */
#define FXL_SCREEN_MAX 1024

/* Horizontal field of view: 10..150 degrees, which are FXL_DEGREES(10) and FXL_DEGREES(150). */
#define FXL_FOV_MIN FXL_CAST(fxl_angle, 119304647u)
#define FXL_FOV_MAX FXL_CAST(fxl_angle, 1789569707u)

/* Pixels a world unit of an orthographic lens: 1/16..4096. */
#define FXL_ORTHOGRAPHIC_SCALE_MIN FXL_CAST(fxl_q16_16, 4096)
#define FXL_ORTHOGRAPHIC_SCALE_MAX FXL_CAST(fxl_q16_16, 4096 * 65536)

/* How far the centre of an orthographic lens may be from the middle of the screen in x and y: 1536
 * pixels. */
#define FXL_ORTHOGRAPHIC_CENTRE_MAX FXL_CAST(fxl_q16_16, 1536 * 65536)

/* In world units. Near plane: 1/256 at least. Far plane: 32767 at most. Inset: 0..1. */
#define FXL_NEAR_MIN  FXL_CAST(fxl_q16_16, 256)
#define FXL_FAR_MAX   FXL_CAST(fxl_q16_16, 32767 * 65536)
#define FXL_INSET_MAX FXL_Q16_16_ONE
/* The Black Book's chapter 65 has an inset (its epsilon) of 0.0001. Fixel needs none. Without an
 * inset, a vertex that the clipper makes lies less than 128/65536 pixel beyond the border of the
 * screen with any lens, and less than 3/65536 pixel with a lens of a usual aspect. An inset leaves
 * a border of background if focal * inset * sqrt(1 + (width / 2 focal)^2) / near is above
 * 1/2 pixel. */
#define FXL_INSET_DEFAULT FXL_CAST(fxl_q16_16, 0)

/* Screen coordinates that project returns and scan accepts: |c| <= 4095 pixels.
 * A vertex inside the frustum lies on the screen. The rest of the range is a
 * margin for the clipper's rounding at the smallest near plane. */
#define FXL_SCREEN_COORDINATE_MAX FXL_CAST(fxl_q16_16, 4095 * 65536)

/* The most vertices of a face that this build draws: 24 with the default capacity.
 * Each of six planes adds at most one vertex to a convex polygon. The other two of
 * the 8 are for polygons that rounding made slightly concave. */
#define FXL_FACE_VERTICES_MAX (FXL_POLYGON_CAPACITY - 8)

/* The largest distance of a face's vertex from the plane through the face's first
 * vertex with the face's stated normal, in units of 1/65536. The largest difference
 * of the squared length of that normal from 1, in units of 2^-60. */
#define FXL_PLANARITY_MAX           FXL_CAST(fxl_q16_16, 4)
#define FXL_NORMAL_SQUARE_MAX_ERROR (FXL_CAST(int64_t, 1) << 32)

/* The result of a public function. If the input is wrong, the function returns a
 * status other than FXL_OK. Its documentation says what it has changed then: most
 * functions nothing, but for the count of refused calls. A bug of the library
 * itself is an assertion (FXL_ASSERT in lib/math/arith.h). */
typedef enum {
    FXL_OK = 0,        /* the function has done what it promises */
    FXL_E_ARGUMENT,    /* a null pointer, or a count of zero where at least one is needed */
    FXL_E_RANGE,       /* a number outside its stated range */
    FXL_E_CAPACITY,    /* the caller's memory, or a capacity set at build, is too small */
    FXL_E_DEGENERATE,  /* fewer than three vertices */
    FXL_E_ORDER,       /* a call out of order: draw before begin */
    FXL_E_ALIGNMENT,   /* memory, an image or an offset that is not aligned as it must be */
    FXL_E_SIZE,        /* an image that is cut off, or not as long as its sections */
    FXL_E_MAGIC,       /* not a scene image */
    FXL_E_VERSION,     /* a scene image, or a section that it needs, of another version */
    FXL_E_CRC,         /* the checksum does not match */
    FXL_E_OFFSET,      /* a table of an image in no place for it, or too long */
    FXL_E_COUNT,       /* a count outside its stated range */
    FXL_E_INDEX,       /* past the end of a table, or not the entry that must follow */
    FXL_E_NORMAL,      /* a normal that is not of unit length */
    FXL_E_PLANARITY,   /* a face vertex off the plane of its face or BSP node */
    FXL_E_RESERVED,    /* a reserved field or an enumeration holds an unknown value */
    FXL_E_RADIUS,      /* a vertex or a sphere outside the sphere that must hold it */
    FXL_E_FACE_BOUNDS, /* a face's bounds differ from those of its vertices and its normal */
    FXL_E_BSP,         /* no tree, too deep a tree, or an instance that may not be with it */
    FXL_E_CLUSTER,     /* the front of a cluster's face may be seen from the cluster's cone */
    FXL_E_PLACEMENT,   /* an orientation that is no rotation */
    FXL_E_DISPLAY,     /* a display, or the wires to it, failed */
    FXL_E_STALE,       /* the handle of an instance that was removed, or that never was */
    FXL_E_COMBINATION, /* two things that a renderer has do not go together */
    FXL_STATUS_COUNT
} fxl_status;

/* Describes a status in one English sentence. Never null, not even for an unknown value. */
const char *fxl_status_text(fxl_status status);

/* What a call was refused for: an English sentence that names the arguments which answer this status,
 * with their ranges, or what must come before. reasons is fxl_H_reasons, which fixel/H.h declares for
 * its functions: fxl_explain(fxl_light_reasons, status) after fxl_attach_light. The sentence is
 * constant, and a program links those of the headers that it names so. Returns null for FXL_OK, for a
 * status that no function of the header answers, and where reasons is null. For the most used calls
 * fxl_renderer_explain and its neighbours (fixel/render.h) look at the arguments themselves. */
const char *fxl_explain(const char *reasons, fxl_status status);

/* The records between the stages: the interface of every stage.
 *
 *   scene -> cull -> transform -> fxl_cached_vertex -> clip -> fxl_view_polygon ->
 *   project -> fxl_screen_polygon -> display list -> scan -> fxl_trapezoid -> fill ->
 *   fxl_band
 *
 * A target that decides by spans takes the same pixels from scan as
 * fxl_span instead, and gives spans to fill.
 *
 * If all vertices of a face are inside the frustum, the projected vertices are
 * the polygon; there is no fxl_view_polygon. The Black Book's clipper comes before
 * the transform: cull -> fxl_polygon -> clip -> fxl_polygon -> transform. All
 * clippers share one interface from a face to the screen: fxl_clipper, in records.h.
 *
 * Axes: x right, y up, z forward, left-handed, in the world and in the view.
 * On the screen x goes right and y goes DOWN; pixel (i, j) covers
 * [i, i+1) x [j, j+1) and its centre is (i + 1/2, j + 1/2).
 */

/* A point of the world, in world units. */
typedef struct {
    fxl_q16_16 x, y, z;
} fxl_point;

/* A unit vector, or a row of a rotation. */
typedef struct {
    fxl_q2_30 x, y, z;
} fxl_direction;

/* A rotation from a model's axes to the world's. A point v of the model is (x . v, y . v, z . v)
 * along the world's axes: the rows are the world's axes as the model sees them. */
typedef struct {
    fxl_direction x, y, z;
} fxl_orientation;

/* The scale of an instance that is turned: 1/256..256. */
#define FXL_SCALE_MIN FXL_CAST(fxl_q16_16, 256)
#define FXL_SCALE_MAX FXL_CAST(fxl_q16_16, 256 * 65536)

/* How an instance is turned and scaled: its point v is at centre + scale * (orientation . v). */
typedef struct {
    fxl_orientation orientation;
    fxl_q16_16 scale; /* FXL_SCALE_MIN..FXL_SCALE_MAX */
} fxl_placement;

/* An initialiser of an fxl_orientation that turns nothing, and one of an fxl_placement that neither
 * turns nor scales. */
#define FXL_ORIENTATION_NONE \
    { \
        {FXL_Q2_30_ONE, 0, 0}, {0, FXL_Q2_30_ONE, 0}, \
        { \
            0, 0, FXL_Q2_30_ONE \
        } \
    }
#define FXL_PLACEMENT_NONE \
    { \
        FXL_ORIENTATION_NONE, FXL_Q16_16_ONE \
    }

/* A plane. A point is inside it if normal . point >= distance; the normal points
 * inside. The distance is exact. Source: A1, A2 (Listing 65.1). */
typedef struct {
    fxl_direction normal;
    fxl_q18_46 distance;
} fxl_plane;

/* Position and direction of the eye. Yaw turns from +z towards +x, then
 * pitch raises the view towards +y, then roll turns the view's right side
 * towards its up side. */
typedef struct {
    fxl_point position;
    fxl_angle yaw, pitch, roll;
} fxl_pose;

/* What a view needs of an off-centre or an orthographic lens (fixel/camera.h). Members are internal. */
typedef struct fxl_off_centre_code fxl_off_centre_code;

/* The screen, and the part of the world that it shows. fxl_lens_from_fov makes one. Its centre is
 * the middle of the screen; fxl_lens_set_centre moves it. fxl_lens_orthographic makes one whose
 * focal length is its scale. */
typedef struct {
    uint16_t width, height;        /* pixels */
    fxl_q16_16 focal;              /* pixels: screen x = centre_x + focal * X / Z */
    fxl_q16_16 near_z, far_z;      /* world units along forward */
    fxl_q16_16 inset;              /* world units that every plane of the frustum moves inward */
    fxl_q16_16 centre_x, centre_y; /* pixels, y down: the point of the screen straight ahead */
    /* Null: the centre is the middle of the screen, and the lens has an eye. */
    const fxl_off_centre_code *off_centre;
} fxl_lens;

/* A vertex of a polygon in the world. u and v are texture coordinates in texels,
 * |u|, |v| <= 16383. */
typedef struct {
    fxl_point position;
    fxl_q16_16 u, v;
} fxl_vertex;

/* A polygon of the world: input and output of a clipper in the world. */
typedef struct {
    uint8_t colour; /* palette index */
    uint8_t count;  /* 3..FXL_POLYGON_CAPACITY */
    bool textured;  /* if false, u and v are neither read nor written */
    fxl_vertex vertices[FXL_POLYGON_CAPACITY];
} fxl_polygon;

/* A point relative to the eye, along right, up and forward, in units of 2^-46
 * world unit. Each coordinate is below 2^61. Where the lens is off-centre, right and up are those
 * of the sheared view (SPEC.md, section 4.2). */
typedef struct {
    fxl_q18_46 x, y, z;
} fxl_view_point;

/* A vertex of a polygon of the view. */
typedef struct {
    fxl_view_point position;
} fxl_view_vertex;

/* A polygon of the view: input and output of a clipper in the view, input of project. */
typedef struct {
    uint8_t colour;
    uint8_t count;
    fxl_view_vertex vertices[FXL_POLYGON_CAPACITY];
} fxl_view_polygon;

/* The outcome of clipping a polygon. Only an fxl_clipper returns the last two. */
typedef enum {
    FXL_CLIP_INSIDE,     /* wholly inside: the input is the result */
    FXL_CLIP_CUT,        /* cut: the result is in the output */
    FXL_CLIP_OUTSIDE,    /* no vertex inside */
    FXL_CLIP_DEGENERATE, /* fewer than three vertices left */
    FXL_CLIP_CAPACITY,   /* refused: more than FXL_POLYGON_CAPACITY vertices */
    FXL_CLIP_RANGE,      /* refused: a coordinate beyond FXL_SCREEN_COORDINATE_MAX */
    FXL_CLIP_BETWEEN     /* inside, and it covers no pixel centre */
} fxl_clip_result;

/* A setting of a clipper, and what the clipper counts. */
typedef struct {
    /* The sliver rule: a vertex that is less than this far inside a plane counts as
     * outside if the vertex before it counts as outside. 0 turns the rule off. In
     * the unit of the plane's distances, below 2^62. With the rule, neighbours that
     * share an edge may be apart by as much. Source: C3. */
    fxl_q18_46 sliver;
    uint32_t intersections; /* intersections computed since the caller set it to 0 */
    uint32_t distances;     /* distances computed by products since then, those of outcodes too */
} fxl_clip_stats;

/* A point of the screen in pixels, y down. */
typedef struct {
    fxl_q16_16 x, y;
} fxl_screen_point;

/* place pixel-format: if pixels are neither bytes nor RGB565: fxl_band */
/* A polygon of the screen: output of project, input of the display list and of scan. */
typedef struct {
    uint8_t colour;
    uint8_t count;
    uint8_t kind;  /* how it is filled: FXL_POLYGON_FLAT and so on */
    uint8_t shade; /* RGB565: 256ths that light takes of the colour; else 0 */
    fxl_screen_point points[FXL_POLYGON_CAPACITY];
} fxl_screen_polygon;

enum {
    FXL_POLYGON_FLAT = 0,    /* one colour */
    FXL_POLYGON_SURFACE = 1, /* a surface (fixel/surfaces.h) */
    FXL_POLYGON_SPRITE = 2,  /* a sprite (fixel/billboards.h) */
    FXL_POLYGON_DEPTH = 3,   /* one colour, with a depth */
    FXL_POLYGON_LINE = 4     /* a line (fixel/lines.h) */
};

/* The rows first <= row < end. No rows if the two are equal. */
typedef struct {
    uint16_t first, end;
} fxl_rows;

/* An edge on a row's line of pixel centres, and its step to the next row. Both are
 * 32.32 numbers. x is the row's first pixel whose centre is not left of the edge.
 * The record holds for the rows of its trapezoid, and x is exact on each of them. */
typedef struct {
    int32_t x;
    uint32_t fraction;
    int32_t step; /* pixels a row */
    uint32_t step_fraction;
} fxl_edge;

/* Output of scan, input of fill: the rows first_row .. end_row - 1 between two
 * edges. A row has the pixels from the smaller x (included) to the larger x (not
 * included). Which of the two edges has the smaller x may change from row to row.
 * Both x lie within 0..width of the band on every row. */
typedef struct {
    int16_t first_row, end_row; /* first_row < end_row, within the band */
    fxl_edge edges[2];          /* on first_row */
} fxl_trapezoid;

/* Pixels x0 <= x < x1 of row y: one row of a trapezoid. Never empty, never outside
 * the band. */
typedef struct {
    int16_t y, x0, x1;
} fxl_span;

/* A rectangle of the frame, or the whole frame: rows first_row .. first_row + rows - 1, and all
 * columns, or columns first_column .. first_column + columns - 1; one byte a pixel. The first pixel
 * of row first_row is pixels[0], that of the next row is pixels[stride]. The caller owns the
 * pixels. Those outside of the rectangle are neither read nor written. */
typedef struct {
    uint8_t *pixels;
    uint16_t width;  /* of the frame, 1..FXL_SCREEN_MAX */
    uint16_t stride; /* in pixels, at least those of a row */
    uint16_t first_row;
    uint16_t rows;           /* >= 1; first_row + rows <= screen height */
    const uint16_t *palette; /* null; of 16 bits a pixel: 256 colours, and pixels are uint16_t */
    uint16_t first_column;
    uint16_t columns; /* first_column + columns <= width; 0: all, and first_column is 0 */
} fxl_band;

/* A rectangle of the frame, in whole pixels. */
typedef struct {
    uint16_t first_column, columns;
    uint16_t first_row, rows;
} fxl_screen_box;

/* What happened to the faces of a frame. Each face is counted once:
 * in == backfacing + outside + degenerate + refused + drawn. */
typedef struct {
    uint32_t in;            /* faces of the scene */
    uint32_t backfacing;    /* culled: turned away from the eye */
    uint32_t outside;       /* culled: wholly outside one plane, with their instance or alone */
    uint32_t degenerate;    /* culled: fewer than three vertices left */
    uint32_t refused;       /* too many vertices, or a screen coordinate out of range */
    uint32_t drawn;         /* reached the screen (the face may still cover no pixel centre) */
    uint32_t clipped;       /* of those drawn: cut by at least one plane */
    uint32_t refused_calls; /* public calls that returned an error */
    uint32_t spilled;       /* of those drawn: not in the display list, computed for every band */
    uint16_t split_bands;   /* bands, or parts of bands, drawn again in halves, or
                               in parts; 65535: or more */
    uint16_t rounded;       /* turned instances in sight whose points were rounded in the world */
} fxl_counters;

/* --- sines ------------------------------------------------------------------------------ */

/* The sine of an angle, as 2.30. Takes any angle. sin(-a) == -sin(a) for every a.
 * Error: at most 0.51 unit of 2^-30 (docs/accuracy.md, section 1; the report claims 1); exact at
 * the quarter turns. Source: the Taylor series, in lib/math/angle.c. */
fxl_q2_30 fxl_sin(fxl_angle angle);

/* The cosine of an angle, as 2.30: fxl_sin(angle + FXL_ANGLE_QUARTER). Takes any angle.
 * Error and source: as fxl_sin. */
fxl_q2_30 fxl_cos(fxl_angle angle);

#ifdef __cplusplus
}
#endif

#endif
