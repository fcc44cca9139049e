/* SPDX-License-Identifier: MIT */
/* The listing as what draws a frame. The scene is turned into its records
 * before anything is measured. */
#include "contract/system.h"
#include "draw.h"
#include "listing.h"
#include "program.h"

#define OBJECTS_MAX  200u
#define FACES_MAX    2100u
#define VERTICES_MAX 6400u /* corners of all faces: each face has its own points */

static listing_object objects[OBJECTS_MAX];
static listing_face faces[FACES_MAX];
static listing_point vertices[VERTICES_MAX];
static listing_world world;

static real from_q16(fxl_q16_16 value)
{
    return (real)value / (real)65536;
}

static real from_angle(fxl_angle angle)
{
    return (real)(int32_t)angle * (real)(3.14159265358979323846 / 2147483648.0);
}

static listing_point from_point(const fxl_point *point)
{
    listing_point result = {{from_q16(point->x), from_q16(point->y), from_q16(point->z)}};
    return result;
}

static void copy_faces(const fxl_scene *scene)
{
    listing_point *next = vertices;
    for (uint32_t m = 0; m < scene->model_count; m++) {
        const fxl_model *model = &scene->models[m];
        for (uint32_t f = model->first_face; f < model->first_face + model->face_count; f++) {
            const fxl_face *face = &scene->faces[f];
            for (uint32_t i = 0; i < face->count; i++) {
                uint32_t vertex = model->first_vertex + fxl_face_indices(scene->indices, face)[i];
                next[i] = from_point(&scene->vertices[vertex]);
            }
            faces[f].vertices = next;
            next += face->count;
            faces[f].count = face->count;
            faces[f].colour = face->material;
        }
    }
}

int draw_open(const fxl_scene_image *image)
{
    const fxl_scene *scene = &image->scene;
    if (scene->instance_count > OBJECTS_MAX || scene->face_count > FACES_MAX ||
        scene->index_count > VERTICES_MAX) {
        text_with_number("bench: the listing has too little memory for so many corners", "", ": ",
                         scene->index_count);
        return SYSTEM_EXIT_CAPACITY;
    }
    copy_faces(scene);
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const fxl_instance *object = &scene->instances[i];
        const fxl_model *model = &scene->models[object->model];
        objects[i].centre = from_point(&object->centre);
        objects[i].faces = &faces[model->first_face];
        objects[i].face_count = model->face_count;
        objects[i].layer = object->layer;
    }
    world.objects = objects;
    world.object_count = scene->instance_count;
    world.focal = from_q16(image->lens.focal);
    return SYSTEM_EXIT_DONE;
}

bool draw_frame(const fxl_pose *pose, const fxl_band *band)
{
    const listing_eye eye = {from_point(&pose->position), from_angle(pose->yaw),
                             from_angle(pose->pitch), from_angle(pose->roll)};
    const listing_screen screen = {band->pixels, band->width, band->rows};
    listing_draw(&world, &eye, &screen);
    return true;
}

/* Distance and link of each object; the rest is the scene, or on the stack. */
uint32_t draw_memory(void)
{
    return (uint32_t)(sizeof world +
                      world.object_count * (sizeof objects[0].distance + sizeof objects[0].next));
}

const fxl_counters *draw_counters(void)
{
    static const fxl_counters none;
    return &none;
}
