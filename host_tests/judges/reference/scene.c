/* SPDX-License-Identifier: MIT */
#include "reference/scene.h"

#include "reference/horizon.h"
#include "reference/sections.h"
/* place field: the reference's reader: sizes of entries, and offsets as numbers */
#include "reference/billboard.h"
#include "reference/surface.h"
#include "reference/wire.h"
#include "reference/placement.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

uint16_t ref_u16(const uint8_t *bytes)
{
    return (uint16_t)(bytes[0] | bytes[1] << 8);
}

uint32_t ref_u32(const uint8_t *bytes)
{
    return ref_u16(bytes) | (uint32_t)ref_u16(bytes + 2) << 16;
}

int32_t ref_i32(const uint8_t *bytes)
{
    uint32_t value = ref_u32(bytes);
    return value < 0x80000000u ? (int32_t)value : (int32_t)((int64_t)value - INT64_C(0x100000000));
}

uint32_t ref_crc32(uint32_t crc, const uint8_t *bytes, size_t size)
{
    uint32_t table[256];
    for (uint32_t i = 0; i < 256; i++) {
        uint32_t entry = i;
        for (int bit = 0; bit < 8; bit++) {
            entry = entry >> 1 ^ (entry & 1 ? 0xEDB88320u : 0);
        }
        table[i] = entry;
    }
    crc = ~crc;
    for (size_t i = 0; i < size; i++) {
        crc = crc >> 8 ^ table[(crc ^ bytes[i]) & 0xFF];
    }
    return ~crc;
}

ref_lattice_point ref_point_read(const uint8_t *bytes)
{
    return (ref_lattice_point){ref_i32(bytes), ref_i32(bytes + 4), ref_i32(bytes + 8)};
}

ref_pose ref_pose_read(const uint8_t *bytes)
{
    return (ref_pose){ref_point_read(bytes), ref_u32(bytes + 12), ref_u32(bytes + 16),
                      ref_u32(bytes + 20)};
}

const ref_face *ref_face_of(const ref_scene *scene, const ref_instance *instance, uint32_t number)
{
    return &scene->faces[scene->models[instance->model].first_face + number];
}

ref_lattice_point ref_model_vertex(const ref_scene *scene, const ref_instance *instance,
                                   uint32_t number)
{
    return scene->vertices[scene->models[instance->model].first_vertex + number];
}

ref_lattice_point ref_face_corner(const ref_scene *scene, const ref_instance *instance,
                                  const ref_face *face, int corner)
{
    return ref_model_vertex(scene, instance, scene->indices[face->first_index + (uint32_t)corner]);
}

ref_lattice_point ref_face_vertex(const ref_scene *scene, const ref_instance *instance,
                                  const ref_face *face, int corner)
{
    return ref_instance_vertex(scene, instance,
                               scene->indices[face->first_index + (uint32_t)corner]);
}

ref_lattice_point ref_instance_vertex(const ref_scene *scene, const ref_instance *instance,
                                      uint32_t number)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    ref_lattice_point vertex = ref_model_vertex(scene, instance, number);
    if (placement) {
        return ref_placement_rounded(placement, &instance->centre, &vertex);
    }
    return (ref_lattice_point){instance->centre.x + vertex.x, instance->centre.y + vertex.y,
                               instance->centre.z + vertex.z};
}

static bool coordinate_is_sound(int64_t c)
{
    return llabs(c) <= (int64_t)REF_COORDINATE_MAX * 65536;
}

static bool inside_world(const ref_lattice_point *p)
{
    return coordinate_is_sound(p->x) && coordinate_is_sound(p->y) && coordinate_is_sound(p->z);
}

/* Appends indices of the image to those of the scene. Returns whether the image has them. */
static bool add_indices(ref_scene *scene, const uint8_t *from, uint32_t there, uint32_t first,
                        uint32_t count)
{
    if (count < 3 || count > REF_FACE_VERTICES_MAX || first > there || count > there - first) {
        return false;
    }
    for (uint32_t k = 0; k < count; k++) {
        scene->indices[scene->index_count++] = ref_u16(from + 2 * ((size_t)first + k));
    }
    return true;
}

