/* SPDX-License-Identifier: MIT */
#include "quad_scene.h"

#include <math.h>

#include "mapped_quad.h"

static quad_scene made;
static const uint16_t indices[] = {0, 1, 2, 3};
static FXL_ALIGN_8 uint8_t memory[1024];

static fxl_point along(const fxl_direction *side, int32_t length)
{
    const double factor = length / (double)FXL_Q2_30_ONE;
    return (fxl_point){(int32_t)floor(side->x * factor + 0.5),
                       (int32_t)floor(side->y * factor + 0.5),
                       (int32_t)floor(side->z * factor + 0.5)};
}

/* A trapezium in the plane of two rows of a rotation, clockwise against the third. */
static void make_face(quad_scene *quad)
{
    const fxl_orientation plane = unit_orientation();
    const int32_t half = unit_between(Q16(0.5), Q16(8)), high = unit_between(Q16(0.5), Q16(8));
    const int32_t top = half + unit_between(-half / 2, half / 2);
    const fxl_point up = along(&plane.y, high), right = along(&plane.x, half),
                    above = along(&plane.x, top);
    quad->vertices[0] = (fxl_point){up.x - above.x, up.y - above.y, up.z - above.z};
    quad->vertices[1] = (fxl_point){up.x + above.x, up.y + above.y, up.z + above.z};
    quad->vertices[2] = (fxl_point){right.x - up.x, right.y - up.y, right.z - up.z};
    quad->vertices[3] = (fxl_point){-right.x - up.x, -right.y - up.y, -right.z - up.z};
    quad->face =
        (fxl_face){{-plane.z.x, -plane.z.y, -plane.z.z}, 4, QUAD_COLOUR, FXL_INDICES_AT(0, 0)};
    quad->model = (fxl_model){
        .vertex_count = 4, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = Q16(24)};
}

/* An eye that looks at the face's front, from near or far. */
static void make_pose(quad_scene *quad)
{
    const fxl_direction *normal = &quad->face.normal;
    const fxl_point *corner = &quad->vertices[unit_between(0, 3)];
    const fxl_point away = along(normal, unit_between(Q16(0.2), Q16(12)));
    const fxl_direction side = unit_direction();
    const fxl_point aside = along(&side, unit_between(0, Q16(4)));
    quad->pose.position =
        (fxl_point){corner->x / 2 + away.x + aside.x, corner->y / 2 + away.y + aside.y,
                    corner->z / 2 + away.z + aside.z};
    const fxl_point target = {corner->x / 3, corner->y / 3, corner->z / 3};
    (void)fxl_pose_look_at(&quad->pose, &target);
    quad->pose.roll = unit_random();
}

static void make_surface(quad_scene *quad)
{
    quad->surface = (fxl_surface){.opacity = 16};
    quad->mapped = (fxl_mapped_face){.corners = {0, 1, 2}};
    const uint16_t skipped = unit_between(0, 1) ? 1 : 0;
    for (uint16_t i = 0; i < 3; i++) {
        quad->mapped_corners[i].vertex = (uint16_t)(i > 0 ? i + skipped : 0);
        quad->mapped_corners[i].texel =
            (fxl_texel){unit_between(-Q16(100), Q16(100)), unit_between(-Q16(100), Q16(100))};
        quad->mapped_corners[i].normal = (uint16_t)unit_between(0, 3);
    }
    for (uint32_t i = 0; i < 4; i++) {
        quad->normals[i] = unit_between(0, 3) ? quad->face.normal : unit_direction();
    }
    quad->face_map = 1;
    quad->set = quad_surface_set(&quad->texture, &quad->surface, &quad->mapped,
                                 quad->mapped_corners, &quad->face_map);
    quad->set.texture_count = 0;
    quad->set.normals = quad->normals;
    quad->set.normal_count = 4;
}

quad_scene *quad_make(bool turned)
{
    const quad_tables tables = {made.vertices, indices, &made.face, &made.model, &made.instance};
    memset(&made, 0, sizeof made);
    make_face(&made);
    make_pose(&made);
    make_surface(&made);
    made.placement = unit_placement();
    made.scene = quad_tables_scene(&tables, 1);
    if (turned) {
        /* The eye goes with the face: both are seen as they were. */
        made.placement.scale = unit_between(Q16(0.5), Q16(2));
        made.scene.placements = &made.placement;
        made.scene.placement_code = &fxl_turned_instances;
    }
    return &made;
}

/* A vector of the model in the world. */
static exact_vector turned(const quad_scene *quad, exact_vector v, double scale)
{
    const fxl_orientation *to = &quad->placement.orientation;
    if (quad->scene.placements == NULL) {
        return v;
    }
    return (exact_vector){scale * exact_dot(exact_direction(&to->x), v),
                          scale * exact_dot(exact_direction(&to->y), v),
                          scale * exact_dot(exact_direction(&to->z), v)};
}

