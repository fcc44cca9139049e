# SPDX-License-Identifier: MIT
"""The rooms of the library: which folder's files may include those of which other."""

import os
import pathlib
import re
import subprocess

import pytest

from conftest import CHECKOUT

BUILT_PROGRAMS = ()
LIB = CHECKOUT / "lib"
PUBLIC = LIB / "include"
# A room includes itself and the rooms before it. A wing includes all rooms, and the study the wings too.
ROOMS = ("math", "scene", "view", "clip", "raster", "paint", "draw")
WINGS = ("order", "screen", "game")
STUDY = "study"
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)

# The room of each public header: that of the code which it declares.
ROOM_OF = {
    "math": {"config", "types", "version"},
    "scene": {"camera", "crc", "records", "scene", "tables"},
    "clip": {"line"},
    # These also declare how lib/draw attaches what they describe to a renderer.
    "paint": {"beams", "billboards", "light", "surfaces"},
    "draw": {"changed", "fixel", "horizon", "lines", "order", "render", "target"},
    "order": {"wire"},
    "screen": {"display", "driver", "overlay", "pixels", "pump"},
    "game": {"collide", "motion", "orientation", "pick", "player", "setup", "world"},
}
# (room, what it includes): why it may, though it stands before it.
EXCEPTIONS = {
    ("raster", "include/fixel/target.h"): "a program clears a target by fxl_fill_band, which the stage of filling has",
    ("view", "clip/clip_view.h"): "fxl_view_distance, which the clipper inlines, gives the outcode near a plane",
    ("paint", "include/fixel/overlay.h"): "a billboard is a sprite of the overlay",
}


def headers():
    """{public header: its room}."""
    return {name: room for room, names in ROOM_OF.items() for name in names}


def room_of(file):
    """The room of a file of lib/."""
    if PUBLIC in file.parents:
        name = str(file.relative_to(PUBLIC).with_suffix(""))
        return headers()[name.removeprefix("fixel/")]
    return file.parent.name


def allowed(room):
    """The rooms of which a room's files may include some."""
    if room in ROOMS:
        return ROOMS[:ROOMS.index(room) + 1]
    return (*ROOMS, room) if room in WINGS else (*ROOMS, *WINGS, STUDY)


def included(file):
    """The files of lib/ that a file includes."""
    for name in INCLUDE.findall(file.read_text(encoding="utf-8")):
        beside = pathlib.Path(os.path.normpath(file.parent / name))
        yield beside if beside.is_file() else PUBLIC / name


def sources():
    return sorted(file for folder in (*ROOMS, *WINGS, STUDY) for file in (LIB / folder).iterdir() if file.suffix in (".c", ".h", ".S"))


def test_every_file_has_a_room():
    assert {file.name for file in LIB.iterdir() if file.is_dir()} == {*ROOMS, *WINGS, STUDY, "include"}
    found = {str(file.relative_to(PUBLIC).with_suffix("")).removeprefix("fixel/") for file in PUBLIC.rglob("*.h")}
    assert set(headers()) == found - {"all"}


def strange(files):
    """["file includes file"] that no rule allows, and the exceptions that were needed."""
    found, used = [], set()
    for file in files:
        room = room_of(file)
        for other in included(file):
            pair = (room, str(other.relative_to(LIB)))
            if room_of(other) in allowed(room):
                continue
            if pair in EXCEPTIONS:
                used.add(pair)
            else:
                found.append(f"{file.relative_to(LIB)} includes {pair[1]}")
    return found, used


def test_no_room_includes_a_later_one():
    found, used = strange(sources())
    assert found == []
    assert used == set(EXCEPTIONS), "an exception that nothing needs"


@pytest.mark.parametrize("room, line, wrong", [
    ("math", '#include "../view/model_view.h"', True), ("view", '#include "../math/arith.h"', False),
    ("paint", '#include "../draw/submit.h"', True), ("draw", '#include "../paint/paint.h"', False),
    ("draw", '#include "../order/bsp_pieces.h"', True), ("order", '#include "../draw/submit.h"', False),
    ("screen", '#include "../game/exact.h"', True), ("game", '  #  include "../study/normalised.h"', True),
    ("study", '#include "../order/bsp_pieces.h"', False), ("clip", '#include "fixel/render.h"', True),
    ("raster", '#include "fixel/records.h"', False), ("math", '/* #include "fixel/scene.h" */', False)])
def test_an_include_that_points_back_is_seen(monkeypatch, tmp_path, room, line, wrong):
    """In a library with the real headers, and one file more."""
    lib = tmp_path / "lib"
    for file in LIB.rglob("*.h"):
        copy = lib / file.relative_to(LIB)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.symlink_to(file)
    (lib / room / "new.h").write_text(line + "\n", encoding="utf-8")
    monkeypatch.setattr(f"{__name__}.LIB", lib)
    monkeypatch.setattr(f"{__name__}.PUBLIC", lib / "include")
    assert bool(strange([lib / room / "new.h"])[0]) == wrong


# Texts that a file for each target includes after it defines these names: those of one target.
TARGET = ["-DFXL_TARGET=fxl_rgb565_depth_16", "-DFXL_TARGET_FORMAT=FXL_RGB565_PIXELS", "-DFXL_TARGET_DEPTH_BITS=16",
          "-DFXL_TARGET_SURFACES=fxl_rgb565_depth_16_surfaces", "-DFXL_TARGET_SPRITES=fxl_rgb565_depth_16_sprites"]
OUTLINE = ["-DFXL_DRAW_OUTLINE=fxl_draw_outline", "-DFXL_DRAW_BY_ACTIVE_EDGES=fxl_draw_by_active_edges",
           "-DFXL_FILL_TRAPEZOID=fxl_fill_trapezoid", "-DFXL_COLOUR=uint8_t", "-Dfill_span(edges, span, band, colour)=(void)(colour)"]
TEMPLATES = {f"draw/{name}_text.h": TARGET
             for name in ("target", "target_flat", "target_faces", "surfaces", "surface_paint", "surface_depth", "surface_smooth", "sprites")} | {
    "draw/pixel_row.h": TARGET, "raster/draw_outline_text.h": OUTLINE, "paint/segment_runs.h": ["-DTEXEL_CODE=(&fxl_texel_code_8)"]}
OTHER_CORES = re.compile(r"_armv[67]m\.h$")


def words_alone(header, options=()):
    """What the compiler says of a header that nothing was included before, if it refuses it."""
    command = ["gcc", "-std=c11", "-ffreestanding", f"-I{LIB / 'include'}", "-fsyntax-only", *options, "-x", "c", header]
    done = subprocess.run(command, check=False, text=True, capture_output=True)
    return done.stderr if done.returncode else ""


def test_a_header_includes_what_it_needs():
    """Otherwise a room could use a later one, if each of its users includes that before."""
    headers_of_rooms = [file for file in sources() if file.suffix == ".h" and not OTHER_CORES.search(file.name)]
    assert len(headers_of_rooms) > 80
    said = {name: words for name, words in ((str(file.relative_to(LIB)), words_alone(file, TEMPLATES.get(str(file.relative_to(LIB)), ())))
                                            for file in headers_of_rooms) if words}
    assert said == {}


def test_a_header_that_needs_another_before_it_is_seen(tmp_path):
    (tmp_path / "new.h").write_text("fxl_lens of(const fxl_renderer *renderer);\n", encoding="utf-8")
    assert "unknown type name" in words_alone(tmp_path / "new.h")
