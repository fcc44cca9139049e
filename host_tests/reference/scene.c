/* SPDX-License-Identifier: MIT */
#include "reference/scene.h"

#include "reference/light.h"
#include "reference/surface.h"
#include "reference/turn.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

__extension__ typedef __int128 wide;

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

static ref_lattice_point point_read(const uint8_t *bytes)
{
    return (ref_lattice_point){ref_i32(bytes), ref_i32(bytes + 4), ref_i32(bytes + 8)};
}

ref_pose ref_pose_read(const uint8_t *bytes)
{
    return (ref_pose){point_read(bytes), ref_u32(bytes + 12), ref_u32(bytes + 16),
                      ref_u32(bytes + 20)};
}

ref_lattice_point ref_face_corner(const ref_scene *scene, const ref_instance *instance,
                                  const ref_face *face, int corner)
{
    const ref_model *model = &scene->models[instance->model];
    uint32_t number = scene->indices[face->first_index + (uint32_t)corner];
    return scene->vertices[model->first_vertex + number];
}

ref_lattice_point ref_face_vertex(const ref_scene *scene, const ref_instance *instance,
                                  const ref_face *face, int corner)
{
    const ref_turn *turn = ref_turn_of(scene, instance);
    ref_lattice_point vertex = ref_face_corner(scene, instance, face, corner);
    if (turn) {
        return ref_turn_rounded(turn, &instance->centre, &vertex);
    }
    return (ref_lattice_point){instance->centre.x + vertex.x, instance->centre.y + vertex.y,
                               instance->centre.z + vertex.z};
}

/* Returns the first entry of a table of the image; null, and *count 0, where it is not usable. */
static const uint8_t *table_at(const uint8_t *bytes, size_t size, size_t field, size_t entry_size,
                               uint32_t maximum, uint32_t *count)
{
    uint64_t offset = ref_u32(bytes + field);
    *count = ref_u32(bytes + field + 4);
    bool usable = *count >= 1 && *count <= maximum && offset % 4 == 0 &&
                  offset + (uint64_t)*count * entry_size <= size;
    if (!usable) {
        *count = 0;
        return NULL;
    }
    return bytes + offset;
}

const uint8_t *ref_image_table(const uint8_t *bytes, size_t size, size_t field, size_t entry_size,
                               uint32_t maximum, uint32_t *count)
{
    return table_at(bytes, size, field, entry_size, maximum, count);
}

static bool coordinate_is_sound(int64_t c)
{
    return llabs(c) <= (int64_t)REF_COORDINATE_MAX * 65536;
}

static bool inside_world(const ref_lattice_point *p)
{
    return coordinate_is_sound(p->x) && coordinate_is_sound(p->y) && coordinate_is_sound(p->z);
}

static bool read_geometry(const uint8_t *bytes, size_t size, ref_scene *scene)
{
    const uint8_t *vertices = table_at(bytes, size, 88, 12, 1000000, &scene->vertex_count);
    const uint8_t *indices = table_at(bytes, size, 96, 2, 4000000, &scene->index_count);
    const uint8_t *faces = table_at(bytes, size, 104, 20, 1000000, &scene->face_count);
    const uint8_t *models = table_at(bytes, size, 112, 28, 65535, &scene->model_count);
    const uint8_t *instances = table_at(bytes, size, 120, 16, 65535, &scene->instance_count);
    if (!vertices || !indices || !faces || !models || !instances) {
        return false;
    }
    scene->vertices = calloc(scene->vertex_count, sizeof *scene->vertices);
    scene->indices = calloc(scene->index_count, sizeof *scene->indices);
    scene->faces = calloc(scene->face_count, sizeof *scene->faces);
    scene->models = calloc(scene->model_count, sizeof *scene->models);
    scene->instances = calloc(scene->instance_count, sizeof *scene->instances);
    if (!scene->vertices || !scene->indices || !scene->faces || !scene->models ||
        !scene->instances) {
        return false;
    }
    for (uint32_t i = 0; i < scene->vertex_count; i++) {
        scene->vertices[i] = point_read(vertices + 12 * (size_t)i);
    }
    for (uint32_t i = 0; i < scene->index_count; i++) {
        scene->indices[i] = ref_u16(indices + 2 * (size_t)i);
    }
    for (uint32_t i = 0; i < scene->face_count; i++) {
        const uint8_t *p = faces + 20 * (size_t)i;
        scene->faces[i] =
            (ref_face){{ref_i32(p), ref_i32(p + 4), ref_i32(p + 8)}, ref_u32(p + 12), p[16], p[17]};
    }
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const uint8_t *p = models + 28 * (size_t)i;
        scene->models[i] = (ref_model){ref_u32(p), ref_u32(p + 4),  ref_u32(p + 8), ref_u32(p + 12),
                                       p[16],      ref_i32(p + 20), ref_u16(p + 18)};
    }
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const uint8_t *p = instances + 16 * (size_t)i;
        scene->instances[i] = (ref_instance){point_read(p), ref_u16(p + 12), p[14]};
    }
    return true;
}