/* The faces, and of each its indices, and behind them those of the whole face of which it is a
 * part. */
static bool read_faces(const uint8_t *bytes, const uint8_t *faces, ref_scene *scene)
{
    uint32_t there, parts;
    const uint8_t *indices = ref_section(bytes, REF_INDICES, &there);
    const uint8_t *wholes = ref_section(bytes, REF_WHOLE_FACES, &parts);
    scene->indices =
        calloc(2 * (size_t)REF_FACE_VERTICES_MAX * scene->face_count, sizeof *scene->indices);
    for (uint32_t i = 0; scene->indices && i < scene->face_count; i++) {
        const uint8_t *p = faces + 20 * (size_t)i;
        const uint32_t whole = parts != 0 ? ref_u32(wholes + 4 * (size_t)i) : 0;
        const uint32_t first = scene->index_count;
        scene->faces[i] = (ref_face){{ref_i32(p), ref_i32(p + 4), ref_i32(p + 8)},
                                     first,
                                     p[12],
                                     p[13],
                                     (uint16_t)(whole % 32)};
        if (!(p[12] == 3 ? add_indices(scene, p + 14, 3, 0, 3)
                         : add_indices(scene, indices, there, ref_u32(p + 16), p[12])) ||
            scene->indices[first] != ref_u16(p + 14) ||
            (whole != 0 && !add_indices(scene, indices, there, whole / 32, whole % 32))) {
            return false;
        }
    }
    return scene->indices != NULL;
}

static bool read_geometry(const uint8_t *bytes, ref_scene *scene)
{
    const uint8_t *vertices, *faces, *models, *instances;
    scene->vertices =
        ref_table(bytes, REF_VERTICES, sizeof *scene->vertices, &vertices, &scene->vertex_count);
    scene->faces = ref_table(bytes, REF_FACES, sizeof *scene->faces, &faces, &scene->face_count);
    scene->models =
        ref_table(bytes, REF_MODELS, sizeof *scene->models, &models, &scene->model_count);
    scene->instances = ref_table(bytes, REF_INSTANCES, sizeof *scene->instances, &instances,
                                 &scene->instance_count);
    if (!scene->vertices || !scene->faces || !scene->models || !scene->instances) {
        return false;
    }
    for (uint32_t i = 0; i < scene->vertex_count; i++) {
        scene->vertices[i] = ref_point_read(vertices + 12 * (size_t)i);
    }
    if (!read_faces(bytes, faces, scene)) {
        return false;
    }
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const uint8_t *p = models + 28 * (size_t)i;
        scene->models[i] = (ref_model){ref_u32(p), ref_u32(p + 4),  ref_u32(p + 8), ref_u32(p + 12),
                                       p[16],      ref_i32(p + 20), ref_u16(p + 18)};
    }
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const uint8_t *p = instances + 16 * (size_t)i;
        scene->instances[i] = (ref_instance){ref_point_read(p), ref_u16(p + 12), p[14]};
    }
    return true;
}

static bool faces_are_sound(const ref_scene *scene, const ref_model *model)
{
    for (uint32_t i = 0; i < model->face_count; i++) {
        const ref_face *face = &scene->faces[model->first_face + i];
        const uint32_t count = (uint32_t)face->count + face->whole_count;
        for (uint32_t k = 0; k < count; k++) {
            if (scene->indices[face->first_index + k] >= model->vertex_count) {
                return false;
            }
        }
    }
    return true;
}

static bool sphere_holds_model(const ref_scene *scene, const ref_model *model)
{
    ref_exact reach = (ref_exact)model->radius * model->radius;
    for (uint32_t v = 0; v < model->vertex_count; v++) {
        ref_lattice_point p = scene->vertices[model->first_vertex + v];
        if ((ref_exact)p.x * p.x + (ref_exact)p.y * p.y + (ref_exact)p.z * p.z > reach) {
            return false;
        }
    }
    return model->radius >= 0;
}

