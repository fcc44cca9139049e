/* SPDX-License-Identifier: MIT */
#include "scene/scene_open.c"
#include "proof.h"

static union {
    fxl_image_header head;
    uint32_t words[64];
} image;
static fxl_image_section one;
static fxl_scene_image opened;
static fxl_scene_fault fault;

/* For fxl_scene_section: an entry of a checked image, or none. */
const fxl_image_section *fxl_scene_section(const fxl_image_header *head, uint32_t kind)
{
    ASSERT("of the image", head == &image.head);
    one.kind = fxl_low_16(kind);
    one.offset = nondet_u32();
    one.count = nondet_u32();
    ASSUME(one.offset % 4 == 0 && one.offset >= sizeof image.head && one.offset <= sizeof image - sizeof(fxl_image_centre));
    return nondet_bool() ? &one : NULL;
}

/* [[row]]
 * function = "first_of"
 * property = "any kind: none, or where the section lies in the image"
 * checks = 36
 * stubs = { fxl_scene_section = "any entry that lies in the image, or none", fxl_lens_from_fov = "any status", fxl_lens_set_centre = "any status", fxl_light_settings_of = "any settings", fxl_light_check = "any status", fxl_scene_sections_check = "any status", fxl_scene_check_all = "any status, after the sections", fxl_motion_check = "any status, after the scene" }
 */
void prove_first_of(void)
{
    const uint32_t kind = nondet_u32();
    const uint8_t *first = (const uint8_t *)first_of(&image.head, kind);
    ASSERT("none, or in the image", first == NULL || (first >= (const uint8_t *)&image.head + sizeof image.head && first <= (const uint8_t *)(&image + 1)));
    (void)count_of(&image.head, kind);
    PROOF_ENDS();
}

/* For what makes and checks lenses, light and scenes: any status. */
fxl_status fxl_lens_from_fov(uint16_t width, uint16_t height, fxl_angle fov, fxl_q16_16 near_z, fxl_q16_16 far_z, fxl_q16_16 inset, fxl_lens *lens)
{
    (void)width, (void)height, (void)fov, (void)near_z, (void)far_z, (void)inset;
    ANY_CONTENT(lens);
    return (fxl_status)nondet_u32();
}

fxl_status fxl_lens_set_centre(fxl_lens *lens, fxl_q16_16 x, fxl_q16_16 y)
{
    (void)lens, (void)x, (void)y;
    return (fxl_status)nondet_u32();
}

void fxl_light_settings_of(const fxl_scene_light *light, fxl_light_settings *settings)
{
    ASSERT("there is a light", light->base != NULL);
    ANY_CONTENT(settings);
}

fxl_status fxl_light_check(const fxl_light_settings *settings, fxl_scene_fault *to)
{
    (void)to;
    ASSERT("there are settings", settings != NULL);
    return (fxl_status)nondet_u32();
}

static unsigned passed; /* checks, in their order */

fxl_status fxl_scene_sections_check(const fxl_image_header *head, size_t size, fxl_scene_fault *to)
{
    (void)size, (void)to;
    ASSERT("of the image", head == &image.head);
    passed = nondet_bool();
    return passed ? FXL_OK : FXL_E_CRC;
}

fxl_status fxl_scene_check_all(fxl_scene *scene, fxl_scene_fault *to)
{
    (void)scene, (void)to;
    ASSERT("after the sections", passed == 1);
    passed += nondet_bool();
    return passed == 2 ? FXL_OK : FXL_E_COUNT;
}

