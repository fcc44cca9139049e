/* SPDX-License-Identifier: MIT */
#include "paint/surfaces_open.c"
#include "scene/scene_tables.h"

#define TEXELS  4096
#define ENTRIES 2

static uint8_t texels[TEXELS];
static fxl_scene_texture from[ENTRIES];
static fxl_texture textures[ENTRIES];
static fxl_surface surfaces[ENTRIES];
static fxl_mapped_face mapped[ENTRIES];
static fxl_corner corners[ENTRIES];
static fxl_direction normals[ENTRIES];
static uint16_t face_map[FACES];
static fxl_scene_image image;
static fxl_surface_set set;

static bool is_in_range(const fxl_scene_texture *texture)
{
    return texture->log_width <= FXL_TEXTURE_LOG_MAX && texture->log_height <= FXL_TEXTURE_LOG_MAX && texture->levels >= 1 &&
           texture->levels <= FXL_TEXTURE_LOG_MAX + 1;
}

/* Bytes of a texture's first level. */
static uint32_t first_bytes(const fxl_scene_texture *texture)
{
    const uint32_t count = 1u << (texture->log_width + texture->log_height);
    return texture->format == FXL_TEXTURE_565 ? 2 * count : texture->format == FXL_TEXTURE_4 ? count / 2 : count;
}

/* [[row]]
 * function = "texel_bytes"
 * property = "any texture in its range: at most nine times 2^17 bytes, and at least those of its first level"
 * checks = 87
 * unwind = 10
 */
void prove_texel_bytes(void)
{
    fxl_scene_texture texture;
    ASSUME(is_in_range(&texture));
    const uint32_t bytes = texel_bytes(&texture);
    ASSERT("at most nine times the most of a level", bytes <= 9u << 17);
    ASSERT("at least those of its first level", bytes >= first_bytes(&texture));
    PROOF_ENDS();
}

/* For texel_bytes. */
uint32_t any_bytes(const fxl_scene_texture *texture)
{
    const uint32_t bytes = nondet_u32();
    ASSERT("in its range", is_in_range(texture));
    ASSUME(bytes <= 9u << 17 && bytes >= first_bytes(texture));
    return bytes;
}

/* [[row]]
 * id = "check_place of a texture"
 * function = "check_place"
 * property = "any texture: one that passes lies in the texels, and so do its colours"
 * checks = 103
 * stands_in = { texel_bytes = "any_bytes" }
 */
void prove_check_place(void)
{
    fxl_scene_texture texture;
    const uint32_t size = nondet_u32();
    const fxl_status status = check_place(&texture, size);
    ASSERT("its first level lies in the texels", status != FXL_OK || (uint64_t)texture.texels + first_bytes(&texture) <= size);
    ASSERT("it begins there", status != FXL_OK || texture.texels <= size);
    ASSERT("so do its colours", status != FXL_OK || texture.format != FXL_TEXTURE_4 || (uint64_t)texture.colours + 16 <= size);
    PROOF_ENDS();
}

/* For check_place and fxl_surfaces_check. */
fxl_status any_place(const fxl_scene_texture *texture, uint32_t size)
{
    const bool good = nondet_bool();
    ASSERT("of the table", texture >= from && texture < from + ENTRIES && size <= TEXELS);
    ASSUME(!good || texture->texels <= size);
    ASSUME(!good || texture->format != FXL_TEXTURE_4 || (uint64_t)texture->colours + 16 <= size);
    return good ? FXL_OK : FXL_E_OFFSET;
}

static bool passed;
fxl_status any_set(const fxl_surface_set *found, const fxl_scene *of, uint32_t pixel_bits, fxl_scene_fault *to)
{
    (void)pixel_bits, (void)to;
    const uint32_t i = nondet_u32() % ENTRIES;
    ASSERT("of the image", of == &image.scene && found->textures == textures);
    ASSERT("texels of the image", i >= found->texture_count || (textures[i].texels >= texels && textures[i].texels <= texels + TEXELS));
    passed = nondet_bool();
    return passed ? FXL_OK : FXL_E_COUNT;
}

/* [[row]]
 * function = "fxl_surfaces_open"
 * property = "any image of up to 2 textures: texels lie in the image, a set is opened after its check, and refused, it stays"
 * checks = 367
 * stands_in = { check_place = "any_place", fxl_surfaces_check = "any_set" }
 */
