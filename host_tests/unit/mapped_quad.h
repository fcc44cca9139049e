/* SPDX-License-Identifier: MIT */
/* Tables of scenes whose models are single quadrilaterals, of which one has a texture: for unit
 * tests, and for the kernels of bench/firmware. */
#ifndef MAPPED_QUAD_H
#define MAPPED_QUAD_H

#include "draw/stages.h"
#include "fixel/all.h"

/* The tables of a scene. */
typedef struct {
    const fxl_point *vertices;
    const uint16_t *indices;
    const fxl_face *faces;
    const fxl_model *models;
    const fxl_instance *instances;
} quad_tables;

/* A scene of so many quadrilaterals, each a model that has one instance. */
static inline fxl_scene quad_tables_scene(const quad_tables *tables, uint16_t quads)
{
    const fxl_scene scene = {.vertices = tables->vertices,
                             .indices = tables->indices,
                             .faces = tables->faces,
                             .models = tables->models,
                             .instances = tables->instances,
                             .vertex_count = quads * 4u,
                             .index_count = quads * 4u,
                             .face_count = quads,
                             .model_count = quads,
                             .instance_count = quads};
    return scene;
}

/* One surface with one texture, for one face. */
static inline fxl_surface_set quad_surface_set(const fxl_texture *texture,
                                               const fxl_surface *surface,
                                               const fxl_mapped_face *mapped,
                                               const fxl_corner *corners, const uint16_t *face_map)
{
    const fxl_surface_set set = {.textures = texture,
                                 .surfaces = surface,
                                 .faces = mapped,
                                 .face_map = face_map,
                                 .corners = corners,
                                 .texture_count = 1,
                                 .surface_count = 1,
                                 .face_count = 1,
                                 .corner_count = 3};
    return set;
}

/* A face with the given three vertices; its texture is so long on each side. The corners have these
 * numbers, from the first one on. */
static inline void quad_map_face(fxl_mapped_face *mapped, fxl_corner corners[3], uint32_t first,
                                 const uint16_t *vertices, fxl_q16_16 side)
{
    const fxl_texel texels[3] = {{0, side}, {0, 0}, {side, 0}};
    mapped->surface = 0;
    for (uint32_t i = 0; i < 3; i++) {
        mapped->corners[i] = (uint16_t)(first + i);
        corners[i].texel = texels[i];
        corners[i].vertex = vertices[i];
        corners[i].normal = 0;
    }
}

/* A scene of one quadrilateral at the origin, with a texture of 64 x 64. */
typedef struct {
    fxl_point vertices[4];
    uint16_t indices[4];
    fxl_face face;
    fxl_model model;
    fxl_instance instance;
    fxl_scene scene;
    uint8_t texels[64 * 64];
    fxl_texture texture;
    fxl_surface surface;
    fxl_mapped_face mapped;
    fxl_corner mapped_corners[3];
    uint16_t face_map;
    fxl_surface_set set;
} mapped_quad;

/* Needs the vertices, and the texels of the first three of them. */
static inline void mapped_quad_make(mapped_quad *quad, fxl_direction normal, fxl_q16_16 radius)
{
    const quad_tables tables = {quad->vertices, quad->indices, &quad->face, &quad->model,
                                &quad->instance};
    for (uint8_t i = 0; i < 4; i++) {
        quad->indices[i] = i;
    }
    for (uint8_t i = 0; i < 3; i++) {
        quad->mapped.corners[i] = quad->mapped_corners[i].vertex = i;
    }
    quad->face = (fxl_face){normal, 4, 200, FXL_INDICES_AT(0, 0)};
    quad->model =
        (fxl_model){.vertex_count = 4, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = radius};
    quad->scene = quad_tables_scene(&tables, 1);
    quad->texture =
        (fxl_texture){.texels = quad->texels, .log_width = 6, .log_height = 6, .levels = 1};
    quad->surface = (fxl_surface){.texture = 1, .opacity = 16};
    quad->face_map = 1;
    quad->set = quad_surface_set(&quad->texture, &quad->surface, &quad->mapped,
                                 quad->mapped_corners, &quad->face_map);
}

/* The floor of workload W4: 16 x 20 units, half a unit below the eye, which runs behind it. Texels
 * are squares of 16 x 16 in 16 colours from 1 on. */
static inline void mapped_quad_make_floor(mapped_quad *quad)
{
    for (uint32_t i = 0; i < 4; i++) {
        const bool is_right = i == 1 || i == 2;
        quad->vertices[i] =
            (fxl_point){(is_right ? 8 : -8) * 65536, -32768, (i < 2 ? 16 : -4) * 65536};
    }
    for (uint32_t i = 0; i < 3; i++) {
        quad->mapped_corners[i].texel =
            (fxl_texel){(i > 0 ? 512 : 0) * 65536, (i < 2 ? 640 : 0) * 65536};
    }
    for (uint32_t i = 0; i < sizeof quad->texels; i++) {
        quad->texels[i] = (uint8_t)(1 + (i >> 10 & 3) * 4 + (i >> 4 & 3));
    }
    mapped_quad_make(quad, (fxl_direction){0, FXL_Q2_30_ONE, 0}, 18 * 65536);
}

/* The camera that sees the floor as W4 does. */
static inline fxl_config mapped_quad_floor_config(uint16_t width, uint16_t height)
{
    fxl_config config = fxl_config_default(width, height);
    config.fov = FXL_ANGLE_QUARTER;
    config.near_z = 4096;
    config.far_z = 64 * 65536;
    return config;
}

#endif
