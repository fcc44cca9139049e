# SPDX-License-Identifier: MIT
"""make boards: every board draws what the host draws, and one that does not is seen; and boards whose tools make test does not install."""

import json
import os
import re
import shutil
import subprocess
import types

import pytest

from board_programs import BOARD, built, EVERY_BOARD, fake_qemu, made, read_uf2, ROOT
from conftest import dry_run, dump_bytes, random_frames, run_cli
from fixel.base.errors import ToolError
from fixel.board import dump, fleet, uf2

BUILT_PROGRAMS = ("boards/*",)
KEYS = {"name": str, "core": str, "flash_bytes": int, "ram_bytes": int, "stack_bytes": int,
        "instructions_per_frame": int, "frames": int, "hash_equal": bool, "unit_tests_passed": int,
        "unit_tests_failed": int}
TINY = "scenes/tiny.toml"
# Changes one pixel of frame 3 of a dump, and the checksum with it.
DOCTOR = """
import struct, zlib
data = bytearray(open("frames.fxld", "rb").read())
width, height = struct.unpack_from("<HH", data, 6)
data[16 + 768 + 3 * (32 + width * height + 48) + 32 + 100] ^= 1
data[-4:] = struct.pack("<I", zlib.crc32(data[:-4]))
open("frames.fxld", "wb").write(data)
"""


def target_boards():
    """All boards but the host that make test has the tools of, by their folders: a new one needs no line here."""
    return EVERY_BOARD


def run_boards(out, *arguments, **changes):
    done = run_cli("boards", "--out", out, *arguments, **changes)
    return done, json.loads(out.read_text()) if out.exists() else None


@pytest.fixture(scope="module")
def everything(tmp_path_factory):
    """tiny and the plaza on all boards, without their unit tests, which make test runs."""
    for board in ["host", *target_boards()]:
        built(f"{board}/walk" if board == "host" else f"{board}/walk.elf")
    return run_boards(tmp_path_factory.mktemp("boards") / "boards.json", "--boards", *target_boards(),
                      "--scene", TINY, "scenes/plaza.toml")


def test_all_boards_draw_what_the_host_draws(everything):
    done, result = everything
    assert done.returncode == 0, done.stdout + done.stderr
    assert [board["name"] for board in result["boards"]] == target_boards()
    for board in result["boards"]:
        tiny, plaza = board["scenes"]
        assert board["hash_equal"] and tiny["frames"] == 16 and tiny["hash_equal"], board
        assert plaza["why_not"] or (plaza["frames"] == 120 and plaza["hash_equal"]), board


def test_the_keys_that_others_read(everything):
    for board in everything[1]["boards"]:
        for key, kind in KEYS.items():
            assert type(board[key]) is kind, (board["name"], key, board[key])
        assert 0 < board["flash_bytes"] <= board["flash_size"] - board["flash_free"]
        assert board["ram_bytes"] + board["ram_free"] == board["ram_size"]
        assert 0 < board["stack_bytes"] < board["stack_reserved"] < board["ram_bytes"]
        assert board["instructions_per_frame"] > 1000


# place board: nothing: these are the tests of all boards
def test_boards_draw_what_is_asked_for(tmp_path):
    """A board without room for it says so, and fails nothing."""
    for board in ("host/walk", "microbit/walk.elf", "stm32vldiscovery/walk.elf"):
        built(board)
    done, result = run_boards(tmp_path / "boards.json", "--boards", "microbit", "stm32vldiscovery", "--scene", TINY,
                              "--pixels", "rgb565", "--depth", "16")
    assert done.returncode == 0, done.stdout + done.stderr
    (small,), (smallest,) = (board["scenes"] for board in result["boards"])
    assert small["hash_equal"] and small["frames"] == 16 and small["why_not"] is None
    assert "draws no RGB565" in smallest["why_not"] and smallest["frames"] == 0
    assert "stm32vldiscovery: tiny does not fit" in done.stdout


def test_the_table_has_a_line_for_each_board(everything):
    lines = everything[0].stdout.splitlines()
    for board in target_boards():
        row, = [line for line in lines if re.match(rf"{re.escape(board)} +cortex-m", line)]
        assert " yes " in row
        figures, = [each for each in everything[1]["boards"] if each["name"] == board]
        for walk in figures["scenes"]:
            speed = 1e6 / walk["instructions_per_frame"]
            assert any(abs(float(word) - speed) <= 0.005 * speed for word in row.split()
                       if re.fullmatch(r"[0-9.]+", word)), (row, speed)


def test_the_host_is_no_board_of_the_table(everything):
    assert "host" not in [board["name"] for board in everything[1]["boards"]]


