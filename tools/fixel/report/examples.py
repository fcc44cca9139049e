# SPDX-License-Identifier: MIT
"""The first program (examples/cube) and the other examples, drawn on this machine."""

import os
import pathlib

import numpy

from fixel.base import children, scratch
from fixel.image import c_scene
from fixel.scene import framing, look, making, target
from fixel.base.errors import ToolError

ROOT = pathlib.Path(__file__).resolve().parents[3]
MODEL = ROOT / "examples" / "cube" / "cube.obj"
PROGRAM = ROOT / "examples" / "cube" / "main.c"
CRATE_FRAMES = 28   # of which the last shows three sides
OWN_MODEL = ROOT / "examples" / "model" / "model.glb"
BOARD = ROOT / "examples" / "attitude" / "board.obj"
OWN_MODEL_FRAMES = 24   # of its path
FRAME = ROOT / "host_tests" / "boards" / "examples" / "frame.c"
HUD = ROOT / "host_tests" / "boards" / "examples" / "hud.c"
HUD_COLOURS = [(16, 20, 40), (240, 240, 240), (255, 220, 90), (230, 50, 60), (140, 20, 40)]    # from entry 250 on
WIDTH, HEIGHT = 320, 240


# The examples whose pixels are entries of a palette, by the name of their folder: the frame that is their picture (None: they
# draw one), and whether their palette is their own.
PICTURES = {"cube": (None, False), "turn": (24, False), "look": (31, False), "text": (None, True), "label": (None, True),
            "outline": (37, True), "lamp": (25, True), "depth": (26, False), "crowd": (None, True), "crate": (CRATE_FRAMES, True),
            "maze": (60, True), "isometric": (145, True)}
# Those that draw bands, of entries of their scene's palette: the frame that is their picture.
BAND_PICTURES = {"attitude": 35}
# Those that draw boxes of frames of 240 x 240: the frame that is their picture.
BOX_PICTURES = {"watch": 1}
# Those that send frames of 240 x 240 by a pump, with what they draw over them: the frame that is their picture.
PUMP_PICTURES = {"horizon": 5}
# Those that keep a band of ROWS rows alone, by the side of their square frame, which is drawn as one band.
SIDE_PICTURES = {"toolpath": 128}
# Those whose pixels are RGB565: the frame that is their picture.
WIDE_PICTURES = {"model": 3, "neon": 60}


def picture_of(name):
    """The file of an example's picture."""
    shown = {"cube": "cube", "crowd": "world", "crate": "crate", "neon": "neon", "game": "game"}
    return ROOT / "docs" / (f"{shown[name]}.png" if name in shown else f"examples/{name}.png")


def draw_example(library, name):
    """The picture of an example whose pixels are entries of a palette, and its palette."""
    if name in BAND_PICTURES:
        program, flags = ROOT / "examples" / name / "main.c", ["-DEXAMPLE_BANDED", f"-DEXAMPLE_FRAMES={BAND_PICTURES[name]}"]
        return _with_palette(library, program, "board_palette", *flags)
    if name in BOX_PICTURES:
        flags = ["-DEXAMPLE_BOXES", f"-DEXAMPLE_FRAMES={BOX_PICTURES[name]}", "-Wl,--wrap=fxl_frame_begin,--wrap=fxl_frame_draw"]
        return _with_palette(library, ROOT / "examples" / name / "main.c", "watch_palette", *flags, size=(240, 240))
    if name in PUMP_PICTURES:
        flags = ["-DEXAMPLE_PUMPED", f"-DEXAMPLE_FRAMES={PUMP_PICTURES[name]}", "-Wl,--wrap=fxl_pump_send"]
        return _with_palette(library, ROOT / "examples" / name / "main.c", f"{name}_palette", *flags, size=(240, 240))
    if name in SIDE_PICTURES:
        side = SIDE_PICTURES[name]
        pixels, _, palette = _run(library, ROOT / "examples" / name / "main.c", 0, f"-DROWS={side}", size=(side, side))
        return pixels, palette
    if name not in PICTURES:
        known = {*PICTURES, *BAND_PICTURES, *BOX_PICTURES, *PUMP_PICTURES, *SIDE_PICTURES, *WIDE_PICTURES}
        raise ToolError(f"there is no example '{name}'; there are: {', '.join(sorted(known))}")
    frames, own = PICTURES[name]
    program, flags = ROOT / "examples" / name / "main.c", [] if frames is None else [f"-DEXAMPLE_FRAMES={frames}"]
    if own:
        return _with_palette(library, program, "palette", *flags)
    pixels, _, palette = _run(library, program, 0, *flags)
    return pixels, palette


def scene():
    """The scene of the first program."""
    return framing.compile_model(str(MODEL), framing=framing.PROGRAM)[0]


