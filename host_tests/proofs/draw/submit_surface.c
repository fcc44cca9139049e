/* SPDX-License-Identifier: MIT */
#include "draw/submit_surface.c"
#include "proof.h"

/* [[row]]
 * function = "lib/paint/smooth_outline.h:fxl_has_few_texels"
 * property = "nothing overflows for coordinates below 2^30, and it is true where all differ by less than 2^23 from the first corner's, or by -2^23"
 * checks = 35
 */
/* Coordinates are within FXL_TEXEL_MAX. */
void prove_has_few_texels(void)
{
    int32_t values[FXL_ATTRIBUTES][3];
    int64_t most = 0, least = 0;
    for (int i = FXL_ATTRIBUTE_U; i <= FXL_ATTRIBUTE_V; i++) {
        for (int j = 0; j < 3; j++) {
            ASSUME(WITHIN(values[i][j], (1 << 30) - 1));
            const int64_t difference = (int64_t)values[i][j] - values[i][0];
            most = difference > most ? difference : most;
            least = difference < least ? difference : least;
        }
    }
    ASSERT("128 texels from the first corner's", fxl_has_few_texels(values) == (most < 1 << 23 && least >= -(1 << 23)));
    PROOF_ENDS();
}

/* Of the corners, and of a vertex that is none. */
static fxl_q18_46 depths[4];

void fxl_find_corner(const fxl_model_view *model_view, uint32_t number, const fxl_traversal *traversal, fxl_view_point *corner)
{
    (void)model_view, (void)traversal;
    ASSERT("a vertex of the face", number < 4);
    corner->z = depths[number];
}

/* [[row]]
 * function = "nearest_depth"
 * property = "faces and whole faces of up to 5 vertices: the least depth of the whole face, and of the corners alone where they are told to be all"
 * checks = 344
 * unwind = 11
 * stubs = { fxl_find_corner = "any depth: it is measured" }
 */
/* Vertices 0, 1, 2 are the corners. A face has up to 5, and so has the whole one, of which it is a part. */
void prove_nearest_depth(void)
{
    fxl_model_view model_view;
    fxl_face face;
    fxl_scene scene;
    fxl_renderer renderer;
    fxl_traversal traversal;
    uint16_t indices[10];
    uint32_t whole;
    fxl_corner some[3];
    const fxl_corner *const corners[3] = {&some[0], &some[1], &some[2]};
    const bool has_others = nondet_bool();
    for (uint16_t i = 0; i < 3; i++) {
        some[i].vertex = i;
    }
    fxl_q18_46 nearest = depths[0] < depths[1] ? depths[0] : depths[1];
    nearest = nearest < depths[2] ? nearest : depths[2];
    scene.indices = indices;
    scene.faces = &face;
    scene.wholes = nondet_bool() ? &whole : NULL;
    renderer.scene = &scene;
    traversal.renderer = &renderer;
    ASSUME(face.count <= 5 && (face.count == 3 || fxl_face_first_index(&face) == 0) && (whole == 0 || (whole / 32 == 5 && whole % 32 <= 5)));
    const bool is_part = scene.wholes != NULL && whole != 0;
    for (uint32_t i = 0; i < 10; i++) {
        const bool is_read = is_part ? i >= 5 && i < 5 + whole % 32 : i < face.count;
        const uint32_t number = !is_part && face.count == 3 && i < 3 ? face.indices[i] : indices[i];
        ASSUME(indices[i] < 4 && number < 4);
        nearest = has_others && is_read && depths[number] < nearest ? depths[number] : nearest;
    }
    ASSERT("the least of all, or of the corners", nearest_depth(&model_view, &face, corners, &traversal, depths, has_others) == nearest);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/surface_polygon.h:fxl_may_have_words"
 * property = "any surface and texture: opaque texels of 8 or 16 bits that repeat, without a key, a stipple or a beam, divided every 16 pixels or not at all"
 * checks = 46
 */
void prove_may_have_words(void)
{
    fxl_surfaces surfaces;
    fxl_surface surface;
    fxl_texture texture;
    const bool may = fxl_may_have_words(&surfaces, &surface, &texture);
    ASSERT("opaque, and lit at most", !may || (surface.opacity == 16 && (surface.flags | FXL_SURFACE_LIT) == FXL_SURFACE_LIT));
    ASSERT("its texture", !may || (texture.flags == 0 && texture.format != FXL_TEXTURE_4));
    ASSERT("in no beam", !may || surfaces.beams == NULL);
    ASSERT("each that is so", may || surface.opacity != 16 || surface.flags != 0 || texture.flags != 0 || texture.format == FXL_TEXTURE_4 ||
                                  surfaces.beams != NULL || surface.division != FXL_DIVIDE_16);
    PROOF_ENDS();
}