void prove_surfaces_open(void)
{
    const uint32_t capacity = nondet_u32();
    const fxl_texture *before = set.textures;
    ANY_CONTENT(&image);
    ANY_CONTENT(from);
    image.surfaces.textures = from;
    image.surfaces.texels = texels;
    image.surfaces.face_map = nondet_bool() ? face_map : NULL;
    ASSUME(image.surfaces.texture_count <= ENTRIES && image.surfaces.texel_bytes <= TEXELS && capacity <= ENTRIES);
    const fxl_status status = fxl_surfaces_open(nondet_bool() ? &image : NULL, textures, capacity, nondet_bool() ? &set : NULL, &fault);
    ASSERT("opened after its check, with its tables", status != FXL_OK || (passed && set.textures == textures && set.texture_count <= capacity));
    ASSERT("refused, it stays", status == FXL_OK || set.textures == before);
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_texture"
 * property = "any texture: one that passes has its sides, levels and colours in their range"
 * checks = 118
 */
void prove_check_texture(void)
{
    fxl_texture texture;
    const bool pixels_of_16 = nondet_bool();
    texture.texels = nondet_bool() ? texels + (nondet_u32() & 3u) : NULL;
    texture.colours = nondet_bool() ? texels : NULL;
    const fxl_status status = check_texture(&texture, pixels_of_16 ? &of_565 : &of_palette);
    ASSERT("sides and levels in their range", status != FXL_OK || (texture.log_width <= 8 && texture.log_height <= 8 && texture.levels >= 1 && texture.levels <= 9));
    ASSERT("colours where it has 4 bits", status != FXL_OK || (texture.format == FXL_TEXTURE_4) == (texture.colours != NULL));
    ASSERT("16 bits in frames of them alone", status != FXL_OK || texture.format != FXL_TEXTURE_565 || (pixels_of_16 && ((uintptr_t)texture.texels & 1u) == 0));
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_surface"
 * property = "any surface: one that passes has a texture and a first corner of the tables, an opacity in its range and what it blends with"
 * checks = 121
 */
void prove_check_surface(void)
{
    fxl_surface surface;
    const bool pixels_of_16 = nondet_bool();
    set.texture_count = nondet_u32();
    set.corner_count = nondet_u32();
    set.blend = nondet_bool() ? texels : NULL;
    const fxl_status status = check_surface(&set, &surface, pixels_of_16 ? &of_565 : &of_palette);
    ASSERT("a texture of the table, or none", status != FXL_OK || surface.texture <= set.texture_count);
    ASSERT("a first corner that is not behind the table's end", status != FXL_OK || surface.first_corner <= set.corner_count);
    ASSERT("an opacity in its range", status != FXL_OK || (surface.opacity >= 1 && surface.opacity <= 16 && surface.sixteenths <= 16));
    ASSERT("a table where it blends", status != FXL_OK || pixels_of_16 || (surface.flags & FXL_SURFACE_BLEND) == 0 || set.blend != NULL);
    ASSERT("no texture of interpolated colours", status != FXL_OK || surface.texture == 0 || (surface.flags & FXL_SURFACE_COLOURS) == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "on_one_line"
 * property = "any three points below 2^30: nothing overflows"
 * checks = 97
 */
void prove_on_one_line(void)
{
    fxl_point a, b, c;
    ASSUME(is_vertex(&a) && is_vertex(&b) && is_vertex(&c));
    (void)on_one_line(&a, &b, &c);
    PROOF_ENDS();
}

/* For on_one_line and check_corner. */
bool any_line(const fxl_point *a, const fxl_point *b, const fxl_point *c)
{
    ASSERT("vertices of a checked model", is_vertex(a) && is_vertex(b) && is_vertex(c));
    return nondet_bool();
}

fxl_status any_corner(const fxl_surface_set *of, const fxl_model *model, uint32_t flags, const fxl_corner *corner)
{
    const bool good = nondet_bool();
    (void)flags;
    ASSERT("of the table", of == &set && corner >= corners && corner < corners + set.corner_count);
    ASSUME(!good || corner->vertex < model->vertex_count);
    return good ? FXL_OK : FXL_E_RANGE;
}

/* Tables of any length up to two, with any content. */
static void any_tables(void)
{
    any_checked_scene();
    ANY_CONTENT(surfaces);
    ANY_CONTENT(mapped);
    ANY_CONTENT(corners);
    ANY_CONTENT(face_map);
    ANY_CONTENT(&set);
    set.surfaces = surfaces;
    set.faces = mapped;
    set.corners = corners;
    set.normals = normals;
    set.textures = textures;
    set.face_map = face_map;
    ASSUME(set.surface_count <= ENTRIES && set.face_count <= ENTRIES && set.corner_count <= ENTRIES && set.normal_count <= ENTRIES && set.texture_count <= ENTRIES);
}

/* [[row]]
 * function = "check_corner"
 * property = "any corner of a checked scene: one that passes has a vertex and a normal of their tables, texels in their range, and colours of 24 bits; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 357
 * unwind = 8
 */
void prove_check_corner(void)
{
    any_tables();
    const fxl_corner *corner = &corners[0];
    const uint32_t flags = nondet_u32();
    const bool passes = check_corner(&set, &models[0], flags, corner) == FXL_OK, has_colour = (flags & FXL_SURFACE_COLOURS) != 0;
    ASSERT("a vertex of the model", !passes || corner->vertex < models[0].vertex_count);
    ASSERT("a normal of the table", !passes || (flags & FXL_SURFACE_LIT) == 0 || corner->normal < set.normal_count);
    ASSERT("in their range", !passes || has_colour || (WITHIN(corner->texel.u, FXL_TEXEL_MAX) && WITHIN(corner->texel.v, FXL_TEXEL_MAX)));
    ASSERT("colours of 24 bits", !passes || !has_colour || ((uint32_t)corner->texel.u < 1u << 24 && corner->texel.v == 0));
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_face"
 * property = "any mapped face of a checked scene and tables of up to 2 entries: one that passes has a surface and corners of their tables"
 * checks = 435
 * unwind = 8
 * stands_in = { on_one_line = "any_line", check_corner = "any_corner" }
 */
void prove_check_face(void)
{
    any_tables();
    const fxl_model *model = &models[0];
    const fxl_mapped_face *face = &mapped[0];
    const uint32_t i = nondet_u32();
    ASSUME(i < 3 && surfaces[0].first_corner <= set.corner_count && surfaces[1].first_corner <= set.corner_count);
    const fxl_status status = check_face(&set, &scene, model, face);
    ASSERT("a surface of the table", status != FXL_OK || face->surface < set.surface_count);
    ASSERT("corners of the table", status != FXL_OK || surfaces[face->surface].first_corner + face->corners[i] < set.corner_count);
    PROOF_ENDS();
}

/* For check_face, check_texture, check_surface, fxl_is_unit and check_faces. */
fxl_status any_face(const fxl_surface_set *of, const fxl_scene *in, const fxl_model *model, const fxl_mapped_face *face)
{
    ASSERT("a face of the table, and its model", of == &set && in == &scene && model >= models && model < models + scene.model_count && face >= mapped &&
                                                     face < mapped + set.face_count);
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * id = "check_faces of surfaces"
 * function = "check_faces"
 * property = "any face map of a checked scene and up to 2 mapped faces: one that passes has records of the table"
 * checks = 402
 * unwind = 8
 * stands_in = { check_face = "any_face" }
 */
void prove_check_faces(void)
{
    any_tables();
    const fxl_status status = check_faces(&set, &scene, &fault);
    const uint32_t i = nondet_u32();
    ASSUME(i < models[0].face_count);
    ASSERT("each is a record of the table, or none", status != FXL_OK || face_map[models[0].first_face + i] <= set.face_count);
    PROOF_ENDS();
}

fxl_status any_texture(const fxl_texture *texture, const frame_kind *kind)
{
    ASSERT("of the table", texture >= textures && texture < textures + set.texture_count && kind != NULL);
    return (fxl_status)nondet_u32();
}

fxl_status any_surface(const fxl_surface_set *of, const fxl_surface *surface, const frame_kind *kind)
{
    ASSERT("of the table", of == &set && surface >= surfaces && surface < surfaces + set.surface_count && kind != NULL);
    return (fxl_status)nondet_u32();
}

bool any_unit_of_set(const fxl_direction *normal)
{
    ASSERT("of the table", normal >= normals && normal < normals + set.normal_count);
    return nondet_bool();
}

fxl_status any_faces(const fxl_surface_set *of, const fxl_scene *in, fxl_scene_fault *to)
{
    ASSERT("of the scene", of == &set && in == &scene && to == &fault);
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "fxl_surfaces_check"
 * property = "any set of tables of up to 2 entries, or without some: nothing is out of bounds, and one that passes has the tables that it needs"
 * checks = 542
 * unwind = 8
 * stands_in = { check_texture = "any_texture", check_surface = "any_surface", fxl_is_unit = "any_unit_of_set", check_faces = "any_faces" }
 */
void prove_surfaces_check(void)
{
    any_tables();
    set.textures = nondet_bool() ? textures : NULL;
    set.normals = nondet_bool() ? normals : NULL;
    set.surfaces = nondet_bool() ? surfaces : NULL;
    set.faces = nondet_bool() ? mapped : NULL;
    set.corners = nondet_bool() ? corners : NULL;
    set.face_map = nondet_bool() ? face_map : NULL;
    const fxl_status status = fxl_surfaces_check(nondet_bool() ? &set : NULL, nondet_bool() ? &scene : NULL, nondet_u32(), &fault);
    ASSERT("tables that it needs", status != FXL_OK || (set.surfaces != NULL && set.faces != NULL && set.corners != NULL && set.face_map != NULL &&
                                                        (set.textures != NULL || set.texture_count == 0)));
    ASSERT("blended colours of a byte", status != FXL_OK || (set.blend_first <= 255 && set.blend_first + set.blend_count <= 256));
    PROOF_ENDS();
}
