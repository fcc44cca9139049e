# SPDX-License-Identifier: MIT
"""What fxl_setup_init reads of an exported scene, as text of C: lib/include/fixel/setup.h."""

from fixel.image import image_surface
from fixel.image.c_text import comment, record, table

INCLUDE = "fixel/setup.h"
POLYGON_CAPACITY = 32       # FXL_POLYGON_CAPACITY: a smaller one takes less memory
FACE_VERTICES = POLYGON_CAPACITY - 8
POINT, LIT_PIECE = 12, 6    # bytes of an fxl_point, and of an fxl_lit_piece
CORNERS_A_CUT, CORNERS_ON_PLANES = 6, 16    # lib/paint/lit_pieces.c
LIGHTING_WORDS = 10         # pointers and numbers of the record before a beam's tables
PIECES_A_FACE = 2           # of an instance that the tree cuts: a choice; scenes/knot.toml takes half of it
PIECE, PIECE_VERTEX = 12, 16


# place pixel-format: the target of an exported scene
def target(scene):
    """The record of fixel/target.h that the scene asks for."""
    return ("fxl_rgb565" if scene.pixel_bits == 16 else "fxl_palette") + (f"_depth_{scene.depth_bits}" if scene.depth_bits else "")


def palette_565(scene, name):
    """The table of the palette in RGB565, or NULL."""
    return f"{name}_palette_565" if scene.pixel_bits == 16 else "NULL"


def _rgb565(red, green, blue):
    return f"0x{red >> 3 << 11 | green >> 2 << 5 | blue >> 3:04X}"


