# SPDX-License-Identifier: MIT
"""make run: what a walk leaves, and how one that cannot be made ends."""

import contextlib
import dataclasses
import hashlib
import json
import os
import pathlib
import re
import struct
import types
import zlib

import numpy
import pytest
from conftest import CHECKOUT, assert_one_sentence, dump_bytes, random_frames, run_cli, run_make
from PIL import Image

from fixel.bench import frame_costs
from fixel.board import counted, firmware, model_look, spilled
from fixel.board import run as run_tool
from fixel.base import scratch
from fixel.scene import making
from fixel.board import dump, emulator

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "boards/netduino2/walk.elf", "host/judge", "host/predict",
                  "host/raycast")
SCENE = "scenes/tiny.toml"
FRAMES = 4
KEYS = {"texel_pixels", "board", "cpu", "scene", "width", "height", "frames", "pixels", "pixels_differing",
        "pixels_unexplained", "worst_frame_differing", "max_edge_distance_px", "polygons",
        "instructions_per_frame", "frame_sha256", "host_frames_equal", "frames_empty", "visibility", "clipper", "program",
        "order_wrong_pixels", "order_judged_pixels", "driver", "wires_frames_equal", "wires_frame_sha256", "kept",
        "frame_crc", "frame_crc_all", "sent_crc", "sent_crc_all", "cycles_per_frame", "emulator", "spilled_note",
        "display_bytes", "display_bytes_by_boxes", "display_share_saved", "boxes_unknown"}


def walk(out, board="mps2-an385", scene=SCENE, frames=FRAMES, **changes):
    more = [] if frames is None else ["--frames", frames]
    return run_cli("run", "--board", board, "--scene", scene, "--out", out, *more, **changes)


def assert_nothing_left(folder, out):
    """No result, and no temporary folder beside its place or where make builds."""
    assert not out.exists()
    assert not list(folder.glob(".fixel-*"))
    assert not list(filter(belongs_to_nobody, (CHECKOUT / "build").glob(".fixel-run-*")))


def belongs_to_nobody(path):
    """Whether a temporary folder outlived its process: it is there, and in the journal of no process that lives. Other
    tests make some at the same time."""
    for journal in scratch.JOURNALS.glob("*-*"):
        with contextlib.suppress(OSError):
            number = journal.name.partition("-")[0]
            if os.fsencode(path) + scratch.END in journal.read_bytes() and os.path.exists(f"/proc/{number}"):
                return False
    return path.exists()


def test_a_folder_is_told_from_one_that_was_left(tmp_path):
    with scratch.folder("run", tmp_path) as mine:
        left = tmp_path / ".fixel-run-0123456789abcdef"
        left.mkdir()
        assert not belongs_to_nobody(mine) and belongs_to_nobody(left)
    assert not belongs_to_nobody(mine)


# --- a walk that works --------------------------------------------------------

@pytest.fixture(scope="module")
def result(build, tmp_path_factory):
    """A short walk on the emulated board: (summary, folder, process)."""
    out = tmp_path_factory.mktemp("run") / "out"
    done = walk(out)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads((out / "summary.json").read_text()), out, done


def test_summary_has_exactly_its_keys(result):
    summary, _, _ = result
    assert set(summary) == KEYS
    assert set(summary["polygons"]) == {"in", "culled", "clipped", "refused", "drawn", "spilled"}
    assert set(summary["instructions_per_frame"]) == {"min", "median", "mean", "max"}


def test_summary_figures(result):
    summary, _, _ = result
    assert (summary["board"], summary["cpu"], summary["scene"]) == ("mps2-an385", "cortex-m3", SCENE)
    assert (summary["width"], summary["height"], summary["frames"]) == (128, 64, FRAMES)
    assert summary["kept"] == [], "tests compute everything"
    assert summary["pixels"] == 128 * 64 * FRAMES
    assert summary["host_frames_equal"] is True and summary["pixels_unexplained"] == 0
    polygons = summary["polygons"]
    assert polygons["in"] == polygons["culled"] + polygons["refused"] + polygons["drawn"] > 0
    assert 0 < summary["instructions_per_frame"]["min"] <= summary["instructions_per_frame"]["max"]


