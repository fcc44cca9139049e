/* SPDX-License-Identifier: MIT */
#include "reference/frustum.h"

#include <math.h>
#include <string.h>
#include <stddef.h>

#include "reference/cull.h"
#include "reference/placement.h"

static long double dot(const ref_point *a, const ref_point *b)
{
    return (long double)a->x * b->x + (long double)a->y * b->y + (long double)a->z * b->z;
}

ref_plane ref_plane_from_point(const ref_point *point, const ref_point *normal, double inset)
{
    return (ref_plane){.normal = *normal, .distance = dot(normal, point) + inset};
}

long double ref_plane_distance(const ref_plane *plane, const ref_point *point)
{
    return dot(&plane->normal, point) - plane->distance;
}

/* The products of whole numbers of 1/65536 unit have 60 bits, so they and their differences are
 * exact in 64. */
bool ref_plane_from_points(const ref_point *a, const ref_point *b, const ref_point *c,
                           ref_plane *plane)
{
    const long double ux = b->x - a->x, uy = b->y - a->y, uz = b->z - a->z;
    const long double vx = c->x - a->x, vy = c->y - a->y, vz = c->z - a->z;
    const long double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    const long double length = sqrtl(x * x + y * y + z * z);
    if (length == 0) {
        return false;
    }
    const ref_point normal = {(double)(x / length), (double)(y / length), (double)(z / length)};
    *plane = ref_plane_from_point(a, &normal, 0);
    return true;
}

/* Makes the plane whose normal has the view coordinates (x, y, z), before scaling to unit
 * length, and which passes through (0, 0, depth). */
static ref_plane view_plane(const ref_camera *camera, double x, double y, double z, double depth,
                            double inset)
{
    double length = sqrt(x * x + y * y + z * z);
    const ref_point *r = &camera->right, *u = &camera->up, *f = &camera->forward;
    ref_point normal = {(r->x * x + u->x * y + f->x * z) / length,
                        (r->y * x + u->y * y + f->y * z) / length,
                        (r->z * x + u->z * y + f->z * z) / length};
    ref_point through = {camera->position.x + f->x * depth, camera->position.y + f->y * depth,
                         camera->position.z + f->z * depth};
    return ref_plane_from_point(&through, &normal, inset);
}

/* Borders on the screen, in pixels from its upper left corner. */
typedef struct {
    double left, right, top, bottom;
} ref_sides;

/* Makes the four planes through the eye, if there is one, and these borders. A border at x is centre_x + focal X / Z,
 * so X along focal and Z along x - centre_x. */
static void set_sides(const ref_camera *camera, const ref_lens *lens, const ref_sides *sides,
                      ref_plane planes[REF_PLANE_COUNT])
{
    double focal = lens->focal, inset = lens->inset;
    double x = lens->centre_x, y = lens->centre_y;
    if (lens->scale != 0) { /* parallel to forward */
        const double scale = lens->scale;
        planes[REF_PLANE_LEFT] = view_plane(camera, 1, 0, 0, 0, (sides->left - x) / scale);
        planes[REF_PLANE_RIGHT] = view_plane(camera, -1, 0, 0, 0, (x - sides->right) / scale);
        planes[REF_PLANE_BOTTOM] = view_plane(camera, 0, 1, 0, 0, (y - sides->bottom) / scale);
        planes[REF_PLANE_TOP] = view_plane(camera, 0, -1, 0, 0, (sides->top - y) / scale);
        return;
    }
    planes[REF_PLANE_LEFT] = view_plane(camera, focal, 0, x - sides->left, 0, inset);
    planes[REF_PLANE_RIGHT] = view_plane(camera, -focal, 0, sides->right - x, 0, inset);
    planes[REF_PLANE_BOTTOM] = view_plane(camera, 0, focal, sides->bottom - y, 0, inset);
    planes[REF_PLANE_TOP] = view_plane(camera, 0, -focal, y - sides->top, 0, inset);
}

ref_frustum ref_frustum_with_guard(const ref_camera *camera, const ref_lens *lens, unsigned cuts,
                                   double pixels)
{
    double middle_x = lens->width / 2.0, middle_y = lens->height / 2.0;
    ref_lens guard = *lens;
    guard.inset = 0;
    ref_frustum frustum = ref_frustum_from_camera(camera, lens);
    ref_sides sides = {.left = middle_x - pixels,
                       .right = middle_x + pixels,
                       .top = middle_y - pixels,
                       .bottom = middle_y + pixels};
    ref_plane wide[REF_PLANE_COUNT];
    set_sides(camera, &guard, &sides, wide);
    for (int plane = REF_PLANE_LEFT; plane <= REF_PLANE_TOP; plane++) {
        if ((cuts >> plane & 1) == 0) {
            frustum.planes[plane] = wide[plane];
        }
    }
    return frustum;
}

ref_frustum ref_frustum_from_camera(const ref_camera *camera, const ref_lens *lens)
{
    double inset = lens->inset;
    ref_sides screen = {.right = lens->width, .bottom = lens->height};
    ref_frustum frustum;
    set_sides(camera, lens, &screen, frustum.planes);
    frustum.planes[REF_PLANE_NEAR] = view_plane(camera, 0, 0, 1, lens->near_z, inset);
    frustum.planes[REF_PLANE_FAR] = view_plane(camera, 0, 0, -1, lens->far_z, inset);
    return frustum;
}

/* --- clippers ----------------------------------------------------------------------------------- */

#define DEPTHS (1u << REF_PLANE_NEAR | 1u << REF_PLANE_FAR)