def _up(size, unit=8):
    return -(-size // unit) * unit


def _beams(scene):
    """uint64_t of memory for fxl_attach_beams as an expression: the tables, and a record of pointers and numbers."""
    planes = [len(beam.planes) for beam in scene.beams]
    pieces = 1
    for count in planes:
        pieces *= count + 1
    corners = FACE_VERTICES - (2 * sum(planes) - planes[0]) + CORNERS_ON_PLANES + CORNERS_A_CUT * (pieces - 1)
    tables = _up(corners * POINT) + _up(corners * 2) + _up(pieces * LIT_PIECE) + _up(POLYGON_CAPACITY * POINT)
    return f"({tables // 8} + ({LIGHTING_WORDS} * sizeof(void *) + 7) / 8)"


def _by_tree(scene):
    return bool(scene.tree) and not scene.by_distance


def _has_lines(scene):
    return any(model.lines for model in scene.models)


def _pieces(scene):
    """Bytes for pieces of instances that the tree cuts."""
    layer = scene.objects[scene.tree.object].layer
    movers = [item for number, item in enumerate(scene.objects) if item.layer == layer and number != scene.tree.object]
    faces = [face for item in movers for face in scene.models[item.model].faces]
    return _up(sum(PIECES_A_FACE * (PIECE + PIECE_VERTEX * (len(face.corners) + 1)) for face in faces)), len(movers)


def _tree(scene):
    """(uint64_t of memory for fxl_by_tree as an expression, bytes for pieces that are within)."""
    pieces, movers = _pieces(scene)
    bits = _up(len(scene.tree.nodes), 32) // 8
    more = bits + (bits + 4 * len(scene.tree.nodes) + 12 * movers if movers else 0)
    return f"((sizeof(fxl_bsp_workspace) + {more + 7}) / 8 + {pieces // 8})", pieces


def _summands(scene, name):
    """{constant: its expression}: what NAME_SETUP_MEMORY adds up, each in uint64_t."""
    capital = name.upper()
    depth = f"((FXL_DEPTH_BYTES({scene.width}, rows, {scene.depth_bits}) + 7) / 8)" if scene.depth_bits else "0"
    moves = (f"(({capital}_INSTANCES * sizeof(fxl_instance) + 7) / 8 + ({capital}_PLACEMENTS * sizeof(fxl_placement) + 7) / 8)"
             if scene.motions else "0")
    return {f"{capital}_SETUP_RENDERER": f"{capital}_MEMORY",
            f"{capital}_SETUP_DEPTH(rows)": depth,
            f"{capital}_SETUP_TREE": _tree(scene)[0] if _by_tree(scene) else "0",
            f"{capital}_SETUP_MOTIONS": moves,
            f"{capital}_SETUP_BEAMS": _beams(scene) if scene.beams else "0",
            f"{capital}_SETUP_LINES": "((sizeof(fxl_lines) + 7) / 8)" if _has_lines(scene) else "0"}


def _memory(scene, name):
    made = _summands(scene, name)
    lines = comment("uint64_t of memory for fxl_setup_init, and what they are for. rows: of a depth buffer, those of the largest "
                    "band that is drawn in one part.")
    lines += [f"#define {what} {expression}" for what, expression in made.items()]
    lines += [f"#define {name.upper()}_SETUP_MEMORY(rows) \\", "    (" + " + ".join(list(made)[:2]) + " + \\",
              "     " + " + ".join(list(made)[2:]) + ")", ""]
    return "\n".join(lines)


def scale_of(scene, name):
    """The scale of an orthographic lens, by its constant."""
    return f"{name.upper()}_SCALE" if scene.scale else "0"


def text(scene, name, frames):
    """The plan of a scene, the sizes of its memory, and its palette in RGB565. frames: whether the header has the path."""
    lit = scene.light is not None and scene.surfaces is not None and any(
        each.flags & image_surface.LIT for each in scene.surfaces.surfaces)
    order = _by_tree(scene)

    def part(there, *rows):
        return ", ".join(rows) if there else ", ".join(["NULL"] * len(rows))
    painter, sprites = f"FXL_SURFACES_OF({target(scene)})", f"FXL_SPRITES_OF({target(scene)})"
    centre = scene.centre or (0, 0)
    rows = [f"&{name}_scene, &{name}_config, {'&fxl_by_tree' if order else 'NULL'}, fxl_renderer_init, false, {name}_palette[0], &{name}_start",
            f"{name}_path, {len(scene.path)}" if frames else "NULL, 0",
            str(_tree(scene)[1] if order else 0),
            f"{centre[0]}, {centre[1]}, {'fxl_renderer_set_centre' if scene.centre else 'NULL'}",
            f"{scale_of(scene, name)}, {'fxl_renderer_set_orthographic' if scene.scale else 'NULL'}",
            part(scene.motions, f"&{name}_motion", "fxl_motion_begin", "fxl_motion_play"),
            part(scene.beams, "fxl_beam_light_workspace_size", "fxl_attach_beams"),
            part(scene.light is not None, f"&{name}_light", "fxl_attach_light"),
            part(scene.surfaces is not None, f"&{name}_surfaces", painter, "fxl_attach_surfaces"),
            part(lit, "fxl_attach_lit"),
            part(scene.billboards is not None, f"&{name}_billboards", sprites, "fxl_attach_billboards")]
    palette = [table("uint16_t", palette_565(scene, name), [_rgb565(*entry) for entry in scene.palette], "The palette in RGB565.",
                     (256,))] if scene.pixel_bits == 16 else []
    rows.append(part(_has_lines(scene), f"&{name}_lines", "fxl_attach_lines"))
    rows.append(part(scene.horizon is not None, f"&{name}_horizon", "fxl_attach_horizon"))
    return [*palette, _memory(scene, name),
            record("fxl_setup_plan", f"{name}_setup", rows,
                   "For fxl_setup_init: scene, configuration, order, renderer, palette, first pose; path; memory for pieces; centre of "
                   "the lens, scale of an orthographic one; motions, beams, light, surfaces, light at corners, billboards, lines, horizon, each with what sets it up.")]


PROGRAM = """/* Written by tools/scene.py export --c --program: draws %(source)s. It is yours to change. */
#include "%(header)s"
#define ROWS %(rows)d /* of a band, 1..%(height)d: more rows take more memory and fewer instructions; all of them: fxl_render */
static fxl_setup it;
static uint64_t memory[%(capital)s_SETUP_MEMORY(ROWS)]; /* in bands more of it takes fewer instructions: docs/setup.md */
static %(pixel)s pixels[ROWS][%(width)d]; /* %(about)s */
/* Draws what the eye sees. */
static fxl_status draw(const fxl_pose *eye)
{
#if ROWS == %(height)d
    return fxl_render(&it.renderer, eye, pixels[0], %(width)d);
#else
    fxl_status status = fxl_frame_begin(&it.renderer, eye);
    for (uint16_t row = 0; status == FXL_OK && row < %(height)d; row += ROWS) {
        const fxl_band band = {.pixels = (uint8_t *)pixels[0],
                               .width = %(width)d,
                               .stride = %(width)d,
                               .first_row = row,
                               .rows = ROWS < %(height)d - row ? ROWS : (uint16_t)(%(height)d - row),
                               .palette = it.renderer.palette};
        fxl_frame_fill(&it.renderer, &band, %(name)s_config.background);
        status = fxl_frame_draw(&it.renderer, &band);
        /* Here band.rows rows of pixels go to your display: docs/displays.md. make run, view and flash take them by themselves. */
    }
    return status;
#endif
}
int main(void)
{
    if (fxl_setup_init(&it, &%(name)s_setup, ROWS, memory, sizeof memory)) { return 1; } /* fxl_setup_explain says why */
    for (uint32_t frame = 0; frame < %(frames)s; frame++) {
        if (draw(fxl_setup_frame(&it, frame))) { return 2; }
    }
    return 0;
}
"""


def program(scene, name, header, source, frames, rows):
    """The text of a program that draws an exported scene in bands of so many rows. header: the file's name; source: that of the scene,
    for a comment."""
    is_565 = scene.pixel_bits == 16
    return PROGRAM % {
        "source": source, "header": header, "name": name, "rows": rows, "capital": name.upper(), "width": scene.width, "height": scene.height,
        "pixel": "uint16_t" if is_565 else "uint8_t", "about": "RGB565" if is_565 else f"entries of {name}_palette",
        "frames": f"{name.upper()}_FRAMES" if frames else "1"}