def test_a_summary_adds_up_all_frames(tmp_path):
    (tmp_path / "drawn.fxld").write_bytes(dump_bytes(random_frames(5, 3, 4)))
    options = types.SimpleNamespace(board="b", program="walk", scene="s", visibility="v", clipper="c", driver=None)
    summary = run_tool.summarise(options, firmware.Program(pathlib.Path("e"), "b", "cpu", (), (), ()), dump.read_dump(tmp_path / "drawn.fxld"), True)
    assert (summary["width"], summary["height"], summary["frames"], summary["pixels"]) == (4, 3, 5, 60)
    assert (summary["polygons"]["in"], summary["polygons"]["drawn"], summary["frames_empty"]) == (50, 20, 0)
    assert summary["instructions_per_frame"] == {"min": 1000, "median": 1002, "mean": 1002, "max": 1004}


def test_pictures_are_the_frames(result):
    summary, out, _ = result
    drawn = dump.read_dump(out / "board.fxld")
    names = sorted(file.name for file in out.glob("frame_*.png"))
    assert names == [f"frame_{number:04d}.png" for number in range(FRAMES)]
    for frame, name, digest in zip(drawn.frames, names, summary["frame_sha256"]):
        with Image.open(out / name) as image:
            assert image.mode == "P"
            assert numpy.array_equal(numpy.asarray(image), frame.pixels)
            assert numpy.array_equal(numpy.asarray(image.convert("RGB")), drawn.palette[frame.pixels])
        assert hashlib.sha256(frame.pixels.tobytes()).hexdigest() == digest
    assert len({*summary["frame_sha256"]}) > 1, "a walk in which nothing moves"


def test_animation_shows_every_frame(result):
    _, out, _ = result
    drawn = dump.read_dump(out / "board.fxld")
    with Image.open(out / "walk.gif") as animation:
        assert animation.n_frames == FRAMES
        for frame in drawn.frames:
            animation.seek(frame.number)
            assert numpy.array_equal(numpy.asarray(animation.convert("RGB")), drawn.palette[frame.pixels])


def test_a_picture_for_each_frame_that_differs(result):
    summary, out, _ = result
    drawn, twin = dump.read_dump(out / "board.fxld"), dump.read_dump(out / "double.fxld")
    differing = [int((a.pixels != b.pixels).sum()) for a, b in zip(drawn.frames, twin.frames)]
    assert [file.name for file in sorted(out.glob("diff_*.png"))] == \
        [f"diff_{number:04d}.png" for number, count in enumerate(differing) if count]
    assert (summary["pixels_differing"], summary["worst_frame_differing"]) == \
        (sum(differing), max(differing))
    assert (summary["max_edge_distance_px"] is None) == (sum(differing) == 0)


def test_table_on_stdout_and_no_colour(result):
    _, out, done = result
    assert "pass" in done.stdout and "\033" not in done.stdout + done.stderr
    assert str(out) in done.stdout


def test_host_is_a_board(build, tmp_path, result):
    done = walk(tmp_path / "out", board="host")
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert done.returncode == 0, done.stdout + done.stderr
    assert summary["cpu"] == "host" and summary["instructions_per_frame"]["min"] is None
    assert "instructions a frame" in done.stdout and "not counted on this board" in done.stdout
    assert summary["frame_sha256"] == result[0]["frame_sha256"]


@pytest.mark.parametrize("counts, figures", [
    ([], (None, None, None, None)),
    ([0, 0], (None, None, None, None)),
    ([5, 0, 7], (None, None, None, None)),  # a frame whose clock stood still or ran backward
    ([5, 6, 10], (5, 6, 7, 10)),
    ([5, 6, 10, 0, 7], (5, 6, 7, 10)),      # a frame that the walk drew as two rectangles
    ([0, 0, 0, 9, 0], (None, None, None, None)),
])
def test_frames_that_were_not_counted(counts, figures):
    found = counted.figures([types.SimpleNamespace(number=number, instructions=count) for number, count in enumerate(counts)])
    assert tuple(found.values()) == figures


def test_again_into_the_same_folder(build, tmp_path):
    out = tmp_path / "out"
    out.mkdir()
    (out / "notes.txt").write_text("mine")
    (out / "frame_0099.png").write_text("of a longer walk")
    assert walk(out, board="host").returncode == 0
    assert (out / "notes.txt").read_text() == "mine"
    assert not (out / "frame_0099.png").exists()
    assert (out / "summary.json").exists()


def test_scene_image_instead_of_toml(build, tmp_path, result):
    image = tmp_path / "tiny.fxls"
    making.build(str(CHECKOUT / SCENE), str(image))
    assert walk(tmp_path / "out", board="host", scene=image).returncode == 0
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["frame_sha256"] == result[0]["frame_sha256"]


