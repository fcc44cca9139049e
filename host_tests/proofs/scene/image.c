/* SPDX-License-Identifier: MIT */
#include "scene/scene_sections.c"
#include "math/core.h"
#include "proof.h"

#define SECTIONS 31 /* more than there are kinds */

/* [[row]]
 * function = "fxl_scene_section"
 * property = "any header of up to 31 sections: nothing is out of bounds, and what is found is an entry of the kind"
 * checks = 53
 * unwind = 32
 */
void prove_scene_section(void)
{
    struct {
        fxl_image_header head;
        fxl_image_section list[SECTIONS];
    } image;
    const uint32_t kind = nondet_u32();
    ASSUME(image.head.section_count <= SECTIONS);
    const fxl_image_section *found = fxl_scene_section(&image.head, kind);
    ASSERT("an entry of the table, of the kind", found == NULL || (found >= image.list && found < image.list + image.head.section_count && found->kind == kind));
    PROOF_ENDS();
}

static union {
    fxl_image_header head;
    uint8_t bytes[4096];
} image;

/* [[row]]
 * function = "check_place"
 * property = "any entry of any image of up to 4,096 bytes: a table that is taken lies in the image, aligned, and before the next"
 * checks = 158
 */
void prove_check_place(void)
{
    fxl_image_section one;
    place next;
    const uint32_t before = next.at;
    ANY_CONTENT(&image);
    /* as check_envelope and check_entry leave them */
    ASSUME(image.head.image_size <= sizeof image && image.head.image_size % 4 == 0);
    ASSUME(next.at % 4 == 0 && next.at >= sizeof image.head && one.kind >= 1);
    const fxl_status status = check_place(&image.head, &one, &next);
    const uint64_t bytes = one.kind < SECTION_KINDS ? (uint64_t)one.count * known[one.kind - 1].entry_size : 0;
    ASSERT("the table lies in the image", status != FXL_OK || (one.offset >= sizeof image.head && one.offset + bytes <= image.head.image_size));
    ASSERT("aligned, and behind the header", status != FXL_OK || one.offset % 4 == 0);
    ASSERT("the next one begins behind it", status != FXL_OK || (next.at >= one.offset + bytes && next.at >= before && next.at <= image.head.image_size && next.at % 4 == 0));
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_entry"
 * property = "any entry: nothing is out of bounds, and kinds rise"
 * checks = 52
 */
void prove_check_entry(void)
{
    fxl_image_section one;
    place next;
    const fxl_status status = check_entry(&one, &next);
    ASSERT("kinds rise", status != FXL_OK || one.kind > next.kind);
    PROOF_ENDS();
}

uint32_t fxl_crc(uint32_t crc, const void *bytes, size_t count)
{
    (void)crc;
    ASSERT("bytes of the image", count <= sizeof image - 16 && __CPROVER_r_ok(bytes, count));
    return nondet_u32();
}

/* [[row]]
 * function = "check_envelope"
 * property = "any bytes, up to 4,096: what is read lies in the block, and so does the table of sections"
 * checks = 78
 * stubs = { fxl_crc = "any answer, for bytes of the image" }
 */
void prove_check_envelope(void)
{
    const size_t size = nondet_size();
    ANY_CONTENT(&image);
    ASSUME(size <= sizeof image);
    const fxl_status status = check_envelope(&image.head, size);
    ASSERT("the sections' table lies in it", status != FXL_OK || (image.head.image_size <= size && image.head.image_size >=
                                                                 sizeof image.head + image.head.section_count * sizeof(fxl_image_section)));
    PROOF_ENDS();
}

/* --- the list of sections, entry by entry ------------------------------------------------------------------ */

/* For fxl_scene_section: any entry of the kind, or none. */
static fxl_image_section found_section;
const fxl_image_section *any_section(const fxl_image_header *head, uint32_t kind)
{
    ASSERT("of the image", head == &image.head);
    found_section.kind = fxl_low_16(kind);
    found_section.count = nondet_u32();
    return nondet_bool() ? &found_section : NULL;
}

/* [[row]]
 * id = "count_of of sections"
 * function = "count_of"
 * property = "any kind: nothing is out of bounds"
 * checks = 7
 * stands_in = { fxl_scene_section = "any_section" }
 * stubs = { fxl_crc = "not called" }
 */
void prove_count_of(void)
{
    (void)count_of(&image.head, nondet_u32());
    PROOF_ENDS();
}

/* For count_of: any count, the same for a kind. */
static uint32_t counts[SECTION_KINDS];
uint32_t any_count(const fxl_image_header *head, uint32_t kind)
{
    ASSERT("a kind", head == &image.head && kind >= 1 && kind < SECTION_KINDS);
    return counts[kind];
}

/* [[row]]
 * function = "check_presence"
 * property = "any counts: an image that passes has the tables that every scene has, one path, and what goes together"
 * checks = 30
 * unwind = 32
 * stands_in = { count_of = "any_count" }
 * stubs = { fxl_crc = "not called" }
 */
void prove_check_presence(void)
{
    fxl_scene_fault fault;
    ANY_CONTENT(counts);
    const fxl_status status = check_presence(&image.head, &fault);
    const uint32_t kind = nondet_u32();
    ASSUME(kind >= SECTION_PALETTE && kind <= SECTION_INSTANCES && kind != SECTION_INDICES);
    ASSERT("the tables that every scene has", status != FXL_OK || counts[kind] != 0);
    ASSERT("one path", status != FXL_OK || (counts[SECTION_POSES] == 0) != (counts[SECTION_SEGMENTS] == 0));
    ASSERT("beams with their colours", status != FXL_OK || (counts[SECTION_BEAMS] == 0) == (counts[SECTION_LIT_COLOURS] == 0));
    ASSERT("motions with placements", status != FXL_OK || counts[SECTION_MOTIONS] == 0 || (counts[SECTION_PLACEMENTS] != 0 && counts[SECTION_KEYS_OF_MOTIONS] != 0));
    ASSERT("surfaces with their corners", status != FXL_OK || (counts[SECTION_SURFACES] == 0) == (counts[SECTION_CORNERS] == 0));
    ASSERT("light with its ramp", status != FXL_OK || (counts[SECTION_LIGHT] == 0) == (counts[SECTION_RAMP] == 0));
    PROOF_ENDS();
}

/* [[row]]
 * id = "check_counts of sections"
 * function = "check_counts"
 * property = "any counts: of an image that passes tables are as long as those that they go with"
 * checks = 31
 * stands_in = { count_of = "any_count" }
 * stubs = { fxl_crc = "not called" }
 */
void prove_check_counts(void)
{
    fxl_scene_fault fault;
    ANY_CONTENT(counts);
    ANY_CONTENT(&image);
    const fxl_status status = check_counts(&image.head, &fault);
    ASSERT("256 colours", status != FXL_OK || counts[SECTION_PALETTE] == 256);
    ASSERT("no more placements than instances", status != FXL_OK || counts[SECTION_PLACEMENTS] <= counts[SECTION_INSTANCES]);
    ASSERT("no more motions than placements", status != FXL_OK || counts[SECTION_MOTIONS] <= counts[SECTION_PLACEMENTS]);
    ASSERT("maps as long as what they map", status != FXL_OK || ((counts[SECTION_FACE_MAP] == 0 || counts[SECTION_FACE_MAP] == counts[SECTION_FACES]) &&
                                                                (counts[SECTION_BILLBOARD_MAP] == 0 ||
                                                                 counts[SECTION_BILLBOARD_MAP] == counts[SECTION_MODELS])));
    PROOF_ENDS();
}

/* For check_entry and check_place: what their rows assume and assert. */
fxl_status any_entry(const fxl_image_section *one, const place *next)
{
    const bool good = nondet_bool();
    ASSERT("an entry of the table", (const uint8_t *)(one + 1) <= image.bytes + image.head.image_size);
    ASSUME(!good || one->kind > next->kind);
    return good ? FXL_OK : FXL_E_OFFSET;
}

fxl_status any_place(const fxl_image_header *head, const fxl_image_section *one, place *next)
{
    const uint32_t before = next->at;
    const bool good = nondet_bool();
    ASSERT("behind what was taken", head == &image.head && next->at % 4 == 0 && next->at >= sizeof image.head && next->at <= head->image_size &&
                                        one->kind >= 1);
    next->at = nondet_u32();
    next->kind = one->kind;
    next->is_exact = nondet_bool();
    ASSUME(!good || (next->at >= before && next->at <= image.head.image_size && next->at % 4 == 0));
    return good ? FXL_OK : FXL_E_COUNT;
}

#define ENTRIES 8

/* [[row]]
 * function = "check_list"
 * property = "any image of up to 4,096 bytes and 8 sections: each entry is checked in turn, behind what was taken before"
 * checks = 168
 * unwind = 10
 * stands_in = { check_entry = "any_entry", check_place = "any_place" }
 * stubs = { fxl_crc = "not called" }
 */
void prove_check_list(void)
{
    fxl_scene_fault fault;
    ANY_CONTENT(&image);
    /* as check_envelope leaves it */
    ASSUME(image.head.section_count <= ENTRIES && image.head.image_size <= sizeof image && image.head.image_size % 4 == 0);
    ASSUME(image.head.image_size >= sizeof image.head + image.head.section_count * sizeof(fxl_image_section));
    (void)check_list(&image.head, &fault);
    PROOF_ENDS();
}

/* For check_envelope, check_list, check_presence and check_counts: any status. */
static unsigned passed;
fxl_status any_envelope(const fxl_image_header *head, size_t size)
{
    (void)size;
    ASSERT("of the image", head == &image.head && passed == 0);
    passed = nondet_bool();
    return passed ? FXL_OK : FXL_E_CRC;
}

fxl_status any_check(const fxl_image_header *head, fxl_scene_fault *fault)
{
    (void)fault;
    ASSERT("after those before it passed", head == &image.head && passed >= 1 && passed <= 3);
    if (nondet_bool()) {
        passed = 0;
        return FXL_E_COUNT;
    }
    passed++;
    return FXL_OK;
}

/* [[row]]
 * function = "fxl_scene_sections_check"
 * property = "any image: one that passes was checked by all, in their order"
 * checks = 15
 * stands_in = { check_envelope = "any_envelope", check_list = "any_check", check_presence = "any_check", check_counts = "any_check" }
 * stubs = { fxl_crc = "not called" }
 */
void prove_scene_sections_check(void)
{
    fxl_scene_fault fault;
    passed = 0;
    const fxl_status status = fxl_scene_sections_check(&image.head, nondet_size(), nondet_bool() ? &fault : NULL);
    ASSERT("all four checks passed", status != FXL_OK || passed == 4);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fault_of"
 * property = "any entry: nothing is out of bounds, and the status stays; a list of up to 3 entries"
 * checks = 27
 * stubs = { fxl_crc = "not called" }
 */
void prove_fault_of(void)
{
    fxl_scene_fault fault;
    fxl_image_section list[3];
    const uint32_t number = nondet_u32();
    ASSUME(number < 3);
    const fxl_status status = (fxl_status)nondet_u32();
    ASSERT("the status that is given", fault_of(list, number, status, &fault) == status);
    PROOF_ENDS();
}
