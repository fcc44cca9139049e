# SPDX-License-Identifier: MIT
"""What the tests of boards share that need tools of their own: frames of scenes and of the game, and unit tests."""

import json
import shutil

from board_programs import ROOT, built, made
from conftest import run_cli, run_make
from fixel.board import crc, unit_tests
from fixel.check import frame_hashes
from fixel.report import examples
from fixel.scene import making, target

SCENES = [("plaza", []), ("spin", []), ("room", ["PIXELS=rgb565"]), ("gallery", ["DEPTH=16"]), ("knot", [])]
GAMES = [["DRIVER=st7789"], ["PIXELS=rgb565", "DEPTH=16"]]
# Flat, a tree, beams, motions, textures with a depth buffer, billboards.
EXPORTED = {"cube": None, "knot": None, "beam": None, "spin": None, "room": "16", "grove": None}
INSTRUMENTS = {"attitude": 60, "watch": 60, "horizon": 60}      # in bands, for 16 KB of RAM; and how many frames each draws
WHOLE = {"isometric": 60}           # frames of 320 x 240, of which show ends the program after so many
SHOW = """#include <stdint.h>
int show(const uint8_t *pixels);
int show(const uint8_t *pixels)
{
    static int shown;
    (void)pixels;
    return ++shown == FRAMES;
}
"""
UNITS = ["test_crc", "test_render", "test_project", "test_plane", "test_clip_view", "test_depth"]    # make test BOARD=<name> runs all


def run(board, out, *words):
    """make run: (what it said, its summary)."""
    done = run_make("run", f"BOARD={board}", f"OUT={out}", *words)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout, json.loads((out / "summary.json").read_text())


def draw_scene(board, out, scene, words):
    """The summary of three frames, which must be those of the host."""
    said, summary = run(board, out, f"SCENE=scenes/{scene}.toml", "FRAMES=3", *words)
    assert "equal to host          yes" in said and summary["host_frames_equal"] and summary["frames"] == 3
    assert summary["pixels_unexplained"] == 0 and len(set(summary["frame_crc"])) > 1
    return summary


def draw_exported(board, folder, name):
    """Two frames by the program that is written beside an exported scene, which must be those that the host draws of its image."""
    source, own, depth = ROOT / "scenes" / f"{name}.toml", folder / "own", EXPORTED[name]
    own.mkdir()
    done = run_cli("export", "--c", source, "-o", own / "scene.h", "--name", "scene", "--program", own / "main.c", *(["--depth", depth] if depth else []))
    assert done.returncode == 0, done.stderr
    made("build/host/frames")
    making.build(str(source), str(folder / "scene.fxls"), asked=target.Target(depth=depth))
    frames = frame_hashes.drawn_by_host(folder / "scene.fxls", ROOT / "build", folder).frames[:2]
    _, summary = run(board, folder / "out", f"PROGRAM={own}", "FRAMES=2")
    assert summary["frame_crc"] == crc.drawn(frames).each and summary["host_frames_equal"]


def draw_example(board, folder, name):
    """All frames of an example of INSTRUMENTS or WHOLE, which must be those of the host."""
    own = folder / name
    shutil.copytree(ROOT / "examples" / name, own)
    examples.write_board_scene(own)
    if board == "microbit":     # whose 16 KB hold fewer rows
        main = own / "main.c"
        main.write_text(main.read_text(encoding="utf-8").replace("#define ROWS 16 ", "#define ROWS 4 "), encoding="utf-8")
    if name in WHOLE:
        (own / "show.c").write_text(SHOW.replace("FRAMES", str(WHOLE[name])), encoding="utf-8")
    _, summary = run(board, folder / "out", f"PROGRAM={own}")
    assert summary["host_frames_equal"] and len(set(summary["frame_crc"])) == summary["frames"] == {**INSTRUMENTS, **WHOLE}[name]


def draw_game(board, out, words):
    """Twelve frames, which must be those of the host; a display shows them if the words name its driver."""
    _, summary = run(board, out, "PROGRAM=game", "FRAMES=12", *words)
    assert summary["host_frames_equal"]
    assert summary["wires_frames_equal"] == (12 if words[0].startswith("DRIVER") else None)


def run_unit(board, name):
    """A unit test must pass. Returns what was linked."""
    linked = json.loads(built(f"{board}/unit/units.json").read_text(encoding="utf-8"))
    elf, = [each for each, names in linked["programs"].items() if name in names]
    file, = unit_tests.run(ROOT / "build/boards" / board / "unit" / elf, [name], every=False)
    assert file.passed > 0 and file.failed == 0, file.output
    return linked
