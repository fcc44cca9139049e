/* SPDX-License-Identifier: MIT */
#include "scene/scene_sections.c"
#include "proof.h"

#define SECTIONS 31 /* more than there are kinds */

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

void prove_check_place(void)
{
    fxl_image_section one;
    place next;
    ANY_CONTENT(&image);
    /* as check_envelope and check_entry leave them */
    ASSUME(image.head.image_size <= sizeof image && image.head.image_size % 4 == 0);
    ASSUME(next.at % 4 == 0 && next.at >= sizeof image.head && one.kind >= 1);
    const fxl_status status = check_place(&image.head, &one, &next);
    const uint64_t bytes = one.kind < SECTION_KINDS ? (uint64_t)one.count * known[one.kind - 1].entry_size : 0;
    ASSERT("the table lies in the image", status != FXL_OK || (one.offset >= sizeof image.head && one.offset + bytes <= image.head.image_size));
    ASSERT("aligned, and behind the header", status != FXL_OK || one.offset % 4 == 0);
    ASSERT("the next one begins behind it", status != FXL_OK || (next.at >= one.offset + bytes && next.at <= image.head.image_size && next.at % 4 == 0));
    PROOF_ENDS();
}

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