fxl_status fxl_motion_check(const fxl_motion_set *set, const fxl_scene *scene, fxl_scene_fault *to)
{
    (void)set, (void)scene, (void)to;
    ASSERT("after the scene", passed == 2);
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "check_lens"
 * property = "any header: nothing is out of bounds"
 * checks = 109
 * stubs = { fxl_scene_section = "any entry that lies in the image, or none", fxl_lens_from_fov = "any status", fxl_lens_set_centre = "any status", fxl_light_settings_of = "any settings", fxl_light_check = "any status", fxl_scene_sections_check = "any status", fxl_scene_check_all = "any status, after the sections", fxl_motion_check = "any status, after the scene" }
 */
void prove_check_lens(void)
{
    ANY_CONTENT(&image);
    (void)check_lens(&image.head, &opened);
    PROOF_ENDS();
}

/* For check_lens. */
fxl_status any_lens(const fxl_image_header *head, fxl_scene_image *to)
{
    ASSERT("of the image", head == &image.head && to == &opened);
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "check_settings"
 * property = "any header: one that passes has a start in the world and motion limits in their range"
 * checks = 198
 * stands_in = { check_lens = "any_lens" }
 * stubs = { fxl_scene_section = "any entry that lies in the image, or none", fxl_lens_from_fov = "any status", fxl_lens_set_centre = "any status", fxl_light_settings_of = "any settings", fxl_light_check = "any status", fxl_scene_sections_check = "any status", fxl_scene_check_all = "any status, after the sections", fxl_motion_check = "any status, after the scene" }
 */
void prove_check_settings(void)
{
    ANY_CONTENT(&image);
    const fxl_status status = check_settings(&image.head, &opened, nondet_bool() ? &fault : NULL);
    ASSERT("a start in the world", status != FXL_OK || fxl_point_in_range(&opened.start.pose.position));
    ASSERT("motion limits in their range", status != FXL_OK || fxl_motion_limits_in_range(&opened.motion_limits));
    PROOF_ENDS();
}

/* [[row]]
 * id = "check_light of an image"
 * function = "check_light"
 * property = "any light, or none: nothing is out of bounds"
 * checks = 14
 * stubs = { fxl_scene_section = "any entry that lies in the image, or none", fxl_lens_from_fov = "any status", fxl_lens_set_centre = "any status", fxl_light_settings_of = "any settings", fxl_light_check = "any status", fxl_scene_sections_check = "any status", fxl_scene_check_all = "any status, after the sections", fxl_motion_check = "any status, after the scene" }
 */
void prove_check_light(void)
{
    static fxl_light_base base;
    fxl_scene_light light;
    light.base = nondet_bool() ? &base : NULL;
    (void)check_light(&light, &fault);
    PROOF_ENDS();
}

#define ENTRIES 4

/* [[row]]
 * id = "check_path of an image"
 * function = "check_path"
 * property = "any path of up to 4 entries: nothing is out of bounds, and one that passes has at most as many frames as a path may, and its poses lie in the world"
 * checks = 90
 * stubs = { fxl_scene_section = "any entry that lies in the image, or none", fxl_lens_from_fov = "any status", fxl_lens_set_centre = "any status", fxl_light_settings_of = "any settings", fxl_light_check = "any status", fxl_scene_sections_check = "any status", fxl_scene_check_all = "any status, after the sections", fxl_motion_check = "any status, after the scene" }
 */
void prove_check_path(void)
{
    static fxl_pose poses[ENTRIES];
    static fxl_path_segment segments[ENTRIES];
    ANY_CONTENT(poses);
    ANY_CONTENT(segments);
    ANY_CONTENT(&opened);
    opened.poses = nondet_bool() ? poses : NULL;
    opened.segments = segments;
    ASSUME(opened.path_count <= ENTRIES);
    const uint32_t i = nondet_u32();
    ASSUME(i < ENTRIES);
    const fxl_status status = check_path(&opened, &fault);
    ASSERT("its frames", status != FXL_OK || opened.frame_count <= FXL_SCENE_PATH_MAX);
    ASSERT("poses in the world", status != FXL_OK || opened.poses == NULL || i >= opened.path_count || fxl_point_in_range(&poses[i].position));
    PROOF_ENDS();
}

/* [[row]]
 * function = "open_sections"
 * property = "any image that passed: nothing is out of bounds"
 * checks = 409
 * stubs = { fxl_scene_section = "any entry that lies in the image, or none", fxl_lens_from_fov = "any status", fxl_lens_set_centre = "any status", fxl_light_settings_of = "any settings", fxl_light_check = "any status", fxl_scene_sections_check = "any status", fxl_scene_check_all = "any status, after the sections", fxl_motion_check = "any status, after the scene" }
 */
void prove_open_sections(void)
{
    ANY_CONTENT(&image);
    open_sections(&image.head, &opened);
    PROOF_ENDS();
}

/* For check_settings, open_sections, check_light and check_path. */
fxl_status any_settings(const fxl_image_header *head, fxl_scene_image *to, fxl_scene_fault *of)
{
    (void)to, (void)of;
    ASSERT("after the sections", head == &image.head && passed == 1);
    return (fxl_status)nondet_u32();
}

static const fxl_motion motion;
void any_sections(const fxl_image_header *head, fxl_scene_image *to)
{
    ASSERT("after the sections", head == &image.head && passed == 1);
    to->motion.motions = nondet_bool() ? &motion : NULL;
}

fxl_status any_light(const fxl_scene_light *light, fxl_scene_fault *of)
{
    (void)light, (void)of;
    ASSERT("after the scene", passed == 2);
    return (fxl_status)nondet_u32();
}

fxl_status any_path(const fxl_scene_image *of, fxl_scene_fault *to)
{
    (void)of, (void)to;
    ASSERT("after the scene", passed == 2);
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "fxl_scene_open"
 * property = "any pointer and size: an image is opened after all checks passed, in their order; refused, what was opened stays"
 * checks = 36
 * stands_in = { check_settings = "any_settings", open_sections = "any_sections", check_light = "any_light", check_path = "any_path" }
 * stubs = { fxl_scene_section = "any entry that lies in the image, or none", fxl_lens_from_fov = "any status", fxl_lens_set_centre = "any status", fxl_light_settings_of = "any settings", fxl_light_check = "any status", fxl_scene_sections_check = "any status", fxl_scene_check_all = "any status, after the sections", fxl_motion_check = "any status, after the scene" }
 */
void prove_scene_open(void)
{
    ANY_CONTENT(&opened);
    const uint32_t before = opened.frame_count;
    const void *from = nondet_bool() ? (const uint8_t *)&image + (nondet_u8() & 3u) : NULL;
    const fxl_status status = fxl_scene_open(from, nondet_size(), nondet_bool() ? &opened : NULL, nondet_bool() ? &fault : NULL);
    ASSERT("opened by all checks, or as it was", status == FXL_OK ? passed == 2 : opened.frame_count == before);
    PROOF_ENDS();
}