def test_unit_tests_are_counted(tmp_path):
    units = tmp_path / "units.json"
    whole = json.loads(built(f"{BOARD}/unit/units.json").read_text(encoding="utf-8"))
    program, names = next((program, names) for program, names in whole["programs"].items() if "test_angle" in names)
    for file in built(f"{BOARD}/unit/units.json").parent.glob("*.elf"):
        (tmp_path / file.name).symlink_to(file)
    units.write_text(json.dumps({"programs": {program: names}, "left_out": {"test_huge": "RAM overflowed by 9 bytes"}}))
    done, result = run_boards(tmp_path / "boards.json", "--boards", BOARD, "--scene", TINY, "--units", BOARD, units)
    row, = result["boards"]
    assert done.returncode == 0, done.stdout + done.stderr
    assert row["unit_tests_passed"] >= len(names) and row["unit_tests_failed"] == 0
    assert row["unit_tests_left_out"] == ["test_huge"]
    assert f"{BOARD}: left out, no room: test_huge (RAM overflowed by 9 bytes)" in done.stdout.splitlines()


def test_a_unit_test_that_fails_fails_the_board(tmp_path):
    """A program that ends without the marker of unit tests."""
    units = tmp_path / "units.json"
    (tmp_path / "walk.elf").symlink_to(built(f"{BOARD}/walk.elf"))
    units.write_text(json.dumps({"programs": {"walk.elf": ["test_a"]}, "left_out": {}}))
    done, result = run_boards(tmp_path / "boards.json", "--boards", BOARD, "--scene", TINY, "--units", BOARD, units)
    assert done.returncode == 1
    assert result["boards"][0]["unit_tests_failed"] == 1 and result["boards"][0]["hash_equal"]


def test_a_board_whose_frames_differ_is_reported(tmp_path):
    doctor = tmp_path / "doctor.py"
    doctor.write_text(DOCTOR)
    path = fake_qemu(tmp_path / "bin", f'"$REAL" "$@"; code=$?\n[ ! -f frames.fxld ] || python3 {doctor}\nexit $code')
    done, result = run_boards(tmp_path / "boards.json", "--boards", BOARD, "--scene", TINY, PATH=path)
    assert done.returncode == 1
    assert f"{BOARD}: FAIL: tiny: frame 3 is not the host's" in done.stdout.splitlines()
    row, = result["boards"]
    assert row["hash_equal"] is False and row["scenes"][0]["first_different"] == 3


def test_a_board_that_fails_is_reported_and_the_others_go_on(tmp_path):
    other = [board for board in target_boards() if board != BOARD][:1]
    path = fake_qemu(tmp_path / "bin", f'case "$*" in *"{BOARD}"*) exit 0 ;; esac\nexec "$REAL" "$@"')
    done, result = run_boards(tmp_path / "boards.json", "--boards", BOARD, *other, "--scene", TINY, PATH=path)
    assert done.returncode == 1
    assert [board["hash_equal"] for board in result["boards"]] == [False] + [True] * len(other)
    assert f"{BOARD}: FAIL: tiny: " in done.stdout and "Traceback" not in done.stderr


def test_no_room_for_the_first_scene_is_no_success(tmp_path):
    """A board whose scene partition is too small: said, and not equal."""
    build = tmp_path / "build"
    (build / "boards" / BOARD).mkdir(parents=True)
    (build / "boards/host").symlink_to(built("host/walk").parent)
    subprocess.run(["arm-none-eabi-objcopy", "--strip-symbol=fxl_scene_size",
                    "--add-symbol=fxl_scene_size=1000,global", built(f"{BOARD}/walk.elf"),
                    build / "boards" / BOARD / "walk.elf"], check=True)
    done, result = run_boards(tmp_path / "boards.json", "--boards", BOARD, "--scene", TINY, "--build", build)
    assert done.returncode == 1, done.stderr
    row, = result["boards"]
    assert row["hash_equal"] is False and row["frames"] == 0
    said, = [line for line in done.stdout.splitlines() if line.startswith(f"{BOARD}: tiny does not fit: ")]
    assert re.search(r"the scene has \d,\d{3} bytes, the board's scene partition 1,000$", said)


def test_the_command_line():
    done = dry_run("boards")
    assert done.returncode == 0, done.stderr
    for board in target_boards():
        assert f"--units {board} " in done.stdout


def test_no_file_but_a_boards_own_names_it():
    """What a new board needs is in its folder: nothing that is built or run knows it by name."""
    names = re.compile("|".join(rf"\b{re.escape(board)}\b" for board in target_boards()))
    for folder in ("lib", "firmware", "linker", "tools", "boards/parts", "boards/contract"):
        for file in (ROOT / folder).rglob("*"):
            if file.is_file() and file.suffix in (".c", ".h", ".mk", ".ld", ".py", ".sh"):
                found = [match for match in names.findall(file.read_text(encoding="utf-8")) if match != BOARD]
                assert not found, f"{file} names {found[0]}"


