/* SPDX-License-Identifier: MIT */
#include "reference/billboard.h"

#include <math.h>
#include <stdlib.h>

#include "reference/camera.h"
/* place field: the reference's reader: sizes of entries, and offsets as numbers */
#include "reference/sections.h"
#include "reference/placement.h"

enum {
    BOARD_BYTES = 32,
    SCREEN_MAX = 4095,
    OPAQUE = 256
};

/* What paints every billboard: its picture alone, exactly at every pixel. */
static const ref_surface plain = {.texture = 1, .division = REF_DIVIDE_1, .opacity = REF_OPAQUE};

/* --- reading ------------------------------------------------------------------------------- */

/* Where the pixels of a sprite are. */
typedef struct {
    const uint8_t *pixels;
    uint32_t bytes, at, colours;
    int width, height, bits, key;
} sprite_source;

static int value_at(const sprite_source *from, int x, int y)
{
    const uint64_t row = (uint64_t)y * (((uint64_t)from->width * (unsigned)from->bits + 7) / 8);
    const uint64_t bit = (uint64_t)x * (unsigned)from->bits;
    const int byte = from->pixels[from->at + row + bit / 8];
    return byte >> (8 - from->bits - (int)(bit % 8)) & ((1 << from->bits) - 1);
}

/* A palette index that nothing of the sprite is drawn in: of 256 values one is not drawn. */
static int unused_colour(const bool used[256])
{
    int colour = 0;
    while (colour < 255 && used[colour]) {
        colour++;
    }
    return colour;
}

static bool read_sprite(const sprite_source *from, ref_texture *texture)
{
    ref_texture_level *level = &texture->levels[0];
    const size_t count = (size_t)from->width * (size_t)from->height;
    int *values = malloc((count + 1) * sizeof *values);
    bool used[256] = {false};
    level->colours = malloc((count + 1) * sizeof *level->colours);
    level->width = from->width;
    level->height = from->height;
    for (size_t i = 0; values && level->colours && i < count; i++) {
        values[i] = value_at(from, (int)(i % (size_t)from->width), (int)(i / (size_t)from->width));
        level->colours[i] = from->bits == 8 ? (uint8_t)values[i]
                                            : from->pixels[from->colours + (uint32_t)values[i]];
        used[level->colours[i]] |= values[i] != from->key;
    }
    texture->clamps = true;
    texture->level_count = 1;
    texture->is_keyed = from->key < OPAQUE;
    texture->key = texture->is_keyed ? (uint8_t)unused_colour(used) : 0;
    for (size_t i = 0; values && level->colours && i < count; i++) {
        level->colours[i] = values[i] == from->key ? texture->key : level->colours[i];
    }
    const bool made = values && level->colours;
    free(values);
    return made;
}

static bool read_board(const uint8_t *p, const uint8_t *pixels, uint32_t bytes,
                       ref_billboard *board)
{
    const sprite_source from = {pixels,         bytes,           ref_u32(p), ref_u32(p + 4),
                                ref_u16(p + 8), ref_u16(p + 10), p[14],      ref_u16(p + 12)};
    const uint64_t row = ((uint64_t)from.width * (unsigned)from.bits + 7) / 8;
    board->width = ref_i32(p + 16) / REF_ONE;
    board->height = ref_i32(p + 20) / REF_ONE;
    board->anchor_x = ref_i32(p + 24) / REF_ONE;
    board->anchor_y = ref_i32(p + 28) / REF_ONE;
    return (from.bits == 1 || from.bits == 4 || from.bits == 8) && from.width > 0 &&
           from.height > 0 && from.at + row * (uint64_t)from.height <= bytes &&
           (from.bits == 8 || from.colours + (1ull << from.bits) <= bytes) &&
           read_sprite(&from, &board->texture);
}

bool ref_billboards_read(const uint8_t *bytes, ref_scene *scene)
{
    uint32_t count, maps, pixel_bytes;
    const uint8_t *p = ref_section(bytes, REF_BILLBOARDS, &count);
    const uint8_t *map = ref_section(bytes, REF_BILLBOARD_MAP, &maps);
    const uint8_t *pixels = ref_section(bytes, REF_SPRITE_PIXELS, &pixel_bytes);
    if (!p) {
        return true;
    }
    ref_billboards *made = calloc(1, sizeof *made);
    scene->billboards = made;
    if (!made) {
        return false;
    }
    made->count = count;
    made->boards = calloc(made->count + 1u, sizeof *made->boards);
    made->model_map = calloc(scene->model_count, sizeof *made->model_map);
    if (!made->boards || !made->model_map) {
        return false;
    }
    for (uint32_t i = 0; i < made->count; i++) {
        if (!read_board(p + BOARD_BYTES * (size_t)i, pixels, pixel_bytes, &made->boards[i])) {
            return false;
        }
    }
    for (uint32_t i = 0; i < maps; i++) {
        made->model_map[i] = ref_u16(map + 2 * (size_t)i);
        if (made->model_map[i] > made->count) {
            return false;
        }
    }
    return true;
}

