/* SPDX-License-Identifier: MIT */
#include "scene_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"
/* place field: the ray-cast oracle's reader: sizes */
#include "scene_sections.h"

enum {
    VERTEX = 12,
    CORNER = 2,
    FACE = 20,
    MODEL = 28,
    INSTANCE = 16,
    TEXTURE = 16,
    SURFACE = 12,
    MAPPED_FACE = 8,
    OPAQUE = 16
};

typedef struct reader {
    const char *path;
    file_block image;
    table vertices, corners, faces, wholes, models, instances;
    play_tables play;
    light_tables light;
    scene_names names;
    table textures, surfaces, mapped, map; /* where faces that let through are left out */
    const uint8_t *centre;                 /* of the lens; null: in the middle */
    const uint8_t *scale;                  /* of an orthographic lens; null: it has an eye */
    table horizon, levels;
} reader;

static double q16(const uint8_t *at)
{
    return get_i32(at) / 65536.0;
}

static vector point_at(const uint8_t *at)
{
    return (vector){q16(at), q16(at + 4), q16(at + 8)};
}

static const uint8_t *entry_of(const reader *r, table t, uint64_t index, uint32_t size,
                               const char *what)
{
    if (index >= t.count)
        unusable("%s: %s %llu of %u", r->path, what, (unsigned long long)index, t.count);
    return t.at + index * size;
}

static void open_placements(reader *r, const table *sections)
{
    r->play.placements = sections[KIND_PLACEMENTS].at;
    r->play.placement_count = sections[KIND_PLACEMENTS].count;
    r->play.motions = sections[KIND_MOTIONS].at;
    r->play.motion_count = sections[KIND_MOTIONS].count;
    r->play.keys = sections[KIND_MOTION_KEYS].at;
    r->play.key_count = sections[KIND_MOTION_KEYS].count;
}

static void open_light(reader *r, const table *sections)
{
    r->light.base = sections[KIND_LIGHT].at;
    r->light.ramp = sections[KIND_RAMP].at;
    r->light.levels = sections[KIND_RAMP].count;
    r->light.points = sections[KIND_POINT_LIGHTS].at;
    r->light.point_count = sections[KIND_POINT_LIGHTS].count;
    if (r->light.base && r->light.levels < 2)
        unusable("%s: a ramp of one level", r->path);
}

/* Whether what is behind a face may be seen through it. */
static bool lets_through(const reader *r, uint64_t face)
{
    const uint32_t number = r->map.count ? get_u16(entry_of(r, r->map, face, 2, "face")) : 0;
    if (number == 0)
        return false;
    const uint8_t *mapped = entry_of(r, r->mapped, number - 1, MAPPED_FACE, "mapped face");
    const uint8_t *surface = entry_of(r, r->surfaces, get_u16(mapped), SURFACE, "surface");
    const uint32_t texture = get_u16(surface);
    const bool is_mixed = surface[3] & (2 | 4), has_pattern = surface[4] < OPAQUE;
    return is_mixed || has_pattern ||
           (texture > 0 && entry_of(r, r->textures, texture - 1, TEXTURE, "texture")[11] & 2);
}

static void open_image(reader *r, const char *path)
{
    r->path = path;
    r->image = file_read(path);
    table sections[KINDS];
    sections_read(path, &r->image, sections);
    /* No ray knows the colours of beams or surfaces: only names can be told. */
    if (r->names == SCENE_COLOURS && (sections[KIND_BEAMS].count || sections[KIND_FACE_MAP].count))
        unusable("%s: a ray knows no colours of beams and surfaces", path);
    if (sections[KIND_BILLBOARDS].count)
        unusable("%s: a ray knows no billboards", path);
    r->vertices = sections[KIND_VERTICES];
    r->corners = sections[KIND_INDICES];
    r->faces = sections[KIND_FACES];
    r->wholes = sections[KIND_WHOLE_FACES];
    r->models = sections[KIND_MODELS];
    r->instances = sections[KIND_INSTANCES];
    r->play.instances = r->instances.at;
    r->play.instance_count = r->instances.count;
    open_placements(r, sections);
    if (r->names == SCENE_COLOURS)
        open_light(r, sections);
    if (r->names == SCENE_NAMES_OPAQUE) { /* what says which faces let through */
        r->textures = sections[KIND_TEXTURES];
        r->surfaces = sections[KIND_SURFACES];
        r->mapped = sections[KIND_MAPPED_FACES];
        r->map = sections[KIND_FACE_MAP];
    }
    r->centre = sections[KIND_LENS_CENTRE].at;
    r->scale = sections[KIND_LENS_SCALE].at;
    if (r->names == SCENE_COLOURS) {
        r->horizon = sections[KIND_HORIZON_SINES];
        r->levels = sections[KIND_HORIZON_COLOURS];
    }
}

static const uint8_t *model_of(const reader *r, const uint8_t *instance)
{
    return entry_of(r, r->models, get_u16(instance + 12), MODEL, "model");
}

/* The vertex of a model that an index at a place names. */
static vector vertex_at(const reader *r, const uint8_t *model, const uint8_t *index)
{
    return point_at(
        entry_of(r, r->vertices, (uint64_t)get_u16(index) + get_u32(model), VERTEX, "vertex"));
}

/* Vertex i of a face: a triangle has its indices in its record. */
static vector vertex_of(const reader *r, const uint8_t *model, const uint8_t *face, uint32_t i)
{
    return vertex_at(r, model,
                     face[12] == 3 ? face + 14 + 2 * i
                                   : entry_of(r, r->corners, (uint64_t)get_u32(face + 16) + i,
                                              CORNER, "index"));
}

