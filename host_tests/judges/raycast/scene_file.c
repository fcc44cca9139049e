/* SPDX-License-Identifier: MIT */
#include "scene_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"

enum {
    HEADER = 160,
    BEAM_HEADER = 176,
    CLUSTER_HEADER = 184,
    TURN_HEADER = 208,
    LIGHT_HEADER = 232,
    SURFACE_HEADER = 296,
    BEAM_COUNT = 164,
    VERTEX = 12,
    CORNER = 2,
    FACE = 20,
    MODEL = 28,
    INSTANCE = 16,
    TURN = 40,
    MOTION = 76,
    KEY = 32,
    LIGHT = 28,
    POINT_LIGHT = 20,
    LEVEL = 256,
    TEXTURE = 16,
    SURFACE = 8,
    MAPPED_FACE = 36,
    OPAQUE = 16
};

typedef struct {
    const uint8_t *at;
    uint32_t count;
} table;

typedef struct reader {
    const char *path;
    file_block image;
    table vertices, corners, faces, models, instances;
    play_tables play;
    light_tables light;
    scene_names names;
    table textures, surfaces, mapped, map; /* where faces that let through are left out */
} reader;

static double q16(const uint8_t *at)
{
    return get_i32(at) / 65536.0;
}

static vector point_at(const uint8_t *at)
{
    return (vector){q16(at), q16(at + 4), q16(at + 8)};
}

static table table_at(const reader *r, uint32_t field, uint32_t entry, const char *what)
{
    uint32_t offset = get_u32(r->image.bytes + field);
    uint32_t count = get_u32(r->image.bytes + field + 4);
    if ((uint64_t)offset + (uint64_t)count * entry > r->image.size || count == 0)
        unusable("%s: its %s do not lie inside the file", r->path, what);
    return (table){r->image.bytes + offset, count};
}

static const uint8_t *entry_of(const reader *r, table t, uint64_t index, uint32_t size,
                               const char *what)
{
    if (index >= t.count)
        unusable("%s: %s %llu of %u", r->path, what, (unsigned long long)index, t.count);
    return t.at + index * size;
}

/* Of an image of version 5: its turns, and its motions if it has some. */
static void open_turns(reader *r)
{
    const table turns = table_at(r, CLUSTER_HEADER, TURN, "turns");
    r->play.turns = turns.at;
    r->play.turn_count = turns.count;
    if (get_u32(r->image.bytes + CLUSTER_HEADER + 12) > 0) {
        const table motions = table_at(r, CLUSTER_HEADER + 8, MOTION, "motions");
        const table keys = table_at(r, CLUSTER_HEADER + 16, KEY, "keys");
        r->play.motions = motions.at;
        r->play.motion_count = motions.count;
        r->play.keys = keys.at;
        r->play.key_count = keys.count;
    }
    if (turns.count > r->instances.count || r->play.motion_count > turns.count)
        unusable("%s: more turns than instances, or more motions than turns", r->path);
}

/* Of an image of version 6: its light. */
static void open_light(reader *r)
{
    const table ramp = table_at(r, TURN_HEADER + 16, LEVEL, "levels");
    r->light.base = table_at(r, TURN_HEADER, LIGHT, "light").at;
    r->light.ramp = ramp.at;
    r->light.levels = ramp.count;
    if (get_u32(r->image.bytes + TURN_HEADER + 12) > 0) {
        const table points = table_at(r, TURN_HEADER + 8, POINT_LIGHT, "point lights");
        r->light.points = points.at;
        r->light.point_count = points.count;
    }
    if (ramp.count < 2)
        unusable("%s: a ramp of one level", r->path);
}

/* Of an image with surfaces: what says which faces let through. */
static void open_surfaces(reader *r)
{
    if (get_u32(r->image.bytes + 236) > 0)
        r->textures = table_at(r, 232, TEXTURE, "textures");
    r->surfaces = table_at(r, 248, SURFACE, "surfaces");
    r->mapped = table_at(r, 256, MAPPED_FACE, "mapped faces");
    r->map = table_at(r, 264, 2, "face map");
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
    const bool is_blended = surface[3] & 2, has_pattern = surface[4] < OPAQUE;
    return is_blended || has_pattern ||
           (texture > 0 && entry_of(r, r->textures, texture - 1, TEXTURE, "texture")[11] & 2);
}

/* Whether the image's header is one that can be read. Only names can be told where there are beams
 * or surfaces, whose colours no ray knows. */