void ref_billboards_close(ref_billboards *billboards)
{
    for (uint32_t i = 0; billboards && billboards->boards && i < billboards->count; i++) {
        free(billboards->boards[i].texture.levels[0].colours);
    }
    if (billboards) {
        free(billboards->boards);
        free(billboards->model_map);
    }
    free(billboards);
}

/* --- drawing ------------------------------------------------------------------------------- */

const ref_billboard *ref_billboard_of(const ref_scene *scene, const ref_instance *instance)
{
    const ref_billboards *billboards = scene->billboards;
    const uint16_t number = billboards ? billboards->model_map[instance->model] : 0;
    return number ? &billboards->boards[number - 1] : NULL;
}

/* The picture on the rectangle, of which the left upper corner and two sides are known. rounding:
 * by how many texels 0.52/65536 pixel of both corners may move it, and what an off-centre lens
 * rounds. */
static void find_look(const ref_billboard *board, const ref_screen_point *left_top,
                      const ref_screen_point *right_bottom, ref_surface_view *look)
{
    const ref_texture_level *level = &board->texture.levels[0];
    look->surface = &plain;
    look->is_billboard = true;
    look->texture = &board->texture;
    look->level = level;
    look->scales[0] = look->scales[1] = 1;
    look->steps[0][REF_U] = level->width;
    look->steps[1][REF_V] = level->height;
    look->rounding[REF_U] = 0.55 * level->width / (right_bottom->x - left_top->x) / REF_ONE;
    look->rounding[REF_V] = 0.55 * level->height / (right_bottom->y - left_top->y) / REF_ONE;
}

static double within(double value, double most)
{
    return fmin(fmax(value, 0), most);
}

/* The part of the rectangle that is on the screen. */
static void find_outline(const ref_lens *lens, const ref_screen_point *left_top,
                         const ref_screen_point *right_bottom, ref_screen_polygon *outline)
{
    const double left = within(left_top->x, lens->width), top = within(left_top->y, lens->height);
    const double right = within(right_bottom->x, lens->width);
    const double bottom = within(right_bottom->y, lens->height);
    outline->count = 4;
    outline->points[0] = (ref_screen_point){left, top};
    outline->points[1] = (ref_screen_point){right, top};
    outline->points[2] = (ref_screen_point){right, bottom};
    outline->points[3] = (ref_screen_point){left, bottom};
}

static bool is_on_plane(double distance)
{
    return fabs(distance) <= SCREEN_MAX;
}

ref_billboard_result ref_billboard_look(const ref_scene *scene, const ref_camera *camera,
                                        const ref_lens *lens, const ref_instance *instance,
                                        ref_drawn *drawn)
{
    const ref_billboard *board = ref_billboard_of(scene, instance);
    const ref_placement *placement = ref_placement_of(scene, instance);
    const double scale = placement ? placement->scale / REF_ONE : 1;
    const ref_point centre = ref_point_from_lattice(&instance->centre);
    const ref_view_point at = ref_transform_point(camera, &centre);
    const double near_z = lens->near_z + lens->inset, far_z = lens->far_z - lens->inset;
    const double bound = 0x1p-28 * (1 + fabs((double)at.x) + fabs((double)at.y) + (double)at.z);
    const double inside = fmin((double)at.z - near_z, far_z - (double)at.z);
    if (inside < -bound) {
        return REF_BILLBOARD_OUTSIDE;
    }
    ref_surface_view *look = &drawn->look;
    look->corner = (ref_view_point){at.x - scale * board->anchor_x,
                                    at.y + scale * (board->height - board->anchor_y), at.z};
    look->sides[0] = (ref_view_point){scale * board->width, 0, 0};
    look->sides[1] = (ref_view_point){0, -scale * board->height, 0};
    const ref_view_point lowest = {look->corner.x + look->sides[0].x,
                                   look->corner.y + look->sides[1].y, at.z};
    const ref_screen_point left_top = ref_project_point(lens, &look->corner);
    const ref_screen_point right_bottom = ref_project_point(lens, &lowest);
    if (!is_on_plane(left_top.x) || !is_on_plane(left_top.y) || !is_on_plane(right_bottom.x) ||
        !is_on_plane(right_bottom.y)) {
        return REF_BILLBOARD_REFUSED;
    }
    if (right_bottom.x <= 0 || left_top.x >= lens->width || right_bottom.y <= 0 ||
        left_top.y >= lens->height) {
        return REF_BILLBOARD_OUTSIDE;
    }
    if (lens->scale != 0) {
        look->corner.z = 1;
    }
    find_look(board, &left_top, &right_bottom, look);
    drawn->depth = (ref_depth_plane){.normal = {0, 0, 1}, .height = at.z, .slack = 0x1p-26};
    drawn->in_doubt = inside < bound;
    find_outline(lens, &left_top, &right_bottom, drawn->in_doubt ? &drawn->most : &drawn->polygon);
    if (inside >= 0) {
        find_outline(lens, &left_top, &right_bottom, &drawn->polygon);
    }
    return inside >= 0 ? REF_BILLBOARD_DRAWN : REF_BILLBOARD_OUTSIDE;
}