static bool geometry_is_sound(const ref_scene *scene)
{
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const ref_model *model = &scene->models[i];
        if ((uint64_t)model->first_vertex + model->vertex_count > scene->vertex_count ||
            (uint64_t)model->first_face + model->face_count > scene->face_count ||
            model->kind > REF_MODEL_SORTED || !faces_are_sound(scene, model) ||
            !sphere_holds_model(scene, model)) {
            return false;
        }
    }
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const ref_instance *instance = &scene->instances[i];
        if (instance->model >= scene->model_count || !inside_world(&instance->centre)) {
            return false;
        }
        if (scene->placements && i >= scene->first_turned) {
            continue; /* the library's loader checks where its sphere is */
        }
        const ref_model *model = &scene->models[instance->model];
        for (uint32_t v = 0; v < model->vertex_count; v++) {
            ref_lattice_point p = scene->vertices[model->first_vertex + v];
            if (!coordinate_is_sound((int64_t)p.x + instance->centre.x) ||
                !coordinate_is_sound((int64_t)p.y + instance->centre.y) ||
                !coordinate_is_sound((int64_t)p.z + instance->centre.z)) {
                return false;
            }
        }
    }
    return true;
}

static bool read_path(const uint8_t *bytes, ref_scene_image *image)
{
    const uint8_t *path = ref_section(bytes, REF_SEGMENTS, &image->path_count);
    const bool segments = path != NULL;
    if (!segments) {
        path = ref_section(bytes, REF_POSES, &image->path_count);
    }
    uint64_t frames = 0;
    if (segments) {
        image->segments = calloc(image->path_count, sizeof *image->segments);
    } else {
        image->poses = calloc(image->path_count, sizeof *image->poses);
    }
    for (uint32_t i = 0; i < image->path_count; i++) {
        if (image->segments) {
            const uint8_t *p = path + 4 * (size_t)i;
            image->segments[i] = (ref_path_segment){ref_u16(p), ref_u16(p + 2)};
            frames += image->segments[i].frames;
        } else if (image->poses) {
            image->poses[i] = ref_pose_read(path + 24 * (size_t)i);
            frames += inside_world(&image->poses[i].position);
        }
    }
    image->frame_count = ref_u32(bytes + 80);
    return frames >= 1 && frames == image->frame_count;
}

/* Moves the centre of the lens, if the image has one. */
static bool read_centre(const uint8_t *bytes, ref_lens *lens)
{
    uint32_t count;
    const uint8_t *centre = ref_section(bytes, REF_LENS_CENTRE, &count);
    if (!centre) {
        return true;
    }
    if (lens->inset != 0) {
        return false;
    }
    lens->centre_x = ref_i32(centre) / REF_ONE;
    lens->centre_y = ref_i32(centre + 4) / REF_ONE;
    const double x = fabs(lens->centre_x - lens->width / 2.0);
    const double y = fabs(lens->centre_y - lens->height / 2.0);
    return x <= 1.5 * lens->width && y <= 1.5 * lens->height && fmax(x, y) <= 4 * lens->focal;
}

/* Makes the lens orthographic, if the image has a scale. */
static bool read_scale(const uint8_t *bytes, ref_lens *lens)
{
    uint32_t count;
    const uint8_t *scale = ref_section(bytes, REF_LENS_SCALE, &count);
    if (!scale) {
        return true;
    }
    lens->scale = ref_i32(scale) / REF_ONE;
    return lens->scale >= 1.0 / 16 && lens->scale <= 4096 && lens->inset == 0;
}