def write_model(file):
    """Writes the GLB file of examples/model: a lighthouse, whose tower has an image of stripes."""
    from fixel.report.showcase_shapes import Gltf, image_bytes
    from fixel.report.showcase_shapes import ball, box, joined, lathe, placed
    y, x = numpy.mgrid[:32, :32]
    stripes = numpy.where(((x + 2 * y) % 32 < 16)[..., None], (200, 40, 36), (236, 232, 220))
    stripes[y % 8 == 7] = stripes[y % 8 == 7] * 3 // 4          # joints of the stones
    made = Gltf()
    tower = made.material("stripes", texture=made.texture(image_bytes(stripes.astype(numpy.uint8))))
    rock, iron, lamp = (made.material(name, colour) for name, colour in (
        ("rock", (0.28, 0.3, 0.28, 1)), ("iron", (0.12, 0.14, 0.2, 1)), ("lamp", (1, 0.85, 0.4, 1))))
    roof = joined(placed(lathe([(0, 0.5), (0.5, 0), (0, 0)], 12), (0, 2.96, 0)), placed(lathe([(0, 0.1), (0.62, 0.1), (0.62, 0), (0, 0)], 12), (0, 2.4, 0)))
    made.node("lighthouse", made.mesh("lighthouse", (lathe([(0, 2.4), (0.42, 2.4), (0.5, 1.6), (0.6, 0.8), (0.75, 0), (0, 0)], 16), tower),
                                      (placed(box(2.2, 0.5, 2.2), (0, -0.5, 0), yaw=20), rock), (roof, iron),
                                      (placed(ball(0.3, 12, 6), (0, 2.78, 0)), lamp)))
    made.write(pathlib.Path(file).parent, pathlib.Path(file).stem)


def write_own_scene(folder, model=OWN_MODEL):
    """Writes model_scene.h into a folder, in the best look."""
    making.export(str(model), str(pathlib.Path(folder) / "model_scene.h"), frames=OWN_MODEL_FRAMES, looks=_best())


def write_board_scene(folder):
    """Writes board_scene.h of examples/attitude into a folder."""
    making.export(str(BOARD), str(pathlib.Path(folder) / "board_scene.h"))


def write_own_image(file):
    """Writes the scene image of examples/model, in the best look."""
    making.build(str(OWN_MODEL), str(file), frames=OWN_MODEL_FRAMES, looks=_best())


def _best():
    return [look.best(look.Asked(), target.Target(), False)]


def write_scene(folder):
    """Writes cube_scene.h into a folder; answers the scene."""
    made = scene()
    (pathlib.Path(folder) / "cube_scene.h").write_text(c_scene.header(made, "cube", MODEL.name), encoding="utf-8")
    return made


def draw(library, program=PROGRAM):
    """The picture as an array of palette entries, and the palette. library: libfixel.a of this machine. program: the
    first program, or another with the same scene and the same pixels."""
    pixels, _, palette = _run(library, program, 0)
    return pixels, palette


def draw_wide(library, name):
    """The picture of an example of WIDE_PICTURES: an array of RGB565."""
    flags = [f"-DEXAMPLE_FRAMES={WIDE_PICTURES[name]}", "-DEXAMPLE_PIXEL=uint16_t"]
    rows, _, _ = _run(library, ROOT / "examples" / name / "main.c", 0, *flags, size=(2 * WIDTH, HEIGHT))
    return rows.view("<u2")


def draw_hud(library):
    """The first program's picture with text and sprites over it (host_tests/boards/examples/hud.c)."""
    pixels, palette = draw(library, HUD)
    palette[250:250 + len(HUD_COLOURS)] = HUD_COLOURS
    return pixels, palette


def _with_palette(library, program, name, *flags, size=(WIDTH, HEIGHT)):
    pixels, colours, _ = _run(library, program, 768, f"-DEXAMPLE_PALETTE={name}", *flags, size=size)
    return pixels, numpy.frombuffer(colours, dtype=numpy.uint8).reshape(-1, 3)


def _run(library, program, more, *flags, size=(WIDTH, HEIGHT)):
    """What a program draws, the `more` bytes before it, and the scene's palette. flags: for the compiler; size: bytes of a row, and rows."""
    if not pathlib.Path(library).exists():
        raise ToolError(f"{library}: there is no such library; `make build/host/libfixel.a` makes one")
    with scratch.folder("first") as folder:
        scene = write_scene(folder)
        if program.parent == OWN_MODEL.parent:
            write_own_scene(folder)
        if program.parent == BOARD.parent:
            write_board_scene(folder)
        command = [os.environ.get("HOSTCC", "gcc"), "-std=c11", f'-DEXAMPLE="{program}"', f"-I{ROOT / 'lib' / 'include'}",
                   *flags, f"-I{folder}", str(FRAME), str(library), "-Wl,--wrap=main", "-o", f"{folder}/frame"]
        done = children.run(command, text=True)
        if done.returncode != 0:
            raise ToolError(f"{program} cannot be compiled with {library}", words=done.stderr.strip())
        ran = children.run([f"{folder}/frame"])
    if ran.returncode != 0 or len(ran.stdout) != more + size[0] * size[1]:
        raise ToolError(f"{program} drew nothing: it ended with {ran.returncode}", exit_code=1)
    pixels = numpy.frombuffer(ran.stdout[more:], dtype=numpy.uint8).reshape(size[1], size[0])
    return pixels, ran.stdout[:more], numpy.array(scene.palette, dtype=numpy.uint8)
