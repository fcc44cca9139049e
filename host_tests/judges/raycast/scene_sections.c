/* SPDX-License-Identifier: MIT */
#include "scene_sections.h"

#include <string.h>

#include "file.h"

/* Of each kind: bytes of an entry, and the most entries. */
static const uint32_t bytes_of[KINDS] = {0,   3,   12, 2,  20, 28,  16, 24, 4,   20, 48,
                                         176, 256, 48, 40, 76, 32,  28, 20, 256, 16, 1,
                                         12,  8,   12, 2,  12, 256, 32, 2,  1,   8,  4,
                                         4,   12,  4,  4,  1};
static const uint32_t most_of[KINDS] = {
    0,     256,   1000000, 4000000, 1000000, 65535,   65535, 1000000, 1000000, 1000000, 65535,
    4,     1,     65535,   65535,   65535,   1000000, 1,     4,       64,      65535,   1 << 24,
    65535, 65535, 196605,  1000000, 65535,   256,     65535, 65535,   1 << 24, 1,       1000000,
    1,     1000000, 65536,   64,      65};

/* Takes the entry of one section, whose bytes may begin at `from`, or later if `gap`. Returns where
 * it ends. */
static uint32_t take(const char *path, const uint8_t *entry, uint32_t size, uint32_t from, int gap,
                     uint64_t *length)
{
    const uint32_t kind = get_u16(entry), at = get_u32(entry + 4), count = get_u32(entry + 8);
    const int is_known = kind < KINDS;
    if (kind == 0 || entry[3] != 0 || entry[2] != (is_known && kind != 9))
        unusable("%s: the entry of section %u is not one", path, kind);
    if (is_known && (count == 0 || count > most_of[kind]))
        unusable("%s: %u entries of section %u", path, count, kind);
    if (at % 4 != 0 || at < from || (at > from && !gap))
        unusable("%s: section %u begins at %u, not at %u", path, kind, at, from);
    *length = is_known ? (uint64_t)count * bytes_of[kind] : 0;
    if (at > size || *length > size - at)
        unusable("%s: section %u reaches outside the image", path, kind);
    return at;
}

static void need(const char *path, int is_sound, const char *what)
{
    if (!is_sound)
        unusable("%s: %s", path, what);
}