static bool faces_are_sound(const ref_scene *scene, const ref_model *model)
{
    for (uint32_t i = 0; i < model->face_count; i++) {
        const ref_face *face = &scene->faces[model->first_face + i];
        if (face->count < 3 || face->count > REF_FACE_VERTICES_MAX ||
            (uint64_t)face->first_index + face->count > scene->index_count) {
            return false;
        }
        for (uint32_t k = 0; k < face->count; k++) {
            if (scene->indices[face->first_index + k] >= model->vertex_count) {
                return false;
            }
        }
    }
    return true;
}

static bool sphere_holds_model(const ref_scene *scene, const ref_model *model)
{
    wide reach = (wide)model->radius * model->radius;
    for (uint32_t v = 0; v < model->vertex_count; v++) {
        ref_lattice_point p = scene->vertices[model->first_vertex + v];
        if ((wide)p.x * p.x + (wide)p.y * p.y + (wide)p.z * p.z > reach) {
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
        if (scene->turns && i >= scene->first_turned) {
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

/* Reads the light of an image of version 6. Returns true also where there is none. */
static bool read_light(const uint8_t *bytes, size_t size, ref_scene_image *image)
{
    uint32_t lights, points = 0, levels;
    if (ref_u16(bytes + 4) < 6 || (ref_u16(bytes + 6) > 232 && ref_u32(bytes + 212) == 0)) {
        return true;
    }
    const uint8_t *base = table_at(bytes, size, 208, 28, 1, &lights);
    const uint8_t *at = table_at(bytes, size, 216, 20, REF_LIGHT_POINTS_MAX, &points);
    const uint8_t *ramp = table_at(bytes, size, 224, 256, REF_LIGHT_LEVELS_MAX, &levels);
    image->light = base && ramp && levels >= 2 ? calloc(1, sizeof *image->light) : NULL;
    if (!image->light || (!at && ref_u32(bytes + 220) != 0)) {
        return false;
    }
    ref_light_read(image->light, base, at, (int)points, ramp, (int)levels);
    image->scene.light = image->light;
    return true;
}

/* Reads the turns of an image of version 5 or later. Returns true also where there are none. */
static bool read_turns(const uint8_t *bytes, size_t size, ref_scene_image *image)
{
    ref_scene *scene = &image->scene;
    uint32_t count;
    if (ref_u16(bytes + 4) < 5 || (ref_u16(bytes + 4) > 5 && ref_u32(bytes + 188) == 0)) {
        return true;
    }
    const uint8_t *turns = table_at(bytes, size, 184, 40, scene->instance_count, &count);
    image->motion_count = ref_u32(bytes + 196);
    scene->turns = turns ? calloc(count, sizeof *scene->turns) : NULL;
    if (!scene->turns || image->motion_count > count) {
        return false;
    }
    scene->first_turned = scene->instance_count - count;
    for (uint32_t i = 0; i < count; i++) {
        const uint8_t *p = turns + 40 * (size_t)i;
        for (int k = 0; k < 9; k++) {
            scene->turns[i].rows[k / 3][k % 3] = ref_i32(p + 4 * k);
        }
        scene->turns[i].scale = ref_i32(p + 36);
    }
    return true;
}

/* Reads the BSP. Returns true also where there is none. A child's number must be greater than
 * its parent's, because nodes are stored in the order root, front, back. So every path downward
 * ends. */
static bool read_bsp(const uint8_t *bytes, size_t size, ref_scene *scene)
{
    if (ref_u16(bytes + 4) == 2) {
        return ref_u32(bytes + 148) == 0 && ref_u32(bytes + 152) == 0 && ref_u32(bytes + 156) == 0;
    }
    scene->bsp_instance = ref_u32(bytes + 156);
    if (ref_u32(bytes + 152) == 0) {
        return ref_u32(bytes + 148) == 0 && scene->bsp_instance == 0;
    }
    const uint8_t *bsp_nodes = table_at(bytes, size, 148, 48, 65535, &scene->bsp_node_count);
    scene->bsp_nodes = bsp_nodes ? calloc(scene->bsp_node_count, sizeof *scene->bsp_nodes) : NULL;
    if (!scene->bsp_nodes || scene->bsp_instance >= scene->instance_count) {
        return false;
    }
    const ref_model *model = &scene->models[scene->instances[scene->bsp_instance].model];
    for (uint32_t i = 0; i < scene->bsp_node_count; i++) {
        const uint8_t *p = bsp_nodes + 48 * (size_t)i;
        ref_bsp_node *node = &scene->bsp_nodes[i];
        *node = (ref_bsp_node){{ref_i32(p), ref_i32(p + 4), ref_i32(p + 8)},
                               (int64_t)(ref_u32(p + 12) | (uint64_t)ref_u32(p + 16) << 32),
                               ref_u16(p + 20),
                               ref_u16(p + 22),
                               ref_u16(p + 24),
                               ref_u16(p + 26),
                               ref_u16(p + 28)};
        const uint32_t below[2] = {node->front, node->back};
        for (int k = 0; k < 2; k++) {
            if (below[k] != REF_BSP_NONE && (below[k] <= i || below[k] >= scene->bsp_node_count)) {
                return false;
            }
        }
        if (node->first_face + node->face_count > model->face_count) {
            return false;
        }
    }
    return true;
}

static bool read_path(const uint8_t *bytes, size_t size, ref_scene_image *image)
{
    bool segments = bytes[37] == 1;
    const uint8_t *path =
        table_at(bytes, size, 128, segments ? 4 : 24, 1000000, &image->path_count);
    if (!path || bytes[37] > 1) {
        return false;
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
    image->frame_count = ref_u32(bytes + 136);
    return frames >= 1 && frames == image->frame_count;
}

/* Moves the centre of the lens, if the image has one behind its header. */
static bool read_centre(const uint8_t *bytes, size_t size, ref_lens *lens)
{
    const size_t at = ref_u16(bytes + 6);
    if (ref_u16(bytes + 38) == 0) {
        return true;
    }
    if (ref_u16(bytes + 38) != 1 || at + 8 > size || lens->inset != 0) {
        return false;
    }
    lens->centre_x = ref_i32(bytes + at) / REF_ONE;
    lens->centre_y = ref_i32(bytes + at + 4) / REF_ONE;
    const double x = fabs(lens->centre_x - lens->width / 2.0);
    const double y = fabs(lens->centre_y - lens->height / 2.0);
    return x <= 1.5 * lens->width && y <= 1.5 * lens->height && fmax(x, y) <= 4 * lens->focal;
}

static bool read_lens(const uint8_t *bytes, size_t size, ref_lens *lens)
{
    int width = ref_u16(bytes + 16), height = ref_u16(bytes + 18);
    ref_angle fov = ref_u32(bytes + 20);
    double near_z = ref_i32(bytes + 24) / REF_ONE, far_z = ref_i32(bytes + 28) / REF_ONE,
           inset = ref_i32(bytes + 32) / REF_ONE;
    *lens = ref_lens_from_fov(width, height, fov, near_z, far_z, inset);
    return width >= 1 && width <= REF_SCREEN_MAX && height >= 1 && height <= REF_SCREEN_MAX &&
           fov >= 119304648u && fov <= 1789569706u && near_z >= 1.0 / 256 && far_z <= 32767 &&
           inset >= 0 && inset <= 1 && near_z + 2 * inset < far_z && read_centre(bytes, size, lens);
}

/* Tells whether the clusters of a model hold all of its faces. */
static bool clusters_are_sound(const ref_scene *scene, const ref_model *model)
{
    uint32_t faces = 0;
    for (uint32_t i = model->first_cluster; i > 0 && faces < model->face_count; i++) {
        if (i > scene->cluster_count || scene->clusters[i - 1].face_count == 0) {
            return false;
        }
        faces += scene->clusters[i - 1].face_count;
    }
    return model->first_cluster == 0 || faces == model->face_count;
}

/* Reads the clusters. Returns true also where there are none. */
static bool read_clusters(const uint8_t *bytes, size_t size, ref_scene *scene)
{
    if (ref_u16(bytes + 6) >= 184 && (ref_u16(bytes + 4) == 4 || ref_u32(bytes + 180) > 0)) {
        const uint8_t *clusters = table_at(bytes, size, 176, 48, 65535, &scene->cluster_count);
        scene->clusters = clusters ? calloc(scene->cluster_count, sizeof *scene->clusters) : NULL;
        for (uint32_t i = 0; scene->clusters && i < scene->cluster_count; i++) {
            const uint8_t *p = clusters + 48 * (size_t)i;
            scene->clusters[i] = (ref_cluster){point_read(p), ref_i32(p + 12), ref_u16(p + 44)};
        }
        if (!scene->clusters) {
            return false;
        }
    }
    for (uint32_t i = 0; i < scene->model_count; i++) {
        if (!clusters_are_sound(scene, &scene->models[i])) {
            return false;
        }
    }
    return true;
}

/* Reads a distance of 18.46, low word first, with all of its bits. */
static long double distance_read(const uint8_t *bytes)
{
    return ldexpl((long double)ref_i32(bytes + 4), -14) + ldexpl((long double)ref_u32(bytes), -46);
}

static void beam_read(const uint8_t *bytes, ref_beam *beam)
{
    for (int i = 0; i < 3; i++) {
        beam->from[i] = ref_i32(bytes + 4 * i);
    }
    beam->kind = bytes[12];
    beam->plane_count = bytes[13];
    for (int i = 0; i < beam->plane_count && i < 8; i++) {
        const uint8_t *p = bytes + 16 + 20 * i;
        beam->planes[i] = (ref_plane){
            {ldexp(ref_i32(p), -30), ldexp(ref_i32(p + 4), -30), ldexp(ref_i32(p + 8), -30)},
            distance_read(p + 12)};
    }
}

static bool read_beams(const uint8_t *bytes, size_t size, ref_scene *scene)
{
    /* With clusters or turns the header has the fields of beams also where there are none. */
    if (ref_u16(bytes + 6) == 160 || (ref_u16(bytes + 6) >= 184 && ref_u32(bytes + 164) == 0)) {
        return true;
    }
    const uint8_t *beams = table_at(bytes, size, 160, 176, 4, &scene->beam_count);
    uint64_t lit = ref_u32(bytes + 168);
    if (!beams || lit + 256 > size) {
        return false;
    }
    memcpy(scene->lit, bytes + lit, 256);
    scene->beams = calloc(scene->beam_count, sizeof *scene->beams);
    for (uint32_t i = 0; scene->beams && i < scene->beam_count; i++) {
        beam_read(beams + 176 * (size_t)i, &scene->beams[i]);
        if (scene->beams[i].plane_count < 1 || scene->beams[i].plane_count > 8 ||
            scene->beams[i].kind > REF_BEAM_DIRECTION) {
            return false;
        }
    }
    return scene->beams != NULL;
}

static const char *read_image(const uint8_t *bytes, size_t size, ref_scene_image *image)
{
    if (size < 160 || memcmp(bytes, "FXLS", 4) != 0) {
        return "it is not a scene image (no FXLS at its start)";
    }
    uint16_t version = ref_u16(bytes + 4), header = ref_u16(bytes + 6);
    if (version < 2 || version > 6 ||
        !(header == 232 || header == 296 ? version == 6
          : header == 208                ? version == 5
          : version > 4                  ? false
                                         : header == 160 || header == 176 || header == 184)) {
        return "this version of the scene image is not known";
    }
    uint32_t stated = ref_u32(bytes + 8);
    if (stated < ref_u16(bytes + 6) || stated > size || stated > 16u << 20) {
        return "the scene image is shorter than its header says";
    }
    if (ref_crc32(0, bytes + 16, stated - 16) != ref_u32(bytes + 12)) {
        return "the scene image's checksum does not match";
    }
    if (!read_lens(bytes, stated, &image->lens)) {
        return "the scene image's lens is out of range";
    }
    image->background = bytes[36];
    image->start = ref_pose_read(bytes + 40);
    image->motion_limits =
        (ref_motion_limits){ref_i32(bytes + 64) / REF_ONE, ref_i32(bytes + 68) / REF_ONE,
                            ref_i32(bytes + 72) / REF_ONE, ref_u32(bytes + 76)};
    uint32_t colours;
    const uint8_t *palette = table_at(bytes, stated, 80, 3, 256, &colours);
    if (!palette || colours != 256) {
        return "the scene image's palette is not usable";
    }
    memcpy(image->palette, palette, sizeof image->palette);
    if (!read_geometry(bytes, stated, &image->scene) || !read_turns(bytes, stated, image) ||
        !geometry_is_sound(&image->scene)) {
        return "a table of the scene image reaches outside the image, points outside another "
               "table, leaves the world's range or a model's radius";
    }
    if (!read_bsp(bytes, stated, &image->scene)) {
        return "the scene image's BSP tree is not usable";
    }
    if (!read_clusters(bytes, stated, &image->scene)) {
        return "the scene image's clusters are not usable";
    }
    if (!read_beams(bytes, stated, &image->scene)) {
        return "the scene image's beams are not usable";
    }
    if (!read_light(bytes, stated, image)) {
        return "the scene image's light is not usable";
    }
    if (!ref_surfaces_read(bytes, stated, &image->scene)) {
        return "the scene image's surfaces are not usable";
    }
    if (!inside_world(&image->start.position) || !read_path(bytes, stated, image)) {
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
    free(image->poses);
    free(image->segments);
    memset(image, 0, sizeof *image);
}