static bool is_known(const reader *r, uint16_t version, uint16_t header)
{
    const uint8_t *bytes = r->image.bytes;
    if (r->image.size < header)
        return false;
    if (r->names == SCENE_COLOURS && header > HEADER && get_u32(bytes + BEAM_COUNT) != 0)
        return false;
    return ((version == 2 || version == 3) && header == HEADER) ||
           (version == 3 && header == BEAM_HEADER) || (version == 4 && header == CLUSTER_HEADER) ||
           (version == 5 && header == TURN_HEADER) || (version == 6 && header == LIGHT_HEADER) ||
           (version == 6 && header == SURFACE_HEADER && r->names != SCENE_COLOURS);
}

static void open_image(reader *r, const char *path)
{
    r->path = path;
    r->image = file_read(path);
    const uint8_t *bytes = r->image.bytes;
    if (r->image.size < HEADER || memcmp(bytes, "FXLS", 4) != 0)
        unusable("%s: not a scene image", path);
    uint16_t version = get_u16(bytes + 4), header = get_u16(bytes + 6);
    if (!is_known(r, version, header))
        unusable("%s: this version of the scene image is not known", path);
    uint32_t size = get_u32(bytes + 8);
    if (size < HEADER || size > r->image.size)
        unusable("%s: %zu bytes of a scene image of %u", path, r->image.size, size);
    if (crc32_of(bytes + 16, size - 16) != get_u32(bytes + 12))
        unusable("%s: the checksum does not match", path);
    r->image.size = size;
    r->vertices = table_at(r, 88, VERTEX, "vertices");
    r->corners = table_at(r, 96, CORNER, "indices");
    r->faces = table_at(r, 104, FACE, "faces");
    r->models = table_at(r, 112, MODEL, "models");
    r->instances = table_at(r, 120, INSTANCE, "instances");
    r->play.instances = r->instances.at;
    r->play.instance_count = r->instances.count;
    if (version == 5 || (version == 6 && get_u32(bytes + CLUSTER_HEADER + 4) > 0))
        open_turns(r);
    if (version == 6 && r->names == SCENE_COLOURS)
        open_light(r);
    if (header == SURFACE_HEADER && r->names == SCENE_NAMES_OPAQUE)
        open_surfaces(r);
}

static const uint8_t *model_of(const reader *r, const uint8_t *instance)
{
    return entry_of(r, r->models, get_u16(instance + 12), MODEL, "model");
}

static void add_face(const reader *r, const placing *place, const uint8_t *model,
                     const uint8_t *face, uint8_t colour, world *w)
{
    world_polygon *polygon = &w->polygons[w->polygon_count++];
    *polygon = (world_polygon){.first = w->corner_count, .count = face[16], .colour = colour};
    if (polygon->count < 3)
        unusable("%s: a face of %u vertices", r->path, polygon->count);
    vector low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < polygon->count; i++) {
        uint64_t corner = (uint64_t)get_u32(face + 12) + i;
        uint64_t vertex = get_u16(entry_of(r, r->corners, corner, CORNER, "index"));
        vertex += get_u32(model);
        const vector at = point_at(entry_of(r, r->vertices, vertex, VERTEX, "vertex"));
        low = (vector){fmin(low.x, at.x), fmin(low.y, at.y), fmin(low.z, at.z)};
        high = (vector){fmax(high.x, at.x), fmax(high.y, at.y), fmax(high.z, at.z)};
        w->corners[w->corner_count++] = placing_point(place, at);
    }
    placing turned = *place;
    turned.centre = (vector){0, 0, 0};
    turned.scale = 1;
    const vector normal = {get_i32(face), get_i32(face + 4), get_i32(face + 8)};
    polygon->lit =
        (light_face){placing_point(&turned, vector_times(normal, 1 / 1073741824.0)),
                     placing_point(place, vector_times(vector_plus(low, high), 0.5)), face[17]};
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
                             r->names == SCENE_COLOURS ? face[17] : name_of(o, f), &w);
                faces++;
                corners += face[16];
            }
        }
        if (pass == 0) {
            if (faces == 0 || faces > 50000000 || corners > 500000000)
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
    };
    /* Half the field of view, pi times the turn: half the screen's width lies
     * this far to the side at a depth of one focal length. */
    s.focal = s.width / 2.0 / tan(turn * acos(-1.0));
    s.centre_x = s.width / 2.0;
    s.centre_y = s.height / 2.0;
    if (bytes[38] != 0) {
        const uint8_t *centre = bytes + get_u16(bytes + 6);
        if (centre + 8 > bytes + r->image.size)
            unusable("%s: it ends before the centre of its lens", path);
        s.centre_x = q16(centre);
        s.centre_y = q16(centre + 4);
    }
    if (s.width == 0 || s.height == 0 || !(s.focal > 0) || !(s.near > 0) || !(s.far > s.near))
        unusable("%s: its screen or its depths make no sense", path);
    s.image = r;
    s.moves = r->play.motion_count > 0;
    s.light = r->light;
    s.world = world_of(r, 0);
    return s;
}
