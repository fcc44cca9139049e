/* SPDX-License-Identifier: MIT */
/* The sections of a scene image: where they lie, and which there are (docs/formats.md,
 * section 1.2).
 */
#include "scene_sections.h"

#include "fixel/crc.h"
#include "scene_check.h"
#include "scene_header.h"

#define MAGIC 0x534C5846u /* "FXLS" */

/* place field: a section that goes with others */
/* formats 1.1 */
static FXL_COLD fxl_status check_envelope(const fxl_image_header *head, size_t size)
{
    if (size < sizeof *head) {
        return FXL_E_SIZE;
    }
    if (head->magic != MAGIC) {
        return FXL_E_MAGIC;
    }
    if (head->version != IMAGE_VERSION) {
        return FXL_E_VERSION;
    }
    /* At most 65,535 sections of 12 bytes. */
    if (head->image_size < sizeof *head + head->section_count * sizeof(fxl_image_section) ||
        head->image_size > FXL_SCENE_IMAGE_MAX || head->image_size % 4 != 0 ||
        head->image_size > size) {
        return FXL_E_SIZE;
    }
    const uint8_t *bytes = (const uint8_t *)head;
    if (fxl_crc(FXL_CRC_START, bytes + 16, head->image_size - 16) != head->crc) {
        return FXL_E_CRC;
    }
    return head->target < 16 && head->target % 4 < 3 ? FXL_OK : FXL_E_RESERVED;
}

/* What is known of the sections, by their kinds. */
static const struct {
    uint16_t entry_size;
    uint16_t is_needed;
    uint32_t count_max;
    const char *what;
} known[] = {SECTION_TABLE};

FXL_STATIC_ASSERT(sizeof known / sizeof known[0] == SECTION_KINDS - 1, "one for each");

/* Where the next section begins; or at the earliest, behind one that is not known. */
typedef struct {
    uint32_t at;
    uint32_t kind; /* of the section before */
    bool is_exact;
} place;

/* formats 1.2 */
static FXL_COLD fxl_status check_entry(const fxl_image_section *one, const place *next)
{
    if (one->kind <= next->kind) {
        return FXL_E_OFFSET;
    }
    const bool is_known = one->kind < SECTION_KINDS;
    if (one->reserved != 0 || one->is_needed > 1 ||
        (is_known && one->is_needed != known[one->kind - 1].is_needed)) {
        return FXL_E_RESERVED;
    }
    return is_known || !one->is_needed ? FXL_OK : FXL_E_VERSION;
}

/* The bytes that rounding added behind a section are 0. */
/* formats 1.2 */
static bool is_padded(const fxl_image_header *head, uint32_t end, uint32_t rounded)
{
    for (uint32_t i = end; i < rounded; i++) {
        if (((const uint8_t *)head)[i] != 0) {
            return false;
        }
    }
    return true;
}

/* The section's place and length, after which *next is that of the one behind it. A count of at
 * most 2^24 times the size of an entry, at most 256 bytes, is below 2^33. The image's size and each
 * place are multiples of four, so that an end that lies within the image also does so rounded. */
/* formats 1.2 */
static FXL_COLD fxl_status check_place(const fxl_image_header *head, const fxl_image_section *one,
                                       place *next)
{
    const bool is_known = one->kind < SECTION_KINDS;
    uint64_t bytes = 0;
    if (is_known) {
        if (one->count == 0 || one->count > known[one->kind - 1].count_max) {
            return FXL_E_COUNT;
        }
        bytes = (uint64_t)one->count * known[one->kind - 1].entry_size;
    }
    if (one->offset % 4 != 0) {
        return FXL_E_ALIGNMENT;
    }
    if (next->is_exact ? one->offset != next->at : one->offset < next->at) {
        return FXL_E_OFFSET;
    }
    if (one->offset > head->image_size || bytes > head->image_size - one->offset) {
        return FXL_E_OFFSET;
    }
    const uint32_t end = one->offset + (uint32_t)bytes;
    next->at = (end + 3u) & ~3u;
    next->kind = one->kind;
    next->is_exact = is_known;
    return is_padded(head, end, next->at) ? FXL_OK : FXL_E_RESERVED;
}

/* A fault of a known section names it; of another, its entry. */
static fxl_status fault_of(const fxl_image_section *list, uint32_t number, fxl_status status,
                           fxl_scene_fault *fault)
{
    const uint32_t kind = list[number].kind;
    return status == FXL_E_VERSION || kind == 0 || kind >= SECTION_KINDS
               ? fxl_fault_at(fault, "section", number, status)
               : fxl_fault_at(fault, known[kind - 1].what, 0, status);
}

static fxl_status missing(uint32_t kind, fxl_scene_fault *fault)
{
    return fxl_fault_at(fault, known[kind - 1].what, 0, FXL_E_COUNT);
}

const fxl_image_section *fxl_scene_section(const fxl_image_header *head, uint32_t kind)
{
    const fxl_image_section *list = (const fxl_image_section *)(const void *)(head + 1);
    for (uint32_t i = 0; i < head->section_count; i++) {
        if (list[i].kind == kind) {
            return &list[i];
        }
    }
    return NULL;
}

static __attribute__((noinline)) uint32_t count_of(const fxl_image_header *head, uint32_t kind)
{
    const fxl_image_section *one = fxl_scene_section(head, kind);
    return one != NULL ? one->count : 0;
}