static bool read_lens(const uint8_t *bytes, ref_lens *lens)
{
    int width = ref_u16(bytes + 16), height = ref_u16(bytes + 18);
    ref_angle fov = ref_u32(bytes + 20);
    double near_z = ref_i32(bytes + 24) / REF_ONE, far_z = ref_i32(bytes + 28) / REF_ONE,
           inset = ref_i32(bytes + 32) / REF_ONE;
    *lens = ref_lens_from_fov(width, height, fov, near_z, far_z, inset);
    return width >= 1 && width <= REF_SCREEN_MAX && height >= 1 && height <= REF_SCREEN_MAX &&
           fov >= 119304647u && fov <= 1789569707u && near_z >= 1.0 / 256 && far_z <= 32767 &&
           inset >= 0 && inset <= 1 && near_z + 2 * inset < far_z && read_centre(bytes, lens) &&
           read_scale(bytes, lens);
}

/* place pixel-format: what the image asks for */
static const char *read_image(const uint8_t *bytes, size_t size, ref_scene_image *image)
{
    const char *wrong = ref_sections_check(bytes, size);
    if (wrong) {
        return wrong;
    }
    if (!read_lens(bytes, &image->lens)) {
        return "the scene image's lens is out of range";
    }
    image->depth_bits = 16 * (bytes[37] & 3);
    image->is_rgb565 = bytes[37] >> 2 & 1;
    image->by_distance = bytes[37] >> 3 & 1;
    image->dark = ref_u16(bytes + 38);
    image->background = bytes[36];
    image->start = ref_pose_read(bytes + 40);
    image->motion_limits =
        (ref_motion_limits){ref_i32(bytes + 64) / REF_ONE, ref_i32(bytes + 68) / REF_ONE,
                            ref_i32(bytes + 72) / REF_ONE, ref_u32(bytes + 76)};
    uint32_t colours;
    const uint8_t *palette = ref_section(bytes, REF_PALETTE, &colours);
    memcpy(image->palette, palette, sizeof image->palette);
    if (!read_geometry(bytes, &image->scene) || !ref_placements_read(bytes, image) ||
        !geometry_is_sound(&image->scene)) {
        return "a table of the scene image reaches outside the image, points outside another "
               "table, leaves the world's range or a model's radius";
    }
    if (!ref_bsp_read(bytes, &image->scene)) {
        return "the scene image's BSP tree is not usable";
    }
    if (!ref_clusters_read(bytes, &image->scene)) {
        return "the scene image's clusters are not usable";
    }
    if (!ref_beams_read(bytes, &image->scene)) {
        return "the scene image's beams are not usable";
    }
    if (!ref_light_part_read(bytes, image)) {
        return "the scene image's light is not usable";
    }
    if (!ref_surfaces_read(bytes, &image->scene)) {
        return "the scene image's surfaces are not usable";
    }
    if (!ref_billboards_read(bytes, &image->scene)) {
        return "the scene image's billboards are not usable";
    }
    if (!ref_lines_read(bytes, &image->scene)) {
        return "the scene image's lines are not usable";
    }
    if (!ref_horizon_read(bytes, &image->scene.horizon)) {
        return "the scene image's horizon is not usable";
    }
    if (!inside_world(&image->start.position) || !read_path(bytes, image)) {
        return "the scene image's path is not usable";
    }
    return NULL;
}

const char *ref_scene_open(const uint8_t *bytes, size_t size, ref_scene_image *image)
{
    memset(image, 0, sizeof *image);
    const char *wrong = read_image(bytes, size, image);
    if (wrong) {
        ref_scene_close(image);
    }
    return wrong;
}

void ref_scene_close(ref_scene_image *image)
{
    free(image->scene.vertices);
    free(image->scene.indices);
    free(image->scene.faces);
    free(image->scene.models);
    free(image->scene.instances);
    free(image->scene.bsp_nodes);
    free(image->scene.beams);
    free(image->scene.clusters);
    free(image->light);
    ref_surfaces_close(image->scene.surfaces);
    ref_billboards_close(image->scene.billboards);
    free(image->scene.lines);
    free(image->scene.line_map);
    free(image->poses);
    free(image->segments);
    memset(image, 0, sizeof *image);
}