def test_frames_in_which_nothing_is_drawn_are_told(build, tmp_path):
    """A tile that faces up, from above and from below."""
    (tmp_path / "tile.toml").write_text(
        '[[objects]]\nsolid = "tile"\n[path]\ninterpolation = "linear"\n'
        'keys = [{ position = [0, 2, 0], pitch = -90, frames = 2 }, { position = [0, -2, 0], pitch = 90 }]\n')
    done = walk(tmp_path / "out", board="host", scene=tmp_path / "tile.toml", frames=None)
    assert done.returncode == 0 and "pass (2 of 3 frames are empty" in done.stdout, done.stdout + done.stderr
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["frames_empty"] == 2


# --- a walk that is wrong -----------------------------------------------------

def spoil(data):
    """A dump with one pixel of its last frame changed, whole otherwise."""
    data = bytearray(data)
    data[-12 - 48 - 1] ^= 1
    data[-4:] = struct.pack("<I", zlib.crc32(data[:-4]))
    return bytes(data)


def run_spoilt(tmp_path, monkeypatch, board):
    """The folder of a run of a board, which fails; the host's dump is spoilt."""
    real = run_tool.walk

    def spoiling(walked, *arguments, **more):
        file, cpu = real(walked, *arguments, **more)
        if walked == "host":
            file.write_bytes(spoil(file.read_bytes()))
        return file, cpu

    monkeypatch.setattr(run_tool, "walk", spoiling)
    monkeypatch.chdir(CHECKOUT)
    out = tmp_path / "out"
    assert run_tool.main(["--board", board, "--scene", SCENE, "--frames", "2", "--out", str(out)]) == 1
    return out


def test_frames_that_are_not_the_hosts_fail(build, tmp_path, monkeypatch):
    out = run_spoilt(tmp_path, monkeypatch, "mps2-an385")
    assert json.loads((out / "summary.json").read_text())["host_frames_equal"] is False


def test_unexplained_pixels_fail(build, tmp_path, monkeypatch):
    out = run_spoilt(tmp_path, monkeypatch, "host")
    summary = json.loads((out / "summary.json").read_text())
    assert summary["host_frames_equal"] is True and summary["pixels_unexplained"] == 1
    assert (out / "diff_0001.png").exists()


def test_frames_equal_looks_at_pixels_poses_palette_and_count():
    frames = random_frames(2)
    one = dump.parse_dump(dump_bytes(frames), "one")
    assert run_tool.frames_equal(one, dump.parse_dump(dump_bytes(frames, instructions=5), "other"))
    other = random_frames(2, seed=2)
    assert not run_tool.frames_equal(one, dump.parse_dump(dump_bytes(other), "other"))
    assert not run_tool.frames_equal(one, dump.parse_dump(dump_bytes(frames[:1]), "other"))
    assert not run_tool.frames_equal(one, dump.parse_dump(dump_bytes(frames, bytes(768)), "other"))
    turned = dataclasses.replace(one, frames=[dataclasses.replace(one.frames[0], angles=(0, 0, 0)),
                                              one.frames[1]])
    assert not run_tool.frames_equal(one, turned)


# --- a walk that cannot be made -----------------------------------------------

@pytest.fixture(scope="module")
def image_bytes(tmp_path_factory):
    """A good scene image."""
    path = tmp_path_factory.mktemp("image") / "tiny.fxls"
    making.build(str(CHECKOUT / SCENE), str(path))
    return path.read_bytes()