void quad_begin(quad_scene *quad)
{
    fxl_config config = fxl_config_default(QUAD_WIDTH, QUAD_HEIGHT);
    config.near_z = 4096;
    config.background = QUAD_BACKGROUND;
    const double scale = quad->placement.scale / 65536.0;
    for (uint32_t i = 0; i < 3; i++) {
        quad->corners[i] = turned(
            quad, exact_point(&quad->vertices[quad->mapped_corners[i].vertex], 1.0 / 65536), scale);
        quad->lit[i] =
            turned(quad, exact_direction(&quad->normals[quad->mapped_corners[i].normal]), 1);
    }
    for (uint32_t i = 0; i < 4; i++) {
        quad->outline[i] = turned(quad, exact_point(&quad->vertices[i], 1.0 / 65536), scale);
    }
    if (quad->scene.placements != NULL) {
        /* Seen from the front, from wherever that is now. */
        const exact_vector eye =
            turned(quad, exact_point(&quad->pose.position, 1.0 / 65536), scale);
        const fxl_point target = {0, 0, 0};
        quad->pose.position = (fxl_point){Q16(eye.x), Q16(eye.y), Q16(eye.z)};
        (void)fxl_pose_look_at(&quad->pose, &target);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&quad->scene, NULL));
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_renderer_init(&quad->renderer, &quad->scene, &config, memory, sizeof memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&quad->renderer, &quad->surfaces, &quad->set,
                                                  FXL_SURFACES_OF(fxl_palette)));
}

void quad_light(quad_scene *quad, fxl_light *light, const fxl_light_settings *settings)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&quad->renderer, light, settings));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&quad->renderer, &quad->corner_light));
}

void quad_draw(quad_scene *quad)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&quad->renderer, &quad->pose, quad->frame, QUAD_WIDTH));
}

/* --- definitions -------------------------------------------------------------------------- */

static exact_vector cross(exact_vector a, exact_vector b)
{
    return (exact_vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static double focal_of(const quad_scene *quad)
{
    return quad->renderer.frame.view.lens.focal / 65536.0;
}

/* A point of the world in the view. */
static exact_vector in_view(const quad_scene *quad, exact_vector point)
{
    const fxl_camera *camera = &quad->renderer.frame.view.camera;
    const exact_vector from = exact_minus(point, exact_point(&camera->position, 1.0 / 65536));
    return (exact_vector){exact_dot(exact_direction(&camera->axes.right), from),
                          exact_dot(exact_direction(&camera->axes.up), from),
                          exact_dot(exact_direction(&camera->axes.forward), from)};
}

double quad_value(const quad_scene *quad, int x, int y, const double a[3], double *weight)
{
    const exact_vector way = {x + 0.5 - QUAD_WIDTH / 2.0, QUAD_HEIGHT / 2.0 - y - 0.5,
                              focal_of(quad)};
    const exact_vector p = in_view(quad, quad->corners[0]);
    const exact_vector e1 = exact_minus(in_view(quad, quad->corners[1]), p),
                       e2 = exact_minus(in_view(quad, quad->corners[2]), p);
    const exact_vector n = cross(e1, e2);
    const double below = exact_dot(n, way);
    *weight = fabs(below) / sqrt(exact_dot(n, n) * exact_dot(way, way));
    return a[0] + (a[1] - a[0]) * (exact_dot(cross(e2, p), way) / below) +
           (a[2] - a[0]) * (exact_dot(cross(p, e1), way) / below);
}

bool quad_affine_value(const quad_scene *quad, int x, int y, const double a[3], double *value)
{
    double sx[3], sy[3];
    for (int i = 0; i < 3; i++) {
        const exact_vector p = in_view(quad, quad->corners[i]);
        sx[i] = QUAD_WIDTH / 2.0 + focal_of(quad) * p.x / p.z;
        sy[i] = QUAD_HEIGHT / 2.0 - focal_of(quad) * p.y / p.z;
        if (p.z < 1.0 / 64 || sx[i] < 0.01 || sx[i] > QUAD_WIDTH - 0.01 || sy[i] < 0.01 ||
            sy[i] > QUAD_HEIGHT - 0.01) {
            return false;
        }
    }
    const double x1 = sx[1] - sx[0], y1 = sy[1] - sy[0], x2 = sx[2] - sx[0], y2 = sy[2] - sy[0];
    const double px = x + 0.5 - sx[0], py = y + 0.5 - sy[0], area = x1 * y2 - x2 * y1;
    *value = a[0] + (a[1] - a[0]) * (px * y2 - py * x2) / area +
             (a[2] - a[0]) * (x1 * py - y1 * px) / area;
    return fabs(area) > 20;
}

double quad_texels(const quad_scene *quad)
{
    const fxl_texel t[3] = {quad->mapped_corners[0].texel, quad->mapped_corners[1].texel,
                            quad->mapped_corners[2].texel};
    const double texel = 1.0 / 65536;
    const double area = fabs(((double)t[1].u - t[0].u) * ((double)t[2].v - t[0].v) -
                             ((double)t[2].u - t[0].u) * ((double)t[1].v - t[0].v)) *
                        texel * texel;
    exact_vector p[3];
    for (int i = 0; i < 3; i++) {
        p[i] = in_view(quad, quad->corners[i]);
    }
    const double volume =
        fabs(exact_dot(cross(exact_minus(p[1], p[0]), exact_minus(p[2], p[0])), p[0]));
    double z = INFINITY;
    for (int i = 0; i < 4; i++) {
        z = fmin(z, in_view(quad, quad->outline[i]).z);
    }
    return z <= 0 ? 0 : area * z * z * z / (focal_of(quad) * focal_of(quad) * volume);
}