/* Which sections there must be, and which go together. */
/* formats 1.2 */
static FXL_COLD fxl_status check_presence(const fxl_image_header *head, fxl_scene_fault *fault)
{
    static const struct {
        uint8_t first, last, needed[4]; /* where one of the kinds first..last is, those must be */
    } sets[] = {
        {SECTION_BEAMS, SECTION_LIT_COLOURS, {SECTION_BEAMS, SECTION_LIT_COLOURS, 0, 0}},
        {SECTION_MOTIONS,
         SECTION_KEYS_OF_MOTIONS,
         {SECTION_PLACEMENTS, SECTION_MOTIONS, SECTION_KEYS_OF_MOTIONS, 0}},
        {SECTION_LIGHT, SECTION_RAMP, {SECTION_LIGHT, SECTION_RAMP, 0, 0}},
        {SECTION_TEXTURES,
         SECTION_BLEND_TABLE,
         {SECTION_SURFACES, SECTION_MAPPED_FACES, SECTION_CORNERS, SECTION_FACE_MAP}},
        {SECTION_BILLBOARDS,
         SECTION_SPRITE_PIXELS,
         {SECTION_BILLBOARDS, SECTION_BILLBOARD_MAP, SECTION_SPRITE_PIXELS, 0}},
        {SECTION_LINES, SECTION_LINE_MAP, {SECTION_LINES, SECTION_LINE_MAP, 0, 0}},
        {SECTION_HORIZON_SINES,
         SECTION_HORIZON_COLOURS,
         {SECTION_HORIZON_SINES, SECTION_HORIZON_COLOURS, 0, 0}},
    };
    for (uint32_t kind = SECTION_PALETTE; kind <= SECTION_INSTANCES; kind++) {
        if (kind != SECTION_INDICES && kind != SECTION_FACES && count_of(head, kind) == 0) {
            return missing(kind, fault);
        }
    }
    if ((count_of(head, SECTION_POSES) != 0) == (count_of(head, SECTION_SEGMENTS) != 0)) {
        return missing(SECTION_POSES, fault);
    }
    for (size_t i = 0; i < sizeof sets / sizeof sets[0]; i++) {
        uint32_t any = 0;
        for (uint32_t kind = sets[i].first; kind <= sets[i].last; kind++) {
            any |= count_of(head, kind);
        }
        for (size_t k = 0; any != 0 && k < sizeof sets[i].needed; k++) {
            const uint32_t kind = sets[i].needed[k];
            if (kind != 0 && count_of(head, kind) == 0) {
                return missing(kind, fault);
            }
        }
    }
    return FXL_OK;
}

/* Counts that go with others, and numbers of the header that go with a section. */
/* formats 1.2, 1.15 */
static FXL_COLD fxl_status check_counts(const fxl_image_header *head, fxl_scene_fault *fault)
{
    static const struct {
        uint8_t map, of, more; /* a map has an entry for each entry of the other section, and more */
    } maps[] = {
        {SECTION_FACE_MAP, SECTION_FACES, 0},
        {SECTION_WHOLE_FACES, SECTION_FACES, 0},
        {SECTION_BILLBOARD_MAP, SECTION_MODELS, 0},
        {SECTION_LINE_MAP, SECTION_MODELS, 1},
        {SECTION_HORIZON_COLOURS, SECTION_HORIZON_SINES, 1},
    };
    if (count_of(head, SECTION_PALETTE) != 256) {
        return missing(SECTION_PALETTE, fault);
    }
    if (count_of(head, SECTION_PLACEMENTS) > count_of(head, SECTION_INSTANCES)) {
        return missing(SECTION_PLACEMENTS, fault);
    }
    if (count_of(head, SECTION_MOTIONS) > count_of(head, SECTION_PLACEMENTS)) {
        return missing(SECTION_MOTIONS, fault);
    }
    for (size_t i = 0; i < sizeof maps / sizeof maps[0]; i++) {
        const uint32_t count = count_of(head, maps[i].map);
        if (count != 0 && count != count_of(head, maps[i].of) + maps[i].more) {
            return missing(maps[i].map, fault);
        }
    }
    if (count_of(head, SECTION_BSP_NODES) == 0 && head->bsp_instance != 0) {
        return fxl_fault_at(fault, "BSP node table", 0, FXL_E_RESERVED);
    }
    return count_of(head, SECTION_BLEND_TABLE) != 0 || head->blend_first == 0
               ? FXL_OK
               : fxl_fault_at(fault, "blend table", 0, FXL_E_RESERVED);
}

static FXL_COLD fxl_status check_list(const fxl_image_header *head, fxl_scene_fault *fault)
{
    const fxl_image_section *list = (const fxl_image_section *)(const void *)(head + 1);
    place next = {(uint32_t)(sizeof *head + head->section_count * sizeof *list), 0, true};
    for (uint32_t i = 0; i < head->section_count; i++) {
        fxl_status status = check_entry(&list[i], &next);
        if (status == FXL_OK) {
            status = check_place(head, &list[i], &next);
        }
        if (status != FXL_OK) {
            return fault_of(list, i, status, fault);
        }
    }
    return next.is_exact && next.at != head->image_size
               ? fxl_fault_at(fault, "image", 0, FXL_E_SIZE)
               : FXL_OK;
}

FXL_COLD fxl_status fxl_scene_sections_check(const fxl_image_header *head, size_t size,
                                             fxl_scene_fault *fault)
{
    fxl_status status = check_envelope(head, size);
    if (status != FXL_OK) {
        return fxl_fault_at(fault, "image", 0, status);
    }
    status = check_list(head, fault);
    if (status == FXL_OK) {
        status = check_presence(head, fault);
    }
    return status == FXL_OK ? check_counts(head, fault) : status;
}
