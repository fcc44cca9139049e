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