/* Which sections there are, and which counts go together. */
static void check_set(const char *path, const uint8_t *bytes, const table *s)
{
    const int light = s[KIND_LIGHT].count > 0;
    int some_surfaces = 0, some_billboards = 0;
    for (int kind = KIND_TEXTURES; kind <= KIND_BLEND_TABLE; kind++)
        some_surfaces |= s[kind].count > 0;
    for (int kind = KIND_BILLBOARDS; kind <= KIND_SPRITE_PIXELS; kind++)
        some_billboards |= s[kind].count > 0;
    for (int kind = KIND_PALETTE; kind <= KIND_INSTANCES; kind++)
        need(path, s[kind].count > 0 || kind == KIND_INDICES || kind == KIND_FACES,
             "a section is missing");
    need(path, !s[KIND_WHOLE_FACES].count || s[KIND_WHOLE_FACES].count == s[KIND_FACES].count,
         "the whole faces have not an entry for each face");
    need(path, s[KIND_PALETTE].count == 256, "its palette has not 256 entries");
    need(path, !s[KIND_POSES].count != !s[KIND_SEGMENTS].count, "it has not one path");
    need(path, !s[KIND_BEAMS].count == !s[KIND_LIT_COLOURS].count, "beams without lit colours");
    need(path, !s[KIND_MOTIONS].count == !s[KIND_MOTION_KEYS].count, "motions without keys");
    need(path, s[KIND_MOTIONS].count <= s[KIND_PLACEMENTS].count, "more motions than placements");
    need(path, s[KIND_PLACEMENTS].count <= s[KIND_INSTANCES].count,
         "more placements than instances");
    need(path, light == (s[KIND_RAMP].count > 0), "light without a ramp");
    need(path, light || !s[KIND_POINT_LIGHTS].count, "point lights without light");
    need(path,
         !some_surfaces ||
             (s[KIND_SURFACES].count && s[KIND_MAPPED_FACES].count && s[KIND_CORNERS].count),
         "a part of the surfaces is missing");
    need(path,
         !some_surfaces ||
             (s[KIND_FACE_MAP].count && s[KIND_FACE_MAP].count == s[KIND_FACES].count),
         "the face map has not an entry for each face");
    need(path, !some_billboards || (s[KIND_BILLBOARDS].count && s[KIND_SPRITE_PIXELS].count),
         "a part of the billboards is missing");
    need(path, !some_billboards || s[KIND_BILLBOARD_MAP].count == s[KIND_MODELS].count,
         "the billboard map has not an entry for each model");
    need(path, !s[KIND_LINES].count == !s[KIND_LINE_MAP].count, "lines without their map");
    need(path, !s[KIND_LINES].count || s[KIND_LINE_MAP].count == s[KIND_MODELS].count + 1,
         "the line map has not an entry for each model, and one more");
    need(path, !s[KIND_HORIZON_SINES].count == !s[KIND_HORIZON_COLOURS].count,
         "a part of the horizon is missing");
    need(path,
         !s[KIND_HORIZON_SINES].count ||
             s[KIND_HORIZON_COLOURS].count == s[KIND_HORIZON_SINES].count + 1,
         "the horizon has not a colour more than sines");
    need(path, s[KIND_BSP_NODES].count || get_u32(bytes + 84) == 0,
         "a BSP instance without a tree");
    need(path, s[KIND_BLEND_TABLE].count || get_u32(bytes + 88) == 0, "a colour of no blend table");
}

/* place field: the ray-cast oracle's reader: sizes */
static void find(const char *path, const uint8_t *bytes, uint32_t size, table *sections)
{
    const uint32_t count = get_u16(bytes + 6);
    uint32_t end = SECTIONS_AT + 12 * count, last = 0;
    int gap = 0;
    need(path, end <= size, "it ends within the table of sections");
    for (uint32_t i = 0; i < count; i++) {
        const uint8_t *entry = bytes + SECTIONS_AT + 12 * i;
        const uint32_t kind = get_u16(entry);
        uint64_t length;
        if (kind <= last)
            unusable("%s: section %u behind section %u", path, kind, last);
        const uint32_t at = take(path, entry, size, end, gap, &length);
        end = at + (uint32_t)length;
        for (; end % 4 != 0; end++)
            need(path, bytes[end] == 0, "bytes between sections are not 0");
        if (kind < KINDS)
            sections[kind] = (table){bytes + at, get_u32(entry + 8)};
        gap = kind >= KINDS;
        last = kind;
    }
    need(path, gap || end == size, "the image does not end with its last section");
}

void sections_read(const char *path, file_block *image, table sections[KINDS])
{
    const uint8_t *bytes = image->bytes;
    if (image->size < SECTIONS_AT || memcmp(bytes, "FXLS", 4) != 0)
        unusable("%s: not a scene image", path);
    if (get_u16(bytes + 4) != 9)
        unusable("%s: the scene image is of another version: build it again", path);
    const uint32_t size = get_u32(bytes + 8);
    if (size < SECTIONS_AT || size % 4 != 0 || size > image->size || size > 16u << 20)
        unusable("%s: %zu bytes of a scene image of %u", path, image->size, size);
    if (crc32_of(bytes + 16, size - 16) != get_u32(bytes + 12))
        unusable("%s: the checksum does not match", path);
    need(path, bytes[37] < 16 && (bytes[37] & 3) < 3, "the target is not known");
    image->size = size;
    memset(sections, 0, KINDS * sizeof *sections);
    find(path, bytes, size, sections);
    check_set(path, bytes, sections);
}