@pytest.mark.parametrize("change, different", [(None, None), (2, 2), (0, 0)])
def test_the_first_frame_that_differs_from_the_hosts_is_known(monkeypatch, tmp_path, change, different):
    frames = random_frames(4)
    host = dump.parse_dump(dump_bytes(frames), "host")
    if change is not None:
        frames[change] = frames[change] ^ 1

    def run(board, image, elf, file, timeout):
        file.write_bytes(dump_bytes(frames))
        return types.SimpleNamespace(output="stack: 500 of 2048 bytes")
    monkeypatch.setattr(fleet.flash_memory, "flash", lambda board, elf, scene, image: image.touch())
    monkeypatch.setattr(fleet.emulator, "run", run)
    monkeypatch.setattr(fleet.firmware, "load", lambda elf, board: types.SimpleNamespace(counts="instructions", hosted=True))
    result = fleet.Walk("tiny")
    fleet._run(result, "a-board", "walk.elf", fleet.Scene("tiny", tmp_path / "tiny.fxls", host), tmp_path)
    assert result == fleet.Walk("tiny", frames=4, instructions_per_frame=1002, hash_equal=different is None,
                                first_different=different, stack_bytes=500, stack_reserved=2048)
    assert not list(tmp_path.iterdir())


def test_dumps_of_another_size_palette_or_length_differ():
    frames = random_frames(3)
    whole = dump.parse_dump(dump_bytes(frames), "host")
    others = {0: dump_bytes(random_frames(3, 24, 31)), 1: dump_bytes(frames[:1]), 3: dump_bytes([*frames, frames[0]])}
    for number, other in others.items():
        assert fleet.first_difference(dump.parse_dump(other, "x"), whole) == number
    assert fleet.first_difference(dump.parse_dump(dump_bytes(frames, palette=bytes(768)), "x"), whole) == 0


# --- boards whose tools make test does not install ----------------------------------

def test_what_is_missing_is_said(tmp_path):
    """A machine with sh and Python alone."""
    for name in ("sh", "dirname", "python3"):
        (tmp_path / name).symlink_to(shutil.which(name))
    done = subprocess.run([ROOT / "tools/setup.sh", "--missing", "riscv"], env={"PATH": str(tmp_path)}, capture_output=True, text=True,
                          check=True)
    needed = "gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf qemu-system-misc"
    assert done.stdout.split() == needed.split()
    made("build/boards/microbit/walk.elf", "BOARD=microbit")
    made("build/boards/host/walk", "BOARD=host")
    done = run_cli("boards", "--boards", "microbit", "--scene", "scenes/tiny.toml", "--out", tmp_path / "boards.json", "--not-run", "rv32",
                   *needed.split())
    assert done.returncode == 0 and f"rv32: not run: needs {needed}\n" in done.stdout
    assert json.loads((tmp_path / "boards.json").read_text())["not_run"] == {"rv32": needed.split()}


@pytest.mark.parametrize("board", ["rv32", "boards/pico"])
def test_make_test_leaves_the_board_out(board):
    """So a machine needs none of its tools for make test."""
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("MAKE", "MFLAGS", "FIXEL_EXTRA"))}
    said = subprocess.run(["make", "--dry-run", "test"], cwd=ROOT, env=environment, capture_output=True, text=True, check=True).stdout
    assert "boards/microbit" in said and board not in said


def test_what_is_missing_for_a_pico_is_said(tmp_path):
    """A machine with sh, Python and no node."""
    for name in ("sh", "dirname", "python3"):
        (tmp_path / name).symlink_to(shutil.which(name))
    done = subprocess.run([ROOT / "tools/setup.sh", "--missing", "pico"], env={"PATH": str(tmp_path)}, capture_output=True, text=True,
                          check=True)
    assert {"nodejs", "npm", "gcc-arm-none-eabi"} <= set(done.stdout.split())


@pytest.mark.parametrize("at, value, sentence", [
    (0, 0, "no marks"), (508, 0, "no marks"), (28, 0, "another chip"), (20, 9, "out of order"), (12, 1, "cannot be for")])
def test_damaged_uf2_blocks_are_refused(at, value, sentence):
    good = uf2.encode([(0x10000000, bytes(range(256)) * 2)], 0xE48BFF56)
    assert uf2.decode(good, 0xE48BFF56) == {0x10000000: bytes(range(256)), 0x10000100: bytes(range(256))} == read_uf2(good)
    with pytest.raises(ToolError, match=sentence):
        uf2.decode(good[:at] + bytes([value]) + good[at + 1:], 0xE48BFF56)
    with pytest.raises(ToolError, match="does not end"):
        uf2.decode(good[:-1], 0xE48BFF56)
