/* A name at each corner of a cube that no face hides, and the number of the face in the middle of the screen. */
#include <fixel.h>
#include <fixel/overlay.h>
#include <fixel/pick.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[240][320];
static uint8_t palette[256][3]; /* that of the cube, and white */

/* Whether a corner of the cube is one of the corners of a face. */
static bool has_corner(const fxl_face *face, uint32_t corner)
{
    for (uint32_t i = 0; i < 4; i++) {
        if (fxl_face_indices(cube_indices, face)[i] == corner) { return true; }
    }
    return false;
}

int main(void)
{
    const fxl_config config = fxl_config_default(320, 240);
    const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-6)}, .pitch = FXL_DEGREES(-18)};
    const fxl_band whole = {.pixels = pixels[0], .width = 320, .stride = 320, .rows = 240};
    const fxl_text_style style = {.font = &fxl_font_5x7, .colour = 7};
    char name[] = "A", sentence[] = "face 0";
    fxl_picked picked;
    for (int i = 0; i < 768; i++) { palette[i / 3][i % 3] = i / 3 < 7 ? cube_palette[i / 3][i % 3] : i / 3 == 7 ? 255 : 0; }
    if (fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory) ||
        fxl_render(&renderer, &eye, pixels[0], 320) || fxl_pick_face(&renderer, 160, 120, &picked)) { return 1; }
    sentence[5] = (char)(picked.instance == FXL_PICK_NONE ? '-' : '0' + picked.face);
    if (fxl_draw_text(&whole, 8, 8, sentence, &style)) { return 1; }
    for (uint32_t i = 0; i < 8; i++, name[0]++) {
        fxl_screen_place place;
        fxl_picked front;
        if (fxl_find_on_screen(&renderer.frame.view, &cube_vertices[i], &place)) { return 1; }
        if (place.place != FXL_POINT_VISIBLE) { continue; }
        const int32_t x = place.at.x >> 16, y = place.at.y >> 16, right = x < 160 ? -1 : 1, down = y < 120 ? -1 : 1;
        /* The face that is seen three pixels nearer to the middle: of a corner that is hidden, it is another's. */
        if (fxl_pick_face(&renderer, (uint16_t)(x - 3 * right), (uint16_t)(y - 3 * down), &front)) { return 1; }
        if (front.instance == FXL_PICK_NONE || !has_corner(&cube_faces[front.face], i)) { continue; }
        if (fxl_draw_text(&whole, x + 6 * right - 2, y + 7 * down - 3, name, &style)) { return 1; }
    }
    return 0;
}