def flip(data, bit):
    data = bytearray(data)
    data[bit // 8] ^= 1 << bit % 8
    return bytes(data)


def with_version(data, version):
    return data[:4] + struct.pack("<H", version) + data[6:]


def with_checksum(data):
    """The image with its checksum made right again: only what it says is wrong."""
    return data[:12] + struct.pack("<I", zlib.crc32(data[16:])) + data[16:]


BAD_IMAGES = {
    "truncated": lambda data: data[:len(data) // 2],
    "truncated head": lambda data: data[:100],
    "empty": lambda data: b"",
    "bit flipped in magic": lambda data: flip(data, 3),
    "bit flipped in head": lambda data: flip(data, 16 * 8 + 1),
    "bit flipped in checksum": lambda data: flip(data, 12 * 8),
    "bit flipped in a table": lambda data: flip(data, (len(data) - 9) * 8),
    "oversized": lambda data: data + bytes(64),
    "says 4 GB": lambda data: data[:8] + b"\xfc\xff\xff\xff" + data[12:],
    "wrong version": lambda data: with_version(data, 3),
    "version 0": lambda data: with_version(data, 0),
    "offset outside": lambda data: with_checksum(data[:96] + b"\xf0\xff\xff\x7f" + data[100:]),
    "no frames": lambda data: with_checksum(data[:80] + bytes(4) + data[84:]),
    "near behind the eye": lambda data: with_checksum(data[:24] + b"\0\0\xff\xff" + data[28:]),
    "screen of no pixels": lambda data: with_checksum(data[:16] + bytes(2) + data[18:]),
}


@pytest.mark.parametrize("board", ["mps2-an385", "host"])
@pytest.mark.parametrize("kind", BAD_IMAGES)
def test_bad_scene_image(build, tmp_path, image_bytes, board, kind):
    bad = tmp_path / "bad.fxls"
    bad.write_bytes(BAD_IMAGES[kind](image_bytes))
    done = walk(tmp_path / "out", board=board, scene=bad, frames=None)
    assert done.returncode in (2, emulator.exit_code("SCENE")), done.stdout + done.stderr
    assert_one_sentence(done, code=done.returncode)
    assert_nothing_left(tmp_path, tmp_path / "out")


@pytest.mark.parametrize("suffix", ["toml", "fxls"])
def test_more_frames_than_the_path_has(build, tmp_path, suffix):
    making.build(str(CHECKOUT / SCENE), str(tmp_path / "tiny.fxls"))
    scene = CHECKOUT / SCENE if suffix == "toml" else tmp_path / "tiny.fxls"
    done = walk(tmp_path / "out", board="host", scene=scene, frames=99)
    assert_one_sentence(done, f"tiny.{suffix}: path: 99 frames are asked for, and the path has 16")
    assert not (tmp_path / "out").exists()


def test_coordinate_out_of_range(build, tmp_path):
    text = (CHECKOUT / SCENE).read_text().replace("position = [-1.8, 0, 5]", "position = [-1.8, 9000, 5]")
    assert "9000" in text
    (tmp_path / "far.toml").write_text(text)
    assert_one_sentence(walk(tmp_path / "out", scene=tmp_path / "far.toml"), "far.toml", "house")
    assert_nothing_left(tmp_path, tmp_path / "out")


def test_obj_with_a_missing_vertex(build, tmp_path):
    (tmp_path / "holed.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")
    assert_one_sentence(walk(tmp_path / "out", scene=tmp_path / "holed.obj"), "holed.obj", "4")
    assert_nothing_left(tmp_path, tmp_path / "out")


@pytest.mark.parametrize("scene", ["none.toml", "none.obj", "none.fxls", "none.txt"])
def test_scene_that_is_not_there(build, tmp_path, scene):
    assert_one_sentence(walk(tmp_path / "out", scene=tmp_path / scene), scene)
    assert_nothing_left(tmp_path, tmp_path / "out")


def test_unwritable_out(build, tmp_path):
    (tmp_path / "file").write_text("in the way")
    for out in (tmp_path / "file", tmp_path / "file" / "below"):
        assert_one_sentence(walk(out, board="host"), "cannot be written")
    assert (tmp_path / "file").read_text() == "in the way"
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


@pytest.mark.parametrize("frames", ["0", "-1", "x", "1.5", "1000001", "9" * 5000])
def test_number_of_frames_that_is_none(build, tmp_path, frames):
    done = run_cli("run", "--board", "host", "--scene", SCENE, "--out", tmp_path / "out",
                   f"--frames={frames}")
    assert_one_sentence(done, "FRAMES")
    assert_nothing_left(tmp_path, tmp_path / "out")


def test_missing_qemu(build, tmp_path):
    (tmp_path / "bin").mkdir()
    assert_one_sentence(walk(tmp_path / "out", PATH=str(tmp_path / "bin")), "qemu-system-arm", "install")
    assert_nothing_left(tmp_path, tmp_path / "out")


def test_failure_leaves_an_earlier_result_alone(build, tmp_path, image_bytes):
    out = tmp_path / "out"
    assert walk(out, board="host", frames=2).returncode == 0
    before = {file.name: file.read_bytes() for file in out.iterdir()}
    (tmp_path / "bad.fxls").write_bytes(image_bytes[:-5])
    assert walk(out, board="host", scene=tmp_path / "bad.fxls").returncode == 2
    assert {file.name: file.read_bytes() for file in out.iterdir()} == before


@pytest.mark.parametrize("words, environment", [*((("BOARD=toaster", goal), {}) for goal in ("run", "flash", "boot", "report", "size", "test")),
                                                *(((goal,), {"BOARD": "toaster"}) for goal in ("lib", "help", "clean", "compare"))])
def test_unknown_board(words, environment):
    """Where a command has no board, the environment's."""
    done = run_make(*words, **environment)
    assert done.returncode == 2
    assert done.stdout == "" and len(done.stderr.splitlines()) == 1
    for word in ("toaster", "host", "mps2-an385"):
        assert word in done.stderr
    assert (CHECKOUT / "build").exists()


def test_make_run(build, tmp_path):
    done = run_make("run", "BOARD=host", f"SCENE={SCENE}", "FRAMES=2", f"OUT={tmp_path / 'out'}")
    assert done.returncode == 0, done.stdout + done.stderr
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["frames"] == 2


def test_on_the_host_whole_frames_are_drawn_and_compared_with_those_of_narrow_bands(build, tmp_path):
    words = "run", "BOARD=host", "SCENE=scenes/plaza.toml", "FRAMES=2"
    for more, is_whole in (([], True), (["ROWS=24"], False)):
        done = run_make(*words, *more, f"OUT={tmp_path / 'out'}", "FRESH=1")
        assert done.returncode == 0, done.stdout + done.stderr
        summary = json.loads((tmp_path / "out" / "summary.json").read_text())
        assert summary["host_frames_equal"] and (summary["polygons"]["spilled"] == 0) == is_whole == (summary["spilled_note"] == "")
    assert_one_sentence(run_cli("run", "--board", "mps2-an385", "--whole-frames", "--scene", SCENE, "--out", tmp_path / "no"), "--whole-frames", "host")


def test_what_to_open_is_the_last_line(result):
    _, out, done = result
    assert done.stdout.splitlines()[-1].startswith(f"open {out / 'walk.gif'}")


def test_spilled_polygons_are_told_with_their_cost_and_the_size_that_ends_it(build, tmp_path):
    """BOARD_LIST_BYTES that the sentence names holds every polygon, and 8 bytes less do not."""
    done = walk(tmp_path / "out", board="netduino2", scene="scenes/plaza.toml", frames=3)
    assert done.returncode == 0, done.stderr
    note = json.loads((tmp_path / "out" / "summary.json").read_text())["spilled_note"]
    assert note in done.stdout and "NaN" not in note
    polygons, bands, times, setting = re.search(r"no room for (\d+) polygon.* (\d+) bands .*takes ([0-9.]+) times.*BOARD_LIST_BYTES := (\d+) in boards/netduino2/", note).groups()
    making.build("scenes/plaza.toml", tmp_path / "plaza.fxls", 3)
    room = model_look.room_of(build / "boards" / "netduino2" / "walk.elf")
    band, number = 320 * (room.band // 320), -(-240 // (room.band // 320))
    costs = frame_costs.load()["cores"]["m3"]

    def drawn(words):
        names, counts = frame_costs.count(build, tmp_path / "plaza.fxls", band, room.order, words, room.cache, frames=3)
        return counts[:, names.index("spilled_faces")].sum(), frame_costs.instructions(costs, names, counts).mean()
    assert drawn(int(setting))[0] == 0 < drawn(int(setting) - 8)[0] and number == int(bands) and int(polygons) > 0
    assert float(times) == pytest.approx(drawn(room.list)[1] / drawn(int(setting))[1], abs=0.006)


@pytest.mark.parametrize("changes, told", [
    ({"polygons": 0}, ""), ({"band_rows": 240}, ""), ({"program": "game"}, "holds every polygon"), ({"clipper": "once"}, "holds every polygon")])
def test_of_spilled_polygons_no_cost_is_told_that_nobody_knows(build, tmp_path, changes, told):
    making.build("scenes/plaza.toml", tmp_path / "plaza.fxls", 3)
    given = {"rows": None, "band_rows": None, "driver": None, "program": "walk", "clipper": None, "visibility": None, "polygons": 7} | changes
    options = types.SimpleNamespace(board="b", build=build, frames=None, **given)
    board = "mps2-an385" if changes.get("band_rows") else "netduino2"
    said = spilled.note(options, build / "boards" / board / "walk.elf", tmp_path / "plaza.fxls", options.polygons)
    assert told in said and bool(said) == bool(told) and "times" not in said


def test_make_flash_and_boot(build, tmp_path):
    done = run_make("flash", f"SCENE={SCENE}")
    assert done.returncode == 0, done.stdout + done.stderr
    done = run_make("boot", "FRAMES=2")
    assert done.returncode == 0, done.stdout + done.stderr
    assert len(dump.read_dump(CHECKOUT / "build" / "boot" / "mps2-an385.fxld").frames) == 2