/* place clipper: which sides each clipper cuts */
static const struct {
    const char *name;
    unsigned planes;
    bool by_points;
} clippers[] = {
    {"view", REF_CUT_ALL, false},
    {"world", REF_CUT_ALL, true},
    {"normalised", REF_CUT_ALL, true},
    {"once", REF_CUT_ALL, true},
    {"half-spaces", REF_CUT_ALL, true},
    /* It clips to the borders of the screen, and so does the scan. */
    {"triangles", DEPTHS, false},
    {"near", DEPTHS, false},
    {"near-box", DEPTHS, false},
    {"left", DEPTHS | 1u << REF_PLANE_LEFT, false},
};

bool ref_take_clipper(const char *name, void *method)
{
    ref_method *of = method;
    for (size_t i = 0; i < sizeof clippers / sizeof *clippers; i++) {
        if (strcmp(name, clippers[i].name) == 0) {
            of->cuts = clippers[i].planes;
            of->by_points = clippers[i].by_points;
            return true;
        }
    }
    return false;
}

static const struct {
    const char *name;
    bool by_bsp, flat;
    int depth_bits;
} methods[] = {
    {"sorted", false, true, 0},    {"box", false, true, 0},     {"spans", false, true, 0},
    {"spans-box", false, true, 0}, {"tree", true, true, 0},     {"tree-spans", true, true, 0},
    {"surfaces", false, false, 0}, {"depth", false, false, 16}, {"depth-32", false, false, 32}};

bool ref_take_visibility(const char *name, void *method)
{
    ref_method *of = method;
    of->is_asked = true;
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        if (strcmp(methods[i].name, name) == 0) {
            of->by_bsp = methods[i].by_bsp;
            of->flat = methods[i].flat;
            of->depth_bits = methods[i].depth_bits;
            return true;
        }
    }
    return false;
}

/* --- what is not drawn -------------------------------------------------------------------------- */

bool ref_face_is_front(const ref_scene *scene, const ref_instance *instance, const ref_face *face,
                       const ref_lattice_point *eye)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    if (placement) {
        const ref_lattice_point corner = ref_face_corner(scene, instance, face, 0);
        return ref_placement_is_front(placement, &instance->centre, eye, face->normal, &corner);
    }
    ref_lattice_point first = ref_face_vertex(scene, instance, face, 0);
    ref_exact sum = (ref_exact)face->normal[0] * ((int64_t)eye->x - first.x) +
                    (ref_exact)face->normal[1] * ((int64_t)eye->y - first.y) +
                    (ref_exact)face->normal[2] * ((int64_t)eye->z - first.z);
    return sum > 0;
}

bool ref_face_shows_front(const ref_scene *scene, const ref_instance *instance,
                          const ref_face *face, const ref_lattice_point *eye,
                          const ref_camera *camera)
{
    int32_t ahead[3];
    if (!camera->has_no_eye) {
        return ref_face_is_front(scene, instance, face, eye);
    }
    ref_direction_in_model(scene, instance, camera->forward_30, ahead);
    return (ref_exact)face->normal[0] * ahead[0] + (ref_exact)face->normal[1] * ahead[1] +
               (ref_exact)face->normal[2] * ahead[2] <
           0;
}

void ref_face_to_polygon(const ref_scene *scene, const ref_instance *instance, const ref_face *face,
                         bool rounded, ref_polygon *polygon)
{
    const ref_placement *placement = rounded ? NULL : ref_placement_of(scene, instance);
    polygon->colour = face->material;
    polygon->count = face->count;
    for (int i = 0; i < face->count; i++) {
        if (placement) {
            const ref_lattice_point corner = ref_face_corner(scene, instance, face, i);
            polygon->vertices[i] = (ref_vertex){
                .position = ref_placement_point(placement, &instance->centre, &corner)};
        } else {
            const ref_lattice_point vertex = ref_face_vertex(scene, instance, face, i);
            polygon->vertices[i] = (ref_vertex){.position = ref_point_from_lattice(&vertex)};
        }
    }
}

uint32_t ref_box_planes(const ref_frustum *frustum, const ref_point *least, const ref_point *most)
{
    uint32_t crossed = 0;
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        int outside = 0, inside = 0;
        for (int corner = 0; corner < 8; corner++) {
            ref_point at = {corner & 1 ? most->x : least->x, corner & 2 ? most->y : least->y,
                            corner & 4 ? most->z : least->z};
            long double distance = ref_plane_distance(&frustum->planes[i], &at);
            outside += distance < -0x1p-9L;
            inside += distance >= 0x1p-9L;
        }
        if (outside == 8) {
            return 1u << REF_PLANE_COUNT;
        }
        crossed |= inside == 8 ? 0 : 1u << i;
    }
    return crossed;
}

ref_sphere_distances ref_sphere_measure(const ref_camera *camera, const ref_view_frustum *frustum,
                                        const ref_point *centre)
{
    ref_sphere_distances distances;
    ref_view_point view_point = ref_transform_point(camera, centre);
    for (int plane = 0; plane < REF_PLANE_COUNT; plane++) {
        distances.inside[plane] = ref_view_distance(&frustum->planes[plane], &view_point);
    }
    return distances;
}

uint32_t ref_sphere_planes(const ref_sphere_distances *distances, double radius)
{
    double reach = radius + REF_SPHERE_SLACK;
    uint32_t crossed = 0;
    for (int plane = 0; plane < REF_PLANE_COUNT; plane++) {
        if (distances->inside[plane] < -reach) {
            return REF_SPHERE_OUTSIDE;
        }
        crossed |= distances->inside[plane] < reach ? 1u << plane : 0;
    }
    return crossed;
}