/* The middle of the bounding box of a face, of a part that of the whole face. */
static vector middle_of(const reader *r, const uint8_t *model, const uint8_t *face)
{
    const uint64_t number = (uint64_t)(face - r->faces.at) / FACE;
    const uint32_t part =
        r->wholes.count ? get_u32(entry_of(r, r->wholes, number, 4, "whole face")) : 0;
    const uint32_t count = part ? part % 32 : face[12];
    if (count < 3)
        unusable("%s: a whole face of %u vertices", r->path, count);
    vector low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < count; i++) {
        const vector at =
            part ? vertex_at(r, model, entry_of(r, r->corners, part / 32 + i, CORNER, "index"))
                 : vertex_of(r, model, face, i);
        low = (vector){fmin(low.x, at.x), fmin(low.y, at.y), fmin(low.z, at.z)};
        high = (vector){fmax(high.x, at.x), fmax(high.y, at.y), fmax(high.z, at.z)};
    }
    return vector_times(vector_plus(low, high), 0.5);
}

static void add_face(const reader *r, const placing *place, const uint8_t *model,
                     const uint8_t *face, uint8_t colour, world *w)
{
    world_polygon *polygon = &w->polygons[w->polygon_count++];
    *polygon = (world_polygon){.first = w->corner_count, .count = face[12], .colour = colour};
    if (polygon->count < 3)
        unusable("%s: a face of %u vertices", r->path, polygon->count);
    for (uint32_t i = 0; i < polygon->count; i++)
        w->corners[w->corner_count++] = placing_point(place, vertex_of(r, model, face, i));
    placing turned = *place;
    turned.centre = (vector){0, 0, 0};
    turned.scale = 1;
    const vector normal = {get_i32(face), get_i32(face + 4), get_i32(face + 8)};
    polygon->lit = (light_face){placing_point(&turned, vector_times(normal, 1 / 1073741824.0)),
                                placing_point(place, middle_of(r, model, face)), face[13]};
}

/* 1..255, by the numbers of an instance and of a face of its model. */
static uint8_t name_of(uint32_t instance, uint32_t face)
{
    const uint32_t mixed = instance * 2654435761u ^ face * 2246822519u;
    return (uint8_t)(1 + (mixed >> 16) % 255);
}

/* Counts faces and vertices first, so that each array is allocated once. */
static world world_of(const reader *r, uint32_t frame)
{
    world w = {0};
    placing *places = allocate(r->instances.count, sizeof *places);
    play_frame(&r->play, frame, places);
    uint64_t faces = 0, corners = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t o = 0; o < r->instances.count; o++) {
            const uint8_t *instance = entry_of(r, r->instances, o, INSTANCE, "instance");
            const uint8_t *model = model_of(r, instance);
            for (uint32_t f = 0; f < get_u32(model + 12); f++) {
                uint64_t number = (uint64_t)get_u32(model + 8) + f;
                const uint8_t *face = entry_of(r, r->faces, number, FACE, "face");
                if (lets_through(r, number))
                    continue;
                if (pass == 1)
                    add_face(r, &places[o], model, face,
                             r->names == SCENE_COLOURS ? face[13] : name_of(o, f), &w);
                faces++;
                corners += face[12];
            }
        }
        if (pass == 0) {
            const bool may_be_empty = r->names == SCENE_NAMES_OPAQUE; /* all may let through */
            if ((faces == 0 && !may_be_empty) || faces > 50000000 || corners > 500000000)
                unusable("%s: %llu polygons", r->path, (unsigned long long)faces);
            w.polygons = allocate(faces, sizeof *w.polygons);
            w.corners = allocate(corners, sizeof *w.corners);
        }
    }
    free(places);
    world_prepare(&w);
    return w;
}

void scene_play(scene *s, uint32_t frame)
{
    free(s->world.polygons);
    free(s->world.corners);
    free(s->world.nodes);
    s->world = world_of(s->image, frame);
}

void scene_light(scene *s, vector eye, vector forward)
{
    for (uint32_t p = 0; s->light.ramp && p < s->world.polygon_count; p++) {
        world_polygon *polygon = &s->world.polygons[p];
        polygon->colour = light_colour(&s->light, &polygon->lit, eye, forward);
    }
}

scene scene_read(const char *path, scene_names names)
{
    reader *r = allocate(1, sizeof *r);
    r->names = names;
    open_image(r, path);
    const uint8_t *bytes = r->image.bytes;
    double turn = get_u32(bytes + 20) / 4294967296.0;
    double inset = q16(bytes + 32);
    scene s = {
        .width = get_u16(bytes + 16),
        .height = get_u16(bytes + 18),
        .near = q16(bytes + 24) + inset,
        .far = q16(bytes + 28) - inset,
        .background = names == SCENE_COLOURS ? bytes[36] : 0,
        .horizon = r->horizon,
        .levels = r->levels,
    };
    /* Half the field of view, pi times the turn: half the screen's width lies
     * this far to the side at a depth of one focal length. */
    s.focal = s.width / 2.0 / tan(turn * acos(-1.0));
    s.centre_x = s.width / 2.0;
    s.centre_y = s.height / 2.0;
    if (r->centre) {
        s.centre_x = q16(r->centre);
        s.centre_y = q16(r->centre + 4);
    }
    s.scale = r->scale ? q16(r->scale) : 0;
    if (s.width == 0 || s.height == 0 || !(s.focal > 0) || !(s.near > 0) || !(s.far > s.near))
        unusable("%s: its screen or its depths make no sense", path);
    s.image = r;
    s.moves = r->play.motion_count > 0;
    s.light = r->light;
    s.world = world_of(r, 0);
    return s;
}
